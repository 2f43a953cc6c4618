"""A sheet: what it holds, in which order, as one page of HTML or as Markdown."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

from swarmgrasp.pages.page import (
    Block,
    Drawing,
    Facts,
    Heading,
    Paragraph,
    Points,
    Table,
    html_page,
    markdown,
)

SIGNERS = ("Prepared by", "Checked by", "Approved by")


@dataclass(frozen=True)
class Section:
    """A part of a sheet.

    Attributes
    ----------
    title : str
    blocks : sequence of Block
    lead : str
        What it comes to, in a sentence; empty if it comes to nothing.
    """

    title: str
    blocks: Sequence[Block]
    lead: str = ""


@dataclass(frozen=True)
class Origin:
    """Where the numbers of a sheet come from.

    Attributes
    ----------
    version : str
        Of the program.
    date : str
        When the answer was found.
    source : str
        The file's name.
    file_digest : str
        SHA-256 of the file's bytes; empty of what was no file.
    question_digest : str
        SHA-256 of all that was asked, in SI units, what the file imports included.
    """

    version: str
    date: str
    source: str
    file_digest: str
    question_digest: str

    def facts(self) -> Facts:
        """Return it as labelled facts."""
        rows = [
            ("Program", f"swarmgrasp {self.version}"),
            ("Date of the answer", self.date),
            ("Input", self.source),
            ("SHA-256 of the input", self.file_digest),
            ("SHA-256 of the question", self.question_digest),
        ]
        return Facts([row for row in rows if row[1]])


@dataclass(frozen=True)
class Sheet:
    """One sheet about one job.

    Attributes
    ----------
    title, description : str
    sections : sequence of Section
    origin : Origin
    """

    title: str
    description: str
    sections: Sequence[Section]
    origin: Origin

    def blocks(self) -> list[Block]:
        """Return all of it, from the title to the lines for signatures."""
        opening: list[Block] = [Heading(self.title, 1)]
        if self.description:
            opening.append(Paragraph(self.description))
        if leads := [section.lead for section in self.sections if section.lead]:
            opening.append(Points(leads))
        for section in self.sections:
            opening += [Heading(section.title), *section.blocks]
        blanks = [[signer, "", "", ""] for signer in SIGNERS]
        return [
            *opening,
            Heading("Origin"),
            self.origin.facts(),
            Heading("Signatures"),
            Table(["", "Name", "Date", "Signature"], blanks, numbers=(), is_blank=True),
        ]

    def named(self, stem: str) -> "Sheet":
        """Return the sheet with the files of its drawings named after it."""

        def after(block: Block) -> Block:
            """Return a block, named so if it is a drawing."""
            if isinstance(block, Drawing):
                return replace(block, name=f"{stem}-{block.name}")
            return block

        sections = [replace(s, blocks=[*map(after, s.blocks)]) for s in self.sections]
        return replace(self, sections=sections)

    def html(self) -> str:
        """Return it as one page that needs no other file, no script and no network."""
        return html_page(self.title, self.blocks(), {})

    def markdown(self) -> str:
        """Return it as Markdown, whose drawings are files beside it."""
        return markdown(self.blocks())

    def drawings(self) -> dict[str, str]:
        """Return the SVG of each drawing, by the name of its file."""
        return {b.name: b.svg for b in self.blocks() if isinstance(b, Drawing)}
