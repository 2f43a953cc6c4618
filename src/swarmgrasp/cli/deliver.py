"""How a command hands over its answer: as JSON, as pictures, and in words."""

from collections.abc import Callable, Iterable
from pathlib import Path
from typing import Any

from swarmgrasp.cli.dash import DASH
from swarmgrasp.cli.inputs import print_json
from swarmgrasp.cli.show.report import told_written


def deliver(
    json: str | None,
    document: dict[str, Any],
    show: Callable[[], None],
    draw: Callable[[], Iterable[str | Path]] = tuple,
    *,
    aside: bool = False,
) -> None:
    """Write an answer where it is wanted, and tell it unless its JSON is printed.

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
    aside : bool
        Whether standard output is for something else than words.
    """
    from swarmgrasp.answer_file import document_text
    from swarmgrasp.files import write_whole

    text, written = document_text(document), list[str | Path]()
    if json not in (None, DASH):
        write_whole(str(json), text.encode())
        written.append(str(json))
    written += draw()
    if json == DASH:
        print_json(text)
    else:
        show()
    told_written(written, aside=aside or json == DASH)
