"""Push forces of robots that steer, reverse, have friction or a least force (T27)."""

import math
from dataclasses import replace

import numpy as np
import pytest

import reference
from crews import KINDS, corners_of, crew_of, robot_of, wrench_for
from strategies import FAMILIES, swarm_of
from swarmgrasp import Outline, Robot, Swarm, forces, forces_along, quality
from swarmgrasp.kernels import shares as kernel
from swarmgrasp.verify.forces import faults_of
from swarmgrasp.verify.pushes import Robots

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
HULL = Outline([(-22, -8), (22, -8), (22, 8), (-22, 8)])
AZIMUTH = {"steers": math.pi, "mounted": True}


def unit(*robots):
    """Return robots on the square, in the unit metric."""
    return Swarm(SQUARE, robots, characteristic_length=1.0)


PAIR = unit(Robot((0.7, 0), 0.0, **AZIMUTH), Robot((-0.7, 0), 0.0, **AZIMUTH))


# -- numbers known otherwise ----------------------------------------------------------


@pytest.mark.parametrize(
    ("wrench", "needed"),
    [((1, 0, 0), 0.5), ((0, 0, 1), 1 / 1.4), ((0.3, 0.4, 0.2), 12 / 35), ((0, 3, 0), 1.5)],
)
def test_two_azimuths(wrench, needed):
    """What their largest share is, by hand; beyond it what is missing."""
    found = forces(PAIR, wrench)
    assert found.needed == pytest.approx(needed, rel=1e-10)
    assert found.largest_share == pytest.approx(min(needed, 1.0), rel=2e-6)
    assert found.is_degraded is (needed > 1.0)
    np.testing.assert_allclose(
        found.missing, np.maximum(needed - 1.0, 0.0) * np.array((0, 2, 0)), atol=1e-9
    )
    assert found.is_least_squares
    assert found.verify()


def test_two_stern_azimuths_turn_a_ship():
    """A thrust allocator's own test says 1800 and 250 N; 25 kN ahead are 5 kN too much for them."""
    places = [(-20.0, 5.0), (-20.0, -5.0)]
    ship = Swarm(HULL, [Robot(at, 0.0, 10e3, **AZIMUTH) for at in places], 1.0)
    turning = forces(ship, (0.0, 500.0, 8000.0))
    np.testing.assert_allclose(turning.vectors, [(-1800.0, 250.0), (1800.0, 250.0)], rtol=1e-9)
    np.testing.assert_allclose(turning.forces, math.hypot(1800.0, 250.0), rtol=1e-9)
    np.testing.assert_allclose(turning.directions, np.arctan2(250.0, [-1800.0, 1800.0]), rtol=1e-9)
    assert forces(ship, (25e3, 0.0, 0.0)).shortfall == pytest.approx(5000.0, rel=1e-9)
    slanted = forces(ship, np.array((1.0, 1.0, -20.0)) * math.sqrt(2.0) * 10e3)
    assert slanted.needed == pytest.approx(1.0, rel=1e-9)


def test_an_azimuth_and_a_tunnel():
    """The same allocator: 50 N astern and 450 N at the bow, which pushes either way."""
    tunnel = Robot((20, 0), math.pi / 2, 1000.0, reverse_limit=1000.0, mounted=True)
    ship = Swarm(HULL, [Robot((-20, 0), 0.0, 10e3, **AZIMUTH), tunnel], 1.0)
    found = forces_along(ship, [(0.0, 500.0, 8000.0), (0.0, -500.0, -8000.0)])
    np.testing.assert_allclose(found.forces, [[50.0, 450.0]] * 2, rtol=1e-9)
    np.testing.assert_allclose(found.vectors[1, 1], [0.0, -450.0], atol=1e-9)
    np.testing.assert_allclose(found.directions[:, 1], [math.pi / 2, -math.pi / 2], rtol=1e-12)
    assert found.verify()


def test_a_finger_slips():
    """Within its friction it makes a force, beyond it the nearest that does not slip."""
    finger = unit(Robot((0, 0), 0.0, 2.0, friction=0.5, mounted=True))
    held = forces(finger, (1.0, 0.5, 0.0))
    assert (held.needed, held.shortfall) == (pytest.approx(0.5, rel=1e-9), 0.0)
    slipping = forces(finger, (1.0, 1.0, 0.0))
    assert slipping.needed == math.inf
    np.testing.assert_allclose(slipping.vectors, [(1.2, 0.6)], rtol=1e-9)
    assert slipping.verify()


