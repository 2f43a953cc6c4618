"""How far some direction opposes all robots."""

import math

import numpy as np
import pytest

import reference
from swarmgrasp.quality.opposed import opposition


@pytest.mark.parametrize("seed", range(12))
def test_no_direction_opposes_all_by_more(seed):
    """One opposes them by so much, none of many others does by more, and changes keep it so."""
    rng = np.random.default_rng(seed)
    generators = rng.normal((3.0, 0.0, 0.0), size=(6, 3))
    shares = rng.uniform(0.0, 1.0, 6)
    found = opposition(generators, shares)
    sizes = np.linalg.norm(generators, axis=1)
    directions = rng.uniform(-1.0, 1.0, (20_000, 3))
    margins = (-(directions @ generators.T) / (sizes * shares)).min(axis=1)
    assert 0.0 < margins.max() <= found <= 2.0 * margins.max()
    off = rng.normal(size=(50, 6, 3))
    off *= (found / math.sqrt(3.0) * shares * sizes)[:, None] / np.linalg.norm(
        off, axis=2, keepdims=True
    )
    assert all(reference.quality(generators + change) <= 1e-12 for change in off)


def test_of_few_and_of_flat_ones_it_is_infinite():
    """No change of one of them closes the grasp; robots all around leave nothing."""
    around = np.vstack([np.eye(3), -np.ones((1, 3))])
    assert opposition(around, np.ones(4)) == pytest.approx(0.0, abs=1e-9)
    assert opposition(around[:3], np.ones(3)) == math.inf
    flat = np.column_stack([np.cos(range(7)), np.sin(range(7)), np.zeros(7)])
    assert opposition(flat, np.ones(7)) == math.inf
