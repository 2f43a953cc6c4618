"""Find the forces that make wrenches with the least shares (T18, T27).

Kernels find them, and check them themselves. Where rounding has misled that for rays, a linear
program tells it the normal to start from.
"""

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.forces.answer import Array, Forces, ForcesAlong
from swarmgrasp.forces.certificate import ForcesCertificate
from swarmgrasp.forces.choosing import gap_rows
from swarmgrasp.forces.rows import Rows, refuse_unproven, set_rows
from swarmgrasp.forces.start import start_for
from swarmgrasp.forces.wanted import CALM, Triple, check_forces, check_forces_along
from swarmgrasp.frozen import read_only
from swarmgrasp.kernels import shares as kernel
from swarmgrasp.swarm import Swarm

_NO_LOAD = np.zeros(3)


def forces(swarm: Swarm, wrench: ArrayLike, *, load: ArrayLike = CALM) -> Forces:
    """Find how hard each robot pushes to make a wrench, with the least largest share.

    A share is a robot's force as a part of its limit. First the largest of all shares is made as
    small as it can be, and then, with none above it, the sum of their squares. If the
    wrench is out of reach, the nearest attainable one in the metric is made so instead.

    A robot that steers, reverses or has friction exerts any force of its set, and its share is what
    that is of the largest the same way. The squares are of its force as a part of its
    largest, and for their sum the largest share may grow by 1e-6 of itself. One that always exerts
    a least force has a share from 0 there to 1 at its limit: the wrench is within reach if
    all can be made within their sets.

    A robot whose sectors have gaps between pushes in one of them, and in which it does is chosen
    anew for each wrench: exactly, by branch and bound over the choices (T28). For up to 4096 asked
    for; beyond that the best found is told, and the certificate's `sectors.is_best` says so.

    Parameters
    ----------
    swarm : Swarm
        Of any size, degenerate or not. Tolerances are not looked at.
    wrench : (3,) [N, N, N m]
        What the object is to receive, about the outline's origin.
    load : (3,) [N, N, N m], optional
        The wrench that the environment exerts on the object, such as wind and current: the
        robots make ``wrench - load``.

    Returns
    -------
    Forces

    Raises
    ------
    WrenchInvalid
        If the wrench or the load is not three finite numbers, the largest of size 0 or 1e-100 to
        1e100; all faults at once.
    SwarmInvalid
        If the swarm is no `Swarm`, with those faults beside this one.
    ForcesNotProven
        If rounding decides: robots are too unlike in strength, or alike to 1e-9 and not equal.

    Examples
    --------
    Two robots push a square ahead, one of them twice as strong; a third turns it:

    >>> from math import pi
    >>> from swarmgrasp import Outline, Robot, Swarm
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> robots = [Robot((-1, -0.5), 0.0), Robot((-1, 0.25), 0.0, limit=2.0), Robot((1, 0), pi / 2)]
    >>> swarm = Swarm(square, robots)
    >>> found = forces(swarm, (1.5, 0.0, 0.0))
    >>> found.shares.round(6).tolist(), found.largest_share, found.is_degraded
    ([0.5, 0.5, 0.0], 0.5, False)
    >>> far = forces(swarm, (4.0, 0.0, 0.0))
    >>> far.wrench.round(6).tolist(), round(far.shortfall, 6), bool(far.verify())
    ([3.0, 0.0, 0.0], 1.0, True)
    """
    wanted, given = check_forces(swarm, wrench, load)
    u, v, w = swarm.scale.tolist()
    x, y, z = wanted
    a, b, c = given
    scaled = np.array((u * x, v * y, w * z))
    row = _rows(swarm, scaled[None], (u * a, v * b, w * c))
    normals = row.normals[0]
    proof = row.sectors[0] if row.sectors else None
    return Forces(
        swarm,
        np.array(wanted),
        np.array(given) if given != CALM else _NO_LOAD,
        row.vectors[0],
        row.shares[0],
        float(row.needed[0]),
        float(row.shortfalls[0]),
        bool(row.is_least_squares[0]),
        ForcesCertificate(normals[normals.any(axis=1)], row.prices[0], proof),
    )


