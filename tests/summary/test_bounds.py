"""What a summary says is true of every swarm it may stand for."""

import copy
import pickle

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from reference import CLOSED_FORMS, support
from reference import quality as slow_quality
from strategies import FAMILIES, swarm_of
from summary.crowds import KINDS, crowd, directions
from swarmgrasp import quality
from swarmgrasp.errors import SummaryInvalid, SwarmGraspError, SwarmInvalid, WrenchInvalid
from swarmgrasp.summary import Summary
from swarmgrasp.summary.support_bounds import greatest_mean

seeds = st.integers(0, 2**32 - 1)
bin_numbers = st.sampled_from([12, 50, 108, 1024])


@given(st.sampled_from(KINDS), seeds, st.integers(0, 40), bin_numbers)
def test_the_support_function_lies_between_its_bounds(kind, seed, n, bins):
    """In every direction, and as sharply as can be along the axes, before and after a message."""
    B, normals = crowd(kind, seed, n), directions(seed)
    h, size = support(B, normals), np.linalg.norm(B, axis=1).sum()
    summary = Summary.from_generators(B, bins)
    for known in (summary, Summary.from_bytes(summary.to_bytes())):
        lower, upper = known.support.lower(normals), known.support.upper(normals)
        assert (lower <= h).all()
        assert (h <= upper).all()
        assert (upper - lower)[-6:].max() <= 1e-4 * size


@given(st.sampled_from(KINDS), seeds, st.integers(0, 14), bin_numbers)
def test_the_quality_lies_between_its_bounds(kind, seed, n, bins):
    """Against all facets by the formula."""
    B = crowd(kind, seed, n)
    truth = slow_quality(B)
    summary = Summary.from_generators(B, bins)
    for known in (summary, Summary.from_bytes(summary.to_bytes())):
        bounds = known.quality()
        assert bounds.lower <= truth * (1.0 + 1e-12)
        assert truth <= bounds.upper * (1.0 + 1e-12) + 1e-15 * np.abs(B).sum()
        assert bounds.is_force_closure is (bounds.lower > 0.0)
        there = known.support.upper(bounds.direction[None])[0]
        assert there <= bounds.upper + 1e-12 * np.abs(B).sum()


@given(st.sampled_from(FAMILIES), seeds, st.integers(0, 60))
def test_a_swarm_is_summarised_in_its_own_metric(family, seed, n):
    """Whatever its weights, length and origin."""
    swarm = swarm_of(family, seed, n)
    summary = Summary.of(swarm)
    bounds = summary.quality()
    assert summary.count == len(swarm)
    assert bounds.lower <= quality(swarm).value <= bounds.upper
    assert bounds.metric == swarm.metric_sentence


@pytest.mark.parametrize("name", CLOSED_FORMS)
def test_published_solids_are_exact(name):
    """Each generator alone in its bin, or among its like: nothing is lost."""
    B, exact = CLOSED_FORMS[name]
    bounds = Summary.from_generators(B).quality()
    assert bounds.lower == pytest.approx(exact, rel=1e-9)
    assert bounds.upper == pytest.approx(exact, rel=1e-9)


@pytest.mark.parametrize("n", range(4))
def test_fewer_than_four_robots_hold_nothing(n):
    """The lower bound is zero, and the upper one says so too."""
    bounds = Summary.from_generators(crowd("round", 1, n)).quality()
    assert bounds.lower == 0.0
    assert bounds.upper <= 1e-9


def test_a_million_identical_robots():
    """A million times what one of each can do, to rounding."""
    four = crowd("round", 3, 4)
    four = np.vstack([four, -four.sum(axis=0)])
    bounds = Summary.from_generators(np.repeat(four, 200_000, axis=0)).quality()
    truth = 2e5 * slow_quality(four)
    assert truth > 0.0
    assert bounds.lower == pytest.approx(truth, rel=1e-6)
    assert bounds.upper == pytest.approx(truth, rel=1e-6)


