"""A page as blocks, and as Markdown or as one HTML page."""

import base64
import html
import re
from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Literal

from matplotlib.figure import Figure

from swarmgrasp.pages.statements import Statement
from swarmgrasp.texts import clean

HOLDS, FAILS = "✓", "✗ not so in this run:"
MOST_WHOLE = 20
"""Rows up to which a table is not broken across printed pages."""
STYLE = """
:root { color-scheme: light dark; --ink: #222; --soft: #6e6e6e; --line: #ddd; --paper: #fff;
  --good: #00775a; --caution: #8a5a00; --bad: #b34700; --link: #0060a8; }
@media screen and (prefers-color-scheme: dark) { :root { --ink: #e4e4e4; --soft: #a2a2a2;
  --line: #454545; --paper: #181a1c; --good: #4cc9a4; --caution: #e8b04a; --bad: #ff9a5c;
  --link: #7cc0ff; } }
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper);
  max-width: 46em; margin: 2em auto; padding: 0 1em; overflow-wrap: break-word; }
h1, h2, h3 { line-height: 1.2; } a { color: var(--link); }
h2 { margin-top: 2em; border-top: 1px solid var(--line); padding-top: 1em; }
h3 { font-size: 1em; margin: 1.5em 0 0.5em; }
figure { margin: 1.5em 0; } img, svg { max-width: 100%; height: auto; }
figure svg { background: #fff; }
figcaption, footer, .note { color: var(--soft); font-size: 0.9em; }
.note { margin: 0.4em 0; }
.strong { font-weight: 600; } .good { color: var(--good); } .caution { color: var(--caution); }
.bad { color: var(--bad); }
.wide { overflow-x: auto; } table { border-collapse: collapse; font-size: 0.85em;
  margin: 0.8em 0; }
th, td { border-bottom: 1px solid var(--line); padding: 0.3em 0.7em; text-align: left;
  vertical-align: top; }
th.number, td.number { text-align: right; font-variant-numeric: tabular-nums; }
td.number { white-space: nowrap; }
.facts th { font-weight: 600; white-space: nowrap; } .facts th, .facts td { border: 0;
  padding: 0.15em 1em 0.15em 0; }
.blanks { width: 100%; } .blanks td { height: 2.6em; }
.checks { list-style: none; padding-left: 0; } .checks li { padding-left: 1.6em;
  text-indent: -1.6em; }
li { margin: 0.4em 0; }
li b { display: inline-block; min-width: 1.6em; text-indent: 0; color: var(--good); }
li.fails b { color: var(--bad); }
@page { size: A4; margin: 16mm 15mm; }
@media print { body { font-size: 10pt; max-width: none; margin: 0; padding: 0; }
  .wide { overflow: visible; } h1, h2, h3, p.strong { break-after: avoid; }
  h2 { margin-top: 1.2em; padding-top: 0.6em; } thead { display: table-header-group; }
  figure, tr, li, .whole { break-inside: avoid; } }
"""

PART = """
.swarmgrasp figure { margin: 0.6em 0; } .swarmgrasp svg { max-width: 100%; height: auto;
  background: #fff; }
.swarmgrasp .strong { font-weight: 600; } .swarmgrasp .note { opacity: 0.75; margin: 0.2em 0; }
.swarmgrasp .wide { overflow-x: auto; }
.swarmgrasp th, .swarmgrasp td { text-align: left; vertical-align: top; padding: 0.15em 0.9em
  0.15em 0; }
.swarmgrasp .facts th { white-space: nowrap; }
.swarmgrasp th.number, .swarmgrasp td.number { text-align: right; white-space: nowrap; }
"""
"""Of what stands on a page of others, whose colours and type it takes."""


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
    """Plain text: as it is, in a colour that says how good it is to hear, or as small print."""

    text: str
    tone: Literal["", "strong", "good", "caution", "bad", "note"] = ""

    def markdown(self) -> str:
        """Return it as Markdown."""
        mark = {"": "", "note": "*"}.get(self.tone, "**")
        return f"{mark}{_escaped(self.text)}{mark}"

    def html(self) -> str:
        """Return it as HTML."""
        strong = "" if self.tone in ("", "strong", "note") else "strong "
        kind = f' class="{strong}{self.tone}"' if self.tone else ""
        return f"<p{kind}>{_safe(self.text)}</p>"


@dataclass(frozen=True)
class Points:
    """Sentences, each with a mark before it."""

    sentences: Sequence[str]

    def markdown(self) -> str:
        """Return them as Markdown."""
        return "\n".join(f"- {_escaped(sentence)}" for sentence in self.sentences)

    def html(self) -> str:
        """Return them as HTML."""
        return "\n".join(["<ul>", *(f"<li>{_safe(each)}</li>" for each in self.sentences), "</ul>"])


@dataclass(frozen=True)
class Facts:
    """Labelled facts; an empty label continues the one above."""

    rows: Sequence[tuple[str, str]]

    def markdown(self) -> str:
        """Return them as Markdown."""
        body = [f"| {_cell(label)} | {_cell(fact)} |" for label, fact in self.rows]
        return "\n".join(["| | |", "| --- | --- |", *body])

    def html(self) -> str:
        """Return them as HTML."""
        rows = [
            f'<tr><th scope="row">{_safe(label)}</th><td>{_safe(fact)}</td></tr>'
            for label, fact in self.rows
        ]
        return "\n".join(['<table class="facts whole"><tbody>', *rows, "</tbody></table>"])


