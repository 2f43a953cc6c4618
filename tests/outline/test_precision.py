"""The rounding that an outline carries by its decimals."""

import math

import numpy as np
import pytest

from cases import rounded_tank
from swarmgrasp.errors import OutlineInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.scenario import parse_scenario

CHAMFERED = [(0.0, 0.0), (10.192, 0.0), (12.192, 2.0), (12.192, 6.0), (0.0, 6.0)]


@pytest.mark.parametrize(
    ("corners", "precision"),
    [
        ([(0, 0), (4, 0), (4, 2), (0, 2)], 0.0),
        ([(0.5, 0), (40.25, 0), (40.25, 12.75), (3, 12.75)], 0.0),  # a design
        ([(0, 0), (0.375, 0), (0.5, 0.125), (0, 0.25)], 0.0),  # a small one, on a grid
        (CHAMFERED, 0.0005),
        (np.array(CHAMFERED) * 0.3048, 0.0),  # computed
        (rounded_tank(360, 0, 2).outline.vertices, 0.005),
        (rounded_tank(360, 0, 9).outline.vertices, 0.5e-9),
        (rounded_tank(360, 0, 15).outline.vertices, 0.0),
    ],
)
def test_precision_is_half_a_unit_in_the_last_decimal(corners, precision):
    """Of rounded coordinates; those of designs and computations are exact."""
    assert Outline(corners).precision == precision


def test_precision_is_of_the_numbers_as_written_in_the_file():
    """Feet with three decimals are known to half a thousandth of a foot."""
    vertices = [list(corner) for corner in CHAMFERED]
    text = f"units: {{length: ft}}\noutline: {{vertices: {vertices}}}\nrobots: []"
    assert parse_scenario(text).swarm.outline.precision == pytest.approx(0.0005 * 0.3048)


def test_only_oblique_edges_have_normals_that_may_be_off():
    """Both ends of the others carry the same number."""
    outline = Outline(CHAMFERED, precision=0.01)
    assert np.flatnonzero(outline.normal_errors).tolist() == [1]
    x, y = np.subtract(CHAMFERED[2], CHAMFERED[1])
    turned = math.atan2(y + 0.02, x - 0.02) - math.pi / 4
    assert turned == pytest.approx(outline.normal_errors[1], rel=1e-3)  # the farthest


@pytest.mark.parametrize("precision", [-1e-3, math.nan, math.inf, "1 mm"])
def test_a_precision_is_a_length(precision):
    """Finite and not negative."""
    with pytest.raises(OutlineInvalid, match=r"the precision is .*; it should be 0 <= precision"):
        Outline(CHAMFERED, precision=precision)
