"""Read a quantity as people write it, "60 t", "25 kn", "90 deg", as a number in SI units."""

import math
import re
from dataclasses import dataclass
from typing import Final

from swarmgrasp.errors import QuantityInvalid
from swarmgrasp.ranges import is_number, number, shown
from swarmgrasp.units.beaufort import beaufort_speed
from swarmgrasp.units.library import LONGEST
from swarmgrasp.units.spellings import BEAUFORT, PLAIN, canonical, size, unit_fault


@dataclass(frozen=True)
class Kind:
    """What is measured.

    Attributes
    ----------
    powers : dict
        Of what quantities with units of their own it is the product.
    si : str
        Its SI unit.
    example : str
    called : str
        With its article.
    """

    powers: dict[str, int]
    si: str
    example: str
    called: str


KINDS: Final = {
    "length": Kind({"length": 1}, "m", "5 m", "a length"),
    "force": Kind({"force": 1}, "N", "60 kN", "a force"),
    "angle": Kind({"angle": 1}, "rad", "90 deg", "an angle"),
    "speed": Kind({"length": 1, "time": -1}, "m/s", "25 kn", "a speed"),
    "mass": Kind({"mass": 1}, "kg", "400 t", "a mass"),
    "time": Kind({"time": 1}, "s", "10 min", "a time"),
    "area": Kind({"length": 2}, "m^2", "400 m^2", "an area"),
    "torque": Kind({"force": 1, "length": 1}, "N m", "900 kN m", "a torque"),
    "density": Kind({"mass": 1, "length": -3}, "kg/m^3", "1.025 t/m^3", "a density"),
    "inertia": Kind({"mass": 1, "length": 2}, "kg m^2", "900 t m^2", "a moment of inertia"),
    "turn rate": Kind({"angle": 1, "time": -1}, "rad/s", "12 deg/s", "a rate of turn"),
}
"""All that is measured."""

_SIGNED = re.compile(r"[-+\u2212]?\.?[0-9]")
_QUANTITY = re.compile(
    r"\s*([-+\u2212]?(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][-+]?[0-9]+)?)(.*)", re.S
)
_POWER = re.compile(r"([^\d^]+)\^?([123]?)")
_WRITTEN = (
    (re.compile(r"\b(?:square|sq\.?)\s*([a-zA-Z]+)"), r"\1^2"),
    (re.compile(r"\b(?:cubic|cu\.?)\s*([a-zA-Z]+)"), r"\1^3"),
    (re.compile(r"\s+per\s+"), "/"),
    (re.compile("-(?!force)"), " "),
    (re.compile(r"\*\*"), "^"),
    (re.compile("\u00b2"), "^2"),
    (re.compile("\u00b3"), "^3"),
)
"""Ways to write a unit of several, and the way it is read."""


def is_quantity(value: object) -> bool:
    """Tell whether text begins with a number, and is more than one.

    Examples
    --------
    >>> is_quantity("90 deg"), is_quantity("-.5 kN"), is_quantity("inward"), is_quantity("60")
    (True, True, False, False)
    """
    text = value.strip() if isinstance(value, str) else ""
    found = _QUANTITY.fullmatch(text)
    return bool(_SIGNED.match(text)) and not (found and found[2] == "")


def quantity(value: str | float, of: str, unit: str = "") -> float:
    """Return a quantity in SI units.

    Parameters
    ----------
    value : str or float
        A number, or text of a number with a unit, such as "25 kn".
    of : str
        What is measured: length, force, angle, speed, mass, time, area, torque, density, inertia or
        turn rate. A "t" is a tonne-force where a force is wanted, and a tonne where a mass is.
    unit : str
        Of a number that has none; the SI unit when left out.

    Raises
    ------
    QuantityInvalid
        If it is no number, or its unit is unknown or of something else.

    Examples
    --------
    >>> quantity("60 t", "force"), quantity("600kN", "force"), quantity("25", "speed", "m/s")
    (588399.0, 600000.0, 25.0)
    >>> quantity("4 Bft", "speed"), quantity("900 kN m", "torque"), quantity("5 t", "mass")
    (7.9, 900000.0, 5000.0)
    >>> quantity("25 kN", "speed")
    Traceback (most recent call last):
    swarmgrasp.errors.QuantityInvalid: 'kN' is a unit of force, not of speed; did you mean 'kn'?
    """
    amount, word = split(value, of)
    word = word or unit or KINDS[of].si
    if word == BEAUFORT and of == "speed":
        return beaufort_speed(amount)
    found = amount * unit_size(word, of)
    if not math.isfinite(found):
        raise QuantityInvalid(f"{shown(value)} is no finite number")
    return found


