"""Read a scenario: from a file, or from text."""

from pathlib import Path

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.scenario.build import build
from swarmgrasp.scenario.document import read_document
from swarmgrasp.scenario.faults import Faults
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.validate import check

LARGEST_FILE = 1_000_000
"""Bytes; a larger file is refused before it is read."""


def load_scenario(path: str | Path) -> Scenario:
    """Read a scenario file.

    Parameters
    ----------
    path : str or Path
        A YAML 1.2 file in UTF-8.

    Returns
    -------
    Scenario

    Raises
    ------
    ScenarioInvalid
        If the file cannot be read or has faults; all of them are told, each with its
        line, column and key.
    """
    source = str(path)
    try:
        size = Path(path).stat().st_size
        if size > LARGEST_FILE:
            raise _too_large(source, f"{size} bytes")
        with Path(path).open("rb") as file:  # a pipe has no size: read no more than allowed
            raw = file.read(LARGEST_FILE + 1)
    except FileNotFoundError:
        raise ScenarioInvalid(f"{source}: there is no such file") from None
    except IsADirectoryError:
        raise ScenarioInvalid(f"{source}: is a directory; give a file in it") from None
    except OSError as error:
        raise ScenarioInvalid(f"{source}: cannot be read: {error.strerror or error}") from None
    except ScenarioInvalid:
        raise
    except ValueError as error:  # such as a null character in the name
        raise ScenarioInvalid(f"{source!r}: is no file name: {error}") from None
    try:
        text = raw.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        faults = Faults(source)
        before = raw[: error.start]
        mark = before.count(b"\n") + 1, error.start - before.rfind(b"\n")
        faults.add(mark, (), f"not UTF-8 (byte 0x{raw[error.start]:02x}); save it as UTF-8")
        raise faults.error() from None
    return parse_scenario(text, source)


def parse_scenario(text: str, source: str = "<text>") -> Scenario:
    r"""Read a scenario from text.

    Parameters
    ----------
    text : str
        YAML 1.2.
    source : str
        What messages call the text; a file's name, as a rule.

    Returns
    -------
    Scenario

    Raises
    ------
    ScenarioInvalid
        If the text has faults; all of them are told, each with its line, column and key.

    Examples
    --------
    >>> square = "outline: {vertices: [[0, 0], [1, 0], [1, 1], [0, 1]]}"
    >>> len(parse_scenario(square + "\nrobots: [{at: 0.5, direction: inward, limit: 2}]").swarm)
    1
    >>> parse_scenario(square + "\nrobots: [{at: 4.5, direction: in, limit: -2}]", "a.yaml")
    Traceback (most recent call last):
    swarmgrasp.errors.ScenarioInvalid: a.yaml:2:15: robots.0.at: ...
    """
    if len(text) > LARGEST_FILE:
        raise _too_large(source, f"{len(text)} characters")
    faults = Faults(source)
    return build(check(read_document(text, faults), faults), Path(source).stem)


def _too_large(source: str, size: str) -> ScenarioInvalid:
    """Return the error for a file past the limit."""
    return ScenarioInvalid(f"{source}: has {size}; it should have at most {LARGEST_FILE}")
