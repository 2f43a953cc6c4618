"""Faces and corners of a convex set that is known by its farthest points: certified inside and out.

Vertices are points of the set, so what they span lies inside it; and the set lies before every face
moved out to the set's support function. Where a face has room to move, the set's farthest point
there is the next vertex. Sets without round parts end exact.
"""

import math
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import WrenchSetTooLarge
from swarmgrasp.wrench_set.mesh import Mesh

Array = NDArray[np.float64]
Farthest = Callable[[Array], Array]
"""Returns the points (m, 3) of a set that are farthest along normals (m, 3)."""
Triple = tuple[float, float, float]
Plane = tuple[float, float, float, float]
"""A unit outward normal, and the distance from the origin [N]."""
Triangle = tuple[int, int, int]
"""Indices of points, counter-clockwise seen from outside; and one of its sides."""
Side = tuple[int, int]

LEVEL = 2e-9
"""Distance from a face, relative to the set's size, that is none: what `TILT` may cost."""
ROUNDING = 1e-13
"""The same for a point that is beyond a face."""
TILT = np.array([0.577e-9, -0.311e-9, 0.443e-9])
"""Added to unit normals: of equally far points it chooses corners, no three of them in line."""
RIM, LEAN = 24, 1e-6
"""Normals next to a flat face's that its corners are looked for at, and how far they lean."""
MOST_VERTICES = 10_000
"""Most vertices a mesh lists."""


def rounded_mesh(farthest: Farthest, axes: Array, tolerance: float) -> Mesh:
    """List the faces and corners of a set, or of one close to it.

    Parameters
    ----------
    farthest : callable
        Points and normals in the metric's coordinates.
    axes : (2 or 3, 3)
        Orthonormal: what the differences of the set's points span.
    tolerance : float
        Greatest distance between a face and the set, relative to the set's size; 0 for a set
        without round parts.

    Returns
    -------
    Mesh
        In the metric's coordinates.
    """

    def corner(normals: Array) -> Array:
        """Return the farthest corners along unit normals."""
        return farthest(normals + TILT)

    ends = corner(np.concatenate([axes, -axes]))
    size = float(np.abs(ends - ends[0]).max())
    least = max(tolerance, LEVEL) * size
    if len(axes) == 2:
        return _polygon(farthest, corner, axes, least)
    hull = _Hull(farthest, corner, ROUNDING * size)
    hull.refine(least)
    hull.complete_flats(LEVEL * size, least)
    hull.refine(least)
    return hull.mesh(LEVEL * size)


def _polygon(farthest: Farthest, corner: Farthest, axes: Array, least: float) -> Mesh:
    """Return a flat set as one polygon, seen from both sides."""
    starts = np.concatenate([axes, -axes])
    sides = list(zip(starts, corner(starts), strict=True))
    found: list[Array] = []
    gap = 0.0
    stack = [(sides[k], sides[(k + 1) % 4]) for k in (3, 2, 1, 0)]
    while stack:
        (before, first), (after, second) = stack.pop()
        way = axes @ (second - first)
        if not np.hypot(*way) > least:
            continue
        normal = np.array([way[1], -way[0]]) @ axes / np.hypot(*way)
        room = float(normal @ (farthest(normal[None])[0] - first))
        middle = (normal, corner(normal[None])[0])
        if room > least and _is_new(middle[1], first, second):
            stack += [(middle, (after, second)), ((before, first), middle)]
        else:
            gap = max(gap, room)
            found.append(first)
    vertices = np.reshape(found, (-1, 3))
    pole = np.cross(*axes)
    normals = np.array([pole, -pole])
    ring = tuple(range(len(vertices)))
    offsets = (normals * farthest(normals)).sum(axis=1)
    gap = max(gap, float((offsets[:, None] - normals @ vertices.T).max()))
    return Mesh(vertices, (ring, ring[::-1]), normals, offsets, gap)


def _is_new(point: Array, *others: Array) -> bool:
    """Tell whether a point is none of the others."""
    return not any(np.array_equal(point, other) for other in others)


