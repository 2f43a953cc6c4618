"""Robots as arrays: a million of them, checked at once and described a few at a time."""

import math
from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import RobotInvalid, RobotOffBoundary
from swarmgrasp.outline import Outline
from swarmgrasp.ranges import MOST_TURNED, STRONGEST, WEAKEST, items, kind_faults, shown
from swarmgrasp.swarm.names import Names
from swarmgrasp.swarm.robot import MOST_FRICTION, Robot, tolerance_faults
from swarmgrasp.swarm.tolerance import Tolerance

MOST_LISTED = 10
"""Robots at fault that a message describes; it counts the others."""
MADE_BY = "Robot(contact, direction, limit)"
FLAGS = "mounted flags"
SAID = (
    "contacts", "directions", "limits", FLAGS, "reverse limits", "steers", "frictions", "leasts"
)  # fmt: skip
"""What messages call the columns, in their order."""


FAR = 2.0**60
"""All that computes is told a couple as a force by so much weaker, at an arm by so much longer than
its lever: its torque is exact, and the force is less than rounding of anything (T29)."""


class Couple(NamedTuple):
    """Where what exerts a couple is, and the lever of its two forces."""

    contact: tuple[float, float]
    lever: float


NO_COUPLES: Mapping[int, Couple] = MappingProxyType({})


class Columns(NamedTuple):
    """The values of n robots, one array each."""

    contacts: NDArray[np.float64]
    """(n, 2) [m, m], in the frame of the outline's vertices."""
    directions: NDArray[np.float64]
    """(n,) [rad]"""
    limits: NDArray[np.float64]
    """(n,) [N]"""
    mounted: NDArray[np.bool_]
    """(n,)"""
    reverse_limits: NDArray[np.float64]
    """(n,) [N]"""
    steers: NDArray[np.float64]
    """(n,) [rad]"""
    frictions: NDArray[np.float64]
    """(n,): 0 for robots without."""
    leasts: NDArray[np.float64]
    """(n,) [N]"""


def columns_of(robots: Iterable[Robot]) -> Columns:
    """Return the values of robots, which have checked them.

    Raises
    ------
    RobotInvalid
        If something is no robot.
    """
    found = items(robots)
    if found is None:
        raise RobotInvalid(f"{shown(robots)} is no list of robots")
    faults = [fault for robot in found for fault in kind_faults(robot, Robot, MADE_BY)]
    if faults:
        raise RobotInvalid(faults[:MOST_LISTED] + _others(len(faults)))
    columns = Columns(
        np.array([robot.contact for robot in found], dtype=float).reshape(-1, 2),
        np.array([robot.direction for robot in found], dtype=float),
        np.array([robot.limit for robot in found], dtype=float),
        np.array([robot.mounted for robot in found], dtype=bool),
        np.array([robot.reverse_limit for robot in found], dtype=float),
        np.array([robot.steers for robot in found], dtype=float),
        np.array([robot.friction or 0.0 for robot in found], dtype=float),
        np.array([robot.least for robot in found], dtype=float),
    )
    levers = np.array([robot.lever for robot in found], dtype=float)
    return _far(columns, levers) if levers.any() else columns


def couple_of(robot: Robot) -> Couple | None:
    """Return the couple that a robot exerts; None if it pushes."""
    return Couple(robot.contact, robot.lever) if robot.lever else None


def _far(columns: Columns, levers: NDArray[np.float64]) -> Columns:
    """Return columns with couples, those of robots with levers (n,), as forces far away."""
    rows = np.flatnonzero(levers)
    columns.contacts[rows] = np.column_stack([FAR * levers[rows], np.zeros(len(rows))])
    columns.directions[rows] = 0.5 * math.pi
    for sizes in (columns.limits, columns.reverse_limits):
        sizes[rows] /= FAR
    return columns


