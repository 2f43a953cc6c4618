"""Lines that pull: where they run free of the object, and where they meet it."""

import math

import numpy as np
import pytest

from strategies import DOCK, L_SHAPE, RECTANGLE, twisted
from swarmgrasp import Outline
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