def forces_along(swarm: Swarm, wrenches: ArrayLike, *, load: ArrayLike = CALM) -> ForcesAlong:
    """Find how hard each robot pushes for each of many wrenches, such as a trajectory's.

    Each is found as by `forces`, and where they follow each other smoothly sooner than alone.
    The shares then follow smoothly too: they are a continuous function of the wrench, but where a
    robot changes between sectors with a gap between.

    Parameters
    ----------
    swarm : Swarm
    wrenches : (m, 3) [N, N, N m]
        What the object is to receive, about the outline's origin.
    load : (3,) [N, N, N m], optional
        The wrench that the environment exerts on the object.

    Returns
    -------
    ForcesAlong

    Raises
    ------
    SwarmInvalid, WrenchInvalid
        As for `forces`; of the wrenches at fault the first ten are shown.

    Examples
    --------
    >>> from swarmgrasp import Outline, Robot, Swarm
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> swarm = Swarm(square, [Robot((-1, 0), 0.0), Robot((1, 0), 3.141592653589793)])
    >>> found = forces_along(swarm, [(0.5, 0, 0), (-0.2, 0, 0), (0, 0, 0)])
    >>> found.shares.round(6).tolist()
    [[0.5, 0.0], [0.0, 0.2], [0.0, 0.0]]
    """
    wanted, given = check_forces_along(swarm, wrenches, load)
    a, b, c = (swarm.scale * given).tolist()
    return ForcesAlong(
        swarm, wanted, np.array(given), *_rows(swarm, wanted * swarm.scale, (a, b, c))
    )


def rows_in_step(swarm: Swarm, wrenches: Array, starts: Array) -> Rows:
    """Find how hard each robot pushes for wrenches that have nothing to do with each other.

    As `forces_along`, to the last bit the same for each whatever the others are: for runs of one
    swarm in step. What is given is trusted.

    Parameters
    ----------
    swarm : Swarm
    wrenches : (m, 3) [N, N, N m]
        What each object is to receive, about the outline's origin.
    starts : (m, 3)
        The first normals of what this gave a moment ago for wrenches like these: they are found
        sooner then. 0 where nothing is known.

    Raises
    ------
    ForcesNotProven
        If rounding decides.
    """
    return _rows(swarm, wrenches * swarm.scale, CALM, starts)


def rows_for(swarm: Swarm, scale: Array, wrenches: Array, load: Triple) -> Rows:
    """Return what the kernels find for wrenches (m, 3) where a scale takes the metric's place.

    Parameters
    ----------
    swarm : Swarm
        No robot of which has sectors with gaps between.
    scale : (3,)
        0 for parts of a wrench that are not seen.
    wrenches, load
        So scaled.
    """
    if not swarm.has_rays_only:
        return set_rows(swarm, wrenches, load, scale)
    return _of_rays(swarm, swarm.generators * scale, wrenches, load, None)


def _rows(swarm: Swarm, wrenches: Array, load: Triple, starts: Array | None = None) -> Rows:
    """Return what the kernels find for wrenches (m, 3), all in the metric's coordinates.

    Searches for rays start from normals (m, 3), if they are given; otherwise from each other's.

    Raises
    ------
    ForcesNotProven
        If rounding decides, so that forces can be found but not proven.
    """
    if swarm.has_rays_only:
        return _of_rays(swarm, swarm.scaled_generators, wrenches, load, starts)
    if swarm.rare.gaps:
        return gap_rows(swarm, wrenches, load)
    return set_rows(swarm, wrenches, load)


def _of_rays(swarm: Swarm, B: Array, wrenches: Array, load: Triple, starts: Array | None) -> Rows:
    """Return what the kernel finds for robots that push along rays, of scaled wrenches B (n, 3)."""
    m, n = len(wrenches), len(swarm)
    table = _ray_rows(swarm, B, wrenches, load, starts)
    shares, rest = table[:, :n], table[:, n:]
    vectors = shares[..., None] * swarm.generators[:, :2]
    normals, is_least = rest[:, 2:11].reshape(m, 3, 3), np.ones(m, dtype=bool)
    return Rows(read_only(vectors), shares, rest[:, 0], rest[:, 1], read_only(is_least),
                 normals, rest[:, 11:14])  # fmt: skip


def _ray_rows(swarm: Swarm, B: Array, wrenches: Array, load: Triple, starts: Array | None) -> Array:
    """Return the kernel's rows for robots that push along rays, all confirmed by its check."""
    given = () if starts is None else (starts,)
    rows = np.frombuffer(kernel.least_shares(B, wrenches, load, *given)).reshape(
        len(wrenches), len(swarm) + 15
    )
    unsure = np.flatnonzero(rows[:, -1] == 0.0)
    if len(unsure):
        rows = rows.copy()
    for k in unsure.tolist():
        start = np.array(start_for(B, wrenches[k] - load))
        rows[k] = np.frombuffer(kernel.least_shares(B, wrenches[k], load, start))
    if len(unsure) and not rows[unsure, -1].all():
        refuse_unproven(swarm, wrenches[unsure[np.argmin(rows[unsure, -1])]])
    return read_only(rows)
