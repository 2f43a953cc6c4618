"""The page on scenario files shows files that work."""

import re
import runpy
from pathlib import Path

import pytest

from swarmgrasp.placement import Problem, place_sequence
from swarmgrasp.scenario import parse_scenario
from swarmgrasp.scenario.fields import FARTHEST, STRONGEST, WIDEST
from swarmgrasp.units import PLAIN, canonical

DOCS = Path(__file__).parents[2] / "docs"
PAGE = (DOCS / "scenario.md").read_text(encoding="utf-8")


@pytest.mark.parametrize("text", re.findall(r"```yaml\n(.*?)```", PAGE, re.DOTALL))
def test_the_yaml_of_the_page_runs(text: str) -> None:
    """Every example loads, and its newcomer finds a place that the proof bears out."""
    scenario = parse_scenario(text, "docs/scenario.md")
    assert scenario.warnings == ()
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
    found = re.search(r"distances up to (\S+), areas up to (\S+), forces up to (\S+), in", PAGE)
    assert found is not None
    assert [float(number) for number in found.groups()] == [FARTHEST, WIDEST, STRONGEST]


def test_the_picture_of_the_page_is_what_is_read() -> None:
    """The script beside it draws it again from what the program reads."""
    drawn = runpy.run_path(str(DOCS / "images" / "scenario_frame.py"))["picture"]()
    assert drawn == (DOCS / "images" / "scenario-frame.svg").read_text(encoding="utf-8")


def test_every_unit_on_the_page_is_read() -> None:
    """Each name of the table is one of the quantity it stands for."""
    rows = re.findall(r"\| `(length|force|angle|speed)` \| ([^|]+) \|", PAGE)
    assert len(rows) == 4
    for quantity, names in rows:
        told = [canonical(name.strip(), quantity) for name in re.split("[,;]", names)]
        assert None not in told
        assert set(told) >= PLAIN[quantity].keys()
