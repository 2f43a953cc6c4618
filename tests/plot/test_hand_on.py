"""Pictures that are handed on: weather, scales, newcomers, widths, what a file says of itself."""

import math
import re

import numpy as np
import pytest

from swarmgrasp import (
    BLENDERMANN,
    Current,
    Environment,
    Newcomer,
    Outline,
    Robot,
    Swarm,
    Wind,
    place_together,
)
from swarmgrasp.environment import KNOT
from swarmgrasp.forces import forces
from swarmgrasp.placement import Problem, best_move
from swarmgrasp.plot import forces_plan, plan, save, style
from swarmgrasp.plot.arrows import Arrows
from swarmgrasp.plot.flows import flows_of
from swarmgrasp.quality import quality
from swarmgrasp.terms import Frame, Terms

WEATHER = Environment(
    Wind(150.0, 500.0, BLENDERMANN["tender"], speed=25.0 * KNOT, bearing=math.radians(60.0)),
    Current(60.0, 240.0, 1.5 * KNOT, bearing=math.radians(300.0)),
)


def by_gid(figure, gid):
    return figure.findobj(lambda artist: artist.get_gid() == gid)


def ends_of(figure, gid):
    """Return tails and tips of the arrows of a kind, each (n, 2)."""
    (quiver,) = by_gid(figure, gid)
    tails = np.asarray(quiver.XY)
    return tails, tails + np.column_stack([quiver.U, quiver.V])


def legend(figure):
    return [text.get_text() for text in figure.axes[0].get_legend().get_texts()]


def test_wind_and_current_are_drawn_where_the_load_is_theirs(barge):
    """Each the way it pushes, with its speed and bearing; not beside a load of something else."""
    outline = barge.outline
    load = WEATHER.load(outline)
    figure = plan(barge, quality=quality(barge, load=tuple(load)), environment=WEATHER)
    pushes = {
        "wind": WEATHER.wind.load(outline, math.radians(60.0), 1.0),
        "current": WEATHER.current.load(outline, math.radians(300.0), 1.0),
    }
    for kind, push in pushes.items():
        tails, tips = ends_of(figure, kind)
        assert ((tips - tails)[0] * push[:2] > 0.0).all()
    said = [text.get_text() for text in by_gid(figure, "flow-label")]
    assert said == ["wind 25 kn (12.9 m/s) from 60°", "current 1.5 kn (0.772 m/s) from 300°"]
    assert not flows_of(WEATHER, outline, 2.0 * load)
    marine = Terms(speed="kn", frame=Frame(heading=math.radians(90.0)))
    with style.settings(terms=marine):
        assert flows_of(WEATHER, outline, load)[0].words == "25 kn from 150° true"


@pytest.mark.parametrize(("size", "note"), [(80e3, ""), (1e3, " (direction only)")])
def test_a_wrench_has_the_scale_of_the_arrows_or_says_that_it_has_none(barge, size, note):
    """The arrow of a force that would be too short is hollow, and of no length that means much."""
    figure = forces_plan(forces(barge, (size, 0.0, 0.0)))
    tails, tips = ends_of(figure, "wrench")
    length = float(np.hypot(*(tips - tails)[0]))
    is_to_scale = math.isclose(length, Arrows(barge.outline, barge.robots).length(size))
    assert is_to_scale == (not note)
    assert f"wrench wanted{note}" in legend(figure)
    (quiver,) = by_gid(figure, "wrench")
    assert (quiver.get_facecolor()[0][:3] == 1.0).all() == bool(note)


def test_a_load_ends_at_the_origin(barge):
    """It pushes the object; the title says who is busiest holding it."""
    found = forces(barge, (0.0, 0.0, 0.0), load=(-60e3, 0.0, 0.0))
    figure = forces_plan(found)
    tails, tips = ends_of(figure, "load")
    np.testing.assert_allclose(tips[0], barge.outline.origin, atol=1e-12)
    assert tails[0, 0] > tips[0, 0]
    busiest = barge.names[int(np.argmax(found.shares))]
    assert by_gid(figure, "title")[0].get_text().startswith(f"Held: busiest {busiest}, ")


