"""Weather on the command line: the load of the file's own weather, said in other words."""

import json
import math

import pytest

from swarmgrasp.scenario import load_scenario

BARGE = """\
name: Barge
units: {length: m, force: kN, angle: rad, speed: knot}
outline: {vertices: [[-40, -10], [40, -10], [40, 10], [-40, 10]], edges: [s, e, n, w]}
robots:
  - {name: Tug 1, edge: s, along: 10, direction: inward, limit: 300, steers: 0.5}
  - {name: Tug 2, edge: s, along: 70, direction: inward, limit: 300, steers: 0.5}
  - {name: Tug 3, edge: n, along: 10, direction: inward, limit: 300, steers: 0.5}
  - {name: Tug 4, edge: n, along: 70, direction: inward, limit: 300, steers: 0.5}
newcomer: {name: Tug 5, limit: 100, attachment: push}
environment:
  wind: {vessel: "container ship, loaded", frontal_area: 400, lateral_area: 1600}
  current: {frontal_area: 40, lateral_area: 160}
"""


@pytest.fixture
def barge(tmp_path):
    """Return the path of a barge whose file says no weather."""
    path = tmp_path / "barge.yaml"
    path.write_text(BARGE)
    return path


def written(path):
    """Return the load of the file with 25 kn from 60 degrees and 1.5 kn of current in it."""
    text = path.read_text().replace("1600", f"1600, speed: 25, from: {math.radians(60)!r}")
    text = text.replace("160}", "160, speed: 1.5}")
    path.with_name("told.yaml").write_text(text + "criterion: {load: environment}\n")
    return load_scenario(path.with_name("told.yaml")).criterion.load


@pytest.mark.parametrize(
    ("command", "more"),
    [("quality", ()), ("move", ()), ("place", ()), ("count", ("--quality", "1e3", "--most", "1"))],
)
def test_the_load_is_that_of_a_file_with_the_weather(run, barge, command, more):
    """Knots, metres per second or Beaufort, degrees, and a current that comes with the wind."""
    expected = written(barge)
    options = ("--wind", "12.861111111111111 m/s", "--from", "60deg", "--current", "1.5")
    status, said, complaints = run(command, barge, *more, *options, "--json", "-")
    assert (status, complaints) == (0, "")
    found = json.loads(said)
    criterion = found.get("problem", found)["criterion"]
    assert criterion["load"] == pytest.approx(expected, rel=1e-9)


def test_quality_and_forces_answer_for_the_weather(run, barge):
    """Held in what was said on the command line; the forces are those that hold it."""
    weather = ("--wind", "6 Bft", "--from", "90", "--current", "1kn", "--current-from", "20deg")
    said = run("quality", barge, *weather, "--waves", "wind")[1]
    assert said.startswith(
        "Barge: held in 26.8 kn from 90 deg, a current of 1 kn from 20 deg and the sea of that "
        "wind from 90 deg, "
    )
    swell = ("--waves", "1.5 m, 7 s", "--waves-from", "-30")
    said = run("quality", barge, "--wind", "0", "--from", "0", *swell)[1]
    assert said.startswith("Barge: held in a sea of 1.5 m and 7 s from 330 deg")
    found = json.loads(run("forces", barge, *weather, "--json", "-")[1])
    assert found["wanted"] == [0.0, 0.0, 0.0]
    total = [sum(vector[k] for vector in found["vectors"]) for k in range(2)]
    assert total == pytest.approx([-part for part in found["load"][:2]], rel=1e-6)


def test_the_answer_names_the_weather(run, barge):
    """In its first line, whatever is asked."""
    weather = ("--wind", "25", "--from", "60")
    for command, *more in (["move"], ["count", "--quality", "1e3"]):
        assert run(command, barge, *more, *weather)[1].startswith("Barge in 25 kn from 60 deg: ")
    assert run("place", barge, *weather)[1].startswith("Barge: held in 25 kn from 60 deg, with ")


def test_compass_points_need_a_heading(run, barge):
    """With the bow to the north-east, a wind from NE is one from ahead."""
    status, _, complaints = run("quality", barge, "--wind", "20", "--from", "NE")
    assert status == 2
    assert complaints.startswith("--from is NE: 'NE' is a true bearing, which needs the heading")
    barge.write_text(f"heading: NE\n{BARGE}")
    told = [
        json.loads(run("quality", barge, "--wind", "20", "--from", way, "--json", "-")[1])
        for way in ("NE", "45 true", "0deg")
    ]
    loads = [found["criterion"]["load"] for found in told]
    assert loads[0] == pytest.approx(loads[2], abs=1e-6)
    assert loads[1] == pytest.approx(loads[2], abs=1e-6)


