"""The exact quality: known numbers, the slow truth, and what every quality must obey."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import reference
from cases import QUALITIES, rounded_tank, swarm_of_case
from strategies import FAMILIES, large_swarms, seeds, swarm_of, swarms
from swarmgrasp import ForceClosure, Outline, Polytope, Robot, Swarm, WrenchSet, quality
from swarmgrasp.errors import SwarmInvalid
from swarmgrasp.quality.weakest import weakest_of
from swarmgrasp.scenario import load_example

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
PULLS = [
    ((1, -0.4), 0.0),
    ((-1, 0.4), math.pi),
    ((-0.4, 1), math.pi / 2),
    ((0.4, -1), -math.pi / 2),
]
MIRRORED = [((x, -y) if abs(x) == 1 else (-x, y), a) for (x, y), a in PULLS]


def size(swarm):
    """Return sum |b_i| [N], the scale of every rounding error."""
    return float(np.linalg.norm(swarm.scaled_generators, axis=1).sum())


def close(value, truth, *crews):
    """Tell whether two qualities are equal up to rounding, or to what counts as zero."""
    return abs(value - truth) <= 1e-9 * truth + 2e-12 * max(map(size, crews))


def remade(swarm, turn=0.0, sign=1.0, stretched=1.0, stronger=1.0):
    """Turn, reflect (sign -1), enlarge and strengthen a swarm; the metric's L grows with it."""
    c, s = math.cos(turn), math.sin(turn)
    move = stretched * np.array([[c, -s], [s, c]]) @ np.diag([1.0, sign])
    robots = [
        Robot(tuple(move @ r.contact), turn + sign * r.direction, stronger * r.limit)
        for r in swarm.robots
    ]
    outline = Outline(swarm.outline.vertices @ move.T, move @ swarm.outline.origin)
    length = stretched * swarm.characteristic_length
    return Swarm(outline, robots, length, swarm.force_weights)


def with_robots(swarm, robots):
    """Return the same object and metric with other robots."""
    return Swarm(swarm.outline, robots, swarm.characteristic_length, swarm.force_weights)


# -- known numbers --------------------------------------------------------------------


@pytest.mark.parametrize("name", QUALITIES)
def test_reference_cases(name):
    """Random and degenerate swarms, computed by another program."""
    swarm, truth = swarm_of_case(QUALITIES[name]), QUALITIES[name]["quality"]
    value = quality(swarm).value
    assert value == pytest.approx(truth, rel=1e-9, abs=1e-12 * size(swarm))


def test_a_square_of_robots_in_closed_form():
    """4 robots give 2 t / sqrt(1 + 2 t^2), the mirrored 4 with them twice that."""
    four, eight = ([Robot(*row) for row in rows] for rows in (PULLS, PULLS + MIRRORED))
    exact = 0.8 / math.sqrt(1.32)
    assert quality(Swarm(SQUARE, four, 1.0)).value == pytest.approx(exact, rel=1e-14)
    assert quality(Swarm(SQUARE, eight, 1.0)).value == pytest.approx(2.0 * exact, rel=1e-14)
    for lost in range(4):
        three = Swarm(SQUARE, four[:lost] + four[lost + 1 :], 1.0)
        assert quality(three).value == 0.0


@pytest.mark.parametrize(
    ("name", "exact"), [("drillship-thrusters", 0.8998300), ("supply-vessel", 748_420.2756)]
)
def test_published_vessels(name, exact):
    """Two vessels whose quality has a closed form."""
    assert quality(load_example(name).swarm).value == pytest.approx(exact, rel=1e-6)


# -- against the slow truth -----------------------------------------------------------


@given(swarms)
@settings(max_examples=400)
def test_the_quality_of_few_robots(swarm):
    """All normals across every generator, each h summed anew."""
    answer = quality(swarm)
    assert close(answer.value, reference.quality(swarm.scaled_generators), swarm)


