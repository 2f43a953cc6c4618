"""Facets and exact quality, on generators that need not belong to robots."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import reference
from strategies import seeds
from swarmgrasp.quality.facets import facets_of


def draw(kind, seed, n):
    """Return n generators, (n, 3), of a kind that is easy or hard to get right."""
    rng = np.random.default_rng(seed)
    grid = rng.integers(-2, 3, size=(n, 3)).astype(float)
    turned = grid @ np.linalg.qr(rng.normal(size=(3, 3)))[0]
    return {
        "random": rng.normal(size=(n, 3)),
        "axes": np.eye(3)[rng.integers(3, size=n)] * rng.choice([-1.0, 1.0], (n, 1)),
        "grid": grid,  # parallel, coplanar and zero ones
        "turned grid": turned,
        "almost": turned + 10.0 ** rng.uniform(-16, -7) * rng.normal(size=(n, 3)),
        "flat": turned * [1.0, 1.0, 0.0],
        "line": np.outer(rng.normal(size=n), turned[:1].sum(axis=0)),
        "balanced": np.vstack([turned, -turned])[:n],
        "spread": rng.normal(size=(n, 3)) * 10.0 ** rng.uniform(-6, 6, (n, 1)),
    }[kind]


KINDS = ["random", "axes", "grid", "turned grid", "almost", "flat", "line", "balanced", "spread"]
generators = st.builds(
    draw, st.sampled_from(KINDS), seeds, st.one_of(st.integers(1, 14), st.integers(45, 70))
)


def size(B):
    """Return sum |b_i|."""
    return np.linalg.norm(B, axis=1).sum()


@pytest.mark.parametrize("name", reference.CLOSED_FORMS)
@pytest.mark.parametrize("copies", [1, 20])
def test_solids_and_squares_in_closed_form(name, copies):
    """Once by the formula, and in many parts of the same sum by the sweep."""
    B, exact = reference.CLOSED_FORMS[name]
    parts = np.repeat(B / copies, copies, axis=0)
    assert facets_of(parts, -np.inf).quality == pytest.approx(exact, rel=1e-13)


@given(generators)
@settings(max_examples=300)
def test_the_quality_is_the_slow_truth(B):
    """On both sides of the sweep's threshold, axis-aligned and parallel generators included."""
    value = facets_of(B, 0.0).quality
    assert value == pytest.approx(reference.quality(B), rel=1e-9, abs=1e-12 * size(B))


@given(generators, st.floats(0.0, 1.0))
@settings(max_examples=150)
def test_a_list_holds_what_is_within_the_margin(B, share):
    """Unit normals with their own h, the least among them; all of them, and no other."""
    every = facets_of(B)
    slack = 1e-12 * size(B)
    np.testing.assert_allclose(np.linalg.norm(every.normals, axis=1), 1.0, atol=1e-14)
    truth = reference.support(B, every.normals)
    np.testing.assert_allclose(every.heights, truth, rtol=1e-12, atol=slack)
    assert every.quality == pytest.approx(every.heights.min(), abs=slack)
    assert reference.support(B, every.weakest)[0] == pytest.approx(every.quality, abs=slack)
    margin = share * (every.heights.max() - every.heights.min())
    few = facets_of(B, margin)
    if np.linalg.matrix_rank(B) > 1 and margin > 0.0:  # a line has only its two null normals
        below = every.heights < every.heights.min() + margin
        np.testing.assert_array_equal(few.normals, every.normals[below])
        np.testing.assert_array_equal(few.heights, every.heights[below])
    np.testing.assert_array_equal(few.weakest, every.weakest)
    assert few.quality == every.quality


@given(st.builds(draw, st.sampled_from(KINDS), seeds, st.integers(3, 9)))
@settings(max_examples=100)
def test_no_facet_is_missing(B):
    """Every normal across two generators that are not nearly parallel is in the list."""
    normals = facets_of(B).normals
    j, k = np.triu_indices(len(B), 1)
    crosses = np.cross(B[j], B[k])
    widths = np.linalg.norm(crosses, axis=1)
    lengths = np.linalg.norm(B, axis=1)
    clear = widths > 1e-3 * lengths[j] * lengths[k]
    wanted = crosses[clear] / widths[clear, None]
    for sign in (1.0, -1.0):
        assert (np.max(sign * wanted @ normals.T, axis=1, initial=-1.0) > 1.0 - 1e-12).all()


@pytest.mark.parametrize(
    "B", [np.zeros((0, 3)), np.zeros((2, 3)), np.outer([1, -2, 3], [3, 4, 12])]
)
def test_a_line_or_nothing_has_no_facet_but_is_weak_across(B):
    """The quality is 0, shown by a unit normal orthogonal to everything."""
    flat = facets_of(B)
    assert flat.quality == 0.0
    assert flat.heights.tolist() == [0.0, 0.0]
    np.testing.assert_array_equal(flat.normals, [flat.weakest, -flat.weakest])
    assert np.linalg.norm(flat.weakest) == pytest.approx(1.0)
    np.testing.assert_allclose(B @ flat.weakest, 0.0, atol=1e-14)


def test_more_facets_than_room_was_made_for():
    """Many robots: the quality is found first, then what is near it listed."""
    B = draw("random", 4, 300)
    value = facets_of(B, 0.0).quality
    few = facets_of(B, 0.2 * value)
    assert len(few.heights) > 16 * len(B)
    few = facets_of(B, 0.05 * value)
    assert len(few.heights) > 100
    assert value <= few.heights.min() <= few.heights.max() < 1.05 * value
    np.testing.assert_allclose(few.heights, reference.support(B, few.normals), rtol=1e-12)
