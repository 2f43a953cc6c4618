"""Signatures and attributes with the names that the sources have.

An array is named as such, and not as what NumPy makes of it; of attributes that are told in one
line, each is listed; and a property whose sentence has a colon keeps it.
"""

import re
from inspect import getdoc
from itertools import takewhile
from typing import Any

from numpy.typing import ArrayLike
from sphinx.addnodes import desc_signature
from sphinx.application import Sphinx
from sphinx.domains.python import PyAttribute, PyProperty
from sphinx.domains.python._object import PyObject
from sphinx.util.typing import stringify_annotation

NUMBERS = re.compile(
    r"~?(?:numpy\.)?ndarray\[\S*?tuple\[~?(?:typing\.)?Any, \.\.\.\], \S*?dtype\[([^\]]*)\]\]"
)
SEVERAL = re.compile(r"(?P<names>\w+(?:, \w+)+) : (?P<kind>.*)$")
"""Attributes, and what each of them is."""
SHAPED = re.compile(r"(\([^)]*\)|float|int|tuple of \w+)( \[[^]]*\])?:")
"""The shape or the kind, and the unit, with which a docstring begins."""
COLON = "\uf8ff"  # of nobody's use


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
    rest = list(lines)
    while rest:
        line, *rest = rest
        several = SEVERAL.match(line)
        if several is None:
            found.append(line)
            continue
        told = list(takewhile(lambda below: not below or below[0] == " ", rest))
        rest = rest[len(told) :]
        for name in several["names"].split(", "):
            found += [f"{name} : {several['kind']}", *told]
    return found


def keep(_: Sphinx, what: str, *event: Any) -> None:
    """Make of a docstring, in place, what Napoleon does not mangle."""
    lines = event[-1]
    if what == "class":
        lines[:] = told_apart(lines)
    elif what in {"attribute", "data", "property"} and lines and not SHAPED.match(lines[0]):
        lines[0] = lines[0].replace(":", COLON)


def restore(_: Sphinx, __: str, *event: Any) -> None:
    """Give a docstring its colons back, in place."""
    lines = event[-1]
    lines[:] = [line.replace(COLON, ":") for line in lines]


def is_alias(_: Sphinx, __: str, ___: str, shown: object, ____: bool, _____: Any) -> bool | None:
    """Tell that a field of a named tuple is told with its class, and not once more."""
    return True if (getdoc(shown) or "").startswith("Alias for field number") else None


class _Named(PyObject):
    """What has a type, with the names that the sources have."""

    def handle_signature(self, sig: str, signode: desc_signature) -> tuple[str, str]:
        """Name the type before it is written."""
        if "type" in self.options:
            self.options["type"] = named(self.options["type"])
        return super().handle_signature(sig, signode)


class Property(_Named, PyProperty):
    """A property."""


class Attribute(_Named, PyAttribute):
    """An attribute."""


def setup(app: Sphinx) -> dict[str, bool]:
    """Register with Sphinx."""
    app.connect("autodoc-process-signature", rename)
    app.connect("autodoc-process-docstring", keep, priority=400)  # before Napoleon
    app.connect("autodoc-process-docstring", restore, priority=600)
    app.connect("autodoc-skip-member", is_alias)
    app.add_directive_to_domain("py", "property", Property, override=True)
    app.add_directive_to_domain("py", "attribute", Attribute, override=True)
    return {"parallel_read_safe": True}
