"""Robots that may be elsewhere than they should, pose by pose: a slow truth for the worst case."""

import math
from dataclasses import replace

import numpy as np
from scipy.optimize import minimize

from reference import force_support

CONTACTS, TURNS = 9, 3
"""Poses drawn of each robot: contacts, the corners besides, and directions."""
AROUND = 400
"""Directions that are looked at before the walk down from the best."""


def drawn(outline, robot):
    """Yield moment arms (c, 2) [m] at which a robot may be, and it in each of its directions."""
    tolerance = robot.tolerance
    arms = np.reshape(robot.contact, (1, 2)) - outline.origin
    if tolerance is None:
        yield arms, robot
        return
    first, last = tolerance.offsets
    if tolerance.is_adrift:
        (at,) = outline.nearest(robot.contact)[1]
        corners = np.concatenate(
            [outline.corner_arc_lengths + k * outline.perimeter for k in (-1, 0, 1)]
        )
        inside = corners[(corners > at + first) & (corners < at + last)]
        arcs = np.concatenate([np.linspace(at + first, at + last, CONTACTS), inside])
        points = [outline.at_arc_length(float(s) % outline.perimeter).point for s in arcs]
        arms = np.array(points) - outline.origin
    limit = tolerance.least_limit or robot.limit
    for turn in np.linspace(*tolerance.turns, TURNS) if any(tolerance.turns) else (0.0,):
        yield (
            arms,
            replace(robot, direction=robot.direction + float(turn), limit=limit, tolerance=None),
        )


def heights(swarm, normals):
    """H(n) (m,) at normals (m, 3): each robot in its worst pose along each, knowing it."""
    n, total = normals * swarm.scale, np.zeros(len(normals))
    for robot in swarm:
        least = np.full(len(normals), math.inf)
        for arms, one in drawn(swarm.outline, robot):
            turned = np.stack([-arms[:, 1], arms[:, 0]], axis=1)
            p = n[:, None, :2] + n[:, None, 2:] * turned
            worths = force_support(one, p.reshape(-1, 2)).reshape(len(normals), -1)
            least = np.minimum(least, worths.min(axis=1))
        total += np.maximum(least, 0.0)
    return total


def worst_quality(swarm, near, enough=0.0):
    """Return the least H that some directions, and walks down from the best two of them, find.

    `near` (3,) is among the directions. Below `enough` the first. An upper bound of the quality in
    the worst case, and nearly always it.
    """
    normals = np.vstack([np.random.default_rng(1).normal(size=(AROUND, 3)), near])
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    values = heights(swarm, normals)
    best = float(values.min())
    for start in normals[np.argsort(values)[:2]]:
        if best < enough:
            break
        found = minimize(
            lambda n: float(heights(swarm, n[None] / np.linalg.norm(n))[0]),
            start,
            method="Nelder-Mead",
            options={"xatol": 1e-6, "fatol": 1e-7, "maxiter": 120},
        )
        best = min(best, float(found.fun))
    return best
