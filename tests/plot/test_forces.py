"""The picture of push forces: limits, forces as parts of them, and the wrench."""

import math

import numpy as np
import pytest

from swarmgrasp import Outline, Robot, Swarm, forces
from swarmgrasp.plot import forces_plan, save


def by_gid(figure, gid):
    return figure.findobj(lambda artist: artist.get_gid() == gid)


def lengths(figure, gid):
    """Return the lengths [m] of all arrows of a kind."""
    (arrows,) = by_gid(figure, gid)
    return np.hypot(arrows.U, arrows.V)


def test_a_force_is_its_share_of_the_limit(barge):
    """The dark part of each arrow, and the share beside the name."""
    found = forces(barge, (50e3, 20e3, 0.0))
    figure = forces_plan(found)
    hardest = found.shares >= found.largest_share - 1e-9
    limits = lengths(figure, "limit")
    drawn = np.sort(np.concatenate([lengths(figure, "force"), lengths(figure, "hardest")]))
    np.testing.assert_allclose(drawn, np.sort((found.shares * limits)[found.shares > 0.002]))
    assert len(lengths(figure, "hardest")) == hardest.sum()
    texts = {text.get_text() for text in by_gid(figure, "robot-label")}
    assert len(texts) == 5
    assert any(text.endswith(f": {100 * found.largest_share:.0f} %") for text in texts)


def test_the_outcome_stands_below_the_title(barge):
    """Made, or out of reach and by how much."""

    def said(wrench, **terms):
        figure = forces_plan(forces(barge, wrench, **terms))
        texts = (text.get_text() for text in figure.axes[0].texts)
        return " ".join(texts).replace("\xa0", " ")

    assert "made, with shares up to" in said((50e3, 0.0, 0.0))
    assert "out of reach by" in said((5e6, 0.0, 0.0))
    assert "Load on the object" in said((50e3, 0.0, 0.0), load=(0.0, 1e3, 0.0))


def test_every_robot_has_a_label_of_its_own():
    """Also two at one contact, whatever they are called; a thruster that reverses is one robot."""
    hull = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])
    crew = [Robot((1, 0), math.pi * a, name=n, mounted=True) for n, a in (("x +", 0), ("x -", 1))]
    crew += [Robot((-1, 0), math.pi / 2, name="aft", mounted=True, reverse_limit=1.0)]
    figure = forces_plan(forces(Swarm(hull, crew), (0.5, 0.0, 0.0)))
    texts = {text.get_text() for text in by_gid(figure, "robot-label")}
    assert texts == {"x +: 50 %", "x -: 0 %", "aft: 0 %"}


def test_all_forces_of_a_tug_are_an_area():
    """Around the arrow of its force; a thruster that reverses has a pale arrow each way."""
    hull = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])
    tug = Robot((-2, 0), 0.0, 2.0, name="tug", steers=0.5)
    tunnel = Robot((1, 0), math.pi / 2, 1.0, name="bow", mounted=True, reverse_limit=0.6)
    found = forces(Swarm(hull, [tug, tunnel]), (1.0, -0.2, 0.0))
    figure = forces_plan(found)
    ((area,),) = [shapes.get_paths() for shapes in by_gid(figure, "limit-area")]
    drawn = np.concatenate([lengths(figure, "force"), lengths(figure, "hardest")])
    assert np.ptp(np.sort(drawn) / np.sort(found.forces)) < 1e-9
    reach = np.hypot(*(area.vertices - (-2, 0)).T).max()
    assert reach / 2.0 == pytest.approx(drawn.max() / found.forces.max())
    assert sorted(lengths(figure, "limit") / reach * 2.0) == pytest.approx([0.6, 1.0])


@pytest.mark.parametrize("count", [0, 1, 60])
@pytest.mark.parametrize("wrench", [(0.0, 0.0, 0.0), (2.0, -1.0, 0.3)])
def test_any_number_of_robots_is_drawn(count, wrench, tmp_path):
    """No wrench is no arrow."""
    angles = np.linspace(0.0, math.tau, 24, endpoint=False)
    outline = Outline(np.column_stack([np.cos(angles), np.sin(angles)]))
    places = [outline.at_arc_length(outline.perimeter * (i + 0.3) / count) for i in range(count)]
    robots = [Robot(c.point, c.inward + 0.4 * math.sin(3 * k)) for k, c in enumerate(places)]
    figure = forces_plan(forces(Swarm(outline, robots), wrench))
    assert bool(by_gid(figure, "wrench")) is any(wrench)
    save(figure, tmp_path / "picture.png")