def checked_columns(
    contacts: ArrayLike, directions: ArrayLike, limits: ArrayLike = 1.0,
    mounted: ArrayLike = False, reverse_limits: ArrayLike = 0.0, steers: ArrayLike = 0.0,
    frictions: ArrayLike = 0.0, leasts: ArrayLike = 0.0,
) -> Columns:  # fmt: skip
    """Return copies of arrays of the right type and shape, in the ranges of a `Robot`.

    Parameters
    ----------
    contacts : (n, 2) [m, m]
    directions : (n,) [rad]
    limits, reverse_limits, leasts : float or (n,) [N]
    mounted : bool or (n,)
    steers : float or (n,) [rad]
    frictions : float or (n,)

    Raises
    ------
    RobotInvalid
        All faults of type, of shape, or of values; of these, those of the first robots.

    Examples
    --------
    >>> checked_columns([(0, 1), (2, 3)], [0.5, 0.6], 7.0).limits.tolist()
    [7.0, 7.0]
    >>> checked_columns([(0, 1), (2, 3)], [0.5, 2e6], 7.0)
    Traceback (most recent call last):
    ...
    swarmgrasp.errors.RobotInvalid: R2: the direction is 2000000.0; it should be ...
    """
    given = (contacts, directions, limits, mounted, reverse_limits, steers, frictions, leasts)
    points, turns, *others = _arrays(*given)
    count = len(points) if points.size and points.ndim else 0
    if points.size and (points.ndim != 2 or points.shape[1] != 2):
        raise RobotInvalid(f"the contacts have shape {points.shape}; it should be (n, 2)")
    turns, *others = (c if c.size or count else c.ravel() for c in (turns, *others))
    faults = []
    if turns.shape != (count,):
        faults.append(f"the directions have shape {turns.shape}; it should be ({count},)")
    for name, array in zip(SAID[2:], others, strict=True):
        if array.shape not in ((), (1,), (count,)):
            faults.append(f"the {name} have shape {array.shape}; it should be () or ({count},)")
    if faults:
        raise RobotInvalid(faults)
    found = Columns(
        np.array(points, dtype=float, order="C").reshape(count, 2),
        np.array(turns, dtype=float),
        *(
            np.array(np.broadcast_to(array, count), dtype=bool if name == FLAGS else float)
            for name, array in zip(SAID[2:], others, strict=True)
        ),
    )
    _check_values(found)
    return found


def checked_tolerances(given: object, columns: Columns, names: Names) -> dict[int, Tolerance]:
    """Return the tolerances of robots by index: one for all of them, or one or None for each.

    Raises
    ------
    RobotInvalid
        If they are no tolerances, not so many, or do not go with a robot; the first ten robots at
        fault are described, the others counted.
    """
    count = len(columns.limits)
    if given is None:
        return {}
    each = (given,) * count if isinstance(given, Tolerance) else items(given)
    if each is None or len(each) != count:
        many = shown(given) if each is None else f"{len(each)}"
        raise RobotInvalid(
            f"the tolerances are {many}; they should be one, or one or None for each of {count} "
            "robots"
        )
    limits, mounted = columns.limits.tolist(), columns.mounted.tolist()
    faults = [
        f"{names[i]}: {fault}"
        for i, tolerance in enumerate(each)
        if tolerance is not None
        for fault in tolerance_faults(tolerance, limits[i], mounted[i])
    ]
    if faults:
        raise RobotInvalid(faults[:MOST_LISTED] + _others(len(faults)))
    return {i: tolerance for i, tolerance in enumerate(each) if tolerance is not None}


def check_contacts(
    outline: Outline, columns: Columns, names: Names, couples: Mapping[int, Couple] = NO_COUPLES
) -> None:
    """Raise `RobotOffBoundary` if robots hold nothing, those that exert couples where they are."""
    if couples:
        columns = columns._replace(contacts=np.array(columns.contacts))
        for i, couple in couples.items():
            columns.contacts[i] = couple.contact
    distances, arc_lengths = outline.nearest(columns.contacts)
    if distances.max(initial=0.0) <= outline.tolerance:
        return
    off = np.flatnonzero(~(distances <= outline.tolerance))
    aboard = columns.mounted[off]
    aboard[aboard] = outline.contains_each(columns.contacts[off[aboard]])
    off = off[~aboard]
    faults = []
    for i in off[:MOST_LISTED].tolist():
        nearest = outline.at_arc_length(float(arc_lengths[i]))
        where = outline.off_boundary(columns.contacts[i], nearest, float(distances[i]))
        remedy = (
            "a mounted robot should be inside the outline"
            if columns.mounted[i]
            else "move it there, or declare it mounted if it sits inside the outline"
        )
        faults.append(f"{names[i]} at {where}; {remedy}")
    if faults:
        raise RobotOffBoundary(faults + _others(len(off)))


