"""What was asked, in words."""

from swarmgrasp.outline import Outline
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
    swarm, criterion = scenario.swarm, scenario.criterion
    asked = criterion.words(swarm, tell.terms.robot)
    rows = [
        ("Object", f"an outline of {_size(swarm.outline, tell)}"),
        ("Held by", _named(tell.terms.robots(len(swarm)), list(swarm.names))),
    ]
    if scenario.newcomer is not None:
        rows += _newcomer(scenario, tell)
    rows.append(("Quality", f"what can be exerted in the worst direction {asked}".rstrip()))
    if criterion.task is not None:
        rows.append(("", "as a multiple of the task in the file"))
    return Facts([*rows, *([("To be held", weather)] if weather else [])])


def outline_facts(outline: Outline, tell: Telling) -> Facts:
    """Say how large an outline is, and about which point moments are taken.

    Parameters
    ----------
    outline : Outline
    tell : Telling
    """
    names = [name for name in outline.edge_names if name]
    rows = [
        ("Size", _size(outline, tell)),
        ("Area", tell.area(outline.area)),
        ("Perimeter", tell.length.text(outline.perimeter)),
        ("Moments about", tell.point(outline.origin.tolist())),
    ]
    return Facts([*rows, *([("Edges", _some(names))] if names else [])])


def _size(outline: Outline, tell: Telling) -> str:
    """Say how many vertices an outline has, and how far apart they are."""
    far = tell.length.text(outline.extent)
    return f"{len(outline.vertices)} vertices, {far} from corner to corner"


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
    if newcomer.body:
        rows.append(("", tell.room(newcomer.body.length, newcomer.body.beam)))
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
