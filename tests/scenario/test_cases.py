"""Files as their owners have them, and what is right for them by other means."""

from pathlib import Path

import numpy as np
import pytest

from swarmgrasp import capability, place, quality
from swarmgrasp.environment import KNOT
from swarmgrasp.errors import ScenarioInvalid, ScenarioWarning
from swarmgrasp.scenario import Scenario, load_scenario, parse_scenario

CASES = Path(__file__).parents[1] / "data" / "cases"


def read(name: str, *changes: tuple[str, str]) -> Scenario:
    """Return a case, with changes to its text."""
    text = (CASES / f"{name}.yaml").read_text(encoding="utf-8")
    for old, new in changes:
        assert old in text
        text = text.replace(old, new)
    return parse_scenario(text, f"{name}.yaml")


def told(name: str) -> list[str]:
    """Return the faults of a case without its name."""
    with pytest.raises(ScenarioInvalid) as caught:
        read(name)
    return [fault.removeprefix(f"{name}.yaml:") for fault in caught.value.faults]


@pytest.mark.parametrize(
    ("name", "wanted"),
    [
        ("catamaran", 396.9525),  # an oracle's, as all of these
        ("catamaran-degrees-as-radians", 369.10),
        ("catamaran-radians-as-degrees", 9.68),
        ("barge-degrees", 300.0),
        ("barge-forgot-degrees", 238.24),
    ],
)
def test_a_file_means_what_it_says(name: str, wanted: float) -> None:
    """Also where it says what nobody means: that is told, and not guessed away."""
    assert quality(read(name).swarm).value == pytest.approx(wanted, rel=5e-4)


def test_a_half_angle_in_degrees_is_beyond_any_in_radians() -> None:
    """It is refused, with the range in the unit of the file."""
    assert told("barge-half-angle") == [
        "3:54: newcomer.half_angle: should lie in [0, 1.57079633] rad (got 30)"
    ]


@pytest.mark.parametrize("name", ["hull-bow-along-x", "hull-bow-along-y"])
def test_a_hull_holds_the_same_wind_whichever_way_it_is_drawn(name: str) -> None:
    """Blendermann's loads and a linear program, written again elsewhere, give these winds."""
    scenario = read(name, *[("units:", "bow: +y\nunits:")] * name.endswith("y"))
    assert scenario.environment is not None
    bearings = np.radians([45.0, 90.0, 135.0])
    found = capability(scenario.swarm, scenario.environment, bearings, losing=0)
    assert found.intact / KNOT == pytest.approx([49.56, 44.55, 35.30], abs=0.005)


def test_quantities_in_a_file() -> None:
    """A pull of 50 t, 90 deg to a file of kilonewtons and degrees."""
    scenario = read("barge-quantities")
    assert scenario.swarm.limits.tolist() == pytest.approx([490332.5], rel=1e-15)
    assert scenario.swarm.robots[0].direction == pytest.approx(np.pi / 2.0, rel=1e-15)
    assert scenario.newcomer is not None
    assert scenario.newcomer.limit == pytest.approx(588399.0, rel=1e-15)


def test_words_of_others_are_told_by_ours() -> None:
    """Whatever is near by its letters."""
    faults = [fault.partition(": ")[2] for fault in told("barge-mistakes")]
    for key, meant in (
        ("robots.0.bollard_pull", "limit"),
        ("robots.0.heading", "direction"),
        ("robots.1.position", "contact"),
        ("robots.1.angle", "direction"),
        ("newcomer.azimuth", "steers"),
        ("thrusters", "robots"),
    ):
        assert f"{key}: unknown key; did you mean {meant!r}?" in faults
    assert not [fault for fault in faults if fault.startswith("frame")]
    assert told("barge-horsepower") == [
        "1:27: units.force: there is no unit of force 'hp'; known: N, kN, MN, kgf, tf, lbf, kip "
        "(got 'hp')",
        "11:62: newcomer.half_angle: should lie in [0, 1.57079633] rad (got 30)",
    ]


