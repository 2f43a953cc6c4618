import io
import json
import re
import sys

import pytest


def test_tells_quality_closure_and_robots(run):
    """The supply vessel's quality is the published 748.42 kN, with all its thrusters listed."""
    status, said, complaints = run("quality", "supply-vessel")
    assert (status, complaints) == (0, "")
    assert said.startswith("Supply vessel: quality 748.42 kN\n")
    assert "Force closure   yes" in said
    assert "Weakest wrench  turning to" in said
    assert said.count(" on board") == 6
    assert "Metric: force weights 1 and 1, characteristic length 38.1 m." in said


def test_no_force_closure_is_said_plainly(run):
    """With a quality of 0 the report names a wrench that the robots cannot exert."""
    _, said, _ = run("quality", "rectangle-5")
    assert "quality 0 N" in said
    assert "Force closure   no" in said
    assert "the robots exert nothing that way" in said


def test_a_scenario_may_have_no_robots(run, pontoon):
    """Nobody there: quality 0, and no table."""
    text = pontoon.read_text()
    pontoon.write_text(text[: text.index("robots:")] + "robots: []\n")
    status, said, _ = run("quality", pontoon)
    assert status == 0
    assert "there are no robots" in said


def test_one_robot_spans_no_facet(run, pontoon):
    """Who sets the quality is told from two robots on."""
    pontoon.write_text("".join(pontoon.read_text().splitlines(keepends=True)[:4]))
    status, said, _ = run("quality", pontoon)
    assert status == 0
    assert "Weakest wrench" in said
    assert "Set by" not in said


def test_json_holds_the_numbers(run, tmp_path):
    """The efficiency is the quality over sum u / pi (T3)."""
    target = tmp_path / "quality.json"
    status, said, _ = run("quality", "supply-vessel", "--json", target)
    found = json.loads(target.read_text())
    assert status == 0
    assert said.endswith(f"wrote {target}\n")
    limits = 8 * 200e3 + 4 * 799e3
    assert found["efficiency"] == pytest.approx(found["value"] * 3.141592653589793 / limits)
    assert found["value"] == pytest.approx(748420, rel=1e-5)
    assert found["swarm"]["characteristic_length"] == pytest.approx(38.1)


def test_reads_standard_input(run, pontoon, monkeypatch):
    """A lone dash is standard input; its faults are told as <stdin>."""
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(pontoon.read_bytes())))
    assert run("quality", "-")[1].startswith("Pontoon: quality ")
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(b"robots: 3\n")))
    status, said, complaints = run("quality", "-")
    assert (status, said) == (2, "")
    assert "<stdin>:1:9: robots: should be a list" in complaints


def test_losing_robots(run, tmp_path):
    """The worst loss, and what each robot's loss leaves."""
    target = tmp_path / "quality.json"
    status, said, _ = run("quality", "rectangle-15", "--losing", "1", "--json", target)
    assert status == 0
    assert said.startswith("Rectangle, 15 robots: quality 1.2638 N after the worst loss of 1 robot")
    assert "As it stands    2.2558 N" in said
    assert "Worst loss      R4\n" in said
    found = json.loads(target.read_text())
    assert found["criterion"]["losing"] == 1
    assert found["lost"] == ["R4"]
    worst = found["losses"][0]
    assert (worst["name"], worst["quality"]) == ("R4", pytest.approx(found["value"]))
    assert len(found["worst_robots"]) == 14


def test_the_worst_poses(run):
    """Those of robots with tolerances, and the value with what it is at least."""
    status, said, _ = run("quality", "deck-barge", "--worst-case")
    assert status == 0
    assert " in the worst poses\n" in said
    assert "Certified" not in said  # it is proven to all digits shown
    assert said.index("The worst poses") < said.index("The tugs as they are meant to be")


def test_what_cannot_be_asked(run):
    """A number of robots that is none, and the worst case where everything is certain."""
    assert run("quality", "deck-barge", "--losing", "-1")[0] == 2
    status, said, complaints = run("quality", "supply-vessel", "--worst-case")
    assert (status, said) == (2, "")
    assert "no robot has a tolerance" in complaints


