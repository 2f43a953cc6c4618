"""Faces and corners of a zonotope, built from incidences rather than from coordinates."""

from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from fractions import Fraction

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import WrenchSetTooLarge
from swarmgrasp.frozen import Frozen

ANGLE_TOLERANCE = 1e-12
"""Angle [rad] up to which generators count as parallel, or as lying in a common plane."""

ROUNDING = 1e-15
"""Error of a triple product of unit vectors; its sign says nothing below this."""

MESH_LINES = 200
"""Most distinct generator directions a mesh takes; its faces number about their square."""

Signs = NDArray[np.bool_]
"""At which end of every line a corner sits, or which lines are meant."""

Plane = tuple[NDArray[np.float64], NDArray[np.float64], Signs]
"""Unit normal (3,), height of every direction over the plane, directions in the plane."""

Face = tuple[NDArray[np.float64], Signs, list[Signs]]
"""Unit outward normal (3,), lines not in the face's plane, corners counter-clockwise."""


@dataclass(frozen=True, eq=False)
class Mesh(Frozen):
    """The faces and corners of a wrench set.

    A flat set has one polygon, listed from both sides; a segment two vertices and no
    face; a set of one point one vertex.

    Attributes
    ----------
    vertices : (v, 3) [N, N, N m]
    faces : tuple of tuple of int
        Convex polygons: indices into `vertices`, counter-clockwise seen from outside.
    normals : (f, 3) [N, N, N]
        Unit outward normal of each face, in the metric's scaled coordinates.
    offsets : (f,) [N]
        Support function at each normal, scaled too. The quality is the least of them
        when the set is neither flat nor round (T2).
    gap : float [N]
        Of a set with round parts, how far it reaches beyond the faces at most, scaled too: it
        contains what the vertices span, and lies before the planes of `normals` and `offsets`.
        Of other sets 0, or rounding.
    """

    vertices: NDArray[np.float64]
    faces: tuple[tuple[int, ...], ...]
    normals: NDArray[np.float64] = field(repr=False)
    offsets: NDArray[np.float64] = field(repr=False)
    gap: float = 0.0

    @property
    def edges(self) -> tuple[tuple[int, int], ...]:
        """Pairs of vertex indices, each pair ascending, sorted."""
        if not self.faces:
            return ((0, 1),) if len(self.vertices) == 2 else ()
        sides = {
            (min(pair), max(pair))
            for face in self.faces
            for pair in zip(face, face[1:] + face[:1], strict=True)
        }
        return tuple(sorted(sides))

    @property
    def volume(self) -> float:
        """Volume [N^3 m] between the faces."""
        corners = self.vertices - self.vertices[0]
        fans = [corners[list(face)] for face in self.faces]
        return sum(float((np.cross(fan[1:-1], fan[2:]) @ fan[0]).sum()) / 6.0 for fan in fans)

    def section(self, torque: float) -> NDArray[np.float64]:
        """Cut at a torque: the forces that can be exerted with it.

        Parameters
        ----------
        torque : float [N m]

        Returns
        -------
        (k, 2) [N, N]
            Corners, counter-clockwise; none where no force goes with the torque. A flat set has
            one or two, and a face or side at just this torque is not told apart from its rim.

        Examples
        --------
        >>> from swarmgrasp.wrench_set import WrenchSet
        >>> prism = WrenchSet.from_generators([[1, 0, 1], [0, 1, 0], [0, 0, 1]]).mesh()
        >>> prism.section(0.5).tolist()
        [[0.0, 0.0], [0.5, 0.0], [0.5, 1.0], [0.0, 1.0]]
        """
        if not self.edges:
            return np.zeros((0, 2))
        one, other = self.vertices[np.array(self.edges).T]
        crossing = (one[:, 2] <= torque) != (other[:, 2] <= torque)
        one, other = one[crossing], other[crossing]
        share = (torque - one[:, 2]) / (other[:, 2] - one[:, 2])
        points = one[:, :2] + share[:, None] * (other - one)[:, :2]
        about = points - points.mean(axis=0) if len(points) else points
        order = np.argsort(np.arctan2(about[:, 1], about[:, 0]))
        return np.asarray(points[order])


