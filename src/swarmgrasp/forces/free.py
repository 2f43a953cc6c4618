"""Wrenches of which a part does not matter, and the largest multiple of one within reach."""

from collections.abc import Collection
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.errors import ForceSetUnsupported, WrenchInvalid
from swarmgrasp.forces.answer import Array
from swarmgrasp.forces.least import rows_for
from swarmgrasp.forces.wanted import CALM, check_forces
from swarmgrasp.quality import Polytope, quality
from swarmgrasp.swarm import Swarm

PARTS: Final = ("fx", "fy", "tz")
"""The parts of a wrench: force along x and along y, and torque."""
INSIDE = 1e-9
"""Relative distance from the border at which a multiple is told, so that it is within reach."""


def with_free_parts(
    swarm: Swarm, wrench: ArrayLike, free: Collection[str], *, load: ArrayLike = CALM
) -> Array:
    """Choose the parts of a wrench that do not matter so that it takes the least largest share.

    That is a question about the projection of the wrench set along these parts, which the same
    kernels answer. If the others are out of reach, those of the nearest wrench are returned.

    Parameters
    ----------
    swarm : Swarm
        No robot of which has sectors with gaps between.
    wrench : (3,) [N, N, N m]
        What its free parts are is not looked at.
    free : collection of {"fx", "fy", "tz"}
        The parts that may be anything, not all three.
    load : (3,) [N, N, N m], optional
        As for `forces`.

    Returns
    -------
    (3,) [N, N, N m]
        The wrench for `forces`.

    Raises
    ------
    WrenchInvalid
        If a part is none, all are free, or a number is wrong.
    ForceSetUnsupported
        If robots have sectors with gaps between.

    Examples
    --------
    An airship with a tail thruster turns by 3.6 N m, if it may drift aside:

    >>> from math import pi
    >>> from swarmgrasp import Outline, Robot, Swarm
    >>> from swarmgrasp.forces import forces
    >>> hull = Outline([(-2, -0.6), (2, -0.6), (2, 0.6), (-2, 0.6)])
    >>> tail = Robot((-1.8, 0), pi / 2, 2.0, reverse_limit=2.0, mounted=True)
    >>> wrench = with_free_parts(Swarm(hull, [tail]), (0, 0, 3.6), ["fy"])
    >>> wrench.round(9).tolist(), forces(Swarm(hull, [tail]), wrench).is_degraded
    ([0.0, -2.0, 3.6], False)
    """
    wanted, given = check_forces(swarm, wrench, load)
    kept = np.array([part not in free for part in PARTS])
    if not kept.any() or any(part not in PARTS for part in free):
        raise WrenchInvalid(
            f"the parts that may be anything are {', '.join(free)}; they should be one or two of "
            f"{', '.join(PARTS)}"
        )
    if swarm.rare.gaps:
        raise ForceSetUnsupported(
            "wrenches with parts that may be anything are not known of robots whose sectors have "
            "gaps between; leave their other sectors out, or say the whole wrench"
        )
    seen = swarm.scale * kept
    x, y, z = (seen * given).tolist()
    row = rows_for(swarm, seen, (seen * wanted)[None], (x, y, z))
    vectors = row.vectors[0]
    arms = swarm.contacts - swarm.outline.origin
    turn = arms[:, 0] * vectors[:, 1] - arms[:, 1] * vectors[:, 0]
    made = np.array([*vectors.sum(axis=0), turn.sum()]) + given
    return np.where(kept, wanted, made)


def largest_multiple(swarm: Swarm, wrench: ArrayLike, *, load: ArrayLike = CALM) -> float:
    """Return the largest multiple of a wrench that is within reach, beside a load (T16).

    Parameters
    ----------
    swarm : Swarm
    wrench : (3,) [N, N, N m]
        Not zero.
    load : (3,) [N, N, N m], optional
        As for `forces`. If the load alone is out of reach, it is 0.

    Returns
    -------
    float
        A hair inside; of robots with gaps between their sectors, that of the best choice of one
        sector each.

    Examples
    --------
    >>> from swarmgrasp import Outline, Robot, Swarm
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> pair = Swarm(square, [Robot((-1, 0.5), 0.0, 3.0), Robot((-1, -0.5), 0.0, 1.0)])
    >>> round(largest_multiple(pair, (4, 0, 0)), 6)
    0.5
    """
    wanted, given = check_forces(swarm, wrench, load)
    found = quality(swarm, load=given, task=Polytope([wanted]))
    return found.value * (1.0 - INSIDE)