def test_cables_stay_taut():
    """A share is 0 at the least force; what is within the sets is made, and no more.

    8 N beyond the least ones is all that either can do.
    """
    ends = [((1, 0), 0.0), ((-1, 0), math.pi)]
    cables = unit(*(Robot(at, way, 10.0, least=2.0) for at, way in ends))
    for pull, needed in ((0.0, 0.0), (4.0, 0.5), (8.0, 1.0), (9.0, 9 / 8)):
        found = forces(cables, (pull, 0.0, 0.0))
        assert found.needed == pytest.approx(needed, rel=1e-9)
        np.testing.assert_allclose(
            found.vectors, [(min(2 + pull, 10.0), 0), (-2, 0)], rtol=1e-5, atol=1e-12
        )
        assert found.shortfall == pytest.approx(max(pull - 8.0, 0.0), abs=1e-9)
        assert found.verify()
    alone = forces(cables.without("R2"), (0.0, 0.0, 0.0))
    assert (alone.needed, alone.shortfall) == (math.inf, pytest.approx(2.0))
    assert alone.verify()


def test_ties_are_broken_by_the_sum_of_squares():
    """The pair that turns is at its largest share; three in line share the rest by their limits."""
    pair = [Robot((0, y), 0.0, **AZIMUTH) for y in (-1, 1)]
    line = [Robot((-1, 0), 0.0, limit, reverse_limit=limit) for limit in (1.0, 1.0, 2.0)]
    found = forces(unit(*pair, *line), (1.2, 0.0, 1.8))
    assert found.needed == pytest.approx(0.9, rel=1e-10)
    np.testing.assert_allclose(found.shares, [0.9, 0.9, 0.2, 0.2, 0.4], rtol=1e-2)


# -- against slow truths --------------------------------------------------------------


@pytest.mark.parametrize("seed", range(25))
def test_the_largest_share_is_that_of_a_linear_program(seed):
    """Of robots whose arcs are fans of rays 0.01 rad apart, but for what these are weaker."""
    rng = np.random.default_rng([seed, 1])
    kinds = [
        kind
        for kind in KINDS
        if "taut" not in kind and kind not in ("cable", "steady", "envelope", "holding finger")
    ]
    robots = [
        robot_of(kinds[rng.integers(len(kinds))], rng, (rng.uniform(-1, 1), rng.uniform(-1, 1)),
                 rng.uniform(-3, 3), rng.uniform(0.5, 2.0))
        for _ in range(5)
    ]  # fmt: skip
    swarm = unit(*robots)
    wrench = rng.normal(size=3)
    found = forces(swarm, wrench)
    arms = swarm.contacts - swarm.outline.origin
    slow = reference.least_largest_part(arms, corners_of(swarm), wrench)
    if math.isinf(found.needed):
        assert math.isinf(slow)
    else:
        assert slow * math.cos(0.005) * (1.0 - 1e-7) <= found.needed <= slow * (1.0 + 1e-7)


@pytest.mark.parametrize("family", FAMILIES)
def test_rays_are_sets_too(family):
    """The kernel of sets finds what that of rays does."""
    swarm = swarm_of(family, 3, 12)
    x, y, z = swarm.scale.tolist()
    arms = np.ascontiguousarray(swarm.contacts - swarm.outline.origin)
    sets, counts = swarm.force_sets
    for wrench in np.random.default_rng(8).normal(size=(10, 3)) * swarm.limits.sum() / 5:
        found = forces(swarm, wrench)
        scaled = (wrench * swarm.scale)[None]
        row = np.frombuffer(
            kernel.push_forces(arms, sets, counts.astype(float), (x, y, z), scaled, (0.0, 0.0, 0.0))
        )
        assert row[36] == pytest.approx(found.needed, rel=1e-9)
        assert row[37] == pytest.approx(found.shortfall, rel=1e-6, abs=1e-9 * swarm.limits.sum())
        sums = [float(shares @ shares) for shares in (row[24:36], found.shares)]
        assert sums[0] <= sums[1] * (1.0 + 2e-5)
        assert row[24:36].max() <= found.largest_share * (1.0 + 2e-6)


@pytest.mark.parametrize("seed", range(20))
def test_the_quality_is_where_shares_reach_one(seed):
    """At the weakest wrench the largest share is 1; inside the ball every wrench is made."""
    rng = np.random.default_rng([seed, 4])
    kinds = ["ray", "segment", "sector", "half", "wide", "azimuth", "both", "finger"]
    robots = [
        robot_of(kinds[rng.integers(len(kinds))], rng, (rng.uniform(-1, 1), rng.uniform(-1, 1)),
                 rng.uniform(-3, 3), rng.uniform(0.5, 2.0))
        for _ in range(8)
    ]  # fmt: skip
    swarm = unit(*robots)
    weakest = quality(swarm)
    assert weakest.value > 0.0
    assert forces(swarm, weakest.weakest_wrench).needed == pytest.approx(1.0, rel=1e-8)
    ways = rng.normal(size=(40, 3))
    ball = weakest.value * ways / np.linalg.norm(ways, axis=1, keepdims=True)
    assert not forces_along(swarm, ball * (1.0 - 1e-8)).is_degraded.any()


