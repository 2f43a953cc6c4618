"""Quality by criteria: losses, loads and tasks, against the listing of all subsets."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import reference
from cases import QUALITIES, swarm_of_case
from strategies import seeds, swarm_of, swarms
from swarmgrasp import (
    Criterion,
    Ellipsoid,
    Outline,
    Polytope,
    Robot,
    Swarm,
    WrenchSet,
    losses,
    quality,
)
from swarmgrasp.errors import CriterionInvalid, RobotInvalid, WrenchInvalid

LOSABLE = [name for name, case in QUALITIES.items() if "quality_after_losing_1" in case]
KINDS = {"polytope": Polytope, "ellipsoid": Ellipsoid}


def size(swarm):
    """Return sum |b_i| [N], the scale of every rounding error."""
    return float(np.linalg.norm(swarm.scaled_generators, axis=1).sum())


@pytest.mark.parametrize("name", LOSABLE)
@pytest.mark.parametrize("losing", [1, 2])
def test_reference_cases(name, losing):
    """Another program's qualities after the worst loss of one robot and of two."""
    case = QUALITIES[name]
    truth = case[f"quality_after_losing_{losing}"]
    found = quality(swarm_of_case(case), losing=losing)
    assert found.value == pytest.approx(truth, rel=1e-9, abs=1e-11)
    assert len(found.lost) <= losing


@given(swarms, st.integers(1, 3))
def test_the_worst_loss_is_that_of_all_subsets(swarm, losing):
    """No subset is worse than the robots said to be lost, and those are as bad."""
    found = quality(swarm, losing=losing)
    B = swarm.scaled_generators
    truth = reference.quality_by_criterion(B, losing) if len(B) > losing else 0.0
    slack = 1e-9 * truth + 4e-12 * size(swarm)
    assert found.value == pytest.approx(truth, abs=slack)
    assert quality(found.worst_swarm).value == pytest.approx(found.value, abs=slack)


@settings(max_examples=60)
@given(swarms, st.integers(0, 1), st.sampled_from([None, *KINDS]), st.integers(1, 4), seeds)
def test_loads_and_tasks(swarm, losing, kind, count, seed):
    """The least (H + n . load) / D over all facet normals, whatever the task's shape."""
    rng = np.random.default_rng(seed)
    B, scale = swarm.scaled_generators, swarm.scale
    unit = size(swarm) or 1.0
    load = 0.02 * unit * rng.normal(size=3) * rng.integers(0, 2)
    rows = unit * rng.normal(size=(count, 3))
    task = None if kind is None else KINDS[kind](rows / scale)
    value = quality(swarm, losing=losing, load=tuple(load / scale), task=task).value
    truth = reference.quality_by_criterion(B, losing, load, rows, kind) if len(B) > losing else 0.0
    assert value == pytest.approx(truth, rel=1e-7, abs=1e-9 * (unit if kind is None else 1.0))


def test_two_hundred_robots_and_three_lost():
    """The three lost are as bad as is said, and other three are no worse."""
    swarm = swarm_of("free", 5, 200)
    found = quality(swarm, losing=3)
    assert len(found.lost) == 3
    assert quality(swarm.without(found.lost)).value == pytest.approx(found.value, rel=1e-12)
    for other in (["R1", "R2", "R3"], {*found.facet_robots, found.lost[0]}):
        assert quality(swarm.without(other)).value >= found.value


def test_a_task_in_one_direction_is_a_ray():
    """How far the wrench set reaches along a wrench, with force closure or without."""
    square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    pair = Swarm(square, [Robot((1, -0.5), 0.2), Robot((1, 0.5), -0.2)])
    assert quality(pair).value == 0.0
    ahead = quality(pair, task=Polytope([(1.0, 0.0, 0.0)])).value
    assert ahead == pytest.approx(2.0 * math.cos(0.2), rel=1e-12)
    assert WrenchSet(pair).contains([ahead * (1.0 - 1e-9), 0.0, 0.0])
    assert not WrenchSet(pair).contains([ahead * (1.0 + 1e-6), 0.0, 0.0])
    assert quality(pair, task=Polytope([(-1.0, 0.0, 0.0)])).value == 0.0


def test_a_load_that_is_not_held_leaves_nothing():
    """The margin is 0 just beyond what the swarm holds, and small just within."""
    swarm = swarm_of("free", 3, 12)
    held = quality(swarm, task=Polytope([(1.0, -2.0, 0.5)])).value
    against = -held * np.array([1.0, -2.0, 0.5])
    assert quality(swarm, load=tuple(1.001 * against)).value == 0.0
    assert 0.0 < quality(swarm, load=tuple(0.999 * against)).value < 0.01 * size(swarm)


def test_losing_more_than_there_are():
    """Nothing is left, and nothing breaks."""
    swarm = swarm_of("free", 1, 5)
    for losing in (5, 6, 1000):
        assert quality(swarm, losing=losing).value == 0.0
    assert quality(Swarm(swarm.outline, []), losing=1).value == 0.0


def test_every_single_loss():
    """Each robot's loss is the quality without it; the worst of them is the worst loss."""
    swarm = swarm_of("along normals", 8, 9)
    found = losses(swarm)
    assert [loss.quality for loss in found] == sorted(loss.quality for loss in found)
    assert found[0].quality == pytest.approx(quality(swarm, losing=1).value, rel=1e-9)
    for loss in found:
        assert loss.quality == quality(swarm.without(loss.name)).value
        assert loss.is_vital == (loss.quality == 0.0)
        assert loss.words


def test_wrong_input_is_named_all_at_once():
    """A criterion, a task and a subset of robots say everything that is wrong with them."""
    with pytest.raises(CriterionInvalid) as fault:
        Criterion(losing=-1, worst_case="yes", load=(1, 2), task=3)
    assert len(fault.value.faults) == 4
    with pytest.raises(CriterionInvalid):
        quality(swarm_of("free", 1, 5), losing=True)
    for rows in ([], [1, 2, 3], [(0, 0, 0)], [(1, math.nan, 0)], "abc"):
        for kind in KINDS.values():
            with pytest.raises(WrenchInvalid):
                kind(rows)
    with pytest.raises(RobotInvalid, match="no robot called 5; there are R1, R2"):
        swarm_of("free", 1, 5).without([5])
