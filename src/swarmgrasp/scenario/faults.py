"""Collect every fault of a file, each with its line, column and key."""

from dataclasses import dataclass

from swarmgrasp.errors import ScenarioInvalid

MOST_FAULTS_SHOWN = 50
"""Faults listed one by one; of the others only the number is told."""

Mark = tuple[int, int] | tuple[int, int, str]
"""A line and a column, counted from 1, and the file if it is another than the scenario's own."""
Path = tuple[str | int, ...]
"""Keys and list positions that lead to a value, such as ``("robots", 0, "limit")``."""


@dataclass(frozen=True, order=True)
class Fault:
    """One thing that is wrong, and where.

    Attributes
    ----------
    file : str
        Where it is; "" for the scenario itself.
    line, column : int
        Counted from 1; line 0 means the file as a whole, column 0 the whole line.
    key : str
        Key path with dots, such as ``robots.0.limit``; empty for the document itself.
    sentence : str
        What is wrong and what it should be.
    """

    file: str
    line: int
    column: int
    key: str
    sentence: str

    def told(self, source: str) -> str:
        """Return the whole message, ``barge.yaml:5:48: robots.0.limit: should be ...``."""
        place = self.file or source
        for number in filter(None, (self.line, self.column)):
            place += f":{number}"
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

    def add(self, mark: Mark, path: Path, sentence: str) -> None:
        """Note a fault at a (line, column), or at a (line, column, file) elsewhere."""
        line, column, *files = mark
        self._found.add(Fault("".join(files), line, column, ".".join(map(str, path)), sentence))

    def __len__(self) -> int:
        """Return the number of faults."""
        return len(self._found)

    def __bool__(self) -> bool:
        """Tell whether there is any fault."""
        return bool(self._found)

    def told(self) -> tuple[str, ...]:
        """Return the faults in the order of the file, each with its place."""
        return tuple(fault.told(self.source) for fault in sorted(self._found))

    def error(self) -> ScenarioInvalid:
        """Return the error that tells the faults, in the order of the file."""
        told = list(self.told())
        more = len(told) - MOST_FAULTS_SHOWN
        if more > 0:
            told[MOST_FAULTS_SHOWN:] = [f"{self.source}: ... and {more} more"]
        return ScenarioInvalid(told)
