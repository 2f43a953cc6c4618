"""Numbers and units for people: forces, lengths, angles, shares, wrenches, lists of names."""

import math
import re
from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.errors import WrenchInvalid
from swarmgrasp.ranges import array_of, shown

MENTIONED = 0.25
"""Share of a unit direction below which a component goes unmentioned."""
WAYS: Final = (("ahead", "aft"), ("to port", "to starboard"))
UNITS: Final = (
    (1e6, 1e6, "MN"),
    (1e3, 1e3, "kN"),
    (1e-2, 1.0, "N"),
    (1e-4, 1e-3, "mN"),
    (1e-7, 1e-6, "µN"),
    (0.0, 1e-9, "nN"),
)
"""Least force [N] told in a unit, its size [N], and its name."""
TIMES: Final = "times the task"
"""The unit of a quality relative to a task."""
PART: Final = 1e-4
"""Share of a whole below which a part of it is told as 0."""


HOUR: Final = 3600.0
DAY: Final = 24.0 * HOUR


def wrench_words(direction: ArrayLike) -> str:
    """Say how a wrench would move the object, the strongest part first.

    Parameters
    ----------
    direction : (3,)
        Surge, sway and yaw in the metric's coordinates: x forward, y to port, yaw
        counter-clockwise. Need not be a unit vector.

    Raises
    ------
    WrenchInvalid
        If it is not three finite numbers.

    Examples
    --------
    >>> wrench_words([0.0, -1.0, 0.0])
    'moving to starboard'
    >>> wrench_words([-0.5, 0.0, 0.8])
    'turning to port while moving aft'
    >>> wrench_words([0.6, -0.7, -0.4])
    'moving to starboard and ahead while turning to starboard'
    >>> wrench_words([0.0, 0.0, 0.0])
    'no wrench'
    """
    parts = array_of(direction)
    if parts is None or parts.shape != (3,) or not np.isfinite(parts).all():
        raise WrenchInvalid(
            f"the direction is {shown(direction)}; it should be three finite numbers"
        )
    size = float(np.linalg.norm(parts))
    if size == 0.0:
        return "no wrench"
    order = [int(i) for i in np.argsort(-np.abs(parts), kind="stable")]
    told = [i for i in order if abs(parts[i]) >= MENTIONED * size]
    moving = " and ".join(WAYS[i][int(parts[i] < 0.0)] for i in told if i < 2)
    said = [f"moving {moving}"] if moving else []
    if 2 in told:
        turning = f"turning to {'port' if parts[2] > 0.0 else 'starboard'}"
        said.insert(0 if told[0] == 2 else 1, turning)
    return " while ".join(said)


def machine_words(count: int, has_groups: bool, robot: str = "robot") -> str:
    """Return what so many of that which fails at once are called: groups, too, if there are any.

    Examples
    --------
    >>> machine_words(1, False), machine_words(2, True, "tug")
    ('robot', 'tugs or groups')
    """
    kinds = (robot, "group")[: 1 + has_groups]
    return " or ".join(kind if count == 1 else plural(kind) for kind in kinds)


def plural(word: str) -> str:
    """Return what several are called of what one is called so.

    Examples
    --------
    >>> [plural(word) for word in ("tug", "launch", "ferry", "buoy")]
    ['tugs', 'launches', 'ferries', 'buoys']
    """
    if re.search("(s|x|z|ch|sh)$", word):
        return f"{word}es"
    return f"{word[:-1]}ies" if re.search("[^aeiou]y$", word) else f"{word}s"


def list_words(names: Sequence[str]) -> str:
    """Join names as in a sentence.

    Examples
    --------
    >>> list_words(["Ajax"]), list_words(["Ajax", "Boreas"]), list_words("abc")
    ('Ajax', 'Ajax and Boreas', 'a, b and c')
    """
    if len(names) < 2:
        return "".join(names)
    return f"{', '.join(names[:-1])} and {names[-1]}"


def either_words(names: Sequence[str]) -> str:
    """Join names of which one is meant; what they begin with alike is said once.

    Examples
    --------
    >>> either_words(["Ajax", "Boreas"]), either_words(["Tug 1", "Tug 2", "Tug 4"])
    ('Ajax or Boreas', 'Tug 1, 2 or 4')
    """
    first, _, _ = names[0].rpartition(" ")
    if first and all(name.rpartition(" ")[0] == first for name in names):
        names = [names[0], *(name.rpartition(" ")[2] for name in names[1:])]
    return " or ".join([", ".join(names[:-1]), names[-1]] if len(names) > 1 else names)


