"""Robots as arrays: a million of them, checked at once and described a few at a time."""

from collections.abc import Iterable
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import RobotInvalid, RobotOffBoundary
from swarmgrasp.outline import Outline
from swarmgrasp.ranges import MOST_TURNED, STRONGEST, WEAKEST, items, kind_faults, shown
from swarmgrasp.swarm.names import Names
from swarmgrasp.swarm.robot import Robot

MOST_LISTED = 10
"""Robots at fault that a message describes; it counts the others."""
MADE_BY = "Robot(contact, direction, limit)"


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
    return Columns(
        np.array([robot.contact for robot in found], dtype=float).reshape(-1, 2),
        np.array([robot.direction for robot in found], dtype=float),
        np.array([robot.limit for robot in found], dtype=float),
        np.array([robot.mounted for robot in found], dtype=bool),
    )


def checked_columns(
    contacts: ArrayLike, directions: ArrayLike, limits: ArrayLike, mounted: ArrayLike
) -> Columns:
    """Return copies of arrays of the right type and shape, in the ranges of a `Robot`.

    Parameters
    ----------
    contacts : (n, 2) [m, m]
    directions : (n,) [rad]
    limits : float or (n,) [N]
    mounted : bool or (n,)

    Raises
    ------
    RobotInvalid
        All faults of type, of shape, or of values; of these, those of the first robots.

    Examples
    --------
    >>> checked_columns([(0, 1), (2, 3)], [0.5, 0.6], 7.0, False).limits.tolist()
    [7.0, 7.0]
    >>> checked_columns([(0, 1), (2, 3)], [0.5, 2e6], 7.0, False)
    Traceback (most recent call last):
    ...
    swarmgrasp.errors.RobotInvalid: R2: the direction is 2000000.0; it should be ...
    """
    points, *columns = _arrays(contacts, directions, limits, mounted)
    count = len(points) if points.size and points.ndim else 0
    if points.size and (points.ndim != 2 or points.shape[1] != 2):
        raise RobotInvalid(f"the contacts have shape {points.shape}; it should be (n, 2)")
    turns, forces, flags = (c if c.size or count else c.ravel() for c in columns)
    faults = []
    if turns.shape != (count,):
        faults.append(f"the directions have shape {turns.shape}; it should be ({count},)")
    for name, array in (("limits", forces), ("mounted flags", flags)):
        if array.shape not in ((), (1,), (count,)):
            faults.append(f"the {name} have shape {array.shape}; it should be () or ({count},)")
    if faults:
        raise RobotInvalid(faults)
    found = Columns(
        np.array(points, dtype=float, order="C").reshape(count, 2),
        np.array(turns, dtype=float),
        np.array(np.broadcast_to(forces, count), dtype=float),
        np.array(np.broadcast_to(flags, count), dtype=bool),
    )
    _check_values(found)
    return found


def check_contacts(outline: Outline, columns: Columns, names: Names) -> None:
    """Raise `RobotOffBoundary` if robots hold nothing."""
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


def _arrays(*values: ArrayLike) -> list[NDArray[np.generic]]:
    """Return values as arrays of numbers, and the last one of flags."""
    names = ("contacts", "directions", "limits", "mounted flags")
    arrays, faults = [], []
    for name, given in zip(names, values, strict=True):
        kinds, meant = ("b", "True or False") if name == names[-1] else ("iuf", "numbers")
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


def _check_values(columns: Columns) -> None:
    """Raise `RobotInvalid`, in the words of `Robot`, for values outside its ranges."""
    x, y = columns.contacts.T
    wrong = {
        "contacts": ~(np.isfinite(x) & np.isfinite(y)),
        "directions": ~(np.abs(columns.directions) <= MOST_TURNED),
        "limits": ~((columns.limits >= WEAKEST) & (columns.limits <= STRONGEST)),
    }
    found = np.flatnonzero(np.logical_or.reduce(list(wrong.values())))
    if not len(found):
        return
    faults: list[str] = []
    for i in found[:MOST_LISTED].tolist():
        point, direction, limit = (column[i].tolist() for column in columns[:3])
        try:
            Robot(tuple(point), direction, limit, name=f"R{i + 1}")
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
