"""How `swarmgrasp place --together` tells its answer."""

import math

from swarmgrasp.cli.show.change import change, proven, show_robots, telling_of, unit_of
from swarmgrasp.cli.show.held import THE_LOAD, headline_with, misses
from swarmgrasp.cli.show.report import Mood, Report
from swarmgrasp.placement import Problem, Together
from swarmgrasp.quality import quality
from swarmgrasp.terms import Terms


def so_far(problem: Problem, quality: float, bound: float, terms: Terms) -> str:
    """Say how far a search has come: the best quality and the bound."""
    tell = telling_of(terms, problem.swarm, [quality], problem.newcomer)
    unit = unit_of(problem.criterion, tell)
    most = f", at most {unit.text(bound)}" if math.isfinite(bound) else ""
    return f"{unit.text(quality)}{most}"


def show(
    name: str, found: Together, terms: Terms, *, is_stopped: bool = False, weather: str = THE_LOAD
) -> None:
    """Write an answer for people; if Ctrl-C ended the search, say so.

    A load is that of some weather.
    """
    report, problem, criterion = Report(), found.problem, found.problem.criterion
    tell = telling_of(terms, problem.swarm, [found.upper_bound], problem.newcomer)
    unit = unit_of(criterion, tell)
    best = "the best places" if found.is_optimal() else "the best found places"
    many = terms.robots(len(found.robots))
    called = problem.newcomer.name or "newcomer"
    mood: Mood = "good" if found.improves else "caution"
    said = f"{best} for {many} like {called}, all at once"
    if criterion.has_load:
        after = quality(found.swarm_after, **criterion.keywords)
        mood = "bad" if misses(after) else mood
        said = headline_with(after, f"{many} like {called} in {best}", weather, tell)
    report.headline(f"{name}: {said}", mood)
    report.blank()
    facts = [("Quality", change(found.quality_before, found.quality, unit))]
    if words := criterion.words(problem.swarm, terms.robot):
        facts.append(("", words))
    if found.sequential >= 0.0:
        facts.append(("One by one", f"{unit.text(found.sequential)}, each best given those before"))
    early = "; the effort was spent before the gap asked for" if found.stopped_early else ""
    early = "; Ctrl-C ended the search before the gap asked for" if is_stopped else early
    told = proven("other places of so many", found.upper_bound, found.quality, unit)
    facts += [("Proven", told.replace(" is better", " are better") + early)]
    facts += [("Limit now" if found.improves else "Why", found.reason_in(terms))]
    report.facts(facts)
    show_robots(report, found, tell)
    report.small_print(problem.swarm, tell, tell.along())
