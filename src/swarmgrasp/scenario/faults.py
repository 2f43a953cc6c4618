"""Collect every fault of a file, each with its line, column and key."""

from dataclasses import dataclass

from swarmgrasp.errors import ScenarioInvalid

MOST_FAULTS_SHOWN = 50
"""Faults listed one by one; of the others only the number is told."""

Path = tuple[str | int, ...]
"""Keys and list positions that lead to a value, such as ``("robots", 0, "limit")``."""


@dataclass(frozen=True, order=True)
class Fault:
    """One thing that is wrong, and where.

    Attributes
    ----------
    line, column : int
        Counted from 1; line 0 means the file as a whole.
    key : str
        Key path with dots, such as ``robots.0.limit``; empty for the document itself.
    sentence : str
        What is wrong and what it should be.
    """

    line: int
    column: int
    key: str
    sentence: str

    def told(self, source: str) -> str:
        """Return the whole message, ``barge.yaml:5:48: robots.0.limit: should be ...``."""
        place = f"{source}:{self.line}:{self.column}" if self.line else source
        return ": ".join(part for part in (place, self.key, self.sentence) if part)


class Faults:
    """The faults found so far in one source.

    Parameters
    ----------
    source : str
        Name of the file, as messages show it.
    """

    def __init__(self, source: str) -> None:
        self.source = source
        self._found: set[Fault] = set()

    def add(self, mark: tuple[int, int], path: Path, sentence: str) -> None:
        """Note a fault at a (line, column)."""
        self._found.add(Fault(*mark, ".".join(map(str, path)), sentence))

    def __bool__(self) -> bool:
        """Tell whether there is any fault."""
        return bool(self._found)

    def error(self) -> ScenarioInvalid:
        """Return the error that tells the faults, in the order of the file."""
        told = [fault.told(self.source) for fault in sorted(self._found)]
        more = len(told) - MOST_FAULTS_SHOWN
        if more > 0:
            told[MOST_FAULTS_SHOWN:] = [f"{self.source}: ... and {more} more"]
        return ScenarioInvalid(told)
