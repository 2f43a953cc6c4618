"""Push forces: against linear and quadratic programs, by their proofs, and what must hold."""

import math
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import reference
from strategies import FAMILIES, seeds, swarm_of
from swarmgrasp import Outline, Robot, Swarm, forces, forces_along, quality
from swarmgrasp.errors import ForcesNotProven, SwarmInvalid, WrenchInvalid
from swarmgrasp.forces.start import start_for
from swarmgrasp.kernels import shares as kernel
from swarmgrasp.scenario import load_example
from swarmgrasp.verify.forces import faults_of

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
AHEAD = Robot((-1, 0), 0.0)
FOUR = [AHEAD, Robot((1, 0), math.pi), Robot((0, -1), math.pi / 2), Robot((0, 1), -math.pi / 2)]
"""Forces through the middle: no torque."""
UNEVEN = {"giant", "spread limits", "weighted", "nearly parallel"}
"""Families whose numbers are too far apart, or too alike, for a general solver."""
EVEN = [family for family in FAMILIES if family not in UNEVEN]
KINDS = ["inside", "corner", "few", "axis", "far", "own", "facet", "beyond", "all", "opposite"]


def wrench_of(kind, swarm, seed):
    """Return a wrench (3,), scaled, that is easy or hard to make."""
    rng = np.random.default_rng([seed, 2])
    B = swarm.scaled_generators
    n, size = len(B), np.linalg.norm(B, axis=1).sum()
    a, b = B[rng.integers(n, size=2)]
    normal = np.cross(a, b)
    normal /= np.linalg.norm(normal) or 1.0
    front = B @ normal > 1e-12 * np.linalg.norm(B, axis=1)
    facet = front @ B + rng.random() * a + rng.random() * b
    return {
        "inside": 0.7 * rng.random(n) @ B,
        "corner": (rng.random(n) > 0.5) @ B,
        "few": (rng.random(n) * (rng.random(n) < 0.2)) @ B,
        "axis": np.eye(3)[rng.integers(3)] * size * rng.choice([-0.1, 0.1, 1.0]),
        "far": rng.normal(size=3) * size,
        "own": a,
        "facet": facet,
        "beyond": facet + rng.random() * size * normal,
        "all": B.sum(axis=0),
        "opposite": -B.sum(axis=0),
    }[kind]


def asked(families, most):
    """Draw a swarm of these families and a wrench, which is scaled."""

    def make(family, seed, n, kind):
        swarm = swarm_of(family, seed, n)
        return swarm, wrench_of(kind, swarm, seed)

    kinds = st.sampled_from(KINDS)
    return st.builds(make, st.sampled_from(families), seeds, st.integers(1, most), kinds)


def solve(swarm, wrench):
    """Make a wrench given in the metric's coordinates."""
    return forces(swarm, wrench / swarm.scale)


# -- against the slow truth -----------------------------------------------------------


@given(asked(EVEN, 30))
@settings(max_examples=300)
def test_the_largest_share_is_that_of_a_linear_program(case):
    """Also above 1, and infinite where no force of the robots helps."""
    swarm, wrench = case
    if np.linalg.norm(wrench) > 1e-9:
        truth = reference.least_largest_share(swarm.scaled_generators, wrench)
        assert solve(swarm, wrench).needed == pytest.approx(truth, rel=1e-9)


@given(asked(EVEN, 30))
@settings(max_examples=150)
def test_the_shares_are_those_of_a_quadratic_program(case):
    """Under the largest share, or for the nearest wrench under 1, the least sum of squares."""
    swarm, wrench = case
    found = solve(swarm, wrench)
    made = (found.wrench - found.load) * swarm.scale
    top = max(found.largest_share, 1e-12)
    truth = reference.least_squares_shares(swarm.scaled_generators, made, top)
    np.testing.assert_allclose(found.shares, truth, atol=1e-9)


