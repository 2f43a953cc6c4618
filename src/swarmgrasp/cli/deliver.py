"""How a command hands over its answer: as JSON, as pictures, and in words."""

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from swarmgrasp.cli.dash import DASH
from swarmgrasp.cli.inputs import print_json
from swarmgrasp.cli.show.report import tables_of, told_written


def deliver(
    json: str | None,
    document: dict[str, Any],
    show: Callable[[], None],
    draw: Callable[[], Iterable[str | Path]] = tuple,
    *,
    csv: str | None = None,
) -> None:
    """Write an answer where it is wanted, and tell it unless its JSON or a table is printed.

    Files come first: whoever reads the report may leave before its end.

    Parameters
    ----------
    json : str or None
        Where the document goes: to a file, or "-" to print it and nothing else.
    document : dict
    show : callable
        Tells the answer.
    draw : callable
        Writes other files; returns their paths.
    csv : str or None
        Where the tables of the answer go; "-" prints the first and nothing else.
    """
    from swarmgrasp.answer_file import document_text
    from swarmgrasp.files import write_whole

    text, written = document_text(document), list[str | Path]()
    if json not in (None, DASH):
        write_whole(str(json), text.encode())
        written.append(str(json))
    written += draw()
    if json == DASH:
        written += write_tables(csv, show)
        print_json(text)
        told_written(written, aside=True)
    else:
        tell(show, written, csv=csv)


def tell(show: Callable[[], None], written: Iterable[str | Path], *, csv: str | None) -> None:
    """Tell an answer, or print its first table, and then which files were written.

    Parameters
    ----------
    show : callable
    written : iterable of str or Path
        Those written before.
    csv : str or None
        As for `deliver`.
    """
    written = [*written, *write_tables(csv, show)]
    if csv == DASH:
        for table in tables_of(show)[:1]:
            print_json(table.csv_text())
    else:
        show()
    told_written(written, aside=csv == DASH)


def write_tables(csv: str | None, show: Callable[[], None]) -> list[Path]:
    """Write the tables of an answer, if they go to files: the first, and others named beside it."""
    from swarmgrasp.files import write_whole

    if csv in (None, DASH):
        return []
    path, written = Path(str(csv)), dict[Path, str]()
    for table in tables_of(show):
        beside = path.with_name(f"{path.stem}-{table.name.replace(' ', '-')}{path.suffix}")
        written[beside if written else path] = table.csv_text()
    for each, text in written.items():
        write_whole(str(each), text.encode())
    return list(written)
