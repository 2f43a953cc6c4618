"""What a page is told of agents, from what listeners know: no network."""

import json
from typing import Any

import pytest

from swarmgrasp.agents.protocol import ProblemPlanner
from swarmgrasp.gui.live import SILENT, Live
from swarmgrasp.scenario import load_example


@pytest.fixture
def live() -> Live:
    scenario = load_example("deck-barge")
    return Live(ProblemPlanner(scenario.problem()), scenario.terms, None)


def robot(name: str, phase: str, **more: Any) -> dict[str, Any]:
    """Return a robot as a listener knows it."""
    place = {"x": 1.0, "y": 2.0, "direction": 0.5, "steers": 0.0}
    told = {
        "name": name, "incarnation": 1, "sequence": 1, "phase": phase, "ticket": 1, "arrival": 0.0,
        "place": place, "certified": 0.0, "gone": [], "running": True, "silent": 0.1,
        "confirmed_by": [],
    }  # fmt: skip
    return told | more


def known(*robots: dict[str, Any], **more: Any) -> dict[str, Any]:
    """Return what a listener knows."""
    told = {
        "mission": "", "robots": list(robots), "alone": [], "quality": 5e5, "certified": 0.0,
        "conflicts": [], "refused": 0,
    }  # fmt: skip
    return told | more


def told(live: Live, *each: dict[str, Any]) -> dict[str, Any] | None:
    """Return what is told when so much is known; None if nothing is."""
    frames: list[bytes] = []
    live._tell(list(each), lambda frame, _: frames.append(frame))
    return json.loads(frames[0]) if frames else None


def test_all_is_told_once_and_then_what_changes(live: Live) -> None:
    """Rows of those that changed; nothing while nothing does."""
    ajax, boreas = robot("Ajax", "attached"), robot("Boreas", "coming")
    first = told(live, known(ajax, boreas))
    assert first is not None
    assert first["whole"]
    assert [row["phase"] for row in first["robots"]] == ["holds", "coming"]
    assert told(live, known(ajax, boreas)) is None
    arrived = robot("Boreas", "arrived", sequence=2, confirmed_by=["Ajax"])
    then = told(live, known(ajax, arrived))
    assert then is not None
    assert not then["whole"]
    (row,) = then["robots"]
    assert (row["name"], row["phase"], row["confirmed"], row["of"]) == ("Boreas", "arrived", 1, 1)


def test_two_listeners_know_more_than_one(live: Live) -> None:
    """The later of two records counts, and the confirmations of both."""
    early = robot("Ajax", "coming", running=False, confirmed_by=["Castor"])
    late = robot("Ajax", "arrived", sequence=2, confirmed_by=["Dione"])
    frame = told(live, known(early), known(late))
    assert frame is not None
    (row,) = frame["robots"]
    assert (row["phase"], row["confirmed"]) == ("arrived", 2)


@pytest.mark.parametrize("change", [{"running": False}, {"silent": SILENT}, {"silent": None}])
def test_who_is_not_heard_is_not_shown_as_fine(live: Live, change: dict[str, Any]) -> None:
    """It does not answer; it holds the object all the same."""
    frame = told(live, known(robot("Ajax", "attached", **change)))
    assert frame is not None
    (row,) = frame["robots"]
    assert (row["phase"], row["there"]) == ("not answering", True)


def test_who_hears_whom_is_told_only_where_it_is_known(live: Live) -> None:
    """A listener does not know; in a demonstration it is asked of the processes."""
    frame = told(live, known(robot("Ajax", "attached"), robot("Boreas", "left")))
    assert frame is not None
    assert frame["cut"] is None
    rows = [(row["phase"], row["hears"], row["process"]) for row in frame["robots"]]
    assert rows == [("holds", None, None), ("left", None, None)]


def test_robots_without_a_process_hold_where_the_scenario_has_them(live: Live) -> None:
    """Those of the mission that nobody has heard of."""
    frame = told(live, known(alone=["Castor"]))
    assert frame is not None
    (row,) = frame["robots"]
    castor = load_example("deck-barge").swarm["Castor"]
    assert (row["name"], row["at"], row["there"]) == ("Castor", list(castor.contact), True)
    assert frame["first"] == {"text": "Holds 51\u00a0t every way", "good": True}


def test_what_is_certified_and_what_conflicts_is_told_in_words(live: Live) -> None:
    """As the robots certify it themselves."""
    frame = told(live, known(certified=2e5, conflicts=["Ajax and Boreas are too close"]))
    assert frame is not None
    assert frame["certified"] == 2e5
    assert frame["second"] == "20\u00a0t certified now, whatever the others do"
    assert frame["conflicts"] == ["Ajax and Boreas are too close"]