@pytest.mark.parametrize("kind", KINDS)
def test_the_check_knows_every_kind(kind):
    """Its support functions are those of the forces that each robot can exert."""
    rng = np.random.default_rng(6)
    swarm = unit(*(robot_of(kind, rng, (0.2, 0.3), rng.uniform(-3, 3), 1.5) for _ in range(20)))
    robots = robots_said(swarm)
    ways = rng.normal(size=(50, 1, 2))
    known = robots.supports(np.broadcast_to(ways, (50, 20, 2)))
    for i, corners in enumerate(corners_of(swarm, 1e-3)):
        beyond = corners - robots.rests[i]
        np.testing.assert_allclose(known[:, i], (ways[:, 0] @ beyond.T).max(axis=1), atol=1e-6)
        assert robots.reaches[i] == pytest.approx(np.hypot(*beyond.T).max(), rel=1e-6, abs=1e-9)


def robots_said(swarm):
    """Return what the check is told of a swarm's robots."""
    return Robots(
        swarm.contacts - swarm.outline.origin, swarm.directions, swarm.limits,
        swarm.reverse_limits, swarm.steers, swarm.frictions, swarm.leasts, swarm.rare.envelopes,
        swarm.rare.gaps,
    )  # fmt: skip


# -- proofs ---------------------------------------------------------------------------


def sweep(seeds):
    """Ask four wrenches of a swarm per seed; return what is wrong with the answers."""
    for seed in seeds:
        rng = np.random.default_rng([seed, 11])
        swarm = crew_of(rng)
        wrenches = [wrench_for(rng, swarm) for _ in range(4)]
        load = wrench_for(rng, swarm) * (0.3 if rng.random() < 0.3 else 0.0)
        for fault in forces_along(swarm, wrenches, load=load).verify().faults:
            yield f"seed {seed}, {fault}"


def test_the_first_of_the_sweep():
    """Of all kinds together, of giants, at one point, on a line, in rings."""
    faults = list(sweep(range(60)))
    assert not faults, "\n".join(faults)


@pytest.mark.long
def test_ten_thousand():
    """None is refused by its check."""
    faults = list(sweep(range(60, 2560)))
    assert not faults, "\n".join(faults)


def test_a_false_claim_is_refused():
    """Other forces for the same wrench, a larger share, too little, outside of a set: each."""
    tug = Robot((-1, 0), 0.0, 2.0, steers=0.5)
    swarm = unit(tug, replace(tug, contact=(-1, 0.5)), Robot((1, 0), math.pi, 2.0, steers=0.5))
    found = forces(swarm, (1.0, 0.2, 0.0))
    assert found.verify()

    def fault(**changes):
        return "; ".join(replace(found, **changes).verify().faults)

    moved = found.vectors + np.array([(0.05, 0), (0.0, 0), (0.05, 0)])
    robots = robots_said(swarm)
    assert "sum of squares" in fault(vectors=moved, shares=robots.shares(moved)[0])
    assert "the share needed is 0.1" in fault(needed=0.1)
    assert "the shortfall is 0 N; recomputed" in fault(vectors=0.5 * found.vectors)
    assert "not what its force is of its set" in fault(shares=0.9 * found.shares)
    sideways = np.array([(0.5, 0.6), (0.5, -0.4), (0.0, 0.0)])
    assert "the share of robot 0" in fault(vectors=sideways, shares=np.array([0.4, 0.3, 0.0]))
    assert "no normal" in fault(certificate=replace(found.certificate, normals=np.zeros((0, 3))))
    claim = found._claim()
    (forged,) = faults_of(replace(claim, wrench=claim.wrench + np.array([0.0, 1e-3, 0.0])))
    assert "the wrench is 0.001 N away from what the forces make" in forged
    far = forces(swarm, (9.0, 0.0, 0.0))
    short = replace(far, vectors=0.9 * far.vectors, shares=0.9 * far.shares, shortfall=9 - 3.6)
    assert "farther along the normal can be made" in "; ".join(short.verify().faults)


# -- degenerate swarms ----------------------------------------------------------------