@given(asked(EVEN, 30))
@settings(max_examples=200)
def test_the_wrench_is_made_or_the_nearest_is(case):
    """The distance of the nearest is the shortfall; none if the wrench is made."""
    swarm, wrench = case
    found = solve(swarm, wrench)
    size = np.linalg.norm(swarm.scaled_generators, axis=1).sum() + np.linalg.norm(wrench)
    nearest = reference.nearest_wrench(swarm.scaled_generators, wrench)
    np.testing.assert_allclose(found.wrench * swarm.scale, nearest, atol=1e-12 * size)
    assert found.shortfall == pytest.approx(np.linalg.norm(wrench - nearest), abs=1e-11 * size)
    if np.linalg.norm(wrench) > 1e-9 * size:
        assert found.is_degraded is (found.needed > 1.0 + 1e-9)


@pytest.mark.parametrize("family", EVEN)
def test_many_robots(family):
    """200 of them, against the linear program."""
    swarm = swarm_of(family, 5, 200)
    for kind in ("inside", "facet"):
        wrench = wrench_of(kind, swarm, 5)
        truth = reference.least_largest_share(swarm.scaled_generators, wrench)
        assert solve(swarm, wrench).needed == pytest.approx(truth, rel=1e-9)


TWINS = [
    (
        [((0, -10), 1, 250), ((40, -10), 1, 200), ((-40, 10), -1, 200), ((-40, 10), -1, 300)],
        (0.0, 0.0, 1000.0),
    ),
    (
        [((20, -10), 1, 200), ((0, 10), -1, 250), ((-40, 10), -1, 100), ((0, -10), 1, 60),
         ((40, -10), 1, 200), ((20, 10), -1, 200), ((0, 10), -1, 200), ((20, 10), -1, 100)],
        (0.0, -200.0, -5000.0),
    ),
]  # fmt: skip


@pytest.mark.parametrize(("robots", "wrench"), TWINS)
def test_two_at_one_place_need_not_be_alike(robots, wrench):
    """The weaker one is at its limit where the stronger one is not yet."""
    barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    swarm = Swarm(barge, [Robot(c, way * math.pi / 2, limit) for c, way, limit in robots])
    found = forces(swarm, wrench)
    truth = reference.least_largest_share(swarm.scaled_generators, wrench * swarm.scale)
    assert found.needed == pytest.approx(truth, rel=1e-9)
    assert not found.is_degraded
    assert found.verify()


def test_a_share_of_next_to_nothing_may_be_any():
    """Robots of 10^-12 of the strongest one cannot be told by their wrench."""
    barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    robots = [
        ((40, 0), 2, 6e4), ((40, 10), -1, 0.3), ((-40, 10), 0, 2e5), ((40, 10), -1, 3e8),
        ((40, 10), 2, 3e-3), ((0, -10), 1, 2e-3), ((-20, -10), 1, 6e-5), ((-40, 10), 0, 3e4),
        ((0, 10), -1, 20.0),
    ]  # fmt: skip
    robots = [Robot(contact, quarters * math.pi / 2, limit) for contact, quarters, limit in robots]
    weights = (2.194853091444896, 2.5816170997950567)
    wrench = (-44020.54123224933, -220102695.15617925, -8804107806.225159)
    assert forces(Swarm(barge, robots, force_weights=weights), wrench).verify()


def misled(monkeypatch, forever=False):
    """Let the kernel be wrong the first time it is asked, or each time."""
    honest = kernel.least_shares

    def once(*asked):
        rows = np.frombuffer(honest(*asked)).reshape(-1, len(asked[0]) + 15).copy()
        if len(asked) == 3 or forever:
            rows[:, : len(asked[0])] = 0.0
            rows[:, -1] = 0.0
        return rows.tobytes()

    monkeypatch.setattr(kernel, "least_shares", once)


@pytest.mark.parametrize("kind", KINDS)
def test_a_kernel_that_is_misled_starts_again_from_a_linear_program(monkeypatch, kind):
    """The second time it is told the normal; the answer is as good."""
    swarm = swarm_of("free", 7, 9)
    wrench = wrench_of(kind, swarm, 7)
    honest = solve(swarm, wrench)
    misled(monkeypatch)
    again = solve(swarm, wrench)
    np.testing.assert_allclose(again.shares, honest.shares, atol=1e-9)
    assert again.verify()


