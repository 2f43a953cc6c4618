"""Where robots and stretches are, in the way that a file says it: by edge, arc length or [x, y]."""

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.scenario.file_keys import FileKeys
from swarmgrasp.scenario.splice import Part
from swarmgrasp.swarm import Robot

SPOT = ("contact", "theta", "at", "edge", "along")
"""Keys that say where a point is."""
SAME = 1e-13
"""How far apart two points are that are one, relative to the outline."""

Said = dict[str, Any]
"""Keys and their values; None for a key that goes."""


class Along(NamedTuple):
    """A point on an edge: which one, and how far from its counter-clockwise start [m]."""

    edge: int
    along: float


class Spots:
    """Places on an outline, before and after it changed, as a file says them.

    Parameters
    ----------
    keys : FileKeys
    before, after : Outline
    """

    def __init__(self, keys: FileKeys, before: Outline, after: Outline) -> None:
        self._keys, self._before, self._after = keys, before, after
        self.is_moved = before != after

    def as_written(
        self, written: Part | None, corners: list[Any], names: list[str] | None
    ) -> tuple[list[Any], list[str] | None]:
        """Return corners and names of edges in the order of the file's corners."""
        if written is None or len(written.items) < 2:
            return corners, names
        second = written.items[1].plain()
        ours = self._keys.point(self._before.vertices[1].tolist())
        is_number = isinstance(second, list) and all(isinstance(x, int | float) for x in second)
        if not is_number or np.allclose(second, ours, rtol=1e-9, atol=1e-9):  # type: ignore[arg-type]
            return corners, names
        return [corners[0], *corners[:0:-1]], None if names is None else names[::-1]

    # -- robots -----------------------------------------------------------------------

    def of_robot(self, entry: Part, old: Robot, new: Robot) -> tuple[Said, int | None]:
        """Return where a robot is as an entry says it, and the edge whose normal is its own.

        No edge where none is meant: at a corner, or inside.
        """
        point = self._keys.point(new.contact)
        spot = self._on(new.contact)
        if new.mounted or spot is None:
            return self._only(contact=point), None
        own = None if entry.get("edge") is None else self._edge_of_robot(entry, old)
        if own is not None:
            here = self._along(own, new.contact)
            if here is not None:
                return {"along": self._from_start(here)}, own
        if entry.get("edge") is not None and self._after.edge_names[spot.edge]:
            name = self._after.edge_names[spot.edge]
            return self._only(edge=name, along=self._from_start(spot)), spot.edge
        is_corner = min(spot.along, float(self._after.lengths[spot.edge]) - spot.along) <= (
            self._after.tolerance
        )
        edge = None if is_corner else spot.edge
        if entry.get("at") is not None:
            arc = float(self._after.corner_arc_lengths[spot.edge]) + spot.along
            return {"at": self._arc(arc)}, edge
        is_there = old.contact == new.contact and not self.is_moved
        return ({} if is_there else self._only(contact=point)), edge

    def _edge_of_robot(self, entry: Part, old: Robot) -> int | None:
        """Return the edge, after the change, that an entry names for a robot."""
        along = entry.get("along")
        for edge in range(len(self._before)):
            here = _along(self._before, edge, old.contact)
            said = None if here is None else self._from_start(here, self._before)
            is_meant = along is None or not isinstance(along.value, float | int)
            if said is not None and (is_meant or math.isclose(
                said, along.value, rel_tol=1e-9, abs_tol=1e-9  # type: ignore[union-attr, arg-type]
            )):  # fmt: skip
                return self._now(edge)
        return None

    def _now(self, edge: int) -> int | None:
        """Return the index of an edge after the change; None if it is gone."""
        name = self._before.edge_names[edge]
        if name:
            there = self._after.edge_names
            return there.index(name) if name in there else None
        return edge if len(self._before) == len(self._after) else None

    def _on(self, point: ArrayLike) -> Along | None:
        """Return where on the boundary a point is; None if it is not exactly there."""
        found = (self._along(edge, point) for edge in range(len(self._after)))
        return next((each for each in found if each is not None), None)

    def _along(self, edge: int, point: ArrayLike) -> Along | None:
        """Return where on an edge a point is; None if it is not exactly there."""
        return _along(self._after, edge, point)

    def _from_start(self, spot: Along, outline: Outline | None = None) -> float:
        """Return how far along its edge a point is as the file counts it."""
        length = float((outline or self._after).lengths[spot.edge])
        along = length - spot.along if self._keys.units.frame.mirrored else spot.along
        return self._keys.length(min(max(along, 0.0), length))

    def _only(self, **said: Any) -> Said:
        """Return keys that say where a point is, and that the others go."""
        return {**dict.fromkeys(SPOT), **said}

    # -- stretches --------------------------------------------------------------------

    def by_arc(self, stretch: Stretch) -> Said:
        """Return where a stretch or a point is by arc length."""
        ends = [self._arc(stretch.start), self._arc(stretch.end)]
        if stretch.is_point:
            return {"at": ends[0]}
        first, last = ends[::-1] if self._keys.units.frame.mirrored else ends
        return {"from": first, "to": last}

    def of_stretch(self, entry: Part, old: Stretch, new: Stretch) -> Said:
        """Return where a stretch or a point is as an entry says it."""
        is_same = old.start == new.start and old.end == new.end
        if is_same and not self.is_moved:
            return {}
        gone = dict.fromkeys((*SPOT, "from", "to"))
        if entry.get("edge") is not None and old.is_point == new.is_point:
            edge = self._edge_of_stretch(old)
            if edge is not None:
                said = self._within(entry, edge, new)
                if said is not None:
                    return said
        if new.is_point and entry.get("contact") is not None:
            return {"contact": self._keys.point(self._after.at_arc_length(new.start).point)}
        return {**gone, **self.by_arc(new)}

    def _edge_of_stretch(self, old: Stretch) -> int | None:
        """Return the edge, after the change, that a stretch lies on."""
        slack = self._before.tolerance
        for edge, start in enumerate(self._before.corner_arc_lengths[: len(self._before)].tolist()):
            end = start + float(self._before.lengths[edge])
            if start - slack <= old.start and old.end <= end + slack and old.start <= old.end:
                return self._now(edge)
        return None

    def _within(self, entry: Part, edge: int, new: Stretch) -> Said | None:
        """Return a stretch by how far along an edge it begins and ends; None if it is not on it."""
        base, length = float(self._after.corner_arc_lengths[edge]), float(self._after.lengths[edge])
        slack = self._after.tolerance
        if new.start < base - slack or new.end > base + length + slack or new.start > new.end:
            return None
        ends = [self._from_start(Along(edge, arc - base)) for arc in (new.start, new.end)]
        if new.is_point:
            return {"along": ends[0]}
        first, last = sorted(ends)
        is_first = entry.get("from") is None and first <= self._keys.length(slack)
        is_last = entry.get("to") is None and last >= self._keys.length(length - slack)
        return {
            **({} if is_first else {"from": first}),
            **({} if is_last else {"to": last}),
        }

    def _arc(self, arc: float) -> float:
        """Return an arc length [m] as the file counts it."""
        if self._keys.units.frame.mirrored:
            arc = self._after.perimeter - arc if arc else 0.0
        return self._keys.length(arc)


def _along(outline: Outline, edge: int, point: ArrayLike) -> Along | None:
    """Return where on an edge a point is; None if it is not there but for rounding."""
    start, end = outline.edge_ends(edge)
    length = float(outline.lengths[edge])
    slack = SAME * (outline.extent + float(np.abs(outline.vertices).max()))
    step, way = np.asarray(point, dtype=float) - start, (end - start) / length
    along, aside = float(step @ way), float(way[0] * step[1] - way[1] * step[0])
    if abs(aside) > slack or not -slack <= along <= length + slack:
        return None
    return Along(edge, min(max(along, 0.0), length))
