"""Robots with gaps between their sectors: bounds of the quality, and choices (T28)."""

import math
from dataclasses import replace

import numpy as np
import pytest

import reference
from crews import SIDES, robots_with_gaps, unit
from swarmgrasp import (
    Ellipsoid,
    Newcomer,
    Outline,
    Problem,
    Robot,
    Swarm,
    Tolerance,
    WrenchSet,
    best_move,
    losses,
    place_together,
    qualities_with,
    quality,
    sensitivities,
)
from swarmgrasp.errors import ForceSetUnsupported, RobotInvalid
from swarmgrasp.quality import changing
from swarmgrasp.quality.changing import NEAR
from swarmgrasp.swarm.choices import Asked, Choices


def crew_of(rng, count):
    """Return a swarm of robots of one to three sectors each."""
    return unit(*robots_with_gaps(rng, count))


def fixed(swarm, sectors):
    """Return a swarm whose robots keep to sectors, by name."""
    return unit(*(
        replace(robot, sectors=[sectors[robot.name]], direction=math.nan)
        if robot.name in sectors else robot
        for robot in swarm
    ))  # fmt: skip


@pytest.mark.parametrize(
    "terms",
    [
        {},
        {"losing": 1},
        {"load": (0.1, 0.0, 0.1)},
        {"task": Ellipsoid([(1, 0, 0), (0, 1, 0), (0, 0, 0.2)])},
    ],
)
@pytest.mark.parametrize("seed", range(4))
def test_the_bounds_are_those_of_all_choices(seed, terms):
    """Below, the best of all choices of a sector each; above, the robots with gaps filled."""
    swarm = crew_of(np.random.default_rng([seed, 5]), 4)
    found, choices = quality(swarm, **terms), Choices(swarm)
    each = np.ndindex(*map(len, choices.options))
    best = max(quality(choices.swarm(taken), **terms).value for taken in each)
    assert found.value == pytest.approx(best, rel=1e-5, abs=1e-12)
    assert max(found.value * (1.0 - 1e-9), found.bound) <= found.upper_bound * (1.0 + 1e-9)
    filled = quality(swarm.filled, **terms).value
    assert found.upper_bound <= filled * (1.0 + 1e-8)
    if terms and found.choice is not None:
        assert found.upper_bound == pytest.approx(filled, rel=1e-8)
    if found.choice is not None:
        kept = quality(fixed(swarm, found.choice.sectors), **terms)
        assert kept.value == pytest.approx(found.value, rel=1e-8)


@pytest.mark.parametrize("seed", range(4))
def test_the_sampled_truth_lies_between(seed):
    """How far the union reaches, in the worst of directions tried, is within the bounds."""
    rng = np.random.default_rng([seed, 6])
    swarm = crew_of(rng, 3)
    found = quality(swarm)
    ways = rng.normal(size=(12, 3))
    ways /= np.linalg.norm(ways, axis=1)[:, None]
    arms = swarm.contacts - swarm.outline.origin
    needed = [
        reference.least_factor_of_sectors(swarm.robots, arms, swarm.scale, way) for way in ways
    ]
    assert found.bound <= 1.0001 / max(needed)
    heights = reference.height_of_sets(swarm, ways)
    assert (found.upper_bound <= heights * (1.0 + 1e-5) + 1e-9).all()
    assert found.bound >= (1.0 - 2.0 * NEAR) * found.upper_bound


@pytest.mark.parametrize("seed", range(4))
def test_a_gap_never_helps_and_filling_it_gives_the_ordinary_robot(seed):
    """Sectors that touch are one; azimuths all around bound whatever has gaps."""
    swarm = crew_of(np.random.default_rng([seed, 7]), 4)
    around = unit(*(replace(r, sectors=[(0, 3), (3, math.tau)], direction=math.nan, steers=0.0)
                    for r in swarm))  # fmt: skip
    assert [robot.steers for robot in around] == [math.pi] * 4
    assert quality(swarm).upper_bound <= quality(around).value * (1.0 + 1e-8)


