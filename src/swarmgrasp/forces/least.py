"""Find the least loads that make wrenches (T18)."""

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.forces.answer import Forces, ForcesAlong, read_only
from swarmgrasp.forces.certificate import LoadCertificate
from swarmgrasp.forces.wanted import check_forces, check_forces_along
from swarmgrasp.kernels import loads as kernel
from swarmgrasp.swarm import Swarm

CALM = (0.0, 0.0, 0.0)
"""No load [N, N, N m]."""
_NO_LOAD = read_only(np.zeros(3))


def forces(swarm: Swarm, wrench: ArrayLike, *, load: ArrayLike = CALM) -> Forces:
    """Find how hard each robot pushes to make a wrench, with the least largest load.

    A load is a robot's force as a share of its limit. First the largest of all loads is made as
    small as it can be, and then, with none above it, the sum of their squares. If the
    wrench is out of reach, the nearest attainable one in the metric is made so instead.

    Parameters
    ----------
    swarm : Swarm
        Of any size, degenerate or not.
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
    RobotInvalid
        If the swarm is no `Swarm`, with those faults beside this one.

    Examples
    --------
    Two robots push a square ahead, one of them twice as strong; a third turns it:

    >>> from math import pi
    >>> from swarmgrasp import Outline, Robot, Swarm
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> robots = [Robot((-1, -0.5), 0.0), Robot((-1, 0.25), 0.0, limit=2.0), Robot((1, 0), pi / 2)]
    >>> swarm = Swarm(square, robots)
    >>> found = forces(swarm, (1.5, 0.0, 0.0))
    >>> found.loads.round(6).tolist(), found.largest_load, found.is_degraded
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
    row = np.frombuffer(kernel.least_loads(swarm.scaled_generators, scaled, (u * a, v * b, w * c)))
    n = len(swarm)
    needed, shortfall = row[n : n + 2].tolist()
    normals = row[n + 2 : n + 11].reshape(3, 3)
    return Forces(
        swarm,
        read_only(np.array(wanted)),
        read_only(np.array(given)) if given != CALM else _NO_LOAD,
        row[:n],
        needed,
        shortfall,
        LoadCertificate(read_only(normals[normals.any(axis=1)]), row[n + 11 :]),
    )


def forces_along(swarm: Swarm, wrenches: ArrayLike, *, load: ArrayLike = CALM) -> ForcesAlong:
    """Find how hard each robot pushes for each of many wrenches, such as a trajectory's.

    Each is found as by `forces`, and where they follow each other smoothly sooner than alone.
    The loads then follow smoothly too: they are a continuous function of the wrench.

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
    WrenchInvalid, RobotInvalid
        As for `forces`; of the wrenches at fault the first ten are shown.

    Examples
    --------
    >>> from swarmgrasp import Outline, Robot, Swarm
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> swarm = Swarm(square, [Robot((-1, 0), 0.0), Robot((1, 0), 3.141592653589793)])
    >>> found = forces_along(swarm, [(0.5, 0, 0), (-0.2, 0, 0), (0, 0, 0)])
    >>> found.loads.round(6).tolist()
    [[0.5, 0.0], [0.0, 0.2], [0.0, 0.0]]
    """
    wanted, given = check_forces_along(swarm, wrenches, load)
    a, b, c = (swarm.scale * given).tolist()
    m, n = len(wanted), len(swarm)
    found = kernel.least_loads(swarm.scaled_generators, wanted * swarm.scale, (a, b, c))
    table = np.frombuffer(found).reshape(m, n + 14)
    return ForcesAlong(
        swarm,
        read_only(wanted),
        read_only(np.array(given)),
        table[:, :n],
        table[:, n],
        table[:, n + 1],
        table[:, n + 2 : n + 11].reshape(m, 3, 3),
        table[:, n + 11 :],
    )
