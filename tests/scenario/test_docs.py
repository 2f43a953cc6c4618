"""The page on scenario files shows files that work."""

import re
from pathlib import Path

import pytest

from swarmgrasp.placement import Problem, place_sequence
from swarmgrasp.scenario import parse_scenario
from swarmgrasp.scenario.fields import FARTHEST, STRONGEST

PAGE = (Path(__file__).parents[2] / "docs" / "scenario.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("text", re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL))
def test_the_yaml_of_the_page_runs(text: str) -> None:
    """Every example loads, and its newcomer finds a place that the proof bears out."""
    scenario = parse_scenario(text, "docs/scenario.md")
    assert scenario.newcomer is not None
    problem = Problem(
        scenario.swarm,
        scenario.newcomer,
        scenario.zones,
        scenario.no_go,
        scenario.spacing,
        scenario.criterion,
    )
    (answer,) = place_sequence(problem, 1)
    assert answer.verify()


def test_the_largest_numbers_are_as_told() -> None:
    """The page and the schema agree."""
    found = re.search(r"distances up to (\S+), forces up to (\S+), in", PAGE)
    assert found is not None
    assert [float(number) for number in found.groups()] == [FARTHEST, STRONGEST]