def zonotope_mesh(
    generators: NDArray[np.float64], scale: NDArray[np.float64], start: NDArray[np.float64]
) -> Mesh:
    """List the faces and corners of a zonotope.

    Parameters
    ----------
    generators : (n, 3) [N, N, N m]
    scale : (3,) [1, 1, 1/m]
    start : (3,) [N, N, N m]
        By which it is moved.

    Raises
    ------
    WrenchSetTooLarge
        If the generators have more than `MESH_LINES` distinct directions.
    """
    mesh = _about_no_wrench(generators, scale)
    offsets = mesh.offsets + mesh.normals @ (start * scale)
    return Mesh(mesh.vertices + start, mesh.faces, mesh.normals, offsets)


def _about_no_wrench(generators: NDArray[np.float64], scale: NDArray[np.float64]) -> Mesh:
    """List the faces and corners of the sum of the segments from no wrench to each generator."""
    starts, ends, directions = _lines(generators, scale)
    if len(directions) < 2:
        corners = np.vstack([starts.sum(axis=0), ends])[: len(directions) + 1]
        return Mesh(corners, (), np.empty((0, 3)), np.empty(0))
    mesh = _assemble(starts, ends, scale, _faces(_planes(directions), directions))
    is_closed = len(mesh.vertices) - len(mesh.edges) + len(mesh.faces) == 2
    if len(mesh.faces) == 2 or is_closed:
        return mesh
    # near the tolerance "lies in the plane" is not transitive; exact signs always agree
    return _assemble(starts, ends, scale, _faces(_exact_planes(directions), directions))


def _assemble(
    starts: NDArray[np.float64],
    ends: NDArray[np.float64],
    scale: NDArray[np.float64],
    polygons: Iterable[Face],
) -> Mesh:
    """Give every corner of the faces a number and a place."""
    index: dict[bytes, int] = {}
    signs: list[Signs] = []
    faces, normals, beyond = [], [], []
    for normal, others, ring in polygons:
        face = []
        for corner in ring:
            key = corner.tobytes()
            if key not in index:
                index[key] = len(signs)
                signs.append(corner)
            face.append(index[key])
        faces.append(tuple(face))
        normals.append(normal)
        beyond.append(others)
    outward = np.array(normals)
    reach = sum(np.maximum(outward @ (tips * scale).T, 0.0) for tips in (starts, ends))
    offsets = np.where(beyond, reach, 0.0).sum(axis=1)  # a line in the face adds no rounding
    corners = np.array(signs, dtype=float) @ (ends - starts) + starts.sum(axis=0)
    return Mesh(corners, tuple(faces), outward, offsets)


