"""A place found from a summary, and what is certain about it."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from strategies import FAMILIES, problem_of, rectangle
from summary.crowds import summary_of
from swarmgrasp import Newcomer, Outline, Robot, Stretch, Swarm, Zone, place, quality
from swarmgrasp.errors import NowhereToAttach, OutlineInvalid, SummaryInvalid, ZoneInvalid
from swarmgrasp.summary import Summary

seeds = st.integers(0, 2**32 - 1)
SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)], edge_names=["s", "e", "n", "w"])
PULLS = [((1, -0.4), 0), ((-1, 0.4), math.pi), ((-0.4, 1), math.pi / 2), ((0.4, -1), -math.pi / 2)]


@given(st.sampled_from(FAMILIES), seeds, st.integers(0, 40), st.sampled_from([12, 108, 972]))
@settings(max_examples=150)
def test_the_bounds_hold_of_the_swarm_itself(family, seed, n, bins):
    """The robot is allowed and as good as said, and the best one is within the bound."""
    problem = problem_of(family, seed, n)
    swarm = problem.swarm
    summary = Summary.from_bytes(Summary.of(swarm, bins).to_bytes())
    asked = (problem.newcomer, problem.zones, problem.no_go)
    found = summary.place(swarm.outline, *asked)
    truth = quality(swarm.with_robot(found.robot)).value
    best = place(swarm, *asked[:2], no_go=problem.no_go)
    assert found.lower <= truth <= found.upper
    assert found.lower <= best.upper_bound
    assert best.quality <= found.best_possible
    assert found.regret >= 0.0
    here = Zone(Stretch(*[swarm.outline.at_point(found.robot.contact).arc_length] * 2), "free")
    assert place(swarm, problem.newcomer, [here]).quality >= truth * (1.0 - 1e-6)


def test_few_robots_are_placed_as_if_all_were_known():
    """The fourth robot of the theory's square; each has a bin of its own."""
    three = Swarm(SQUARE, [Robot(*row) for row in PULLS[:3]], 1.0)
    newcomer = Newcomer(1.0, "pull", 0.0, name="four")
    found = Summary.of(three).place(SQUARE, newcomer)
    assert (found.robot.name, found.place, found.is_force_closure) == ("four", "s", True)
    assert found.robot.contact == pytest.approx((0.4, -1.0), abs=1e-3)
    truth = 0.8 / math.sqrt(1.32)
    for bound in (found.lower, found.upper, found.best_possible):
        assert bound == pytest.approx(truth, rel=2e-4)


@pytest.mark.parametrize("n", range(4))
def test_too_few_robots(n):
    """Nothing is promised, unless the newcomer is the fourth."""
    swarm = Swarm(SQUARE, [Robot(*row) for row in PULLS[:n]], 1.0)
    found = Summary.of(swarm).place(SQUARE, Newcomer())
    assert found.is_force_closure is (n == 3)
    assert (found.upper > 1e-9) is (n == 3)


@pytest.mark.parametrize("limit", [1.0, 3e3, 3e5])
def test_a_crowd_of_a_hundred_thousand(limit):
    """The robot found and the best possible one are within a hundredth of each other."""
    rng = np.random.default_rng(4)
    outline, n = rectangle(rng), 100_000
    contacts = outline.vertices[0] + rng.uniform(size=(n, 1)) * (
        outline.vertices[1] - outline.vertices[0]
    )
    contacts *= rng.choice([-1.0, 1.0], (n, 1))
    crowd = Swarm.from_arrays(outline, contacts, rng.uniform(-math.pi, math.pi, n))
    found = Summary.of(crowd).place(outline, Newcomer(limit, "push"))
    assert 0.0 < found.lower <= found.upper
    assert found.regret <= 0.01 * found.lower


def test_limits_over_many_orders():
    """Robots of 1e-12 to 1e12 N and a newcomer in between."""
    rng = np.random.default_rng(9)
    spots = [SQUARE.at_arc_length(s) for s in rng.uniform(0.0, 8.0, 200)]
    limits = 10.0 ** rng.uniform(-12.0, 12.0, 200)
    crew = [
        Robot(c.point, a, u) for c, a, u in zip(spots, rng.uniform(-3, 3, 200), limits, strict=True)
    ]
    swarm = Swarm(SQUARE, crew)
    found = Summary.of(swarm).place(SQUARE, Newcomer(1e6))
    assert found.lower <= quality(swarm.with_robot(found.robot)).value <= found.upper


def test_questions_that_have_no_answer():
    """Another origin, a zone beyond the boundary, no point left."""
    summary = summary_of("round", 1, 30)
    with pytest.raises(SummaryInvalid, match=r"the outline's origin is \(1.0, 1.0\)"):
        summary.place(Outline(SQUARE.vertices, origin=(1, 1)), Newcomer())
    with pytest.raises(OutlineInvalid, match="None is no Outline"):
        summary.place(None, Newcomer())
    with pytest.raises(ZoneInvalid, match="both ends should lie in"):
        summary.place(SQUARE, Newcomer(), [Zone(Stretch(7.0, 9.0))])
    with pytest.raises(NowhereToAttach):
        summary.place(SQUARE, Newcomer(), no_go=[Stretch(0.0, 8.0)])
