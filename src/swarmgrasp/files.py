"""Writing files whole or not at all, and reading them within bounds."""

import secrets
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

MOST_DEPTH = 20
"""Levels of nesting that are read; a scenario needs 5, an answer 8."""


@contextmanager
def scratch_for(target: Path) -> Iterator[Path]:
    """Offer a path beside a target; what is written there takes the target's place at the end.

    If the block raises, nothing is left behind and the target stays as it was.

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
    finally:
        scratch.unlink(missing_ok=True)


def write_whole(path: str | Path, content: bytes) -> None:
    """Write a file through a temporary one beside it, so that it is never half-written."""
    with scratch_for(Path(path)) as scratch:
        scratch.write_bytes(content)
