"""Robots that can exert all kinds of force sets, and wrenches that are easy or hard to make."""

import math
from dataclasses import replace

import numpy as np

from swarmgrasp import Outline, Robot, Swarm

BARGE = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
KINDS = (
    "ray", "segment", "sector", "half", "wide", "azimuth", "both", "finger", "cable", "envelope",
    "holding finger", "taut", "steady",
)  # fmt: skip
CREWS = (
    KINDS, KINDS, ("azimuth",), ("sector",), ("segment",), ("cable", "ray"),
    ("azimuth", "sector", "ray", "segment"),
)  # fmt: skip
SIZES = [0, 1, 2, 3, 4, 6, 8, 15, 30]


def robot_of(kind, rng, contact, direction, limit):
    """Return a robot of a kind."""
    more = {
        "segment": {"reverse_limit": limit * rng.choice([1.0, 0.6])},
        "sector": {"steers": float(rng.choice([0.5236, 1e-6, rng.uniform(0.0, 1.5)]))},
        "half": {"steers": math.pi / 2},
        "wide": {"steers": rng.uniform(1.6, 3.1)},
        "azimuth": {"steers": math.pi},
        "both": {"steers": rng.uniform(0.1, 1.5), "reverse_limit": 0.5 * limit},
        "finger": {"friction": rng.uniform(0.1, 1.0)},
        "cable": {"least": limit * rng.choice([0.1, 0.5])},
        "holding finger": {"friction": 0.4, "least": 0.2 * limit},
        "taut": {"steers": rng.uniform(0.1, 1.4), "least": 0.2 * limit},
        "steady": {"least": limit},
    }
    if kind == "envelope":
        corners = rng.normal(size=(rng.integers(2, 7), 2)) + 1.5 * rng.integers(2) * rng.normal(
            size=2
        )
        more["envelope"] = {"envelope": (limit * corners).tolist(), "limit": 1.0}
    said = {"limit": float(limit)} | more.get(kind, {})
    return Robot(contact, direction, mounted=True, **said)


def crew_of(rng):
    """Return robots at random, at one point, on a line, on a grid, in a ring; some with a giant."""
    n, place = int(rng.choice(SIZES)), rng.integers(6)
    kinds = CREWS[rng.integers(len(CREWS))]
    is_aligned = rng.random() < 0.15
    robots = []
    for i in range(n):
        turn = math.tau * i / n
        contact = [
            (rng.uniform(-40, 40), rng.uniform(-10, 10)),
            (rng.uniform(-40, 40), rng.uniform(-10, 10)),
            (5.0, 2.0),
            (rng.choice([-40.0, 0.0, 40.0]), 0.0),
            (rng.choice([-40.0, -20.0, 0.0, 20.0, 40.0]), rng.choice([-10.0, 10.0])),
            (9.9 * math.cos(turn), 9.9 * math.sin(turn)),
        ][place]
        way = (
            rng.uniform(-3.1, 3.1)
            if rng.random() < 0.5
            else rng.choice([0, 0.5, 1, -0.5]) * math.pi
        )
        limit = rng.choice([100.0, 200.0, 300.0]) if rng.random() < 0.7 else rng.uniform(10, 1e3)
        kind = kinds[rng.integers(len(kinds))]
        robots.append(robot_of(kind, rng, contact, 0.0 if is_aligned else float(way), limit))
    if n and rng.random() < 0.08 and robots[0].envelope is None:
        robots[0] = replace(robots[0], limit=robots[0].limit * 10.0 ** rng.integers(2, 6))
    length = None if rng.random() < 0.7 else rng.uniform(1.0, 100.0)
    weights = tuple(rng.uniform(0.3, 3.0, 2)) if rng.random() < 0.2 else (1.0, 1.0)
    return Swarm(BARGE, robots, length, weights)


def corners_of(swarm, turn=0.01):
    """Return forces (m, 2) [N, N] of each robot whose hull is its set, but for a small turn."""
    elements, counts = swarm.force_sets
    found = []
    for rows in np.split(elements, np.cumsum(counts)[:-1]) if len(counts) else ():
        corners = [row[None, 1:3] for row in rows if row[0] == 0.0]
        for radius, _, _, start, end in rows[rows[:, 0] > 0.0]:
            turns = np.linspace(start, end, math.ceil((end - start) / turn) + 1)
            corners.append(radius * np.column_stack([np.cos(turns), np.sin(turns)]))
        found.append(np.concatenate(corners))
    return found


def wrench_for(rng, swarm):
    """Return a wrench inside, on the boundary or outside, along an axis, or next to one inside."""
    kind, size = rng.integers(6), float(swarm.limits.sum()) or 1.0
    if kind == 2:
        return rng.normal(size=3) * [size / 5, size / 5, 3 * size]
    if kind == 3:
        return np.eye(3)[rng.integers(3)] * size * rng.choice([-0.1, 0.1, 1.0])
    if kind == 5:
        return rng.normal(size=3) * size * 10.0 ** rng.uniform(-2.0, 2.0)
    inside = np.zeros(3)
    for (x, y), corners in zip(
        swarm.contacts - swarm.outline.origin, corners_of(swarm, 0.5), strict=True
    ):
        few = rng.choice([0.1, 1.0, 3.0])
        fx, fy = rng.dirichlet(np.full(len(corners), few)) @ corners
        inside += (fx, fy, x * fy - y * fx)
    if kind == 4:
        return 0.1 * inside + rng.normal(size=3) * size * 1e-6
    return inside * (1.0 if kind == 0 else rng.choice([0.3, 1.0, 1.5]))


SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
SIDES = [(math.radians(20), math.radians(160)), (math.radians(200), math.radians(340))]
"""Sectors that leave out a gap ahead and one astern."""


def unit(*robots):
    """Return robots on the square, in the unit metric."""
    return Swarm(SQUARE, robots, characteristic_length=1.0)


def robots_with_gaps(rng, count, fewest=1):
    """Return robots of up to three sectors each, mounted on the square, at random."""
    robots = []
    for _ in range(count):
        ends = np.sort(rng.uniform(0.0, math.tau, 2 * rng.integers(fewest, 4)))
        ends += rng.uniform(-3, 3)
        sectors = list(zip(ends[::2].tolist(), ends[1::2].tolist(), strict=True))
        contact = tuple(rng.uniform(-1, 1, 2).tolist())
        limit = float(rng.uniform(0.5, 2.0))
        robots.append(Robot(contact, limit=limit, sectors=sectors, mounted=True))
    return robots
