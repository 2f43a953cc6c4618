"""Several newcomers of any kind at once, beside robots of any kind."""

import itertools
import math

import numpy as np
import pytest

from swarmgrasp import (
    Criterion,
    Newcomer,
    Outline,
    Problem,
    Robot,
    Stretch,
    Swarm,
    Zone,
    how_many,
    place,
    place_together,
    quality,
)
from swarmgrasp.errors import ForceSetUnsupported
from swarmgrasp.placement.together.sets import SetGauge, SetGround
from swarmgrasp.placement.together.stands import Stands

HULL = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])
TUGS = Swarm(HULL, [Robot((-2, 0.3), 0.0, steers=0.5), Robot((2, -0.2), math.pi, steers=0.5)])
RAYS = Swarm(HULL, [Robot((-2, 0.3), 0.2), Robot((2, -0.2), 3.0), Robot((0, 1), -1.3)])
BUSES = Swarm(HULL, [
    Robot((-2, 0.3), 0.2, group="A"), Robot((2, -0.2), 3.0, group="A"),
    Robot((0, 1), -1.3, group="B"), Robot((0.5, -1), 1.4, group="B"),
    Robot((1.5, 1), -1.8, steers=0.6),
])  # fmt: skip
NONE = Swarm(HULL, [])
PADS = (Zone(Stretch(0.5, 3.5, "south"), "push"), Zone(Stretch(6.5, 9.5, "north"), "push"))
ASKED = {
    "push beside tugs": Problem(TUGS, Newcomer(1.0, "push", 0.6), PADS),
    "free beside tugs": Problem(TUGS, Newcomer(0.8)),
    "two-way beside tugs": Problem(TUGS, Newcomer(0.8, "push", 0.3, reverse_limit=0.5)),
    "two-way beside rays": Problem(RAYS, Newcomer(1.0, "push", 0.6, reverse_limit=1.0), PADS),
    "two-way, stronger astern": Problem(RAYS, Newcomer(0.5, "push", 0.0, reverse_limit=1.0), PADS),
    "groups": Problem(BUSES, Newcomer(1.0, "push", 0.4), criterion=Criterion(losing=1)),
    "failures": Problem(RAYS, Newcomer(1.0, "push", 0.4), criterion=Criterion(failures=[["R1"]])),
    "load": Problem(TUGS, Newcomer(1.0, "push", 0.4), criterion=Criterion(load=(0.1, 0.2, -0.1))),
    "fingers": Problem(RAYS, Newcomer(1.0, "push", friction=0.5)),
    "steering both ways": Problem(TUGS, Newcomer(1.0, "push", 0.5, steers=True, reverse_limit=0.5)),
}


