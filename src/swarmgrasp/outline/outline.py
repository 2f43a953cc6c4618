"""The object: a simple polygon, its boundary, and the contacts on it."""

import math
from bisect import bisect_right
from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import TYPE_CHECKING, Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import ContactInvalid, OutlineInvalid, ZoneInvalid, refuse
from swarmgrasp.frozen import Frozen, read_only
from swarmgrasp.outline.nearest import Edges, chords, edges_of
from swarmgrasp.outline.polygon import (
    as_point,
    centroid,
    checked_vertices,
    edge_name_faults,
    exterior,
    signed_area,
)
from swarmgrasp.outline.precision import written_precision
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import (
    angles,
    array_of,
    is_whole,
    items,
    kind_faults,
    length_faults,
    name_faults,
    number,
    shown,
)
from swarmgrasp.visible import Visible

if TYPE_CHECKING:
    from shapely import Polygon

BOUNDARY_TOLERANCE = 1e-6
"""Largest distance of a contact from the boundary, relative to the outline's extent."""


@dataclass(frozen=True)
class Contact(Plain):
    """A point on the boundary.

    Attributes
    ----------
    point : tuple of float [m, m]
        Position in the frame of the vertices.
    edge : int
        Index of the edge it lies on; at a corner, the edge that starts there.
    arc_length : float [m]
        Distance along the boundary, counter-clockwise from the first vertex.
    inward : float [rad]
        Direction of the edge's inward normal.
    is_corner : bool
        Whether the point is a vertex, where the normal is not unique.
    """

    point: tuple[float, float]
    edge: int
    arc_length: float
    inward: float
    is_corner: bool


@dataclass(frozen=True)
class Stretch(Plain):
    """A stretch of the boundary, counter-clockwise from `start` to `end`.

    Attributes
    ----------
    start, end : float [m]
        Arc lengths from the first vertex. Equal ends mean a single point, such as a
        bollard; ``end < start`` means a stretch that runs across the first vertex.
    name : str
        A label for messages and pictures.

    Raises
    ------
    ZoneInvalid
        If an end is no length, or the name no text; all faults at once.

    Examples
    --------
    >>> Stretch(10.0, 25.0, "pads"), Stretch(4.0, 4.0, "bollard").is_point
    (Stretch(start=10.0, end=25.0, name='pads'), True)
    """

    start: float
    end: float
    name: str = ""

    def __post_init__(self) -> None:
        """Check the values; whether they lie on an outline is seen where there is one."""
        faults = length_faults(self.start, "start") + length_faults(self.end, "end")
        faults += name_faults(self.name)
        if faults:
            raise ZoneInvalid(f"stretch: {fault}" for fault in faults)
        vars(self).update(start=float(self.start), end=float(self.end), name=str(self.name))

    @property
    def is_point(self) -> bool:
        """Whether the stretch is a single point."""
        return self.start == self.end


