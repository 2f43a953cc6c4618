"""A page with its pictures, written into a folder: all of it or nothing."""

import tempfile
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path

from swarmgrasp.pages.page import Block, Picture, html_page, markdown
from swarmgrasp.pages.statements import Statement
from swarmgrasp.plot import save


@dataclass(frozen=True)
class Report:
    """What was written, and what it says.

    Attributes
    ----------
    paths : tuple of Path
        The page as HTML, the same as Markdown, and its pictures.
    statements : tuple of Statement
    """

    paths: tuple[Path, ...]
    statements: tuple[Statement, ...]

    @property
    def failed(self) -> tuple[Statement, ...]:
        """The statements that do not hold in this run."""
        return tuple(one for one in self.statements if not one.holds)


def write(
    folder: Path,
    name: str,
    title: str,
    blocks: Sequence[Block],
    statements: Sequence[Statement],
    drawn: Callable[[], object],
) -> Report:
    """Write a page as HTML and as Markdown, and its pictures.

    Parameters
    ----------
    folder : Path
        Created if need be. Files of an earlier page in it are replaced; all appear at the end,
        or none.
    name : str
        Of the two files, before the suffix.
    title : str
    blocks : sequence of Block
    statements : sequence of Statement
        All that it states.
    drawn : callable
        Called after each picture.

    Raises
    ------
    OSError
        If the folder cannot be written to.
    """
    folder.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix=f".{name}-", dir=folder) as scratch:
        names = _draft(Path(scratch), name, title, blocks, drawn)
        for each in names:
            (Path(scratch) / each).replace(folder / each)
    return Report(tuple(folder / each for each in names), tuple(statements))


def _draft(
    scratch: Path, name: str, title: str, blocks: Sequence[Block], drawn: Callable[[], object]
) -> list[str]:
    """Write all files to a scratch folder; return their names."""
    contents = {}
    for block in blocks:
        if isinstance(block, Picture):
            contents[block.name] = save(block.figure, scratch / block.name).read_bytes()
            drawn()
    page, text = f"{name}.html", f"{name}.md"
    (scratch / page).write_text(html_page(title, blocks, contents), encoding="utf-8")
    (scratch / text).write_text(markdown(blocks), encoding="utf-8")
    return [page, text, *contents]
