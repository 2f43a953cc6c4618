"""How `swarmgrasp count` tells its answer."""

from swarmgrasp.cli.show.change import change, show_robots, telling_of, unit_of
from swarmgrasp.cli.show.report import Report
from swarmgrasp.placement import HowMany
from swarmgrasp.terms import Terms


def show(name: str, found: HowMany, terms: Terms, *, is_stopped: bool = False) -> None:
    """Write an answer for people; if Ctrl-C ended the search, say so."""
    report, problem, criterion = Report(), found.problem, found.problem.criterion
    tell = telling_of(terms, problem.swarm, [found.required], problem.newcomer)
    unit = unit_of(criterion, tell)
    wanted = unit.text(found.required)
    quality = change(found.quality_before, found.quality, unit)
    if found.count is None:
        many = terms.robots(found.most)
        failed = "is out of reach of" if found.is_proven else "was not reached with up to"
        report.headline(f"{name}: {wanted} {failed} {many}", "caution")
        quality = f"{unit.text(found.quality_before)} as it is"
    else:
        are = f"{terms.robots(found.count)} {'is' if found.count == 1 else 'are'}"
        word = "the fewest" if found.is_proven else "the fewest found"
        told = f"{are} {word} for {wanted}" if found.count else f"{wanted} is there"
        report.headline(f"{name}: {told}", "good")
    report.blank()
    facts = [("Quality", quality)]
    if words := criterion.words(problem.swarm, terms.robot):
        facts.append(("", words))
    early = "; Ctrl-C ended the search" if is_stopped else ""
    facts.append(("Proven" if found.is_proven else "Open", found.reason_in(terms) + early))
    if found.answer is not None:
        facts.append(("Limit then", found.answer.reason_in(terms)))
    report.facts(facts)
    if found.answer is not None:
        show_robots(report, found.answer, tell)
    report.small_print(problem.swarm, tell, tell.along())
