"""How `swarmgrasp place --together` tells its answer."""

from swarmgrasp.cli.show.change import change, proven, show_robots
from swarmgrasp.cli.show.report import ALONG, Mood, Report
from swarmgrasp.placement import Together


def show(name: str, found: Together) -> None:
    """Write an answer for people."""
    report, criterion = Report(), found.problem.criterion
    unit = criterion.unit(found.quality, found.upper_bound)
    best = "the best places" if found.is_optimal() else "the best found places"
    count = len(found.robots)
    many = f"{count} robots" if count > 1 else "1 robot"
    called = found.problem.newcomer.name or "newcomer"
    mood: Mood = "good" if found.improves else "caution"
    report.headline(f"{name}: {best} for {many} like {called}, all at once", mood)
    report.blank()
    facts = [("Quality", change(found.quality_before, found.quality, unit))]
    if words := criterion.words(found.problem.swarm):
        facts.append(("", words))
    if found.sequential >= 0.0:
        facts.append(("One by one", f"{unit.text(found.sequential)}, each best given those before"))
    early = "; the effort was spent before the gap asked for" if found.stopped_early else ""
    told = proven("other places of so many", found.upper_bound, found.quality, unit)
    facts += [("Proven", told.replace(" is better", " are better") + early)]
    facts += [("Limit now" if found.improves else "Why", found.reason)]
    report.facts(facts)
    show_robots(report, found)
    report.small_print(found.problem.swarm, ALONG)
