"""One robot that attaches elsewhere: the best of all such moves."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import reference
from strategies import seeds, swarm_of
from swarmgrasp import (
    Criterion,
    Newcomer,
    Outline,
    Problem,
    Robot,
    Stretch,
    Swarm,
    Tolerance,
    Zone,
    best_move,
    place,
    quality,
)
from swarmgrasp.errors import NowhereToAttach, RobotInvalid

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
PULLS = [
    ((1, -0.4), 0.0),
    ((-1, 0.4), math.pi),
    ((-0.4, 1), math.pi / 2),
    ((0.4, -1), -math.pi / 2),
]
FOUR = Swarm(SQUARE, [Robot(*row, name=name) for row, name in zip(PULLS, "ABCD", strict=True)], 1.0)
PULLING = Newcomer(1.0, "pull", 0.0)


@given(st.sampled_from(["free", "along normals", "spread limits", "balanced"]), seeds,
       st.integers(2, 7))  # fmt: skip
@settings(max_examples=25)
def test_no_move_of_one_robot_is_better(family, seed, n):
    """Whichever robot goes wherever: random moves stay below the bound, the best is exact."""
    rng = np.random.default_rng(seed)
    swarm = swarm_of(family, seed, n)
    move = best_move(Problem(swarm, Newcomer(5.0, "push", 0.7)))
    slack = 1e-11 * (np.linalg.norm(swarm.scaled_generators, axis=1).sum() + 1.0)
    truth = reference.quality(move.swarm_after.scaled_generators)
    assert move.quality == pytest.approx(truth, rel=1e-9, abs=slack)
    assert move.gain == pytest.approx(truth - quality(swarm).value, rel=1e-9, abs=2.0 * slack)
    assert len(move.ranked) == len(swarm)
    assert all(a.quality >= b.quality for a, b in zip(move.ranked, move.ranked[1:], strict=False))
    for _ in range(30):
        gone = swarm.names[int(rng.integers(len(swarm)))]
        at = swarm.outline.at_arc_length(rng.uniform(0.0, swarm.outline.perimeter))
        robot = Robot(at.point, at.inward + rng.uniform(-0.7, 0.7), swarm[gone].limit)
        moved = swarm.without(gone).with_robot(robot)
        assert quality(moved).value <= move.upper_bound * (1.0 + 1e-9) + slack


def test_the_stray_goes_back():
    """Three of the square's four, and one where it adds nothing: it goes where it was."""
    stray = Robot((0.4, 1.0), math.pi / 2, name="D")
    move = best_move(Problem(Swarm(SQUARE, [*FOUR.robots[:3], stray], 1.0), PULLING))
    assert move.best.name == "D"
    assert move.best.new.contact == pytest.approx((0.4, -1.0), rel=1e-5)
    assert move.best.new.name == "D"
    assert move.quality_before == 0.0
    assert move.quality == pytest.approx(0.8 / math.sqrt(1.32), rel=1e-5)
    assert move.best.placement.verify()
    assert [robot.name for robot in move.swarm_after.robots] == list("ABCD")
    assert move.is_worth_it(0.6)
    assert not move.is_worth_it(0.7)
    assert "D had better be on edge 0" in move.reason


def test_a_balanced_square_is_left_alone():
    """No robot alone can raise it; the answer says so, and the ranking is still there."""
    move = best_move(Problem(FOUR, PULLING))
    assert not move.improves
    assert not move.is_worth_it(1e-6)
    assert move.gain == pytest.approx(0.0, abs=1e-6)
    assert move.upper_bound == pytest.approx(move.quality_before, rel=2e-6)
    assert "leave them" in move.reason


