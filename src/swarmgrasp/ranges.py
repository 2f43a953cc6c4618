"""Ranges of the numbers that users give, and what to say of those outside."""

import math
import re
from numbers import Integral
from typing import TypeGuard

MOST_TURNED = 1e6
"""Largest angle [rad]: beyond it, rounding eats the direction."""
WEAKEST, STRONGEST = 1e-100, 1e100
"""Range of force limits [N] whose squares and cubes are still numbers."""
_CONTROL = re.compile("[\\x00-\\x1f\\x7f-\\x9f\\u2028\\u2029\\ud800-\\udfff\\ufffe\\uffff]")
"""What steers a terminal, breaks a line, or may not stand in XML or UTF-8."""
MOST_SHOWN = 60
"""Characters of a wrong value that a message shows."""
MOST_PLACED = 1000
"""Robots that one call places."""


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


def is_whole(value: object) -> TypeGuard[int]:
    """Tell whether a value counts something: True and 2.0 do not."""
    return isinstance(value, Integral) and not isinstance(value, bool)


def count_faults(count: object, called: str = "the number of robots") -> list[str]:
    """Return what is wrong with a number of robots to be placed."""
    if is_whole(count) and 1 <= count <= MOST_PLACED:
        return []
    wanted = f"it should be a whole number from 1 to {MOST_PLACED}"
    return [f"{called} is {shown(count)}; {wanted}"]


def shown(value: object) -> str:
    """Return a value as a message has it: not thousands of digits."""
    try:
        text = repr(value)
    except ValueError:  # of more digits than Python writes
        return "a number of too many digits"
    return text if len(text) <= MOST_SHOWN else f"{text[:MOST_SHOWN]}..."


def name_faults(name: object) -> list[str]:
    r"""Return what is wrong with a name: it should be text that every terminal and picture takes.

    Examples
    --------
    >>> name_faults("Zoë"), name_faults("\x1b[31mZoë")
    ([], ["the name '\\x1b[31mZoë' holds the control character '\\x1b'; leave it out"])
    """
    if not isinstance(name, str):
        return [f"the name is {name!r}; it should be text"]
    found = _CONTROL.search(name)
    if found is None:
        return []
    return [f"the name {name!r} holds the control character {found[0]!r}; leave it out"]


def plain_name(name: str) -> str:
    """Return a name that `name_faults` takes, made of one that may have come from anywhere."""
    return _CONTROL.sub("?", name)


def limit_faults(limit: object) -> list[str]:
    """Return what is wrong with a force limit [N]."""
    if any(WEAKEST <= value <= STRONGEST for value in numbers((limit,))):
        return []
    return [f"the limit is {limit!r}; it should be {WEAKEST:g} <= limit <= {STRONGEST:g} [N]"]
