"""The signed margin: by how much a load or a task is held or missed."""

import math
from itertools import combinations

import numpy as np
import pytest

import reference
from strategies import swarm_of
from swarmgrasp import Criterion, Ellipsoid, Outline, Polytope, Robot, Swarm, Tolerance, quality
from swarmgrasp.forces import forces
from swarmgrasp.quality.margin import missed

BARGE = Outline([(-2.0, -1.0), (2.0, -1.0), (2.0, 1.0), (-2.0, 1.0)])
KINDS = [
    {}, {"steers": 0.5}, {"steers": math.pi}, {"reverse_limit": 0.6}, {"friction": 0.5},
    {"least": 0.3}, {"envelope": [(1.0, 0.2), (0.5, 0.9), (-0.4, 0.1), (0.3, -0.7)]},
]  # fmt: skip


def crew(seed, kinds=KINDS, tolerance=None):
    """Return a swarm of a robot of each kind, two of them in one group."""
    rng = np.random.default_rng(seed)
    robots = []
    for k, kind in enumerate(kinds):
        at = BARGE.at_arc_length(float(rng.uniform(0.0, BARGE.perimeter)))
        way = at.inward + rng.uniform(-1.0, 1.0)
        group = "bus" if k in (1, 3) else ""
        robots.append(Robot(at.point, way, group=group, tolerance=tolerance, **kind))
    return Swarm(BARGE, robots, characteristic_length=1.3)


@pytest.mark.parametrize("losing", range(4))
@pytest.mark.parametrize("family", ["along normals", "free", "integer grid"])
def test_the_worst_of_all_losses(family, losing):
    """Every subset of robots is left out, and the nearest wrench found by least squares."""
    swarm = swarm_of(family, losing, 8)
    B, rng = swarm.scaled_generators, np.random.default_rng([losing, 1])
    size = float(np.linalg.norm(B, axis=1).sum())
    for share in (0.03, 0.3, 1.0, 3.0):
        load = share * size * rng.normal(size=3) / 3.0
        found = quality(swarm, losing=losing, load=tuple(load / swarm.scale))
        left = [np.delete(B, gone, axis=0) for gone in combinations(range(8), losing)]
        short = max(float(np.linalg.norm(reference.nearest_wrench(b, -load) + load)) for b in left)
        truth = found.value if found.value > 0.0 else -short
        assert found.margin == pytest.approx(truth, abs=1e-9 * size)
        missing = np.linalg.norm(found.missing * swarm.scale)
        assert missing == pytest.approx(max(0.0, -truth), abs=1e-9 * size)
        height = reference.support(np.delete(B, [swarm.index(n) for n in found.lost], 0),
                                   found.direction[None]) + found.direction @ load  # fmt: skip
        assert height == pytest.approx(found.margin, abs=1e-9 * size)