def test_wishes_are_told_by_what_there_is() -> None:
    """What can be said otherwise is told how; limits ahead and astern, and of cables, are read."""
    faults = told("raft-wishes")
    said = {fault.split(": ")[1]: fault for fault in faults}
    assert "steers: any" in said["robots.1.direction"]
    assert "sectors" in said["robots.2.direction"]
    assert "{ahead: .., astern: ..}" in said["robots.4.two_way"]
    assert "write it at the left margin" in said["environment.heading"]
    assert not {"robots.0.limit", "robots.3.limit", "environment.wind.speed"} & said.keys()


def test_limits_of_several_numbers_take_units() -> None:
    """Ahead and astern, and least and largest, each with its own."""
    outline = "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}\n"
    scenario = parse_scenario(
        f"{outline}robots:\n"
        "  - {at: 1, direction: inward, limit: {ahead: 51 kN, astern: 4 t}}\n"
        "  - {at: 2, direction: inward, limit: [200 kgf, 20kN]}\n"
    )
    both, cable = scenario.swarm.robots
    assert (both.limit, both.reverse_limit) == (51e3, 4 * 9806.65)
    assert (cable.least, cable.limit) == (200 * 9.80665, 20e3)


def test_toed_out_thrusters_lose_what_their_cosine_loses() -> None:
    """20 cos 30 degrees ahead, of 20: less than its owner feared."""
    scenario = read("rov-toe-out")
    found = quality(scenario.swarm, **scenario.criterion.keywords)
    assert found.value == pytest.approx(20.0 * np.cos(np.pi / 6.0), rel=1e-9)


def test_a_second_robot_of_four_needed_adds_exactly_nothing() -> None:
    """No trace of rounding is told as a quality."""
    answer = place(read("dock-one-robot").problem())
    assert (answer.quality, answer.upper_bound) == (0.0, 0.0)


def test_a_basin_in_degrees_of_the_globe_is_read_with_a_warning() -> None:
    """As the 4 mm that it says."""
    with pytest.warns(ScenarioWarning, match="longitude and latitude"):
        scenario = load_scenario(CASES / "basin-longitude-latitude.yaml")
    assert scenario.swarm.outline.extent == pytest.approx(0.00437, rel=1e-3)


@pytest.mark.parametrize(
    ("encoding", "change", "said"),
    [
        ("utf-8", ("", ""), None),
        ("utf-8-sig", ("", ""), None),
        ("utf-8", ("\n", "\r\n"), None),
        ("latin-1", ("Barge", "Bargé"), "6:7: not UTF-8 (byte 0xe9); save it as UTF-8"),
        ("utf-16", ("", ""), "1:1: not UTF-8 (byte 0xff); save it as UTF-8"),
        (
            "utf-8",
            ("  - {name: a", "\t- {name: a"),
            "4:1: not valid YAML: a tab stands where spaces should; indent with spaces",
        ),
        (
            "utf-8",
            ("limit: 60tf", "limit: 60,5"),
            "5:22: newcomer: a key should be text (got 5); decimals go after a point",
        ),
        (
            "utf-8",
            ("robots:", "name: Barge: loaded\nrobots:"),
            "3:12: not valid YAML: a colon makes a key here; put a text with a colon in quotes",
        ),
    ],
)
def test_files_as_editors_save_them(
    tmp_path: Path, encoding: str, change: tuple[str, str], said: str | None
) -> None:
    """They are read, or refused in one line that says what to do."""
    path = tmp_path / "barge.yaml"
    text = (CASES / "barge-quantities.yaml").read_text(encoding="utf-8") + "# Barge\n"
    path.write_bytes(text.replace(*change).encode(encoding) if change[0] else text.encode(encoding))
    if said is None:
        assert len(load_scenario(path).swarm) == 1
        return
    with pytest.raises(ScenarioInvalid) as caught:
        load_scenario(path)
    assert caught.value.faults == (f"{path}:{said}",)
