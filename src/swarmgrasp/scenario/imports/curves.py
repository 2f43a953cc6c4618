"""Curves as chords: how many are enough for a tolerance."""

import cmath
import math
from collections.abc import Callable

from swarmgrasp.scenario.imports.hull import Point

MOST_CHORDS = 5_000
"""Of one curve."""
FINE = 1e-4
"""How far chords are off a curve at most, relative to the drawing's extent, unless told."""


def chords_for(bend: float, tolerance: float) -> int:
    """Return how many chords, even in the parameter from 0 to 1, stay within a tolerance.

    A curve whose second derivative is at most `bend` is off a chord over a step h by at most
    bend h^2 / 8.

    Examples
    --------
    >>> chords_for(8.0, 0.01), chords_for(0.0, 0.01)
    (10, 1)
    """
    return min(max(1, math.ceil(math.sqrt(bend / (8.0 * tolerance)) - 1e-9)), MOST_CHORDS)


def chorded(at: Callable[[float], complex], bend: float, tolerance: float) -> list[Point]:
    """Return the points of a curve that its chords end at, without the first."""
    count = chords_for(bend, tolerance)
    ends = (at(k / count) for k in range(1, count + 1))
    return [(end.real, end.imag) for end in ends]


def bulged(start: Point, end: Point, bulge: float, tolerance: float) -> list[Point]:
    """Return the ends of chords of an arc, without the first, as drawings tell it by its bulge.

    Parameters
    ----------
    start, end : (float, float)
    bulge : float
        The tangent of a quarter of the angle it turns by, positive to the left.
    tolerance : float
        How far chords are off the arc at most.

    Examples
    --------
    A half circle to the left, below the x axis:

    >>> [(round(x, 6) + 0.0, round(y, 6) + 0.0) for x, y in bulged((0, 0), (2, 0), 1.0, 0.3)]
    [(1.0, -1.0), (2.0, 0.0)]
    """
    if bulge == 0.0 or start == end:
        return [end]
    a, b = complex(*start), complex(*end)
    turn = 4.0 * math.atan(bulge)
    middle = 0.5 * (a + b) + 0.5j * (b - a) * (1.0 - bulge**2) / (2.0 * bulge)
    radius = abs(a - middle)
    share = min(tolerance / radius, 1.0)
    step = 2.0 * math.acos(1.0 - share)  # the sagitta is radius (1 - cos(step / 2))
    count = min(max(1, math.ceil(abs(turn) / step - 1e-9)), MOST_CHORDS)
    ends = [middle + (a - middle) * cmath.exp(1j * turn * k / count) for k in range(1, count)]
    return [*((p.real, p.imag) for p in ends), end]
