"""Signatures and attributes with the names that the sources have.

An array is named as such, and not as what NumPy makes of it; of attributes that are told in one
line, each is listed; and a property whose sentence has a colon keeps it.
"""

import re
from typing import Any

from numpy.typing import ArrayLike
from sphinx.application import Sphinx
from sphinx.util.typing import stringify_annotation

NUMBERS = re.compile(
    r"~?(?:numpy\.)?ndarray\[\S*?tuple\[~?(?:typing\.)?Any, \.\.\.\], \S*?dtype\[([^\]]*)\]\]"
)
SEVERAL = re.compile(r"(?P<names>\w+(?:, \w+)+) : (?P<kind>.*)$")
"""Attributes, and what each of them is."""


def named(text: str | None) -> str | None:
    """Return a signature with arrays by their names."""
    if text is None:
        return None
    for mode in ("smart", "fully-qualified-except-typing", "fully-qualified"):
        text = text.replace(stringify_annotation(ArrayLike, mode), "ArrayLike")
    return NUMBERS.sub(lambda found: f"NDArray[{found[1].rpartition('.')[2]}]", text)


def rename(*event: Any) -> tuple[str | None, str | None]:
    """Return what stands for the signature of an object and for what it returns."""
    signature, returned = event[-2:]
    return named(signature), named(returned)


def told_apart(lines: list[str]) -> list[str]:
    """Return a docstring with an entry for each attribute of ``a, b : float``, as Napoleon needs.

    Examples
    --------
    >>> told_apart(["Attributes", "----------", "x, y : float [m]", "    Where."])[2:]
    ['x : float [m]', '    Where.', 'y : float [m]', '    Where.']
    """
    found: list[str] = []
    k = 0
    while k < len(lines):
        several = SEVERAL.match(lines[k])
        below = len(lines)
        if several:
            following = range(k + 1, len(lines))
            below = next((j for j in following if lines[j] and lines[j][0] != " "), len(lines))
            names = several["names"].split(", ")
            for name in names:
                found += [f"{name} : {several['kind']}", *lines[k + 1 : below]]
            k = below
        else:
            found.append(lines[k])
            k += 1
    return found


def keep(_: Sphinx, what: str, *event: Any) -> None:
    """Make of a docstring, in place, what Napoleon does not mangle."""
    lines = event[-1]
    if what == "class":
        lines[:] = told_apart(lines)
    elif what in {"attribute", "data", "property"} and lines and ":" in lines[0]:
        lines.insert(0, "")


def setup(app: Sphinx) -> dict[str, bool]:
    """Register with Sphinx."""
    app.connect("autodoc-process-signature", rename)
    app.connect("autodoc-process-docstring", keep, priority=400)  # before Napoleon
    return {"parallel_read_safe": True}
