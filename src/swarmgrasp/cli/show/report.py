"""Text for people: colour and tables on a terminal, plain aligned columns in a pipe."""

import csv
import io
import sys
from collections.abc import Callable, Iterable, Sequence
from contextvars import ContextVar
from dataclasses import dataclass
from itertools import islice
from pathlib import Path
from typing import TYPE_CHECKING, Literal

from swarmgrasp.texts import clean

if TYPE_CHECKING:
    from rich.console import Console

    from swarmgrasp.swarm import Swarm
    from swarmgrasp.telling import Telling

Mood = Literal["", "good", "caution", "bad"]
STYLES: dict[Mood, str] = {
    "": "bold",
    "good": "bold green",
    "caution": "bold yellow",
    "bad": "bold red",
}
GAP = "  "
PERCENT = " %"


def complain(faults: Iterable[str]) -> None:
    """Write faults to standard error, one per line."""
    for fault in faults:
        print(clean(fault), file=sys.stderr)


@dataclass(frozen=True)
class Column:
    """A column of a table.

    Attributes
    ----------
    name : str
        Its heading, with the unit in square brackets.
    is_number : bool
        Numbers stand flush right and never wrap.
    is_spare : bool
        Left out on a terminal too narrow for the whole table.
    """

    name: str
    is_number: bool = False
    is_spare: bool = False


@dataclass(frozen=True)
class Table:
    """A table as it was told.

    Attributes
    ----------
    name : str
        What its rows are.
    columns : sequence of Column
    rows : sequence of sequence of str
    """

    name: str
    columns: Sequence[Column]
    rows: Sequence[Sequence[str]]

    def csv_text(self) -> str:
        r"""Return it with commas between; shares as plain numbers of percent.

        Of headings that are alike the later ones are numbered.

        Examples
        --------
        >>> Table("tugs", [Column("tug"), Column("share")], [["Ajax", "12.3 %"]]).csv_text()
        'tug,share [%]\nAjax,12.3\n'
        >>> Table("winds", [Column("[m/s]"), Column("[m/s]")], [["3", "4"]]).csv_text()
        '[m/s],[m/s] (2)\n3,4\n'
        >>> Table("blanks", [Column("after [s]"), Column("what")], [["", "lost"]]).csv_text()
        'after [s],what\n,lost\n'
        """
        names, cells = [column.name for column in self.columns], [list(row) for row in self.rows]
        for k, name in enumerate(names):
            column = [row[k] for row in cells if row[k]]
            if column and all(cell.endswith(PERCENT) for cell in column):
                names[k] = f"{name} [%]"
                for row in cells:
                    row[k] = row[k].removesuffix(PERCENT)
        names = [
            f"{name} ({names[: k + 1].count(name)})" if name in names[:k] else name
            for k, name in enumerate(names)
        ]
        out = io.StringIO(newline="")
        csv.writer(out, lineterminator="\n").writerows([names, *cells])
        return out.getvalue()


@dataclass(frozen=True)
class Line:
    """A line as it was told.

    Attributes
    ----------
    kind : {"headline", "sentence", "note"}
    text : str
    mood : {"", "good", "caution", "bad"}
    """

    kind: Literal["headline", "sentence", "note"]
    text: str
    mood: Mood = ""


@dataclass(frozen=True)
class Facts:
    """Labelled facts as they were told; an empty label continues the one above.

    Attributes
    ----------
    rows : sequence of tuple of str
    """

    rows: Sequence[tuple[str, str]]


Piece = Line | Facts | Table


@dataclass(frozen=True)
class _Telling:
    """Where goes what is told, and how many rows of a table at most."""

    pieces: list[Piece]
    most: int | None


_TOLD: ContextVar[_Telling | None] = ContextVar("told", default=None)
"""Where goes what is told, if it is not written."""


def told_by(show: Callable[[], None], most: int | None = None) -> list[Piece]:
    """Return what is told, piece by piece, and write nothing.

    Parameters
    ----------
    show : callable
        Tells it.
    most : int, optional
        Rows of each table; the first of more are told, and that they are.

    Examples
    --------
    >>> told_by(lambda: Report().headline("barge: held", "good"))
    [Line(kind='headline', text='barge: held', mood='good')]
    >>> tugs = [["Ajax"], ["Boreas"], ["Castor"]]
    >>> told_by(lambda: Report().table([Column("tug")], tugs, "tugs"), most=2)[1].text
    'The first 2 tugs are listed.'
    """
    told = _Telling([], most)
    token = _TOLD.set(told)
    try:
        show()
    finally:
        _TOLD.reset(token)
    return told.pieces


def tables_of(show: Callable[[], None]) -> list[Table]:
    """Return the tables of what is told, and write nothing.

    Examples
    --------
    >>> found = tables_of(lambda: Report().table([Column("tug")], [["Ajax"]], "tugs"))
    >>> found[0].name, found[0].rows
    ('tugs', [['Ajax']])
    """
    return [piece for piece in told_by(show) if isinstance(piece, Table)]


