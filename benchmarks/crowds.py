"""Swarms of any size for the growth of time and memory, by family."""

import numpy as np

from swarmgrasp import Outline, Swarm

RECTANGLE = ((-2.0, -1.0), (2.0, -1.0), (2.0, 1.0), (-2.0, 1.0))
FAMILIES = {
    "random": "contacts and directions anywhere, on a rectangle",
    "along normals": "pulling along the normals of a rectangle",
    "ring": "on an ellipse of 120 edges, within 0.02 rad of the normals",
    "duplicates": "64 distinct robots, repeated",
    "clustered": "20 clusters of contacts and directions, spread 1e-3",
    "needle": "forces along one axis, both ways, spread 1e-3",
    "one giant": "one robot a million times as strong as the others",
    "balanced": "each robot with its opposite at the same contact",
}


def swarm_of(family, count):
    """Draw a swarm of a family; unit robots, characteristic length 1 m, the same every time."""
    rng = np.random.default_rng(count)
    corners = RECTANGLE
    if family == "ring":
        turn = np.arange(120) * np.pi / 60
        corners = np.column_stack([2.0 * np.cos(turn), np.sin(turn)])
    outline = Outline(corners)
    shares, directions, limits = (
        rng.random(count),
        rng.uniform(-np.pi, np.pi, count),
        np.ones(count),
    )
    if family == "duplicates":
        shares, directions = shares[np.arange(count) % 64], directions[np.arange(count) % 64]
    elif family == "clustered":
        cluster = np.arange(count) % 20
        shares = np.clip(shares[cluster] + 1e-3 * rng.standard_normal(count), 0.0, 1.0)
        directions = directions[cluster] + 1e-3 * rng.standard_normal(count)
    elif family == "needle":
        directions = 0.3 + np.pi * (np.arange(count) % 2) + 1e-3 * rng.standard_normal(count)
    elif family == "one giant":
        limits[0] = 1e6
    elif family == "balanced":
        half = np.arange(count) // 2
        shares, directions = shares[half], directions[half] + np.pi * (np.arange(count) % 2)
    contacts, outward = points(outline, shares)
    if family == "along normals":
        directions = outward
    elif family == "ring":
        directions = outward + np.pi + rng.uniform(-0.02, 0.02, count)
    return Swarm.from_arrays(outline, contacts, directions, limits, characteristic_length=1.0)


def points(outline, shares):
    """Return boundary points (n, 2) [m] at shares of the perimeter, and the normals out [rad]."""
    arc = shares * outline.perimeter
    reach = outline.corner_arc_lengths
    loop = np.vstack([outline.vertices, outline.vertices[:1]])
    contacts = np.column_stack([np.interp(arc, reach, loop[:, axis]) for axis in (0, 1)])
    edge = np.clip(np.searchsorted(reach, arc, side="right") - 1, 0, len(outline) - 1)
    outward = np.array([outline.inward_normal(e) + np.pi for e in range(len(outline))])
    return contacts, outward[edge]
