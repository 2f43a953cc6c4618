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
    facet : tuple of int
        The vertices of the face it touches; none when there are no faces, or when a flat set is
        touched at its rim. With a quality of 0 the face through no wrench, or the one that this
        is farthest beyond.
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
    facet: tuple[int, ...]

    @property
    def weakest(self) -> Vectors:
        """(3,): outward normal of the touched face, upward when there is none."""
        if not self.facet:
            return np.array([0.0, 0.0, 1.0])
        normal: Vectors = self.normals[self.faces.index(self.facet)]
        return normal

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
    limit = quality(swarm, **criterion.terms)
    worst = swarm if criterion.is_nominal else limit.worst_swarm
    mesh = WrenchSet(worst).mesh()
    load = np.array(criterion.load) * swarm.scale
    offsets = mesh.offsets + mesh.normals @ load
    facet: tuple[int, ...] = ()
    if mesh.faces:
        along = mesh.normals @ limit.direction
        least = ALIGNED
        if limit.value == 0.0:
            lowest = offsets.min() + LEVEL * float(np.abs(mesh.vertices * swarm.scale).max())
            along, least = np.where(offsets <= lowest, along, -np.inf), -1.0
        best = int(along.argmax())
        facet = mesh.faces[best] if along[best] >= least else ()
    return Body(
        vertices=mesh.vertices * swarm.scale + load,
        faces=mesh.faces,
        edges=mesh.edges,
        normals=mesh.normals,
        offsets=offsets,
        robots=len(worst),
        quality=limit.value,
        held=solid(criterion, swarm.scale).times(limit.value),
        touching=limit.weakest_wrench * swarm.scale,
        facet=facet,
    )


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
