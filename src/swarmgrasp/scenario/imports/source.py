"""A file that a scenario takes something from: its bytes, its text, and where its faults go."""

import codecs
from dataclasses import dataclass
from pathlib import Path

from swarmgrasp.files import read_fault
from swarmgrasp.scenario.faults import Faults
from swarmgrasp.scenario.faults import Path as Keys

LARGEST_FILE = 10_000_000
"""Bytes of a file that is read."""
MOST_ROWS = 20_000
"""Corners of an outline, or robots, that a file may hold."""
_MARKS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
"""What files of an encoding may begin with."""


@dataclass(frozen=True, eq=False)
class Source:
    """A file to be read.

    Attributes
    ----------
    path : Path
        Where it is.
    faults : Faults
        Receives what is wrong with it.
    keys : tuple
        What of a scenario it stands for, for messages.
    largest : int
        Bytes that are read.
    """

    path: Path
    faults: Faults
    keys: Keys = ()
    largest: int = LARGEST_FILE

    def fault(self, sentence: str, line: int = 0, keys: Keys = ()) -> None:
        """Note a fault of the file, or of one of its lines, counted from 1."""
        self.faults.add((line, 0, str(self.path)), (*self.keys, *keys), sentence)

    def raw(self) -> bytes | None:
        """Return the bytes of the file; None after a fault."""
        try:
            if self.path.exists() and not self.path.is_file() and not self.path.is_dir():
                self.fault("is no ordinary file")  # a pipe may never end
                return None
            with self.path.open("rb") as file:
                found = file.read(self.largest + 1)
        except (OSError, ValueError) as error:  # a path may hold a zero
            error = error if isinstance(error, OSError) else OSError(0, "no path of a file")
            self.fault(read_fault(self.path, error).removeprefix(f"{self.path}: "))
            return None
        if len(found) > self.largest:
            self.fault(f"is too large; at most {self.largest} bytes are read")
        elif not found.strip():
            self.fault("is empty")
        else:
            return found
        return None

    def text(self) -> str | None:
        """Return the text of the file, in UTF-8 or with a mark of UTF-16; None after a fault."""
        raw = self.raw()
        if raw is None:
            return None
        mark, encoding = next((m for m in _MARKS if raw.startswith(m[0])), (b"", "utf-8"))
        try:
            text = raw[len(mark) :].decode(encoding)
        except UnicodeDecodeError as error:
            line = raw[: len(mark) + error.start].count(b"\n") + 1
            self.fault(f"is no text in {encoding.upper()}; save it as UTF-8", line)
            return None
        if "\0" in text:
            self.fault("holds zero bytes: it is no text", text[: text.index("\0")].count("\n") + 1)
            return None
        return text
