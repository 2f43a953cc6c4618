"""Generators given as arrays, right and wrong."""

import re

import numpy as np
import pytest

from swarmgrasp import Outline, Robot, Swarm, qualities
from swarmgrasp.errors import WrenchInvalid
from swarmgrasp.quality.generators import checked_generators

SWARM = Swarm(Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)]), [Robot((1, 0), 0.0)])


@pytest.mark.parametrize(
    ("given", "says"),
    [
        ("abc", [r"are 'abc'; they should be real numbers \(m, n, 3\)"]),
        (None, ["are None"]),
        ([SWARM, SWARM], ["should be real numbers"]),
        ([[[1, 2, 3], [4, 5]]], ["should be real numbers"]),
        (np.ones((1, 4, 3)) * 1j, ["should be real numbers"]),
        (np.ones((1, 3, 4)), [r"the shape \(1, 3, 4\); it should be \(m, n, 3\)"]),
        ([[[0, 0, 1e121]]], [r"generator 0 of swarm 0 is .* 0 or 1e-120 <= size <= 1e\+120"]),
        ([[[0, -1e-121, 0]]], ["generator 0 of swarm 0"]),
        ([[[0, 1, np.nan]], [[0, 0, -np.inf]]], ["swarm 0 is .*nan", "swarm 1 is .*-inf"]),
    ],
)
def test_what_is_no_array_of_generators_is_refused(given, says):
    """All faults of type and shape at once, or those of values."""
    with pytest.raises(WrenchInvalid) as caught:
        qualities(given)
    faults = caught.value.faults
    assert len(faults) == len(says)
    for fault, pattern in zip(faults, says, strict=True):
        assert re.search(pattern, fault)


def test_ten_generators_are_shown_and_the_others_counted():
    """Of a single swarm they have one number."""
    with pytest.raises(WrenchInvalid, match="generator 0 is ") as caught:
        checked_generators(np.full((1000, 3), np.nan), "(n, 3)")
    assert (len(caught.value.faults), caught.value.faults[-1]) == (11, "... and 990 more")


@pytest.mark.parametrize("good", [[[0, 0, 0]], [[True, 2, 3]], [[1e120, 1e-300, -1e120]]])
def test_what_is_in_range_is_kept(good):
    """As floats, whole numbers and zeros too."""
    found = checked_generators(good, "(n, 3)")
    assert (found.dtype, found.tolist()) == (float, np.array(good, float).tolist())
