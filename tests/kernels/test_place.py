"""Exact qualities with a newcomer, and bounds that hold whatever happens to the search."""

import signal

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import reference
from alongside import while_it_computes
from strategies import FAMILIES, problem_of, seeds, swarm_of
from swarmgrasp import Newcomer, place_sequence
from swarmgrasp.kernels import core
from swarmgrasp.placement import Problem, search
from swarmgrasp.placement.search import Search


def robots_at(rows, rng):
    """Return a unit wrench on each piece, (r, 3), at its ends and in between."""
    along, across = rng.choice([0.0, 0.3, 0.5, 1.0], (2, len(rows)))
    angles = rows[:, 4] + across * (rows[:, 5] - rows[:, 4])
    x, y = (rows[:, :2] + along[:, None] * (rows[:, 2:4] - rows[:, :2])).T
    c, s = np.cos(angles), np.sin(angles)
    return np.column_stack([c, s, x * s - y * c])


@given(st.sampled_from(FAMILIES), seeds, st.one_of(st.integers(0, 30), st.integers(59, 63)))
@settings(max_examples=60)
def test_the_quality_with_one_robot_more(family, seed, n):
    """As by summing anew over all facets of the larger swarm, wherever the robot is."""
    swarm = swarm_of(family, seed, n)
    rows = Problem(swarm, Newcomer()).pieces().rows
    search = Search(swarm.scaled_generators, swarm.scale, rows)
    rng = np.random.default_rng(seed)
    robots = robots_at(rows[rng.integers(len(rows), size=6)], rng)
    for value, robot in zip(search.qualities_with(robots), robots, strict=True):
        more = np.vstack([swarm.scaled_generators, robot * swarm.scale])
        total = np.linalg.norm(more, axis=1).sum()
        assert value == pytest.approx(reference.quality(more), rel=1e-9, abs=2e-12 * total)


@pytest.mark.parametrize("family", ["along normals", "free", "ring", "giant", "balanced"])
@pytest.mark.parametrize("work", [0, 300, 3000])
@pytest.mark.parametrize("n", [8, 101])
def test_bounds_hold_when_the_search_runs_out_of_budget(family, work, n, monkeypatch):
    """With little or no work done an answer is coarse, and still proven."""
    for seed in range(8):
        problem = problem_of(family, seed, n)
        (fine,) = place_sequence(problem, 1)
        with monkeypatch.context() as patch:
            patch.setattr(search, "WORK", work)
            (coarse,) = place_sequence(problem, 1)
        slack = 1e-12 * np.linalg.norm(fine.swarm_after.scaled_generators, axis=1).sum()
        assert coarse.quality <= fine.upper_bound * (1.0 + 1e-9) + slack
        assert coarse.upper_bound >= fine.quality * (1.0 - 1e-9) - slack
        assert coarse.verify()


def search_of(problem):
    """Return the kernels' search for a problem."""
    rows, swarm = problem.pieces().rows, problem.swarm
    weights = swarm.scale * problem.newcomer.limit
    return core.Search(swarm.scaled_generators, tuple(weights.tolist()), rows), rows


@pytest.mark.parametrize("n", [0, 4, 57, 61])
def test_robots_that_join_are_as_if_there_from_the_start(n):
    """Across the sizes at which a list of facets gives way to a tree, and that is built anew."""
    problem = problem_of("free", 3, n)
    newcomers = 40 if n == 61 else 6
    for answer in place_sequence(Problem(problem.swarm, Newcomer(2.0)), newcomers):
        (alone,) = place_sequence(answer.problem, 1)
        size = np.linalg.norm(answer.swarm_after.scaled_generators, axis=1).sum()
        assert answer.quality_before == pytest.approx(alone.quality_before, abs=1e-11 * size)
        assert answer.quality == pytest.approx(alone.quality, rel=2.1e-6, abs=1e-11 * size)
        assert answer.upper_bound >= alone.quality - 1e-11 * size


def test_what_the_kernels_refuse():
    """Numbers that are none, arrays of other shapes, and pieces that are not there."""
    search, rows = search_of(problem_of("free", 1, 5))
    weights = (1.0, 1.0, 1.0)
    for call in (
        lambda: core.weakest(np.full((4, 3), np.nan)),
        lambda: core.weakest(np.ones((4, 3)), (0.0, np.inf, 0.0)),
        lambda: core.weakest(np.ones(4)),
        lambda: core.weakest(np.ones((4, 3), dtype=np.float32)),
        lambda: core.qualities(np.ones((4, 3)), -1),
        lambda: core.qualities(np.ones((4, 3)), 3),
        lambda: core.Search(np.ones((4, 3)), weights, np.empty((0, 10))),
        lambda: core.Search(np.ones((4, 3)), (1.0, np.nan, 1.0), rows),
        lambda: search.quality_with(np.nan, 0.0, 0.0),
        lambda: search.join(np.inf, 0.0, 0.0, rows),
        lambda: search.solve(1e-6, b"1"),
    ):
        with pytest.raises(ValueError, match=r"wanted|there are"):
            call()
    assert search.solve(1e-6, None)[0]


def test_a_search_in_use_is_not_used_twice():
    """A signal's handler that calls it gets an error, and the search goes on to its end."""
    turn = np.arange(20_000) * (np.pi / 10_000)
    ring = np.column_stack([np.cos(turn), np.sin(turn), 0.3 * (-1.0) ** np.arange(len(turn))])
    rows = search_of(problem_of("free", 1, 5))[1]
    search = core.Search(np.vstack([ring, 0.01 * ring]), (1.0, 1.0, 1.0), rows)
    met = []

    def call(*_):
        try:
            search.quality_with(1.0, 0.0, 0.0)
        except RuntimeError as fault:
            met.append(str(fault))

    before = signal.signal(signal.SIGINT, call)
    try:
        with while_it_computes(lambda: signal.raise_signal(signal.SIGINT)):
            search.qualities_with(np.tile([1.0, 0.0, 0.0], (2, 1)))
    finally:
        signal.signal(signal.SIGINT, before)
    assert met[0] == "the search is in use"
