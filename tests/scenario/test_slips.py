"""What is probably a slip is told, and nothing is told of files that are merely unusual."""

from dataclasses import replace
from pathlib import Path

import pytest

from swarmgrasp import Newcomer, Outline, Robot, Swarm, quality
from swarmgrasp.cli import main
from swarmgrasp.errors import DirectionWarning, FrictionWarning, ScenarioWarning
from swarmgrasp.scenario import example_names, load_example, load_scenario, parse_scenario

CASES = Path(__file__).parents[1] / "data" / "cases"
SLIPS = {
    "catamaran-degrees-as-radians": "7:55: robots.0.direction: 45 rad is 7.16 turns; for degrees, "
    "write units: {angle: deg}, or 45 deg here. There are 3 more like it.",
    "catamaran-radians-as-degrees": "7:55: robots.0.direction: 0.785398 deg is next to nothing, "
    "and as radians it is a common angle; for radians, write units: {angle: rad}, or 0.785398 rad "
    "here.",
    "barge-forgot-degrees": "4:47: robots.0.direction: 90 rad is 14.3 turns; for degrees, write "
    "units: {angle: deg}, or 90 deg here. There are 4 more like it.",
    "catamaran-ned": "5:11: outline.edges.0: 'port' and 'starboard' lie on the other side as the "
    "file is read, with y to port; if y runs to starboard in it, write frame: NED",
    "hull-bow-along-y": "14:62: environment.wind.lateral_area: is larger than the frontal area, "
    "and so the object should be longest along its bow; but the outline is 13.16 m along the bow "
    "and 133 m across it. Say which way the bow points, such as by bow: +y",
    "basin-longitude-latitude": "4:13: outline.vertices: these look like longitude and latitude, "
    "and are read as an object 0.00437 m across; give coordinates in m from a point nearby",
}
HONEST = ["catamaran", "barge-degrees", "hull-bow-along-x", "rov-toe-out", "dock-one-robot"]
SQUARE = "outline: {vertices: [[0, 0], [40, 0], [40, 20], [0, 20]]%s}\nrobots:\n"


def slips(text: str) -> list[str]:
    """Return the slips of a text without the file's name."""
    return [slip.removeprefix("a.yaml:") for slip in parse_scenario(text, "a.yaml").warnings]


@pytest.mark.parametrize("name", SLIPS)
def test_a_slip_in_a_file_is_told_with_its_place(name: str) -> None:
    """With what is to be written instead; Python warns where the file is read."""
    path = CASES / f"{name}.yaml"
    with pytest.warns(ScenarioWarning) as caught:
        scenario = load_scenario(path)
    assert scenario.warnings == (f"{path}:{SLIPS[name]}",)
    assert [str(one.message) for one in caught] == list(scenario.warnings)
    assert caught[0].filename == __file__


def test_what_is_written_instead_has_no_slip() -> None:
    """The boat with its y to starboard is then the boat with its y to port."""
    mended = (CASES / "catamaran-ned.yaml").read_text().replace("units:", "frame: NED\nunits:")
    assert slips(mended) == []
    assert quality(parse_scenario(mended).swarm).value == pytest.approx(396.9525, rel=1e-6)
    hull = (CASES / "hull-bow-along-y.yaml").read_text().replace("units:", "bow: +y\nunits:")
    assert slips(hull) == []


@pytest.mark.parametrize("name", HONEST)
def test_an_honest_file_has_no_slip(name: str) -> None:
    """Nor does any built-in scenario."""
    load_scenario(CASES / f"{name}.yaml")


def test_no_built_in_scenario_has_a_slip() -> None:
    """They are what people start from."""
    assert [slip for name in example_names() for slip in load_example(name).warnings] == []