@dataclass(frozen=True, eq=False)
class Outline(Frozen, Plain, Visible):
    """A simple polygon, convex or not, with the point that moments are taken about.

    Vertices may be given in either orientation; they are kept counter-clockwise, with
    the same first vertex. Edge `i` runs from vertex `i` to vertex `i + 1`.

    Parameters
    ----------
    vertices : (k, 2) [m, m]
        Corners in order; the closing repetition of the first one is optional.
    origin : (2,) [m, m], optional
        Reference point for moments; the centroid when left out.
    edge_names : sequence of str, optional
        One name per edge in the order of the given vertices; "" for a nameless edge.
    precision : float [m], optional
        How far each coordinate may be off, 0 for exact ones. When left out, half a unit in the
        last decimal, if the coordinates have 3 to 12 of them, and else 0: see `written_precision`.

    Raises
    ------
    OutlineInvalid
        If there are fewer than 3 distinct vertices, a coordinate is not finite, the
        polygon has no area or crosses itself (the message names the crossing point), or the
        precision is negative or not finite.

    Examples
    --------
    >>> barge = Outline([(0, 0), (4, 0), (4, 2), (0, 2)], edge_names=["s", "e", "n", "w"])
    >>> barge.perimeter, barge.area, tuple(barge.origin.tolist())
    (12.0, 8.0, (2.0, 1.0))
    >>> barge.at_arc_length(5.0).point
    (4.0, 1.0)
    """

    vertices: NDArray[np.float64]
    origin: NDArray[np.float64]
    edge_names: tuple[str, ...]
    lengths: NDArray[np.float64] = field(repr=False)
    """(k,) [m]: of the edges."""
    corner_arc_lengths: NDArray[np.float64] = field(repr=False)
    """(k + 1,) [m]: where the edges begin; the last entry is the perimeter."""
    inward_normals: NDArray[np.float64] = field(repr=False)
    """(k,) [rad]: the directions of the edges' inward normals."""
    precision: float

    def __init__(
        self,
        vertices: ArrayLike,
        origin: ArrayLike | None = None,
        edge_names: Sequence[str] | None = None,
        precision: float | None = None,
    ) -> None:
        corners = checked_vertices(vertices)
        given = [""] * len(corners) if edge_names is None else items(edge_names)
        names = list(given or ())
        faults = [f"the edge names are {shown(edge_names)}; they should be a list of names"]
        if given is not None:
            faults = edge_name_faults(names, len(corners))
        if signed_area(corners) < 0.0:  # keep the first vertex first
            corners = np.roll(corners[::-1], 1, axis=0)
            names = names[::-1]
        centre = centroid(corners) if origin is None else as_point(origin)
        if not np.isfinite(centre).all():
            faults.append(f"the origin is {shown(origin)}; it should be two finite coordinates [m]")
        if precision is None:
            precision = written_precision(corners)
        else:
            faults += length_faults(precision, "precision")
        if faults:
            raise OutlineInvalid(faults)
        ends = np.roll(corners, -1, axis=0)
        lengths = np.linalg.norm(ends - corners, axis=1)
        arrays = {
            "vertices": corners,
            "origin": centre,
            "lengths": lengths,
            "corner_arc_lengths": np.concatenate([[0.0], np.cumsum(lengths)]),
            "inward_normals": np.arctan2(ends[:, 0] - corners[:, 0], corners[:, 1] - ends[:, 1]),
        }
        vars(self).update(arrays, edge_names=tuple(map(str, names)), precision=float(precision))
        self._freeze()

    @classmethod
    def from_shapely(
        cls,
        polygon: "Polygon",
        origin: ArrayLike | None = None,
        edge_names: Sequence[str] | None = None,
        precision: float | None = None,
    ) -> Self:
        """Make an outline of a polygon of shapely.

        Parameters
        ----------
        polygon : shapely.Polygon [m, m]
            One without holes.
        origin, edge_names, precision
            As for `Outline`; names in the order of the polygon's exterior.

        Raises
        ------
        OutlineInvalid
            If it is no polygon or has holes, or as for `Outline`.

        Examples
        --------
        >>> from shapely import box
        >>> Outline.from_shapely(box(0, 0, 4, 2)).to_shapely().equals(box(0, 0, 4, 2))
        True
        """
        return cls(exterior(polygon), origin, edge_names, precision)

    def to_shapely(self) -> "Polygon":
        """Return the outline as a polygon of shapely, in metres and counter-clockwise."""
        from shapely import Polygon

        return Polygon(self.vertices)

    def _repr_svg_(self) -> str:
        """Return a picture for a notebook: the outline, x to the right, and the origin."""
        low, high = self.vertices.min(axis=0), self.vertices.max(axis=0)
        width, height = (high - low).tolist()
        margin, line = 0.04 * self.extent, 0.004 * self.extent
        corners = " ".join(f"{x:.6g},{-y:.6g}" for x, y in self.vertices.tolist())
        x, y = self.origin.tolist()
        return (
            '<svg xmlns="http://www.w3.org/2000/svg" width="320" role="img" '
            f'aria-label="outline of {len(self)} edges, {width:.6g} m by {height:.6g} m" '
            f'viewBox="{low[0] - margin:.6g} {-high[1] - margin:.6g} '
            f'{width + 2.0 * margin:.6g} {height + 2.0 * margin:.6g}">'
            f'<polygon points="{corners}" fill="#eef2f5" stroke="#25323e" '
            f'stroke-width="{line:.3g}"/>'
            f'<circle cx="{x:.6g}" cy="{-y:.6g}" r="{2.0 * line:.3g}" fill="#25323e"/></svg>'
        )

    # -- measures ---------------------------------------------------------------------

    @cached_property
    def _ends(self) -> NDArray[np.float64]:
        """(k, 2) [m, m]: where the edges end."""
        return read_only(np.roll(self.vertices, -1, axis=0))

    @cached_property
    def _edges(self) -> Edges:
        """The edges as columns."""
        return edges_of(self.vertices)

    def __len__(self) -> int:
        """Return the number of edges."""
        return len(self.vertices)

    @cached_property
    def perimeter(self) -> float:
        """Length of the boundary [m]."""
        return float(self.corner_arc_lengths[-1])

    @cached_property
    def area(self) -> float:
        """Enclosed area [m^2]."""
        return float(signed_area(self.vertices))

    @cached_property
    def extent(self) -> float:
        """Diagonal of the bounding box [m], the scale of every geometric tolerance."""
        return float(np.linalg.norm(np.ptp(self.vertices, axis=0)))

    @cached_property
    def tolerance(self) -> float:
        """Distance [m] below which two boundary points count as one."""
        return BOUNDARY_TOLERANCE * self.extent

    @cached_property
    def radius(self) -> float:
        """Largest distance from the origin to the outline [m]."""
        return float(np.linalg.norm(self.vertices - self.origin, axis=1).max())

    @cached_property
    def normal_errors(self) -> NDArray[np.float64]:
        """(k,) [rad]: by how much the edges' normals may be off, by the `precision`.

        Those of edges along x or y are exact: both ends carry the same number.
        """
        steps = np.abs(self._ends - self.vertices)
        turns = 2.0 * self.precision * steps.sum(axis=1) / self.lengths**2
        errors = np.where((steps == 0.0).any(axis=1), 0.0, turns)
        errors.setflags(write=False)
        return errors

    def edge_label(self, edge: int | str) -> str:
        """Return the name of an edge, or "edge i" for a nameless one."""
        index = self.edge_index(edge)
        return self.edge_names[index] or f"edge {index}"

    def edge_ends(self, edge: int | str) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the two ends of an edge, counter-clockwise, each (2,) [m, m]."""
        index = self.edge_index(edge)
        return self.vertices[index], self._ends[index]

    def inward_normal(self, edge: int | str) -> float:
        """Return the direction [rad] of the inward normal of an edge, given by name or index.

        Raises
        ------
        ContactInvalid
            If there is no such edge.
        """
        return float(self.inward_normals[self.edge_index(edge)])

    # -- contacts ---------------------------------------------------------------------

    def nearest(self, points: ArrayLike) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Find the boundary points nearest to given points.

        Parameters
        ----------
        points : (n, 2) [m, m]

        Returns
        -------
        distances : (n,) [m]
        arc_lengths : (n,) [m]
            Of the nearest boundary points.

        Examples
        --------
        >>> square = Outline([(0, 0), (2, 0), (2, 2), (0, 2)])
        >>> [values.tolist() for values in square.nearest([(1, -3), (2.5, 1)])]
        [[3.0, 0.5], [1.0, 3.0]]
        """
        wanted = _points(points)
        distances, edges, alongs = self._edges.nearest(wanted)
        return distances, self.corner_arc_lengths[edges] + alongs

    def at_arc_length(self, arc_length: float) -> Contact:
        """Return the contact at a distance along the boundary.

        Parameters
        ----------
        arc_length : float [m]
            Counter-clockwise from the first vertex, within [0, perimeter].

        Raises
        ------
        ContactInvalid
            If the arc length is outside [0, perimeter].
        """
        if not 0.0 <= number(arc_length) <= self.perimeter:
            raise ContactInvalid(
                f"arc length {shown(arc_length)} m is outside the boundary: "
                f"it should lie in [0, {self.perimeter:.9g}] m"
            )
        reach, wanted = self._reach, float(arc_length)
        edge = min(bisect_right(reach, wanted) - 1, len(self) - 1)
        along = wanted - reach[edge]
        if reach[edge + 1] - wanted <= self.tolerance:  # a corner belongs to what follows
            edge, along = (edge + 1) % len(self), 0.0
        return self._contact(edge, 0.0 if along <= self.tolerance else along)

    @cached_property
    def _reach(self) -> list[float]:
        """The corners' arc lengths, for a quick search."""
        return list(map(float, self.corner_arc_lengths))

    @cached_property
    def _rows(self) -> list[list[float]]:
        """(x, y, dx, dy, length, inward normal) of every edge, for single contacts."""
        steps = self._ends - self.vertices
        rows: list[list[float]] = np.column_stack(
            [self.vertices, steps, self.lengths, self.inward_normals]
        ).tolist()
        return rows

    def _contact(self, edge: int, along: float) -> Contact:
        """Return the contact at a distance [m] along an edge, which it belongs to."""
        x, y, dx, dy, length, inward = self._rows[edge]
        along = float(along)
        share = along / length
        return Contact(
            point=(x + dx * share, y + dy * share),
            edge=edge,
            arc_length=self._reach[edge] + along,
            inward=inward,
            is_corner=min(along, length - along) <= self.tolerance,
        )

    def at_point(self, point: ArrayLike) -> Contact:
        """Return the contact at a boundary point.

        Raises
        ------
        ContactInvalid
            If the point is off the boundary; the message gives the nearest point on it.

        Examples
        --------
        >>> square = Outline([(0, 0), (2, 0), (2, 2), (0, 2)])
        >>> square.at_point((2, 0.5)).arc_length
        2.5
        >>> square.at_point((2, 2)).is_corner
        True
        """
        wanted = as_point(point)
        if not np.isfinite(wanted).all():
            raise ContactInvalid(
                f"the point is {shown(point)}; it should be two finite numbers [m]"
            )
        (distance,), (arc_length,) = self.nearest(wanted)
        contact = self.at_arc_length(float(arc_length))
        if not distance <= self.tolerance:
            raise ContactInvalid(self.off_boundary(point, contact, float(distance)))
        return contact

    def off_boundary(self, point: ArrayLike, nearest: Contact, distance: float) -> str:
        """Return the sentence for a point off the boundary."""
        x, y = np.asarray(point, dtype=float)
        return (
            f"({x:.9g}, {y:.9g}) m is {distance:.3g} m off the boundary: the nearest boundary "
            f"point is ({nearest.point[0]:.9g}, {nearest.point[1]:.9g}) m on "
            f"{self.edge_label(nearest.edge)}"
        )

    def at_angle(self, theta: float) -> Contact:
        """Return the contact where the ray from the origin at a polar angle meets the boundary.

        Parameters
        ----------
        theta : float [rad]
            Counter-clockwise from +x: the paper's contact coordinate.

        Raises
        ------
        ContactInvalid
            If the angle is none, or the ray meets the boundary more than once, or nowhere.
        """
        contacts = self.ray_contacts(theta)
        if len(contacts) == 1:
            return contacts[0]
        where = ", ".join(f"({c.point[0]:.6g}, {c.point[1]:.6g})" for c in contacts)
        meets = f"{len(contacts)} times, at {where}" if contacts else "nowhere"
        raise ContactInvalid(
            f"the ray from the origin ({self.origin[0]:.6g}, {self.origin[1]:.6g}) at theta = "
            f"{theta:.6g} rad meets the boundary {meets}: give the contact by point or arc length"
        )

    def ray_contacts(self, theta: float) -> tuple[Contact, ...]:
        """Return every contact on the ray from the origin at a polar angle [rad].

        Raises
        ------
        ContactInvalid
            If the angle is none.
        """
        if not angles((theta,)):
            raise ContactInvalid(
                f"theta is {shown(theta)}; it should be -1e6 <= theta <= 1e6 [rad]"
            )
        ray_x, ray_y = math.cos(theta), math.sin(theta)
        p, q = self.vertices - self.origin, self._ends - self.origin
        side_p, side_q = (ray_x * v[:, 1] - ray_y * v[:, 0] for v in (p, q))
        turn = side_p - side_q
        crosses = np.abs(turn) > 1e-15 * self.extent  # otherwise its ends belong to the neighbours
        share = np.clip(side_p / np.where(crosses, turn, 1.0), 0.0, 1.0)
        x, y = (p + share[:, None] * (q - p)).T
        touches = np.abs(ray_x * y - ray_y * x) <= self.tolerance
        hits = np.flatnonzero(crosses & touches & (ray_x * x + ray_y * y >= 0.0))
        contacts: list[Contact] = []
        for reached in self.corner_arc_lengths[hits] + share[hits] * self.lengths[hits]:
            contact = self.at_arc_length(min(float(reached), self.perimeter))
            if all(math.dist(contact.point, c.point) > self.tolerance for c in contacts):
                contacts.append(contact)
        return tuple(contacts)

    def edge_index(self, edge: int | str) -> int:
        """Return the index of an edge given by name or index.

        Raises
        ------
        ContactInvalid
            If there is no such edge.
        """
        if isinstance(edge, str):
            if edge and edge in self.edge_names:
                return self.edge_names.index(edge)
            known = ", ".join(repr(n) for n in self.edge_names if n) or "none is named"
            raise ContactInvalid(f"there is no edge named {shown(edge)}; the named edges: {known}")
        if is_whole(edge) and 0 <= edge < len(self):
            return int(edge)
        raise ContactInvalid(f"there is no edge {shown(edge)}; edges run from 0 to {len(self) - 1}")

    def on_edge(self, edge: int | str, along: float) -> Contact:
        """Return the contact at a distance along an edge, with that edge's normal.

        Parameters
        ----------
        edge : int or str
        along : float [m]
            From the edge's counter-clockwise start, within [0, its length].

        Raises
        ------
        ContactInvalid
            If there is no such edge, or the distance is beyond its ends.

        Examples
        --------
        >>> barge = Outline([(0, 0), (4, 0), (4, 2), (0, 2)], edge_names=["s", "e", "n", "w"])
        >>> barge.on_edge("e", 0.5).point
        (4.0, 0.5)
        """
        index = self.edge_index(edge)
        length = float(self.lengths[index])
        if not -self.tolerance <= number(along) <= length + self.tolerance:
            raise ContactInvalid(
                f"{shown(along)} m along {self.edge_label(index)} is beyond its ends: it should "
                f"lie in [0, {length:.9g}] m"
            )
        return self._contact(index, min(max(along, 0.0), length))

    def stretch(
        self, edge: int | str, start: float = 0.0, end: float | None = None, name: str = ""
    ) -> Stretch:
        """Return a stretch of one edge.

        Parameters
        ----------
        edge : int or str
        start, end : float [m]
            Distances from the edge's counter-clockwise start; the whole edge by default.
        name : str
            A label; the edge's own by default.

        Raises
        ------
        ContactInvalid
            If there is no such edge.
        ZoneInvalid
            If the distances are not ordered within [0, the edge's length].

        Examples
        --------
        >>> square = Outline([(0, 0), (2, 0), (2, 2), (0, 2)], edge_names=["s", "e", "n", "w"])
        >>> square.stretch("e", 0.5, 1.5)
        Stretch(start=2.5, end=3.5, name='e')
        """
        index = self.edge_index(edge)
        length = float(self.lengths[index])
        stop = length if end is None else end
        if not 0.0 <= number(start) <= number(stop) <= length + self.tolerance:
            raise ZoneInvalid(
                f"{shown(start)} to {shown(stop)} m does not lie on {self.edge_label(index)}: it "
                f"should be 0 <= from <= to <= {length:.9g} m"
            )
        is_empty = isinstance(name, str) and not name
        base = float(self.corner_arc_lengths[index])
        first, last = base + min(start, length), base + min(stop, length)
        return Stretch(first, last, self.edge_label(index) if is_empty else name)

    def stretches_near(
        self, points: ArrayLike, distance: float, name: str = ""
    ) -> tuple[Stretch, ...]:
        """Return the stretches of the boundary that are nearer to points than a distance.

        Parameters
        ----------
        points : (2,) or (n, 2) [m, m]
        distance : float [m]
        name : str
            What the stretches are called.

        Returns
        -------
        tuple of Stretch
            Those of each point, one point after the other.

        Raises
        ------
        ContactInvalid
            If a point is not two finite numbers.
        ZoneInvalid
            If the distance is not a finite length >= 0.

        Examples
        --------
        >>> square = Outline([(0, 0), (2, 0), (2, 2), (0, 2)])
        >>> square.stretches_near((2, 0), 0.5)
        (Stretch(start=1.5, end=2.5, name=''),)
        """
        given, faults = array_of(points), length_faults(distance, "distance")
        if given is not None and not np.isfinite(given).all():
            raise ContactInvalid(f"the points are {shown(points)}; they should be finite [m, m]")
        wanted = _points(points)
        if faults:
            raise ZoneInvalid(faults)
        return tuple(
            Stretch(start, end, name)
            for point in wanted
            for start, end in self._runs_near(point, distance)
        )

    def _runs_near(self, point: NDArray[np.float64], distance: float) -> list[tuple[float, float]]:
        """Return what is nearer to a point than a distance, from and to as arc lengths [m]."""
        units = (self._ends - self.vertices) / self.lengths[:, None]
        edges, first, last = chords(self.vertices, units, point, distance)
        starts = self.corner_arc_lengths[edges] + np.maximum(first, 0.0)
        ends = self.corner_arc_lengths[edges] + np.minimum(last, self.lengths[edges])
        runs: list[tuple[float, float]] = []
        for start, end in zip(
            starts.tolist(), np.minimum(ends, self.perimeter).tolist(), strict=True
        ):
            if start < end and runs and start - runs[-1][1] <= self.tolerance:
                runs[-1] = runs[-1][0], end
            elif start < end:
                runs.append((start, end))
        if len(runs) > 1 and runs[0][0] == 0.0 and runs[-1][1] == self.perimeter:
            runs = [*runs[1:-1], (runs[-1][0], runs[0][1])]  # one across the first vertex
        return runs

    def contains(self, point: ArrayLike) -> bool:
        """Tell whether a point is inside the outline or on its boundary.

        Examples
        --------
        >>> square = Outline([(0, 0), (2, 0), (2, 2), (0, 2)])
        >>> square.contains((1, 1)), square.contains((2, 1)), square.contains((3, 1))
        (True, True, False)
        """
        return bool(self.contains_each(as_point(point))[0])

    def contains_each(self, points: ArrayLike) -> NDArray[np.bool_]:
        """Do the same for many points, (n, 2) [m, m]; return (n,) bool."""
        wanted = _points(points)
        on_boundary = self.nearest(wanted)[0] <= self.tolerance
        return on_boundary | self._edges.enclose(wanted)


def check_outline(outline: object) -> None:
    """Raise `OutlineInvalid` unless something is an outline."""
    refuse((OutlineInvalid, kind_faults(outline, Outline, "Outline(vertices)")))


def _points(points: ArrayLike) -> NDArray[np.float64]:
    """Return points as an array (n, 2) [m, m]."""
    wanted = array_of(points)
    if wanted is not None and (wanted.size == 0 or wanted.shape == (2,)):
        wanted = wanted.reshape(-1, 2)
    if wanted is None or wanted.ndim != 2 or wanted.shape[1] != 2 or np.isnan(wanted).any():
        raise ContactInvalid(
            f"the points are {shown(points)}; they should be numbers (n, 2) [m, m]"
        )
    return wanted