@pytest.mark.parametrize("family", FAMILIES)
def test_the_quality_of_few_robots_to_the_last_digits(family):
    """In fractions: wrong by no more than what rounding does to a sum of all generators."""
    for seed in range(25):
        swarm = swarm_of(family, seed, seed % 8)
        size = np.linalg.norm(swarm.scaled_generators, axis=1).sum()
        exact = reference.exact_quality(swarm.scaled_generators)
        error = abs(quality(swarm).value - exact)
        assert error <= (1e-12 * exact + 3e-16 * size if exact > 1e-12 * size else exact)


@pytest.mark.parametrize(("family", "seed", "n"), [("giant", 3, 30), ("giant", 8, 25)])
def test_dwarfs_beside_a_giant_count_in_full(family, seed, n):
    """Running sums would carry the giant's rounding, many times that of a sum."""
    swarm = swarm_of(family, seed, n)
    exact = reference.exact_quality(swarm.scaled_generators)
    assert abs(quality(swarm).value - exact) <= 1e-12 * exact


def test_the_weakest_of_facets_that_are_almost_equal_is_found():
    """Of a ring of 60 robots, all alike but for a part in 10^11."""
    turn = np.arange(60) * (math.pi / 30)
    ring = np.column_stack([np.cos(turn), np.sin(turn), 0.3 * (-1.0) ** np.arange(60)])
    ring *= 1.0 + 1e-11 * np.random.default_rng(0).normal(size=(60, 1))
    truth = reference.quality(ring)
    assert abs(weakest_of(ring).quality - truth) <= 3e-13 * truth


@given(large_swarms)
@settings(max_examples=60)
def test_the_quality_of_many_robots(swarm):
    """The sweep agrees too, parallel and coplanar generators included."""
    answer = quality(swarm)
    assert close(answer.value, reference.quality(swarm.scaled_generators), swarm)


@given(st.one_of(swarms, large_swarms))
@settings(max_examples=200)
def test_what_an_answer_says_of_its_facet(swarm):
    """The support at the direction is the value, the wrench is there, its robots too."""
    answer = quality(swarm)
    B, lengths = swarm.scaled_generators, np.linalg.norm(swarm.scaled_generators, axis=1)
    assert np.linalg.norm(answer.direction) == pytest.approx(1.0, abs=1e-14)
    assert close(answer.value, reference.support(B, answer.direction)[0], swarm)
    np.testing.assert_allclose(
        answer.weakest_wrench * swarm.scale, answer.value * answer.direction, rtol=1e-12
    )
    distances = np.abs(B @ answer.direction) / lengths
    rows = [swarm.index(name) for name in answer.facet_robots]
    assert rows == np.flatnonzero(distances <= 1e-9).tolist()
    if answer.value > 0.0:
        assert answer.is_force_closure
        spread = B[rows] / lengths[rows, None]
        assert np.linalg.svd(spread, compute_uv=False)[1] > 0.0


# -- what every quality obeys ---------------------------------------------------------


@given(swarms, st.floats(-7.0, 7.0), st.floats(-3.0, 3.0), st.floats(-3.0, 3.0))
@settings(max_examples=150)
def test_frames_and_units_do_not_matter(swarm, turn, longer, stronger):
    """Turning and reflecting change nothing; force scales it, length with L does not."""
    before = quality(swarm).value
    factor = 10.0**stronger
    if swarm.force_weights == (1.0, 1.0):  # surge and sway weighed alike
        assert close(quality(remade(swarm, turn)).value, before, swarm)
    assert close(quality(remade(swarm, sign=-1.0)).value, before, swarm)
    assert close(quality(remade(swarm, stretched=10.0**longer)).value, before, swarm)
    strong = remade(swarm, stronger=factor)
    assert close(quality(strong).value, factor * before, strong)


@given(st.one_of(swarms, large_swarms), seeds)
@settings(max_examples=150)
def test_order_and_halves_do_not_matter(swarm, seed):
    """Robots in another order, and one of them split in two halves."""
    rng = np.random.default_rng(seed)
    before, robots = quality(swarm).value, list(swarm.robots)
    shuffled = [robots[i] for i in rng.permutation(len(robots))]
    assert close(quality(with_robots(swarm, shuffled)).value, before, swarm)
    if robots:
        one = shuffled.pop()
        half = Robot(one.contact, one.direction, 0.5 * one.limit)
        assert close(quality(with_robots(swarm, [half, *shuffled, half])).value, before, swarm)


