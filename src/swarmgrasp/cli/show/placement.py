"""How `swarmgrasp place` tells its answer."""

from collections.abc import Sequence

from swarmgrasp.cli.show.change import (
    room_facts,
    spot,
    spot_columns,
    telling_of,
    unit_of,
)
from swarmgrasp.cli.show.grounds import show_grounds
from swarmgrasp.cli.show.held import THE_LOAD, headline_with, misses
from swarmgrasp.cli.show.report import Column, Mood, Report
from swarmgrasp.placement import Placement
from swarmgrasp.placement.grounds import Ground
from swarmgrasp.quality import quality
from swarmgrasp.swarm import Robot
from swarmgrasp.swarm.force_words import force_words
from swarmgrasp.swarm.stance import Stance, stance
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms
from swarmgrasp.words import Unit, percent, trimmed

FEWEST = 1e-12
"""Relative gap below which bound and answer count as equal."""
FINE = 1e-6
"""Relative gap, 0.0001 %, below which it is not told to the digit unless asked for."""
WORTH = 1.001
"""Times a quality from which on a better one is worth a word."""
MOST_TOLD = 12
"""Runners-up of one newcomer that are told."""


def show(
    name: str,
    answers: Sequence[Placement],
    terms: Terms,
    survey: Sequence[Ground] = (),
    at_once: float = 0.0,
    asked: int = 1,
    weather: str = THE_LOAD,
) -> None:
    """Write the answer for people.

    Parameters
    ----------
    name : str
        The scenario's.
    answers : sequence of Placement
        One newcomer, or several placed one after the other.
    terms : Terms
        In which to tell it.
    survey : sequence of Ground
        Where the newcomer may attach and where not, if that is asked.
    at_once : float [N]
        What several reach that are placed all at once; 0 if that is not known.
    asked : int
        How many were to be placed; Ctrl-C ended the search after fewer.
    weather : str
        What a load is of.
    """
    report, problem = Report(), answers[0].problem
    tell = telling_of(terms, problem.swarm, [answers[-1].upper_bound], problem.newcomer)
    _show_headline(report, name, answers, weather, tell)
    if len(answers) == 1:
        _show_one(report, answers[0], tell)
    else:
        _show_sequence(report, answers, tell, at_once)
    if asked > len(answers):
        report.blank()
        report.sentence(f"Ctrl-C ended the search after {len(answers)} of {terms.robots(asked)}.")
    _show_runners_up(report, answers, tell)
    if survey:
        show_grounds(report, answers[0], survey, tell)
    report.small_print(problem.swarm, tell, tell.along())


def _show_headline(
    report: Report, name: str, answers: Sequence[Placement], weather: str, tell: Telling
) -> None:
    """Tell whether a load is held then, if there is one; else what was found."""
    last, several = answers[-1], tell.terms.robots(len(answers))
    criterion, called = last.problem.criterion, last.problem.newcomer.name or "newcomer"
    helps = last.quality > answers[0].quality_before and any(a.improves for a in answers)
    best = "best found place" if last.is_open else "best place"
    if criterion.has_load:
        who = f"{several} like {called}, one after the other"
        if len(answers) == 1:
            found = f"in the {best}" if helps else "where it prepares best"
            who = f"{last.robot.name} {found}"
        after = quality(last.swarm_after, **criterion.keywords)
        mood: Mood = "bad" if misses(after) else "good" if helps else "caution"
        report.headline(f"{name}: {headline_with(after, who, weather, tell)}", mood)
    elif len(answers) > 1:
        no_gain = "" if helps else ": no gain in quality"
        said = f"{several} like {called}, one after the other{no_gain}"
        report.headline(f"{name}: {said}", "good" if helps else "caution")
    elif helps:
        best = best if last.is_open else f"the {best}"
        report.headline(f"{name}: {best} for {last.robot.name}", "good")
    else:
        none = "no place found" if last.is_open else "no allowed place"
        report.headline(f"{name}: {none} for {last.robot.name} raises the quality", "caution")


