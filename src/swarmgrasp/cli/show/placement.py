"""How `swarmgrasp place` tells its answer."""

from collections.abc import Sequence

from swarmgrasp.cli.show.change import spot
from swarmgrasp.cli.show.report import ALONG, Column, Report
from swarmgrasp.placement import Placement
from swarmgrasp.quality import quality
from swarmgrasp.swarm import Robot
from swarmgrasp.swarm.force_words import force_words
from swarmgrasp.swarm.sectors import sector_words
from swarmgrasp.swarm.stance import Stance, stance
from swarmgrasp.words import Lengths, Unit, degrees, percent

FEWEST = 1e-12
"""Relative gap below which bound and answer count as equal."""
FINE = 1e-6
"""Relative gap, 0.0001 %, below which it is not told to the digit unless asked for."""
MOST_TOLD = 12
"""Runners-up of one newcomer that are told."""


def show(name: str, answers: Sequence[Placement]) -> None:
    """Write the answer for people.

    Parameters
    ----------
    name : str
        The scenario's.
    answers : sequence of Placement
        One newcomer, or several placed one after the other.
    """
    report = Report()
    criterion = answers[0].problem.criterion
    unit = criterion.unit(answers[-1].quality, answers[-1].upper_bound)
    if len(answers) == 1:
        _show_one(report, name, answers[0], unit)
    else:
        _show_sequence(report, name, answers, unit)
    _show_runners_up(report, answers, unit)
    report.small_print(answers[0].problem.swarm, ALONG)


def _show_one(report: Report, name: str, answer: Placement, unit: Unit) -> None:
    """Tell where one newcomer goes."""
    robot = answer.robot
    if answer.improves:
        best = "best found place" if answer.is_open else "the best place"
        report.headline(f"{name}: {best} for {robot.name}", "good")
        why = []
    else:
        none = "no place found" if answer.is_open else "no allowed place"
        report.headline(f"{name}: {none} for {robot.name} raises the quality", "caution")
        enough = max(2, answer.problem.fewest - len(answer.problem.swarm))
        why = [
            ("Why", answer.reason),
            (
                "Suggestion",
                f"{robot.name} adds nothing now; of all places this one prepares best for the "
                f"next robot (--robots {enough} goes on from here)",
            ),
        ]
    placed = _stance(answer)
    report.blank()
    report.facts(
        [
            *why,
            ("Where", _where(answer, placed)),
            ("", _spot(answer, placed)),
            *_way(robot, placed),
            (
                "Quality",
                _gain(answer.quality_before, answer.quality, unit)
                if answer.improves
                else f"stays {unit.text(answer.quality_before)}",
            ),
            *_kept(answer),
            *_beside(answer, answer, unit),
            ("Proven", _sure(answer, unit)),
            *([("Limit now", answer.reason)] if answer.improves else []),
        ]
    )  # fmt: skip


def _show_sequence(report: Report, name: str, answers: Sequence[Placement], unit: Unit) -> None:
    """Tell where several newcomers go, one row each."""
    first, last = answers[0], answers[-1]
    helps = last.quality > first.quality_before and any(a.improves for a in answers)
    called = first.problem.newcomer.name or "newcomer"
    report.headline(
        f"{name}: {len(answers)} robots like {called}, one after the other"
        + ("" if helps else ": no gain in quality"),
        "good" if helps else "caution",
    )
    report.blank()
    columns = [
        *(Column(text) for text in ("robot", "place")),
        *(Column(text, is_number=True) for text in ("x [m]", "y [m]")),
        Column("along [m]", is_number=True, is_spare=True),
        Column("to [deg]", is_number=True),
        Column(f"quality [{unit.name}]", is_number=True),
        Column("gain", is_number=True),
        Column("off the normal [deg]", is_spare=True),
    ]
    rows = []
    for answer in answers:
        *figures, off = spot(first.problem.swarm.outline, answer.robot)
        gain = _percent_gain(answer.quality_before, answer.quality) if answer.improves else "none"
        rows.append(
            [answer.robot.name, answer.place, *figures, unit.number(answer.quality), gain, off]
        )
    report.table(columns, rows)
    report.blank()
    worst = max(answers, key=lambda a: a.gap if a.quality else 0.0)
    report.facts([
        ("Quality", _gain(first.quality_before, last.quality, unit)),
        *_beside(first, last, unit),
        ("Proven", f"for each robot given those before it: {_sure(worst, unit, bound=False)}; "
                   "other places for all of them together may be better still"),
        ("Limit now" if last.improves else "Why no more", last.reason),
    ])  # fmt: skip


