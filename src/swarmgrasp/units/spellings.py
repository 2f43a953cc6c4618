"""What units are called, by the quantity that they are of, and what they are in SI units.

The sizes of the common ones stand here, so that a file of plain numbers or with "60 t" starts as
fast as one in SI units; all others come from a library of units.
"""

import math
from functools import cache
from typing import Final

from swarmgrasp.errors import QuantityInvalid
from swarmgrasp.ranges import nearest_name, shown
from swarmgrasp.units.library import known_size

KNOT: Final = 1852.0 / 3600.0
"""One knot [m/s]: a nautical mile an hour."""
BEAUFORT: Final = "Bft"
"""The unit of speed that is no multiple of a metre per second."""
LENGTHS: Final = {"m": 1.0, "mm": 1e-3, "cm": 1e-2, "km": 1e3, "ft": 0.3048, "in": 0.0254}
"""Metres per common unit of length."""
FORCES: Final = {
    "N": 1.0,
    "kN": 1e3,
    "MN": 1e6,
    "kgf": 9.80665,
    "tf": 9806.65,
    "lbf": 4.4482216152605,
    "kip": 4448.2216152605,
}
"""Newtons per common unit of force."""
ANGLES: Final = {"deg": math.pi / 180.0, "rad": 1.0}
"""Radians per common unit of angle."""
SPEEDS: Final = {"m/s": 1.0, "km/h": 1.0 / 3.6, "kn": KNOT}
"""Metres per second per common unit of speed."""
PLAIN: Final[dict[str, dict[str, float]]] = {
    "length": LENGTHS,
    "force": FORCES,
    "angle": ANGLES,
    "speed": SPEEDS,
    "mass": {"kg": 1.0, "t": 1e3},
    "time": {"s": 1.0, "min": 60.0, "h": 3600.0},
}
"""Sizes of the common units in SI units, by the quantity they are of. A unit is called by these
names wherever the program speaks of it."""
_SI: Final = {
    "length": "meter",
    "force": "newton",
    "angle": "radian",
    "speed": "meter/second",
    "mass": "kilogram",
    "time": "second",
}
"""The SI unit of each quantity, as pint writes it."""
_ALSO: Final = {
    "length": {
        "m": "metre metres meter meters",
        "mm": "millimetre millimetres millimeter millimeters",
        "cm": "centimetre centimetres centimeter centimeters",
        "km": "kilometre kilometres kilometer kilometers",
        "ft": "foot feet",
        "in": "inch inches",
    },
    "force": {
        "N": "newton newtons",
        "kN": "kilonewton kilonewtons",
        "MN": "meganewton meganewtons",
        "kgf": "kp kilopond kilogram-force kilograms-force",
        "tf": "t tonne tonnes tonne-force tonnes-force tonne_force",
        "lbf": "pound-force pounds-force",
        "kip": "kips klbf",
    },
    "angle": {"deg": "degree degrees °", "rad": "radian radians"},
    "speed": {
        "m/s": "mps",
        "km/h": "kmh kph kmph",
        "kn": "knot knots kt kts",
        BEAUFORT: "beaufort",
    },
    "mass": {"kg": "kilogram kilograms", "t": "tonne tonnes"},
    "time": {"s": "sec second seconds", "min": "minute minutes", "h": "hr hour hours"},
}
"""How else people write them. Three letters and more may be in any case."""
_VAGUE: Final = {
    **dict.fromkeys(
        ("ton", "tons", "tonf", "ton-force", "tons-force"),
        "a ton may be short, long or metric; write t for the metric one, or kip, 1000 pounds-force",
    ),
}
"""What means several units, and what to do about it."""


@cache
def spellings(quantity: str) -> dict[str, str]:
    """Return every spelling of the units of a quantity, with the name that units have here.

    Examples
    --------
    >>> spellings("force")["t"], spellings("mass")["t"], spellings("speed")["knots"]
    ('tf', 't', 'kn')
    """
    own = {name: name for name in PLAIN[quantity]}
    also = {also: name for name, words in _ALSO[quantity].items() for also in words.split()}
    return {**own, **({BEAUFORT: BEAUFORT} if quantity == "speed" else {}), **also}


def unit_name(word: str, quantity: str) -> str | None:
    """Return what a common unit is called here; None for a rare one, or none.

    Examples
    --------
    >>> unit_name("Knots", "speed"), unit_name("tonne-force", "force"), unit_name("yard", "length")
    ('kn', 'tf', None)
    """
    return spellings(quantity).get(word) or _folded(quantity).get(word.lower())


@cache
def _folded(quantity: str) -> dict[str, str]:
    """Return the spellings of three letters and more in small letters: case means nothing there."""
    return {word.lower(): name for word, name in spellings(quantity).items() if len(word) > 2}


def canonical(word: str, quantity: str) -> str | None:
    """Return what a unit of a quantity is called here; None if nothing is.

    Examples
    --------
    >>> canonical("Knots", "speed"), canonical("kN", "speed"), canonical("yard", "length")
    ('kn', None, 'yard')
    """
    found = unit_name(word, quantity)
    if found or word in _VAGUE or any(word in spellings(other) for other in PLAIN):
        return found
    word = "_".join(word.split())  # as the library has nautical miles
    return None if known_size(word, _SI[quantity]) is None else word


def size(name: str, quantity: str) -> float:
    """Return what a unit, called as it is here, is in SI units.

    Examples
    --------
    >>> size("ft", "length"), size("yard", "length")
    (0.3048, 0.9144)
    """
    found = PLAIN[quantity].get(name) or known_size(name, _SI[quantity])
    if found is None:
        raise QuantityInvalid(f"{shown(name)} is no unit of {quantity}")
    return found


def unit_fault(word: str, quantity: str) -> str:
    """Return what is wrong with the unit of a quantity.

    Examples
    --------
    >>> unit_fault("knt", "speed"), unit_fault("hp", "angle")
    ("there is no unit of speed 'knt'; did you mean 'knot'?", \
"there is no unit of angle 'hp'; known: deg, rad")
    """
    if word in _VAGUE:
        return _VAGUE[word]
    near = nearest_name(word, list(spellings(quantity)))
    near = near if near.startswith("; did") else f"; known: {', '.join(PLAIN[quantity])}"
    for other in PLAIN:
        if word in spellings(other):
            return f"{shown(word)} is a unit of {other}, not of {quantity}{near}"
    return f"there is no unit of {quantity} {shown(word)}{near}"
