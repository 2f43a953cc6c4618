"""Writing files whole or not at all, and reading them within bounds."""

import os
import secrets
from collections.abc import Iterator, Mapping
from contextlib import ExitStack, contextmanager
from pathlib import Path

NO_FILE = "there is no such file"
MOST_DEPTH = 20
"""Levels of nesting that are read; a scenario needs 5, an answer 8."""


def read_fault(path: str | Path, error: OSError) -> str:
    """Return the sentence for a file that cannot be read.

    Examples
    --------
    >>> read_fault("a.yaml", IsADirectoryError())
    'a.yaml: is a folder; give a file in it'
    """
    if isinstance(error, FileNotFoundError):
        return f"{path}: {NO_FILE}"
    if isinstance(error, IsADirectoryError):
        return f"{path}: is a folder; give a file in it"
    return f"{path}: cannot be read: {error.strerror or error}"


def target_faults(target: Path) -> list[str]:
    """Return what is wrong with where a file is to be written."""
    if target.is_dir():
        return [f"{target}: is a folder; give a file in it"]
    if not target.parent.is_dir():
        return [f"{target}: there is no folder {target.parent}; create it first"]
    return folder_faults(target.parent)


def folder_faults(folder: Path) -> list[str]:
    """Return what is wrong with a folder to write to, which is created if need be."""
    there = next(path for path in (folder, *folder.absolute().parents) if os.path.lexists(path))
    if not there.is_dir():
        return [f"{there}: is no folder; choose another"]
    if not os.access(there, os.W_OK | os.X_OK):
        return [f"{there}: the folder may not be written to; choose another"]
    return []


@contextmanager
def scratch_for(target: Path) -> Iterator[Path]:
    """Offer a path beside a target; what is written there takes the target's place at the end.

    If the block raises, nothing is left behind and the target stays as it was. An `OSError` names
    the target.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> with TemporaryDirectory() as folder:
    ...     target = Path(folder) / "answer.txt"
    ...     with scratch_for(target) as scratch:
    ...         _ = scratch.write_text("42")
    ...     target.read_text(), len(list(Path(folder).iterdir()))
    ('42', 1)
    """
    scratch = target.with_name(f".{target.stem}-{secrets.token_hex(6)}{target.suffix}")
    try:
        yield scratch
        scratch.replace(target)
    except OSError as error:
        if error.filename not in (None, str(scratch), scratch):
            raise
        said = os.strerror(error.errno) if error.errno else str(error)
        raise OSError(error.errno, said, str(target)) from None
    finally:
        scratch.unlink(missing_ok=True)


def write_together(contents: Mapping[Path, bytes]) -> None:
    """Write several files: if one cannot be written, none takes its place."""
    with ExitStack() as all_of_them:
        for target, content in contents.items():
            all_of_them.enter_context(scratch_for(target)).write_bytes(content)


def write_whole(path: str | Path, content: bytes, *, durable: bool = False) -> None:
    """Write a file through a temporary one beside it, so that it is never half-written.

    A durable one is on the disk when this returns: it is there after a power cut, too.
    """
    target = Path(path)
    with scratch_for(target) as scratch, scratch.open("wb") as file:
        file.write(content)
        if durable:
            file.flush()
            os.fsync(file.fileno())
    if durable:
        folder = os.open(target.parent, os.O_RDONLY)
        try:
            os.fsync(folder)
        finally:
            os.close(folder)
