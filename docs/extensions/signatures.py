"""Signatures with the names that the sources have: an array, and not what NumPy makes of it."""

import re
from typing import Any

from numpy.typing import ArrayLike
from sphinx.application import Sphinx
from sphinx.util.typing import stringify_annotation

NUMBERS = re.compile(
    r"~?(?:numpy\.)?ndarray\[\S*?tuple\[~?(?:typing\.)?Any, \.\.\.\], \S*?dtype\[([^\]]*)\]\]"
)


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


def setup(app: Sphinx) -> dict[str, bool]:
    """Register with Sphinx."""
    app.connect("autodoc-process-signature", rename)
    return {"parallel_read_safe": True}
