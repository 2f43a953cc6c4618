import os
import subprocess
import sys

import pytest

COMMANDS = [
    "place", "move", "count", "quality", "capability", "study", "verify", "judge", "plot", "paper",
    "examples", "schema", "agent",
]  # fmt: skip


def shell(line):
    """Run a shell line with `swarmgrasp` in it, its output piped."""
    program = f"{sys.executable} -m swarmgrasp"
    environment = {**os.environ, "PYTHONWARNINGS": "error"}
    return subprocess.run(
        ["bash", "-c", line.replace("swarmgrasp", program)],
        capture_output=True, text=True, env=environment, timeout=60, check=False,
    )  # fmt: skip


def test_help_lists_commands_and_exit_status(run):
    """The first thing a new user reads."""
    status, said, _ = run("--help")
    assert status == 0
    assert all(f"\n {command} " in said for command in COMMANDS)
    assert "Exit status: 0 done; 1 an answer was refused (verify, judge, report)" in said
    able_to_fail = ("paper", "agents curve", "agents simulate", "agents demo", "agents ask")
    assert all(
        command in " ".join(said.split("Exit status")[1].split()) for command in able_to_fail
    )
    assert "swarmgrasp place deck-barge" in said


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_explains_itself(run, command):
    """Each help has an example, and no parameter without a word."""
    status, said, _ = run(command, "--help")
    assert status == 0
    assert f"swarmgrasp {command}" in said
    assert "│" not in said


@pytest.mark.parametrize(
    ("arguments", "fault"),
    [
        (["plaice"], 'Unknown command "plaice". Did you mean "place"?'),
        (["place"], "requires an argument"),
        (["place", "deck-barge", "--gaps", "1"], "Unknown option: --gaps"),
        (["place", "--json", "--plot", "a.png"], "--json requires an argument"),
        (["quality", "--lonely"], "--lonely"),
        (["-"], 'Unknown command "-"'),
    ],
)
def test_wrong_usage(run, arguments, fault):
    """Two lines on standard error: what is wrong, and where to look."""
    status, said, complaints = run(*arguments)
    first, second = complaints.splitlines()
    assert (status, said) == (2, "")
    assert fault in first
    assert second.startswith("For help: swarmgrasp ")


def test_an_interrupt_is_quiet(run, monkeypatch):
    """Ctrl-C ends with 130 and no traceback."""

    def interrupt(*_):
        raise KeyboardInterrupt

    monkeypatch.setattr("swarmgrasp.cli.quality.read_scenario", interrupt)
    assert run("quality", "deck-barge") == (130, "", "")


def test_piped_output_is_plain():
    """No escape codes, no frames, no broken lines; the exit status is the program's."""
    done = shell("swarmgrasp place deck-barge")
    assert (done.returncode, done.stderr) == (0, "")
    assert "\x1b" not in done.stdout
    assert "─" not in done.stdout
    assert max(map(len, done.stdout.splitlines())) > 80


def test_a_reader_that_leaves_is_no_fault():
    """`| head` is quiet."""
    done = shell("set -o pipefail; swarmgrasp schema | head -1")
    assert (done.stdout, done.stderr) == ("{\n", "")
    done = shell("set -o pipefail; swarmgrasp examples deck-barge | true")
    assert (done.returncode in (0, 141), done.stderr) == (True, "")


def test_files_are_written_whoever_reads_the_report(tmp_path):
    """A reader that leaves at once does not cost the answer."""
    target = tmp_path / "answer.json"
    shell(f"swarmgrasp place model-ship --json {target} | true")
    assert shell(f"swarmgrasp verify {target}").returncode == 0


def test_closed_streams_are_no_traceback():
    """`>&-` is told in one line, and complaints nobody hears go nowhere."""
    done = shell("swarmgrasp schema >&-")
    assert (done.returncode, done.stdout) == (2, "")
    assert done.stderr == "standard output is closed; send it to a file, or to /dev/null\n"
    done = shell("swarmgrasp quality - <&-")
    assert (done.returncode, done.stderr) == (2, "<stdin>: is closed\n")
    done = shell("swarmgrasp plaice 2>&-")
    assert (done.returncode, done.stdout) == (2, "")


def test_a_pipe_of_commands_verifies():
    """An answer goes from `place` to `verify` without a file."""
    done = shell("set -o pipefail; swarmgrasp place model-ship --json - | swarmgrasp verify -")
    assert (done.returncode, done.stderr) == (0, "")
    assert done.stdout.startswith("<stdin>: verified\n")