def test_the_rules_of_the_problem_hold():
    """Zones, spacing and criterion; each robot keeps its limit, and a thruster its place."""
    robots = [Robot((1, 0.2 * k), math.pi, 3.0 + k) for k in range(-2, 3)]
    swarm = Swarm(SQUARE, [*robots, Robot((0.0, 0.0), 1.0, 9.0, mounted=True)])
    zones = (Zone(Stretch(4.0, 6.0, "north")),)
    problem = Problem(swarm, Newcomer(1.0, "push", 0.5), zones, spacing=0.3)
    move = best_move(problem)
    assert {each.name for each in move.ranked} == {f"R{k}" for k in range(1, 6)}
    for each in move.ranked:
        assert each.place == "north"
        assert each.new.limit == each.old.limit
        assert each.new.contact[1] == 1.0
    one = best_move(problem, robots="R4")
    assert one.best.name == "R4"
    again = place(swarm.without("R4"), Newcomer(4.0, "push", 0.5), zones, spacing=0.3)
    assert one.quality == pytest.approx(again.quality, rel=1e-6, abs=1e-12)


def test_of_a_swarm_alone():
    """Anywhere, in any direction."""
    swarm = swarm_of("free", 5, 6)
    assert (
        best_move(swarm).quality >= best_move(Problem(swarm, Newcomer(1.0, "push"))).quality - 1e-6
    )


def test_wrong_questions():
    """No robot to move, none such, a thruster, nowhere to go."""
    thruster = Robot((0.0, 0.0), 1.0, mounted=True, name="T")
    aboard = Swarm(SQUARE, [thruster, *FOUR.robots])
    with pytest.raises(RobotInvalid, match="no robot that could move"):
        best_move(Swarm(SQUARE, [thruster]))
    with pytest.raises(RobotInvalid) as error:
        best_move(aboard, robots=[0, "Z", "B"])
    assert len(error.value.faults) == 2
    with pytest.raises(RobotInvalid, match="T is mounted"):
        best_move(aboard, robots=["T", "B"])
    with pytest.raises(RobotInvalid, match="give at least one"):
        best_move(aboard, robots=[])
    with pytest.raises(NowhereToAttach, match="anywhere to go"):
        best_move(Problem(FOUR, PULLING, spacing=5.0))


def test_who_may_be_absent_is_worth_nothing_in_the_worst_case():
    """It does not move; asked for by name it is refused."""
    from swarmgrasp import Criterion

    absent = Robot((0.4, 1.0), math.pi / 2, tolerance=Tolerance(may_be_absent=True))
    worst = Criterion(worst_case=True)
    problem = Problem(Swarm(SQUARE, [*FOUR.robots, absent], 1.0), PULLING, criterion=worst)
    assert {each.name for each in best_move(problem).ranked} == set("ABCD")
    with pytest.raises(RobotInvalid, match="may be absent"):
        best_move(problem, robots="R1")


def test_who_fails_with_others_stays_where_losses_count():
    """A moved robot stays in its group, and the quality told is that of the swarm then."""
    rng = np.random.default_rng(3)
    places = [SQUARE.at_arc_length(s) for s in rng.uniform(0.0, 8.0, 9)]
    robots = [
        Robot(p.point, p.inward + rng.uniform(-0.7, 0.7), name=f"N{i}", group="A" if i < 2 else "")
        for i, p in enumerate(places)
    ]
    swarm = Swarm(SQUARE, robots)
    named = Criterion(failures=(("N3", "A"),))
    for criterion, staying in ((Criterion(losing=1), {"N0", "N1"}), (named, {"N0", "N1", "N3"})):
        problem = Problem(swarm, Newcomer(), criterion=criterion)
        for name in staying:
            with pytest.raises(RobotInvalid, match=f"{name}: where a robot should go that fails"):
                best_move(problem, robots=[name])
    move = best_move(Problem(swarm, Newcomer(), criterion=Criterion(losing=1)))
    assert not {found.name for found in move.ranked} & {"N0", "N1"}
    after = quality(move.best.swarm_after, losing=1).value
    assert move.quality == pytest.approx(after, abs=1e-9)
    alone = best_move(swarm, robots=["N0"])
    assert alone.best.new.group == "A"
    assert quality(alone.best.swarm_after).value == pytest.approx(alone.quality, abs=1e-9)