def test_many_robots_are_summed_in_parts(monkeypatch):
    """Parts of seven give the same bounds as all at once."""
    B, normals = crowd("clustered", 2, 50), directions(2)
    whole = Summary.from_generators(B, 108)
    monkeypatch.setattr("swarmgrasp.summary.moments.CHUNK", 7)
    parts = Summary.from_generators(B, 108)
    assert np.allclose(parts.total, whole.total, rtol=1e-13)
    for bound in ("lower", "upper"):
        ours, theirs = (getattr(s.support, bound)(normals) for s in (parts, whole))
        assert np.allclose(ours, theirs, rtol=1e-9)


@pytest.mark.parametrize(("bins", "share"), [(128, 0.03), (1024, 0.003)])
def test_the_bounds_are_narrow(bins, share):
    """For 100 000 robots all round; ten times better still than was asked of 1024 bins."""
    summary = Summary.from_generators(crowd("round", 5, 100_000), bins)
    bounds = summary.quality()
    assert 0.0 < bounds.width <= share * bounds.lower
    assert len(summary.to_bytes()) <= 108 + 18 * summary.bins


@given(seeds)
def test_the_greatest_mean_is_that_of_no_distribution_exceeded(seed):
    """Random distributions stay below it, and two of its own values reach it."""
    rng = np.random.default_rng(seed)
    y, p = rng.uniform(-1.0, 1.0, 6) * 10.0 ** rng.uniform(-6, 0, 6), rng.dirichlet(np.full(6, 0.3))
    low, high = min(y.min(), -1e-9), max(y.max(), 1e-9)
    mean = p @ y
    variance = p @ (y - mean) ** 2
    (bound,) = greatest_mean(*(np.array([v]) for v in (mean, variance, low, high)))
    assert p @ np.abs(y) <= bound * (1.0 + 1e-9) + 1e-15
    assert bound <= np.hypot(mean, np.sqrt(variance)) * (1.0 + 1e-12)


@pytest.mark.parametrize(
    ("generators", "bins", "error", "says"),
    [
        ([[1.0, 2.0]], 1024, WrenchInvalid, r"the shape \(1, 2\)"),
        ([[0, 0, 1], [0, np.nan, 1]], 1024, WrenchInvalid, "generator 1"),
        ([[0, np.inf, 1]], 1024, WrenchInvalid, "generator 0"),
        ([[0, 1e-200, 0]], 1024, WrenchInvalid, "1e-120 <= size"),
        ("abc", 1024, WrenchInvalid, "are 'abc'"),
        ([[0, 0, 1j]], 1024, WrenchInvalid, "should be real numbers"),
        ([[0, 0, 1], [0]], 1024, WrenchInvalid, "should be real numbers"),
        ([[0, 0, 1.0]], 11, SummaryInvalid, "the number of bins is 11"),
        ([[0, 0, 1.0]], 1e3, SummaryInvalid, "a whole number"),
    ],
)
def test_bad_input_is_named(generators, bins, error, says):
    """With the value and its range."""
    with pytest.raises(error, match=says):
        Summary.from_generators(generators, bins)
    assert issubclass(error, SwarmGraspError)


@pytest.mark.parametrize("origin", [(0,), (0, 0, 0), (0, np.nan), 3.0, None])
def test_the_origin_is_a_point(origin):
    """Two finite numbers."""
    with pytest.raises(SummaryInvalid, match="it should be two finite numbers"):
        Summary.from_generators([[0, 0, 1.0]], origin=origin)


@pytest.mark.parametrize("stranger", [None, Summary.from_generators([[0, 0, 1.0]])])
def test_only_a_swarm_is_summarised(stranger):
    """A summary is one already."""
    with pytest.raises(SwarmInvalid, match="is no Swarm"):
        Summary.of(stranger)


@pytest.mark.parametrize("copied", [copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s))])
def test_a_copy_is_the_same_summary_and_read_only(copied):
    """It says the same, also once it was asked."""
    summary = Summary.from_generators(crowd("round", 4, 200))
    before = summary.quality()
    twin = copied(summary)
    assert twin.to_bytes() == summary.to_bytes()
    assert (twin.quality().lower, twin.quality().upper) == (before.lower, before.upper)
    m = twin.moments
    for array in (twin.total, m.cells, m.weights, m.means, m.covariances, twin.quality().direction):
        assert not array.flags.writeable
