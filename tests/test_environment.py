"""Wind and current: the published formulas, in the object's own frame."""

import math
import re
from pathlib import Path

import numpy as np
import pytest

from swarmgrasp import (
    BLENDERMANN,
    Current,
    CurrentCoefficients,
    Environment,
    Outline,
    Wind,
    WindCoefficients,
)
from swarmgrasp.environment import KNOT, beaufort_number, vessel_type
from swarmgrasp.errors import EnvironmentInvalid
from swarmgrasp.scenario import load_example, parse_scenario

COMPASS = np.radians(np.arange(0.0, 360.0, 15.0))


def box(length, beam=18.0, origin=(0.0, 0.0), midship=(0.0, 0.0)):
    """Return the outline of a box about midship."""
    (x, y), a, b = midship, 0.5 * length, 0.5 * beam
    return Outline([(x - a, y - b), (x + a, y - b), (x + a, y + b), (x - a, y + b)], origin)


@pytest.fixture
def research_vessel():
    """Return the vessel of 55 m whose coefficients Fossen's toolbox plots."""
    return Wind(160.7, 434.8, BLENDERMANN["research vessel"], lateral_centroid=1.48)


@pytest.mark.parametrize(
    ("degrees", "surge", "sway", "yaw"),
    [
        (0.0, -0.55, 0.0, 0.0),
        (45.0, -0.503934, 0.778808, 0.131058),  # by hand: CD_l/CD_t = 0.239150, D = 0.771745
        (90.0, 0.0, 0.85, 0.85 * 1.48 / 55.0),
        (180.0, 0.65, 0.0, 0.0),
    ],
)
def test_wind_coefficients_are_blendermanns(research_vessel, degrees, surge, sway, yaw):
    """C_X, C_Y and C_N of a published vessel: ahead, abeam and astern as tabled, 45 by hand."""
    found = research_vessel.load(box(55.0), math.radians(degrees), 20.0)
    pressure = 0.5 * 1.226 * 20.0**2
    unit = pressure * np.array([160.7, 434.8, 434.8 * 55.0])
    np.testing.assert_allclose(found / unit, [surge, sway, yaw], atol=1e-6)


@pytest.mark.parametrize(
    ("degrees", "expected"),
    [
        (0.0, (-3878.28, 0.0, 0.0)),
        (30.0, (-3358.6890, 75411.0, 75411.0 * 18.5)),  # the arm's upper limit: 0.25 L
        (45.0, (-2742.3581, 106647.2589, 106647.2589 * 14.5)),
        (90.0, (0.0, 150822.0, 150822.0 * -1.5)),
        (150.0, (3358.6890, 75411.0, 75411.0 * -17.5)),  # the lower one: -0.2 L
        (180.0, (3878.28, 0.0, 0.0)),
    ],
)
def test_current_loads_are_those_of_the_standard(degrees, expected):
    """DNV-ST-0111, 3.6, by hand: 80 x 18 x 6 m at 1 m/s, where rho V^2 / 2 is 513 Pa."""
    current = Current(18.0 * 6.0, 490.0, lateral_centroid=-1.5)
    found = current.load(box(80.0), math.radians(degrees), 1.0)
    np.testing.assert_allclose(found, expected, rtol=1e-7, atol=1e-6)


def test_bearings_are_clockwise_and_where_it_comes_from(research_vessel):
    """A wind from the starboard bow pushes astern and to port, and the bow to port."""
    surge, sway, yaw = research_vessel.load(box(55.0), math.radians(40.0), 10.0)
    assert surge < 0.0 < min(sway, yaw)


@pytest.mark.parametrize("kind", list(BLENDERMANN))
def test_port_mirrors_starboard_at_any_turn(kind):
    """Sway and yaw change sign, surge does not; a turn more is the same bearing."""
    hull = box(90.0)
    wind = Wind(300.0, 900.0, BLENDERMANN[kind], 4.0)
    current = Current(100.0, 500.0, lateral_centroid=2.0)
    for part in (wind, current):
        starboard, port = (part.load(hull, sign * COMPASS, 3.0) for sign in (1, -1))
        np.testing.assert_allclose(port, starboard * [1, -1, -1], atol=1e-6)
        np.testing.assert_allclose(
            part.load(hull, COMPASS + 6.0 * math.pi, 3.0), starboard, rtol=1e-9, atol=1e-5
        )


def test_forces_never_push_upwind():
    """Whatever the bearing, the force has no part towards where the wind comes from."""
    wind = Wind(300.0, 900.0, BLENDERMANN["car carrier"])
    force = wind.load(box(90.0), COMPASS, 10.0)[:, :2]
    towards = np.column_stack([np.cos(COMPASS), -np.sin(COMPASS)])
    assert ((force * towards).sum(axis=1) < 0.0).all()


def test_moments_are_about_the_origin(research_vessel):
    """Moved by r, the same force has the moment r x F more."""
    here = research_vessel.load(box(55.0), COMPASS, 10.0)
    there = research_vessel.load(box(55.0, origin=(7.0, -2.0), midship=(3.0, 1.0)), COMPASS, 10.0)
    np.testing.assert_allclose(there[:, :2], here[:, :2])
    arm_x, arm_y = 3.0 - 7.0, 1.0 + 2.0
    moved = here[:, 2] + arm_x * here[:, 1] - arm_y * here[:, 0]
    np.testing.assert_allclose(there[:, 2], moved, rtol=1e-9, atol=1e-6)


