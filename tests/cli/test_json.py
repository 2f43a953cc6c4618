"""With `--json -` standard output is one JSON document, whatever libraries print from C."""

import inspect
import json
import subprocess
import sys
from tempfile import TemporaryDirectory

import pytest

from swarmgrasp.cli.app import COMMANDS

ASKED = {
    "place": ["deck-barge"],
    "place together": ["deck-barge", "--robots", "2", "--together"],
    "move": ["deck-barge"],
    "count": ["deck-barge", "--quality", "600kN"],
    "quality": ["rectangle-5"],
    "forces": ["deck-barge", "--wrench", "300kN", "0", "0"],
    "capability": ["supply-vessel", "--step", "30"],
    "simulate": ["escort-ring", "--for", "1"],
    "judge": ["model-ship"],
    "study": ["rectangle-5", "runs", "--runs", "50", "--workers", "1"],
    "verify": ["-"],
}


def printed(command: str, given: str = "") -> str:
    """Return what a process prints for a command, its JSON asked for."""
    program = [sys.executable, "-m", "swarmgrasp", command.split()[0], *ASKED[command]]
    with TemporaryDirectory() as folder:
        done = subprocess.run(
            [*program, "--json", "-"], input=given, capture_output=True, text=True, check=True,
            cwd=folder,
        )  # fmt: skip
    return done.stdout


@pytest.mark.parametrize("command", ASKED)
def test_standard_output_is_one_json_document(command: str) -> None:
    """A banner before it, such as that of HiGHS 1.16, would be a fault for every reader."""
    given = printed("place") if command == "verify" else ""
    assert isinstance(json.loads(printed(command, given)), dict)


def test_every_command_with_json_is_asked() -> None:
    """A new command is added to the list above; a robot prints lines as it goes, not an answer."""
    with_json = {c.__name__ for c in COMMANDS if "json" in inspect.signature(c).parameters}
    assert with_json - {"agent"} == {command.split()[0] for command in ASKED}