def test_what_cannot_be_proven_is_not_handed_out(monkeypatch):
    """An error says which wrench, and what to do."""
    swarm = swarm_of("free", 7, 9)
    misled(monkeypatch, forever=True)
    with pytest.raises(ForcesNotProven, match="leave out the far weaker ones"):
        forces_along(swarm, [(0.1, 0.0, 0.0)])


@pytest.mark.parametrize("kind", KINDS)
def test_a_linear_program_finds_where_to_start(kind):
    """Of a wrench within reach the normal proves the largest share that is needed."""
    swarm = swarm_of("free", 3, 8)
    B, wrench = swarm.scaled_generators, wrench_of(kind, swarm, 4)
    normal = np.array(start_for(B, wrench))
    found = solve(swarm, wrench)
    assert np.linalg.norm(normal) == pytest.approx(1.0)
    if 0.0 < found.needed <= 1.0:
        proven = (normal @ wrench) / reference.support(B, normal)[0]
        assert proven == pytest.approx(found.needed, rel=1e-7)
    else:
        assert normal @ wrench > 0.0


# -- proofs ---------------------------------------------------------------------------


@given(asked(FAMILIES, 60))
@settings(max_examples=600)
def test_shares_carry_a_proof(case):
    """Of every swarm, however uneven, by code that shares nothing with the solver."""
    verdict = solve(*case).verify()
    assert verdict, verdict.faults


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("family", FAMILIES)
def test_large_crowds_carry_a_proof(family, kind):
    """300 robots: many in one plane, where not every side is looked at."""
    swarm = swarm_of(family, 11, 300)
    verdict = solve(swarm, wrench_of(kind, swarm, 11)).verify()
    assert verdict, verdict.faults


def test_a_false_claim_is_refused():
    """Other shares for the same wrench, a larger one, too little: each has its fault."""
    swarm = Swarm(SQUARE, [AHEAD, AHEAD, *FOUR[1:]], 1.0)
    found = forces(swarm, (0.5, 0.2, 0.0))
    assert found.verify()

    def fault(**changes):
        return "; ".join(replace(found, **changes).verify().faults)

    up = found.shares
    assert "not show to be least" in fault(shares=up + np.array([0.05, -0.05, 0, 0, 0]))
    more = up + np.array([0, 0, 0, 0.1, 0.1])
    assert "the largest share is 0.3; the normal proves no more" in fault(shares=more)
    assert "the shortfall is 0 N; recomputed it is" in fault(shares=0.5 * up)
    assert "within 0 and 1" in fault(shares=up - 0.3)
    assert "no normal" in fault(certificate=replace(found.certificate, normals=np.zeros((0, 3))))
    claim = found._claim()
    (forged,) = faults_of(replace(claim, wrench=claim.wrench + np.array([0.0, 1e-3, 0.0])))
    assert "the wrench is 0.001 N away from what the forces make" in forged
    far = forces(swarm, (5.0, 0.0, 0.0))
    short = replace(far, shares=0.9 * far.shares, shortfall=5.0 - 0.9 * 2.0)
    assert "farther along the normal can be made" in "; ".join(short.verify().faults)


# -- what the numbers mean ------------------------------------------------------------


@pytest.mark.parametrize("name", ["deck-barge", "supply-vessel", "drillship-thrusters"])
def test_the_quality_is_where_shares_reach_one(name):
    """At the weakest wrench the largest share is 1, beyond it the shortfall is what is beyond."""
    swarm = load_example(name).swarm
    weakest = quality(swarm)
    for share in (1e-9, 0.5, 1.0):
        found = forces(swarm, share * weakest.weakest_wrench)
        assert found.needed == pytest.approx(share, rel=1e-12)
        assert not found.is_degraded
    beyond = forces(swarm, 1.25 * weakest.weakest_wrench)
    assert beyond.is_degraded
    assert beyond.shortfall == pytest.approx(0.25 * weakest.value, rel=1e-9)
    np.testing.assert_allclose(beyond.normal, weakest.direction, atol=1e-9)
    np.testing.assert_allclose(beyond.missing, 0.25 * weakest.weakest_wrench, rtol=1e-9, atol=1e-9)