@pytest.mark.parametrize(
    ("robots", "slip"),
    [
        (
            "  - {name: stern port, at: 5, direction: inward, limit: 5}\n",
            "4:12: robots.0.name: 'stern port' lies to starboard as the file is read, with y to "
            "port; if y runs to starboard in it, write frame: NED",
        ),
        (
            "  - {name: bow tug, contact: [0, 10], direction: inward, limit: 5}\n",
            "4:12: robots.0.name: 'bow tug' lies aft of the middle; say which way the bow points, "
            "by bow",
        ),
        (
            "  - {name: a, at: 5, direction: inward, limit: 60}\n"
            "  - {name: b, at: 9, direction: inward, limit: 60000}\n",
            "4:48: robots.0.limit: 60 kN is 1000 times less than the 60000 kN of b; are both in "
            "kN?",
        ),
        ("  - {name: Port Said, at: 5, direction: inward, limit: 5}\n", None),
        ("  - {name: a, at: 5, direction: 400 deg, limit: 5}\n", None),
        ("  - {name: a, at: 5, direction: 0.0005, limit: 5}\n", None),
    ],
)
def test_slips_of_robots(robots: str, slip: str | None) -> None:
    """By their names and their limits; a harbour is no side."""
    head = "units: {force: kN, angle: deg}\n"
    assert slips(head + SQUARE % "" + robots) == ([slip] if slip else [])


def test_an_edge_drawn_the_other_way_round_is_on_its_side() -> None:
    """Sides are told of the places of edges, whichever way the vertices run."""
    edges = ", edges: [starboard, bow, port, stern]"
    assert slips(SQUARE % edges + "  []\n") == []
    turned = "frame: NED\n" + SQUARE % edges + "  []\n"
    assert slips(turned) == [
        "2:67: outline.edges.0: 'starboard' and 'port' lie on the other side "
        "as the file is read, with y to starboard; if y runs to port in it, leave out frame: NED"
    ]


def test_the_command_line_tells_slips_apart_from_answers(capsys: pytest.CaptureFixture) -> None:
    """On standard error, once; the answer is what it is."""
    path = CASES / "barge-forgot-degrees.yaml"
    assert main(["quality", str(path)]) == 0
    out, err = capsys.readouterr()
    assert err == f"warning: {path}:{SLIPS['barge-forgot-degrees']}\n"
    assert "warning" not in out


def test_a_robot_with_degrees_is_told_of() -> None:
    """Once, where it is made; not where a swarm takes it up, nor of what code has turned."""
    outline = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    with pytest.warns(DirectionWarning, match="the direction 90 rad is 14.3 turns") as caught:
        degrees = Robot((0, -1), 90, name="Ajax")
    assert [one.filename for one in caught] == [__file__]
    with pytest.warns(DirectionWarning) as caught:
        replace(degrees, direction=80)
    assert [one.filename for one in caught] == [__file__]
    again = Swarm(outline, [degrees, Robot((0, 1), 9.0, name="Boreas")]).without("Boreas")
    assert again.robots[0].direction == 90.0


UNREAL = """
units: {{length: ft, force: kN}}
outline: {{vertices: [[0, 0], [40, 0], [40, 20], [0, 20]]}}
robots: [{{at: 1, limit: 50, friction: {0}, tolerance: {{direction: {1}, least_limit: {2}}}}}]
tolerance: {{direction: [-{1}, 0], least_limit: {3}}}
newcomer: {{limit: 5, friction: {0}, attachment: push}}
environment:
  wind:
    coefficients: {{transverse: {4}, bow: 0.7, stern: 0.7}}
    frontal_area: 1
    lateral_area: 2
    density: {5}
    speed: {6}
    from: 0
  current: {{frontal_area: 1, lateral_area: 2, density: {7}, speed: {8}}}
  waves: {{height: {9}, period: 3, density: {7}}}
  dynamic_factor: {4}
"""