class _Hull:
    """A triangulated convex hull that takes one point after another.

    Parameters
    ----------
    farthest : callable
        The set's farthest points.
    corner : callable
        The same, always a corner.
    level : float [N]
        How far a point is beyond a triangle at least that it takes away.
    """

    def __init__(self, farthest: Farthest, corner: Farthest, level: float) -> None:
        self.farthest, self.corner, self.level = farthest, corner, level
        self.points: list[Triple] = []
        self.planes: dict[Triangle, Plane] = {}
        self.across: dict[Side, Triangle] = {}
        """The triangle that has a side, counter-clockwise."""
        self.rooms: dict[Triangle, tuple[float, Triple]] = {}
        """By how much the set reaches beyond a triangle [N], and its corner there."""
        corners = _four_corners(corner)
        self.points = [_triple(p) for p in corners]
        a, b, c, d = corners
        p, q, r, s = (0, 1, 2, 3) if np.cross(b - a, c - a) @ (d - a) < 0.0 else (0, 2, 1, 3)
        for triangle in ((p, q, r), (p, s, q), (q, s, r), (r, s, p)):
            self._add(triangle)

    def refine(self, least: float) -> None:
        """Add points until no triangle is farther than `least` from the set."""
        while True:
            self._look()
            wide = sorted((-room, t) for t, (room, _) in self.rooms.items() if room > least)
            before = len(self.points)
            for _, triangle in wide:
                if triangle in self.planes:
                    self._take(triangle, self.rooms[triangle][1])
            if len(self.points) > MOST_VERTICES:
                raise WrenchSetTooLarge(
                    f"the mesh would list more than {MOST_VERTICES} vertices: use support(), "
                    "bounds() and contains(), which take any number of robots, a smaller swarm, or "
                    "if robots steer a greater tolerance"
                )
            if len(self.points) == before:  # but for rounding nothing is beyond; gaps are told
                return

    def complete_flats(self, level: float, apart: float) -> None:
        """Add the corners of the faces that are flat, which those found may be part of.

        Parameters
        ----------
        level : float [N]
            Height over a face that is none.
        apart : float [N]
            How far from those found a corner is to be.
        """
        flats = [t for t, (room, _) in self.rooms.items() if room <= level]
        normals = np.array([self.planes[t][:3] for t in flats]).reshape(-1, 3)
        turns = np.linspace(0.0, math.tau, RIM, endpoint=False)
        bases = [np.linalg.qr(np.column_stack([n, np.eye(3)]))[0][:, 1:3].T for n in normals]
        ways = np.column_stack([np.cos(turns), np.sin(turns)]) * LEAN
        tilted = np.array([n + ways @ basis for n, basis in zip(normals, bases, strict=True)])
        corners = self.corner(tilted.reshape(-1, 3)).reshape(-1, RIM, 3)
        for triangle, points in zip(flats, corners, strict=True):
            for point in map(_triple, points):
                start = self._before(triangle, point, level) if triangle in self.planes else None
                if start is not None:
                    self._take(start, point, apart)
        self._look()

    def _before(self, flat: Triangle, point: Triple, level: float) -> Triangle | None:
        """Return a triangle that a point is beyond, next to those in whose plane it lies."""
        seen, stack = {flat}, [flat]
        while stack:
            triangle = stack.pop()
            height = self._height(triangle, point)
            if height > self.level:
                return triangle
            if height >= -level:
                new = {self.across[b, a] for a, b in _sides(triangle)} - seen
                seen |= new
                stack += new
        return None

    def _look(self) -> None:
        """Look how far the set reaches beyond the new triangles."""
        new = [t for t in self.planes if t not in self.rooms]
        normals = np.array([self.planes[t][:3] for t in new]).reshape(-1, 3)
        reach = (normals * self.farthest(normals)).sum(axis=1).tolist()
        corners = map(_triple, self.corner(normals))
        for triangle, h, point in zip(new, reach, corners, strict=True):
            self.rooms[triangle] = (h - self.planes[triangle][3], point)

    def _take(self, first: Triangle, point: Triple, apart: float = 0.0) -> None:
        """Add a point beyond a triangle, unless a corner next to it is hardly `apart` [N]."""
        if self._height(first, point) <= self.level:
            return
        seen, stack = {first}, [first]
        while stack:
            for a, b in _sides(stack.pop()):
                other = self.across[b, a]
                if other not in seen and self._height(other, point) > self.level:
                    seen.add(other)
                    stack.append(other)
        rim = [(a, b) for t in seen for a, b in _sides(t) if self.across[b, a] not in seen]
        nearest = min(math.dist(self.points[a], point) for a, _ in rim)
        if len({a for a, _ in rim}) < len(rim) or nearest <= apart:
            return
        for triangle in seen:
            del self.planes[triangle]
            self.rooms.pop(triangle, None)
            for side in _sides(triangle):
                del self.across[side]
        self.points.append(point)
        for a, b in rim:
            self._add((a, b, len(self.points) - 1))

    def _height(self, triangle: Triangle, point: Triple) -> float:
        """Return how far a point is beyond a triangle [N]."""
        nx, ny, nz, distance = self.planes[triangle]
        x, y, z = point
        return nx * x + ny * y + nz * z - distance

    def _add(self, triangle: Triangle) -> None:
        """Add a triangle, counter-clockwise seen from outside."""
        corners = [self.points[i] for i in triangle]
        (ax, ay, az), (bx, by, bz), (cx, cy, cz) = corners
        ux, uy, uz, vx, vy, vz = bx - ax, by - ay, bz - az, cx - ax, cy - ay, cz - az
        nx, ny, nz = uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx
        size = math.sqrt(nx * nx + ny * ny + nz * nz) or 1.0
        nx, ny, nz = nx / size, ny / size, nz / size
        self.planes[triangle] = (nx, ny, nz, max(nx * x + ny * y + nz * z for x, y, z in corners))
        self.across.update((side, triangle) for side in _sides(triangle))

    def mesh(self, level: float) -> Mesh:
        """Return the hull; triangles in one plane, up to a `level`, as one face."""
        points = np.array(self.points)
        listed = sorted(self.planes)
        a, b, c = points[np.array(listed)].transpose(1, 0, 2)
        areas = np.linalg.norm(np.cross(b - a, c - a), axis=1)
        left = dict.fromkeys(listed[i] for i in np.argsort(-areas, kind="stable").tolist())
        faces, normals, offsets = [], [], []
        gap = max(room for room, _ in self.rooms.values())
        while left:
            first = next(iter(left))
            *normal, distance = self.planes[first]
            same, stack = {first}, [first]
            del left[first]
            while stack:
                for side in _sides(stack.pop()):
                    other = self.across[side[::-1]]
                    off = np.abs(points[list(other)] @ normal - distance).max()
                    if other in left and off <= level:
                        del left[other]
                        same.add(other)
                        stack.append(other)
            rim = dict(s for t in same for s in _sides(t) if self.across[s[::-1]] not in same)
            faces.append(_ring(rim))
            normals.append(normal)
            offsets.append(distance + self.rooms[first][0])
        kept = sorted({i for face in faces for i in face})
        number = {old: new for new, old in enumerate(kept)}
        renamed = tuple(tuple(number[i] for i in face) for face in faces)
        return Mesh(points[kept], renamed, np.array(normals), np.array(offsets), max(gap, 0.0))


