"""The exact quality of generators that need not belong to robots, many or few."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import reference
from strategies import seeds
from swarmgrasp import qualities
from swarmgrasp.errors import WrenchInvalid
from swarmgrasp.kernels import core
from swarmgrasp.quality.weakest import weakest_of


def draw(kind, seed, n):
    """Return n generators, (n, 3), of a kind that is easy or hard to get right."""
    rng = np.random.default_rng(seed)
    grid = rng.integers(-2, 3, size=(n, 3)).astype(float)
    turned = grid @ np.linalg.qr(rng.normal(size=(3, 3)))[0]
    free = rng.normal(size=(n, 3))
    around = np.arange(n) * 2.0 * np.pi / n
    return {
        "random": free,
        "axes": np.eye(3)[rng.integers(3, size=n)] * rng.choice([-1.0, 1.0], (n, 1)),
        "grid": grid,  # parallel, coplanar and zero ones
        "turned grid": turned,
        "almost": turned + 10.0 ** rng.uniform(-16, -7) * free,
        "flat": turned * [1.0, 1.0, 0.0],
        "line": np.outer(free[:, 0], turned[:1].sum(axis=0)),
        "balanced": np.vstack([turned, -turned])[:n],
        "spread": free * 10.0 ** rng.uniform(-6, 6, (n, 1)),
        "giant": free * np.where(np.arange(n) == n // 2, 1e4, 1.0)[:, None],
        "needle": free * [1e-6, 1e-6, 1.0],
        "pancake": free * [1.0, 1.0, 1e-6],
        "clustered": free[rng.integers(6, size=n) % n] + 1e-3 * free,
        "half coplanar": np.where(np.arange(n)[:, None] % 2, free * [1.0, 1.0, 0.0], free),
        "duplicates": free[rng.integers(8, size=n) % n],
        "ring": np.column_stack([np.cos(around), np.sin(around), 0.3 * (-1.0) ** np.arange(n)]),
        "one-sided": np.abs(free),
        "ties": np.repeat(np.sign(free) + 2e-16 * rng.integers(-1, 2, (n, 3)), 2, axis=0)[:n],
    }[kind]


KINDS = (
    "random", "axes", "grid", "turned grid", "almost", "flat", "line", "balanced", "spread",
    "giant", "needle", "pancake", "clustered", "half coplanar", "duplicates", "ring", "one-sided",
    "ties",
)  # fmt: skip
kinds = st.sampled_from(KINDS)


def size(B):
    """Return sum |b_i|."""
    return np.linalg.norm(B, axis=1).sum()


def all_pairs(B):
    """Return the least h over all candidate normals, one generator's plane at a time."""
    kept = B[np.linalg.norm(B, axis=1) > 0.0]
    each = (reference.support(B, reference.normals_across(b, kept)).min() for b in kept)
    return min(each, default=0.0)


def check(B):
    """Compare with all pairs, and the normal with its own support function."""
    value, normal = weakest_of(B)
    slack = 1e-13 * size(B) if value > 0.0 else 2e-12 * size(B)
    assert value == pytest.approx(all_pairs(B), rel=1e-11, abs=slack)
    assert np.linalg.norm(normal) == pytest.approx(1.0)
    own = reference.support(B, np.array(normal))[0]
    assert own == pytest.approx(value, rel=1e-11, abs=2e-12 * size(B))


@given(kinds, seeds, st.integers(1, 14))
@settings(max_examples=300)
def test_few_robots_are_as_weak_as_all_pairs_say(kind, seed, n):
    """By sweeping: axis-aligned, parallel, coplanar and zero generators included."""
    check(draw(kind, seed, n))


@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("n", [47, 48, 49, 50, 131])
def test_many_robots_are_as_weak_as_all_pairs_say(kind, n):
    """By sweeping and by branch and bound, on both sides of the border between them."""
    for seed in range(3):
        check(draw(kind, seed, n))


@pytest.mark.long
@pytest.mark.parametrize("kind", KINDS)
@pytest.mark.parametrize("n", [200, 300, 500])
def test_more_robots_are_as_weak_as_all_pairs_say(kind, n):
    """All kinds, up to five hundred."""
    for seed in range(100, 103):
        check(draw(kind, seed, n))


@pytest.mark.parametrize("name", reference.CLOSED_FORMS)
@pytest.mark.parametrize("copies", [1, 20, 5000])
def test_solids_and_squares_in_closed_form(name, copies):
    """Once by the formula, and in many parts of the same sum."""
    B, exact = reference.CLOSED_FORMS[name]
    parts = np.repeat(B / copies, copies, axis=0)
    assert weakest_of(parts).quality == pytest.approx(exact, rel=1e-12)


