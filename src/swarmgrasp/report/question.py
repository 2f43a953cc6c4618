"""What was asked, in words."""

from swarmgrasp.pages.page import Facts
from swarmgrasp.scenario import Scenario
from swarmgrasp.swarm.force_words import newcomer_words
from swarmgrasp.telling import Telling
from swarmgrasp.words import list_words

MOST_NAMED = 12
"""Robots, zones and stretches that are named."""


def question(scenario: Scenario, tell: Telling, weather: str) -> Facts:
    """Say what was asked: who holds the object, who is to come, where, and what counts as good.

    Parameters
    ----------
    scenario : Scenario
    tell : Telling
    weather : str
        The weather in which the object is to be held, in words; empty if that is not asked.
    """
    swarm, outline, criterion = scenario.swarm, scenario.swarm.outline, scenario.criterion
    corners = f"an outline of {len(outline.vertices)} vertices"
    asked = criterion.words(swarm, tell.terms.robot)
    rows = [
        ("Object", f"{corners}, {tell.length.text(outline.extent)} from corner to corner"),
        ("Held by", _named(tell.terms.robots(len(swarm)), list(swarm.names))),
    ]
    if scenario.newcomer is not None:
        rows += _newcomer(scenario, tell)
    rows.append(("Quality", f"what can be exerted in the worst direction {asked}".rstrip()))
    if criterion.task is not None:
        rows.append(("", "as a multiple of the task in the file"))
    return Facts([*rows, *([("To be held", weather)] if weather else [])])


def _newcomer(scenario: Scenario, tell: Telling) -> list[tuple[str, str]]:
    """Say who is to come, and where it may attach."""
    newcomer, zones, length = scenario.newcomer, scenario.zones, tell.length
    assert newcomer is not None
    called = newcomer.name or f"another {tell.terms.robot}"
    where = "anywhere on the boundary"
    if newcomer.mounted:
        where = "anywhere on board"
    if zones is not None:
        count = f"{len(zones)} {'zone' if len(zones) == 1 else 'zones'}"
        where = _named(count, [zone.name for zone in zones])
    rows = [("To come", f"{called}: {newcomer_words(newcomer, tell)}"), ("", f"in {where}")]
    if zones is None:
        rows[-1] = ("", where)
    if scenario.no_go:
        rows.append(("", f"not from {_some(_spans(scenario, tell))} along the outline"))
    if scenario.spacing:
        rows.append(("", f"at least {length.text(scenario.spacing)} from any other"))
    return rows


def _spans(scenario: Scenario, tell: Telling) -> list[str]:
    """Return between which arc lengths nobody may attach, the way round that the file counts."""
    perimeter, spans = scenario.swarm.outline.perimeter, []
    for stretch in scenario.no_go:
        ends = [tell.arc(arc, perimeter) for arc in (stretch.start, stretch.end)]
        first, last = reversed(ends) if tell.terms.frame.mirrored else ends
        spans.append(f"{tell.length.number(first)} to {tell.length.text(last)}")
    return spans


def _named(count: str, names: list[str]) -> str:
    """Return a number of things with their names."""
    return f"{count}: {_some(names)}" if names else count


def _some(parts: list[str]) -> str:
    """Name things, the first few of many."""
    more = len(parts) - MOST_NAMED
    return list_words([*parts[:MOST_NAMED], *([f"{more} more"] if more > 0 else [])])