def _show_one(report: Report, answer: Placement, tell: Telling) -> None:
    """Tell where one newcomer goes."""
    robot, unit = answer.robot, unit_of(answer.problem.criterion, tell)
    reason = answer.reason_in(tell.terms)
    why = []
    if not answer.improves:
        enough = max(2, answer.problem.fewest - len(answer.problem.swarm))
        why = [
            ("Why", reason),
            (
                "Suggestion",
                f"{robot.name} adds nothing now; of all places this one prepares best for the "
                f"next {tell.terms.robot} (--robots {enough} goes on from here)",
            ),
        ]
    report.blank()
    report.facts(
        [
            *why,
            *place_facts(answer, tell),
            (
                "Quality",
                _gain(answer.quality_before, answer.quality, unit)
                if answer.improves
                else f"stays {unit.text(answer.quality_before)}",
            ),
            *_kept(answer, tell),
            *_beside(answer, answer, tell),
            ("Proven", _sure(answer, unit)),
            *([("Limit now", reason)] if answer.improves else []),
        ]
    )  # fmt: skip


def place_facts(answer: Placement, tell: Telling) -> list[tuple[str, str]]:
    """Tell where a robot goes, and which way it pushes how hard."""
    placed = _stance(answer)
    return [
        ("Where", _where(answer, placed)),
        ("", _spot(answer, placed, tell)),
        *_way(answer.robot, placed, tell),
        *room_facts(answer.problem.newcomer, tell),
    ]


def _show_sequence(
    report: Report, answers: Sequence[Placement], tell: Telling, at_once: float
) -> None:
    """Tell where several newcomers go, one row each."""
    first, last = answers[0], answers[-1]
    unit = unit_of(first.problem.criterion, tell)
    report.blank()
    columns = [
        *(Column(text) for text in (tell.terms.robot, "place")),
        *spot_columns(tell),
        Column(f"quality [{unit.name}]", is_number=True),
        Column("gain", is_number=True),
        Column("off the normal [deg]", is_spare=True),
    ]
    rows = []
    for answer in answers:
        *figures, off = spot(first.problem.swarm.outline, answer.robot, tell)
        gain = _percent_gain(answer.quality_before, answer.quality) if answer.improves else "none"
        rows.append(
            [answer.robot.name, answer.place, *figures, unit.number(answer.quality), gain, off]
        )
    report.table(columns, rows, "robots")
    report.blank()
    worst = max(answers, key=lambda a: a.gap if a.quality else 0.0)
    report.facts([
        ("Quality", _gain(first.quality_before, last.quality, unit)),
        *_beside(first, last, tell),
        ("Proven", f"for each {tell.terms.robot} given those before it: "
                   f"{_sure(worst, unit, bound=False)}; other places for all of them together may "
                   "be better still"),
        *_together(last.quality, at_once, unit),
        ("Limit now" if last.improves else "Why no more", last.reason_in(tell.terms)),
    ])  # fmt: skip


def _together(quality: float, at_once: float, unit: Unit) -> list[tuple[str, str]]:
    """Say by how much placing them all at once is better, if it is."""
    if at_once <= quality * WORTH:
        return []
    times = f", {trimmed(at_once / quality, 3)} times as much" if quality else ""
    return [("All at once", f"{unit.text(at_once)} or more{times}: add --together")]


def _show_runners_up(report: Report, answers: Sequence[Placement], tell: Telling) -> None:
    """Tell the best robots in other places, for newcomers that help."""
    unit = unit_of(answers[0].problem.criterion, tell)
    told = [answer for answer in answers if answer.improves and answer.runners_up]
    if not told:
        return
    several = len(answers) > 1
    columns = [
        *([Column("instead of")] if several else []), Column("place"),
        *spot_columns(tell),
        Column(f"quality [{unit.name}]", is_number=True),
        Column("of best", is_number=True), Column("off the normal [deg]", is_spare=True),
    ]  # fmt: skip
    rows, more = [], 0
    for answer in told:
        more += len(answer.runners_up[MOST_TOLD:])
        for runner in answer.runners_up[:MOST_TOLD]:
            *figures, off = spot(answer.problem.swarm.outline, runner.robot, tell)
            instead_of = [answer.robot.name] if several else []
            share = f"{100.0 * runner.quality / answer.quality:.1f} %"
            reached = unit.number(runner.quality)
            rows.append([*instead_of, runner.place, *figures, reached, share, off])
    report.blank()
    best = "best found" if any(answer.is_open for answer in told) else "best"
    report.headline(f"Next best: the {best} {tell.terms.robot} on each other edge, side or zone")
    report.table(columns, rows, "next best")
    if more:
        report.note(f"... and {more} more; --json has them all.")


