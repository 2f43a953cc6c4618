"""Hundreds and thousands of robots in the page: bars in the place of arrows, and one in hand."""

import pytest

from paged import CROWDS, crowd
from swarmgrasp import Problem, place
from swarmgrasp.scenario import parse_scenario


@pytest.mark.parametrize(
    "count",
    [CROWDS[0], pytest.param(CROWDS[1], marks=[pytest.mark.long, pytest.mark.timeout(600)])],
)
def test_one_of_a_crowd_is_taken_in_hand(one, count):
    """By a press near its contact; the answer is the library's, and one undo brings it back."""
    one.page.set_default_timeout(120_000)
    try:
        one.open(f"Crowd of {count}")
        assert one.page.locator("canvas.crowd").is_visible()
        assert one.page.locator(".robot").count() == 0
        hull = one.page.locator(".hull").bounding_box()
        one.pull(hull["x"] + 0.6 * hull["width"], hull["y"] + hull["height"], -80, 12)
        doc = one.kept(f"crowd-{count}")["doc"]["problem"]
        before = parse_scenario(crowd(count)).problem()
        moved = [
            i
            for i, robot in enumerate(doc["swarm"]["robots"])
            if robot["contact"] != list(before.swarm.robots[i].contact)
        ]
        assert len(moved) == 1
        assert one.text(".inspect-name") == ""
        assert one.page.locator(".inspect-name").input_value() == f"R{moved[0] + 1}"
        found = place(Problem.from_data(doc))
        assert one.text(".figures .after") == f"{found.quality / 1e3:.0f}"
        assert one.text(".second") == f"with all {count + 1:_} working".replace(
            "_", "" if count < 10_000 else " "
        )
        one.press("Control+z")
        assert one.kept(f"crowd-{count}") is None
    finally:
        one.page.set_default_timeout(20_000)
