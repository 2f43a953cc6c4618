"""Held or not comes first, with how much to spare, after whose loss, and where it drives."""

import math
import re

import pytest

from swarmgrasp import forces
from swarmgrasp.scenario import load_scenario

BARGE = """\
name: Barge
units: {length: m, force: kN, angle: deg, speed: knot}
outline: {vertices: [[-40, -10], [40, -10], [40, 10], [-40, 10]], edges: [s, e, n, w]}
robots:
  - {name: Tug 1, edge: s, along: 10, direction: inward, limit: 300, steers: 30}
  - {name: Tug 2, edge: s, along: 70, direction: inward, limit: 300, steers: 30}
  - {name: Tug 3, edge: n, along: 10, direction: inward, limit: 300, steers: 30}
  - {name: Tug 4, edge: n, along: 70, direction: inward, limit: 300, steers: 30}
environment:
  wind:
    {vessel: "container ship, loaded", frontal_area: 400, lateral_area: 1600, speed: 25, from: 60}
criterion: {load: environment}
"""


NEWCOMER = "newcomer: {name: Gaia, limit: 100, attachment: pull, length: 25, beam: 8}\n"


@pytest.mark.parametrize(
    ("options", "first"),
    [
        ([], r"Barge: held in 25 kn from 60 deg, with Gaia in the best place: [\d.]+ kN to spare"),
        (
            ["--wind", "90"],
            r"Barge: not held in 90 kn from 60 deg, even with Gaia where it prepares best: out of "
            r"reach by [\d.]+ kN, which leaves the object moving to port.*",
        ),
        (
            ["--robots", "2"],
            r"Barge: held in 25 kn from 60 deg, with 2 robots like Gaia, one after the other: .*",
        ),
        (
            ["--robots", "2", "--together", "--effort", "0"],
            r"Barge: held in 25 kn from 60 deg, with 2 robots like Gaia in the best found places.*",
        ),
    ],
)
def test_a_place_says_first_whether_the_load_is_held_then(run, tmp_path, options, first):
    """As well as the quality tells of the swarm with the newcomers; and what room each needs."""
    path, answer = tmp_path / "barge.yaml", tmp_path / "answer.json"
    path.write_text(
        BARGE + (NEWCOMER.replace(", length: 25, beam: 8", "") if options else NEWCOMER)
    )
    status, said, _ = run("place", path, *options, "--json", answer)
    assert status == 0
    assert re.fullmatch(first, said.splitlines()[0])
    assert ("needs 25 m by 8 m of room" in said) == (not options)


@pytest.fixture
def asked(run, tmp_path):
    """Ask for the quality of the barge with other words in its file; return file and answer."""

    def asked(change=("", ""), *options):
        path = tmp_path / "barge.yaml"
        path.write_text(BARGE.replace(*change) if change[0] else BARGE)
        status, said, complaints = run("quality", path, *options)
        assert (status, complaints) == (0, "")
        return load_scenario(path), said

    return asked


def test_held_and_after_whose_loss_it_is_not(asked):
    """As the losses tell when each is tried by hand."""
    scenario, said = asked()
    first = said.splitlines()[0]
    match = re.fullmatch(r"Barge: held in 25 kn from 60 deg, ([0-9.]+) kN to spare\. (.*)", first)
    assert match, first
    load, swarm = scenario.criterion.load, scenario.swarm
    lost = [n for n in swarm.names if forces(swarm.without(n), (0, 0, 0), load=load).is_degraded]
    assert lost == ["Tug 3", "Tug 4"]
    assert match[2] == "Not held after losing Tug 3 or 4."


def test_out_of_reach_by_how_much_and_whither(asked):
    """The load less what the robots make of it is what moves the object: to port."""
    scenario, said = asked(("speed: 25", "speed: 60"))
    answer = forces(scenario.swarm, (0, 0, 0), load=scenario.criterion.load)
    left = -answer.missing
    assert said.startswith(
        f"Barge: not held in 60 kn from 60 deg: out of reach by {answer.shortfall / 1e3:.2f} kN, "
        "which leaves the object moving to port while turning to port\n"
    )
    assert f"{left[1] / 1e3:.2f} kN along y" in said
    assert left[1] > 0.0


def test_a_flat_swarm_holds_with_nothing_to_spare(asked):
    """Tugs that push square to the sides hold a beam wind, and cannot push aft."""
    _, said = asked((", steers: 30", ""), "--units", "si")
    assert said.startswith("Barge: not held in 12.9 m/s from 60 deg: out of reach by 12.")
    beam = BARGE.replace(", steers: 30", "").replace("frontal_area: 400", "frontal_area: 1e-9")
    _, said = asked((BARGE, beam))
    assert re.match(r"Barge: held in 25 kn from 60 deg, with nothing to spare moving ", said)


def test_force_closure_says_of_which_state(asked):
    """Intact, and after the worst loss."""
    _, said = asked((", steers: 30", ", steers: 20"), "--losing", "2")
    assert "Force closure   intact yes; after the worst loss of 2 robots no: there are " in said
    assert said.startswith("Barge: not held in 25 kn from 60 deg after the worst loss of 2 robots")


def test_a_vessel_that_cannot_go_every_way_is_pointed_to_tasks(run, tmp_path):
    """Two propellers ahead are no fault; with a task, the wrench it names is told first."""
    path = tmp_path / "boat.yaml"
    path.write_text(
        "outline: {vertices: [[-2, -1], [2, -1], [2, 1], [-2, 1]]}\n"
        "robots:\n"
        "  - {name: left, contact: [0, 0.5], direction: 0, limit: 10, mounted: true}\n"
        "  - {name: right, contact: [0, -0.5], direction: 0, limit: 10, mounted: true}\n"
    )
    said = run("quality", path)[1]
    assert "Force closure   no: there are directions" in said
    assert "criterion: {task: {polytope: [[FX, FY, TZ], ...]}}" in said
    path.write_text(path.read_text() + "criterion: {task: {polytope: [[1, 0, 0]]}}\n")
    said = run("quality", path)[1]
    assert said.startswith("boat: quality 20.000 times the task, the least of it moving ahead\n")


def test_rounding_of_the_outline_is_no_quality(run, tmp_path):
    """Pushes square to a round tank do not turn it: what is left are the decimals of the file."""
    path, n = tmp_path / "tank.yaml", 360
    turns = [math.tau * k / n for k in range(n)]
    ring = [[round(25 * math.cos(t), 6), round(25 * math.sin(t), 6)] for t in turns]
    robots = [
        f"{{edge: {72 * k}, along: {math.pi * 25 / n:.6f}, direction: inward, limit: 4e5}}"
        for k in range(5)
    ]
    path.write_text(f"outline: {{vertices: {ring}}}\nrobots: [{', '.join(robots)}]\n")
    first = run("quality", path)[1].splitlines()[0]
    assert first.endswith(" kN, which the decimals of the outline do not tell from 0")


def test_nobody_holds_nothing(run, tmp_path):
    """All of the load is left over, and drives the object; nobody is told to ask for a task."""
    path = tmp_path / "adrift.yaml"
    path.write_text(
        "outline: {vertices: [[-2, -1], [2, -1], [2, 1], [-2, 1]]}\n"
        "robots: []\ncriterion: {load: [0, 5, 0]}\n"
    )
    said = run("quality", path)[1]
    assert said.startswith(
        "adrift: not held against the load: out of reach by 5.0000 N, which leaves the object "
        "moving to port\n"
    )
    assert "criterion: {task" not in said
