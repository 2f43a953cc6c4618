"""The best place of all: bounds from both sides, and what every answer must obey."""

import math
import re

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import reference
from strategies import FAMILIES, L_SHAPE, newcomer_of, problem_of, problems, seeds, swarm_of
from swarmgrasp import (
    Newcomer,
    Outline,
    Robot,
    Stretch,
    Swarm,
    Zone,
    place,
    place_sequence,
    quality,
)
from swarmgrasp.errors import NowhereToAttach, ProblemInvalid, SwarmGraspError
from swarmgrasp.placement import Problem

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)], edge_names=["s", "e", "n", "w"])
PULLS = [
    ((1, -0.4), 0.0),
    ((-1, 0.4), math.pi),
    ((-0.4, 1), math.pi / 2),
    ((0.4, -1), -math.pi / 2),
]
THREE = Swarm(SQUARE, [Robot(*row) for row in PULLS[:3]], 1.0)


def rounding(answer):
    """Return the absolute part of the gap [N]: what counts as zero, and half that twice."""
    swarm = answer.swarm_after
    reach = np.linalg.norm(swarm.scale[:2]) + swarm.outline.radius * swarm.scale[2]
    total = np.linalg.norm(swarm.scaled_generators, axis=1).sum()
    return 4e-12 * float(total + answer.robot.limit * reach)


def solved(problem):
    """Answer a problem, or skip the example if nowhere is left."""
    try:
        (answer,) = place_sequence(problem, 1)
    except NowhereToAttach:
        assume(False)
    return answer


def whole_boundary(outline, newcomer):
    """List all (p, q, low, high) of a newcomer that may attach anywhere, from the vertices."""
    half = math.pi / 2 if newcomer.half_angle is None else newcomer.half_angle
    sides = {"push": [0.0], "pull": [math.pi], "free": [0.0, math.pi]}[newcomer.attachment]
    found = []
    for p, q in zip(outline.vertices, np.roll(outline.vertices, -1, axis=0), strict=True):
        inward = math.atan2(q[1] - p[1], q[0] - p[0]) + math.pi / 2
        found += [(p, q, inward + side - half, inward + side + half) for side in sides]
    return found


def mirrored(problem):
    """Reflect a problem on the whole boundary in the x axis."""
    swarm = problem.swarm
    flip = np.array([1.0, -1.0])
    robots = [Robot(tuple(r.contact * flip), -r.direction, r.limit) for r in swarm.robots]
    outline = Outline(swarm.outline.vertices * flip, swarm.outline.origin * flip)
    image = Swarm(outline, robots, swarm.characteristic_length, swarm.force_weights)
    return Problem(image, problem.newcomer)


# -- optimality -----------------------------------------------------------------------


@given(st.sampled_from(FAMILIES), seeds, st.integers(0, 9))
@settings(max_examples=50)
def test_no_robot_of_a_grid_is_better(family, seed, n):
    """Answers are at least as good as any sampled robot, bounds the more so."""
    assume(family != "ring")  # 240 pieces: in the sweep
    rng = np.random.default_rng(seed)
    swarm, newcomer = swarm_of(family, seed, n), newcomer_of(rng, 10.0 ** rng.uniform(-1, 1))
    answer = place(swarm, newcomer)
    pieces = whole_boundary(swarm.outline, newcomer)
    best, *_ = reference.best_on_grid(
        swarm.scaled_generators, pieces, newcomer.limit, swarm.outline.origin, swarm.scale, 7, 13
    )
    slack = rounding(answer)
    assert best <= answer.upper_bound * (1.0 + 1e-9) + slack
    assert best <= answer.quality * (1.0 + 1e-6) + slack


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("family", ["free", "notched"])
def test_linear_programs_agree(family, seed):
    """An independent cutting-plane solution of each piece, to within its tolerance."""
    swarm = swarm_of(family, seed, 4 + seed % 3)
    newcomer = Newcomer(1.0, "pull" if seed % 2 else "push", [0.3, None, 0.0][seed % 3])
    answer = place(swarm, newcomer, gap=1e-7)
    found = [
        reference.piece_upper_bound_lp(
            swarm.scaled_generators, piece, 1.0, swarm.outline.origin, swarm.scale, 1e-5
        )
        for piece in whole_boundary(swarm.outline, newcomer)
    ]
    upper, lower = np.max(found, axis=0)
    assert lower <= answer.upper_bound + 1e-9
    assert answer.quality <= upper + 1e-9
    assert answer.quality >= lower - 1e-6