def _stance(answer: Placement) -> Stance:
    """Return how the robot of an answer stands."""
    return stance(answer.problem.swarm.outline, answer.robot)


def _where(answer: Placement, placed: Stance) -> str:
    """Return the place, and the edge when the place is a zone."""
    return (
        answer.place if placed.where == f"on {answer.place}" else f"{answer.place}, {placed.where}"
    )


def _spot(answer: Placement, placed: Stance, tell: Telling) -> str:
    """Return the contact."""
    point = tell.point(answer.robot.contact)
    if placed.arc_length is None:
        return f"contact {point}"
    arc = tell.arc(placed.arc_length, answer.problem.swarm.outline.perimeter)
    return f"contact {point}, {tell.length.text(arc)} along the outline"


def _way(robot: Robot, placed: Stance, tell: Telling) -> list[tuple[str, str]]:
    """Return as facts which way a robot pushes and how hard."""
    way = f": {placed.way}" if placed.way else ""
    if not robot.is_ray:
        return [("Force", f"{force_words(robot, tell)}{way}")]
    return [
        ("Direction", f"{tell.direction(robot.direction)}{way}"),
        ("Force", f"{tell.force.text(robot.limit)}, its limit"),
    ]


def _gain(before: float, after: float, unit: Unit) -> str:
    """Say how the quality changes."""
    if after <= before * (1.0 + FEWEST):
        return f"stays {unit.text(before)}"
    change = f"{unit.number(before)} -> {unit.text(after)}"
    return f"{change} ({_percent_gain(before, after)})"


def _kept(answer: Placement, tell: Telling) -> list[tuple[str, str]]:
    """Tell the sectors that robots with gaps between theirs keep."""
    if answer.choice is None:
        return []
    each = answer.choice.sectors.items()
    kept = "; ".join(f"{name} {tell.sector(sector)}" for name, sector in each)
    return [
        ("Sectors kept", f"{kept}; {tell.terms.several} may change sectors, which is not counted")
    ]


def _beside(first: Placement, last: Placement, tell: Telling) -> list[tuple[str, str]]:
    """Say by what criterion the quality is meant, and how it changes as things stand."""
    criterion = first.problem.criterion
    words = criterion.words(first.problem.swarm, tell.terms.robot)
    facts = [("", words)] if words else []
    if criterion.is_of_worst:
        before, after = (
            quality(swarm, load=criterion.load, task=criterion.task).value
            for swarm in (first.problem.swarm, last.swarm_after)
        )
        facts.append(("As it stands", _gain(before, after, unit_of(criterion, tell))))
    return facts


def _percent_gain(before: float, after: float) -> str:
    """Say by what share a quality grows."""
    if before == 0.0:
        return "from none" if after > 0.0 else "none"
    return f"+{percent(after / before - 1.0)}" if after > before else "none"


def _sure(answer: Placement, unit: Unit, *, bound: bool = True) -> str:
    """Say how far the answer can be from the best."""
    if answer.gap <= FEWEST:
        said = "no allowed place is better"
    else:
        said = (
            f"no allowed place is better by more than {_most(answer)}"
            if answer.quality
            else f"no allowed place exceeds {unit.text(answer.upper_bound)}"
        )
    early = "; the search stopped before the gap asked for" if answer.stopped_early else ""
    if answer.choice is not None:
        early = ", whatever sectors robots push in"
    return f"{said} (upper bound {unit.text(answer.upper_bound)}){early}" if bound else said + early


def _most(answer: Placement) -> str:
    """Say by what share another place may be better, at most."""
    return "0.0001 %" if answer.gap <= FINE <= answer.asked_gap else percent(answer.gap)