def in_unit(value: str | float, of: str, unit: str) -> float:
    """Return a quantity in some unit; the number itself if it is written in that unit.

    Parameters
    ----------
    value, of
        As of `quantity`.
    unit : str
        Not Bft; the SI unit for "".

    Raises
    ------
    QuantityInvalid
        As of `quantity`.

    Examples
    --------
    >>> in_unit("60 t", "force", "kN"), in_unit("12.1 feet", "length", "ft")
    (588.399, 12.1)
    """
    unit = unit or KINDS[of].si
    amount, word = split(value, of)
    if math.isfinite(amount) and word in ("", unit):
        return amount
    return quantity(value, of) / unit_size(unit, of)


def split(value: str | float, of: str) -> tuple[float, str]:
    """Return the number of a quantity, and its unit as it is called here; "" if it has none.

    Raises
    ------
    QuantityInvalid
        As of `quantity`.

    Examples
    --------
    >>> split("60 tonnes", "force"), split(60, "force")
    ((60.0, 'tf'), (60.0, ''))
    """
    amount, word = (number(value), "") if is_number(value) else _parted(value, KINDS[of])
    return amount, (of in PLAIN and canonical(word, of)) or word


def unit_size(word: str, of: str) -> float:
    """Return what a unit is in SI units.

    Raises
    ------
    QuantityInvalid
        If it is unknown, or of something else.

    Examples
    --------
    >>> unit_size("kNm", "torque"), unit_size("ft\u00b2", "area"), unit_size("deg/min", "turn rate")
    (1000.0, 0.09290304, 0.0002908882086657216)
    """
    if len(word) > LONGEST:
        raise QuantityInvalid(f"there is no unit of {of} {shown(word)}")
    name = canonical(word, of) if of in PLAIN else None
    if name is not None:
        return size(name, of)
    found = _product(word, KINDS[of])
    if found is None and of in PLAIN:
        raise QuantityInvalid(unit_fault(word, of))
    if found is None:
        said = f"{shown(word)} is no unit of {KINDS[of].called.split(' ', 1)[1]}"
        raise QuantityInvalid(f"{said}; write it as in {KINDS[of].example}")
    return found


def _parted(text: object, kind: Kind) -> tuple[float, str]:
    """Return the number and the unit of a quantity."""
    found = _QUANTITY.fullmatch(text) if isinstance(text, str) else None
    if found is None:
        said = f"{shown(text)} is no {kind.called.split(' ', 1)[1]}; write a number, or one with "
        raise QuantityInvalid(f"{said}its unit, such as {kind.example}")
    rest = found[2].strip()
    if rest[:1] == ",":
        raise QuantityInvalid(f"{shown(text)} has a comma; write decimals after a point")
    if rest.lstrip("'_")[:1].isdigit():
        raise QuantityInvalid(f"{shown(text)} has digits apart; write them together, as in 1000")
    return float(found[1].replace("\u2212", "-")), rest


def _product(word: str, kind: Kind) -> float | None:
    """Return the size of a unit made of several; None if it is not of a kind."""
    for pattern, plain in _WRITTEN:
        word = pattern.sub(plain, word)
    powers, found = dict.fromkeys(kind.powers, 0), 1.0
    for index, part in enumerate(word.split("/")):
        for piece in filter(None, re.split(r"[\s*.\u00b7\u22c5]+", part)):
            taken = _piece(piece, kind, -1 if index else 1)
            if taken is None:
                return None
            for measured, power, each in taken:
                powers[measured] += power
                found *= each**power
    return found if powers == kind.powers else None


def _piece(piece: str, kind: Kind, sign: int) -> list[tuple[str, int, float]] | None:
    """Return of what quantity the factors of a unit are, their powers, and their sizes."""
    told = _POWER.fullmatch(piece)
    if told is None:
        return None
    name, power = told[1], sign * int(told[2] or 1)
    for of in kind.powers:
        known = canonical(name, of)
        if known is not None:
            return [(of, power, size(known, of))]
    if list(kind.powers) != ["force", "length"]:
        return None
    for at in range(1, len(name)):  # a torque in "kNm"
        first, last = canonical(name[:at], "force"), canonical(name[at:], "length")
        if first and last:
            return [("force", power, size(first, "force")), ("length", power, size(last, "length"))]
    return None