@given(problems)
@settings(max_examples=150)
def test_every_answer_is_real_exact_and_closed(problem):
    """Within the gap of its bound, with exactly its quality, and verified by other code."""
    answer = solved(problem)
    slack = rounding(answer)
    assert 0.0 <= answer.upper_bound - answer.quality <= 1e-6 * answer.quality + slack
    assert answer.quality >= answer.quality_before * (1.0 - 1e-9) - slack
    truth = reference.quality(answer.swarm_after.scaled_generators)
    assert answer.quality == pytest.approx(truth, rel=1e-9, abs=slack)
    assert answer.robot.limit == problem.newcomer.limit
    verdict = answer.verify()
    assert verdict, verdict.faults


@given(st.sampled_from(FAMILIES[:6]), seeds, st.integers(0, 9))
@settings(max_examples=60)
def test_a_stronger_newcomer_is_never_worse_and_a_mirror_changes_nothing(family, seed, n):
    """Monotone in the limit (T6); the same quality for the reflected problem."""
    problem = problem_of(family, seed, n)
    weak = Problem(problem.swarm, newcomer_of(np.random.default_rng(seed), 0.5))
    kind = weak.newcomer
    strong = Problem(weak.swarm, Newcomer(2.0, kind.attachment, kind.half_angle))
    low, high, image = (solved(p) for p in (weak, strong, mirrored(weak)))
    slack = rounding(high)
    assert high.quality >= low.quality * (1.0 - 1e-6) - slack
    assert image.quality == pytest.approx(low.quality, rel=1.1e-6, abs=slack)


@given(st.sampled_from(["free", "along normals", "ring"]), seeds, st.sampled_from([1e-6, 1e6]))
@settings(max_examples=25)
def test_a_newcomer_of_another_size(family, seed, limit):
    """A millionth or a million times as strong as the others, to the same gap."""
    swarm = swarm_of(family, seed, 9)
    answer = place(swarm, newcomer_of(np.random.default_rng(seed), limit))
    assert answer.upper_bound <= (1.0 + 1e-6) * answer.quality + rounding(answer)
    assert answer.verify()


@pytest.mark.parametrize(("seed", "n"), [(41, 11), (120, 4), (163, 9), (509, 7), (575, 5)])
def test_a_giant_newcomer_on_an_object_of_many_edges(seed, n):
    """240 pieces, each of which asks for many normals: the gap is closed all the same."""
    answer = solved(problem_of("ring", seed, n))
    assert answer.upper_bound <= (1.0 + 1e-6) * answer.quality + rounding(answer)


@pytest.mark.parametrize("turn", [1e-9, 1e-8, 1e-7, 1e-6])
def test_a_base_that_is_only_nearly_balanced(turn):
    """Weak at n and almost at -n: a strong newcomer gets in between, and no bound denies it."""
    robots = [Robot(c, a + turn * (k == 0)) for k, (c, a) in enumerate(PULLS[:2] * 2)]
    swarm = Swarm(SQUARE, robots, 1.0)
    for newcomer in (Newcomer(1e6, "push", 0.0), Newcomer(1e4, "free")):
        answer = place(swarm, newcomer)
        verdict = answer.verify()
        assert verdict, verdict.faults


# -- particular objects ---------------------------------------------------------------


def test_the_missing_robot_of_the_square_is_found():
    """Three of the four robots of the theory's square: the fourth goes to (0.4, -1)."""
    answer = place(THREE, Newcomer(1.0, "pull", 0.0), gap=1e-9)
    assert answer.robot.contact == pytest.approx((0.4, -1.0), abs=1e-6)
    assert answer.quality == pytest.approx(0.8 / math.sqrt(1.32), rel=1e-9)
    assert (answer.quality_before, answer.improves, answer.place) == (0.0, True, "s")


