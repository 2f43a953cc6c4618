import json
import shlex
import sys

import pytest

from swarmgrasp.agents.simulator import Book, Broken

PONTOON = """\
outline: {vertices: [[-20, -5], [20, -5], [20, 5], [-20, 5]]}
robots: []
newcomer: {limit: 1000, attachment: push, half_angle: 0.5}
spacing: 4
"""


@pytest.fixture
def barge(tmp_path):
    """Write a barge that nobody holds yet to a file."""
    path = tmp_path / "barge.yaml"
    path.write_text(PONTOON)
    return path


def test_schedules_that_hold_are_told_in_one_sentence(run, barge):
    """What was simulated, and that nothing broke."""
    status, said, complaints = run("agents", "simulate", barge, "--seeds", "1:2", "--robots", "3")
    assert (status, complaints) == (0, "")
    assert said.startswith("All invariants hold in 2 schedules of main")


def test_a_schedule_can_be_said_in_words_and_written_as_json(run, barge):
    """Two join, one is killed: who attached, how much was sent, and a digest of it all."""
    faults = "join@0:R1; join@1:R2; crash@3-5:R1"
    arguments = ("agents", "simulate", barge, "--faults", faults, "--calm", "6", "--seeds", "7")
    status, said, _ = run(*arguments, "--json", "-")
    document = json.loads(said)
    (schedule,) = document["schedules"]
    assert (status, document["broken"]) == (0, None)
    assert (schedule["seed"], schedule["attached"]) == (7, 2)
    assert json.loads(run(*arguments, "--json", "-")[1]) == document


def test_a_failing_schedule_is_told_with_the_command_that_repeats_it(run, barge, monkeypatch):
    """Exit status 1, what broke, what the robots said, and a command that says the same."""

    def check_end(_):
        raise Broken("nothing ever happens", "something did")

    monkeypatch.setattr(Book, "check_end", check_end)
    status, said, _ = run("agents", "simulate", barge, "--robots", "2", "--shrink")
    assert status == 1
    assert "'nothing ever happens' does not hold in main, seed 1" in said
    command = next(line for line in said.splitlines() if line.startswith("swarmgrasp agents"))
    words = shlex.split(command)[1:]
    status, again, _ = run(*words)
    assert status == 1
    assert command in again


def test_groups_are_told_in_words_and_repeated(run, monkeypatch):
    """How many hold the object, what all know, what each sends; and the command that repeats it."""
    arguments = ("agents", "simulate", "rectangle-5", "--robots", "12", "--seeds", "2")
    status, said, complaints = run(*arguments, "--groups", "2")
    assert (status, complaints) == (0, "")
    assert said.startswith("All invariants hold in 1 schedule of groups")
    assert "10 robots in 2 groups hold the object" in said
    (schedule,) = json.loads(run(*arguments, "--mode", "groups", "--json", "-")[1])["schedules"]
    assert schedule["groups"]["counted"] == schedule["attached"] >= 10
    counted = schedule["attached"]
    assert f"{counted} hold the object. Everybody knows that the quality is" in said

    def check_end(_):
        raise Broken("nothing ever happens", "something did")

    monkeypatch.setattr(Book, "check_end", check_end)
    status, said, _ = run(*arguments, "--groups", "2")
    command = next(line for line in said.splitlines() if line.startswith("swarmgrasp agents"))
    assert (status, run(*shlex.split(command)[1:])[0]) == (1, 1)


def test_what_is_not_for_groups_is_told(run):
    """Each in a line."""
    wrong = ("--groups", "2", "--mode", "dead", "--faults", "join@1:J1", "--robots", "9")
    status, _, complaints = run("agents", "simulate", "rectangle-5", *wrong)
    assert status == 2
    assert complaints.splitlines() == [
        "--groups is for --mode groups, not dead",
        "--robots is not for --faults, which say who joins",
    ]
    status, _, complaints = run("agents", "simulate", "harbour-tugs", "--groups", "2")
    assert status == 2
    assert "groups are for robots that push along one ray each" in complaints


def test_all_that_is_wrong_is_told_at_once(run, tmp_path):
    """Options and file: a line for each fault, and nothing is run."""
    status, said, complaints = run(
        "agents", "simulate", tmp_path / "none.yaml", "--seeds", "9:1", "--mode", "main,odd",
        "--robots", "0", "--loss", "2", "--calm", "3", "--json", "a.txt",
    )  # fmt: skip
    assert (status, said) == (2, "")
    assert len(complaints.splitlines()) == 7
    status, _, complaints = run("agents", "simulate", "deck-barge", "--faults", "jion@0:R1")
    assert status == 2
    assert "jion@0:R1" in complaints


def test_wrong_usage_points_to_the_help_of_the_command(run):
    """The hint names the command within its group."""
    status, _, complaints = run("agents", "simulate", "--lonely")
    assert status == 2
    assert complaints.splitlines()[1] == "For help: swarmgrasp agents simulate --help"


@pytest.mark.parametrize(
    "words",
    [
        ["agent", "deck-barge", "--name", "Fortuna"],
        ["agents", "demo"],
        ["agents", "keys", "none", "Ajax"],
        ["agents", "simulate", "deck-barge"],
        ["agents", "watch", "deck-barge"],
    ],
)
def test_without_the_extra_the_remedy_is_told(run, monkeypatch, words):
    """What robots speak with is an extra: each command that needs it says how to install it."""
    monkeypatch.setitem(sys.modules, "msgspec", None)
    status, said, complaints = run(*words)
    assert (status, said) == (2, "")
    assert "needs msgspec; install it with: pip install 'swarmgrasp[agents]'" in complaints
