"""What rounded coordinates of an outline leave open about the robots that stand on it."""

import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.outline import Outline
from swarmgrasp.swarm.columns import Columns

ALONG = 1e-12
"""Angle [rad] between a direction and a normal that were computed from the same edge."""


def largest_error(outline: Outline, scale: NDArray[np.float64]) -> float:
    """Bound by how much any robot's generator may be off [N], per newton of its limit."""
    turned = math.hypot(scale[0], scale[1], outline.radius * scale[2])
    return float(outline.normal_errors.max() * turned + _moved(outline, scale))


def generator_errors(
    outline: Outline, columns: Columns, scale: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Bound by how much the generators may be off, by the outline's `precision`.

    Only robots that push or pull along the normal of an edge have their direction from the
    outline: it turns with the edge, and the contact and the centroid move too. All others, and
    those on edges along x or y, are where they are said to be.

    Parameters
    ----------
    outline : Outline
    columns : Columns
    scale : (3,) [1, 1, 1/m]
        Turns wrenches into the metric's coordinates.

    Returns
    -------
    (n,) [N]
        Of |b_i|, in these coordinates.
    """
    contacts, directions, limits, mounted = columns[:4]
    errors, edges = outline.normal_errors, len(outline)
    if not errors.any() or not len(limits):
        return np.zeros(len(limits))
    _, arcs = outline.nearest(contacts)
    at = np.clip(np.searchsorted(outline.corner_arc_lengths, arcs, "right") - 1, 0, edges - 1)
    turns, along, near = (
        np.zeros(len(limits)),
        arcs - outline.corner_arc_lengths[at],
        outline.tolerance,
    )
    is_on = {-1: along <= near, 0: along >= 0.0, 1: outline.lengths[at] - along <= near}
    for step, is_there in is_on.items():  # a corner is on both
        edge = (at + step) % edges
        off = np.remainder(directions - outline.inward_normals[edge] + 0.5 * math.pi, math.pi)
        is_along = is_there & (np.abs(off - 0.5 * math.pi) <= errors[edge] + ALONG)
        turns = np.maximum(turns, np.where(is_along, errors[edge], 0.0))
    c, s = np.cos(directions), np.sin(directions)
    x, y = (contacts - outline.origin).T
    turned = np.linalg.norm(np.column_stack([-s, c, x * c + y * s]) * scale, axis=1)
    errors = limits * (turns * turned + _moved(outline, scale))
    return np.where((turns > 0.0) & ~mounted, errors, 0.0)


def _moved(outline: Outline, scale: NDArray[np.float64]) -> float:
    """Return what a contact that moves, and the origin, change of a unit wrench."""
    return float(math.sqrt(8.0) * outline.precision * scale[2])
