"""Ctrl-C ends a search with the best so far, its bound, and a word; completion installs."""

import json
import re
import signal

import pytest

from swarmgrasp.cli.show import together
from swarmgrasp.placement.place import _Placing
from swarmgrasp.placement.together import moving
from swarmgrasp.placement.together.how_many import _Count


@pytest.fixture
def ctrl_c(monkeypatch):
    """Press Ctrl-C when something is called for the second time."""
    signal.signal(signal.SIGINT, signal.default_int_handler)  # whatever it was started with

    def ctrl_c(owner, name):
        true, calls = getattr(owner, name), []

        def pressed(*arguments):
            calls.append(arguments)
            if len(calls) == 2:
                signal.raise_signal(signal.SIGINT)
            return true(*arguments)

        monkeypatch.setattr(owner, name, pressed)

    return ctrl_c


def test_placing_together_ends_with_the_best_so_far(run, tmp_path, ctrl_c):
    """The bound holds; the answer file says that the search stopped early; status 130."""
    ctrl_c(together, "so_far")
    path = tmp_path / "answer.json"
    command = ["place", "deck-barge", "--robots", "3", "--together", "--gap", "1e-9"]
    status, said, complaints = run(*command, "--json", path)
    assert (status, complaints) == (130, "")
    assert "; Ctrl-C ended the search before the gap asked for" in said
    found = json.loads(path.read_text())
    assert found["stopped_early"]
    assert found["quality"] <= found["upper_bound"]
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_placing_one_after_the_other_ends_with_those_placed(run, ctrl_c):
    """They are an answer of their own."""
    ctrl_c(_Placing, "placement")
    status, said, complaints = run("place", "hull-120", "--robots", "5", "--runners-up", "1")
    assert (status, complaints) == (130, "")
    assert "Ctrl-C ended the search after 2 of 5 tugs." in said
    assert said.startswith("Hull of 120 vertices: 2 tugs like ")


def test_moving_ends_with_those_looked_at(run, tmp_path, ctrl_c):
    """The best of them, with its bound, and who was not looked at; status 130."""
    ctrl_c(moving, "_without")
    path = tmp_path / "moves.json"
    status, said, complaints = run("move", "deck-barge", "--json", path)
    assert (status, complaints) == (130, "")
    found = json.loads(path.read_text())
    assert len(found["ranked"]) + len(found["stuck"]) == 2
    assert found["untried"] == ["Castor", "Dione", "Electra"]
    assert "Ctrl-C ended the search before Castor, Dione and Electra" in said
    assert "no move of those looked at is better" in said
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_counting_ends_with_what_is_known(run, ctrl_c):
    """How many are enough, and that fewer is not settled."""
    ctrl_c(_Count, "_told")
    status, said, _ = run("count", "deck-barge", "--quality", "700kN", "--effort", "100000")
    assert status == 130
    assert re.search(r"Open +.* is not settled; Ctrl-C ended the search\n", said)


def test_completion_is_installed_where_it_is_wanted(run, tmp_path):
    """For a shell, in a file; it knows the commands and their options."""
    script = tmp_path / "completion.bash"
    status, _, _ = run("--install-completion", "--shell", "bash", "--output", script)
    assert status == 0
    assert "--where-not" in script.read_text()
