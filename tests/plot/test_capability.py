"""The capability diagram shows what was found, where seamen look for it."""

import math
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from matplotlib.figure import Figure

from swarmgrasp import (
    BLENDERMANN,
    Current,
    Environment,
    Outline,
    Robot,
    Swarm,
    Waves,
    Wind,
    WindCoefficients,
    capability,
    capability_numbers,
    place,
    thrust_use,
)
from swarmgrasp.environment import KNOT
from swarmgrasp.plot import capability_diagram, numbers_diagram, save, thrust_use_picture
from swarmgrasp.scenario import load_example

BEARINGS = np.radians(np.arange(0.0, 360.0, 15.0))


def by_gid(figure, gid):
    return figure.findobj(lambda artist: artist.get_gid() == gid)


def texts(figure, gid=None):
    found = [artist for artist in figure.findobj() if hasattr(artist, "get_text")]
    return [a.get_text() for a in found if gid is None or a.get_gid() == gid]


def line(figure, gid):
    """Return the points of an envelope, (k, 2) [kn]."""
    (found,) = by_gid(figure, gid)
    return np.column_stack(found.get_data())


@pytest.fixture(scope="module")
def vessel():
    scenario = load_example("supply-vessel")
    return capability(scenario.swarm, scenario.environment, BEARINGS)


def test_the_radius_is_the_wind_held_clockwise_from_the_bow(vessel):
    """Every bearing has its point, ahead is up, starboard on the right; none beyond 100 kn."""
    figure = capability_diagram(vessel)
    for gid, speeds in (("intact", vessel.intact), ("after-loss", vessel.after_loss)):
        drawn = line(figure, gid)
        is_cut = speeds >= 100.0 * KNOT
        assert is_cut.any()
        for bearing, radius, cut in zip(BEARINGS, speeds / KNOT, is_cut, strict=True):
            point = min(100.0, radius) * np.array([math.sin(bearing), math.cos(bearing)])
            nearest = np.nanmin(np.hypot(*(drawn - point).T))
            assert nearest > 1.0 if cut else nearest < 1e-6
        assert np.nanmax(np.hypot(*drawn.T)) < 100.0
    said = " ".join(texts(figure))
    assert "Where no line is drawn, more than 100 kn is held." in said


def test_the_least_is_marked_and_told(vessel):
    """In knots, metres per second and Beaufort, with where it comes from and what is lost."""
    figure = capability_diagram(vessel, "Hermod")
    said = texts(figure)
    assert "Hermod" in said
    for speed in (vessel.intact.min(), vessel.after_loss.min()):
        assert f"{speed / KNOT:.3g} kn" in said
        assert f"{speed:.3g} m/s" in said
    assert "port propeller" in said
    marks = np.array([np.ravel(mark.get_data()) for mark in by_gid(figure, "worst")])
    np.testing.assert_allclose(
        np.hypot(*marks.T), [vessel.intact.min() / KNOT, vessel.after_loss.min() / KNOT]
    )


def test_small_print_tells_what_was_taken_into_account(vessel):
    """Coefficients, areas, current, allowance, and that there are no waves."""
    said = " ".join(texts(capability_diagram(vessel)))
    for part in (
        "Blendermann (1994), offshore supply vessel",
        "280 m² ahead, 700 m² abeam",
        "Current 1.5 kn (0.772 m/s) with the wind",
        "loads times 1.25",
        "no waves",
    ):
        assert part in said


def test_the_hull_lies_bow_up_and_the_lost_thruster_stands_out(vessel):
    """The outline turned by a quarter; both arrows of the propeller have another colour."""
    figure = capability_diagram(vessel)
    (hull,) = by_gid(figure, "hull")
    corners = hull.get_xy()
    assert np.ptp(corners[:, 1]) == pytest.approx(0.56 * 100.0)
    assert corners[np.argmax(corners[:, 1]), 0] == pytest.approx(0.0)  # the stem is above
    (lost,) = by_gid(figure, "lost")
    (others,) = by_gid(figure, "robot")
    assert (lost.N, others.N) == (2, 10)
    assert (np.asarray(lost.XY)[:, 0] < 0.0).all()  # the port propeller is on the left


def test_rings_are_round_numbers_of_knots():
    """As few as are easily counted, whatever the speeds, up to 100 knots."""
    outline = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    ways = {(-40, 0): 0.0, (40, 0): math.pi, (0, -10): math.pi / 2, (0, 10): -math.pi / 2}
    weather = Environment(Wind(150.0, 500.0, WindCoefficients(0.9, 0.7, 0.7)))
    for limit, expected in ((2e3, ["5 kn", "10 kn", "15 kn"]), (4e6, ["20 kn", "100 kn"])):
        swarm = Swarm(outline, [Robot(c, way, limit) for c, way in ways.items()])
        said = texts(capability_diagram(capability(swarm, weather, [0.0, math.pi / 2])), "ring")
        knots = [text for text in said if text.endswith("kn")]
        assert len(knots) <= 5
        assert [text for text in expected if text in knots] == expected


