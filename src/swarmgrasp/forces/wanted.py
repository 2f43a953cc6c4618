"""What is asked for: wrenches that are numbers, of sizes that can be computed with."""

import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import RobotInvalid, WrenchInvalid
from swarmgrasp.ranges import STRONGEST, WEAKEST
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.columns import MOST_LISTED
from swarmgrasp.swarm.swarm import check_swarm

Triple = tuple[float, float, float]
UNITS = "[N, N, N m]"
RANGE = f"its largest number should be 0 or {WEAKEST:g} <= size <= {STRONGEST:g} {UNITS}"


def check_forces(swarm: object, wrench: object, load: object) -> tuple[Triple, Triple]:
    """Return a wrench and a load as numbers.

    Raises
    ------
    WrenchInvalid, RobotInvalid
        As `forces` says.

    Examples
    --------
    >>> check_forces(None, (1, 2), (0, 0, math.inf))
    Traceback (most recent call last):
    ...
    swarmgrasp.errors.RobotInvalid: NoneType is no Swarm: make one with Swarm(outline, robots)
    the wrench is (1, 2); it should be three finite numbers [N, N, N m]
    the load is (0, 0, inf); it should be three finite numbers [N, N, N m]
    """
    wanted, given = _triple(wrench), _triple(load)
    if isinstance(swarm, Swarm) and wanted and given and _is_sized(wanted) and _is_sized(given):
        return wanted, given
    faults = _triple_faults("wrench", wrench, wanted) + _triple_faults("load", load, given)
    raise _fault(swarm, faults)


def check_forces_along(
    swarm: object, wrenches: object, load: object
) -> tuple[NDArray[np.float64], Triple]:
    """Return wrenches (m, 3) as a new array, and a load as numbers.

    Raises
    ------
    WrenchInvalid, RobotInvalid
        As `forces_along` says.
    """
    given = _triple(load)
    rows, faults = _rows(wrenches)
    if isinstance(swarm, Swarm) and not faults and given and _is_sized(given):
        return rows, given
    raise _fault(swarm, faults + _triple_faults("load", load, given))


def _triple(value: object) -> Triple | None:
    """Return three numbers as floats, None for anything else."""
    try:
        array = np.asarray(value)
    except (TypeError, ValueError):
        return None
    if array.shape != (3,) or array.dtype.kind not in "iuf":
        return None
    x, y, z = map(float, array.tolist())
    return (x, y, z) if math.isfinite(x) and math.isfinite(y) and math.isfinite(z) else None


def _is_sized(triple: Triple) -> bool:
    """Tell whether the largest of three numbers is in range, or 0."""
    largest = max(map(abs, triple))
    return largest == 0.0 or WEAKEST <= largest <= STRONGEST


def _triple_faults(name: str, value: object, triple: Triple | None) -> list[str]:
    """Return what is wrong with a wrench."""
    if triple is None:
        return [f"the {name} is {_shown(value)}; it should be three finite numbers {UNITS}"]
    return [] if _is_sized(triple) else [f"the {name} is {_shown(value)}; {RANGE}"]


def _rows(wrenches: object) -> tuple[NDArray[np.float64], list[str]]:
    """Return wrenches as a new array (m, 3), and what is wrong with them."""
    none = np.zeros((0, 3))
    try:
        array = np.asarray(wrenches)
    except (TypeError, ValueError):
        return none, ["the wrenches have rows of different lengths; their shape should be (m, 3)"]
    if array.shape in ((0,), (0, 3)):
        return none, []
    if array.dtype.kind not in "iuf":
        return none, [f"the wrenches are of type {array.dtype}; they should be real numbers"]
    if array.ndim != 2 or array.shape[1] != 3:
        return none, [f"the wrenches have shape {array.shape}; it should be (m, 3) {UNITS}"]
    rows = np.array(array, dtype=float, order="C")
    sizes = np.abs(rows).max(axis=1)
    good = (sizes == 0.0) | ((sizes >= WEAKEST) & (sizes <= STRONGEST))
    wrong = np.flatnonzero(~good)
    faults = []
    for i in wrong[:MOST_LISTED].tolist():
        remedy = RANGE if np.isfinite(rows[i]).all() else f"it should be finite {UNITS}"
        faults.append(f"wrench {i} is {rows[i].tolist()}; {remedy}")
    left = len(wrong) - MOST_LISTED
    return rows, faults + ([f"... and {left} more"] if left > 0 else [])


def _shown(value: object) -> str:
    """Return a value as a message shows it."""
    text = repr(value.tolist() if isinstance(value, np.ndarray) else value)
    return text if len(text) <= 80 else f"{text[:77]}..."


def _fault(swarm: object, faults: list[str]) -> WrenchInvalid | RobotInvalid:
    """Return the error that tells all faults."""
    try:
        check_swarm(swarm)
    except RobotInvalid as error:
        return RobotInvalid([*error.faults, *faults])
    return WrenchInvalid(faults)
