"""Fig. 8 and Fig. 9 in kind: the quality along a line of wrenches is quasi-concave (T5)."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.pages.statements import Statement
from swarmgrasp.paper.cylinder import Cylinder
from swarmgrasp.paper.draws import Task, generator, problem
from swarmgrasp.paper.relaxed import relaxed_optimum
from swarmgrasp.quality import qualities
from swarmgrasp.quality.weakest import weakest_of

Array = NDArray[np.float64]

ROBOTS = 15
STEPS = 201
"""Wrenches along the line."""
DRAWS, LINES = 3, 10
"""Swarms looked at, and lines through the optimum of each."""
LEVEL = 0.6
"""Of the height of the line's summit, that its level set is drawn at."""
BRACKETS = 4, 12
"""Facets that a picture should show, at least and at most."""
HALF = 1.5
"""Half of a line's length, in half widths of the cylinder."""
GRID = 81
"""Wrenches along each side of the plane."""
ROUNDING = 1e-9
"""What a quality may be below the lower end of its segment [N]."""
PURPOSE = 7
"""Sets these random numbers apart from those of the draws."""


@dataclass(frozen=True, eq=False)
class Section:
    """A line of wrenches that a newcomer might add, and a plane through it.

    Attributes
    ----------
    along : (s,)
        From 0 to 1 along the line.
    quality : (s,) [N]
        With each wrench.
    brackets : (m, s) [N]
        h(n) + max(0, n . b) for each direction that is weakest somewhere on the line.
    across : (g,)
        From 0 to 1 along the plane's other side.
    plane : (s', g) [N]
        The quality over the plane; its middle row is the line.
    """

    along: Array
    quality: Array
    brackets: Array
    across: Array
    plane: Array

    @property
    def level(self) -> float:
        """A level between the lowest and the highest quality on the line [N]."""
        low, high = float(self.quality.min()), float(self.quality.max())
        return low + LEVEL * (high - low)

    @property
    def reached(self) -> NDArray[np.bool_]:
        """(s,): where on the line that level is reached."""
        return self.quality >= self.level


def section(seed: int) -> Section:
    """Cut through the wrenches a newcomer might add to 15 robots.

    Of some random lines through the optimum over the cylinder, the one with the clearest summit
    among those on which a few facets are weakest.
    """
    lines = [line for k in range(DRAWS) for line in _lines((seed, ROBOTS, k))]
    line = max(lines, key=_clearness)
    rng, cylinder, middle = generator((seed, ROBOTS, 0), PURPOSE), line.cylinder, line.middle
    side = _unit(np.cross(line.way, rng.normal(size=3)))
    base = cylinder.base
    heights = np.maximum(line.normals @ base.T, 0.0).sum(axis=1)
    u = np.linspace(-HALF, HALF, GRID)
    plane = middle + u[:, None, None] * line.way + u[None, :, None] * side
    return Section(
        np.linspace(0.0, 1.0, STEPS),
        line.quality,
        heights[:, None] + np.maximum(line.normals @ line.wrenches.T, 0.0),
        np.linspace(0.0, 1.0, GRID),
        _with_each(base, plane.reshape(-1, 3) * cylinder.size).reshape(GRID, GRID),
    )


class _Line(NamedTuple):
    """A line of wrenches (s, 3) [N], the qualities on it, and the directions weakest there."""

    cylinder: Cylinder
    middle: Array
    way: Array
    wrenches: Array
    quality: Array
    normals: Array


def _lines(task: Task) -> list[_Line]:
    """Return random lines through the optimum over a draw's cylinder."""
    cylinder, rng = Cylinder(problem(task)), generator(task, PURPOSE)
    middle = relaxed_optimum(cylinder.problem).wrench / cylinder.wrench(np.ones(3))
    return [_line(cylinder, middle, _unit(rng.normal(size=3))) for _ in range(LINES)]


def _line(cylinder: Cylinder, middle: Array, way: Array) -> _Line:
    """Follow a line both ways from a point of the unit cylinder."""
    u = np.linspace(-HALF, HALF, STEPS)
    wrenches = (middle + np.outer(u, way)) * cylinder.size
    found = [weakest_of(np.vstack([cylinder.base, b])) for b in wrenches]
    normals = _distinct(np.array([one.normal for one in found]))
    values = np.array([one.quality for one in found])
    return _Line(cylinder, middle, way, wrenches, values, normals)


def _clearness(line: _Line) -> tuple[bool, float]:
    """Return whether a line shows a few facets, and how far its summit is above its ends [N]."""
    low, high = BRACKETS
    ends = max(line.quality[0], line.quality[-1])
    return low <= len(line.normals) <= high, float(line.quality.max() - ends)


def _unit(vector: Array) -> Array:
    """Return a vector at length 1."""
    return np.asarray(vector / np.linalg.norm(vector))


def _distinct(normals: Array) -> Array:
    """Return unit normals, each once up to rounding."""
    _, first = np.unique(normals.round(6), axis=0, return_index=True)
    return normals[np.sort(first)]


def _with_each(base: Array, wrenches: Array) -> Array:
    """Compute the quality with each of many wrenches (m, 3) [N]: (m,) [N]."""
    crews = np.concatenate(
        [np.broadcast_to(base, (len(wrenches), *base.shape)), wrenches[:, None]], axis=1
    )
    return qualities(crews)


def lowest_dip(seed: int, segments: int) -> float:
    """Return how far the quality falls below the lower end of a segment, at most [N].

    Parameters
    ----------
    seed : int
    segments : int
        Drawn at random in the cylinder, with a random wrench on each.
    """
    cylinder = Cylinder(problem((seed, ROBOTS, 0)))
    rng = generator((seed, ROBOTS, 1), PURPOSE)
    first, last = (rng.uniform(-1.0, 1.0, (segments, 3)) * cylinder.size for _ in range(2))
    share = rng.random((segments, 1))
    ends = np.minimum(_with_each(cylinder.base, first), _with_each(cylinder.base, last))
    between = _with_each(cylinder.base, first + share * (last - first))
    return float((ends - between).max())


def statements(found: Section, seed: int, segments: int) -> list[Statement]:
    """State that the picture shows what is true, and that it is true in general."""
    apart = float(np.abs(found.brackets.min(axis=0) - found.quality).max())
    dip = lowest_dip(seed, segments)
    return [
        Statement(
            f"The quality along the line is the least of the {len(found.brackets)} brackets drawn, "
            "each of which rises or falls one way only and is flat elsewhere. What reaches a level "
            "is one interval.",
            apart <= ROUNDING
            and all(_one_way(row) for row in found.brackets)
            and int(np.abs(np.diff(found.reached.astype(int))).sum()) <= 2,
            rests_on=("T5",),
        ),
        Statement(
            f"On none of {segments} random segments is the quality between the ends below that at "
            "the lower end: the superlevel sets are convex.",
            dip <= ROUNDING,
            rests_on=("T5",),
        ),
    ]


def _one_way(row: Array) -> bool:
    """Tell whether values only rise or only fall."""
    steps = np.diff(row)
    return bool((steps >= -ROUNDING).all() or (steps <= ROUNDING).all())