def _show_runners_up(report: Report, answers: Sequence[Placement], unit: Unit) -> None:
    """Tell the best robots in other places, for newcomers that help."""
    told = [answer for answer in answers if answer.improves and answer.runners_up]
    if not told:
        return
    several = len(answers) > 1
    columns = [
        *([Column("instead of")] if several else []), Column("place"),
        *(Column(text, is_number=True) for text in ("x [m]", "y [m]")),
        Column("along [m]", is_number=True, is_spare=True),
        Column("to [deg]", is_number=True),
        Column(f"quality [{unit.name}]", is_number=True),
        Column("of best", is_number=True), Column("off the normal [deg]", is_spare=True),
    ]  # fmt: skip
    rows, more = [], 0
    for answer in told:
        more += len(answer.runners_up[MOST_TOLD:])
        for runner in answer.runners_up[:MOST_TOLD]:
            *figures, off = spot(answer.problem.swarm.outline, runner.robot)
            instead_of = [answer.robot.name] if several else []
            share = f"{100.0 * runner.quality / answer.quality:.1f} %"
            reached = unit.number(runner.quality)
            rows.append([*instead_of, runner.place, *figures, reached, share, off])
    report.blank()
    best = "best found" if any(answer.is_open for answer in told) else "best"
    report.headline(f"Next best: the {best} robot on each other edge, side or zone")
    report.table(columns, rows)
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


def _spot(answer: Placement, placed: Stance) -> str:
    """Return the contact."""
    lengths = Lengths.for_extent(answer.problem.swarm.outline.extent)
    point = lengths.point(answer.robot.contact)
    if placed.arc_length is None:
        return f"contact {point}"
    return f"contact {point}, {lengths.number(placed.arc_length)} m along the outline"


def _way(robot: Robot, placed: Stance) -> list[tuple[str, str]]:
    """Return as facts which way a robot pushes and how hard."""
    way = f": {placed.way}" if placed.way else ""
    if not robot.is_ray:
        return [("Force", f"{force_words(robot)}{way}")]
    limit = Unit.for_size(robot.limit).text(robot.limit)
    return [
        ("Direction", f"{degrees(robot.direction)} deg{way}"),
        ("Force", f"{limit}, its limit"),
    ]


def _gain(before: float, after: float, unit: Unit) -> str:
    """Say how the quality changes."""
    if after <= before * (1.0 + FEWEST):
        return f"stays {unit.text(before)}"
    change = f"{unit.number(before)} -> {unit.text(after)}"
    return f"{change} ({_percent_gain(before, after)})"


def _kept(answer: Placement) -> list[tuple[str, str]]:
    """Tell the sectors that robots with gaps between theirs keep."""
    if answer.choice is None:
        return []
    each = answer.choice.sectors.items()
    kept = "; ".join(f"{name} {sector_words(sector)}" for name, sector in each)
    return [("Sectors kept", f"{kept}; robots may change sectors, which is not counted")]


def _beside(first: Placement, last: Placement, unit: Unit) -> list[tuple[str, str]]:
    """Say by what criterion the quality is meant, and how it changes as things stand."""
    criterion = first.problem.criterion
    words = criterion.words(first.problem.swarm)
    facts = [("", words)] if words else []
    if criterion.is_of_worst:
        before, after = (
            quality(swarm, load=criterion.load, task=criterion.task).value
            for swarm in (first.problem.swarm, last.swarm_after)
        )
        own = criterion.unit(before, after)
        facts.append(("As it stands", _gain(before, after, max(unit, own, key=_size))))
    return facts


def _size(unit: Unit) -> float:
    """Return the size of a unit [N]."""
    return unit.newtons


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
