"""Wrench sets, and what fits into them, as polygons in the metric's coordinates."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.plot.tasks import Solid, solid
from swarmgrasp.quality import Criterion, quality
from swarmgrasp.quality.criterion import NOMINAL
from swarmgrasp.swarm import Swarm
from swarmgrasp.wrench_set import WrenchSet
from swarmgrasp.wrench_set.mesh import Mesh

FINE = 1e-3
"""How far round faces may reach beyond those drawn, relative to the set."""
SHARP = 0.906
"""Cosine between the normals of faces that are one round face from which on they are two."""
Vectors = NDArray[np.float64]
Piece = tuple[Vectors, Vectors]
"""A polygon (k, 3) [N, N, N] and its colour (4,)."""

LEVEL = 1e-9
"""Difference of two faces' distances that is rounding, relative to the set."""
ALIGNED = 1.0 - 1e-4
"""Cosine between the weakest direction and a face's normal from which on they are one."""


@dataclass(frozen=True, eq=False)
class Body:
    """The wrenches on an object in the worst case, in the metric's coordinates.

    Attributes
    ----------
    vertices : (v, 3) [N, N, N]
        Of the wrench set, moved by the load.
    faces : tuple of tuple of int
    edges : tuple of (int, int)
        Those that are no part of a round face.
    normals : (f, 3)
        Unit outward normals.
    offsets : (f,) [N]
        Distances of the faces from no wrench; negative beyond a face.
    robots : int
        How many exert them.
    quality : float [N]
        With a task, without a unit.
    held : Solid
        The largest ball about no wrench, or the task times the quality.
    touching : (3,) [N, N, N]
        Where that touches the boundary; no wrench when the quality is 0.
    weakest : (3,)
        Outward normal there; upward when there are no faces, or when a flat set is touched at its
        rim.
    facet : tuple of int
        The vertices of the face it touches; none when `weakest` is upward, or the set is round
        there. With a quality of 0 the face through no wrench, or the one that this is farthest
        beyond.
    """

    vertices: Vectors
    faces: tuple[tuple[int, ...], ...]
    edges: tuple[tuple[int, int], ...]
    normals: Vectors
    offsets: Vectors
    robots: int
    quality: float
    held: Solid
    touching: Vectors
    weakest: Vectors
    facet: tuple[int, ...]

    @property
    def is_beyond(self) -> bool:
        """Whether no wrench is outside: the load alone is not held."""
        size = float(np.abs(self.vertices).max())
        return bool((self.offsets < -LEVEL * size).any())


def body(swarm: Swarm, criterion: Criterion = NOMINAL) -> Body:
    """Return the wrenches a swarm leaves possible by a criterion, and what measures them (T1, T16).

    Of robots that may be lost, and of poses that are not certain, those of the worst case are
    drawn: robots in these poses have exactly the quality.

    Parameters
    ----------
    swarm : Swarm
    criterion : Criterion

    Returns
    -------
    Body
    """
    limit = quality(swarm, **criterion.keywords)
    worst = swarm if criterion.is_nominal else limit.worst_swarm
    mesh = WrenchSet(worst).mesh(FINE)
    load = np.array(criterion.load) * swarm.scale
    offsets = mesh.offsets + mesh.normals @ load
    heights = mesh.normals @ (mesh.vertices * swarm.scale + load).T
    facet: tuple[int, ...] = ()
    weakest = np.array([0.0, 0.0, 1.0])
    if mesh.faces:
        size = float(np.abs(mesh.vertices * swarm.scale).max())
        along = mesh.normals @ limit.direction
        least = ALIGNED
        if limit.value == 0.0:
            lowest = offsets.min() + LEVEL * size
            along, least = np.where(offsets <= lowest, along, -np.inf), -1.0
        best = int(along.argmax())
        is_round = offsets - heights.max(axis=1) > LEVEL * size
        if along[best] >= least and not is_round[best]:
            facet, weakest = mesh.faces[best], mesh.normals[best]
        elif is_round.any():
            weakest = limit.direction
    return Body(
        vertices=mesh.vertices * swarm.scale + load,
        faces=mesh.faces,
        edges=_edges(mesh),
        normals=mesh.normals,
        offsets=offsets,
        robots=len(worst),
        quality=limit.value,
        held=solid(criterion, swarm.scale).times(limit.value),
        touching=limit.weakest_wrench * swarm.scale,
        weakest=weakest,
        facet=facet,
    )


def _edges(mesh: Mesh) -> tuple[tuple[int, int], ...]:
    """Return the edges of a mesh, of a round one those that it bends at sharply."""
    if mesh.gap == 0.0:
        return mesh.edges
    normals: dict[tuple[int, int], Vectors] = {}
    found = []
    for face, normal in zip(mesh.faces, mesh.normals, strict=True):
        for a, b in zip(face, face[1:] + face[:1], strict=True):
            other = normals.setdefault((min(a, b), max(a, b)), normal)
            if normal @ other < SHARP:
                found.append((min(a, b), max(a, b)))
    return tuple(sorted(found))


def split(
    patches: Sequence[Vectors], colours: Vectors, shape: Body
) -> tuple[list[Piece], list[Piece]]:
    """Cut polygons at a convex body.

    Parameters
    ----------
    patches : sequence of k (c, 3) [N, N, N]
        Convex polygons.
    colours : (k, 4)
    shape : Body

    Returns
    -------
    inside, outside : list of (polygon, colour)
        The parts inside the body and those outside it.
    """
    inside: list[Piece] = []
    outside: list[Piece] = []
    for patch, colour in zip(patches, colours, strict=True):
        rest, height = patch, patch @ shape.normals.T - shape.offsets
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
