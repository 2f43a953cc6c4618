"""The picture of sensitivities: a half of a bar or arc for every slope, to scale."""

import math

import numpy as np
import pytest

from swarmgrasp import Outline, Robot, Swarm, sensitivities
from swarmgrasp.plot import save, sensitivity_plan
from swarmgrasp.plot.sensitivity import COLOURS, LEAST

KINDS = ("shift-rise", "shift-fall", "turn-rise", "turn-fall")


def by_gid(figure, gid):
    return figure.findobj(lambda artist: artist.get_gid() == gid)


def test_a_half_for_every_slope(barge):
    """As many as slopes that matter, green where the quality rises."""
    found = sensitivities(barge)
    figure = sensitivity_plan(found)
    for kind, slopes in (("shift", found.contact), ("turn", found.direction)):
        matter = np.abs(slopes) > LEAST * np.abs(slopes).max()
        for way, rises in (("rise", True), ("fall", False)):
            halves = by_gid(figure, f"{kind}-{way}")
            assert len(halves) == np.count_nonzero(matter & ((slopes > 0.0) == rises)) > 0
            assert {half.get_color() for half in halves} == {COLOURS[rises]}


def test_lengths_follow_the_slopes(barge):
    """Of two falling bars the longer is the steeper."""
    found = sensitivities(barge)
    falls = np.sort(-found.contact[found.contact < 0.0])
    lengths = []
    for half in by_gid(sensitivity_plan(found), "shift-fall"):
        steps = np.diff(np.column_stack(half.get_data()), axis=0)
        lengths.append(np.hypot(*steps.T).sum())
    np.testing.assert_allclose(np.sort(lengths) / max(lengths), falls / falls.max(), rtol=0.02)


def test_a_thruster_has_no_bar():
    """It turns, and does not move along the boundary."""
    hull = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])
    ways = (0.3, 1.8, 3.0, -1.9, -0.8)
    spots = ((-1.5, 0.5), (1.0, 0.6), (1.5, -0.5), (-0.5, -0.6), (0.3, 0.7))
    crew = [Robot(p, a, mounted=True) for p, a in zip(spots, ways, strict=True)]
    figure = sensitivity_plan(sensitivities(Swarm(hull, crew)))
    assert not by_gid(figure, "shift-rise")
    assert not by_gid(figure, "shift-fall")
    assert by_gid(figure, "turn-rise")


@pytest.mark.parametrize("count", [0, 1, 4, 60])
def test_any_number_of_robots_is_drawn(count, tmp_path):
    """Also where no small move helps, which is said."""
    angles = np.linspace(0.0, math.tau, 24, endpoint=False)
    outline = Outline(np.column_stack([np.cos(angles), np.sin(angles)]))
    places = [outline.at_arc_length(outline.perimeter * (i + 0.3) / count) for i in range(count)]
    robots = [Robot(c.point, c.inward + 0.4 * math.sin(3 * k)) for k, c in enumerate(places)]
    found = sensitivities(Swarm(outline, robots))
    figure = sensitivity_plan(found)
    drawn = sum(len(by_gid(figure, kind)) for kind in KINDS)
    assert (drawn > 0) == bool(np.any(found.contact) or np.any(found.direction))
    said = "No small move of one robot changes the quality."
    assert any(said in t.get_text() for t in figure.axes[0].texts) == (drawn == 0)
    save(figure, tmp_path / "picture.png")
