"""What commands read, and the checks of where they are to write."""

import io
import os
import re
import sys
from collections.abc import Iterable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING
from warnings import catch_warnings, simplefilter

from swarmgrasp.cli.dash import DASH
from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.files import NO_FILE, target_faults

if TYPE_CHECKING:
    from swarmgrasp.scenario import Scenario

STDIN = "<stdin>"
PICTURES = (".pdf", ".png", ".svg")


class UsageFault(SwarmGraspError):
    """What was asked for cannot be done: nothing was computed, nothing written."""


def read_scenario(file: str, faults: Iterable[str] = ()) -> "Scenario":
    """Read a scenario, or the question of an answer; tell its faults with those found before.

    Parameters
    ----------
    file : str
        A path, "-" for standard input, or the name of a built-in example.
    faults : iterable of str
        Already found, for instance in where to write.

    Raises
    ------
    UsageFault
        If there is any fault.
    """
    from swarmgrasp.cli.show.report import complain
    from swarmgrasp.errors import ScenarioWarning

    found = list(faults)
    try:
        with catch_warnings():
            simplefilter("ignore", ScenarioWarning)  # they are told below
            scenario = _scenario(file)
    except SwarmGraspError as error:
        found += error.faults
    if found:
        raise UsageFault(found)
    complain(f"warning: {warning}" for warning in scenario.warnings)
    return scenario


def _scenario(file: str) -> "Scenario":
    """Read a scenario from where a command line says."""
    from swarmgrasp.answer_file import LARGEST_FILE
    from swarmgrasp.ranges import nearest_name
    from swarmgrasp.scenario import example_names, load_example, load_scenario, parse_scenario

    if file == DASH:
        return parse_scenario(read_stdin(LARGEST_FILE), STDIN)
    if not is_written(file):
        known = list(example_names())
        if file in known:
            return load_example(file)
        raise UsageFault(
            f"{file}: {NO_FILE}, and no built-in example of that name{nearest_name(file, known)}"
        )
    return load_scenario(file)


def is_written(file: str) -> bool:
    """Tell whether a file or standard input is meant, and not a built-in example."""
    return file == DASH or os.path.lexists(file)


def source_of(file: str) -> str:
    """Return what messages call a file."""
    return STDIN if file == DASH else file


def read_stdin(largest: int) -> bytes:
    """Return standard input.

    Raises
    ------
    UsageFault
        If it is closed, or larger than a number of bytes.
    """
    if sys.stdin is None:
        raise UsageFault(f"{STDIN}: is closed")
    raw = sys.stdin.buffer.read(largest + 1)
    if len(raw) > largest:
        raise UsageFault(f"{STDIN}:1:1: is too large; it should have at most {largest} bytes")
    return raw


@contextmanager
def blaming(file: str) -> Iterator[None]:
    """Tell what is wrong with a question as a fault of the file that asks it."""
    try:
        yield
    except SwarmGraspError as error:
        raise UsageFault(f"{source_of(file)}: {fault}" for fault in error.faults) from error


@contextmanager
def noting(faults: list[str]) -> Iterator[None]:
    """Note what is wrong, to be told with what else is; what follows within is left out."""
    try:
        yield
    except SwarmGraspError as error:
        faults += error.faults


def output_faults(path: str | Path | None, suffixes: tuple[str, ...]) -> list[str]:
    """Return what is wrong with where to write, before anything is computed.

    Parameters
    ----------
    path : str, Path or None
        None and "-" are fine.
    suffixes : tuple of str
        Those allowed; a suffix guards against overwriting a scenario by a slip.
    """
    if path is None or str(path) == DASH:
        return []
    target = Path(path)
    named_well = target.suffix.lower() in suffixes
    faults = [] if named_well else [f"{target}: the name should end in {' or '.join(suffixes)}"]
    return faults + target_faults(target)


def print_json(text: str) -> None:
    """Print JSON and nothing else, in UTF-8 as its standard asks."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(encoding="utf-8", errors="strict")
    sys.stdout.write(text)


def json_faults(path: str | Path | None) -> list[str]:
    """Return what is wrong with where to write JSON."""
    return output_faults(path, (".json",))


def whole_faults(option: str, text: str | None, low: int = 0, high: int = 999_999_999) -> list[str]:
    """Return what is wrong with an option that takes a whole number, and may be left out."""
    # int() would also take 1_0, and cyclopts 1.5 and 0x2
    if text is None or (re.fullmatch(r"[0-9]{1,19}", text) and low <= int(text) <= high):
        return []
    return [f"{option} is {text}; it should be a whole number from {low} to {high}"]