@pytest.mark.parametrize("seed", range(6))
def test_robots_of_every_kind(seed):
    """The height along the normal is the margin, none of many is lower, and forces agree."""
    swarm, rng = crew(seed), np.random.default_rng([seed, 2])
    terms = {
        "losing": seed % 3,
        "load": tuple((4.0 * rng.normal(size=3)).tolist()),
        "failures": (("R2",), ("R4", "R1")) if seed > 3 else (),
    }
    found = quality(swarm, **terms)
    normals = rng.normal(size=(3000, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    there = reference.height_of_sets(swarm, found.direction[None], **terms)
    assert found.margin < 0.0
    assert found.margin == pytest.approx(there[0], abs=1e-9 * len(swarm))
    assert reference.height_of_sets(swarm, normals, **terms).min() >= found.margin - 1e-9
    against = forces(found.worst_swarm, (0.0, 0.0, 0.0), load=terms["load"])
    assert -found.margin == pytest.approx(against.shortfall, rel=1e-9)
    assert found.missing == pytest.approx(against.missing, rel=1e-6, abs=1e-9)


def test_no_step_at_nothing():
    """From held to missed the margin falls by no more than the load grows."""
    swarm = swarm_of("free", 3, 12)
    wrench = np.array([1.0, -2.0, 0.5])
    held = quality(swarm, losing=1, task=Polytope([wrench])).value
    shares = (0.9, 0.999, 1.001, 1.1)
    margins = [
        quality(swarm, losing=1, load=tuple(-held * share * wrench)).margin for share in shares
    ]
    size = held * float(np.linalg.norm(wrench * swarm.scale))
    assert margins == sorted(margins, reverse=True)
    assert margins[1] > 0.0 > margins[2]
    assert (-np.diff(margins) <= size * np.diff(shares) * (1.0 + 1e-9)).all()


def test_the_worst_poses():
    """No sample of the poses is worse, and the worst poses are as bad."""
    spread = Tolerance(contact=(-0.4, 0.1), direction=(-0.2, 0.1), least_limit=0.8)
    swarm, rng = crew(4, [{}] * 6, spread), np.random.default_rng(4)
    load = (3.0, -2.0, 1.0)
    found = quality(swarm, worst_case=True, losing=1, load=load)
    assert quality(found.worst_swarm, load=load).margin == pytest.approx(found.margin, rel=1e-9)
    for _ in range(40):
        robots = []
        for robot in swarm:
            at = BARGE.at_point(robot.contact).arc_length + rng.uniform(-0.4, 0.1)
            point = BARGE.at_arc_length(at % BARGE.perimeter).point
            turn = robot.direction + rng.uniform(-0.2, 0.1)
            robots.append(Robot(point, turn, rng.uniform(0.8, 1.0)))
        sample = quality(Swarm(BARGE, robots, characteristic_length=1.3), losing=1, load=load)
        assert sample.margin >= found.margin - 1e-9


@pytest.mark.parametrize("grown", [0.5, 2.0])
@pytest.mark.parametrize("kind", [Polytope, Ellipsoid])
def test_a_whole_task(kind, grown):
    """Of the wrenches of a task, the one that is held least; it is held where the value is 1."""
    swarm, rng = swarm_of("free", 5, 9), np.random.default_rng(6)
    rows = rng.normal(size=(2, 3))
    once = quality(swarm, task=kind(rows)).value
    task = kind(grown * once * rows)
    found = quality(swarm, task=task)
    assert (found.margin > 0.0) == (found.value > 1.0)
    weights = rng.normal(size=(60, 2))
    weights /= np.linalg.norm(weights, axis=1)[:, None]
    wrenches = [*task.generators, (0, 0, 0)] if kind is Polytope else weights @ task.axes
    alone = [quality(swarm, load=tuple(-np.array(wrench))).margin for wrench in wrenches]
    assert min(alone) >= found.margin - 1e-9
    assert min(alone) == pytest.approx(found.margin, rel=1e-9 if kind is Polytope else 0.02)
    missing = np.linalg.norm(found.missing * swarm.scale)
    assert missing == pytest.approx(max(0.0, -found.margin))


def test_sectors_with_gaps_are_chosen_for_the_load():
    """Of all choices of sectors, the one that comes nearest, as that of the push forces."""
    sectors = [(0.4, 1.0), (2.5, 3.1)]
    robots = [Robot((-2.0, y), sectors=sectors, mounted=True) for y in (-0.5, 0.5)]
    swarm, load = Swarm(BARGE, robots), (1.0, -3.0, 0.4)
    found = quality(swarm, load=load)
    assert -found.margin == pytest.approx(forces(swarm, (0, 0, 0), load=load).shortfall, rel=1e-9)


def test_nothing_missed_without_a_load():
    """A swarm without force closure is on the border of nothing; nobody misses all of a load."""
    swarm = swarm_of("free", 1, 3)
    assert (quality(swarm).value, quality(swarm).margin) == (0.0, 0.0)
    assert missed(swarm, Criterion()).value == 0.0
    for robots in ([], swarm.robots):
        alone = quality(Swarm(swarm.outline, robots), losing=3, load=(3.0, 4.0, 0.0))
        assert (alone.margin, alone.missing.tolist()) == (-5.0, [-3.0, -4.0, 0.0])