def test_strong_robots_give_as_large_a_share():
    """Shares are shares of the limits: of two in line the stronger one pushes harder."""
    swarm = Swarm(SQUARE, [AHEAD, Robot((-1, 0), 0.0, limit=3.0)])
    found = forces(swarm, (2.0, 0.0, 0.0))
    np.testing.assert_allclose(found.shares, [0.5, 0.5], rtol=1e-15)
    np.testing.assert_allclose(found.forces, [0.5, 1.5], rtol=1e-15)


def test_ties_are_broken_by_the_sum_of_squares():
    """Turning takes the first two whole; those that only push ahead share what is left.

    1 N of torque from a pair with lever 1 each; 1.2 N ahead from three through the middle, of which
    the strongest gives most: shares in proportion to the limits, where none is at the largest.
    """
    pair = [Robot((1, -1), math.pi / 2), Robot((-1, 1), -math.pi / 2)]
    line = [Robot((-1, 0), 0.0, limit=f) for f in (1.0, 1.0, 2.0)]
    swarm = Swarm(SQUARE, pair + line, 1.0)
    found = forces(swarm, (1.2, 0.0, 1.8))
    np.testing.assert_allclose(found.shares, [0.9, 0.9, 0.2, 0.2, 0.4], rtol=1e-14)


def test_the_environment_does_its_part():
    """The robots make the rest; the object receives what was wanted."""
    swarm = Swarm(SQUARE, FOUR, 1.0)
    found = forces(swarm, (0.5, 0.0, 0.0), load=(0.2, -0.4, 0.0))
    np.testing.assert_allclose(found.shares, [0.3, 0.0, 0.4, 0.0], atol=1e-15)
    np.testing.assert_allclose(found.wrench, [0.5, 0.0, 0.0], atol=1e-15)
    held = forces(swarm, (0.2, -0.4, 0.0), load=(0.2, -0.4, 0.0))
    assert not held.shares.any()
    assert held.verify()
    np.testing.assert_allclose(held.wrench, [0.2, -0.4, 0.0], rtol=1e-15)


# -- degenerate swarms and wrenches ---------------------------------------------------


def test_no_wrench_takes_no_force():
    """Nor a certificate."""
    found = forces(Swarm(SQUARE, FOUR), (0.0, 0.0, 0.0))
    assert (found.needed, found.largest_share, found.is_degraded) == (0.0, 0.0, False)
    assert not found.normal.any()
    assert found.verify()


def test_nobody_makes_nothing():
    """The nearest wrench is none, however far the limits were raised."""
    found = forces(Swarm(SQUARE, []), (3.0, 4.0, 0.0))
    assert (found.needed, found.shortfall, found.largest_share) == (math.inf, 5.0, 0.0)
    assert found.shares.shape == (0,)
    assert found.verify()


def test_a_flat_set_keeps_its_own_wrenches():
    """Without any torque, what lies in the plane is made at half shares, its torque missing.

    The shares of the nearest wrench are the least too: nobody gives all because of what is missing.
    """
    swarm = Swarm(SQUARE, FOUR, 1.0)
    flat = forces(swarm, (0.5, -0.25, 0.0))
    assert (flat.needed, flat.is_degraded) == (pytest.approx(0.5, rel=1e-14), False)
    found = forces(swarm, (0.5, -0.25, 2.0))
    assert found.needed == math.inf
    assert found.shortfall == pytest.approx(2.0, rel=1e-14)
    np.testing.assert_allclose(found.shares, [0.5, 0.0, 0.0, 0.25], atol=1e-14)
    assert found.verify()


