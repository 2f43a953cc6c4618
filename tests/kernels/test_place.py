"""Exact qualities with a newcomer, and bounds that hold whatever happens to the search."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import reference
from strategies import FAMILIES, problem_of, seeds, swarm_of
from swarmgrasp import Newcomer, place_sequence
from swarmgrasp.placement import Problem, optimum
from swarmgrasp.placement.optimum import Search


def robots_at(rows, rng):
    """Return a unit wrench on each piece, (r, 3), at its ends and in between."""
    along, across = rng.choice([0.0, 0.3, 0.5, 1.0], (2, len(rows)))
    angles = rows[:, 4] + across * (rows[:, 5] - rows[:, 4])
    x, y = (rows[:, :2] + along[:, None] * (rows[:, 2:4] - rows[:, :2])).T
    c, s = np.cos(angles), np.sin(angles)
    return np.column_stack([c, s, x * s - y * c])


@given(st.sampled_from(FAMILIES), seeds, st.one_of(st.integers(0, 30), st.integers(101, 110)))
@settings(max_examples=100)
def test_the_quality_with_one_robot_more(family, seed, n):
    """As by summing anew over all facets of the larger swarm, wherever the robot is."""
    swarm = swarm_of(family, seed, n)
    rows = Problem(swarm, Newcomer()).pieces().rows
    search = Search(swarm.scaled_generators, swarm.scale, rows)
    rng = np.random.default_rng(seed)
    robots = robots_at(rows[rng.integers(len(rows), size=20)], rng)
    for value, robot in zip(search.qualities_with(robots), robots, strict=True):
        more = np.vstack([swarm.scaled_generators, robot * swarm.scale])
        total = np.linalg.norm(more, axis=1).sum()
        assert value == pytest.approx(reference.quality(more), rel=1e-9, abs=2e-12 * total)


@pytest.mark.parametrize("family", ["along normals", "free", "ring", "giant", "balanced"])
@pytest.mark.parametrize("budget", [0, 1, 5])
@pytest.mark.parametrize("n", [8, 101])
def test_bounds_hold_when_the_search_runs_out_of_budget(family, budget, n, monkeypatch):
    """With few or no normals met an answer is coarse, and still proven."""
    for seed in range(8):
        problem = problem_of(family, seed, n)
        (fine,) = place_sequence(problem, 1)
        with monkeypatch.context() as patch:
            patch.setattr(optimum, "MOST_NORMALS", budget)
            (coarse,) = place_sequence(problem, 1)
        slack = 1e-12 * np.linalg.norm(fine.swarm_after.scaled_generators, axis=1).sum()
        assert coarse.quality <= fine.upper_bound * (1.0 + 1e-9) + slack
        assert coarse.upper_bound >= fine.quality * (1.0 - 1e-9) - slack
        assert coarse.verify()
