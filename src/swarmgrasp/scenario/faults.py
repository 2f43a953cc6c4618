"""Collect every fault of a file, each with its line, column and key."""

from swarmgrasp.errors import FileFault, ScenarioInvalid

MOST_FAULTS_SHOWN = 50
"""Faults listed one by one; of the others only the number is told."""

Mark = tuple[int, int] | tuple[int, int, str]
"""A line and a column, counted from 1, and the file if it is another than the scenario's own."""
Path = tuple[str | int, ...]
"""Keys and list positions that lead to a value, such as ``("robots", 0, "limit")``."""


class Faults:
    """The faults found so far in one source.

    Parameters
    ----------
    source : str
        Name of the file, as messages show it.
    """

    def __init__(self, source: str) -> None:
        self.source = source
        self._found: set[FileFault] = set()

    def add(self, mark: Mark, path: Path, sentence: str) -> None:
        """Note a fault at a (line, column), or at a (line, column, file) elsewhere."""
        line, column, *files = mark
        place = "".join(files), line or None, column or None
        self._found.add(FileFault(*place, ".".join(map(str, path)), sentence))

    def __len__(self) -> int:
        """Return the number of faults."""
        return len(self._found)

    def __bool__(self) -> bool:
        """Tell whether there is any fault."""
        return bool(self._found)

    def listed(self) -> tuple[FileFault, ...]:
        """Return the faults in the order of the file, those of other files after its own."""

        def place(fault: FileFault) -> tuple[str, int, int, str, str]:
            """Return what a fault is sorted by."""
            return fault.file, fault.line or 0, fault.column or 0, fault.path, fault.sentence

        found = sorted(self._found, key=place)
        return tuple(fault._replace(file=fault.file or self.source) for fault in found)

    def error(self) -> ScenarioInvalid:
        """Return the error that tells the faults, in the order of the file."""
        found = list(self.listed())
        more = len(found) - MOST_FAULTS_SHOWN
        if more > 0:
            said = f"... and {more} more"
            found[MOST_FAULTS_SHOWN:] = [FileFault(self.source, None, None, "", said)]
        return ScenarioInvalid(found)
