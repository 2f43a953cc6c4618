"""What a piece offers, and bounds that hold whatever happens to the search."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import reference
from strategies import FAMILIES, problem_of, seeds, swarm_of
from swarmgrasp import Newcomer, place_sequence
from swarmgrasp.kernels import facets
from swarmgrasp.kernels import place as kernels
from swarmgrasp.kernels.sector import best_on_piece
from swarmgrasp.placement import Problem, optimum
from swarmgrasp.placement.optimum import Search, robots_at


def piece_row(rng):
    """Return a piece on one side of a random edge: a stretch or a point, a sector or a ray."""
    p = rng.normal(size=2)
    q = p + (rng.normal(size=2) if rng.random() < 0.7 else 0.0)
    side = np.arctan2(*(q - p)[::-1])
    lo, hi = side + np.sort(rng.uniform(0.0, np.pi, 2))
    if rng.random() < 0.3:
        lo, hi = (side, side + np.pi) if rng.random() < 0.5 else (lo, lo)
    return np.array([*p, *q, lo, hi, np.cos(lo), np.sin(lo), np.cos(hi), np.sin(hi)])


@given(seeds)
@settings(max_examples=200)
def test_the_support_function_of_a_piece(seed):
    """It is reached by a robot of the piece, and beaten by none of a dense grid."""
    rng = np.random.default_rng(seed)
    piece, v = piece_row(rng), rng.normal(size=3) * rng.choice([0.0, 1.0, 1e6], 3)
    value, c, s, torque = best_on_piece.py_func(piece, v)
    angles = np.linspace(piece[4], piece[5], 2001)
    F = np.column_stack([np.cos(angles), np.sin(angles)])
    torques = [c_x * F[:, 1] - c_y * F[:, 0] for c_x, c_y in (piece[0:2], piece[2:4])]
    grid = max(float((F @ v[:2] + v[2] * t).max()) for t in torques)
    scale = 1e-12 * (1.0 + np.abs(v).sum()) * (1.0 + np.abs(piece).max())
    assert grid - scale <= value <= grid + 2e-6 * np.abs(v).sum() * 10.0 + scale
    assert value == pytest.approx(v @ [c, s, torque], abs=scale)
    assert np.hypot(c, s) == pytest.approx(1.0)
    past = (np.arctan2(s, c) - piece[4] + 1e-9) % (2.0 * np.pi)
    assert past <= piece[5] - piece[4] + 2e-9


@given(st.sampled_from(FAMILIES), seeds, st.integers(0, 30))
@settings(max_examples=100)
def test_the_quality_with_one_robot_more(family, seed, n):
    """As by summing anew over all facets of the larger swarm, wherever the robot is."""
    search = Search(Problem(swarm_of(family, seed, n), Newcomer()))
    rng = np.random.default_rng(seed)
    rows = search.rows[rng.integers(len(search.rows), size=20)]
    robots = robots_at(rows, *rng.choice([0.0, 0.3, 0.5, 1.0], (2, 20)))
    B = search.generators
    for value, robot in zip(search.qualities(robots), robots, strict=True):
        more = np.vstack([B, robot * search.weights])
        total = np.linalg.norm(more, axis=1).sum()
        assert value == pytest.approx(reference.quality(more), rel=1e-9, abs=2e-12 * total)


@pytest.mark.parametrize("family", ["along normals", "free", "ring", "giant", "balanced"])
@pytest.mark.parametrize("room", [0, 1, 5])
def test_bounds_hold_when_the_search_runs_out_of_room(family, room, monkeypatch):
    """With little or no room for normals an answer is coarse, and still proven."""
    for seed in range(8):
        problem = problem_of(family, seed, 8)
        (fine,) = place_sequence(problem, 1)
        with monkeypatch.context() as patch:
            patch.setattr(optimum, "POOL_ROOM", room)
            patch.setattr(optimum, "ROOM_PER_PIECE", 0)
            patch.setattr(optimum, "MOST_NORMALS", 0)
            (coarse,) = place_sequence(problem, 1)
        slack = 1e-12 * np.linalg.norm(fine.swarm_after.scaled_generators, axis=1).sum()
        assert coarse.quality <= fine.upper_bound * (1.0 + 1e-9) + slack
        assert coarse.upper_bound >= fine.quality * (1.0 - 1e-9) - slack
        assert coarse.verify()


def test_kernels_are_compiled_ahead_for_the_types_they_are_called_with():
    """One compiled version each, however it came about."""
    for module, kernel in ((facets, facets.list_facets), (kernels, kernels.solve)):
        module.compile_ahead()
        place_sequence(problem_of("free", 0, 6), 2)
        assert len(kernel.signatures) == 1