def test_loads_grow_with_the_square_of_speed_and_with_the_allowance(research_vessel):
    """Twice the speed, four times the load; speeds and bearings broadcast."""
    weather = Environment(research_vessel, dynamic_factor=1.25)
    loads = weather.wind_load(box(55.0), 0.7, [10.0, 20.0])
    np.testing.assert_allclose(loads[1], 4.0 * loads[0])
    plain = Environment(research_vessel).wind_load(box(55.0), 0.7, 10.0)
    np.testing.assert_allclose(loads[0], 1.25 * plain)
    assert weather.wind_load(box(55.0), COMPASS[:, None], [1.0, 2.0]).shape == (24, 2, 3)


def test_the_current_comes_alongside_the_wind_or_from_its_own_bearing(research_vessel):
    """The steady load is the sum of both."""
    hull = box(55.0)
    wind = Wind(**{**vars(research_vessel), "speed": 12.0, "bearing": 0.5})
    current = Current(60.0, 300.0, speed=0.8)
    alongside = Environment(wind, current).load(hull)
    expected = wind.load(hull, 0.5, 12.0) + current.load(hull, 0.5, 0.8)
    np.testing.assert_allclose(alongside, expected)
    across = Environment(wind, Current(60.0, 300.0, speed=0.8, bearing=-2.0))
    np.testing.assert_allclose(
        across.load(hull) - alongside,
        current.load(hull, -2.0, 0.8) - current.load(hull, 0.5, 0.8),
    )
    assert not Environment(wind).current_load(hull, COMPASS).any()


def test_faults_are_told_together():
    """Every number outside its range, with the range."""
    with pytest.raises(EnvironmentInvalid) as caught:
        Wind(0.0, math.nan, "tender", speed=10.0, density=-1.0)  # type: ignore[arg-type]
    faults = caught.value.faults
    assert [fault.split(" is ")[0] for fault in faults[:3]] == [
        "wind: the frontal area", "wind: the lateral area", "wind: the density"
    ]  # fmt: skip
    assert "BLENDERMANN['tender']" in faults[3]
    assert faults[4].endswith("go together; give both or neither")
    with pytest.raises(EnvironmentInvalid, match=r"the speed is 2000\.0; it should be 0 <= speed"):
        Current(1.0, 1.0, speed=2000.0)
    with pytest.raises(EnvironmentInvalid, match="is no Wind"):
        Environment(Current(1.0, 1.0))  # type: ignore[arg-type]
    with pytest.raises(EnvironmentInvalid, match=r"dynamic factor is 0\.5"):
        Environment(Wind(1.0, 1.0, BLENDERMANN["ferry"]), dynamic_factor=0.5)
    with pytest.raises(EnvironmentInvalid, match="no speed and bearing"):
        Environment(Wind(1.0, 1.0, BLENDERMANN["ferry"])).load(box(9.0))
    with pytest.raises(EnvironmentInvalid, match="cross-force parameter is 2"):
        WindCoefficients(1.0, 1.0, 1.0, 2.0)
    with pytest.raises(EnvironmentInvalid, match="surge coefficient is -1"):
        CurrentCoefficients(-1.0)


def test_types_of_vessel_are_told_apart():
    """Each row of the table is its own: coefficients lead back to their name."""
    assert len(BLENDERMANN) == 17
    assert all(vessel_type(row) == kind for kind, row in BLENDERMANN.items())


def test_the_beaufort_scale():
    """Its steps are those of the World Meteorological Organization, each by its strongest wind."""
    most = [0.2, 1.5, 3.3, 5.4, 7.9, 10.7, 13.8, 17.1, 20.7, 24.4, 28.4, 32.6]
    assert [beaufort_number(speed) for speed in most] == list(range(12))
    assert [beaufort_number(speed + 0.1) for speed in most] == [*range(11), 12]
    assert beaufort_number(34.0 * KNOT) == 7  # the weakest gale, where Beaufort 8 begins


PAGE = (Path(__file__).parents[1] / "docs" / "environment.md").read_text(encoding="utf-8")


def test_the_page_lists_the_coefficients_in_use():
    """Type by type, the printed table is the one computed with."""
    row = r"^\| ([a-z, ]+) " + 4 * r"\| ([\d.]+) " + r"\|$"
    rows = re.findall(row, PAGE, re.MULTILINE)
    assert {name: WindCoefficients(*map(float, values)) for name, *values in rows} == dict(
        BLENDERMANN
    )


def test_the_page_shows_what_runs(tmp_path, monkeypatch, capsys):
    """Its YAML and its Python say the same environment, and draw a plot of it."""
    vessel = load_example("supply-vessel")
    (yaml,) = re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL)
    hull = "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}\nrobots: []\n"
    told = parse_scenario(yaml + hull).environment
    assert told == vessel.environment
    monkeypatch.chdir(tmp_path)
    (code,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    names = {"swarm": vessel.swarm}
    exec(code, names)
    assert names["weather"].wind == told.wind
    assert (tmp_path / "capability.png").exists()
    intact, after_loss = map(float, capsys.readouterr().out.split())
    assert intact > after_loss > 25.0