class Report:
    """Writes to standard output, for a terminal or for a pipe."""

    def __init__(self) -> None:
        self._console: Console | None = None
        self._told = _TOLD.get()
        if self._told is None and sys.stdout.isatty():
            from rich import console

            self._console = console.Console(highlight=False, markup=False, emoji=False)

    def headline(self, text: str, mood: Mood = "") -> None:
        """Write what matters most."""
        self._line(Line("headline", text, mood), STYLES[mood])

    def sentence(self, text: str) -> None:
        """Write a sentence."""
        self._line(Line("sentence", text))

    def note(self, text: str) -> None:
        """Write small print."""
        self._line(Line("note", text), "dim")

    def _line(self, line: Line, style: str = "") -> None:
        """Write a line."""
        if self._told is not None:
            self._told.pieces.append(line)
        elif self._console is None:
            print(clean(line.text))
        else:
            self._console.print(clean(line.text), style=style)

    def blank(self) -> None:
        """Write an empty line."""
        self.sentence("")

    def small_print(self, swarm: "Swarm", tell: "Telling", *notes: str) -> None:
        """Write what the numbers mean, after an empty line."""
        self.blank()
        for note in (metric_note(swarm, tell), *tell.notes(), *notes):
            self.note(note)

    def facts(self, rows: Sequence[tuple[str, str]]) -> None:
        """Write labelled facts; an empty label continues the one above."""
        if self._told is not None:
            self._told.pieces.append(Facts(rows))
            return
        if self._console is None:
            self._write_columns([[label, fact] for label, fact in rows], [False, False])
            return
        from rich.table import Table

        grid = Table.grid(padding=(0, 2))
        grid.add_column(style="cyan", no_wrap=True)
        grid.add_column()
        for label, fact in rows:
            grid.add_row(clean(label), clean(fact))
        self._console.print(grid)

    def table(
        self, columns: Sequence[Column], rows: Iterable[Sequence[str]], name: str = "rows"
    ) -> None:
        """Write a table, whose rows are called by a name."""
        most = None if self._told is None else self._told.most
        going = iter(rows)
        rows = list(islice(going, most))
        if self._told is not None:
            self._told.pieces.append(Table(name, columns, rows))
            if next(going, None) is not None:
                self.note(f"The first {most} {name} are listed.")
            return
        if self._console is None:
            cells = [[column.name for column in columns], *map(list, rows)]
            self._write_columns(cells, [column.is_number for column in columns])
            return
        from rich.table import Table as Grid

        kept = self._fitting(self._console.width, columns, rows)
        table = Grid(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="cyan")
        for index in kept:
            is_number = columns[index].is_number
            table.add_column(
                columns[index].name, justify="right" if is_number else "left", no_wrap=is_number
            )
        for row in rows:
            table.add_row(*(clean(row[index]) for index in kept))
        self._console.print(table)
        if len(kept) < len(columns):
            left = ", ".join(c.name for i, c in enumerate(columns) if i not in kept)
            self.note(f"A wider terminal, or a pipe, also shows: {left}.")

    @staticmethod
    def _fitting(room: int, columns: Sequence[Column], rows: Sequence[Sequence[str]]) -> list[int]:
        """Return the columns to show in a number of characters.

        Spare ones go, last first; then numbers, first first, y with x; never the names.
        """
        cells = [[column.name for column in columns], *rows]
        widths = [max(map(len, column)) + len(GAP) for column in zip(*cells, strict=True)]
        kept = list(range(len(columns)))
        spare = [index for index in reversed(kept) if columns[index].is_spare]
        numbers = [index for index in kept if columns[index].is_number and index not in spare]
        for index in spare + numbers:
            x_is_gone = columns[index].name.startswith("y [") and index - 1 not in kept
            if x_is_gone or sum(widths[i] for i in kept) - len(GAP) > room:
                kept.remove(index)
        return kept

    def _write_columns(self, rows: Sequence[Sequence[str]], is_number: Sequence[bool]) -> None:
        """Write rows as aligned columns, as wide as they need to be."""
        tidy = [[clean(cell) for cell in row] for row in rows]
        widths = [max(map(len, column)) for column in zip(*tidy, strict=True)]
        for row in tidy:
            cells = [
                cell.rjust(width) if right else cell.ljust(width)
                for cell, width, right in zip(row, widths, is_number, strict=True)
            ]
            print(GAP.join(cells).rstrip())


def metric_note(swarm: "Swarm", tell: "Telling") -> str:
    """Say by what metric wrenches are compared."""
    return metric_words(swarm.force_weights, swarm.characteristic_length, tell)


def metric_words(weights: Sequence[float], length: float, tell: "Telling") -> str:
    """Say by what metric wrenches are compared, of its force weights and its length [m]."""
    a1, a2 = weights
    from swarmgrasp.words import trimmed

    told = f"{trimmed(length / tell.length.metres, 6)} {tell.length.name}"
    return f"Metric: force weights {a1:g} and {a2:g}, characteristic length {told}."


def told_written(paths: Iterable[str | Path], *, aside: bool = False) -> None:
    """Say which files were written.

    Parameters
    ----------
    paths : iterable of str or Path
    aside : bool
        On standard error, because standard output holds data.
    """
    for path in paths:
        print(f"wrote {clean(str(path))}", file=sys.stderr if aside else sys.stdout)
