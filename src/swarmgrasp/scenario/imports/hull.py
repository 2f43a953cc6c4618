"""What an imported outline is: its corners, its unit, and what was assumed of it."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

Point = tuple[float, float]
Axis = Literal["x", "y"]
SAME = 1e-9
"""Distance of two points, relative to the whole, that is none."""
OBLIQUE = math.radians(80.0)
"""Angle between a centreline and a side below which they meet in a pointed bow or stern."""
MOST_CORNERS = 20_000
"""Of an outline."""


@dataclass(frozen=True)
class Hull:
    """Corners of an outline as a file has them.

    Attributes
    ----------
    points : list of (float, float)
        In order, either way round, the first not repeated.
    unit : str
        Of length; "" for that of the scenario.
    is_closed : bool
        Whether the file says that the last corner is joined to the first.
    said : tuple of str
        What was assumed of it, sentences.
    lines : tuple of int
        Where each corner stands; none at all where a file has no lines.
    bow : str
        The axis along which a mirrored half is pointed, such as "+y"; "" if nothing is known.
    """

    points: list[Point]
    unit: str = ""
    is_closed: bool = True
    said: tuple[str, ...] = ()
    lines: tuple[int, ...] = field(default=(), repr=False)
    bow: str = ""

    def with_word(self, sentence: str) -> "Hull":
        """Return the same with one assumption more."""
        return replace(self, said=(*self.said, sentence))


def opened(points: Sequence[Point]) -> tuple[list[Point], bool]:
    """Return corners without the repetition of the first at the end, and whether there was one.

    Examples
    --------
    >>> opened([(0, 0), (1, 0), (1, 1), (0, 0)])
    ([(0, 0), (1, 0), (1, 1)], True)
    """
    is_ring = len(points) > 1 and _near(points[0], points[-1], _size(points))
    return list(points[:-1] if is_ring else points), is_ring


def centreline(points: Sequence[Point]) -> Axis | None:
    """Return the axis that a half hull is one side of: both its ends on it, and no other point.

    Examples
    --------
    >>> centreline([(0, 10), (2, 8), (2, 0)]), centreline([(0, 10), (2, 8), (2, 1), (0, 0)])
    (None, 'y')
    """
    if len(points) < 3:
        return None
    size = _size(points)
    for across, axis in ((0, "x"), (1, "y")):
        on = 1 - across  # points of the x axis have no y
        if all(abs(end[on]) <= SAME * size for end in (points[0], points[-1])):
            sides = {math.copysign(1.0, p[on]) for p in points[1:-1] if abs(p[on]) > SAME * size}
            if len(sides) == 1 and not _near(points[0], points[-1], size):
                return "x" if axis == "x" else "y"
    return None


def looks_halved(points: Sequence[Point]) -> Axis | None:
    """Return the centreline of what is one half of a hull by all it shows; None if it may be whole.

    Its ends lie on an axis and all else on one side of it, it is narrower than half its length, and
    it has four corners or more, of which an end is pointed: a rectangle or a triangle may be whole.

    Examples
    --------
    >>> looks_halved([(0, 0), (60, 0), (60, 20), (0, 20)])
    >>> looks_halved([(40, 0), (30, 5), (-40, 5), (-40, 0)])
    'x'
    """
    axis = centreline(points)
    if axis is None or len(points) < 4:
        return None
    along = 0 if axis == "x" else 1
    length = abs(points[0][along] - points[-1][along])
    spread = [max(p[k] for p in points) - min(p[k] for p in points) for k in (0, 1)]
    turns = [_slant(points[0], points[1], along), _slant(points[-1], points[-2], along)]
    is_whole = length < (1.0 - SAME) * spread[along] or spread[1 - along] > 0.5 * length
    return axis if not is_whole and SAME < min(turns) < OBLIQUE else None


def pointed_along(points: Sequence[Point], axis: Axis) -> str:
    """Return the way along its centreline in which a half hull is more pointed.

    Examples
    --------
    >>> pointed_along([(40, 0), (30, 5), (-40, 5), (-40, 0)], "x")
    '+x'
    """
    along = 0 if axis == "x" else 1
    turns = [_slant(points[0], points[1], along), _slant(points[-1], points[-2], along)]
    first, last = (points[0], points[-1]) if turns[0] <= turns[1] else (points[-1], points[0])
    return f"{'+' if first[along] > last[along] else '-'}{axis}"


def mirrored(points: Sequence[Point], axis: Axis) -> list[Point]:
    """Return a half hull with its other half.

    Examples
    --------
    >>> mirrored([(4, 0), (3, 1), (0, 1), (0, 0)], "x")
    [(4, 0), (3, 1), (0, 1), (0, 0), (0, -1), (3, -1)]
    """
    size = _size(points)
    on = 1 if axis == "x" else 0
    others = [p for p in reversed(points) if abs(p[on]) > SAME * size]
    return [*points, *((p[0], -p[1]) if axis == "x" else (-p[0], p[1]) for p in others)]


def _slant(end: Point, following: Point, along: int) -> float:
    """Return the angle [rad] between a centreline and the side that leaves it at an end."""
    steps = (abs(following[k] - end[k]) for k in (1 - along, along))
    return math.atan2(*steps)


def _size(points: Sequence[Point]) -> float:
    """Return the size of the box around points."""
    spans = (max(p[k] for p in points) - min(p[k] for p in points) for k in (0, 1))
    return math.hypot(*spans)


def _near(one: Point, other: Point, size: float) -> bool:
    """Tell whether two points are the same."""
    return math.dist(one, other) <= SAME * size
