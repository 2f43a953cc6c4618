"""Slopes of the quality of robots that steer, reverse or rub, against finite differences."""

import math
from dataclasses import replace

import numpy as np
import pytest

import reference
from swarmgrasp import Ellipsoid, Outline, Polytope, Robot, Swarm, quality, sensitivities
from swarmgrasp.errors import ForceSetUnsupported
from swarmgrasp.quality.set_slopes import KINDS

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
MIDDLES = [((1, 0), math.pi), ((-1, 0), 0.0), ((0, 1), -math.pi / 2), ((0, -1), math.pi / 2)]
CORNERS = [(1, 1), (-1, 1), (-1, -1), (1, -1)]
LOOKS = [
    {},
    {"steers": 0.6},
    {"steers": math.pi},
    {"reverse_limit": 0.6},
    {"friction": 0.5},
    {"steers": 0.4, "reverse_limit": 0.5},
]
STEP = 2e-4


def draw(seed, count):
    """Return robots of random kinds on the square."""
    rng = np.random.default_rng(seed)
    robots = []
    for look in rng.choice(LOOKS, count):
        at = SQUARE.at_arc_length(rng.uniform(0.0, 8.0))
        turn, limit = at.inward + rng.uniform(-0.5, 0.5), rng.uniform(0.5, 2.0)
        robots.append(Robot(at.point, turn, limit, **look))
    return Swarm(SQUARE, robots)


def moved(swarm, i, kind, x):
    """Return a swarm once one robot has changed by x [m, rad or N]."""
    robot = swarm.robots[i]
    if kind == "contact":
        arc = float(SQUARE.nearest(np.array([robot.contact]))[1][0])
        changed = {"contact": SQUARE.at_arc_length((arc + x) % 8.0).point}
    elif kind in ("start", "end"):
        half = 0.5 * x if kind == "end" else -0.5 * x
        changed = {"direction": robot.direction + 0.5 * x, "steers": robot.steers + half}
    else:
        changed = {kind: getattr(robot, kind) + x}
    robots = list(swarm.robots)
    robots[i] = replace(robot, **changed)
    return Swarm(SQUARE, robots, swarm.characteristic_length)


def worst_difference(swarm, **terms):
    """Return the greatest difference between a slope and its finite difference, and how many."""
    found = sensitivities(swarm, **terms)
    gaps = []
    for i, kind, way in np.ndindex(len(swarm), len(KINDS), 2):
        slope = getattr(found, KINDS[kind])[i, way]
        if np.isnan(slope):
            continue
        sign = 2 * way - 1

        def at(x, i=i, kind=kind, sign=sign):
            return quality(moved(swarm, i, KINDS[kind], sign * x), **terms).value

        gaps.append(abs(reference.one_sided_slope(at, STEP) - slope))
    return max(gaps), len(gaps)


TERMS = [
    {},
    {"losing": 1},
    {"load": (0.1, 0.2, 0.1)},
    {"task": Ellipsoid([(3, 0, 0), (0, 1, 0), (0, 0, 0.5)])},
    {"task": Polytope([(1, 0, 0), (-0.5, 1, 0), (-0.5, -1, 0.3)])},
]


@pytest.mark.parametrize("terms", TERMS, ids=str)
@pytest.mark.parametrize("seed", [0, 4, 7])
def test_random_mixtures(seed, terms):
    """Contact, direction, both limits and both ends of every robot, both ways."""
    swarm = draw(seed, 8)
    assert quality(swarm, **terms).value > 0.05
    gap, count = worst_difference(swarm, **terms)
    assert count > 6 * len(swarm)
    assert gap <= 1e-4


TIES = {
    "sectors": [Robot(c, a, steers=math.pi / 6) for c, a in MIDDLES],
    "half turns": [Robot(c, a, steers=math.pi / 2) for c, a in MIDDLES],
    "azimuths": [Robot(c, 0.0, steers=math.pi) for c in CORNERS],
    "fingers": [Robot(c, a, friction=0.5) for c, a in MIDDLES],
}


@pytest.mark.parametrize("name", TIES)
def test_balanced_swarms_have_one_sided_slopes(name):
    """Eight directions are equally weak: the least counts, each way."""
    swarm = Swarm(SQUARE, TIES[name], 1.0)
    found = sensitivities(swarm)
    assert len(found.weakest) == 8
    assert found.is_ridge
    assert found.kinks.any()
    assert worst_difference(swarm)[0] <= 1e-5


def test_groups_are_lost_together():
    """Rays too: what is lost is a machine."""
    for seed in (4, 5):
        robots = [
            replace(robot, group="bus A" if i < 2 else "") for i, robot in enumerate(draw(seed, 9))
        ]
        swarm = Swarm(SQUARE, robots)
        assert worst_difference(swarm, losing=1)[0] <= 1e-5
    rays = [
        Robot(c, a + turn, group=f"pair {k}")
        for k, (c, a) in enumerate([*MIDDLES, ((1, 0.5), 3.0), ((-0.6, 1), -1.7)])
        for turn in (-0.6, 0.7)
    ]
    assert worst_difference(Swarm(SQUARE, rays), losing=1)[0] <= 1e-5


def test_the_worst_of_named_failures_counts():
    """Each takes a robot and a group; balanced ones are equally bad."""
    swarm = draw(4, 9)
    robots = [replace(r, name=f"N{i}", group="A" if i < 2 else "") for i, r in enumerate(swarm)]
    failures = (("A",), ("N4", "N7"))
    named = Swarm(SQUARE, robots)
    assert worst_difference(named, failures=failures)[0] <= 1e-5
    assert worst_difference(named, failures=failures, losing=1)[0] <= 1e-5
    azimuths = [Robot(c, 0.0, name=f"{c}", steers=math.pi) for c in CORNERS]
    each = tuple((robot.name,) for robot in azimuths)
    assert worst_difference(Swarm(SQUARE, azimuths, 1.0), failures=each)[0] <= 1e-5


def test_what_a_robot_does_not_have_has_no_slope():
    """No reverse limit, no ends of a sector; mounted robots do not move."""
    looks = [{}, {"steers": math.pi}, {"steers": 0.5}, {"reverse_limit": 0.5}]
    robots = [Robot(c, a, mounted=True, **x) for (c, a), x in zip(MIDDLES, looks, strict=True)]
    found = sensitivities(Swarm(SQUARE, robots))
    assert np.isnan(found.contact).all()
    assert np.isnan(found.reverse_limit).all(axis=1).tolist() == [True, True, True, False]
    assert np.isnan(found.start).all(axis=1).tolist() == [True, True, False, True]
    assert np.isnan(found.end).all(axis=1).tolist() == [True, True, False, True]
    assert not np.isnan([found.direction, found.limit]).any()


def test_no_quality_has_no_slopes_yet():
    """One azimuth holds nothing, and is told so."""
    with pytest.raises(ForceSetUnsupported, match="the quality is 0"):
        sensitivities(Swarm(SQUARE, [Robot((1, 0), 0.0, steers=math.pi)]))