def robots_on_a_grid(problem, contacts, turns):
    """Return newcomers at about so many contacts, in so many directions each."""
    ground = SetGround(problem)
    each = max(2, contacts // len(ground.low))
    stands = [
        (piece, along, angle)
        for piece, (low, high) in enumerate(zip(ground.low, ground.high, strict=True))
        for along in np.linspace(low[0], high[0], each)
        for angle in np.unique(np.linspace(low[1], high[1], turns))
    ]
    rows = np.array(stands)
    all_ = Stands(rows[:, 0].astype(int), rows[:, 1:])
    return ground.robots(all_, [f"N{k}" for k in range(len(rows))])


@pytest.mark.parametrize("kind", ASKED)
def test_no_two_of_a_grid_are_better(kind):
    """The bound holds for all pairs of a grid, and what was found is as good as the best one."""
    problem = ASKED[kind]
    answer = place_together(problem, 2, effort=300)
    best = 0.0
    for one, other in itertools.combinations(robots_on_a_grid(problem, 9, 2), 2):
        swarm = problem.swarm.with_robot(one).with_robot(other)
        best = max(best, quality(swarm, **problem.criterion.keywords).value)
    assert best <= answer.upper_bound * (1.0 + 1e-9)
    assert answer.quality >= 0.98 * best
    found = quality(answer.swarm_after, **problem.criterion.keywords).value
    assert answer.quality == pytest.approx(found, rel=1e-8)
    assert answer.quality >= answer.sequential * (1.0 - 1e-9)
    newcomer = problem.newcomer
    assert {robot.reverse_limit for robot in answer.robots} == {newcomer.reverse_limit}
    assert {robot.friction for robot in answer.robots} == {newcomer.friction}


@pytest.mark.parametrize("kind", ["two-way beside tugs", "fingers", "steering both ways"])
def test_one_is_placed_as_ever(kind):
    """Its bound is that of `place`."""
    problem = ASKED[kind]
    one = place(problem)
    together = place_together(problem, 1, effort=50)
    assert together.quality == pytest.approx(one.quality, rel=1e-6)
    assert together.upper_bound <= one.upper_bound * (1.0 + 1e-9)


@pytest.mark.parametrize("kind", ASKED)
def test_what_newcomers_add_is_their_support_function(kind):
    """By the reference's heights of the swarm with and without them, along any normal."""
    problem, rng = ASKED[kind], np.random.default_rng(5)
    ground = SetGround(problem)
    gauge = SetGauge(ground)
    stands, normals = ground.random(rng, 3), rng.normal(size=(40, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    told = gauge.adds(normals, ground.points_of(stands))
    for k, robot in enumerate(ground.robots(stands, ["a", "b", "c"])):
        assert told[:, k] == pytest.approx(_height(robot, problem.swarm.scale, normals), abs=1e-12)
    assert (told <= gauge.reach * (1.0 + 1e-12)).all()


def _height(robot, scale, normals):
    """Return what a robot alone has along normals (m, 3), from its forces at all angles: (m,)."""
    (x, y), turns = robot.contact, np.linspace(-math.pi, math.pi, 7)[:-1]
    u, v, turn = (normals * scale).T
    p = np.column_stack([u - turn * y, v + turn * x])
    best = np.zeros(len(normals))
    if robot.friction:
        for side in (-1.0, 1.0):
            c, s = math.cos(robot.direction), math.sin(robot.direction)
            force = np.array([c, s]) + side * robot.friction * np.array([-s, c])
            best = np.maximum(best, robot.limit * p @ force)
        return best
    for limit, way in ((robot.limit, 0.0), (robot.reverse_limit, math.pi)):
        off = np.arctan2(p[:, 1], p[:, 0]) - robot.direction - way
        off = np.abs((off + math.pi) % math.tau - math.pi)
        worth = np.cos(np.maximum(off - robot.steers, 0.0))
        best = np.maximum(best, limit * np.hypot(*p.T) * worth)
    assert len(turns) == 6
    return best


def test_how_many_two_way_thrusters():
    """Two lines of action hold nothing, which the bound need not see; three do."""
    thruster = Newcomer(1.0, "push", 0.0, reverse_limit=1.0)
    found = how_many(Problem(NONE, thruster), 0.5, effort=200)
    assert found.count == 3
    assert found.at_least in {2, 3}
    assert found.quality >= 0.5


def test_three_fingers_are_proven():
    """The best grasp of three fingers with friction 0.5: 0.6 sqrt(5 / 3), within 0.1 %."""
    answer = place_together(Problem(NONE, Newcomer(1.0, "push", friction=0.5)), 3, effort=500)
    assert answer.quality == pytest.approx(0.6 * math.sqrt(5.0 / 3.0), rel=1e-4)
    assert answer.gap <= 1e-3


def test_mounted_newcomers_are_refused_in_words():
    """Several of them; and those that miss their place but by a tolerance that is known."""
    for newcomer in (Newcomer(mounted=True), Newcomer(mounted=True, reverse_limit=1.0)):
        with pytest.raises(ForceSetUnsupported, match="one after the other"):
            place_together(Problem(TUGS, newcomer), 2)
