"""Read a scenario: from a file, or from text; or the question of an answer."""

from codecs import BOM_UTF8
from pathlib import Path

from swarmgrasp.answer_file import LARGEST_FILE as LARGEST_ANSWER
from swarmgrasp.callers import warn_caller
from swarmgrasp.errors import FileFault, ScenarioInvalid, ScenarioWarning, refuse
from swarmgrasp.files import read_fault
from swarmgrasp.ranges import path_faults
from swarmgrasp.scenario.asking import answer_in, scenario_of
from swarmgrasp.scenario.build import build
from swarmgrasp.scenario.document import read_document
from swarmgrasp.scenario.faults import Faults
from swarmgrasp.scenario.imports.expand import Folder, expand, files_named
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.validate import check

LARGEST_FILE = 1_000_000
"""Bytes, of a scenario in YAML."""


def load_scenario(path: str | Path) -> Scenario:
    """Read a scenario file, or the question of an answer file.

    Parameters
    ----------
    path : str or Path
        A YAML 1.2 file in UTF-8, or an answer as `write_answer` writes it.

    Returns
    -------
    Scenario

    Raises
    ------
    ScenarioInvalid
        If the file cannot be read or has faults; all of them are told, each with its
        line, column and key.

    Warns
    -----
    ScenarioWarning
        Of each slip in `Scenario.warnings`.
    """
    refuse((ScenarioInvalid, path_faults(path)))
    source = str(path)
    scenario = parse_scenario(_bytes_of(path), source, Path(path).parent)
    for warning in scenario.warnings:
        warn_caller(warning, ScenarioWarning)
    return scenario


def _bytes_of(path: str | Path) -> bytes:
    """Return what a file holds: a little more than may be read, if it is too large."""
    try:
        with Path(path).open("rb") as file:
            raw = file.read(LARGEST_FILE + 1)
            if len(raw) > LARGEST_FILE and raw.lstrip().startswith(b"{"):
                raw += file.read(LARGEST_ANSWER - LARGEST_FILE)
    except OSError as error:
        raise ScenarioInvalid(read_fault(path, error)) from None
    return raw


def parse_scenario(text: str | bytes, source: str = "<text>", folder: Folder = None) -> Scenario:
    r"""Read a scenario from text, or the question of an answer.

    Parameters
    ----------
    text : str or bytes
        YAML 1.2, or an answer in JSON; bytes in UTF-8.
    source : str
        What messages call the text; a file's name, as a rule.
    folder : Path, or mapping of str to Path, optional
        That paths in it are relative to, or the only paths that it may name with where they are; a
        scenario that takes something from a file is refused when left out.

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
    answer = answer_in(text, source)
    if answer is not None:
        return scenario_of(answer, source)
    if len(text) > LARGEST_FILE:
        unit = "characters" if isinstance(text, str) else "bytes"
        said = f"is too large; it should have at most {LARGEST_FILE} {unit}"
        raise ScenarioInvalid([FileFault(source, 1, 1, "", said)])
    faults = Faults(source)
    if isinstance(text, bytes):
        text = _decoded(text, faults)
    root = read_document(text, faults)
    taken = expand(root, faults, folder)
    return build(check(root, faults, taken.stand_ins), Path(source).stem)


def named_files(text: str) -> list[str]:
    r"""Return the paths of the files that the text of a scenario takes something from, as it says.

    Raises
    ------
    ScenarioInvalid
        If the text is no YAML.

    Examples
    --------
    >>> named_files("outline: {file: hull.dxf}\nrobots: []")
    ['hull.dxf']
    """
    return files_named(read_document(text, Faults("<text>")))


def _decoded(raw: bytes, faults: Faults) -> str:
    """Return the text of a file; a byte that is not UTF-8 is told with its line and column."""
    start = len(BOM_UTF8) if raw.startswith(BOM_UTF8) else 0
    try:
        return raw[start:].decode()
    except UnicodeDecodeError as error:
        before = raw[start:][: error.start].decode()
        mark = before.count("\n") + 1, len(before) - before.rfind("\n")
        byte = raw[start + error.start]
        faults.add(mark, (), f"not UTF-8 (byte 0x{byte:02x}); save it as UTF-8")
        raise faults.error() from None
