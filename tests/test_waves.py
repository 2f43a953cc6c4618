"""The mean drift of waves: the published formula by hand, and the sea that goes with a wind."""

import math
import re
from pathlib import Path

import numpy as np
import pytest

from swarmgrasp import BLENDERMANN, Environment, Outline, Waves, Wind
from swarmgrasp.environment import STEPS, sea_of
from swarmgrasp.environment.waves import aft_fullness_of, bow_angle_of
from swarmgrasp.errors import EnvironmentInvalid

COMPASS = np.radians(np.arange(0.0, 360.0, 15.0))
SHIP = Outline([(-40, -9), (24.4115, -9), (40, 0), (24.4115, 9), (-40, 9)], (0, 0))
"""80 m by 18 m, with a bow of 30 degrees."""


@pytest.mark.parametrize(
    ("degrees", "sea", "expected"),
    [  # worked out apart from this package: T' is 1.58 and 1.90 in the first sea, so f < 1
        (0, (3.1, 8.5, 0.9), (-27079.859, 0.0, 0.0)),
        (45, (3.1, 8.5, 0.9), (-20992.179, 84181.593, 101017.911)),
        (90, (3.1, 8.5, 0.9), (-4653.576, 119050.75, -190481.2)),
        (135, (3.1, 8.5, 0.9), (17623.521, 84181.593, -370399.008)),
        (180, (3.1, 8.5, 0.9), (26141.55, 0.0, 0.0)),
        (0, (1.3, 4.0, 2.0), (-8943.508, 0.0, 0.0)),  # T' < 1, a stern as full as counts: 1.15
        (90, (1.3, 4.0, 2.0), (-2010.22, 61235.825, -97977.32)),
        (180, (1.3, 4.0, 2.0), (14096.246, 0.0, 0.0)),
    ],
)
def test_drift_is_that_of_the_standard(degrees, sea, expected):
    """DNV-ST-0111, 3.7, for a hull of 80 m by 18 m with a bow of 30 degrees."""
    height, period, full = sea
    waves = Waves(bow_angle=math.radians(30.0), aft_fullness=full)
    found = waves.load(SHIP, math.radians(degrees), height, period)
    np.testing.assert_allclose(found, expected, rtol=1e-7, atol=2e-3)


def test_bow_and_stern_are_of_the_outline():
    """A bow of 30 degrees to the quarter of the beam, a box aft; at any place and scale."""
    told = Waves(bow_angle=math.radians(30.0), aft_fullness=1.0)
    assert bow_angle_of(SHIP) == pytest.approx(math.radians(30.0), rel=1e-5)
    assert aft_fullness_of(SHIP) == pytest.approx(1.0)
    np.testing.assert_allclose(
        Waves().load(SHIP, COMPASS, 2.0, 7.0), told.load(SHIP, COMPASS, 2.0, 7.0), rtol=1e-5
    )
    moved = Outline(3.0 * SHIP.vertices + (500.0, -20.0))
    assert bow_angle_of(moved) == pytest.approx(bow_angle_of(SHIP))
    lobes = Outline([(0, 0), (4, 0), (4, 1), (3, 1), (3, 2), (4, 2), (4, 3), (0, 3)])
    assert bow_angle_of(lobes) == pytest.approx(math.pi / 2)  # a notch between two bows
    assert aft_fullness_of(lobes) == 1.0


def test_waves_push_the_way_they_go_and_port_mirrors_starboard():
    """Ahead they push astern, abeam to leeward; moments are about the origin."""
    waves = Waves(2.0, 7.0)
    loads = waves.load(SHIP, COMPASS, 2.0, 7.0)
    np.testing.assert_allclose(waves.load(SHIP, -COMPASS, 2.0, 7.0), loads * [1, -1, -1], atol=1e-6)
    assert loads[0, 0] < 0.0 < loads[6, 1]
    aside = Outline(SHIP.vertices, (7.0, -2.0))
    moved = loads[:, 2] - 7.0 * loads[:, 1] - 2.0 * loads[:, 0]
    np.testing.assert_allclose(
        waves.load(aside, COMPASS, 2.0, 7.0)[:, 2], moved, rtol=1e-9, atol=1e-5
    )


def test_the_sea_goes_with_the_wind_or_is_given():
    """By the steps and straight lines between; a given sea is the same in every wind."""
    heights, periods = sea_of([step.wind for step in STEPS])
    assert heights.tolist() == [step.height for step in STEPS]
    assert periods.tolist() == [step.period for step in STEPS]
    wind = Wind(160.0, 430.0, BLENDERMANN["tender"], speed=12.25, bearing=0.4)
    growing = Environment(wind, waves=Waves(), dynamic_factor=1.25)
    expected = 1.25 * (wind.load(SHIP, 0.4, 12.25) + Waves().load(SHIP, 0.4, 2.6, 8.0))
    np.testing.assert_allclose(growing.load(SHIP), expected)
    swell = Environment(wind, waves=Waves(1.0, 9.0, bearing=-2.0))
    drift = swell.wave_load(SHIP, [0.0, 1.0], [3.0, 60.0])
    np.testing.assert_allclose(drift, 2 * [Waves().load(SHIP, -2.0, 1.0, 9.0)])
    assert not Environment(wind).wave_load(SHIP, COMPASS, 20.0).any()


def test_faults_are_told_together():
    """What is outside its range, half a sea, and a wind whose sea nobody told."""
    with pytest.raises(EnvironmentInvalid) as caught:
        Waves(height=-1.0, bow_angle=9.0)
    assert [fault.split(" is ")[0] for fault in caught.value.faults[:2]] == [
        "waves: the height", "waves: the bow angle"
    ]  # fmt: skip
    assert "the height and the period of waves go together" in caught.value.faults[2]
    storm = Wind(160.0, 430.0, BLENDERMANN["tender"], speed=40.0, bearing=0.0)
    with pytest.raises(EnvironmentInvalid, match=r"0 <= speed <= 32\.6 \[m/s\]: give the waves"):
        Environment(storm, waves=Waves())
    with pytest.raises(EnvironmentInvalid, match="is no Waves"):
        Environment(storm, waves=1.0)  # type: ignore[arg-type]


def test_the_page_lists_the_steps_in_use():
    """Number by number, the printed table is the one computed with."""
    page = (Path(__file__).parents[1] / "docs" / "environment.md").read_text(encoding="utf-8")
    rows = re.findall(r"^\| (\d+) \|" + 4 * r" ([\d.]+) \|" + "$", page, re.MULTILINE)
    assert [int(row[0]) for row in rows] == list(range(len(STEPS)))
    assert [tuple(map(float, row[1:])) for row in rows] == [tuple(step) for step in STEPS]