def test_newcomers_placed_together_are_newcomers(barge, zones, no_go):
    """In their colour, named, with their zones, beside what was weakest before them."""
    problem = Problem(barge, Newcomer(100e3, "push", name="Fred"), zones=zones, no_go=no_go)
    found = place_together(problem, 2, effort=20)
    figure = plan(barge, quality=quality(barge), placements=found)
    assert len(ends_of(figure, "newcomer")[0]) == 2
    assert len(ends_of(figure, "robot")[0]) == len(barge)
    assert {text.get_text() for text in by_gid(figure, "newcomer-label")} == {
        "Fred 1, 100 kN", "Fred 2, 100 kN",
    }  # fmt: skip
    assert by_gid(figure, "zone")
    assert by_gid(figure, "no-go")


def test_a_robot_that_moves_is_hollow_where_it_was(barge):
    """And a newcomer where it had better be."""
    found = best_move(Problem(barge, Newcomer(100e3, "push")))
    figure = plan(barge, quality=quality(barge), placements=found)
    np.testing.assert_allclose(
        np.vstack(ends_of(figure, "missing")),
        np.vstack(Arrows(barge.outline, barge.robots, (found.best.new,)).ends(found.best.old)),
    )
    assert "before the move" in legend(figure)
    assert len(ends_of(figure, "newcomer")[0]) == 1


@pytest.mark.parametrize("turn", [100.0, 179.0, 225.0, 269.0, 350.0])
def test_a_push_at_a_corner_has_its_head_on_the_contact(turn):
    """Also when it points past the other side; a pull that leaves the object starts there."""
    hull = Outline([(-5, -1), (5, -1), (5, 1), (-5, 1)])
    corner = Robot((5, 1), math.radians(turn))
    assert Arrows(hull, (corner,)).ends(corner)[1].tolist() == [5, 1]
    away = Robot((5, 1), math.radians(45.0))
    assert Arrows(hull, (away,)).ends(away)[0].tolist() == [5, 1]


def test_a_label_without_room_becomes_a_number_with_a_table():
    """Twenty names round a ring do not fit a column: what is not written there is in the table."""
    angles = np.linspace(0.0, 2.0 * np.pi, 24, endpoint=False)
    outline = Outline(np.column_stack([np.cos(angles), np.sin(angles)]))
    places = [outline.at_arc_length(outline.perimeter * i / 20) for i in range(20)]
    robots = [
        Robot(c.point, c.inward, name=f"very long harbour tug {i}") for i, c in enumerate(places)
    ]
    figure = plan(Swarm(outline, robots), width=3.4)
    tags = by_gid(figure, "tag")
    table = by_gid(figure, "small-print")[0].get_text().replace("\n", " ")
    numbers = [int(text.get_text()) for text in tags]
    assert numbers == list(range(1, len(tags) + 1)) != []
    named = {text.get_text() for text in by_gid(figure, "robot-label")}
    tagged = set(re.findall(r"\d+ (very long harbour tug \d+)", table))
    assert len(tagged) == len(tags)
    assert named | tagged == {robot.name for robot in robots}


def test_files_say_what_they_show(barge, tmp_path):
    """Text is text in SVG, with title and description; fonts in PDF are of Type 42."""
    figure = plan(barge, quality=quality(barge), title="Barge <76 m>", width=88.0 / 25.4)
    svg = save(figure, tmp_path / "a.svg").read_text()
    assert "<title>Barge &lt;76 m&gt;</title>" in svg
    (said,) = re.findall(r"<desc>(.*?)</desc>", svg)
    assert said.startswith("5 robots: quality ")
    assert all(robot.name in said for robot in barge)
    assert all(f">{robot.name}</text>" in svg for robot in barge)
    assert float(re.findall(r'<svg [^>]*width="([0-9.]+)pt"', svg)[0]) == pytest.approx(
        88.0 / 25.4 * 72.0
    )
    pdf = save(figure, tmp_path / "a.pdf").read_bytes()
    assert b"/CIDFontType2" in pdf  # how Type 42 fonts are embedded
    assert b"/Type3" not in pdf
    assert by_gid(figure, "heading")[0].get_text() == "Barge <76 m>"
