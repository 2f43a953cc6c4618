"""Sets of forces as the kernel takes them: what does not fit together is refused."""

import numpy as np
import pytest

from swarmgrasp.kernels import core

FULL_TURN = 2.0 * np.pi


def arguments(**changed):
    """Return two discs at (1, 0) and (-1, 0), but for what is changed."""
    given = {
        "arms": np.array([[1.0, 0.0], [-1.0, 0.0]]),
        "elements": np.array([[1.0, 0.0, 0.0, 0.0, FULL_TURN]] * 2),
        "counts": np.ones(2),
        "machines": np.arange(2.0),
        "scale": (1.0,) * 3,
        "losing": 0,
        "load": (0.0,) * 3,
        "task": np.zeros((0, 3)),
        "is_polytope": False,
        "parts": np.zeros((0, 5)),
        "poses": np.zeros((0, 12)),
        "failures": np.zeros((0, 2)),
    }
    return (given | changed).values()


def test_what_sets_are_worth():
    """H, D, the best forces, and a budget that is too small says so by the bound."""
    sets = core.Sets(*arguments())
    value, normal, bound, left = sets.least(1e-9, np.inf)
    assert value == pytest.approx(np.sqrt(2.0), rel=1e-9)
    assert value * (1.0 - 1.1e-9) <= bound <= value
    assert left < core.WORK + 1e6
    height, cap, extent = np.frombuffer(sets.heights(np.array([normal])))
    assert (height, cap, extent) == (pytest.approx(value), np.inf, pytest.approx(1.0))
    worths, *forces = np.frombuffer(sets.forces((0.0, 2.0, 0.0))).reshape(2, 5).T
    assert worths.tolist() == [2.0, 2.0]
    assert np.transpose(forces).tolist() == [[0.0, 1.0, 1.0, 0.0], [0.0, 1.0, -1.0, 0.0]]
    assert sets.least(1e-9, np.inf, 1.0)[2] == 0.0
    assert sets.least(1e-9, 0.5)[:2] == (0.5, (0.0, 0.0, 0.0))
    some = sets.least(1e-9, np.inf, 1e9, 2.0 * value)
    assert value <= some[0] < 2.0 * value
    assert some[2] == 0.0


@pytest.mark.parametrize(
    ("changed", "said"),
    [
        ({"arms": np.zeros((1, 2))}, "a count, a machine and failures for each arm"),
        ({"counts": np.ones(3)}, "a count, a machine and failures for each arm"),
        ({"failures": np.zeros((1, 3))}, "a count, a machine and failures for each arm"),
        ({"counts": np.array([1.0, 2.0])}, "counts should add up to the elements"),
        ({"counts": np.array([0.5, 1.5])}, "counts should be whole numbers"),
        ({"counts": np.array([3.0, -1.0])}, "counts should be whole numbers"),
        ({"machines": np.array([0.0, 2.0])}, "machines should be 0, 1, 2"),
        ({"elements": np.zeros((2, 4))}, "float64 in rows of 5"),
        ({"elements": np.full((2, 5), np.nan)}, "finite numbers"),
        ({"losing": -1}, "machines to lose should be 0 or more"),
        ({"scale": (1.0, np.inf, 1.0)}, "finite numbers"),
        ({"parts": np.array([[2.0, 0, 0, 0, 0]])}, "sorted by robot"),
        ({"parts": np.array([[1.0, 0, 0, 0, 0], [0.0, 0, 0, 0, 0]])}, "sorted by robot"),
        ({"poses": np.full((1, 12), -1.0)}, "limits should be 0 or more"),
    ],
)
def test_arrays_that_do_not_fit_together(changed, said):
    """They are refused, in words."""
    with pytest.raises(ValueError, match=said):
        core.Sets(*arguments(**changed))


def test_sets_take_no_keywords():
    """As all objects of the kernels."""
    with pytest.raises(TypeError, match="no keyword arguments"):
        core.Sets(*arguments(), work=1.0)
