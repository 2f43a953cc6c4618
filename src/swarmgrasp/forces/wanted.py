"""What is asked for: wrenches that are numbers, of sizes that can be computed with."""

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import SwarmInvalid, WrenchInvalid, refuse
from swarmgrasp.ranges import STRONGEST, WEAKEST, array_of, shown
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.columns import MOST_LISTED
from swarmgrasp.swarm.swarm import swarm_faults

Triple = tuple[float, float, float]
CALM: Triple = (0.0, 0.0, 0.0)
"""No wrench [N, N, N m]."""
UNITS = "[N, N, N m]"
RANGE = f"its largest number should be 0 or {WEAKEST:g} <= size <= {STRONGEST:g} {UNITS}"


def check_forces(swarm: Swarm, wrench: object, load: object) -> tuple[Triple, Triple]:
    """Return a wrench and a load as numbers.

    Raises
    ------
    SwarmInvalid, WrenchInvalid
        As `forces` says.

    Examples
    --------
    >>> check_forces(None, (1, 2), (0, 0, float("inf")))  # type: ignore[arg-type]
    Traceback (most recent call last):
    ...
    swarmgrasp.errors.SwarmInvalid: None is no Swarm: make one with Swarm(outline, robots)
    the wrench is (1, 2); it should be three finite numbers [N, N, N m]
    the load is (0, 0, inf); it should be three finite numbers [N, N, N m]
    """
    wanted, faults = _triple(wrench, "wrench")
    given, more = _triple(load, "load")
    refuse((SwarmInvalid, swarm_faults(swarm)), (WrenchInvalid, faults + more))
    return wanted, given


def check_forces_along(
    swarm: Swarm, wrenches: object, load: object
) -> tuple[NDArray[np.float64], Triple]:
    """Return wrenches (m, 3) as a new array, and a load as numbers.

    Raises
    ------
    SwarmInvalid, WrenchInvalid
        As `forces_along` says.
    """
    rows, faults = _rows(wrenches)
    given, more = _triple(load, "load")
    refuse((SwarmInvalid, swarm_faults(swarm)), (WrenchInvalid, faults + more))
    return rows, given


def _triple(value: object, name: str) -> tuple[Triple, list[str]]:
    """Return a wrench as three floats, and what is wrong with it."""
    array = array_of(value)
    if array is None or array.shape != (3,) or not np.isfinite(array).all():
        return CALM, [f"the {name} is {shown(value)}; it should be three finite numbers {UNITS}"]
    x, y, z = array.tolist()
    largest = max(abs(x), abs(y), abs(z))
    if largest == 0.0 or WEAKEST <= largest <= STRONGEST:
        return (x, y, z), []
    return CALM, [f"the {name} is {shown(value)}; {RANGE}"]


def _rows(wrenches: object) -> tuple[NDArray[np.float64], list[str]]:
    """Return wrenches as a new array (m, 3), and what is wrong with them."""
    none = np.zeros((0, 3))
    rows = array_of(wrenches)
    if rows is None:
        return none, [f"the wrenches are {shown(wrenches)}; they should be numbers (m, 3) {UNITS}"]
    if rows.shape in ((0,), (0, 3)):
        return none, []
    if rows.ndim != 2 or rows.shape[1] != 3:
        return none, [f"the wrenches have shape {rows.shape}; it should be (m, 3) {UNITS}"]
    rows = np.ascontiguousarray(rows)
    sizes = np.abs(rows).max(axis=1)
    good = (sizes == 0.0) | ((sizes >= WEAKEST) & (sizes <= STRONGEST))
    wrong = np.flatnonzero(~good)
    faults = []
    for i in wrong[:MOST_LISTED].tolist():
        remedy = RANGE if np.isfinite(rows[i]).all() else f"it should be finite {UNITS}"
        faults.append(f"wrench {i} is {rows[i].tolist()}; {remedy}")
    left = len(wrong) - MOST_LISTED
    return rows, faults + ([f"... and {left} more"] if left > 0 else [])