@pytest.mark.parametrize("shift", [(0.0, 0.0), (30.0, -20.0), (1e4, 1e4)])
def test_the_frame_does_not_matter_and_the_origin_may_be_anywhere(shift):
    """Moving the frame moves the answer; a far origin is another, still proven, problem."""
    outline = Outline(np.add(L_SHAPE, shift))
    spots = [outline.at_arc_length(s) for s in (0.5, 2.0, 3.7, 5.1, 6.2, 9.0)]
    robots = [Robot(c.point, c.inward + 0.3 * k) for k, c in enumerate(spots)]
    newcomer = Newcomer(1.5, "push")
    answer = place(Swarm(outline, robots, 1.0), newcomer)
    still = Outline(L_SHAPE)
    home = [Robot(tuple(np.subtract(r.contact, shift)), r.direction) for r in robots]
    truth = place(Swarm(still, home, 1.0), newcomer)
    assert answer.quality == pytest.approx(truth.quality, rel=1.1e-6)
    far = Swarm(Outline(L_SHAPE, origin=shift), home, 1.0, (4.0, 0.25))
    there = place(far, newcomer)
    assert there.upper_bound <= (1.0 + 1e-6) * there.quality + rounding(there)
    assert there.verify()


@given(seeds, st.integers(3, 9))
@settings(max_examples=60)
def test_one_edge_as_a_zone(seed, corners):
    """It never beats the whole boundary, equals it on the best edge, and verifies."""
    rng = np.random.default_rng(seed)
    turns = np.sort(rng.uniform(0, 2 * math.pi, corners))
    assume(np.diff(turns, append=turns[0] + 2 * math.pi).max() < 3.0)
    outline = Outline(np.column_stack([2.0 * np.cos(turns), np.sin(turns)]))
    spots = [outline.at_arc_length(s) for s in rng.uniform(0, outline.perimeter, 5)]
    swarm = Swarm(outline, [Robot(c.point, rng.uniform(-4, 4)) for c in spots])
    newcomer = newcomer_of(rng)
    whole = place(swarm, newcomer)
    answers = [place(swarm, newcomer, [Zone(outline.stretch(e))]) for e in range(len(outline))]
    best = max(a.quality for a in answers)
    assert best == pytest.approx(whole.quality, rel=1.1e-6, abs=rounding(whole))
    assert [a.verify().faults for a in answers] == [()] * len(answers)


@pytest.mark.parametrize("n", range(4))
def test_too_few_robots(n):
    """With at most three robots and the newcomer there is no closure, unless it is the fourth."""
    swarm = Swarm(SQUARE, [Robot(*row) for row in PULLS[:n]], 1.0)
    answer = place(swarm, Newcomer(1.0, "free"))
    assert answer.improves is (n == 3)
    assert (answer.quality > 0.0) is (n == 3)
    assert answer.verify()


# -- the other arguments --------------------------------------------------------------


def test_runners_up_are_the_best_of_other_places():
    """In order, each the optimum of its own edge, none below the fraction asked for."""
    newcomer = Newcomer(1.0, "pull")
    answer = place(THREE, newcomer, runners_up=0.1)
    assert answer.runners_up
    values = [r.quality for r in answer.runners_up]
    assert values == sorted(values, reverse=True)
    assert answer.quality * (1.0 + 1e-6) >= values[0]
    assert values[-1] >= 0.1 * answer.quality
    for runner in answer.runners_up:
        assert runner.place != answer.place
        alone = place(THREE, newcomer, [Zone(SQUARE.stretch(runner.place))])
        assert runner.quality == pytest.approx(alone.quality, rel=1.1e-6)
        truth = quality(THREE.with_robot(runner.robot)).value
        assert runner.quality == pytest.approx(truth, rel=1e-14)
    assert answer.verify()


