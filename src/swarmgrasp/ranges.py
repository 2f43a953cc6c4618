"""Ranges of the numbers that users give, and what to say of those outside."""

import math

MOST_TURNED = 1e6
"""Largest angle [rad]: beyond it, rounding eats the direction."""
WEAKEST, STRONGEST = 1e-100, 1e100
"""Range of force limits [N] whose squares and cubes are still numbers."""


def numbers(values: object) -> tuple[float, ...]:
    """Return finite numbers as floats; nothing at all if one is not."""
    try:
        found = tuple(map(float, values))  # type: ignore[call-overload]
    except (TypeError, ValueError, OverflowError):
        return ()
    return found if all(map(math.isfinite, found)) else ()


def angles(value: object) -> tuple[float, ...]:
    """Do the same for angles [rad], one or several, none of which is beyond `MOST_TURNED`."""
    found = numbers(value) or numbers((value,))
    return found if all(abs(angle) <= MOST_TURNED for angle in found) else ()


def name_faults(name: object) -> list[str]:
    """Return what is wrong with a name."""
    return [] if isinstance(name, str) else [f"the name is {name!r}; it should be text"]


def limit_faults(limit: object) -> list[str]:
    """Return what is wrong with a force limit [N]."""
    if any(WEAKEST <= value <= STRONGEST for value in numbers((limit,))):
        return []
    return [f"the limit is {limit!r}; it should be {WEAKEST:g} <= limit <= {STRONGEST:g} [N]"]