def test_tasks_and_loads_are_told_in_their_units(run, tmp_path):
    """The quality is a factor, the weakest wrench a wrench; a load too great is said to be."""
    text = run("examples", "deck-barge")[1]
    barge = tmp_path / "barge.yaml"
    barge.write_text(text + "\ncriterion: {task: {polytope: [[10, 0, 0]]}}\n")
    status, said, _ = run("quality", barge)
    assert status == 0
    assert "relative to the task" not in said
    assert "the tugs exert at most" in said
    assert "times the task along x" not in said
    barge.write_text(text + "\ncriterion: {load: [0, 1e6, 0]}\n")
    assert "the tugs fall short most that way" in run("quality", barge)[1]
    assert "tugs and load come to at most" in run("quality", "escort-ring")[1]


def test_nothing_is_left_of_nobody(run):
    """As many losses as there are robots are refused; equal losses are all named."""
    status, _, complaints = run("quality", "deck-barge", "--losing", "5")
    assert (status, complaints) == (
        2,
        "--losing is 5, and there are 5 robots: none would be left\n",
    )
    assert (
        "Worst loss      Ajax, Castor or Dione\n"
        in run("quality", "deck-barge", "--losing", "1")[1]
    )


STEERING = """
units: {length: m, force: kN, angle: deg}
outline: {vertices: [[-40, -10], [40, -10], [40, 10], [-40, 10]], edges: [stb, bow, port, stern]}
robots:
  - {name: Ajax, edge: stb, along: 10, direction: inward, limit: 210, steers: 30, group: line A}
  - {name: Boreas, edge: stb, along: 70, direction: 100, limit: 300, steers: 30}
  - {name: Castor, edge: port, along: 40, limit: 5.5, friction: 0.5}
  - {name: Dione, edge: bow, along: 5, direction: outward, limit: [2, 20]}
  - {name: tunnel, contact: [30, 0], direction: 90, limit: {ahead: 51, astern: 40}, mounted: true}
  - {name: azimuth, contact: [-30, 0], limit: 99, steers: any, mounted: true, group: line A}
"""


def test_what_each_robot_can_exert_is_told(run, tmp_path):
    """In the table of robots, with their groups, instead of one direction and one limit."""
    (tmp_path / "tugs.yaml").write_text(STEERING)
    status, said, complaints = run("quality", tmp_path / "tugs.yaml")
    assert (status, complaints) == (0, "")
    (heads,) = (line for line in said.splitlines() if line.startswith("robot "))
    assert re.split("  +", heads)[3:6] == ["forces", "group", "place"]
    told = (
        "210 kN within 30 deg of 90 deg     line A",
        "300 kN within 30 deg of 100 deg ",
        "5.5 kN at -90 deg, friction 0.5 ",
        "2 to 20 kN at 0 deg ",
        "51 kN ahead, 40 kN astern, at 90 deg ",
        "99 kN in any direction ",
    )
    for forces in told:
        assert re.sub(" +", " ", forces) in re.sub(" +", " ", said)


SIDES = """\
name: Abreast
units: {force: kN, angle: deg}
outline: {vertices: [[-40, -10], [40, -10], [40, 10], [-40, 10]]}
robots:
  - {name: bow, contact: [30, 0], limit: 90, mounted: true, sectors: [[20, 160], [200, 340]]}
  - {name: mid, contact: [0, 0], limit: 90, mounted: true, sectors: [[20, 160], [200, 340]]}
  - {name: stern, contact: [-30, 0], limit: 90, mounted: true, sectors: [[-150, 150]]}
newcomer: {limit: 60, attachment: push}
"""


def test_sectors_with_gaps_are_told_by_every_command(run, tmp_path):
    """The quality's bounds and the sectors kept; a place beside them; and forces in sectors."""
    file = tmp_path / "abreast.yaml"
    file.write_text(SIDES)
    _, said, complaints = run("quality", file)
    assert re.match(r"Abreast: quality 129\.\d+ to 130\.97 kN\n", said), said
    assert complaints == ""
    assert "Sectors kept    bow " in said
    assert "90 kN from 20 to 160 deg or 200 to 340 deg" in said
    _, said, _ = run("place", file)
    assert "best found place for newcomer" in said
    assert "whatever sectors robots push in" in said
    _, said, _ = run("forces", file, "--wrench", "60", "0", "0")
    assert "at the end of a sector" in said
    status, _, complaints = run("quality", file, "--sensitivities")
    assert status != 0
    assert complaints.startswith(f"{file}: what is asked for is not known of robots whose sectors")
    assert "sectors have gaps between: bow, mid, stern" in complaints
