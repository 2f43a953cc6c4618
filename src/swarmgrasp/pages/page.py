"""The report as blocks, and as Markdown or as one HTML page."""

import base64
import html
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field

from matplotlib.figure import Figure

from swarmgrasp.pages.statements import Statement

HOLDS, FAILS = "✓", "✗ not so in this run:"
STYLE = """
body { font: 16px/1.5 system-ui, sans-serif; color: #222; max-width: 46em; margin: 2em auto;
  padding: 0 1em; }
h1, h2 { line-height: 1.2; } h2 { margin-top: 2em; border-top: 1px solid #ddd; padding-top: 1em; }
figure { margin: 1.5em 0; } img { max-width: 100%; height: auto; }
figcaption, footer { color: #6e6e6e; font-size: 0.9em; }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-size: 0.85em; }
th, td { border-bottom: 1px solid #ddd; padding: 0.3em 0.7em; text-align: right;
  vertical-align: top; }
th:first-child, td:first-child, .words th, .words td { text-align: left; }
ul { list-style: none; padding-left: 0; } li { padding-left: 1.6em; text-indent: -1.6em;
  margin: 0.4em 0; }
li b { display: inline-block; min-width: 1.6em; text-indent: 0; color: #009e73; }
li.fails b { color: #d55e00; }
@media print { figure, tr, li { break-inside: avoid; } }
"""


@dataclass(frozen=True)
class Heading:
    """A heading; the first of a page is its title."""

    text: str
    level: int = 2

    def markdown(self) -> str:
        """Return it as Markdown."""
        return f"{'#' * self.level} {_escaped(self.text)}"

    def html(self) -> str:
        """Return it as HTML."""
        return f"<h{self.level}>{html.escape(self.text)}</h{self.level}>"


@dataclass(frozen=True)
class Paragraph:
    """Plain text."""

    text: str

    def markdown(self) -> str:
        """Return it as Markdown."""
        return _escaped(self.text)

    def html(self) -> str:
        """Return it as HTML."""
        return f"<p>{html.escape(self.text)}</p>"


@dataclass(frozen=True)
class Findings:
    """Statements, each with the mark of its check."""

    statements: Sequence[Statement]

    def markdown(self) -> str:
        """Return them as Markdown."""
        return "\n".join(f"- {_mark(s)} {_escaped(s.text)}" for s in self.statements)

    def html(self) -> str:
        """Return them as HTML."""
        rows = [
            f'<li class="{"holds" if one.holds else "fails"}"><b>{_mark(one)}</b> '
            f"{html.escape(one.text)}</li>"
            for one in self.statements
        ]
        return "\n".join(["<ul>", *rows, "</ul>"])


@dataclass(frozen=True)
class Table:
    """A table, of numbers but for its first column, or of words."""

    heads: Sequence[str]
    rows: Sequence[Sequence[str]]
    of_words: bool = False

    def markdown(self) -> str:
        """Return it as Markdown."""
        marks = ["---"] + ["---" if self.of_words else "---:"] * (len(self.heads) - 1)
        body = [[_escaped(cell).replace("|", "\\|") for cell in row] for row in self.rows]
        return "\n".join("| " + " | ".join(row) + " |" for row in (self.heads, marks, *body))

    def html(self) -> str:
        """Return it as HTML."""
        head = "".join(f"<th>{html.escape(cell)}</th>" for cell in self.heads)
        rows = [
            "<tr>" + "".join(f"<td>{html.escape(cell)}</td>" for cell in row) + "</tr>"
            for row in self.rows
        ]
        kind = ' class="words"' if self.of_words else ""
        lines = f'<div class="wide"><table{kind}>', f"<tr>{head}</tr>", *rows, "</table></div>"
        return "\n".join(lines)


@dataclass(frozen=True, eq=False)
class Picture:
    """A figure, the name of its file, and what it shows."""

    name: str
    figure: Figure = field(repr=False)
    caption: str

    def markdown(self) -> str:
        """Return it as Markdown, as a file beside the page."""
        return f"![{_escaped(self.caption)}]({self.name})\n\n{_escaped(self.caption)}"

    def html(self, content: bytes) -> str:
        """Return it as HTML with its PNG inside."""
        data = base64.b64encode(content).decode()
        caption = html.escape(self.caption)
        image = f'<img src="data:image/png;base64,{data}" alt="{caption}">'
        return f"<figure>{image}<figcaption>{caption}</figcaption></figure>"


Block = Heading | Paragraph | Findings | Table | Picture


def markdown(blocks: Sequence[Block]) -> str:
    """Return a page as Markdown; its pictures are files beside it."""
    return "\n\n".join(block.markdown() for block in blocks) + "\n"


def html_page(title: str, blocks: Sequence[Block], pictures: Mapping[str, bytes]) -> str:
    """Return a page as HTML that needs no other file.

    Parameters
    ----------
    title : str
    blocks : sequence of Block
    pictures : mapping of str to bytes
        The PNG of each picture, by name.
    """
    body = [b.html(pictures[b.name]) if isinstance(b, Picture) else b.html() for b in blocks]
    head = (
        '<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
        '<meta name="viewport" content="width=device-width, initial-scale=1">'
        f"<title>{html.escape(title)}</title><style>{STYLE}</style></head><body>"
    )
    return "\n".join([head, *body, "</body></html>"]) + "\n"


def _mark(statement: Statement) -> str:
    """Return the mark of a statement's check."""
    return HOLDS if statement.holds else FAILS


def _escaped(text: str) -> str:
    """Return text without what Markdown would take for markup."""
    return text.replace("<", "&lt;").replace("*", "\\*").replace("_", "\\_")