@given(st.one_of(swarms, large_swarms), seeds)
@settings(max_examples=150)
def test_more_never_hurts(swarm, seed):
    """Neither more force of one robot (T6) nor one more robot lowers the quality."""
    rng = np.random.default_rng(seed)
    before, robots = quality(swarm).value, list(swarm.robots)
    spot = swarm.outline.at_arc_length(rng.uniform(0.0, swarm.outline.perimeter)).point
    more = [[*robots, Robot(spot, rng.uniform(-4.0, 4.0), 10.0 ** rng.uniform(-6, 6))]]
    if robots:
        one = robots.pop()
        more.append(
            [*robots, Robot(one.contact, one.direction, one.limit * 10 ** rng.uniform(0, 3))]
        )
    for crew in more:
        larger = with_robots(swarm, crew)
        assert quality(larger).value >= before * (1.0 - 1e-9) - 2e-12 * size(larger)


@given(st.one_of(swarms, large_swarms), seeds)
@settings(max_examples=150)
def test_a_small_change_is_a_small_change(swarm, seed):
    """Q moves by at most sum |db_i| (T4), and by the right order of magnitude."""
    rng = np.random.default_rng(seed)
    B = swarm.scaled_generators
    change = 10.0 ** rng.uniform(-9, 1) * rng.normal(size=B.shape)
    before, after = (weakest_of(G).quality for G in (B, B + change))
    allowed = np.linalg.norm(change, axis=1).sum()
    assert abs(after - before) <= allowed * (1.0 + 1e-9) + 1e-12 * size(swarm)


