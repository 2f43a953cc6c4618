"""The places that an answer tells apart: zones, edges, and the hills of smooth sides.

A round hull is drawn with many edges, and the edge beside the best one is no other place. So
nameless edges that follow each other smoothly make one side, which is looked at in parts, and
of its parts only those are told that are better than all others around them.
"""

import math
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import numpy as np

from swarmgrasp.outline import Outline
from swarmgrasp.placement.areas import Areas, Decks
from swarmgrasp.placement.pieces import SLIVER, Pieces

SMOOTH = math.radians(20.0)
"""Turn at a corner [rad] up to which the edges on both sides of it are one side."""
FINEST = 720
"""Parts that the sides of an outline are looked at in, about, at most."""
RISE = 0.01
"""By what share of the best quality a hill rises above the way to a higher one."""


class Parts(NamedTuple):
    """The parts of the boundary that are looked at one by one.

    Attributes
    ----------
    pieces : list of list of int
        Of each part.
    touching : list of (int, int)
        Parts next to each other on one smooth side.
    """

    pieces: list[list[int]]
    touching: list[tuple[int, int]]


def parts_of(pieces: Pieces | Areas | Decks) -> Parts:
    """Part the boundary: a zone or a named edge is one part, a smooth side has many.

    Parameters
    ----------
    pieces : Pieces, Areas or Decks
        An area is one part.
    """
    places: dict[str, list[int]] = {}
    for k, place in enumerate(pieces.places):
        places.setdefault(place, []).append(k)
    if isinstance(pieces, Areas | Decks):
        return Parts(list(places.values()), [])
    outline, plain = pieces.outline, {}
    for place, members in list(places.items()):
        edge = pieces.each[members[0]].edge
        if not outline.edge_names[edge] and place == outline.edge_label(edge):
            plain[edge] = places.pop(place)
    parts = Parts(list(places.values()), [])
    goes_on = _goes_on(pieces, plain)
    count, room = len(outline), outline.perimeter / FINEST
    starts = [edge for edge in plain if not goes_on.get((edge - 1) % count)]
    for start in starts or list(plain)[:1]:
        edge, filled, first = start, math.inf, len(parts.pieces)
        while True:
            filled += float(outline.lengths[edge])
            if filled > room:
                parts.pieces.append([])
                filled = float(outline.lengths[edge])
                if len(parts.pieces) > first + 1:
                    parts.touching.append((len(parts.pieces) - 2, len(parts.pieces) - 1))
            parts.pieces[-1] += plain[edge]
            if not goes_on[edge] or (edge + 1) % count == start:
                break
            edge = (edge + 1) % count
        if goes_on[edge] and len(parts.pieces) > first + 2:
            parts.touching.append((first, len(parts.pieces) - 1))
    return parts


def smooth_sides(outline: Outline) -> list[list[int]]:
    """Return the edges of each side: a named edge alone, nameless ones as far as they go smoothly.

    Examples
    --------
    >>> ring = [(math.cos(k), math.sin(k)) for k in np.linspace(0, 6.2, 40)]
    >>> len(smooth_sides(Outline(ring))), smooth_sides(Outline([(0, 0), (1, 0), (0, 1)]))
    (1, [[0], [1], [2]])
    """
    count, turns = len(outline), _turns(outline)
    goes_on = [
        turns[edge] <= SMOOTH and not outline.edge_names[edge]
        and not outline.edge_names[(edge + 1) % count]
        for edge in range(count)
    ]  # fmt: skip
    start = next((edge for edge in range(count) if not goes_on[edge - 1]), 0)
    sides: list[list[int]] = []
    for k in range(count):
        edge = (start + k) % count
        if k and goes_on[edge - 1]:
            sides[-1].append(edge)
        else:
            sides.append([edge])
    return sorted(sides)


def _turns(outline: Outline) -> list[float]:
    """Return by how much the boundary turns at the end of each edge [rad]."""
    along = np.roll(outline.vertices, -1, axis=0) - outline.vertices
    after = np.roll(along, -1, axis=0)
    crosses = along[:, 0] * after[:, 1] - along[:, 1] * after[:, 0]
    turns: list[float] = np.abs(np.arctan2(crosses, (along * after).sum(axis=1))).tolist()
    return turns


def _goes_on(pieces: Pieces, plain: Mapping[int, Sequence[int]]) -> dict[int, bool]:
    """Tell of nameless edges whether the allowed contacts go on smoothly on the next edge."""
    outline = pieces.outline
    turns = _turns(outline)
    sliver = SLIVER * outline.extent
    first = {edge: min(pieces.each[k].start for k in members) for edge, members in plain.items()}
    last = {edge: max(pieces.each[k].end for k in members) for edge, members in plain.items()}
    return {
        edge: turns[edge] <= SMOOTH
        and last[edge] >= float(outline.lengths[edge]) - sliver
        and first.get((edge + 1) % len(outline), math.inf) <= sliver
        for edge in plain
    }


def hills(values: Mapping[int, float], touching: Sequence[tuple[int, int]]) -> list[int]:
    """Return the parts that are tops of hills, the best first.

    A hill that rises less than `RISE` of the best value above the way to a higher one is none.

    Parameters
    ----------
    values : mapping of int to float
        The best quality on each part; parts that are left out lie lower.
    touching
        See `Parts`.

    Examples
    --------
    >>> ring = [(k, (k + 1) % 6) for k in range(6)]
    >>> hills(dict(enumerate([9.0, 4.0, 7.0, 7.0, 7.001, 3.0])), ring)
    [0, 4]
    """
    beside: dict[int, list[int]] = {part: [] for part in values}
    for one, other in touching:
        if one in values and other in values:
            beside[one].append(other)
            beside[other].append(one)
    order = sorted(values, key=lambda part: (-values[part], part))
    rise = RISE * values[order[0]] if order else 0.0
    above: dict[int, int] = {}
    merged: set[int] = set()

    def top(part: int) -> int:
        """Return the top of the hill that a part is on, and shorten the way to it."""
        while above[part] != part:
            above[part] = part = above[above[part]]
        return part

    for part in order:  # as a falling tide would bare them
        above[part] = part
        for other in beside[part]:
            if other not in above:
                continue
            low, high = sorted((top(part), top(other)), key=lambda t: (values[t], -t))
            if low != high:
                above[low] = high
                if values[low] - values[part] < rise or low == part:
                    merged.add(low)
    return [part for part in order if part not in merged]