@dataclass(frozen=True)
class Unit:
    """The unit in which one report tells one quantity, chosen by the largest value of it.

    Attributes
    ----------
    newtons : float
        Its size; 1 for a quality relative to a task.
    name : str
    figures : int
        Significant digits of a number.
    metres : float
        The size of the unit of length that goes with it in torques.
    arm : str
        The name of that.

    Examples
    --------
    >>> unit = Unit.for_size(229_220.4)
    >>> unit.text(229_220.4), unit.number(1200.0)
    ('229.22 kN', '1.2000')
    >>> unit.text(0.0), Unit.for_size(2e-9).text(0.0)
    ('0 kN', '0 N')
    """

    newtons: float
    name: str
    figures: int = 5
    metres: float = 1.0
    arm: str = "m"

    @property
    def torque(self) -> str:
        """The name of the unit of torque that goes with it."""
        return f"{self.name} {self.arm}"

    @classmethod
    def for_size(cls, *sizes: float, figures: int = 5) -> "Unit":
        """Choose the unit for forces of some sizes [N]."""
        size = max(map(abs, sizes), default=0.0) or 1.0
        newtons, name = next((n, name) for least, n, name in UNITS if size >= least)
        return cls(newtons, name, figures)

    def number(self, force: float) -> str:
        """Return a force [N] without its unit."""
        value = force / self.newtons
        return digits(value, value, self.figures)

    def text(self, force: float) -> str:
        """Return a force [N] with its unit, which for nothing is no part of a newton."""
        name = self.name if force or self.newtons >= 1.0 else "N"
        return f"{self.number(force)} {name}"

    def part(self, force: float, whole: float) -> str:
        """Return a part of a whole [N] with its unit, to the last digit of the whole, never as -0.

        Examples
        --------
        >>> unit = Unit.for_size(2e3)
        >>> unit.part(-1e-9, 2e3), unit.part(-1500.0, 2e3)
        ('0 kN', '-1.5000 kN')
        """
        return f"{self._part(force, whole, self.newtons)} {self.name}"

    def turn(self, torque: float, whole: float) -> str:
        """Return a part of a torque [N m] with its unit, to the last digit of the whole.

        Examples
        --------
        >>> Unit.for_size(2e3).turn(150.0, 2e3)
        '0.1500 kN m'
        """
        return f"{self._part(torque, whole, self.newtons * self.metres)} {self.torque}"

    def _part(self, part: float, whole: float, size: float) -> str:
        """Return a part of a whole in a unit of some size, without its name."""
        held = 0.0 if abs(part) < PART * abs(whole) else part
        return digits(held / size, whole / size, self.figures)

    def wrench(self, parts: Sequence[float], length: float) -> tuple[str, str, str]:
        """Return the parts (3,) [N, N, N m] of a wrench whose torque counts by a length [m].

        Examples
        --------
        >>> Unit.for_size(5e3, figures=4).wrench((3e3, 0.0, 4e3), 1.0)
        ('3.000 kN', '0 kN', '4.000 kN m')
        """
        x, y, turn = parts
        size = math.hypot(x, y, turn / length)
        return self.part(x, size), self.part(y, size), self.turn(turn, size * length)


def digits(value: float, size: float, figures: int = 5) -> str:
    """Write a number with the decimals that give a size so many digits, never as -0.

    Examples
    --------
    >>> digits(2.0, 2.0, 4), digits(0.5, 100.0, 4), digits(0.0, 0.0), digits(-1e-9, 1.0)
    ('2.000', '0.5', '0', '0')
    >>> [digits(v, v) for v in (123.456, 0.000123456, 1234567.0, -2.5, 1.25e-7, 9.99996)]
    ['123.46', '0.00012346', '1234567', '-2.5000', '1.2500e-07', '10.000']
    """
    if value == 0.0 or size == 0.0:
        return "0"
    power = _power(size, figures)
    if power <= -6:
        return f"{value:.{figures - 1}e}"
    decimals = max(0, figures - 1 - power)
    rounded = round(value, decimals)
    return f"{rounded:.{decimals}f}" if rounded else "0"


def trimmed(value: float, figures: int) -> str:
    """Write a number with at most so many digits, but all of a whole number, and no zeros after it.

    Examples
    --------
    >>> [trimmed(v, 3) for v in (134885.0, 2100.0, 60.0, 12.345, 0.5, 0.0)]
    ['134885', '2100', '60', '12.3', '0.5', '0']
    """
    told = digits(value, value, figures)
    return told.rstrip("0").rstrip(".") if "." in told and "e" not in told else told