def _four_corners(corner: Farthest) -> list[Array]:
    """Return four points of a set that span it: the farthest along a line, a side and a height."""
    ways = np.concatenate([np.eye(3), -np.eye(3)])
    ends = corner(ways)
    widths = np.linalg.norm(ends[:3] - ends[3:], axis=1)
    axis = int(widths.argmax())
    a, b = ends[axis + 3], ends[axis]
    found = [a, b]
    for _ in range(2):
        basis = np.linalg.qr(np.column_stack([*(p - a for p in found[1:]), np.eye(3)]))[0]
        across = basis[:, len(found) - 1 : 3].T
        trials = np.concatenate([across, -across])
        ends = corner(trials)
        heights = np.abs((ends - a) @ across.T)
        row, _ = np.unravel_index(int(heights.argmax()), heights.shape)
        found.append(ends[row])
    return found


def _triple(point: Array) -> Triple:
    """Return a point (3,) as plain numbers."""
    x, y, z = point.tolist()
    return x, y, z


def _sides(triangle: Triangle) -> tuple[Side, Side, Side]:
    """Return the sides of a triangle, counter-clockwise."""
    a, b, c = triangle
    return (a, b), (b, c), (c, a)


def _ring(rim: dict[int, int]) -> tuple[int, ...]:
    """Return the corners of a polygon in order, from the one that follows each."""
    start = min(rim)
    ring, at = [start], rim[start]
    while at != start and len(ring) <= len(rim):
        ring.append(at)
        at = rim[at]
    return tuple(ring)
