"""Find the places on the outline that robots, zones and no-go stretches name.

Everything here is in the file's own units, so that messages speak the file's language.
"""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np

from swarmgrasp.outline import Contact, Outline, Stretch
from swarmgrasp.ranges import nearest_name
from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.schema import RobotSection, StretchSection, ZoneSection
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.scenario.ways import POINT_KEYS
from swarmgrasp.words import trimmed


@dataclass(frozen=True)
class Place:
    """A point on the boundary.

    Attributes
    ----------
    point : tuple of float [file units]
    arc_length : float [file units]
        Zero for a mounted robot, which is not on the boundary.
    inward : float or None [rad]
        Direction of the inward normal; None at a corner named without its edge.
    """

    point: tuple[float, float]
    arc_length: float
    inward: float | None


@dataclass(frozen=True, eq=False)
class Locator:
    """An outline in the file's units, and the document that refers to it.

    Attributes
    ----------
    outline : Outline [file units]
        With a name for every edge, "edge i" for the nameless ones, i counted as in the file.
    si : Outline
        The same outline in metres.
    labels : list of str
        The edges' names in the order of the file.
    unit : str
        What messages call the file's unit of length.
    units : Units
    checked : Checked
    """

    outline: Outline
    si: Outline
    labels: list[str]
    unit: str
    units: Units
    checked: Checked

    # -- points -----------------------------------------------------------------------

    def place(self, section: RobotSection | ZoneSection, path: Path) -> Place | None:
        """Find the point a robot or a zone names by contact, theta, at, or edge and along.

        Returns None after noting a fault, or where the schema has already found one.
        """
        if not all(self.checked.is_sound(*path, key) for key in (*POINT_KEYS, "along")):
            return None
        if section.edge is not None:
            return self._on_edge(section.edge, section.along, path)
        if section.at is not None:
            return self._at(section.at, (*path, "at"))
        if section.theta is not None:
            return self._at_angle(section.theta, (*path, "theta"))
        if section.contact is not None:
            return self._at_point(section.contact, (*path, "contact"))
        return None

    def inside(self, wanted: list[float], path: Path) -> Place | None:
        """Return the point [x, y] of a mounted robot or of an area; None after noting a fault."""
        if self.outline.contains(wanted):
            return Place((wanted[0], wanted[1]), 0.0, None)
        what = "an area" if path[0] == "zones" else "a mounted robot"
        self.checked.fault(path, f"{what} should be inside; {self._off(wanted)}")
        return None

    def _at_point(self, wanted: list[float], path: Path) -> Place | None:
        """Find the boundary point at [x, y]."""
        (distance,), (arc,) = self.outline.nearest(wanted)
        if distance > self.outline.tolerance:
            self.checked.fault(path, f"is off the boundary; {self._off(wanted)}")
            return None
        arc = min(float(arc), self.outline.perimeter)
        return self._placed(self.outline.at_arc_length(arc), (wanted[0], wanted[1]))

    def _off(self, wanted: list[float]) -> str:
        """Return how far a point is from the boundary."""
        (distance,), (arc,) = self.outline.nearest(wanted)
        nearest = self.outline.at_arc_length(min(float(arc), self.outline.perimeter))
        far = f"{trimmed(float(distance), 4)} {self.unit}"
        return f"the nearest boundary point is {self._shown(nearest)}, {far} away"

    def _at(self, arc_length: float, path: Path) -> Place | None:
        """Find the boundary point at an arc length."""
        if not self._is_arc_length(arc_length, path):
            return None
        arc = min(arc_length, self.outline.perimeter)
        contact = self.outline.at_arc_length(arc)
        place = self._placed(contact)
        return place if contact.is_corner else replace(place, arc_length=arc)

    def _at_angle(self, theta: float, path: Path) -> Place | None:
        """Find the boundary point on the ray from the origin at an angle."""
        if not (
            self.checked.is_sound("units", "angle") and self.checked.is_sound("outline", "origin")
        ):
            return None
        contacts = self.outline.ray_contacts(self.units.radians(theta))
        if len(contacts) == 1:
            return self._placed(contacts[0])
        where = "; ".join(self._shown(c) for c in contacts[:4])
        meets = f"{len(contacts)} times, at {where}" if contacts else "nowhere"
        said = f"the ray from the origin meets the boundary {meets}; use contact, at or edge"
        self.checked.fault(path, said)
        return None

    def _on_edge(self, edge: int | str, along: float | None, path: Path) -> Place | None:
        """Find the point at a distance along an edge; its normal is the edge's own."""
        index = self.edge(edge, (*path, "edge"))
        if index is None or along is None:
            return None
        if not self._is_on_edge(along, index, (*path, "along")):
            return None
        length = float(self.outline.lengths[index])
        start, end = self.outline.edge_ends(index)
        x, y = start + (end - start) * min(along / length, 1.0)
        arc = float(self.outline.corner_arc_lengths[index]) + min(along, length)
        return Place((float(x), float(y)), arc, self.outline.inward_normal(index))

    def _placed(self, contact: Contact, point: tuple[float, float] | None = None) -> Place:
        """Return a contact as a place, its normal left open at a corner."""
        inward = None if contact.is_corner else contact.inward
        return Place(point or contact.point, contact.arc_length, inward)

    def _shown(self, contact: Contact) -> str:
        """Return a contact as messages show it."""
        x, y = contact.point
        where = self.outline.edge_label(contact.edge)
        return f"[{x:.7g}, {y:.7g}] {self.unit} on {where}"

    # -- stretches --------------------------------------------------------------------

    def stretch(self, section: StretchSection, path: Path, no_length: str) -> Stretch | None:
        """Find the stretch [m] a section names by its edge, or by from and to.

        Returns None after noting a fault, `no_length` for a stretch that has none, or where
        the schema has already found one.
        """
        if not all(self.checked.is_sound(*path, key) for key in ("edge", "from", "to")):
            return None
        if section.edge is not None:
            return self._edge_stretch(section.edge, section, path, no_length)
        start, end = section.start or 0.0, section.end or 0.0
        inside = [
            self._is_arc_length(start, (*path, "from")),
            self._is_arc_length(end, (*path, "to")),
        ]
        first, last = self._ours(start, end)
        if not all(inside) or self._is_empty(first, last, path, no_length):
            return None
        return self._stretch(first, last, section.name)

    def _edge_stretch(
        self, edge: int | str, section: StretchSection, path: Path, no_length: str
    ) -> Stretch | None:
        """Find a stretch [m] of one edge."""
        index = self.edge(edge, (*path, "edge"))
        if index is None:
            return None
        length = float(self.outline.lengths[index])
        ends = {"from": section.start or 0.0, "to": length if section.end is None else section.end}
        inside = [self._is_on_edge(ends[key], index, (*path, key)) for key in ends]
        base = float(self.outline.corner_arc_lengths[index])
        first, last = self._ours(*(base + distance for distance in ends.values()))
        if not all(inside) or self._is_empty(first, last, path, no_length):
            return None
        return self._stretch(first, last, section.name or self.outline.edge_label(index))

    def _ours(self, start: float, end: float) -> tuple[float, float]:
        """Return the ends of a stretch [file units] as counter-clockwise arc lengths [m]."""
        first, last = self.metres(start), self.metres(end)
        return (last, first) if self.units.frame.mirrored else (first, last)

    def _stretch(self, first: float, last: float, name: str) -> Stretch:
        """Return a stretch between arc lengths [m]."""
        # the first vertex is both 0 and the perimeter: 0 as a start, the perimeter as an end
        first = 0.0 if first == self.si.perimeter else first
        return Stretch(first, self.si.perimeter if last == 0.0 else last, name)

    def _is_empty(self, start: float, end: float, path: Path, said: str) -> bool:
        """Note a fault if a stretch [m, m] has no length."""
        # from the perimeter to 0 is from the first vertex to itself
        apart = min(abs(end - start), self.si.perimeter + end - start)
        if apart > self.si.tolerance:
            return False
        key = "to" if self.checked.has(*path, "to") else "from"
        self.checked.fault((*path, key), said)
        return True

    def _is_on_edge(self, distance: float, index: int, path: Path) -> bool:
        """Tell whether a distance is within an edge; note a fault otherwise."""
        length = float(self.outline.lengths[index])
        if distance <= length + self.outline.tolerance:
            return True
        said = (
            f"should lie in [0, {length:.9g}] {self.unit}, the length of "
            f"{self.outline.edge_label(index)}"
        )
        self.checked.fault(path, said)
        return False

    def _is_arc_length(self, value: float, path: Path) -> bool:
        """Tell whether an arc length is on the boundary; note a fault otherwise."""
        if value <= self.outline.perimeter + self.outline.tolerance:
            return True
        said = (
            f"should lie in [0, {self.outline.perimeter:.9g}] {self.unit}, the length of "
            "the boundary"
        )
        self.checked.fault(path, said)
        return False

    # -- edges ------------------------------------------------------------------------

    def edge(self, edge: int | str, path: Path) -> int | None:
        """Return the outline's index of an edge named, or counted, as in the file."""
        count = len(self.labels)
        if isinstance(edge, str) and not self._has_names():
            return None
        label = self.labels[edge] if isinstance(edge, int) and edge < count else edge
        if label in self._edges:
            return self._edges[label]
        known = "" if isinstance(edge, int) else nearest_name(edge, self.labels)
        said = f"there is no such edge; they run from 0 to {count - 1}{known}"
        self.checked.fault(path, said)
        return None

    @cached_property
    def _edges(self) -> dict[int | str, int]:
        """The outline's index of each edge by its label."""
        return {label: index for index, label in enumerate(self.outline.edge_names)}

    def _has_names(self) -> bool:
        """Tell whether the file's names of edges are one per edge; if not, that is noted."""
        written = self.checked.file.outline.edges
        sound = self.checked.is_sound("outline", "edges")
        return sound and (written is None or len(written) == len(self.labels))

    def metres(self, arc_length: float) -> float:
        """Convert an arc length to ours, in metres; one at a corner lands on it exactly."""
        arc = self.units.metres(arc_length)
        if self.units.frame.mirrored:
            arc = self.si.perimeter - arc if arc else 0.0  # the first vertex stays at 0
        corners = self.si.corner_arc_lengths
        exact = float(corners[np.argmin(np.abs(corners - arc))])
        return exact if abs(exact - arc) <= self.si.tolerance else min(arc, self.si.perimeter)