def test_faults_are_told_together(run, barge):
    """Units of something else, half a weather, and what the file does not say."""
    status, said, complaints = run(
        "quality", barge, "--wind", "25 kN", "--current", "-1", "--waves", "3", "--losing", "x"
    )
    assert (status, said) == (2, "")
    lines = complaints.splitlines()
    assert lines[0].startswith("--losing is x")
    assert lines[1].startswith("--wind is 25 kN: 'kN' is a unit of force, not of speed; did you")
    assert lines[2].startswith("--current is -1; it should be at least 0")
    assert lines[3].startswith("--waves is 3: it should be wind, for the sea that goes with")
    for options, fault in (
        (("--wind", "20"), "--from is missing: where the wind comes from"),
        (("--from", "20"), "--wind is missing: how fast the wind is"),
        (("--current", "1"), "--current-from is missing: where the current comes from"),
        (("--waves-from", "1"), "--waves-from is of no sea: give --waves"),
        (
            ("--wind", "70kn", "--from", "0", "--waves", "wind"),
            "--wind is 70 kn of wind: the sea that goes with it is known up to 63.37 kn; give",
        ),
    ):
        status, _, complaints = run("quality", barge, *options)
        assert status == 2
        assert complaints.startswith(fault)
    # ranges are told in the option's own unit, and amounts below zero are no options
    wind = ("--wind", "-5kn", "--from", "1e23", "--current", "1e5 kn", "--current-from", "-60deg")
    sea = ("--waves", "-2ft,1e9s", "--waves-from", "1e9true")
    assert run("quality", barge, *wind, *sea)[2].splitlines() == [
        "--wind is -5kn; it should be from 0 to 1944 kn",
        "--from is 1e23; it should be from -1e+06 to 1e+06 deg",
        "--current is 1e5 kn; it should be from 0 to 1944 kn",
        "--waves is -2ft,1e9s: the height is -2ft; it should be from 0 to 328.1 ft",
        "--waves is -2ft,1e9s: the period is 1e9s; it should be from 0.001 to 1000 s",
        "--waves-from is 1e9true; it should be from -1e+06 to 1e+06 deg",
    ]
    odd = ("--wind", "300kn", "--from", "0", "--current", "40 kn", "--waves", "9m,2s")
    status, _, complaints = run("quality", barge, *odd)
    assert (status, complaints.splitlines()) == (
        0,
        [
            "warning: --wind is 300kn, faster than any wind",
            "warning: --current is 40 kn, faster than any current",
            "warning: --waves is 9m,2s, higher than such a sea can be",
        ],
    )
    status, _, complaints = run("forces", barge, "--load", "1", "2", "3", "--wind", "3")
    assert "--load and --wind each say the load; keep one" in complaints
    barge.write_text(BARGE.partition("environment")[0])
    status, _, complaints = run("place", barge, "--wind", "20", "--from", "0")
    assert (status, "environment: is missing; say what" in complaints) == (2, True)


def test_weather_is_taken_as_a_whole(run, barge):
    """A storm of the file, whose sea nobody knows, does not keep a breeze from having one."""
    barge.write_text(BARGE.replace("1600", "1600, speed: 80, from: 1"))
    said = run("quality", barge, "--wind", "10", "--from", "60", "--waves", "wind")[1]
    assert said.startswith("Barge: held in 10 kn from 60 deg")
    assert run("capability", barge, "--waves", "wind", "--step", "90")[0] == 0


def test_a_load_of_the_file_gives_way_and_is_told(run, barge):
    """Not in silence; weather in the place of the file's weather needs no word."""
    barge.write_text(f"{BARGE}criterion: {{load: [0, 5, 0]}}\n")
    weather = ("--wind", "20", "--from", "0")
    status, _, complaints = run("quality", barge, *weather)
    assert status == 0
    assert complaints == f"{barge}: the weather given takes the place of the file's load\n"
    own = BARGE.replace("1600", "1600, speed: 9, from: 1")
    barge.write_text(f"{own}criterion: {{load: environment}}\n")
    assert run("quality", barge, *weather)[2] == ""