def test_the_gap_is_what_was_asked_for():
    """Coarse answers have honest bounds, fine ones end where rounding begins."""
    swarm = swarm_of("free", 5, 12)
    answers = [place(swarm, Newcomer(), gap=gap) for gap in (0.1, 1e-3, 1e-9, 1e-15)]
    bounds = [a.upper_bound for a in answers]
    assert bounds[-1] <= min(bounds) * (1.0 + 1e-12)
    for answer, gap in zip(answers[:3], (0.1, 1e-3, 1e-9), strict=True):
        assert answer.upper_bound <= (1.0 + gap) * answer.quality + rounding(answer)
        assert answer.verify()
    assert answers[-1].upper_bound <= answers[-1].quality + rounding(answers[-1])


@pytest.mark.parametrize(
    ("rest", "says"),
    [
        ({"gap": 0.0}, "the gap is 0.0; it should be 0 < gap < 1"),
        ({"gap": math.nan}, "the gap is nan"),
        ({"gap": "x"}, "the gap is 'x'"),
        ({"gap": None}, "the gap is None"),
        ({"gap": 1e-6j}, "the gap is 1e-06j"),
        ({"runners_up": 1.5}, "runners_up is 1.5; it should be a fraction"),
        ({"runners_up": True}, "runners_up is True; it should be a fraction"),
        ({"zones": []}, "give None for the whole boundary"),
        ({"spacing": -1.0}, "0 <= spacing <= "),
        ({"no_go": [Stretch(0, 99)]}, "both ends should lie in"),
    ],
)
def test_bad_arguments_are_named(rest, says):
    """With the value and its range."""
    with pytest.raises(SwarmGraspError, match=says):
        place(THREE, Newcomer(), **rest)


@pytest.mark.parametrize("count", [0, -1, 1.5, 2.0, True, "2", None, math.nan, 1001, 2**63])
def test_robots_are_counted_in_whole_numbers(count):
    """From one to a thousand, told before any search."""
    says = f"the number of robots is {count!r}; it should be a whole number from 1 to 1000"
    with pytest.raises(SwarmGraspError, match=re.escape(says)):
        place_sequence(Problem(THREE, Newcomer()), count)


def test_a_number_of_thousands_of_digits_is_not_written_out():
    """The message stays short."""
    with pytest.raises(SwarmGraspError) as caught:
        place_sequence(Problem(THREE, Newcomer()), 10**5000)
    assert len(str(caught.value)) < 200


def test_what_was_not_found_is_not_called_impossible():
    """A wide gap leaves open whether a place helps; a narrow one says."""
    problem = problem_of("integer grid", 16, 6)
    (rough,), (fine,) = (place_sequence(problem, 1, gap=gap) for gap in (0.9, 1e-6))
    assert not rough.improves
    assert rough.gap == pytest.approx(rough.upper_bound / rough.quality - 1.0)
    assert 1e-3 < rough.gap < rough.asked_gap
    assert "whether there is one is not settled" in rough.reason
    assert fine.gap <= 1e-6
    assert "not settled" not in fine.reason


def test_numbers_of_numpy_count_as_numbers():
    """A count, a gap and a fraction from arrays."""
    asked = {"gap": np.float32(1e-3), "runners_up": np.int64(1)}
    (answer,) = place_sequence(Problem(THREE, Newcomer()), np.int64(1), **asked)
    assert answer.verify()


def test_all_arguments_of_a_sequence_are_told_at_once():
    """Also that a swarm is no problem yet."""
    with pytest.raises(ProblemInvalid, match=r"^Swarm is no Problem: make one with") as caught:
        place_sequence(THREE, 0, gap=1.0, runners_up=-1.0)
    assert len(caught.value.faults) == 4


@pytest.mark.parametrize("seed", [2, 17, 38, 39])
def test_no_runner_up_is_better_than_the_answer(seed):
    """With a wide gap the search on one edge may find what that on all has left aside."""
    (answer,) = place_sequence(problem_of("along normals", seed, 6), 1, gap=0.3, runners_up=0.1)
    assert answer.runners_up
    assert all(runner.quality <= answer.quality * (1.0 + 1e-5) for runner in answer.runners_up)
    assert answer.verify()