def test_azimuths_at_one_point_turn_nothing():
    """What is across all that they do is missing; the rest is made as if it were all."""
    swarm = unit(*(Robot((0, 0), 0.0, limit, **AZIMUTH) for limit in (1.0, 3.0)))
    made = forces(swarm, (2.0, 0.0, 0.0))
    assert made.needed == pytest.approx(0.5, rel=1e-10)
    np.testing.assert_allclose(made.shares, 0.5, rtol=1e-5)
    turned = forces(swarm, (2.0, 0.0, 1.0))
    assert turned.needed == math.inf
    assert turned.shortfall == pytest.approx(1.0, rel=1e-9)
    np.testing.assert_allclose(turned.shares, 0.5, rtol=1e-5)
    assert made.verify()
    assert turned.verify()


def test_what_cancels_is_not_exerted():
    """The nearest wrench is none, which two could make against each other."""
    sides = [Robot((0, -1), math.pi / 2), Robot((0, 1), math.pi / 2, reverse_limit=1.0)]
    found = forces(unit(*sides), (0.0, 0.0, 17.0))
    assert not found.vectors.any()
    assert found.verify()


def test_one_or_none_of_nothing():
    """No wrench takes no force; a steady force is all that a robot without a choice exerts."""
    still = forces(PAIR, (0.0, 0.0, 0.0))
    assert not still.vectors.any()
    assert still.verify()
    np.testing.assert_allclose(still.directions, 0.0)
    steady = unit(Robot((-1, 0), 0.0, 2.0, least=2.0))
    assert forces(steady, (2.0, 0.0, 0.0)).needed == 0.0
    far = forces(steady, (3.0, 0.0, 0.0))
    assert (far.needed, far.shortfall) == (math.inf, pytest.approx(1.0))
    assert far.verify()


@pytest.mark.parametrize("size", [1e-90, 1e-9, 1e9, 1e90])
def test_units_do_not_matter(size):
    """Limits and wrenches as small or as large as they may be."""
    strong = unit(*(replace(robot, limit=size) for robot in PAIR))
    for wrench in ((0.3, 0.4, 0.2), (3.0, 0.0, 0.0)):
        before, after = forces(PAIR, wrench), forces(strong, np.array(wrench) * size)
        np.testing.assert_allclose(after.shares, before.shares, atol=1e-9)
        assert after.shortfall == pytest.approx(size * before.shortfall, rel=1e-9)
        assert after.verify()


def test_a_trajectory_is_smooth():
    """Forces of azimuths turn as the wrench does, across the boundary of what they can make."""
    t = np.linspace(0.0, 1.0, 1001)[:, None]
    found = forces_along(PAIR, (1 - t) * (0.3, 0.4, 0.2) + t * (2.5, -1.0, 0.5))
    assert 0 < found.is_degraded.sum() < len(found)
    assert np.abs(np.diff(found.vectors, axis=0)).max() < 0.1
    np.testing.assert_array_equal(found[500].vectors, found.vectors[500])
    np.testing.assert_allclose(found.missing[~found.is_degraded], 0.0, atol=1e-9)


def test_rays_are_told_the_same_way():
    """Forces along their directions, of the sizes that shares of the limits are."""
    swarm = swarm_of("free", 5, 9)
    found = forces(swarm, swarm.generators[:4].sum(axis=0) / 3)
    ways = np.column_stack([np.cos(swarm.directions), np.sin(swarm.directions)])
    np.testing.assert_allclose(found.vectors, found.forces[:, None] * ways, atol=1e-12)
    np.testing.assert_allclose(found.forces, found.shares * swarm.limits, rtol=1e-12)
    assert found.is_least_squares
    forged = replace(found, vectors=found.vectors[:, ::-1])
    assert "not its share of its limit" in "; ".join(forged.verify().faults)


@pytest.mark.parametrize(
    ("counts", "said"),
    [
        ([1.0], "a count for each arm"),
        ([0.0, 3.0], "add up"),
        ([1.5, 1.5], "add up"),
        ([1.0, 1.0], "add up"),
    ],
)
def test_the_kernel_refuses_elements_of_nobody(counts, said):
    """Each robot has one at least, and all are some robot's."""
    elements, unit_scale, none = (
        np.tile([1.0, 0.0, 0.0, 0.0, math.tau], (3, 1)),
        (1.0,) * 3,
        (0.0,) * 3,
    )
    with pytest.raises(ValueError, match=said):
        kernel.push_forces(
            np.zeros((2, 2)), elements, np.array(counts), unit_scale, np.eye(3), none
        )
