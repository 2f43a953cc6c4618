"""Robots from an allocation matrix, whose columns are the wrenches of thrusters."""

import math
from collections.abc import Sequence
from typing import Literal, NamedTuple, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import RobotInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.outline.outline import check_outline
from swarmgrasp.ranges import array_of, items, name_faults, number, numbers, shown
from swarmgrasp.swarm.robot import Robot
from swarmgrasp.terms import Frame

Axes = Literal["ENU", "NED"]
"""x forward, y to port, counter-clockwise; or x forward, y to starboard, clockwise."""
PURE = 1e-12
"""Force of a column, relative to the largest force of all, that is none: it is a couple."""
Array = NDArray[np.float64]


class Allocation(NamedTuple):
    """What a matrix says.

    Attributes
    ----------
    columns : (n, 3) [1, 1, m]
        Wrenches per newton of each, about the origin, in our frame.
    ranges : (n, 2) [N]
        From the lowest to the highest, which is above 0.
    names : tuple of str
    """

    columns: Array
    ranges: Array
    names: tuple[str, ...]

    @property
    def reach(self) -> float:
        """The largest moment arm of a line of action [m]; 0 without forces."""
        return reach_of(self.columns)


def reach_of(columns: Array) -> float:
    """Return the largest arm of the lines of action of wrenches (n, 3); 0 without forces."""
    sizes = np.hypot(*columns[:, :2].T)
    pushing = sizes > PURE * sizes.max(initial=0.0)
    return float(np.abs(columns[pushing, 2] / sizes[pushing]).max(initial=0.0))


def checked_allocation(
    matrix: ArrayLike, limits: object, names: Sequence[str] | None, frame: Axes
) -> Allocation:
    """Return what a matrix says, each column turned so that its highest is the larger.

    Raises
    ------
    RobotInvalid
        All faults at once.

    Examples
    --------
    >>> checked_allocation([[1, 0], [0, 0], [8, 1]], [2.0, (0.0, 3.0)], None, "NED").columns.tolist()
    [[1.0, 0.0, -8.0], [0.0, 0.0, -1.0]]
    """  # noqa: E501
    rows = array_of(matrix)
    faults = []
    if frame not in get_args(Axes):
        faults.append(f"the frame is {shown(frame)}; it should be ENU or NED")
    if rows is None or rows.ndim != 2 or rows.shape[0] != 3 or not np.isfinite(rows).all():
        size = "" if rows is None else f" of shape {rows.shape}"
        faults.append(
            f"the matrix{size} should be 3 rows of n finite numbers: surge, sway and yaw of each "
            "column"
        )
        raise RobotInvalid(faults)
    count = rows.shape[1]
    called = tuple(f"thruster {i + 1}" for i in range(count)) if names is None else items(names)
    if called is None or len(called) != count:
        faults.append(f"the names are {shown(names)}; there should be {count}, one a column")
        called = tuple(f"column {i + 1}" for i in range(count))
    faults += [fault for name in called for fault in name_faults(name)]
    ranges = _ranges(limits, called, faults)
    faults += [
        f"{name}: the column is 0; leave it out"
        for name, column in zip(called, rows.T, strict=True)
        if not column.any()
    ]
    if faults:
        raise RobotInvalid(faults)
    columns = Frame(mirrored=frame == "NED").wrench_from_file(rows.T)
    turned = -ranges[:, 0] > ranges[:, 1]
    columns[turned] *= -1.0
    ranges[turned] = -ranges[turned, ::-1]
    return Allocation(columns + 0.0, ranges + 0.0, called)


def robots_from(asked: Allocation, outline: Outline) -> list[Robot]:
    """Return the robots of a matrix: each on the line of action of its column, on board.

    It is where the line is nearest to the origin, or nearest to that within the outline; a column
    without a force is a couple at the origin, or at the point of the outline nearest to it.

    Raises
    ------
    RobotInvalid
        If lines run past the outline; all of them are told.
    """
    check_outline(outline)
    sizes = np.hypot(*asked.columns[:, :2].T)
    pure = sizes <= PURE * sizes.max(initial=0.0)
    robots, faults = [], []
    for column, (low, high), name, size, is_pure in zip(
        asked.columns, asked.ranges, asked.names, sizes, pure, strict=True
    ):
        factor = 1.0 if is_pure else float(size)
        said = {"limit": factor * high, "name": name, "mounted": True}
        said |= {"reverse_limit": -factor * low} if low < 0.0 else {"least": factor * low}
        if is_pure:
            if low > 0.0:
                faults.append(f"{name}: a couple is from nothing; its lowest should be 0 or below")
                continue
            robots.append(Robot(_middle(outline), lever=float(column[2]), **said))
            continue
        fx, fy, torque = (column / size).tolist()
        foot = outline.origin + torque * np.array([fy, -fx])
        point = _on_board(outline, foot, np.array([fx, fy]))
        if point is None:
            faults.append(
                f"{name}: its line of action is {abs(torque):.6g} m from the origin, past the "
                "outline; check the column, or give an outline that holds it"
            )
        else:
            robots.append(Robot(point, math.atan2(fy, fx), **said))
    if faults:
        raise RobotInvalid(faults)
    return robots


def square_around(asked: Allocation) -> Outline:
    """Return a square about the origin that holds the lines of action of a matrix."""
    half = asked.reach or 1.0
    corners = [(-half, -half), (half, -half), (half, half), (-half, half)]
    return Outline(corners, origin=(0.0, 0.0))


def _ranges(limits: object, names: Sequence[str], faults: list[str]) -> Array:
    """Return the lowest and highest (n, 2) [N] of columns; note what is wrong with them."""
    given = items(limits)
    if given is None:
        given = (limits,) * len(names)
    found = np.zeros((len(names), 2))
    if len(given) != len(names):
        faults.append(f"there are {len(given)} limits; there should be {len(names)}, one a column")
        return found
    for row, limit, name in zip(found, given, names, strict=True):
        pair = numbers(limit) if items(limit) is not None else (-number(limit), number(limit))
        if len(pair) != 2 or not pair[0] < pair[1] or not max(map(abs, pair)) > 0.0:
            faults.append(
                f"{name}: the limit is {shown(limit)}; it should be a number above 0, both ways, "
                "or the lowest and the highest, such as (-40, 51) or (0, 60) [N]"
            )
        else:
            row[:] = pair
    return found


def _middle(outline: Outline) -> tuple[float, float]:
    """Return the origin, or the point of the outline that is nearest to it."""
    x, y = outline.origin.tolist()
    if outline.contains_each([(x, y)])[0]:
        return x, y
    return outline.at_arc_length(float(outline.nearest([(x, y)])[1][0])).point


def _on_board(outline: Outline, foot: Array, way: Array) -> tuple[float, float] | None:
    """Return the point of a line, from a foot along a way, that is inside and nearest the foot."""
    if outline.contains_each(foot[None])[0]:
        return float(foot[0]), float(foot[1])
    ends = outline.vertices - foot
    off, along = ends @ np.array([-way[1], way[0]]), ends @ way
    next_off, next_along = np.roll(off, -1), np.roll(along, -1)
    crossed = (off * next_off <= 0.0) & (off != next_off)
    if not crossed.any():
        return None
    shares = off[crossed] / (off[crossed] - next_off[crossed])
    places = along[crossed] + shares * (next_along[crossed] - along[crossed])
    x, y = foot + places[np.abs(places).argmin()] * way
    return float(x), float(y)