def test_two_azimuths_that_push_aside():
    """Two cannot push ahead without turning; four can, and reach as far as with gaps filled."""
    pair = unit(*(Robot((x, 0.0), sectors=SIDES, mounted=True) for x in (0.7, -0.7)))
    found = quality(pair)
    assert (found.value, found.upper_bound, str(found.force_closure)) == (0.0, 0.0, "no")
    assert "nothing in some directions, whatever sectors" in found.explanation
    r = 0.7
    assert quality(pair.filled).value == pytest.approx(2 * r / math.sqrt(1 + r * r), rel=1e-9)
    four = unit(*(Robot((x, 0.0), sectors=SIDES, mounted=True) for x in (0.9, 0.3, -0.3, -0.9)))
    found = quality(four)
    assert 0.0 < 1.5 * found.value < found.bound
    assert 0.98 * found.upper_bound <= found.bound <= found.upper_bound
    assert found.upper_bound == pytest.approx(quality(four.filled).value, rel=1e-5)
    assert "from 2.287 N to 2.299 N, as robots may change" in found.explanation
    worst = losses(four)[0]
    assert worst.quality <= worst.after.upper_bound <= quality(four).upper_bound


def test_too_many_choices_say_so():
    """The work ends; what was found is a choice still, and no worse than going down greedily."""
    swarm = crew_of(np.random.default_rng(1), 5)
    choices = Choices(swarm)

    def ask(taken):
        """Ask for nothing but the quality."""
        value = quality(choices.swarm(taken)).value
        return Asked((-value,), choices.first_open(taken), value)

    short, long = choices.least(ask, most=1), choices.least(ask)
    assert (short.is_best, long.is_best) == (False, True)
    assert -1 not in short.taken
    assert short.asked.what <= long.asked.what * (1.0 + 1e-5)


def test_what_is_not_known_is_refused():
    """Nothing takes robots with gaps for something else."""
    spread = replace(
        Robot((0.5, 0), sectors=SIDES, mounted=True), tolerance=Tolerance(direction=0.1)
    )
    swarm = unit(Robot((0.5, 0), sectors=SIDES, mounted=True), Robot((-0.5, 0), 0.0, mounted=True))
    for ask in (
        lambda: sensitivities(swarm), lambda: WrenchSet(swarm), lambda: swarm.force_sets,
        lambda: place_together(Problem(swarm, Newcomer(steers=True)), 2),
        lambda: qualities_with(swarm, [(1.0, 0.0)], [3.0]),
        lambda: best_move(swarm),
    ):  # fmt: skip
        with pytest.raises(ForceSetUnsupported, match="gaps between: R1"):
            ask()
    with pytest.raises(RobotInvalid, match="sectors with gaps between is not known"):
        quality(unit(spread), worst_case=True)


L_SHAPE = Outline([(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)])


def test_no_more_is_asked_than_the_budget_holds(monkeypatch):
    """Thrusters whose quality stays open ask for no more wrenches than are allowed."""
    crew = Swarm(L_SHAPE, [
        Robot((1.5333333333333332, 0.6666666666666666), 0.0, 1.4798049038350918, mounted=True,
              reverse_limit=1.0358634326845642),
        Robot((1.2333333333333334, 0.8398717474235544), limit=1.8866479975630024, mounted=True,
              sectors=((0.25217763435220775,) * 2, (2.7390659567188838,) * 2), group="A"),
        Robot((1.2333333333333332, 0.49346158590977895), -2.347702109254705, 0.8944087722899638,
              mounted=True, reverse_limit=0.6260861406029746, group="A"),
    ])  # fmt: skip
    asked, reaches = [], changing._reaches
    monkeypatch.setattr(
        changing, "_reaches", lambda one, ways: asked.append(len(ways)) or reaches(one, ways)
    )
    monkeypatch.setattr(changing, "MOST_ASKED", 3000)
    found = quality(crew)
    assert 0 < sum(asked) <= 3000
    assert found.bound <= found.upper_bound


def test_giants_leave_the_best_kept_choice_and_the_hull(monkeypatch):
    """Where limits are so far apart that rounding decides, no triangle is asked for."""
    monkeypatch.setattr(changing, "_reaches", None)
    square = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])
    crew = Swarm(square, [
        Robot((2, -0.36), limit=1e9, sectors=((3.7676, 8.8430),)),
        Robot((2, 0.5), sectors=((3.2169, 5.5882), (5.8214, 7.8071))),
        Robot((2, 0.5), sectors=((5.3535, 10.3764),)),
    ])  # fmt: skip
    found = quality(crew)
    assert 0.0 <= found.bound <= found.upper_bound
