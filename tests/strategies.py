"""Swarms, newcomers and placement problems that are easy or hard to get right.

Everything is drawn from a family's name and a seed, so that a failure is two words long.
"""

import math

import numpy as np
from hypothesis import strategies as st

from swarmgrasp import Newcomer, Outline, Robot, Stretch, Swarm, Zone
from swarmgrasp.placement import Problem

RECTANGLE = [(-2.0, -1.0), (2.0, -1.0), (2.0, 1.0), (-2.0, 1.0)]
L_SHAPE = [(0.0, 0.0), (3.0, 0.0), (3.0, 1.0), (1.0, 1.0), (1.0, 2.0), (0.0, 2.0)]
TURNS = 2.0 * math.pi * np.arange(120) / 120
RING = np.column_stack([3.0 * np.cos(TURNS), 2.0 * np.sin(TURNS)])

FAMILIES = (
    "along normals",
    "free",
    "integer grid",
    "giant",
    "spread limits",
    "balanced",
    "duplicated",
    "through a point",
    "nearly parallel",
    "ring",
    "notched",
    "weighted",
)
"""Kinds of swarms, the usual ones first."""


DOCK = [(-30, -20), (30, -20), (30, -14), (-24, -14), (-24, 14), (30, 14), (30, 20), (-30, 20)]
"""A U, open to +x."""


def twisted(rng):
    """Return a star that is turned the more, the farther from its middle: full of bights."""
    from shapely import Polygon

    while True:
        turns = np.sort(rng.uniform(0.0, math.tau, rng.integers(5, 14)))
        reach = rng.uniform(0.2, 1.0, len(turns))
        turns = turns + reach * rng.uniform(0.0, 3.0)
        corners = np.column_stack([reach * np.cos(turns), reach * np.sin(turns)])
        if Polygon(corners).is_valid and np.ptp(turns) > 1.0:
            return Outline(corners)


def rectangle(rng):
    """Return a rectangle of random proportions about the origin."""
    half = (rng.uniform(0.5, 3.0), rng.uniform(0.5, 3.0))
    return Outline(np.array([(-1, -1), (1, -1), (1, 1), (-1, 1)]) * half)


def outline_of(family, rng):
    """Return the object of a family."""
    if family == "integer grid":
        return Outline(RECTANGLE)
    if family == "ring":
        return Outline(RING)
    if family == "notched":
        return Outline(L_SHAPE)
    if family == "weighted":
        return Outline(rng.normal(size=(3, 2)), origin=rng.uniform(-50.0, 50.0, 2))
    return rectangle(rng)


def robots_of(family, rng, outline, n):
    """Return n robots, a few more or less where the family asks for pairs or copies."""
    contacts = [outline.at_arc_length(s) for s in rng.uniform(0.0, outline.perimeter, n)]
    points, limits = [c.point for c in contacts], np.ones(n)
    angles = rng.uniform(-math.pi, math.pi, n)
    if family == "along normals":
        angles = np.array([c.inward + math.pi for c in contacts])
    elif family == "integer grid":
        grid = [(x, y) for x in range(-2, 3) for y in (-1, 0, 1) if abs(x) == 2 or y]
        points = [grid[k] for k in rng.integers(len(grid), size=n)]
        angles = 0.5 * math.pi * rng.integers(-1, 3, n)
    elif family == "giant":
        limits[: min(n, 1)] = 1e9
    elif family in ("spread limits", "weighted"):
        limits = 10.0 ** rng.uniform(-6.0, 6.0, n)
    elif family == "through a point":
        middle = rng.uniform(-0.4, 0.4, 2)
        angles = np.array([math.atan2(*(middle - p)[::-1]) for p in points])
    elif family == "nearly parallel":
        few = rng.uniform(-math.pi, math.pi, 3)
        angles = rng.choice(few, n) + 1e-9 * rng.normal(size=n)
        spots = rng.uniform(0.0, outline.perimeter, 4)
        points = [outline.at_arc_length(rng.choice(spots)).point for _ in range(n)]
    robots = [Robot(*row) for row in zip(points, angles, limits, strict=True)]
    if family == "balanced":
        half = robots[: (n + 1) // 2]
        robots = half + [Robot(r.contact, r.direction + math.pi, r.limit) for r in half]
    elif family == "duplicated" and n:
        robots = [robots[k] for k in rng.integers((n + 2) // 3, size=n)]
    return robots


def swarm_of(family, seed, n):
    """Return about n robots of a family around its object, in a random or default metric."""
    rng = np.random.default_rng(seed)
    outline = outline_of(family, rng)
    robots = robots_of(family, rng, outline, n)
    length = rng.choice([1.0, outline.radius, rng.uniform(0.2, 5.0)])
    weights = tuple(rng.uniform(0.2, 5.0, 2)) if family == "weighted" else (1.0, 1.0)
    return Swarm(outline, robots, float(length), weights)


def newcomer_of(rng, limit=1.0):
    """Return a newcomer that may push, pull or both, within a sector or along the normal."""
    attachment = rng.choice(["push", "pull", "free"])
    half_angle = None if attachment == "free" else rng.choice([None, 0.0, 0.4])
    return Newcomer(limit, str(attachment), half_angle)


def problem_of(family, seed, n):
    """Return a placement problem: often the whole boundary, sometimes zones and the rest."""
    rng = np.random.default_rng([seed, 1])
    swarm = swarm_of(family, seed, n)
    limit = float(rng.choice([1.0, 1.0, 1e-6, 1e6, 10.0 ** rng.uniform(-2, 2)]))
    if rng.random() < 0.6:
        return Problem(swarm, newcomer_of(rng, limit))
    spot, *ends = rng.uniform(0.0, swarm.outline.perimeter, 5).tolist()
    directions = (0.0, 2.0) if rng.random() < 0.3 else None
    zones = (Zone(Stretch(ends[0], ends[1], "one")), Zone(Stretch(spot, spot, "b"), "free"))
    zones += (Zone(Stretch(ends[1], ends[0], "two"), directions=directions),)
    no_go = (Stretch(ends[2], ends[2] + 0.5 * (swarm.outline.perimeter - ends[2])),)
    return Problem(swarm, newcomer_of(rng, limit), zones, no_go, float(rng.choice([0.0, 0.05])))


seeds = st.integers(0, 2**32 - 1)
swarms = st.builds(swarm_of, st.sampled_from(FAMILIES), seeds, st.integers(0, 12))
"""Few robots: every facet by the formula."""
large_swarms = st.builds(swarm_of, st.sampled_from(FAMILIES), seeds, st.integers(60, 100))
"""Enough robots for the sweep."""
problems = st.builds(problem_of, st.sampled_from(FAMILIES), seeds, st.integers(0, 12))
"""Placements of every kind."""