def test_a_flat_set_is_seen_from_across_to_the_last_digit():
    """The second wrench starts from the first one's normal, which is good to fewer digits.

    Its nearest is in the plane of x and the torque, where the shares are those found alone.
    """
    box = Outline([(-0.8, -2.5), (0.8, -2.5), (0.8, 2.5), (-0.8, 2.5)])
    contacts = [(0.8, 1.1), (0.8, 0.77), (0.8, -2.4), (-0.8, 1.2)]
    swarm = Swarm.from_arrays(box, contacts, [0.0, 0.0, 0.0, math.pi])
    wanted = [(1.05, 0.0, -2.55), (-4e-7, 3e-6, 4.1e-6)]
    found = forces_along(swarm, wanted)
    assert found.verify()
    np.testing.assert_allclose(found.shares[1], forces(swarm, wanted[1]).shares, rtol=1e-9)
    flat = np.array([1.0, 0.0, 1.0])
    truth = reference.least_largest_share(
        swarm.scaled_generators * flat, found.wanted[1] * swarm.scale * flat
    )
    assert found.largest_shares[1] == pytest.approx(truth, rel=1e-9)


def test_what_a_giant_misses_of_little_is_told():
    """One number says what rounding of 2 MN is, to what is told and to what is confirmed."""
    barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    places = [(20, -10), (-40, -10)]
    giant = Swarm.from_arrays(
        barge, places, [0.5 * math.pi] * 2, [300.0, 2e6], characteristic_length=1.0,
        force_weights=(2.0, 0.5),
    )  # fmt: skip
    for push in np.linspace(1e-7, 2e-6, 20):
        found = forces(giant, (0.0, push, 40.0 * push))
        assert found.needed == math.inf
        assert found.verify()


def test_a_single_robot_gives_its_part():
    """The nearest wrench on a segment: its middle, its end, its beginning."""
    swarm = Swarm(SQUARE, [AHEAD], 1.0)
    wanted = [(0.5, 1.0, 0.0), (3.0, 1.0, 0.0), (-1.0, 1.0, 0.0)]
    found = forces_along(swarm, wanted)
    np.testing.assert_allclose(found.shares[:, 0], [0.5, 1.0, 0.0], atol=1e-15)
    np.testing.assert_allclose(found.shortfalls, [1.0, math.sqrt(5.0), math.sqrt(2.0)])
    assert found.verify()


@pytest.mark.parametrize("size", [1e-90, 1e-9, 1e9, 1e90])
def test_units_do_not_matter(size):
    """Limits and wrenches as small or as large as they may be."""
    swarm = swarm_of("free", 4, 9)
    strong = Swarm(swarm.outline, [replace(r, limit=size * r.limit) for r in swarm.robots])
    for wrench in ((0.5, -0.2, 0.1), (90.0, -20.0, 10.0)):
        before, after = forces(swarm, wrench), forces(strong, np.array(wrench) * size)
        np.testing.assert_allclose(after.shares, before.shares, atol=1e-9)
        assert after.shortfall == pytest.approx(size * before.shortfall, rel=1e-9)


def test_a_far_wrench_is_met_as_far_as_it_goes():
    """1e100 N from robots of 1e-100 N: everybody who can push that way does."""
    swarm = Swarm(SQUARE, [replace(robot, limit=1e-100) for robot in FOUR])
    found = forces(swarm, (1e100, 0.0, 0.0))
    np.testing.assert_array_equal(found.shares, [1.0, 0.0, 0.0, 0.0])
    assert found.shortfall == 1e100


# -- many wrenches --------------------------------------------------------------------


