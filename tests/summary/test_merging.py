"""Summaries add up, in any order."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from reference import support
from summary.crowds import KINDS, crowd, directions, summary_of
from swarmgrasp import Outline, Robot, Swarm
from swarmgrasp.errors import SummaryInvalid
from swarmgrasp.summary import Summary

seeds = st.integers(0, 2**32 - 1)
summaries = st.builds(summary_of, st.sampled_from(KINDS), seeds, st.integers(0, 30))
SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])


def everything(summary):
    """Return all its numbers."""
    m = summary.moments
    parts = (m.cells, m.weights, m.means, m.covariances, summary.total, summary.rounding)
    return [summary.count, *(np.asarray(part).tobytes() for part in parts)]


@given(summaries, summaries)
def test_the_order_of_two_does_not_matter(a, b):
    """To the last bit."""
    assert everything(a + b) == everything(b + a)


@given(summaries)
def test_the_empty_summary_changes_nothing(a):
    """From either side, and none at all are empty."""
    empty = Summary.from_generators([], 108)
    assert everything(a + empty) == everything(empty + a) == everything(a)
    assert everything(empty + empty) == everything(empty)


@given(st.lists(st.tuples(st.sampled_from(KINDS), seeds), min_size=1, max_size=6), seeds)
def test_any_grouping_bounds_the_whole(parts, seed):
    """However the parts are merged, and though each came by message."""
    crowds = [crowd(kind, s, s % 20) for kind, s in parts]
    messages = [Summary.from_generators(B, 108).to_bytes() for B in crowds]
    known = [Summary.from_bytes(message) for message in messages]
    whole, normals = np.vstack(crowds), directions(seed)
    h = support(whole, normals)
    one_by_one = known[0]
    for other in known[1:]:
        one_by_one = Summary.from_bytes((one_by_one + other).to_bytes())
    backwards = Summary.merge(reversed(known))
    direct = Summary.from_generators(whole, 108)
    size = np.abs(whole).sum()
    for merged in (one_by_one, backwards):
        assert merged.count == len(whole)
        lower, upper = merged.support.lower(normals), merged.support.upper(normals)
        assert (lower <= h).all()
        assert (h <= upper).all()
        assert np.abs(lower - direct.support.lower(normals)).max() <= 1e-4 * size


def test_only_like_summaries_are_merged():
    """All that differs is named, with both values."""
    robots = [Robot((1, 0), 3.0)]
    a = Summary.of(Swarm(SQUARE, robots), 108)
    others = [
        (Summary.of(Swarm(SQUARE, robots)), "bins of two summaries differ: 108 and 972"),
        (Summary.of(Swarm(SQUARE, robots, 2.0), 108), r"lengths \[m\] .* 1.41\d+ and 2.0"),
        (Summary.of(Swarm(SQUARE, robots, None, (1, 2)), 108), r"\(1.0, 1.0\) and \(1.0, 2.0\)"),
        (Summary.empty(Outline(SQUARE.vertices, origin=(0, 1)), 108), r"\(0.0, 0.0\) and \(0.0, 1"),
    ]
    for b, says in others:
        with pytest.raises(SummaryInvalid, match=says):
            a + b
    with pytest.raises(SummaryInvalid, match="at least one"):
        Summary.merge([])
    with pytest.raises(SummaryInvalid, match=r"3 is no Summary.*\nNone is no Summary"):
        Summary.merge([a, 3, None])
    with pytest.raises(TypeError):
        a + 1