@dataclass(frozen=True)
class Findings:
    """Statements, each with the mark of its check."""

    statements: Sequence[Statement]

    def markdown(self) -> str:
        """Return them as Markdown."""
        links = (" ".join(f"[{label}](#{label})" for label in s.rests_on) for s in self.statements)
        rows = zip(self.statements, links, strict=True)
        return "\n".join(f"- {_mark(s)} {_escaped(s.text)} {link}".rstrip() for s, link in rows)

    def html(self) -> str:
        """Return them as HTML."""
        rows = [
            f'<li class="{"holds" if one.holds else "fails"}"><b>{_mark(one)}</b> '
            f"{_safe(one.text)}{''.join(map(_link, one.rests_on))}</li>"
            for one in self.statements
        ]
        return "\n".join(['<ul class="checks">', *rows, "</ul>"])


@dataclass(frozen=True)
class Labelled:
    """Sentences with labels that statements of the page lead to."""

    sentences: Mapping[str, str]

    def markdown(self) -> str:
        """Return them as Markdown."""
        rows = self.sentences.items()
        return "\n\n".join(f'<a id="{label}"></a>**({label})** {_escaped(s)}' for label, s in rows)

    def html(self) -> str:
        """Return them as HTML."""
        rows = self.sentences.items()
        return "\n".join(f'<p id="{label}"><b>({label})</b> {_safe(s)}</p>' for label, s in rows)


@dataclass(frozen=True)
class Table:
    """A table.

    Attributes
    ----------
    heads : sequence of str
    rows : sequence of sequence of str
    numbers : collection of int, optional
        The columns of numbers; all but the first when left out.
    is_blank : bool
        Whether its cells are to be filled in by hand.
    """

    heads: Sequence[str]
    rows: Sequence[Sequence[str]]
    numbers: Collection[int] | None = None
    is_blank: bool = False

    def _is_number(self, column: int) -> bool:
        """Tell whether a column is of numbers."""
        return column > 0 if self.numbers is None else column in self.numbers

    def markdown(self) -> str:
        """Return it as Markdown."""
        marks = ["---:" if self._is_number(k) else "---" for k in range(len(self.heads))]
        cells = [[_cell(cell) for cell in row] for row in (self.heads, *self.rows)]
        return "\n".join("| " + " | ".join(row) + " |" for row in (cells[0], marks, *cells[1:]))

    def html(self) -> str:
        """Return it as HTML."""
        kind = ("blanks " * self.is_blank) + ("whole" * (len(self.rows) <= MOST_WHOLE))
        kind = f' class="{kind.strip()}"' if kind else ""
        rows = [self._row("td", row) for row in self.rows]
        return "\n".join([
            f'<div class="wide"><table{kind}><thead>', self._row("th", self.heads),
            "</thead><tbody>", *rows, "</tbody></table></div>",
        ])  # fmt: skip

    def _row(self, tag: str, cells: Sequence[str]) -> str:
        """Return a row as HTML."""
        kinds = [' class="number"' if self._is_number(k) else "" for k in range(len(cells))]
        told = zip(kinds, cells, strict=True)
        return "<tr>" + "".join(f"<{tag}{k}>{_safe(c)}</{tag}>" for k, c in told) + "</tr>"


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
        caption = _safe(self.caption)
        image = f'<img src="data:image/png;base64,{data}" alt="{caption}">'
        return f"<figure>{image}<figcaption>{caption}</figcaption></figure>"


@dataclass(frozen=True)
class Drawing:
    """A picture as SVG, the name of its file beside Markdown, and what it shows."""

    name: str
    svg: str = field(repr=False)
    caption: str

    def markdown(self) -> str:
        """Return it as Markdown, as a file beside the page."""
        return f"![{_escaped(self.caption)}]({self.name})\n\n{_escaped(self.caption)}"

    def html(self) -> str:
        """Return it as HTML with its SVG inside."""
        below = f"<figcaption>{_safe(self.caption)}</figcaption>" if self.caption else ""
        return f"<figure>{self.svg}{below}</figure>"


Part = Heading | Paragraph | Points | Facts | Findings | Labelled | Table | Drawing
"""What is whole in itself."""
Block = Part | Picture


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
        f"<title>{_safe(title)}</title><style>{STYLE}</style></head><body>"
    )
    return "\n".join([head, *body, "</body></html>"]) + "\n"


def html_part(blocks: Sequence[Part]) -> str:
    """Return blocks as HTML that can stand on a page of others."""
    body = (block.html() for block in blocks)
    return "\n".join(['<div class="swarmgrasp">', f"<style>{PART}</style>", *body, "</div>"])


def _link(label: str) -> str:
    """Return a link to what has a label."""
    return f' <a href="#{label}">{label}</a>'


def _mark(statement: Statement) -> str:
    """Return the mark of a statement's check."""
    return HOLDS if statement.holds else FAILS


def _safe(text: str) -> str:
    """Return text without what HTML would take for markup."""
    return html.escape(clean(text))


_MARKUP = re.compile(r"([\\`*_\[\]|~$])")
"""What Markdown takes for markup within a line."""
_BLOCK = re.compile(r"^(\s*)([#+>-]|\d+(?=[.)]))")
"""What Markdown takes for a heading, a list or a quotation at the beginning of a line."""


def _escaped(text: str) -> str:
    r"""Return text without what Markdown would take for markup.

    Examples
    --------
    >>> print(_escaped("# a*b_c <i> & [x](y)"))
    \# a\*b\_c &lt;i> &amp; \[x\](y)
    """
    return _BLOCK.sub(lambda found: _item(found[1], found[2]), _cell(text))


def _item(space: str, mark: str) -> str:
    """Return the mark of a heading, a list or a quotation as text."""
    return f"{space}&#{ord(mark[0])};{mark[1:]}" if mark[0].isdigit() else f"{space}\\{mark}"


def _cell(text: str) -> str:
    """Return text without what Markdown would take for markup within a line."""
    return _MARKUP.sub(r"\\\1", clean(text).replace("&", "&amp;").replace("<", "&lt;"))