def test_a_trajectory_is_its_wrenches_one_by_one():
    """The same shares in one call, and continuous ones along a line through the boundary of W."""
    swarm = load_example("supply-vessel").swarm
    ends = np.array([[-9e5, 4e5, -2e7], [1.4e6, 8e5, 3e7]])
    shares = np.linspace(0.0, 1.0, 2001)[:, None]
    wanted = (1.0 - shares) * ends[0] + shares * ends[1]
    found = forces_along(swarm, wanted, load=(1e4, 0.0, 0.0))
    assert 0 < np.count_nonzero(found.is_degraded) < len(found)
    assert np.abs(np.diff(found.shares, axis=0)).max() < 0.02
    for i in range(0, 2001, 400):
        one = forces(swarm, wanted[i], load=(1e4, 0.0, 0.0))
        np.testing.assert_allclose(found.shares[i], one.shares, atol=1e-12)
        np.testing.assert_allclose(found.wrenches[i], one.wrench, atol=1e-6)
        assert found.shortfalls[i] == pytest.approx(one.shortfall, abs=1e-6)
    assert all(found[i].verify() for i in range(0, 2001, 80))
    np.testing.assert_allclose(found.missing[found.shortfalls == 0.0], 0.0, atol=1e-5)
    np.testing.assert_array_equal(found.largest_shares, [one.largest_share for one in found])


def test_no_wrenches_are_none():
    """An empty trajectory has no shares."""
    found = forces_along(Swarm(SQUARE, FOUR), [])
    assert (len(found), found.shares.shape, found.forces.shape) == (0, (0, 4), (0, 4))


def test_results_are_read_only():
    """What an answer holds cannot be changed by a slip."""
    found = forces(Swarm(SQUARE, FOUR), (0.5, 0.0, 0.0))
    for array in (found.shares, found.forces, found.wrench, found.wanted, found.normal):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 1.0


# -- size -------------------------------------------------------------------


def test_a_hundred_thousand_robots():
    """A crowd in a fraction of a second, proof and all."""
    rng = np.random.default_rng(3)
    n = 100_000
    x, side = rng.uniform(-1.0, 1.0, n), rng.choice([-1.0, 1.0], n)
    crowd = Swarm.from_arrays(SQUARE, np.column_stack([x, side]), rng.uniform(-3.1, 3.1, n))
    for wrench in ((9000.0, 100.0, -2000.0), (-90_000.0, 0.0, 0.0)):
        found = forces(crowd, wrench)
        assert found.verify()
    assert found.is_degraded


# -- bad input ------------------------------------------------------------------------


def test_all_faults_are_told_at_once():
    """The swarm's, the wrench's and the load's."""
    with pytest.raises(SwarmInvalid) as error:
        forces(None, "abc", load=(1, 2))
    assert error.value.faults == (
        "None is no Swarm: make one with Swarm(outline, robots)",
        "the wrench is 'abc'; it should be three finite numbers [N, N, N m]",
        "the load is (1, 2); it should be three finite numbers [N, N, N m]",
    )


@pytest.mark.parametrize(
    ("wrench", "said"),
    [
        ((1, 2, math.nan), "three finite numbers"),
        ([[1, 2, 3]], "three finite numbers"),
        ([1, [2], 3], "three finite numbers"),
        (("1", "2", "3"), "three finite numbers"),
        ((1e101, 0, 0), r"should be 0 or 1e-100 <= size <= 1e\+100 \[N, N, N m\]"),
        ((1e-101, 0, 0), "should be 0 or 1e-100"),
    ],
)
def test_a_wrench_is_three_numbers(wrench, said):
    """Of sizes that can be computed with."""
    with pytest.raises(WrenchInvalid, match=said):
        forces(Swarm(SQUARE, FOUR), wrench)


@pytest.mark.parametrize(
    ("wrenches", "said"),
    [
        ([(1, 2)], r"the wrenches have shape \(1, 2\); it should be \(m, 3\)"),
        ((1, 2, 3), r"the wrenches have shape \(3,\)"),
        ([(1, 2, 3), (4,)], r"should be numbers \(m, 3\)"),
        ([("a", "b", "c")], r"should be numbers \(m, 3\)"),
        ([(1, 2, 3), (0, math.inf, 0)], r"wrench 1 is \[0.0, inf, 0.0\]; it should be finite"),
        ([(1e200, 0, 0)] * 12, r"wrench 9 is [^\n]*\n... and 2 more"),
    ],
)
def test_wrenches_are_rows_of_three(wrenches, said):
    """The first ten at fault are shown."""
    with pytest.raises(WrenchInvalid, match=said):
        forces_along(Swarm(SQUARE, FOUR), wrenches)