@pytest.mark.parametrize(
    "B", [np.zeros((0, 3)), np.zeros((2, 3)), np.outer([1, -2, 3], [3, 4, 12]), np.zeros((200, 3))]
)
def test_a_line_or_nothing_is_weak_across(B):
    """The quality is 0, shown by a unit normal orthogonal to everything."""
    value, normal = weakest_of(B)
    assert value == 0.0
    assert np.linalg.norm(normal) == pytest.approx(1.0)
    np.testing.assert_allclose(B @ normal, 0.0, atol=1e-14)


def test_a_million_robots():
    """Identical ones hold nothing; with their opposites turned and mirrored they do."""
    assert weakest_of(np.tile([[1.0, 2.0, 3.0]], (1_000_000, 1))).quality == 0.0
    B, exact = reference.CLOSED_FORMS["cube"]
    parts = np.tile(B / 1e5, (1_000_000 // len(B), 1))
    assert weakest_of(parts).quality == pytest.approx(exact * len(parts) / len(B) / 1e5, rel=1e-9)


def test_limits_from_1e_minus_12_to_1e12():
    """The quality is that of what the strongest leave open, and never more than all pairs."""
    for seed in range(20):
        rng = np.random.default_rng(seed)
        n = int(rng.integers(4, 120))
        B = rng.normal(size=(n, 3)) * 10.0 ** rng.uniform(-12, 12, (n, 1))
        check(B)


@pytest.mark.parametrize("n", [3, 12, 48, 49, 100])
@pytest.mark.parametrize("kind", ["random", "grid", "half coplanar", "clustered", "one-sided"])
def test_beside_a_wrench_that_is_always_there(kind, n):
    """It adds n . load to the support function; where that falls below 0, so does the quality."""
    for seed in range(4):
        rng = np.random.default_rng(seed)
        B, load = draw(kind, seed, n), 0.05 * n * rng.normal(size=3)
        normals = np.vstack([reference.normals_across(b, B) for b in B if b.any()])
        truth = max((normals @ load + reference.support(B, normals)).min(), 0.0)
        value, normal = weakest_of(B, tuple(load))
        assert value == pytest.approx(truth, rel=1e-11, abs=2e-12 * size(B))
        own = load @ normal + reference.support(B, np.array(normal))[0]
        assert max(own, 0.0) == pytest.approx(value, abs=2e-12 * size(B))


@pytest.mark.parametrize("n", [20, 49, 200])
@pytest.mark.parametrize("stretch", [1.0, 1e4])
def test_forces_in_any_unit(n, stretch):
    """The quality scales with the limits, over all of their range."""
    B = draw("random", 5, n) * [1.0, 1.0, stretch]
    value = weakest_of(B).quality
    for unit in (1e-98, 1e-40, 1e-20, 1e20, 1e77, 1e98):
        assert weakest_of(unit * B).quality == pytest.approx(unit * value, rel=1e-12)


# -- many at once --------------------------------------------------------------------------


@pytest.mark.parametrize("n", [0, 1, 3, 7, 90])
def test_many_swarms_at_once(n):
    """As one by one."""
    swarms = np.array([draw(kind, 3, max(n, 1))[:n] for kind in KINDS])
    values = qualities(swarms)
    assert values.tolist() == [weakest_of(B).quality for B in swarms]


@pytest.mark.parametrize("empty", [[], np.zeros((0, 4, 3)), [[], []], np.zeros((2, 0, 3))])
def test_many_swarms_of_nobody(empty):
    """No swarms have no qualities, those of no robots have none each."""
    assert qualities(empty).tolist() == [0.0] * len(empty)


@pytest.mark.parametrize("unit", [1e-120, 1e120])
def test_many_swarms_in_any_unit(unit):
    """Up to the ends of the range; what rounding leaves beside it does not matter."""
    B = np.array([draw("random", seed, 60) for seed in range(3)])
    B /= np.abs(B).max(axis=2, keepdims=True)
    B[:, 0] = [1.0, 1e-170, 0.0]
    np.testing.assert_allclose(qualities(unit * B), unit * qualities(B), rtol=1e-12)


def test_many_swarms_of_the_wrong_kind():
    """What is wrong is named, and the first generators at fault."""
    with pytest.raises(WrenchInvalid, match=r"shape \(4, 3\); it should be \(m, n, 3\)"):
        qualities(np.zeros((4, 3)))
    B = np.ones((3, 4, 3))
    B[1, 2, 0], B[2, 0, 0] = np.nan, np.inf
    with pytest.raises(
        WrenchInvalid, match=r"generator 2 of swarm 1 is \[nan, 1.0, 1.0\]"
    ) as caught:
        qualities(B)
    assert len(caught.value.faults) == 2


def test_with_little_work_a_bound_is_left():
    """Of many robots: what was found is too much, the bound too little, and both are told."""
    B = np.random.default_rng(0).normal(size=(3000, 3))
    exact = weakest_of(B).quality
    for work in (0.0, 1e4, 1e5):
        value, _, bound = core.weakest(B, (0.0, 0.0, 0.0), work)
        assert bound <= exact <= value
    value, _, bound = core.weakest(B)
    assert bound == value == exact
