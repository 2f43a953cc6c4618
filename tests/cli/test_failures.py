"""`--failures`: named robots and groups that fail together, on the command line."""

import json

import numpy as np
import pytest

from swarmgrasp import capability
from swarmgrasp.scenario import parse_scenario

BARGE = """\
name: Barge
units: {angle: deg}
outline: {vertices: [[-2, -1], [2, -1], [2, 1], [-2, 1]], edges: [starboard, bow, port, stern]}
robots:
  - {name: Ajax, edge: starboard, along: 0.6, direction: 80, limit: 1000, steers: 40, group: bus A}
  - {name: Boreas, edge: port, along: 0.5, direction: 260, limit: 900, steers: 40, group: bus B}
  - {name: Castor, edge: bow, along: 0.5, direction: 190, limit: 1000, steers: 30, group: bus A}
  - {name: Dione, edge: stern, along: 0.8, direction: 10, limit: 1000, steers: 50}
  - {name: "Erato, II", edge: port, along: 3.1, direction: 280, limit: 800, steers: 60}
newcomer: {name: Fama, limit: 1500, attachment: push, half_angle: 30, steers: true}
environment: {wind: {vessel: offshore supply vessel, frontal_area: 20, lateral_area: 40}}
"""
BOTH = ("--failures", "bus A", "--failures", "Boreas,Dione")


@pytest.fixture
def barge(tmp_path):
    """Five tugs that steer, two of them on one switchboard, in a file."""
    path = tmp_path / "barge.yaml"
    path.write_text(BARGE)
    return path


@pytest.mark.parametrize("command", ["quality", "place", "move", "count", "capability"])
def test_every_command_takes_named_failures(run, barge, command):
    """The criterion of the answer has them, and the report says so."""
    more = {"count": ("--quality", "400"), "capability": ("--step", "90")}.get(command, ())
    taken = BOTH if command != "move" else ("--failures", "bus B")
    status, told, complaints = run(command, barge, *more, *taken, "--json", "-")
    assert (status, complaints) == (0, "")
    found = json.loads(told)
    asked = found.get("criterion") or found.get("problem", {}).get("criterion") or found
    wanted = [["bus A"], ["Boreas", "Dione"]] if command != "move" else [["bus B"]]
    assert asked["failures"] == wanted
    said = run(command, barge, *more, *taken)[1]
    words = "after the failure of bus B" if command == "move" else "after the worst of 2 failures"
    assert words in said


def test_the_quality_is_that_without_the_worst_of_them(run, barge):
    """The report says how it stands, and which failure is the worst; a loss is besides."""
    said = run("quality", barge, *BOTH)[1]
    numbers = [
        json.loads(run("quality", barge, "--failures", name, "--json", "-")[1])["value"]
        for name in ("bus A", "Boreas,Dione")
    ]
    found = json.loads(run("quality", barge, *BOTH, "--json", "-")[1])
    assert found["value"] == min(numbers) < max(numbers)
    assert "As it stands" in said
    worst = ("bus A", "Boreas and Dione")[numbers.index(min(numbers))]
    assert f"Worst failure   {worst}" in said
    assert "after the worst loss of 1 robot or group" in run("quality", barge, "--losing", "1")[1]
    assert (
        "What the loss of each robot or group leaves" in run("quality", barge, "--losing", "1")[1]
    )


def test_options_stand_instead_of_those_in_the_file(run, barge):
    """And a name with a comma is that of a robot, if there is one."""
    barge.write_text(BARGE + "criterion: {failures: [bus B]}\n")
    asked = json.loads(run("quality", barge, "--failures", "Erato, II", "--json", "-")[1])
    assert asked["criterion"]["failures"] == [["Erato, II"]]
    asked = json.loads(run("quality", barge, "--json", "-")[1])
    assert asked["criterion"]["failures"] == [["bus B"]]


def test_an_answer_is_asked_again_with_its_failures(run, barge, tmp_path):
    """Placed, checked by the independent code, and told in words."""
    target = tmp_path / "answer.json"
    assert run("place", barge, *BOTH, "--losing", "1", "--json", target)[0] == 0
    status, said, _ = run("verify", target)
    assert status == 0
    words = (
        "after the failure of bus A or Boreas and Dione, after the worst loss of 1 robot or group"
    )
    assert words in " ".join(said.split())
    again = json.loads(run("quality", target, "--json", "-")[1])["criterion"]
    assert (again["failures"], again["losing"]) == ([["bus A"], ["Boreas", "Dione"]], 1)


def test_wrong_names_are_answered_with_those_there_are(run, barge):
    """All of them at once."""
    status, _, complaints = run("quality", barge, "--failures", "bus C", "--failures", "Ajax,Ayax")
    assert status == 2
    said = " ".join(complaints.split())
    there = "there are bus A, bus B, Ajax, Boreas, Castor, Dione and Erato, II"
    assert f"--failures takes 'bus C', which is no robot and no group; {there}" in said
    assert "--failures takes 'Ayax', which is no robot and no group" in said


def test_capability_is_held_after_the_worst_failure(run, barge):
    """No robot is lost besides unless it is asked for; the table says what fails."""
    told = json.loads(run("capability", barge, *BOTH, "--step", "45", "--json", "-")[1])
    assert told["losing"] == 0
    scenario = parse_scenario(BARGE)
    alone = [
        capability(scenario.swarm.without(names), scenario.environment, told["bearings"], 0)
        for names in (["Ajax", "Castor"], ["Boreas", "Dione"])
    ]
    winds = np.array([found.intact for found in alone])
    assert told["after_loss"] == pytest.approx(winds.min(axis=0), rel=1e-6)
    assert np.ptp(winds, axis=0).max() > 1.0
    named = (["bus A"], ["Boreas", "Dione"])
    for names, pair in zip(told["worst_losses"], winds.T, strict=True):
        assert names in named
        assert pair[named.index(names)] == pytest.approx(pair.min(), rel=1e-6)
    lost = json.loads(
        run("capability", barge, *BOTH, "--losing", "1", "--step", "45", "--json", "-")[1]
    )
    pairs = zip(told["after_loss"], lost["after_loss"], strict=True)
    assert all(less <= more for more, less in pairs)
    said = run("capability", barge, *BOTH)[1]
    assert "After a failure" in said
    assert "worst failure" in said