def snapped(outline: Outline, columns: Columns, names: Names, snap: float) -> Columns:
    """Return columns whose contacts are moved to the boundary, if no more than so far.

    Those of mounted robots stay where they are.

    Parameters
    ----------
    outline : Outline
    columns : Columns
    names : Names
    snap : float [m]

    Raises
    ------
    RobotOffBoundary
        If robots are farther off; the first ten are described, the others counted.
    """
    distances, arc_lengths = outline.nearest(columns.contacts)
    moved = ~(columns.mounted | (distances <= outline.tolerance))
    spots = {
        i: outline.at_arc_length(float(arc_lengths[i])) for i in np.flatnonzero(moved).tolist()
    }
    far = [i for i in spots if not distances[i] <= max(snap, outline.tolerance)]
    if far:
        raise RobotOffBoundary([
            f"{names[i]} at "
            f"{outline.off_boundary(columns.contacts[i], spots[i], float(distances[i]))}; snap "
            f"moves it by {snap:g} m at most: measure again, or give a larger snap"
            for i in far[:MOST_LISTED]
        ] + _others(len(far)))  # fmt: skip
    contacts = np.array(columns.contacts)
    for i, spot in spots.items():
        contacts[i] = spot.point
    return columns._replace(contacts=contacts)


def _arrays(*values: ArrayLike) -> list[NDArray[np.generic]]:
    """Return values as arrays of numbers, or of flags."""
    arrays, faults = [], []
    for name, given in zip(SAID, values, strict=True):
        kinds, meant = ("b", "True or False") if name == FLAGS else ("iuf", "numbers")
        try:
            arrays.append(array := np.asarray(given))
        except ValueError:
            faults.append(f"the {name} have rows of different lengths")
        else:
            if array.size and array.dtype.kind not in kinds:
                faults.append(f"the {name} are of type {array.dtype}; they should be {meant}")
    if faults:
        raise RobotInvalid(faults)
    return arrays


def robot_of(
    columns: Columns, i: int, name: str, couple: Couple | None = None, **more: Any
) -> Robot:
    """Return a robot of the arrays, which checks its values."""
    contact, direction, limit, mounted, reverse, steers, friction, least = (
        column[i].tolist() for column in columns
    )
    if couple is not None:
        return Robot(
            couple.contact, limit=FAR * limit, name=name, mounted=True, reverse_limit=FAR * reverse,
            lever=couple.lever, **more,
        )  # fmt: skip
    return Robot(
        tuple(contact), direction, limit, name, mounted, reverse_limit=reverse, steers=steers,
        friction=friction or None, least=least, **more,
    )  # fmt: skip


def _check_values(columns: Columns) -> None:
    """Raise `RobotInvalid`, in the words of `Robot`, for values outside its ranges."""
    x, y = columns.contacts.T
    limits, reverse, steers = columns.limits, columns.reverse_limits, columns.steers
    frictions, leasts = columns.frictions, columns.leasts
    wrong = {
        "contacts": ~(np.isfinite(x) & np.isfinite(y)),
        "directions": ~(np.abs(columns.directions) <= MOST_TURNED),
        "limits": ~((limits >= WEAKEST) & (limits <= STRONGEST)),
        "reverse limits": ~((reverse == 0.0) | ((reverse >= WEAKEST) & (reverse <= STRONGEST))),
        "steers": ~((steers >= 0.0) & (steers <= math.pi)),
        "frictions": ~((frictions >= 0.0) & (frictions <= MOST_FRICTION)),
        "leasts": ~((leasts == 0.0) | ((leasts >= WEAKEST) & (leasts <= limits))),
        "kinds": (frictions > 0.0) & ((reverse > 0.0) | (steers > 0.0))
        | (leasts > 0.0) & (reverse > 0.0),
    }
    found = np.flatnonzero(np.logical_or.reduce(list(wrong.values())))
    if not len(found):
        return
    faults: list[str] = []
    for i in found[:MOST_LISTED].tolist():
        try:
            robot_of(columns, i, f"R{i + 1}")
        except RobotInvalid as error:
            faults += error.faults
    counts = (f"{_grouped(flags.sum())} {name}" for name, flags in wrong.items() if flags.any())
    in_all = f"; in all, out of range: {', '.join(counts)}"
    raise RobotInvalid(faults + [line + in_all for line in _others(len(found))])


def _others(count: int) -> list[str]:
    """Return the line for those robots at fault, of a number, that a message leaves out."""
    left = count - MOST_LISTED
    return [f"... and {_grouped(left)} more"] if left > 0 else []


def _grouped(count: int) -> str:
    """Return a count with spaces between its thousands."""
    return f"{count:,}".replace(",", " ")