def test_numbers_beyond_anything_real_are_told() -> None:
    """Each with its key; nothing is told of what is merely much."""
    assert slips(UNREAL.format(1.5, 0.5, 3, 1, 2.5, 1.1, 40, 1000, 4, 6)) == []
    odd = slips(UNREAL.format(900, 3, 0.9, 0.2, 9, 1225, 121, 1.025, 16, 8))
    told = dict(slip.split(": ", 2)[1:] for slip in odd)
    assert told.pop("robots.0.friction") == told.pop("newcomer.friction")
    assert told == {
        "robots.0.tolerance.direction": "3 rad is 172 deg; for degrees, write 3 deg",
        "robots.0.tolerance.least_limit": "0.9 kN is 1.8 % of the limit, 50 kN; a share of 0.9 is "
        "45 kN",
        "tolerance.direction": "3 rad is 172 deg; for degrees, write 3 deg",
        "tolerance.least_limit": "0.2 kN is 4 % of the limit, 5 kN; a share of 0.2 is 1 kN",
        "environment.wind.coefficients.transverse": "9 is beyond any real drag: a flat plate "
        "across has about 2",
        "environment.wind.density": "1225 kg/m^3 is no air, which has about 1.226; it is in kg/m^3 "
        "whatever the units",
        "environment.wind.speed": "121 m/s is faster than any wind; is it in m/s?",
        "environment.current.density": "1.025 kg/m^3 is no water, which has about 1026; it is in "
        "kg/m^3 whatever the units",
        "environment.current.speed": "16 m/s is faster than any current; is it in m/s?",
        "environment.waves.density": "1.025 kg/m^3 is no water, which has about 1026; it is in "
        "kg/m^3 whatever the units",
        "environment.waves.height": "a sea with a period of 3 s breaks before it is 8 ft high; it "
        "is at most 6.59 ft then",
        "environment.dynamic_factor": "multiplies all loads by 9; an allowance is 1 to 1.5",
    }
    assert slips(UNREAL.format(1, 0.5, 3, 1, 1, 1, 1, 1e3, 1, 100))[0].endswith("is it in ft?")


def test_friction_beyond_anything_real_is_told_where_a_robot_is_made() -> None:
    """Not where a swarm takes it up, nor of what a file says, which has a slip."""
    with pytest.warns(FrictionWarning, match="Ajax: the friction 900 is beyond") as caught:
        finger = Robot((0, -1), 1.5, name="Ajax", friction=900)
    with pytest.warns(FrictionWarning, match="newcomer: the friction 6 is") as sent:
        Newcomer(1.0, "push", friction=6)
    assert [one.filename for one in (*caught, *sent)] == [__file__] * 2
    assert Swarm(Outline([(-1, -1), (1, -1), (1, 1)]), [finger]).robots[0].friction == 900.0
    parse_scenario(SQUARE % "" + "  [{at: 5, limit: 5, friction: 900}]")


def test_lines_and_bodies_in_the_way_are_told() -> None:
    """A line through the object, with where it meets it, and two tugs in one place."""
    text = """
units: {length: ft, force: kN, angle: deg}
outline:
  vertices: [[-30, -20], [30, -20], [30, -14], [-24, -14], [-24, 14], [30, 14], [30, 20], [-30, 20]]
robots:
  - {name: Ajax, contact: [12.96, 14], direction: -150, limit: 300, length: 8, beam: 4}
  - {name: Boreas, contact: [8, 14], direction: -90, limit: 300, length: 8, beam: 4}
  - {name: Castor, contact: [14, -14], direction: 60, limit: 300}
  - {name: Dione, contact: [-30, 0], direction: 0, limit: 300}
"""
    told = parse_scenario(text, "dock.yaml").warnings
    assert told[0].startswith("dock.yaml:6:5: robots.0: the line of Ajax runs through the object")
    assert "it meets edge 3 at (-24, -7.339) ft, after 42.68 ft" in told[0]
    assert any("Ajax and Boreas" in each or "Boreas and Ajax" in each for each in told)
    assert len(told) == 3  # Boreas's line meets the other side
