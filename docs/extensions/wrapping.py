"""Long sentences that commands print, in lines as on a terminal; tables stay, and scroll."""

import re
import textwrap
from typing import Any

from docutils import nodes
from sphinx.application import Sphinx
from sphinx.transforms import SphinxTransform

WIDTH = 103
"""Letters of code in a line of a page."""
KINDS = {"console", "text"}


def wrapped(line: str) -> str:
    """Return a line of sentences in lines that fit, further ones below the first word.

    Examples
    --------
    >>> print(wrapped("Weakest   " + "turning to port " * 7))
    Weakest   turning to port turning to port turning to port turning to port turning to port turning to
              port turning to port
    >>> wrapped("Ajax  1.0  " + "2.0  " * 30) == "Ajax  1.0  " + "2.0  " * 30
    True
    """  # noqa: E501
    gaps = [gap.end() for gap in re.finditer(r"(?<=\S) {2,}(?=\S)", line)]
    if len(line) <= WIDTH or len(gaps) > 1 or line.startswith("$ "):
        return line
    indent = gaps[0] if gaps else len(line) - len(line.lstrip())
    start, said = line[:indent], line[indent:]
    rows = textwrap.wrap(said, WIDTH - indent, break_long_words=False, break_on_hyphens=False)
    return "\n".join([start + rows[0], *(" " * indent + row for row in rows[1:])])


class Wrap(SphinxTransform):
    """Wrap what commands print."""

    default_priority = 300

    def apply(self, **_: Any) -> None:
        """Go through the blocks of a page."""
        for block in self.document.findall(nodes.literal_block):
            if block.get("language") in KINDS:
                text = "\n".join(map(wrapped, block.astext().split("\n")))
                block.children = [nodes.Text(text)]
                block.rawsource = text


def setup(app: Sphinx) -> dict[str, bool]:
    """Register with Sphinx."""
    app.add_transform(Wrap)
    return {"parallel_read_safe": True}