def plain_seconds(seconds: float) -> str:
    """Write a time [s] to a tenth, or to a whole second where it is longer than an hour.

    Examples
    --------
    >>> [plain_seconds(time) for time in (0.0, 0.05, 40.94, 256.6, 600.0, 86400.4)]
    ['0', '0.05', '40.9', '256.6', '600', '86400']
    """
    if seconds and abs(seconds) < 1.0:
        return f"{seconds:.2g}"
    return f"{round(seconds, 0 if abs(seconds) >= HOUR else 1):.15g}"


def span(seconds: float) -> str:
    """Say how long something lasts, in a unit that suits it.

    Examples
    --------
    >>> [span(time) for time in (0.4, 600.0, 7200.0, 1e5, 1e6)]
    ['0.4 s', '600 s', '2 h', '27.8 h', '11.6 days']
    """
    size, name = time_unit(seconds)
    if size == 1.0:
        return f"{plain_seconds(seconds)} s"
    return f"{float(digits(seconds / size, seconds / size, 3)):g} {name}"


def time_unit(seconds: float) -> tuple[float, str]:
    """Return the size [s] and the name of the unit in which so long a time is told."""
    units = (DAY, "days"), (HOUR, "h")
    return next((unit for unit in units if seconds >= 2.0 * unit[0]), (1.0, "s"))


def percent(share: float) -> str:
    """Say a share in percent, to three digits, or two where it is tiny.

    Examples
    --------
    >>> percent(1.0806), percent(0.975), percent(0.0), percent(2.2e-7), percent(0.999996)
    ('108 %', '97.5 %', '0 %', '0.000022 %', '100 %')
    """
    value = 100.0 * share
    if value == 0.0:
        return "0 %"
    power = _power(value, 3)
    figures = 2 if power >= -1 else 1
    return f"{value:.{max(0, figures - power)}f} %"


def _power(value: float, figures: int) -> int:
    """Return the power of ten of a number's first digit, once it is rounded to some digits."""
    return int(f"{value:.{figures - 1}e}".partition("e")[2])


@dataclass(frozen=True)
class Lengths:
    """How the lengths of one object are told: to some 1/10 000 of its extent.

    Attributes
    ----------
    decimals : int
    metres : float
        The size of their unit.
    name : str
        Of their unit.
    """

    decimals: int
    metres: float = 1.0
    name: str = "m"

    @classmethod
    def for_extent(cls, extent: float, metres: float = 1.0, name: str = "m") -> "Lengths":
        """Choose the number of decimals for an object so many metres across."""
        return cls(max(0, 4 - math.floor(math.log10(extent / metres))), metres, name)

    def number(self, length: float) -> str:
        """Return a length [m] without its unit."""
        return f"{round(length / self.metres, self.decimals) + 0.0:.{self.decimals}f}"

    def text(self, length: float) -> str:
        """Return a length [m] with its unit."""
        return f"{self.number(length)} {self.name}"

    def short(self, length: float) -> str:
        """Return a length [m] with its unit and three digits at most.

        Examples
        --------
        >>> Lengths(2).short(2.1)
        '2.1 m'
        """
        return f"{trimmed(length / self.metres, 3)} {self.name}"

    def point(self, point: Sequence[float]) -> str:
        """Return a point [m, m] as "(x, y) m".

        Examples
        --------
        >>> Lengths.for_extent(76.2).point((-12.19, 10.9728))
        '(-12.190, 10.973) m'
        >>> Lengths.for_extent(76.2, 0.3048, "ft").point((-12.192, 10.9728))
        '(-40.00, 36.00) ft'
        """
        return f"({self.number(point[0])}, {self.number(point[1])}) {self.name}"


def turned(angle: float) -> float:
    """Return an angle [rad] in degrees within (-180, 180].

    Examples
    --------
    >>> [round(turned(a), 6) for a in (math.pi, -math.pi, 0.0, 5.5 * math.pi)]
    [180.0, 180.0, 0.0, -90.0]
    """
    return 180.0 - (180.0 - math.degrees(angle)) % 360.0


def degrees(angle: float) -> str:
    """Return a direction [rad] in degrees as text, never -0."""
    return f"{round(turned(angle), 1) + 0.0:.1f}"
