"""Where a newcomer may attach and where not, place by place, and what each is worth."""

from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import partial

import numpy as np

from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.placement.answer import Placement, RunnerUp
from swarmgrasp.placement.pieces import (
    SLIVER,
    Interval,
    Pieces,
    crowded_on,
    left_of,
    parts_on,
    runs_on,
)
from swarmgrasp.placement.sides import smooth_sides

Part = tuple[int, Interval]
"""A part of an edge [m, m]."""
OUTSIDE = "outside the zones"
NO_WAY = "no direction allowed"


@dataclass(frozen=True)
class Ground:
    """A zone, an edge, or several nameless edges that make one smooth side.

    Attributes
    ----------
    place : str
        The zone's name, or the edges'.
    length : float [m]
        0 for a single point; of an area, which has none, too.
    allowed : float [m]
        How much of it is left to the newcomer.
    is_allowed : bool
        Whether there is a place for it.
    excluded : tuple of (str, float [m])
        What takes how much of the rest: a no-go stretch, the spacing to a robot, zones that end.
    best : RunnerUp, optional
        The best robot there, if one there betters the swarm.
    """

    place: str
    length: float
    allowed: float
    is_allowed: bool
    excluded: tuple[tuple[str, float], ...]
    best: RunnerUp | None


def grounds(answer: Placement) -> tuple[Ground, ...]:
    """Tell all zones, and the edges outside them, or all edges where there are no zones.

    Parameters
    ----------
    answer : Placement
        With all runners-up, from 0 on.

    Examples
    --------
    >>> from swarmgrasp import place
    >>> from swarmgrasp.scenario import load_example
    >>> answer = place(load_example("deck-barge").problem(), runners_up=0.0)
    >>> first, *_ = grounds(answer)
    >>> first.place, round(first.length, 3), round(first.allowed, 3), first.excluded[0][0]
    ('starboard aft pads', 22.86, 4.572, 'spacing to Ajax')
    """
    return tuple(_Survey(answer).grounds())


class _Survey:
    """One question, looked at place by place."""

    def __init__(self, answer: Placement) -> None:
        self._problem, self._outline = answer.problem, answer.problem.swarm.outline
        self._sliver = SLIVER * self._outline.extent
        found = [RunnerUp(answer.robot, answer.quality, answer.place)] * answer.improves
        self._found = sorted([*found, *answer.runners_up], key=lambda each: -each.quality)
        places = self._problem.places()
        self._places = set(places.places)
        self._open: dict[tuple[str, int], list[Interval]] = {}
        for piece in places.each if isinstance(places, Pieces) else ():
            self._open.setdefault((piece.place, piece.edge), []).append((piece.start, piece.end))

    def grounds(self) -> Iterator[Ground]:
        """Yield zones, and sides outside them."""
        problem, outline = self._problem, self._outline
        if problem.newcomer.mounted:
            for place in sorted(self._places):
                yield Ground(place, 0.0, 0.0, True, (), self._best({place}))
            return
        for zone, label in zip(problem.zones or (), problem.zone_labels, strict=False):
            if zone.stretch is not None:
                edges = range(len(outline))
                parts = [(e, part) for e in edges for part in parts_on(outline, e, zone.stretch)]
                yield self._ground(label, {label}, parts)
        for side in smooth_sides(outline):
            whole = [(edge, (0.0, float(outline.lengths[edge]))) for edge in side]
            labels = {outline.edge_label(edge) for edge in side}
            if problem.zones is None:
                yield self._ground(side_name(outline, side), labels, whole)
            else:
                yield from self._outside(side, whole)

    def _outside(self, side: Sequence[int], whole: list[Part]) -> Iterator[Ground]:
        """Yield what no zone covers of a side, if that is more than rounding."""
        stretches = [zone.stretch for zone in self._problem.zones or () if zone.stretch is not None]
        left = _length(
            part
            for edge, interval in whole
            for part in left_of(
                interval, [p for each in stretches for p in parts_on(self._outline, edge, each)]
            )
        )
        if left > self._sliver:
            name = side_name(self._outline, side)
            if left < _length(interval for _, interval in whole) - self._sliver:
                name = f"rest of {name}"
            yield Ground(name, left, 0.0, False, ((OUTSIDE, left),), None)

    def _ground(self, place: str, labels: Collection[str], parts: list[Part]) -> Ground:
        """Return what is left of the parts of edges that a place has."""
        length, excluded = _length(interval for _, interval in parts), list[tuple[str, float]]()
        for what, taken in self._taking():
            rest = [
                (edge, each)
                for edge, interval in parts
                for each in self._cut(interval, taken(edge))
            ]
            less = _length(interval for _, interval in parts) - _length(i for _, i in rest)
            if less > self._sliver or (len(rest) < len(parts) and less == 0.0):
                excluded.append((what, less))
            parts = rest
        edges = {edge for edge, _ in parts}
        open_ = [self._open.get((label, edge), []) for label in labels for edge in edges]
        allowed = sum(_length(_joined(intervals)) for intervals in open_)
        closed = _length(interval for _, interval in parts) - allowed
        if closed > self._sliver or (parts and not any(open_)):
            excluded.append((NO_WAY, closed))
        return Ground(place, length, allowed, any(open_), tuple(excluded), self._best(labels))

    def _taking(self) -> Iterator[tuple[str, Callable[[int], list[Interval]]]]:
        """Yield what takes parts of edges from the newcomer, in turn."""
        problem, outline = self._problem, self._outline
        for stretch in problem.no_go:
            yield f"no-go {stretch.name}".rstrip(), partial(_runs, outline, stretch)
        if problem.spacing:
            for robot in problem.swarm:
                if not robot.mounted:
                    crowd = np.array([robot.contact])
                    near = partial(crowded_on, outline, crowd=crowd, spacing=problem.spacing)
                    yield f"spacing to {robot.name}", near

    def _cut(self, interval: Interval, taken: list[Interval]) -> list[Interval]:
        """Return what is left of a part of an edge, or of a single point of it."""
        start, end = interval
        if start < end:
            return [(a, b) for a, b in left_of(interval, taken) if b - a > self._sliver]
        is_taken = any(a + self._sliver < start < b - self._sliver for a, b in taken)
        return [] if is_taken else [interval]

    def _best(self, labels: Collection[str]) -> RunnerUp | None:
        """Return the best robot in some places."""
        return next((each for each in self._found if each.place in labels), None)


def side_name(outline: Outline, side: Sequence[int]) -> str:
    """Return what the edges of a side are called."""
    if len(side) == 1:
        return outline.edge_label(side[0])
    return f"edges {side[0]} to {side[-1]}"


def _runs(outline: Outline, stretch: Stretch, edge: int) -> list[Interval]:
    """Return a stretch as distances along an edge."""
    return runs_on(outline, edge, stretch)


def _joined(intervals: Iterable[Interval]) -> list[Interval]:
    """Return intervals that may overlap as ones that do not."""
    found: list[Interval] = []
    for start, end in sorted(intervals):
        if found and start <= found[-1][1]:
            found[-1] = (found[-1][0], max(end, found[-1][1]))
        else:
            found.append((start, end))
    return found


def _length(intervals: Iterable[Interval]) -> float:
    """Return the length of intervals that do not overlap [m]."""
    return sum(end - start for start, end in intervals)
