"""Ranges of what users give, and what to say of what lies outside.

Every public function and class checks its arguments by these, at its door, and keeps what they
return: numbers as floats, counts as whole numbers, flags as bools. A function `..._faults` returns
a sentence for each fault, so that all of them can be told at once.
"""

import math
import re
import unicodedata
from collections.abc import Iterable, Mapping, Sequence, Set
from difflib import get_close_matches
from numbers import Integral, Number, Real
from pathlib import Path
from typing import Any, TypeGuard

import numpy as np
from numpy.typing import NDArray

MOST_TURNED = 1e6
"""Largest angle [rad]: beyond it, rounding eats the direction."""
WEAKEST, STRONGEST = 1e-100, 1e100
"""Range of force limits [N] whose squares and cubes are still numbers."""
_JOINED = "[^\\0-\\u02af\\u2000-\\u206f]"
"""What joiners stand between: letters that change when they meet, and emoji."""
_ODD = re.compile(
    "[\\x00-\\x1f\\x7f-\\x9f\\u2028\\u2029\\ud800-\\udfff\\ufffe\\uffff]"  # controls
    "|[\\xad\\u034f\\u180e\\u200b\\u2060-\\u2064\\ufeff\\ufff9-\\ufffb]"  # of no width
    "|[\\u061c\\u200e\\u200f\\u202a-\\u202e\\u2066-\\u206f]"  # of direction
    f"|(?<!{_JOINED})[\\u200c\\u200d]|[\\u200c\\u200d](?!{_JOINED})"
    "|(?<![^\\sA-Za-z\\xc0-\\u02af])[\\ufe00-\\ufe0f]"  # that choose a shape, where there is one
    "|(?<![\U0001f3f4\U000e0020-\U000e007f])[\U000e0001-\U000e007f]"  # that make flags, elsewhere
)
"""What steers a terminal, breaks a line, may not stand in XML or UTF-8, hides in a name so that two
look the same, or turns text around."""
_UNSEEN = {"Cf", "Mn", "Zs"}
"""Other categories of characters that show nothing by themselves."""
_FILLERS = "\u115f\u1160\u2800\u3164\uffa0"
"""Letters and signs that show nothing all the same."""
MOST_SHOWN = 60
"""Characters of a wrong value that a message shows."""
MOST_LOOKED_AT = 100
"""Names among which one like a wrong name is looked for; there may be many wrong ones."""
MOST_PLACED = 1000
"""Robots that one call places."""
MOST_SEED = 2**63 - 1
"""Of what is drawn from chance."""


# -- what a value is ----------------------------------------------------------------------

_NUMBERS = (float, int)


def is_number(value: object) -> TypeGuard[float]:
    """Tell whether a value is a real number: True and "1" are none."""
    if type(value) in _NUMBERS:  # asking for an abstract kind takes long
        return True
    return isinstance(value, Real) and not isinstance(value, bool)


def is_whole(value: object) -> TypeGuard[int]:
    """Tell whether a value counts something: True and 2.0 do not."""
    return type(value) is int or (isinstance(value, Integral) and not isinstance(value, bool))


def is_flag(value: object) -> TypeGuard[bool]:
    """Tell whether a value is True or False: 1 and "no" are neither."""
    return isinstance(value, bool | np.bool_)


def number(value: object) -> float:
    """Return a finite number as a float; nan for anything else, which no range holds."""
    if type(value) is float:
        return value if math.isfinite(value) else math.nan
    try:
        found = float(value) if is_number(value) else math.nan
    except OverflowError:
        return math.nan
    return found if math.isfinite(found) else math.nan


def items(values: object) -> tuple[Any, ...] | None:
    """Return what is given in a row; None for what has no order, is text, or is one thing."""
    if type(values) is tuple:
        return values
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
    r"""Return what is wrong with a name: it should be text that every terminal and picture shows.

    Examples
    --------
    >>> name_faults("Zoë"), name_faults("Zoë\u200b")
    ([], ["the name 'Zoë\\u200b' holds U+200B ZERO WIDTH SPACE; leave it out"])
    """
    if not isinstance(name, str):
        return [f"the name is {shown(name)}; it should be text"]
    fault = name_fault(name)
    return [f"the name {shown(name)} {fault}"] if fault else []


def name_fault(name: str) -> str:
    r"""Return what is wrong with text as a name, as the rest of a sentence; "" if nothing is.

    Examples
    --------
    >>> name_fault("\x07"), name_fault("\u3000"), name_fault("")
    ('holds U+0007, a control character; leave it out', 'shows nothing; give it a letter', '')
    """
    if name.isascii() and name.isprintable() and not name.isspace():
        return ""  # most names, of which there may be a million
    odd = _ODD.search(name)
    if odd:
        called = unicodedata.name(odd[0], "")
        called = f" {called}" if called else ", a control character"
        return f"holds U+{ord(odd[0]):04X}{called}; leave it out"
    shows = (c not in _FILLERS and unicodedata.category(c) not in _UNSEEN for c in name)
    return "shows nothing; give it a letter" if name and not any(shows) else ""


def plain_name(name: str) -> str:
    """Return a name that `name_faults` takes, made of one that may have come from anywhere."""
    plain = _ODD.sub("?", name)
    return "?" if name_fault(plain) else plain


def path_faults(path: object) -> list[str]:
    """Return what is wrong with the path of a file."""
    if isinstance(path, str | Path) and "\0" not in str(path):
        return []
    return [f"{shown(path)} is no path of a file"]


def unknown_key(key: object, known: Sequence[str]) -> str:
    """Return the fault of a key that no mapping of its place has, whose known keys are given."""
    return f"unknown key{nearest_name(str(key), known)}"


def nearest_name(wanted: str, known: Sequence[str]) -> str:
    """Return "; did you mean ..." for a near miss, else the list of known names.

    Examples
    --------
    >>> nearest_name("limt", ["limit", "name"])
    "; did you mean 'limit'?"
    >>> nearest_name("colour", ["limit", "name"])
    '; known: limit, name'
    """
    if len(known) > MOST_LOOKED_AT:
        return f"; known: {', '.join(known[:20])}, ..."
    # spelling differs by case and by hyphens more often than by letters
    plain = {name.lower().replace("-", "_"): name for name in reversed(known)}
    close = get_close_matches(wanted[:80].lower().replace("-", "_"), plain, n=1)
    if close:
        return f"; did you mean {plain[close[0]]!r}?"
    return f"; known: {', '.join(known[:20])}" if known else ""