def unit_directions(vectors: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the unit directions of the vectors that are not zero."""
    peaks = np.abs(vectors).max(axis=1, initial=0.0)
    # shaped first, so that squares neither over- nor underflow
    shaped: NDArray[np.float64] = vectors[peaks > 0.0] / peaks[peaks > 0.0, None]
    shaped /= np.linalg.norm(shaped, axis=1, keepdims=True)
    return shaped


def plane_tolerance(width: float) -> float:
    """Return the height over a plane, spanned by units `width` apart, that counts as zero."""
    return max(ANGLE_TOLERANCE, ROUNDING / width)


def across(unit: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return (2, 3): e1, e2 orthonormal with e1 x e2 = the given unit vector."""
    x, y, z = map(float, unit)
    s = 1.0 if z >= 0.0 else -1.0  # so that nothing cancels
    a = -1.0 / (s + z)
    b = x * y * a
    return np.array([[1.0 + s * x * x * a, s * b, -s * x], [b, s + y * y * a, -y]])


def fold(flat: NDArray[np.float64]) -> tuple[Signs, NDArray[np.intp]]:
    """Sort lines through the origin of a plane, given by vectors along them, by angle.

    Vectors are turned upward before their angles are taken: folding the angle itself
    modulo pi misorders those along the axis.

    Parameters
    ----------
    flat : (n, 2)

    Returns
    -------
    upward : (n,) of bool
        Whether a vector's own angle is in [0, pi).
    order : (n,) of int
        Indices in the order of the angles of the vectors turned upward.
    """
    x, y = flat.T
    upward = (y > 0.0) | ((y == 0.0) & (x > 0.0))
    turned = np.where(upward, 1.0, -1.0)
    return upward, np.argsort(np.arctan2(y * turned + 0.0, x * turned))


def _lines(
    generators: NDArray[np.float64], scale: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """Merge parallel and antiparallel generators into segments, and drop zeros.

    Returns
    -------
    starts, ends : (k, 3) [N, N, N m]
        The set is the sum of the segments from start to end.
    directions : (k, 3)
        Unit direction of each segment, scaled.

    Raises
    ------
    WrenchSetTooLarge
    """
    left = generators[np.abs(generators * scale).max(axis=1, initial=0.0) > 0.0]
    starts: list[NDArray[np.float64]] = []
    ends: list[NDArray[np.float64]] = []
    directions: list[NDArray[np.float64]] = []
    while len(left):
        if len(directions) == MESH_LINES:
            raise WrenchSetTooLarge(
                f"the generators have more than {MESH_LINES} distinct directions, so their mesh "
                f"would list more than {MESH_LINES**2 - MESH_LINES} faces: use support(), "
                "bounds() and contains(), which take any number, or a smaller swarm"
            )
        pointing = unit_directions(left * scale)
        sines = np.linalg.norm(np.cross(pointing[0], pointing), axis=1)
        along = sines <= ANGLE_TOLERANCE
        forward = along & (pointing @ pointing[0] > 0.0)
        starts.append(left[along & ~forward].sum(axis=0))
        ends.append(left[forward].sum(axis=0))
        directions.append(pointing[0])
        left = left[~along]
    rows = (-1, 3)
    return np.reshape(starts, rows), np.reshape(ends, rows), np.reshape(directions, rows)


def _pairs(
    directions: NDArray[np.float64],
) -> tuple[NDArray[np.intp], NDArray[np.float64], NDArray[np.float64]]:
    """Return all pairs (m, 2), the normals across them (m, 3) and their sines, widest first.

    u x v is taken as u x (v - u), with v turned to u's side first: the difference of
    close floats is exact, so the normal across a narrow pair is as good as any other.
    """
    pairs = np.column_stack(np.triu_indices(len(directions), 1))
    one, other = directions[pairs[:, 0]], directions[pairs[:, 1]]
    side = np.where((one * other).sum(axis=1) < 0.0, -1.0, 1.0)[:, None]
    crosses = side * np.cross(one, side * other - one)
    widths = np.linalg.norm(crosses, axis=1)
    order = np.argsort(-widths, kind="stable")
    return pairs[order], (crosses / widths[:, None])[order], widths[order]


def _planes(directions: NDArray[np.float64]) -> Iterator[Plane]:
    """Yield every plane that two directions span, once, up to the tolerance.

    The widest pairs come first: each plane is then found by its best conditioned pair,
    and the pairs of directions in it need no look of their own.
    """
    done = np.zeros((len(directions), len(directions)), dtype=bool)
    for (j, k), normal, width in zip(*_pairs(directions), strict=True):
        if done[j, k]:
            continue
        heights = directions @ normal
        members = np.abs(heights) <= plane_tolerance(width)
        members[[j, k]] = True
        done |= np.outer(members, members)
        yield normal, heights, members


def _exact_planes(directions: NDArray[np.float64]) -> Iterator[Plane]:
    """Yield every plane that two directions span, once, taking each float at its word."""
    exact = [[Fraction(float(v)) for v in row] for row in directions]
    done = np.zeros((len(directions), len(directions)), dtype=bool)
    for (j, k), normal, width in zip(*_pairs(directions), strict=True):
        if done[j, k]:
            continue
        heights = directions @ normal
        for i in np.flatnonzero(np.abs(heights) * width <= 10.0 * ROUNDING):
            heights[i] = _side(exact[j], exact[k], exact[i])
        members = heights == 0.0
        done |= np.outer(members, members)
        yield normal, heights, members


def _side(a: list[Fraction], b: list[Fraction], c: list[Fraction]) -> float:
    """Return the sign of det(a, b, c): 1, 0 or -1."""
    det = (
        (a[1] * b[2] - a[2] * b[1]) * c[0]
        + (a[2] * b[0] - a[0] * b[2]) * c[1]
        + (a[0] * b[1] - a[1] * b[0]) * c[2]
    )
    return float((det > 0) - (det < 0))


def _faces(planes: Iterable[Plane], directions: NDArray[np.float64]) -> Iterator[Face]:
    """Yield the two faces along each plane.

    Around a zonogon: start with every line of the plane at its lower end, send them to
    the upper end in the order of their angles, then back in the same order. The opposite
    face uses all the other ends, and is seen from the other side.
    """
    for normal, heights, members in planes:
        corner = heights > 0.0
        upward, order = fold(directions[members] @ across(normal).T)
        corner[members] = ~upward
        ring = []
        for line in np.tile(np.flatnonzero(members)[order], 2):
            ring.append(corner.copy())
            corner[line] = ~corner[line]
        yield normal, ~members, ring
        yield -normal, ~members, [~c for c in reversed(ring)]
