"""Questions whose value is zero, flat or next to rounding: each is answered within little work."""

import math

import numpy as np
import pytest

import reference
from swarmgrasp import Newcomer, Outline, Polytope, Robot, Swarm, Tolerance, place, quality
from swarmgrasp.placement import search

BARGE = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
LITTLE = 3e6
"""Units of work, some 10 ms: what each of these takes at most, where millions of times that was
not enough."""


@pytest.fixture(autouse=True)
def _little_work(monkeypatch):
    monkeypatch.setattr(search, "WORK", LITTLE)


def tugs(*poses):
    """Return tugs of 300 kN at the barge, (contact, direction, its tolerance)."""
    robots = [Robot(c, a, 300e3, tolerance=Tolerance(direction=turn)) for c, a, turn in poses]
    return Swarm(BARGE, robots)


def checked(answer):
    """Return an answer's quality; it came to its end and passes its check."""
    assert answer._found.solved
    assert answer.verify(), answer.verify().faults
    return answer.quality


def test_two_tugs_that_are_nearly_one():
    """A one-way task out of their plane, and a newcomer along the normals: no place helps."""
    poses = [
        ((40.0, -8.550473938437051), 2.9199276226266146),
        ((40.0, -5.47484958878141), 2.9206887028174187),
    ]
    swarm = Swarm(BARGE, [Robot(*pose) for pose in poses])
    task = Polytope([[0.002990683562655561, 0.411024426673088, -23.19526617045397]])
    assert checked(place(swarm, Newcomer(1.0, "push", 0.0), task=task)) == 0.0


TWO = (((-22.78, -10), 1.35, 0.02), ((-6.97, -10), 1.487, 0.1))
LOAD = (1052.0, -875.0, 106790.0)


@pytest.mark.parametrize(
    ("poses", "terms", "value"),
    [
        (TWO, {"load": LOAD}, 1256.2537),
        (TWO, {}, 0.0),
        ((*TWO, ((20, 10), -1.5, 0.05)), {"load": LOAD}, 1667.1057),
        (
            (((13.96, -10), 1.6047, 0.02),),
            {"task": Polytope([(22442.6, 18873.9, 253319.7)])},
            13.6407,
        ),
        (
            (((-4.05, 10), -1.7688, 0.02), ((-22.64, -10), 1.8641, 0.02)),
            {"task": Polytope([(-25684.4, 14443.96, 225152.9)])},
            18.58398,
        ),
    ],
)
def test_tugs_known_to_a_degree(poses, terms, value):
    """Few uncertain tugs and a load or a task that goes one way."""
    answer = place(tugs(*poses), Newcomer(400e3, "push"), worst_case=True, **terms)
    assert checked(answer) == pytest.approx(value, rel=1e-5)


def test_a_quality_that_goes_to_zero():
    """Uncertain tugs that just hold a load: value and bound meet down to rounding."""
    at = BARGE.at_arc_length(153.0652717113505).point
    low, high = -1.7971317977586303, -1.797081797759  # held, and not
    for _ in range(45):
        middle = 0.5 * (low + high)
        swarm = tugs(*TWO).with_robot(Robot(at, middle, 400e3))
        found = quality(swarm, worst_case=True, load=LOAD)
        assert found.bound <= found.value <= found.bound * (1.0 + 1e-6)
        low, high = (middle, high) if found.value > 0.0 else (low, middle)
    assert low == pytest.approx(-1.7971185929, abs=1e-9)


@pytest.mark.parametrize("small", [1e-5, 3e-7, 1e-8, 1e-9, 1e-12])
def test_a_small_demand_that_nobody_meets(small):
    """Two push ahead; the task also asks for next to nothing to port. Turned, it is as much."""
    for turn in (0.0, 0.3):
        c, s = math.cos(turn), math.sin(turn)
        spin = np.array([[c, s], [-s, c]])
        square = Outline(SQUARE.vertices @ spin)
        contacts = np.array([(-1, -0.5), (-1, 0.5)]) @ spin
        swarm = Swarm(square, [Robot(tuple(contact), turn) for contact in contacts])
        rows = [(*(np.array(row) @ spin), 0.0) for row in ((1.0, 0.0), (0.0, small))]
        assert quality(swarm, task=Polytope(rows[:1])).value == pytest.approx(2.0)
        assert quality(swarm, task=Polytope(rows)).value == 0.0
        assert place(swarm, Newcomer(), task=Polytope(rows)).verify()


@pytest.mark.parametrize(("port", "value"), [(0.5, 0.2), (-0.5, 0.0)])
def test_a_small_demand_that_a_small_robot_meets(port, value):
    """2 MN ahead, and 0.1 N to port: of 1 MN and half a newton a fifth, as linear programs say."""
    robots = [Robot((-40, 0), 0.0, 2e6), Robot((0, -10), math.pi / 2, 0.1)]
    swarm, rows = Swarm(BARGE, robots), [(1e6, 0, 0), (0, port, 0)]
    assert quality(swarm, task=Polytope(rows)).value == pytest.approx(value, rel=1e-12)
    assert reference.most_of_task(swarm.generators, rows) == pytest.approx(value, rel=1e-9)


def test_a_task_in_one_plane_with_the_robots():
    """One robot and a one-way task: the newcomer has to be coplanar, but for rounding."""
    triangle = Outline([(2.78857603, 0.53889262), (-1.33783347, 1.08197845), (-0.82, -1.9063)])
    contact = triangle.at_arc_length(float(triangle.nearest([(0.4, -1.08)])[1][0])).point
    one = Swarm(triangle, [Robot(contact, -2.70006, 2.0)], 14.2551306, (2.05358225, 1.08520949))
    rng, values = np.random.default_rng(0), []
    for _ in range(60):
        task = Polytope([rng.normal(size=3)])
        values.append(checked(place(one, Newcomer(3.0, "push", 0.0), task=task)))
    assert sum(value > 0.0 for value in values) > 10
