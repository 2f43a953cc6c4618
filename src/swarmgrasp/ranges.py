"""Ranges of what users give, and what to say of what lies outside.

Every public function and class checks its arguments by these, at its door, and keeps what they
return: numbers as floats, counts as whole numbers, flags as bools. A function `..._faults` returns
a sentence for each fault, so that all of them can be told at once.
"""

import math
import re
from collections.abc import Iterable, Mapping, Set
from numbers import Integral, Number, Real
from pathlib import Path
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import NDArray

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


# -- what a value is ----------------------------------------------------------------------


def is_number(value: object) -> TypeGuard[float]:
    """Tell whether a value is a real number: True and "1" are none."""
    return isinstance(value, Real) and not isinstance(value, bool)


def is_whole(value: object) -> TypeGuard[int]:
    """Tell whether a value counts something: True and 2.0 do not."""
    return isinstance(value, Integral) and not isinstance(value, bool)


def is_flag(value: object) -> TypeGuard[bool]:
    """Tell whether a value is True or False: 1 and "no" are neither."""
    return isinstance(value, bool | np.bool_)


def number(value: object) -> float:
    """Return a finite number as a float; nan for anything else, which no range holds."""
    try:
        found = float(value) if is_number(value) else math.nan
    except OverflowError:
        return math.nan
    return found if math.isfinite(found) else math.nan


def items(values: object) -> tuple[Any, ...] | None:
    """Return what is given in a row; None for what has no order, is text, or is one thing."""
    if isinstance(values, str | bytes | Mapping | Set) or not isinstance(values, Iterable):
        return None
    try:
        return tuple(values)
    except TypeError:  # an array of one number
        return None


def numbers(values: object) -> tuple[float, ...]:
    """Return finite numbers in a row as floats; nothing at all if one is not."""
    found = tuple(map(number, items(values) or ()))
    return () if any(map(math.isnan, found)) else found


def angles(value: object) -> tuple[float, ...]:
    """Do the same for angles [rad], one or several, none of which is beyond `MOST_TURNED`."""
    found = numbers(value) or numbers((value,))
    return found if all(abs(angle) <= MOST_TURNED for angle in found) else ()


def array_of(values: object) -> NDArray[np.float64] | None:
    """Return numbers of any shape as a fresh array of floats; None if something is no number.

    Examples
    --------
    >>> array_of([(0, 1), (2, 3)]).shape, array_of(["1", "2"]), array_of([(1, 2), 3])
    ((2, 2), None, None)
    """
    try:
        found = np.array(values)
        if found.dtype.kind == "O" and not all(map(is_number, found.flat)):
            return None
        return found.astype(float) if found.dtype.kind in "iufO" else None
    except (TypeError, ValueError, OverflowError):
        return None


# -- what is wrong with it ----------------------------------------------------------------


def shown(value: object) -> str:
    """Return a value as a message has it: not thousands of digits.

    Examples
    --------
    >>> shown("1"), shown(10**5000), shown(10**400)[-6:]
    ("'1'", 'a number of too many digits', '000...')
    """
    try:
        text = repr(value.tolist() if isinstance(value, np.ndarray) else value)
    except ValueError:  # of more digits than Python writes
        return "a number of too many digits"
    text = " ".join(text.split())
    return text if len(text) <= MOST_SHOWN else f"{text[:MOST_SHOWN]}..."


def kind_faults(value: object, kind: type, made_by: str = "") -> list[str]:
    """Return what is wrong with something that should be of a kind.

    Examples
    --------
    >>> kind_faults(3, Path, "Path(name)")
    ['3 is no Path: make one with Path(name)']
    """
    if isinstance(value, kind):
        return []
    remedy = f": make one with {made_by}" if made_by else ""
    is_small = value is None or isinstance(value, str | Number)
    return [f"{shown(value) if is_small else type(value).__name__} is no {kind.__name__}{remedy}"]


def flag_faults(value: object, called: str) -> list[str]:
    """Return what is wrong with a flag."""
    return [] if is_flag(value) else [f"{called} is {shown(value)}; it should be True or False"]


def count_faults(count: object, called: str = "the number of robots") -> list[str]:
    """Return what is wrong with a number of robots to be placed."""
    if is_whole(count) and 1 <= count <= MOST_PLACED:
        return []
    wanted = f"it should be a whole number from 1 to {MOST_PLACED}"
    return [f"{called} is {shown(count)}; {wanted}"]


def gap_faults(gap: object) -> list[str]:
    """Return what is wrong with a gap between bound and answer, relative to the answer."""
    if 0.0 < number(gap) < 1.0:
        return []
    return [f"the gap is {shown(gap)}; it should be 0 < gap < 1"]


def length_faults(length: object, called: str) -> list[str]:
    """Return what is wrong with a length [m] that may be 0."""
    if 0.0 <= number(length) <= STRONGEST:
        return []
    return [f"the {called} is {shown(length)}; it should be 0 <= {called} <= {STRONGEST:g} [m]"]


def call_faults(progress: object) -> list[str]:
    """Return what is wrong with what is called as a search goes on."""
    if progress is None or callable(progress):
        return []
    return [f"progress is {shown(progress)}; it should be a function, or None"]


def limit_faults(limit: object) -> list[str]:
    """Return what is wrong with a force limit [N]."""
    if WEAKEST <= number(limit) <= STRONGEST:
        return []
    return [f"the limit is {shown(limit)}; it should be {WEAKEST:g} <= limit <= {STRONGEST:g} [N]"]


def name_faults(name: object) -> list[str]:
    r"""Return what is wrong with a name: it should be text that every terminal and picture takes.

    Examples
    --------
    >>> name_faults("Zoë"), name_faults("\x1b[31mZoë")
    ([], ["the name '\\x1b[31mZoë' holds the control character '\\x1b'; leave it out"])
    """
    if not isinstance(name, str):
        return [f"the name is {shown(name)}; it should be text"]
    found = _CONTROL.search(name)
    if found is None:
        return []
    return [f"the name {shown(name)} holds the control character {found[0]!r}; leave it out"]


def plain_name(name: str) -> str:
    """Return a name that `name_faults` takes, made of one that may have come from anywhere."""
    return _CONTROL.sub("?", name)


def path_faults(path: object) -> list[str]:
    """Return what is wrong with the path of a file."""
    if isinstance(path, str | Path) and "\0" not in str(path):
        return []
    return [f"{shown(path)} is no path of a file"]