def test_nothing_held_is_said():
    """No robots, no wind: a dot in the middle, and words."""
    outline = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    weather = Environment(
        Wind(150.0, 500.0, BLENDERMANN["tender"]), Current(60.0, 240.0, 1.0, bearing=1.0)
    )
    said = texts(capability_diagram(capability(Swarm(outline, []), weather, BEARINGS)))
    assert "no wind held\nall robots" in said
    assert "Current 1.94 kn (1 m/s) from 57.3°; no waves; steady loads." in said


def test_labels_keep_off_each_other(vessel):
    """Neither of the two names hides a bearing, a ring's speed or the other."""
    figure = capability_diagram(vessel)
    boxes = [a.get_window_extent() for gid in ("envelope", "bearing") for a in by_gid(figure, gid)]
    for i, box in enumerate(boxes):
        assert not any(box.overlaps(other) for other in boxes[i + 1 :])


def test_it_is_saved_and_drawn_elsewhere(vessel, tmp_path: Path):
    """As a file of its own, or on an axes that is there."""
    assert save(capability_diagram(vessel), tmp_path / "a.svg").stat().st_size > 10_000
    figure = Figure()
    assert capability_diagram(vessel, ax=figure.add_subplot()) is figure


def test_the_forces_of_azimuths_are_circles_on_the_hull():
    """Those of the group that is lost have another colour."""
    hull = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    robots = [
        Robot((x, y), 0.0, 60e3, mounted=True, steers=math.pi, group=group)
        for x, y, group in [(30, 0, "A"), (-30, 0, "A"), (25, 5, "B"), (-25, 5, "B")]
    ]
    weather = Environment(Wind(150.0, 500.0, WindCoefficients(0.9, 0.7, 0.7)))
    figure = capability_diagram(capability(Swarm(hull, robots), weather, [0.0, math.pi / 2]))
    assert not by_gid(figure, "robot")
    for gid in ("robot-area", "lost-area"):
        (areas,) = by_gid(figure, gid)
        assert len(areas.get_paths()) == 2


def test_a_line_ends_where_winds_have_no_known_sea(vessel):
    """From ahead every wind is held that was tried: there is no limit to draw."""
    around = replace(vessel.environment, waves=Waves())
    found = capability(vessel.swarm, around, BEARINGS)
    figure = capability_diagram(found)
    assert found.intact[0] == found.most_told
    drawn = line(figure, "intact")
    assert np.nanmax(np.hypot(*drawn.T)) < found.most_told / KNOT
    said = " ".join(texts(figure))
    assert "Where no line is drawn, more than 63.4 kn is held." in said
    assert "drift of the wind's sea (DNV-ST-0111)" in said


def test_a_newcomer_is_beside_those_it_joins():
    """Grey curves and rows without it, its own arrow in another colour."""
    scenario = load_example("deck-barge")
    joined = place(scenario.problem())
    before = capability(scenario.swarm, scenario.environment, BEARINGS)
    after = capability(joined.swarm_after, scenario.environment, BEARINGS)
    figure = capability_diagram(after, before=before)
    least = before.worst
    point = np.array([math.sin(BEARINGS[least]), math.cos(BEARINGS[least])])
    off = line(figure, "intact-before") - point * before.intact[least] / KNOT
    assert np.nanmin(np.hypot(*off.T)) < 1e-6
    assert texts(figure).count("without Fortuna") == 2
    (arrow,) = by_gid(figure, "newcomer")
    assert arrow.N == 1


def test_numbers_have_a_ring_each(vessel):
    """Eleven rings; the last step is drawn, for it was held; what this is not is said."""
    found = capability_numbers(vessel.swarm, vessel.environment, BEARINGS)
    figure = numbers_diagram(found, "Hermod")
    drawn = line(figure, "intact")
    assert np.hypot(*drawn.T).max() == pytest.approx(11.0)
    rings = texts(figure, "ring")
    numbers = [int(text) for text in rings if text.isdigit()]
    assert set(range(4, 12)) <= set(numbers)  # the hull may hide the first
    assert "No assessment by that standard" in " ".join(texts(figure))


def test_shares_are_rows_of_robots_and_a_curve_of_the_busiest(vessel):
    """In per cent over where the wind comes from; hatched where it is not held."""
    found = thrust_use(vessel.swarm, vessel.environment, 25.0, BEARINGS)
    figure = thrust_use_picture(found, "Hermod")
    x, y = np.array(by_gid(figure, "busiest")[0].get_data())
    np.testing.assert_allclose(x[:-1], np.degrees(BEARINGS))
    np.testing.assert_allclose(y[:-1], 100.0 * found.largest)
    (mesh,) = by_gid(figure, "shares")
    np.testing.assert_allclose(mesh.get_array(), 100.0 * found.shares.T)
    storm = thrust_use(vessel.swarm, vessel.environment, 45.0, BEARINGS)
    assert not storm.held.all()
    assert any("hatched: not held" in text for text in texts(thrust_use_picture(storm)))