@given(st.one_of(swarms, large_swarms), seeds)
@settings(max_examples=100)
def test_no_direction_is_weaker_than_the_quality(swarm, seed):
    """Q <= h(n) for any unit n, and Q <= N / pi for N unit robots (T3)."""
    normals = np.random.default_rng(seed).normal(size=(200, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    value = quality(swarm).value
    heights = reference.support(swarm.scaled_generators, normals)
    assert value <= heights.min() + 1e-12 * size(swarm)
    a1, a2 = swarm.force_weights
    total = sum(r.limit for r in swarm.robots) * math.sqrt(max(a1, a2))
    assert value <= total / math.pi + 1e-12 * size(swarm)


@given(swarms, seeds)
@settings(max_examples=60)
def test_every_wrench_of_the_ball_can_be_made(swarm, seed):
    """Q w lies in the wrench set for unit w, and a little more in the weakest direction not."""
    normals = np.random.default_rng(seed).normal(size=(4, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    answer, wrenches = quality(swarm), WrenchSet(swarm)
    assert wrenches.contains(answer.value * normals / swarm.scale).all()
    assert wrenches.contains(answer.weakest_wrench)
    beyond = (answer.value + 1e-6 * size(swarm)) * answer.direction / swarm.scale
    assert not len(swarm) or not wrenches.contains(beyond)


# -- force closure --------------------------------------------------------------------

CENTRED = [Robot((1, 0), 0.0), Robot((-1, 0), math.pi), Robot((0, 1), math.pi / 2)]
CENTRED += [Robot((0, -1), -math.pi / 2)]
ONE_WAY = Robot((1, 0.5), math.pi / 2)
TAIL = [Robot((-0.9, 0), turn * math.pi / 2, 2.0, mounted=True) for turn in (1, -1)]
AIRSHIP = [Robot((0, y), 0.0, 10.0, mounted=True) for y in (0.5, -0.5)] + TAIL  # never astern


@pytest.mark.parametrize(
    ("robots", "verdict"),
    [
        ([Robot(*row) for row in PULLS], ForceClosure.YES),
        ([Robot(*row, limit=1e-6) for row in PULLS], ForceClosure.YES),
        ([], ForceClosure.NO),
        ([Robot(*PULLS[0])], ForceClosure.NO),
        ([Robot(*row) for row in PULLS[:3]], ForceClosure.NO),
        ([Robot(*row) for row in PULLS[:2] * 3], ForceClosure.NO),  # parallel: flat
        (CENTRED, ForceClosure.NO),  # no torque whatever they do
        ([*CENTRED, ONE_WAY], ForceClosure.NO),  # torque one way, none the other
        ([*CENTRED * 3, ONE_WAY, ONE_WAY], ForceClosure.NO),
        (AIRSHIP, ForceClosure.NO),
        ([Robot((1, y), 0.1 * y) for y in (-1, -0.5, 0.2, 0.7, 1)], ForceClosure.NO),
        ([*CENTRED, ONE_WAY, Robot((1, -0.5), -math.pi / 2)], ForceClosure.YES),
    ],
)
def test_force_closure(robots, verdict):
    """Certain, or missing where some direction opposes or idles all robots."""
    answer = quality(Swarm(SQUARE, robots, 1.0))
    assert answer.force_closure is verdict
    assert (answer.value > 0.0) is answer.is_force_closure is (verdict is ForceClosure.YES)


@pytest.mark.parametrize("decimals", [2, 3, 4, 6, 9])
@pytest.mark.parametrize(("corners", "robots"), [(36, 4), (36, 5), (360, 5), (360, 7), (1440, 11)])
def test_inward_pushes_on_a_rounded_circle_never_close_it(corners, robots, decimals):
    """They have no torque; what their outline's decimals make of it is told as noise."""
    answer = quality(rounded_tank(corners, robots, decimals))
    assert answer.value <= answer.noise
    assert answer.force_closure is not ForceClosure.YES
    assert quality(rounded_tank(corners, robots, 15)).force_closure is ForceClosure.NO


def test_a_quality_below_the_noise_is_marginal_and_one_above_is_certain():
    """0.37 N of 2 MN is rounding; two tugs that push past the middle are not."""
    tank = rounded_tank(360, 5, 6)
    answer = quality(tank)
    assert 0.0 < answer.value < answer.noise < 1e-5 * size(tank)
    assert answer.force_closure is ForceClosure.MARGINAL
    assert "may be rounding" in answer.explanation
    turned = [Robot(r.contact, r.direction + side) for r in tank.robots for side in (0.1, -0.1)]
    assert quality(with_robots(tank, turned)).is_force_closure
    task = Polytope([(0.0, 0.0, 1e6), (0.0, 0.0, -1e6)])
    relative = quality(tank, task=task)
    assert relative.noise == pytest.approx(answer.noise * tank.characteristic_length / 1e6)


def test_no_closure_is_certain_only_where_all_are_opposed_by_more_than_their_errors():
    """Tugs along one side of a tank push away for certain; around it rounding may close."""
    side = Swarm((tank := rounded_tank(360, 12, 6)).outline, tank.robots[:5])
    assert quality(side).force_closure is ForceClosure.NO
    coarse = rounded_tank(360, 4, 4)
    assert quality(coarse).value == 0.0
    assert quality(coarse).force_closure is ForceClosure.MARGINAL


def test_all_through_one_point_is_no_closure():
    """Lines of action through any point leave the torque about it to nobody."""
    middle = np.array([0.3, -0.2])
    spots = [SQUARE.at_arc_length(s).point for s in np.linspace(0.1, 7.9, 12)]
    robots = [Robot(p, math.atan2(*(middle - p)[::-1])) for p in spots]
    answer = quality(Swarm(SQUARE, robots, 1.0))
    assert (answer.value, answer.force_closure) == (0.0, ForceClosure.NO)
    assert answer.facet_robots == tuple(f"R{k}" for k in range(1, 13))


@pytest.mark.parametrize("stranger", [None, [Robot((0, 0), 0.0)]])
def test_only_a_swarm_has_a_quality(stranger):
    """Robots without an object have none."""
    with pytest.raises(SwarmInvalid, match="is no Swarm: make one"):
        quality(stranger)
