"""What commands tell, as parts of a sheet: the same words, tables and numbers."""

from collections.abc import Callable, Sequence

from swarmgrasp.cli.show.report import Facts, Line, Piece, Table, told_by
from swarmgrasp.pages import page
from swarmgrasp.report import Section


def section(title: str, show: Callable[[], None], *drawings: page.Drawing) -> Section:
    """Return what is told as a section of a sheet, with drawings below its first line.

    Parameters
    ----------
    title : str
    show : callable
        Tells it.
    *drawings : Drawing
    """
    first, *rest = without_blanks(told_by(show))
    lead = first.text if isinstance(first, Line) else ""
    return Section(title, [block(first, True), *drawings, *map(block, rest)], lead)


def without_blanks(pieces: Sequence[Piece]) -> list[Piece]:
    """Return what is told without its empty lines."""
    return [piece for piece in pieces if piece != Line("sentence", "")]


def block(piece: Piece, is_first: bool = False) -> page.Part:
    """Return a piece of what is told as a block of a page."""
    if isinstance(piece, Facts):
        return page.Facts(piece.rows)
    if isinstance(piece, Table):
        numbers = [k for k, column in enumerate(piece.columns) if column.is_number]
        return page.Table([column.name for column in piece.columns], piece.rows, numbers)
    if piece.kind == "headline":
        tone = piece.mood or "strong"
        return page.Paragraph(piece.text, tone) if is_first else page.Heading(piece.text, 3)
    return page.Paragraph(piece.text, "note" if piece.kind == "note" else "")
