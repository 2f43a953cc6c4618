import math
import re

import numpy as np
import pytest

from swarmgrasp import (
    Criterion,
    Newcomer,
    Outline,
    Polytope,
    Problem,
    Robot,
    Stretch,
    Swarm,
    Tolerance,
    Zone,
    cell_qualities,
    place,
    qualities_with,
)
from swarmgrasp.errors import SwarmGraspError, SwarmInvalid
from swarmgrasp.plot import landscape
from swarmgrasp.quality import quality

RESOLUTION = (120, 90)


@pytest.mark.parametrize("count", [0, 1, 2, 3, 6])
def test_the_grid_is_the_quality_of_each_swarm_with_one_more(crowd, count):
    base = Swarm(crowd.outline, crowd.robots[:count], crowd.characteristic_length)
    contacts = np.array([(1.8, 0.1), (-0.4, 0.8), (1.8, -0.8)])
    directions = np.array([0.0, 1.0, math.pi, -2.5])
    pairs = [(tuple(contact), float(direction)) for contact in contacts for direction in directions]
    values = qualities_with(base, *zip(*pairs, strict=True), limits=1.5)
    for value, (contact, direction) in zip(values, pairs, strict=True):
        truth = quality(base.with_robot(Robot(contact, direction, 1.5))).value
        assert value == pytest.approx(truth, abs=1e-12)


def test_newcomers_need_a_swarm():
    with pytest.raises(SwarmInvalid, match="None is no Swarm: make one with"):
        qualities_with(None, [(0, 0)], [0.0])


@pytest.mark.parametrize("wrong", [(0, 5), (-1, 5), (2.5, 5), (True, 5), 5, (5,), "34", None])
def test_a_grid_has_columns_and_rows(placement, wrong):
    says = re.escape(f"the resolution is {wrong!r}; it should be two whole numbers")
    with pytest.raises(SwarmGraspError, match=says):
        cell_qualities(placement.problem, wrong)


def test_what_is_wrong_with_a_grid_is_told_at_once(crowd):
    with pytest.raises(SwarmGraspError, match="Swarm is no Problem") as caught:
        cell_qualities(crowd, (0, 0))
    assert len(caught.value.faults) == 2


@pytest.mark.parametrize("attachment", ["push", "pull", "free"])
def test_the_best_cell_comes_near_the_answer_and_never_above_its_bound(barge, attachment):
    answer = place(barge, Newcomer(100e3, attachment, None))
    best = float(np.nanmax(cell_qualities(answer.problem, RESOLUTION)))
    # half a cell: the torque arm moves by its length, the force turns by its angle (T4)
    step = 0.5 * barge.outline.perimeter / RESOLUTION[0] / barge.characteristic_length
    slack = 100e3 * (step + 1.5 * math.pi / RESOLUTION[1])
    assert best <= answer.upper_bound * (1.0 + 1e-9)
    assert best >= answer.quality - slack


def test_no_cell_outside_the_zones_has_a_value(barge, zones, no_go):
    answer = place(barge, Newcomer(100e3, "push", 0.5), zones=zones, no_go=no_go, spacing=2.0)
    known = np.isfinite(cell_qualities(answer.problem, RESOLUTION))
    columns = known.any(axis=1)
    cell = barge.outline.perimeter / RESOLUTION[0]
    (port, bollard) = (zone.stretch for zone in zones)
    expected = [
        (port.start, no_go[0].start),
        (no_go[0].end, port.end),
        (bollard.start - cell, bollard.end + cell),
    ]
    for column in np.flatnonzero(columns):
        low, high = column * cell, (column + 1) * cell
        assert any(low < end + 1e-9 and high > start - 1e-9 for start, end in expected)
    assert known[int(bollard.start / cell)].all()  # it may push any way
    rows = known[int((port.start + 1.0) / cell)].sum() * 360.0 / RESOLUTION[1]
    assert rows == pytest.approx(math.degrees(1.0), abs=2 * 360.0 / RESOLUTION[1])


def test_exactly_along_the_normal_is_still_seen(crowd):
    answer = place(crowd, Newcomer(1.0, "pull", 0.0))
    known = np.isfinite(cell_qualities(answer.problem, RESOLUTION))
    assert known.any(axis=1).all()
    assert known.sum() <= 3.5 * RESOLUTION[0]


