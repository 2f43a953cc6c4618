"""How `swarmgrasp count` tells its answer."""

from swarmgrasp.cli.show.change import change, show_robots
from swarmgrasp.cli.show.report import ALONG, Report
from swarmgrasp.placement import HowMany


def show(name: str, found: HowMany) -> None:
    """Write an answer for people."""
    report, criterion = Report(), found.problem.criterion
    unit = criterion.unit(found.required, found.quality)
    wanted = unit.text(found.required)
    quality = change(found.quality_before, found.quality, unit)
    if found.count is None:
        many = f"{found.most} robot{'s' if found.most > 1 else ''}"
        failed = "is out of reach of" if found.is_proven else "was not reached with up to"
        report.headline(f"{name}: {wanted} {failed} {many}", "caution")
        quality = f"{unit.text(found.quality_before)} as it is"
    else:
        are = "robot is" if found.count == 1 else "robots are"
        word = "the fewest" if found.is_proven else "the fewest found"
        told = f"{found.count} {are} {word} for {wanted}" if found.count else f"{wanted} is there"
        report.headline(f"{name}: {told}", "good")
    report.blank()
    facts = [("Quality", quality)]
    if words := criterion.words(found.problem.swarm):
        facts.append(("", words))
    facts.append(("Proven" if found.is_proven else "Open", found.reason))
    if found.answer is not None:
        facts.append(("Limit then", found.answer.reason))
    report.facts(facts)
    if found.answer is not None:
        show_robots(report, found.answer)
    report.small_print(found.problem.swarm, ALONG)
