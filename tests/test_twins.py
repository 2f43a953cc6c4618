"""Numbers of the search that its check has again, for it imports nothing of the search."""

import pytest

from swarmgrasp.kernels import core
from swarmgrasp.placement.pieces import SLIVER
from swarmgrasp.placement.place import RISE
from swarmgrasp.quality.robot_sets import UNSURE
from swarmgrasp.swarm.robot import SAME_ANGLE
from swarmgrasp.verify import boundary, judge, placement, recompute


@pytest.mark.parametrize(
    ("search", "check"),
    [
        (core.UNASKED, judge.UNASKED),
        (core.MARGINAL, recompute.ABSOLUTE),
        (SLIVER, boundary.SLIVER),
        (SAME_ANGLE, recompute.ANGLE),
        (RISE, placement.RISE),
        (UNSURE, placement.CERTIFIED),
    ],
)
def test_twins_agree(search, check):
    """What counts as none is one number on both sides."""
    assert search == check


def test_the_check_allows_for_what_the_search_rounds():
    """What the search lets rounding hide is less than what its check lets it hide."""
    assert core.UNASKED < judge.ROUNDED < core.FLOOR < placement.SETTLED < core.MARGINAL
