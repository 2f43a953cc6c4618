"""Lines that pull: where they run free of the object, and where they meet it."""

import math

import numpy as np
import pytest

from strategies import DOCK, L_SHAPE, RECTANGLE, twisted
from swarmgrasp import Newcomer, Outline, Robot, Swarm, Zone, place
from swarmgrasp.outline.lines import FINEST, free_cells, meeting


def test_a_line_from_inside_a_dock_meets_its_bottom():
    """Where, on which edge, and after how many metres."""
    met = meeting(Outline(DOCK), (12.96, 14.0), math.radians(-150.0))
    assert met.point == pytest.approx((-24.0, -7.338866))
    assert (met.edge, met.distance) == (3, pytest.approx(42.677732))


def test_a_line_that_grazes_a_corner_runs_free():
    """It touches, and no more; a hair inward it meets."""
    dock = Outline(DOCK)
    past_the_corner = math.atan2(14.0 + 14.0, 30.0 - 0.0)
    assert meeting(dock, (0.0, -14.0), past_the_corner) is None
    assert meeting(dock, (0.0, -14.0), past_the_corner + 1e-4).edge == 4


def test_a_convex_outline_has_no_cells():
    """All lines outward run free, from every edge; of an L, from all but two."""
    assert free_cells(Outline(RECTANGLE)) == (None,) * 4
    assert [cells is None for cells in free_cells(Outline(L_SHAPE))] == [
        True, True, False, False, True, True
    ]  # fmt: skip


@pytest.mark.parametrize("seed", range(12))
def test_cells_tell_what_is_free(seed):
    """A line in a cell's window meets nothing; one well outside does, but for short cells."""
    rng = np.random.default_rng(seed)
    outline = twisted(rng)
    for edge, cells in enumerate(free_cells(outline)):
        p, q = outline.edge_ends(edge)
        for share, turn in zip(
            rng.uniform(0.01, 0.99, 8), rng.uniform(-1.57, 1.57, 8), strict=True
        ):
            point, at = tuple((p + share * (q - p)).tolist()), share * outline.lengths[edge]
            here = [cell for cell in cells or () if cell.start <= at <= cell.end]
            is_free = meeting(outline, point, outline.inward_normal(edge) + math.pi + turn) is None
            if cells is None or any(cell.lo <= turn <= cell.hi for cell in here):
                assert is_free
            elif is_free:
                assert any(
                    min(abs(turn - cell.lo), abs(turn - cell.hi)) <= FINEST
                    or cell.end - cell.start < 0.01 * outline.lengths[edge]
                    for cell in here
                )


def test_a_line_finds_its_way_through_a_neck():
    """From the middle of a flask's floor, though none does from the ends of its parts."""
    right = [(0.1, 20), (0.1, 3), (2, 3), (2, 1)]
    left = [(-x, y) for x, y in reversed(right)]
    flask = Outline([(-3, 0), (3, 0), (3, 20), *right, *left, (-3, 20)])
    assert meeting(flask, (0.0, 1.0), math.pi / 2) is None
    floor = free_cells(flask)[6]
    assert any(cell.start <= 2.0 <= cell.end and cell.lo <= 0.0 <= cell.hi for cell in floor)
    swarm = Swarm(flask, [Robot((0.0, 0.0), math.pi / 2)])
    zone = Zone(flask.stretch(6, 1.0, 3.0))
    assert place(swarm, Newcomer(1.0, "pull", 0.3), [zone]).verify()


def test_a_line_along_a_wall_only_touches():
    """From an inner corner along an edge, and past the end of one."""
    assert meeting(Outline(DOCK), (-24.0, -14.0), 0.0) is None
