"""Numbers for people: one unit for one quantity, whatever its values are."""

import re

import pytest

from swarmgrasp import Newcomer, Outline, Robot, Swarm, place
from swarmgrasp.words import Unit

SIZES = [3e-12, 4e-8, 2e-5, 3e-3, 0.5, 20.0, 4e3, 7e6]
NAMES = ["nN", "nN", "µN", "mN", "N", "N", "kN", "MN"]


@pytest.mark.parametrize(("size", "name"), list(zip(SIZES, NAMES, strict=True)))
def test_a_unit_suits_the_largest_value(size: float, name: str) -> None:
    """The others are told in it too, and nothing is nothing of a whole newton."""
    unit = Unit.for_size(0.001 * size, -size)
    assert unit.name == name
    assert unit.text(size).endswith(f" {name}")
    assert unit.text(0.001 * size).endswith(f" {name}")
    assert unit.text(0.0) == f"0 {name if unit.newtons >= 1.0 else 'N'}"


def test_an_explanation_has_one_prefix_for_all_qualities() -> None:
    """From below a million newtons to above it, before and after are told in meganewtons."""
    square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    ways = [((1, -0.4), 0.0), ((-1, 0.4), 3.14159), ((-0.4, 1), 1.5708), ((0.5, -1), -1.5708)]

    def answer_of(limit):
        swarm = Swarm(square, [Robot(contact, way, limit) for contact, way in ways])
        return place(swarm, Newcomer(limit), runners_up=0.5)

    small = answer_of(1.0)
    answer = answer_of(1e6 / (small.quality_before * small.quality) ** 0.5)
    assert answer.quality_before < 1e6 < answer.quality
    assert set(re.findall(r"[\d.]+ ([kMm]?N)\b(?! m)", answer.explanation)) == {"MN"}
