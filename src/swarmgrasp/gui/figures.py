"""Figures as the page sets them: few digits, no-break spaces, true minus signs, bearings."""

import math
from dataclasses import dataclass

from swarmgrasp.terms import Terms
from swarmgrasp.units import FORCES, LENGTHS, SPEEDS

SPACE = "\u00a0"
MINUS = "\u2212"
DEGREE = "\u00b0"
LABELS = {"tf": "t", "deg": DEGREE}
"""What people read where the library has another name for a unit."""
SMALL = 9.95
"""Size below which a figure has a decimal."""
GROUPED = 10_000
"""Size from which on digits stand in groups."""
COUNTS = (
    "none", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten",
    "eleven", "twelve",
)  # fmt: skip


def figure(value: float) -> str:
    """Write a number: a decimal below ten, two digits of what is small, groups from 10 000 on.

    Examples
    --------
    >>> [figure(v) for v in (4.449, 0.0, 34.1, -12.7, 0.0312)]
    ['4.4', '0', '34', '\u221213', '0.031']
    >>> figure(89868.2).replace(SPACE, " ")
    '89 868'
    """
    size = abs(value)
    if size == 0.0:
        return "0"
    if size < 1.0:
        decimals = min(12, 1 - math.floor(math.log10(size)))
        said = f"{size:.{decimals}f}" if size >= 1e-6 else f"{size:.1e}"
    elif size < SMALL:
        said = f"{size:.1f}"
    else:
        said = f"{size:,.0f}".replace(",", SPACE if size >= GROUPED else "")
    return f"{MINUS * (value < 0.0)}{said}"


def count(number: int) -> str:
    """Write a number of things, to twelve in words.

    Examples
    --------
    >>> count(9), count(40)
    ('nine', '40')
    """
    return COUNTS[number] if number < len(COUNTS) else figure(float(number))


@dataclass(frozen=True)
class Figures:
    """Figures in the terms of a page."""

    terms: Terms

    @property
    def force_unit(self) -> str:
        """What forces are told in."""
        return LABELS.get(self.terms.force, self.terms.force)

    def in_force(self, newtons: float) -> float:
        """Return a force [N] in the unit of forces."""
        return newtons / FORCES[self.terms.force]

    def in_speed(self, speed: float) -> float:
        """Return a speed [m/s] in the unit of speeds."""
        return speed / SPEEDS[self.terms.speed]

    def force(self, newtons: float) -> str:
        """Return a force [N] without its unit."""
        return figure(self.in_force(newtons))

    def forces(self, newtons: float) -> str:
        """Return a force [N] with its unit."""
        return f"{self.force(newtons)}{SPACE}{self.force_unit}"

    def lengths(self, metres: float) -> str:
        """Return a length [m] with its unit."""
        return f"{figure(metres / LENGTHS[self.terms.length])}{SPACE}{self.terms.length}"

    def speed(self, speed: float) -> str:
        """Return a speed [m/s] without its unit."""
        return figure(self.in_speed(speed))

    def speeds(self, speed: float) -> str:
        """Return a speed [m/s] with its unit."""
        return f"{self.speed(speed)}{SPACE}{self.terms.speed}"

    def bearing(self, direction: float) -> str:
        """Return a direction [rad] of ours as a bearing, of three digits.

        Examples
        --------
        >>> Figures(Terms()).bearing(-math.pi / 2), Figures(Terms()).bearing(0.0)
        ('090\u00b0', '000\u00b0')
        """
        degrees = round(math.degrees(self.terms.frame.bearing(direction))) % 360
        return f"{degrees:03d}{DEGREE}"

    def coming(self, bearing: float) -> str:
        """Return where wind comes from, a bearing [rad] clockwise from the bow."""
        return self.bearing(-bearing)
