"""The one door to pint, which knows units that few people write; loaded when one of them is met."""

from fractions import Fraction
from functools import cache, lru_cache
from typing import Any

LONGEST = 40
"""Letters of a name that is looked up."""


@cache
def _registry() -> Any:
    """Return all that pint knows, in exact numbers."""
    from pint import UnitRegistry

    return UnitRegistry(non_int_type=Fraction)


@lru_cache(4096)
def known_size(name: str, si: str) -> float | None:
    """Return what a unit is in SI units; None if it is unknown, or of something else.

    Parameters
    ----------
    name : str
        A symbol of two letters has no prefix: next to "mm", "Mm" would be a slip.
    si : str
        The SI unit of the quantity, as pint writes it.

    Examples
    --------
    >>> known_size("yard", "meter"), known_size("mph", "meter/second"), known_size("Mm", "meter")
    (0.9144, 0.44704, None)
    >>> known_size("yard", "newton"), known_size("percent", "radian")
    (None, None)
    """
    if len(name) > LONGEST or not name.isidentifier():
        return None
    registry = _registry()
    found = registry.parse_unit_name(name)
    if not found or (found[0][0] and len(name) < 3):
        return None
    factor, unit = registry.get_base_units(name)
    told, wanted = registry.get_base_units(si)
    return float(factor / told) if unit == wanted else None
