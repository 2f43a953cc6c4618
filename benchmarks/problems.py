"""Small placement problems: random and degenerate families, all drawn from a seeded generator."""

import numpy as np

from swarmgrasp import Newcomer, Outline, Problem, Robot, Swarm, quality

FAMILIES = (
    "rectangle, 15 + 1", "12-gon, 15 + 1", "free", "along normals", "integer grid", "one giant",
    "limits 1e-6 to 1e6", "balanced", "duplicated", "ring of 120 edges",
)  # fmt: skip
MOST = 15
"""Robots already there, at most."""


def rectangle(rng):
    """Draw a rectangle about the origin with half sides within [0.4, 2] m."""
    a, b = rng.uniform(0.4, 2.0, 2)
    return Outline([(-a, -b), (a, -b), (a, b), (-a, b)])


def oval(rng, edges=12):
    """Draw a polygon inscribed in an ellipse with half axes within [0.4, 2] m."""
    turn = np.arange(edges) * 2.0 * np.pi / edges
    return Outline(np.column_stack([np.cos(turn), np.sin(turn)]) * rng.uniform(0.4, 2.0, 2))


def crowd(outline, count, rng, along_normals=False):
    """Draw unit robots anywhere on an outline, pushing anywhere or pulling along the normal."""
    contacts = [outline.at_arc_length(share * outline.perimeter) for share in rng.random(count)]
    pulls = along_normals
    directions = [c.inward + np.pi if pulls else rng.uniform(-np.pi, np.pi) for c in contacts]
    return Swarm(outline, [Robot(c.point, d) for c, d in zip(contacts, directions, strict=True)])


def closed(outline, count, rng, along_normals=False):
    """Draw such a swarm in force closure."""
    while True:
        swarm = crowd(outline, count, rng, along_normals)
        if quality(swarm).is_force_closure:
            return swarm


def problem_of(family, rng):
    """Draw one problem of a family: up to 15 robots, and a newcomer of any kind."""
    outline = rectangle(rng)
    if family == "integer grid":
        a, b = rng.integers(1, 4, 2)
        outline = Outline([(-a, -b), (a, -b), (a, b), (-a, b)])
    elif family == "12-gon, 15 + 1":
        outline = oval(rng)
    elif family == "ring of 120 edges":
        turn = np.arange(120) * np.pi / 60
        outline = Outline(np.column_stack([2 * np.cos(turn), np.sin(turn)]))
    count = MOST if family.endswith("15 + 1") else int(rng.integers(3, MOST + 1))
    if family in ("balanced", "duplicated"):
        count = count // 2 + 1
    shares = rng.integers(0, 5, count) / 4 if family == "integer grid" else rng.random(count)
    contacts = [outline.at_arc_length(float(s) * outline.perimeter) for s in shares]
    normal = family in ("rectangle, 15 + 1", "12-gon, 15 + 1", "along normals", "integer grid")
    directions = [c.inward + np.pi if normal else rng.uniform(-np.pi, np.pi) for c in contacts]
    limits = np.ones(count)
    if family == "one giant":
        limits[0] = 10.0 ** rng.integers(1, 9)
    elif family == "limits 1e-6 to 1e6":
        limits = 10.0 ** rng.uniform(-6, 6, count)
    crew = [Robot(c.point, d, u) for c, d, u in zip(contacts, directions, limits, strict=True)]
    if family == "balanced":
        crew += [Robot(r.contact, r.direction + np.pi, r.limit) for r in crew]
    elif family == "duplicated":
        crew += crew
    kind = str(rng.choice(["push", "pull", "free"]))
    half_angle = None if kind == "free" else rng.choice([0.0, np.pi / 6, np.pi / 3, np.pi / 2])
    return Problem(Swarm(outline, crew[:MOST], 1.0), Newcomer(1.0, kind, half_angle))
