"""Parts of the boundary, one for each group, nowhere nearer to each other than the spacing."""

from dataclasses import dataclass
from itertools import combinations, pairwise

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import AgentInvalid
from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.ranges import is_whole, shown

WIDER = 1.25
"""By what factor the gaps between parts are widened until they are wide enough."""
MOST_GROUPS = 1000

Array = NDArray[np.float64]


@dataclass(frozen=True)
class Parts:
    """The parts of a boundary, in order from its first vertex.

    Attributes
    ----------
    outline : Outline
    each : tuple of Stretch
    gaps : tuple of Stretch
        What lies between them.
    """

    outline: Outline
    each: tuple[Stretch, ...]
    gaps: tuple[Stretch, ...]

    @classmethod
    def of(cls, outline: Outline, groups: int, spacing: float) -> "Parts":
        """Cut a boundary into equal parts with gaps between them.

        Parameters
        ----------
        outline : Outline
        groups : int
            From 2 to 1000.
        spacing : float [m]
            Robots of two groups are never nearer to each other.

        Raises
        ------
        AgentInvalid
            If there are too few or too many, or no gap keeps them apart.

        Examples
        --------
        Around a corner the gap is wider along the boundary.

        >>> square = Outline([(0, 0), (10, 0), (10, 10), (0, 10)])
        >>> [(s.start, s.end) for s in Parts.of(square, 2, 1.0).each]
        [(0.78125, 19.21875), (20.78125, 39.21875)]
        """
        if not is_whole(groups) or not 2 <= groups <= MOST_GROUPS:
            raise AgentInvalid(
                f"there are {shown(groups)} groups; there should be 2 to {MOST_GROUPS}"
            )
        length = outline.perimeter / groups
        half = 0.5 * spacing
        while 2.0 * half < length:
            ends = [(k * length + half, (k + 1) * length - half) for k in range(groups)]
            if _nearest(outline, ends) >= spacing - outline.tolerance:
                return cls._between(outline, ends)
            half *= WIDER
        raise AgentInvalid(
            f"{groups} groups do not keep {spacing:g} m from each other; have fewer of them, or a "
            "smaller spacing"
        )

    @classmethod
    def _between(cls, outline: Outline, ends: list[tuple[float, float]]) -> "Parts":
        """Return parts with these ends, and what lies between them."""
        each = tuple(Stretch(a, b, f"group {k}") for k, (a, b) in enumerate(ends))
        around = [*each, each[0]]
        gaps = tuple(Stretch(one.end, two.start) for one, two in pairwise(around))
        return cls(outline, each, tuple(gap for gap in gaps if not gap.is_point))

    def __len__(self) -> int:
        """Return the number of groups."""
        return len(self.each)

    def at(self, point: tuple[float, float]) -> int:
        """Return the group whose part is nearest to a point [m, m], along the boundary."""
        _, (arc,) = self.outline.nearest(point)
        return min(int(float(arc) / self.outline.perimeter * len(self)), len(self) - 1)

    def others(self, groups: set[int]) -> tuple[Stretch, ...]:
        """Return the whole boundary but for the parts of some groups."""
        left_out = (part for k, part in enumerate(self.each) if k not in groups)
        return (*self.gaps, *left_out)


def _nearest(outline: Outline, ends: list[tuple[float, float]]) -> float:
    """Return the least distance of two stretches of the boundary [m].

    They do not cross, so that it is one from a corner or an end.
    """
    lines = [_line(outline, a, b) for a, b in ends]
    return min(min(_distance(p, q), _distance(q, p)) for p, q in combinations(lines, 2))


def _line(outline: Outline, start: float, end: float) -> Array:
    """Return the corners of a stretch, its ends among them: (m, 2) [m, m]."""
    corners = outline.corner_arc_lengths[:-1]
    within = outline.vertices[(corners > start) & (corners < end)]
    ends = [outline.at_arc_length(arc).point for arc in (start, end)]
    return np.vstack([ends[:1], within, ends[1:]])


def _distance(points: Array, line: Array) -> float:
    """Return the least distance of points (n, 2) from a polygonal line (m, 2) [m]."""
    start, step = line[:-1], np.diff(line, axis=0)
    off = points[:, None] - start
    along = np.einsum("nmi,mi->nm", off, step) / np.maximum((step**2).sum(axis=1), 1e-300)
    beside = off - np.clip(along, 0.0, 1.0)[:, :, None] * step
    return float(np.sqrt((beside**2).sum(axis=2)).min())