def test_a_stretch_across_the_first_corner_and_an_absolute_range(crowd):
    around = crowd.outline.perimeter
    zone = Zone(Stretch(around - 1.0, 1.0), "free", directions=(3.0, -3.0))
    answer = place(crowd, Newcomer(1.0), zones=[zone])
    known = np.isfinite(cell_qualities(answer.problem, RESOLUTION))
    columns = np.flatnonzero(known.any(axis=1)) * around / RESOLUTION[0]
    assert ((columns < 1.0) | (columns > around - 1.2)).all()
    assert known[0, 0]
    assert known[0, -1]
    assert not known[:, RESOLUTION[1] // 2].any()


def test_the_answer_is_marked_where_it_is(placement):
    figure = landscape(placement, resolution=(60, 30))
    (mark,) = figure.findobj(lambda artist: artist.get_gid() == "best")
    contact = placement.problem.swarm.outline.at_point(placement.robot.contact)
    assert mark.get_xdata()[0] == pytest.approx(contact.arc_length)
    turns = (math.radians(mark.get_ydata()[0]) - placement.robot.direction) / math.tau
    assert turns == pytest.approx(round(turns), abs=1e-9)


def test_a_problem_without_an_answer_has_no_mark(placement):
    figure = landscape(placement.problem, resolution=(60, 30))
    assert not figure.findobj(lambda artist: artist.get_gid() == "best")


def test_a_swarm_no_newcomer_can_better_says_so(square):
    answer = place(square, Newcomer(2.0, "pull"))
    figure = landscape(answer, resolution=(40, 20))
    assert any("everywhere" in text.get_text() for text in figure.axes[0].texts)


def test_a_round_hull_is_ticked_by_distance():
    angles = np.linspace(0.0, math.tau, 120, endpoint=False)
    hull = Outline(np.column_stack([60 * np.cos(angles), 10 * np.sin(angles)]))
    swarm = Swarm(hull, [Robot(hull.at_arc_length(10.0 * i).point, 1.0 * i) for i in range(7)])
    figure = landscape(place(swarm, Newcomer(1.0, "push")), resolution=(60, 30))
    assert len(figure.axes[0].get_xticks()) < 15


def test_the_colours_run_from_the_quality_before_to_the_answer(barge, zones):
    answer = place(barge, Newcomer(100e3, "push", None), zones=zones)
    figure = landscape(answer, resolution=(4, 2))  # cells too coarse to come near the answer
    (image,) = figure.axes[0].images
    low, high = image.get_clim()
    assert low == pytest.approx(answer.quality_before / 1e3)
    assert high >= answer.quality / 1e3


@pytest.mark.parametrize("size", [1e-9, 1e-5, 1.0, 123_456_789.0])
def test_the_colour_bar_ends_on_the_page(crowd, size):
    robots = [Robot(r.contact, r.direction, size) for r in crowd.robots]
    swarm = Swarm(crowd.outline, robots, crowd.characteristic_length)
    figure = landscape(place(swarm, Newcomer(0.02 * size, "push")), resolution=(40, 20))
    figure.draw_without_rendering()
    bar = figure.axes[0].child_axes[0]
    assert bar.get_tightbbox().x1 <= figure.bbox.x1
    assert bar.yaxis.get_offset_text().get_text() == ""


def test_a_landscape_says_its_criterion(crowd):
    """Words, load and a bar without unit; colours leave the newcomer's own tolerance out."""
    terms = {"losing": 1, "load": (0.1, 0.0, 0.0), "task": Polytope([(1, 0, 0), (0, 1, 0)])}
    figure = landscape(place(crowd, Newcomer(1.0), **terms), resolution=(20, 10))
    said = " ".join(text.get_text() for text in figure.texts)
    assert "after the worst loss of 1 robot, beside the load" in said
    assert "times the task" in said
    assert "Load on the object: 0.1 N ahead." in said
    bar = figure.axes[0].child_axes[0]
    assert bar.get_ylabel() == "quality with the newcomer"
    newcomer = Newcomer(1.0, tolerance=Tolerance(contact=0.1))
    problem = Problem(crowd, newcomer, criterion=Criterion(worst_case=True))
    said = " ".join(text.get_text() for text in landscape(problem, resolution=(20, 10)).texts)
    assert "as if the newcomer hit its place exactly" in said
