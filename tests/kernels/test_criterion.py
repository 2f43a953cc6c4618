"""The criterion's kernel: what it refuses, and what bounds it must keep."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from strategies import seeds
from swarmgrasp.kernels.core import Criterion, Search

NO_ROWS, NO_TASK, UNIT, NO_LOAD = np.zeros((0, 12)), np.zeros((0, 3)), (1.0,) * 3, (0.0,) * 3


def box(robot, rng):
    """Return a row: a robot on an upright stretch that pushes aft, more or less."""
    x, y, turn, reach = rng.uniform(-1, 1), rng.uniform(-1, 1), rng.uniform(-3, 3), 0.2
    lo, hi = turn - reach, turn + reach
    arms = [x, y - reach, x, y + reach]
    return [robot, 1.0, *arms, lo, hi, np.cos(lo), np.sin(lo), np.cos(hi), np.sin(hi)]


def test_refuses_what_is_no_criterion():
    """Rows out of order or of the wrong width, numbers that are none, a negative loss."""
    points = np.ones((4, 3))
    rng = np.random.default_rng(0)
    for rows in (
        [box(1, rng)],
        [box(0, rng), box(2, rng)],
        [box(0, rng), box(1, rng), box(0, rng)],
    ):
        with pytest.raises(ValueError, match="sorted by robot"):
            Criterion(points, UNIT, np.array(rows), 0, NO_LOAD, NO_TASK, False)
    with pytest.raises(ValueError, match="rows of 12"):
        Criterion(points, UNIT, np.ones((1, 11)), 0, NO_LOAD, NO_TASK, False)
    with pytest.raises(ValueError, match="finite"):
        Criterion(points, UNIT, NO_ROWS, 0, (np.nan, 0.0, 0.0), NO_TASK, False)
    with pytest.raises(ValueError, match="0 or more"):
        Criterion(points, UNIT, NO_ROWS, -1, NO_LOAD, NO_TASK, False)
    with pytest.raises(TypeError, match="Criterion or None"):
        Search(points, UNIT, np.ones((1, 10)), NO_LOAD, 3)


@given(seeds, st.integers(0, 6), st.integers(0, 6), st.integers(0, 9))
def test_no_direction_is_below_the_least(seed, points, boxes, losing):
    """The least of a criterion is attained at its normal, and undercut at no other."""
    rng = np.random.default_rng(seed)
    known = rng.normal(size=(points, 3))
    rows = np.array([box(k, rng) for k in range(boxes)]).reshape(-1, 12)
    task = rng.normal(size=(3, 3))
    criterion = Criterion(known, UNIT, rows, losing, NO_LOAD, task, bool(seed % 2))
    value, normal, *_ = criterion.least(1e-7, np.inf)
    at = np.frombuffer(criterion.heights(np.array([normal])))
    assert value == pytest.approx(at[0] / at[2], rel=1e-9, abs=1e-11)
    trials = rng.normal(size=(300, 3))
    height, cap, extent = np.frombuffer(criterion.heights(trials)).reshape(-1, 3).T
    assert (height >= value * extent * (1.0 - 1e-6) - 1e-11).all()
    assert (cap >= height).all()
