"""Wrench sets and the ball as polygons in the metric's coordinates."""

import math
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.quality import quality
from swarmgrasp.swarm import Swarm
from swarmgrasp.wrench_set import WrenchSet

Vectors = NDArray[np.float64]
Piece = tuple[Vectors, Vectors]
"""A polygon (k, 3) [N, N, N] and its colour (4,)."""

BALL_STEPS: Final = (16, 32)
"""Parts of the ball from pole to pole and around."""


@dataclass(frozen=True, eq=False)
class Body:
    """A wrench set in the metric's coordinates, with its largest ball about the origin.

    Attributes
    ----------
    vertices : (v, 3) [N, N, N]
    faces : tuple of tuple of int
    edges : tuple of (int, int)
    normals : (f, 3)
        Unit outward normals.
    offsets : (f,) [N]
        Distances of the faces from the origin.
    radius : float [N]
        Of the ball: the quality.
    touching : (3,) [N, N, N]
        Where the ball touches the boundary; the origin when the radius is 0.
    facet : tuple of int
        The vertices of the face it touches, none when there are no faces.
    """

    vertices: Vectors
    faces: tuple[tuple[int, ...], ...]
    edges: tuple[tuple[int, int], ...]
    normals: Vectors
    offsets: Vectors
    radius: float
    touching: Vectors
    facet: tuple[int, ...]

    @property
    def weakest(self) -> Vectors:
        """(3,): outward normal of the touched face, upward when there is none."""
        if not self.facet:
            return np.array([0.0, 0.0, 1.0])
        normal: Vectors = self.normals[self.faces.index(self.facet)]
        return normal


def body(swarm: Swarm) -> Body:
    """Return the wrench set of a swarm, with the ball that measures its quality (T1).

    Parameters
    ----------
    swarm : Swarm

    Returns
    -------
    Body
    """
    mesh = WrenchSet(swarm).mesh()
    limit = quality(swarm)
    facet: tuple[int, ...] = ()
    if mesh.faces:
        facet = mesh.faces[int((mesh.normals @ limit.direction).argmax())]
    return Body(
        vertices=mesh.vertices * swarm.scale,
        faces=mesh.faces,
        edges=mesh.edges,
        normals=mesh.normals,
        offsets=mesh.offsets,
        radius=limit.value,
        touching=limit.value * limit.direction,
        facet=facet,
    )


def unit_ball() -> tuple[Vectors, Vectors]:
    """Return the unit ball as quadrangles.

    Returns
    -------
    patches : (q, 4, 3)
    normals : (q, 3)
        Unit outward normals.
    """
    rows, columns = BALL_STEPS
    tilt, turn = np.meshgrid(
        np.linspace(0.0, math.pi, rows + 1),
        np.linspace(0.0, 2.0 * math.pi, columns + 1),
        indexing="ij",
    )
    grid = np.stack([np.sin(tilt) * np.cos(turn), np.sin(tilt) * np.sin(turn), np.cos(tilt)], -1)
    corners = [grid[:-1, :-1], grid[1:, :-1], grid[1:, 1:], grid[:-1, 1:]]
    patches = np.stack(corners, axis=2).reshape(-1, 4, 3)
    normals = patches.mean(axis=1)
    return patches, normals / np.linalg.norm(normals, axis=1, keepdims=True)


def split(patches: Vectors, colours: Vectors, shape: Body) -> tuple[list[Piece], list[Piece]]:
    """Cut polygons at a convex body.

    Parameters
    ----------
    patches : (k, c, 3) [N, N, N]
        Convex polygons of c corners.
    colours : (k, 4)
    shape : Body

    Returns
    -------
    inside, outside : list of (polygon, colour)
        The parts inside the body and those outside it.
    """
    inside: list[Piece] = []
    outside: list[Piece] = []
    heights = patches @ shape.normals.T - shape.offsets
    for patch, colour, height in zip(patches, colours, heights, strict=True):
        rest = patch
        for plane in np.flatnonzero((height > 0.0).any(axis=0)):
            beyond, rest = _cut(rest, shape.normals[plane], shape.offsets[plane])
            outside += [(beyond, colour)] if len(beyond) > 2 else []
            if len(rest) < 3:
                break
        else:
            inside.append((rest, colour))
    return inside, outside


def _cut(polygon: Vectors, normal: Vectors, offset: float) -> tuple[Vectors, Vectors]:
    """Cut a convex polygon (k, 3) by a plane; return the parts beyond it and before it."""
    heights = polygon @ normal - offset
    beyond: list[Vectors] = []
    before: list[Vectors] = []
    for i, (point, height) in enumerate(zip(polygon, heights, strict=True)):
        (beyond if height > 0.0 else before).append(point)
        j = (i + 1) % len(polygon)
        if (height > 0.0) != (heights[j] > 0.0):
            crossing = point + (polygon[j] - point) * height / (height - heights[j])
            beyond.append(crossing)
            before.append(crossing)
    return np.reshape(beyond, (-1, 3)), np.reshape(before, (-1, 3))
