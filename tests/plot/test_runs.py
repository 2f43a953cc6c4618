"""The pictures of a run show where it went, within which circles, and what happened when."""

from dataclasses import replace

import numpy as np
import pytest

from made_runs import JOINED, LOST, NOTICED, SENT, made_run
from swarmgrasp.environment import KNOT
from swarmgrasp.plot import save
from swarmgrasp.plot.history import history
from swarmgrasp.plot.limits import limits_diagram
from swarmgrasp.plot.sheet_of_run import run_sheet
from swarmgrasp.plot.track import stages_of, track
from swarmgrasp.simulation.limits import Limits
from swarmgrasp.simulation.verdict import verdict_of


@pytest.fixture(scope="module")
def run():
    return made_run()


@pytest.fixture(scope="module")
def verdict(run):
    return verdict_of(run)


def by_gid(figure, gid):
    return figure.findobj(lambda artist: artist.get_gid() == gid)


def test_the_stages_are_those_between_loss_and_join(run, verdict):
    """What is noticed or sent begins none; each has the largest errors of its instants."""
    stages = stages_of(run, verdict, 1)
    assert [(s.start, s.end) for s in stages] == [(0, LOST), (LOST, JOINED), (JOINED, 300)]
    assert [s.words for s in stages] == ["from the start", "Castor lost", "Fortuna there"]
    for stage in stages:
        rows = (run.times > stage.start) & (run.times <= stage.end)
        assert stage.distance == pytest.approx(float(run.distances[1, rows].max()), rel=1e-6)


def test_the_track_is_the_way_of_the_origin(run, verdict):
    """A line for each stage, joined to the next, and a circle that holds it."""
    figure = track(run, verdict)
    ways = [line.get_xydata() for line in by_gid(figure, "way")]
    assert len(ways) == 3
    drawn = np.vstack([ways[0], *(way[1:] for way in ways[1:])])
    for point in run.poses[0, ::10, :2]:
        assert np.hypot(*(drawn - point).T).min() < 1e-6
    circles = by_gid(figure, "circle")
    for circle, way in zip(circles, ways, strict=True):
        off = np.hypot(*(way[1:] - np.array(circle.center)).T)
        assert off.max() <= circle.radius * (1 + 1e-5)


def test_a_long_history_is_in_days_and_its_names_are_apart(run, verdict):
    """Ticks at even numbers of days; who has no room above is marked by a line alone."""
    long = replace(run, times=4000.0 * run.times, happenings=tuple(
        replace(at, time=4000.0 * time)
        for at, time in zip(run.happenings, (0.0, 60.0, 65.0, 62.0, 64.0), strict=True)
    ))  # fmt: skip
    figure = history(long, verdict)
    last = figure.axes[-1]
    assert last.get_xlabel() == "time [days]"
    days = last.xaxis.get_major_locator()() / 86400.0
    assert np.allclose(2.0 * days, np.round(2.0 * days))
    figure.draw_without_rendering()
    boxes = [text.get_window_extent() for text in figure.axes[0].texts]
    assert [text.get_text() for text in figure.axes[0].texts] == ["Castor lost", "Fortuna sent"]
    assert not boxes[0].overlaps(boxes[1])


def test_the_history_marks_what_happened(run, verdict):
    """A line through every panel when a robot is lost, sent and joins, with its name above."""
    figure = history(run, verdict)
    assert [ax.get_ylabel().split("\n")[0] for ax in figure.axes] == [
        "off by", "turned", "share of", "out of", "wind"
    ]  # fmt: skip
    times = {LOST, SENT, JOINED}
    for ax in figure.axes:
        marks = [line.get_xdata()[0] for line in ax.lines if len(set(line.get_xdata())) == 1]
        assert set(marks) == times
    names = [text.get_text() for text in figure.axes[0].texts]
    assert names == ["Castor lost", "Fortuna sent", "Fortuna joins"]
    assert NOTICED not in times


def test_shares_are_drawn_while_a_robot_is_there(run, verdict):
    """Castor's line ends at its loss, Fortuna's begins as it joins."""
    lines = {line.get_label(): line for line in history(run, verdict).axes[2].lines}
    for name, there in (("Castor", run.times <= LOST), ("Fortuna", run.times >= JOINED)):
        drawn = np.isfinite(lines[name].get_ydata())
        assert np.array_equal(drawn, there)


def test_a_sheet_has_both_and_is_saved(run, verdict, tmp_path):
    """Track above, five panels below, the title on top."""
    figure = run_sheet(run, verdict, "Deck barge")
    assert len(figure.axes) == 6
    assert figure.texts[0].get_text() == "Deck barge"
    assert save(figure, tmp_path / "run.svg").stat().st_size > 10_000


def test_the_diagram_of_limits_has_three_curves(run):
    """The radius is the wind in knots, ahead is up; in gusts the least of all seeds."""
    bearings = np.radians(np.arange(0.0, 360.0, 15.0))
    static = 20.0 + 5.0 * np.cos(bearings)
    gusty = np.stack([0.9 * static, 0.8 * static])
    found = Limits(run.simulation, bearings, static, 1.01 * static, gusty, (1, 2), 5.0, 0.1, 0.002)
    figure = limits_diagram(found, "Deck barge")
    for name, speeds in (("static", static), ("steady", 1.01 * static), ("gusty", 0.8 * static)):
        (line,) = by_gid(figure, name)
        drawn = np.column_stack(line.get_data())
        for bearing, knots in zip(bearings, speeds / KNOT, strict=True):
            point = knots * np.array([np.sin(bearing), np.cos(bearing)])
            assert np.hypot(*(drawn - point).T).min() < 1e-6
    said = [text.get_text() for text in figure.texts]
    assert "least 23.3 kn; 0.80 to 0.80 of statics" in said
