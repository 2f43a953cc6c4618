"""`swarmgrasp place --together`: several newcomers at the same time."""

from pathlib import Path

from swarmgrasp.cli.criteria import unit_for
from swarmgrasp.cli.gains import change, proven, show_robots
from swarmgrasp.cli.inputs import UsageFault, source_of
from swarmgrasp.cli.pictures import Picture
from swarmgrasp.cli.report import ALONG, NOTES, Mood, Report
from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.placement import Together, place_together
from swarmgrasp.quality import Criterion, quality
from swarmgrasp.scenario import Scenario


def solve(
    scenario: Scenario, file: str, robots: int, gap: float, effort: int, criterion: Criterion
) -> Together:
    """Place newcomers together.

    Raises
    ------
    UsageFault
        If the scenario leaves them no place.
    """
    try:
        return place_together(scenario.problem(criterion), robots, gap=gap, effort=effort)
    except SwarmGraspError as error:
        raise UsageFault(f"{source_of(file)}: {fault}" for fault in error.faults) from error


def show(name: str, found: Together) -> None:
    """Write an answer for people."""
    report, criterion = Report(), found.problem.criterion
    unit = unit_for(criterion, found.quality, found.upper_bound)
    best = "the best places" if found.is_optimal() else "the best found places"
    count = len(found.robots)
    many = f"{count} robots" if count > 1 else "1 robot"
    called = found.problem.newcomer.name or "newcomer"
    mood: Mood = "good" if found.improves else "caution"
    report.headline(f"{name}: {best} for {many} like {called}, all at once", mood)
    report.blank()
    facts = [("Quality", change(found.quality_before, found.quality, unit))]
    if criterion.words:
        facts.append(("", criterion.words))
    if found.sequential >= 0.0:
        facts.append(("One by one", f"{unit.text(found.sequential)}, each best given those before"))
    early = "; the effort was spent before the gap asked for" if found.stopped_early else ""
    told = proven("other places of so many", found.upper_bound, found.quality, unit)
    facts += [("Proven", told.replace(" is better", " are better") + early)]
    facts += [("Limit now" if found.improves else "Why", found.reason)]
    report.facts(facts)
    show_robots(report, found)
    report.blank()
    report.note(f"Metric: {found.problem.swarm.metric_sentence}.")
    for note in (*NOTES, ALONG):
        report.note(note)


def draw(found: Together, paths: dict[Picture, Path]) -> list[Path]:
    """Write the plan and the wrenches."""
    from swarmgrasp.plot import plan, save, wrench_sets

    criterion = found.problem.criterion
    after = found.swarm_after
    drawn = {
        paths["plan"]: plan(after, quality=quality(after, **criterion.terms)),
        paths["wrenches"]: wrench_sets(found.problem.swarm, after, criterion=criterion),
    }
    return [save(figure, path) for path, figure in drawn.items()]
