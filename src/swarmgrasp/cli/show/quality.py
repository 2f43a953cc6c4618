"""How `swarmgrasp quality` tells its answer."""

from collections.abc import Sequence
from dataclasses import replace

from swarmgrasp.cli.show.change import spot, telling_of, unit_of, xy_columns
from swarmgrasp.cli.show.held import Held, headline, held_of
from swarmgrasp.cli.show.report import Column, Mood, Report
from swarmgrasp.cli.show.sensitivities import show_sensitivities
from swarmgrasp.quality import Criterion, ForceClosure, Loss, Quality, Sensitivities
from swarmgrasp.quality import quality as quality_of
from swarmgrasp.quality.criterion import Load
from swarmgrasp.scenario import Scenario
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.force_words import force_words
from swarmgrasp.swarm.stance import stance
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms
from swarmgrasp.words import Unit, list_words, percent

POSES = "The worst poses"
"""The title of the table of robots as they are in the worst case."""
EQUAL = 1e-9
"""Relative difference of two qualities that is none."""


def show(
    scenario: Scenario,
    found: Quality,
    lost: Sequence[Loss],
    slopes: Sensitivities | None,
    terms: Terms,
    alone: Sequence[Loss] | None = None,
) -> None:
    """Write a quality for people.

    Parameters
    ----------
    scenario : Scenario
    found : Quality
    lost : sequence of Loss
        What the loss of each robot leaves, if the criterion is of a loss.
    slopes : Sensitivities, optional
    terms : Terms
    alone : sequence of Loss, optional
        What the loss of each leaves beside the load.
    """
    report, swarm, criterion = Report(), scenario.swarm, found.criterion
    tell = telling_of(terms, swarm, [found.upper_bound])
    held = None
    if criterion.has_load and found.choice is None:
        held = held_of(swarm, found, alone)
    _headline(report, scenario, found, held, tell)
    report.blank()
    facts = [
        *_kept(found, tell),
        *(_grade(found, tell) if held else []),
        *_beside(swarm, found, lost, tell),
        *_closure(swarm, found, tell),
        *_noise(found, unit_of(criterion, tell)),
        *(_missed(held, tell) if held else []),
        *_weakest(swarm, found, tell),
    ]
    if len(swarm) and criterion.is_nominal:
        facts.append(_efficiency(swarm, found, tell))
    report.facts(facts)
    if lost:
        _show_losses(report, swarm, lost, tell, unit_of(criterion, tell))
    if criterion.worst_case:
        _show_robots(report, found.worst_swarm, POSES, tell)
    _show_robots(report, swarm, _title(criterion, tell, bool(lost)), tell)
    if slopes is not None:
        show_sensitivities(report, slopes, tell)
    report.small_print(swarm, tell)


def _headline(
    report: Report, scenario: Scenario, found: Quality, held: Held | None, tell: Telling
) -> None:
    """Answer what was asked: whether the load is held if there is one, else the quality."""
    if held is not None:
        mood: Mood = "caution" if held.unheld or not found.value else "good"
        said = headline(scenario, held, tell)
        report.headline(f"{scenario.name}: {said}", "bad" if held.is_missed else mood)
        return
    words = found.criterion.words(scenario.swarm, tell.terms.robot)
    told = f"quality {_told(found, unit_of(found.criterion, tell))} {words}".rstrip()
    if found.force_closure is ForceClosure.MARGINAL and found.value <= found.noise:
        told += ", which the decimals of the outline do not tell from 0"
    elif found.criterion.task is not None and len(scenario.swarm):
        told += f", the least of it {found.weakest_words}"
    report.headline(
        f"{scenario.name}: {told}", "good" if max(found.value, found.bound) > found.noise else "bad"
    )


def _grade(found: Quality, tell: Telling) -> list[tuple[str, str]]:
    """Tell the quality by its criterion, where the headline tells whether a load is held."""
    words = found.criterion.words(found.worst_swarm, tell.terms.robot)
    return [("Quality", f"{_told(found, unit_of(found.criterion, tell))} {words}")]


def _closure(swarm: Swarm, found: Quality, tell: Telling) -> list[tuple[str, str]]:
    """Tell the force closure of the swarm as it stands, and of what is left in the worst case."""
    criterion = replace(found.criterion, load=(0.0, 0.0, 0.0))
    closure = found.force_closure
    said = f"{closure}: {_CLOSURE[str(closure)].format(tell.terms.several)}"
    facts = [("Force closure", said)]
    if criterion.is_of_worst:
        intact = quality_of(swarm).force_closure
        words = criterion.words(swarm, tell.terms.robot)
        facts = [("Force closure", f"intact {intact}; {words} {said}")]
    if closure is ForceClosure.NO and criterion.is_nominal and _is_vessel(swarm):
        facts.append(("", "if it is not to go every way, ask for what it is to do: "
                          "criterion: {task: {polytope: [[FX, FY, TZ], ...]}}"))  # fmt: skip
    return facts


def _is_vessel(swarm: Swarm) -> bool:
    """Tell whether there are thrusters on board, and nothing else."""
    return len(swarm) > 0 and bool(swarm.mounted.all())


def _missed(held: Held, tell: Telling) -> list[tuple[str, str]]:
    """Tell by how much a load is out of reach, and where it drives the object."""
    if not held.is_missed:
        return []
    short = tell.force.text(-held.alone.margin)
    left = _parts(held.alone.worst_swarm, (-held.alone.missing).tolist(), tell)
    return [("Out of reach", f"by {short} in the metric: {left} of torque are left over")]


def _told(found: Quality, unit: Unit) -> str:
    """Return the quality as text, or its bounds if robots may change between sectors."""
    if found.choice is None or unit.number(found.bound) == unit.number(found.upper_bound):
        return unit.text(found.upper_bound)
    return f"{unit.number(found.bound)} to {unit.text(found.upper_bound)}"


def _kept(found: Quality, tell: Telling) -> list[tuple[str, str]]:
    """Tell the sectors that robots with gaps between theirs keep, and what changing them may do."""
    if found.choice is None:
        return []
    unit, robots = unit_of(found.criterion, tell), tell.terms.several
    kept = "; ".join(f"{name} {tell.sector(at)}" for name, at in found.choice.sectors.items())
    known = "the best choice" if found.choice.is_best else "the best choice found"
    least, most = unit.text(found.bound), unit.text(found.upper_bound)
    return [
        ("Sectors kept", f"{kept}: {known}, which has {unit.text(found.value)}"),
        ("Changing them", f"from {least} to {most}, as {robots} may change between sectors"),
    ]


_CLOSURE = {
    "yes": "the {} can push and turn the object in every direction",
    "no": "there are directions in which the {} can exert nothing",
    "open": "no choice of one sector each gives it; whether changing sectors does is not known",
    "marginal": "rounding in the outline's coordinates decides whether the {} hold the object",
}


def _noise(found: Quality, unit: Unit) -> list[tuple[str, str]]:
    """Tell how far the outline's coordinates tell a quality that is below that."""
    if found.value > found.noise or found.noise == 0.0 or str(found.force_closure) == "no":
        return []
    decimals = "by the decimals of its coordinates the outline tells the quality"
    return [("", f"{decimals} to {unit.text(found.noise)} only")]


def _title(criterion: Criterion, tell: Telling, has_losses: bool) -> str:
    """Return the title of the robots' table, which other tables may stand before."""
    robots = f"The {tell.terms.several}"
    if criterion.worst_case:
        return f"{robots} as they are meant to be"
    return robots if has_losses else ""


def _efficiency(swarm: Swarm, found: Quality, tell: Telling) -> tuple[str, str]:
    """Tell how much of what the limits allow is reached."""
    weighted = "" if swarm.force_weights == (1.0, 1.0) else "weighted "
    what = f"the {weighted}sum of the limits / pi"
    if not swarm.has_rays_only:
        what = f"the {weighted}mean of their forces over all directions"
    return (
        "Efficiency",
        f"{percent(found.efficiency)} of {tell.force.text(found.ceiling)}, {what}, which these "
        f"{tell.terms.several} could not exceed wherever they were",
    )


def _worst_loss(found: Quality, lost: Sequence[Loss]) -> str:
    """Name the robots whose loss is worst, and those whose loss is as bad."""
    if found.criterion.losing == 1:
        least = _spare(found)
        close = least + EQUAL * abs(least)
        equal = [loss.name for loss in lost if _spare(loss.after) <= close]
        if len(equal) > 1:
            return f"{', '.join(equal[:-1])} or {equal[-1]}"
    names = ", ".join(found.lost)
    if len(found.lost) < found.criterion.losing:
        return f"{names}: that alone leaves nothing"
    return names


def _spare(found: Quality) -> float:
    """Return the quality, or by how much a load is missed [N]."""
    return found.value if found.criterion.task is not None else found.margin


def _beside(
    swarm: Swarm, found: Quality, lost: Sequence[Loss], tell: Telling
) -> list[tuple[str, str]]:
    """Tell what else the swarm can do, and who is lost, by a criterion."""
    criterion = found.criterion
    if criterion.is_nominal:
        return []
    plain = quality_of(swarm, load=criterion.load, task=criterion.task).value
    unit = unit_of(criterion, tell)
    facts = []
    if criterion.is_of_worst:
        facts.append(("As it stands", unit.text(plain)))
    if unit.text(found.bound) != unit.text(found.value):
        facts.append(("Certified", f"no less than {unit.text(found.bound)}"))
    if criterion.failures:
        facts.append(("Worst failure", list_words(found.failure)))
    if found.lost:
        facts.append(("Worst loss", _worst_loss(found, lost)))
    absent = [swarm.names[i] for i, t in swarm.tolerances.items() if t.may_be_absent]
    if criterion.worst_case and absent:
        facts.append(("Absent", ", ".join(absent)))
    if criterion.has_load:
        facts.append(("Load", f"{_parts(swarm, criterion.load, tell)} of torque on the object"))
    return facts


def _show_losses(
    report: Report, swarm: Swarm, lost: Sequence[Loss], tell: Telling, unit: Unit
) -> None:
    """Write the table of what the loss of each robot, or group, leaves."""
    columns = [
        Column("without"),
        Column(f"quality [{unit.name}]", is_number=True),
        Column("left", is_number=True),
        Column("weakest then"),
    ]
    rows = [
        [
            loss.name,
            unit.number(loss.quality),
            percent(loss.quality / loss.quality_before) if loss.quality_before else "",
            f"{'' if loss.quality else 'nothing: '}{loss.direction_words}",
        ]
        for loss in lost
    ]
    report.blank()
    report.headline(f"What the loss of each {tell.machines(1, bool(swarm.rare.groups))} leaves")
    report.table(columns, rows, "losses")


def _parts(swarm: Swarm, wrench: Load, tell: Telling) -> str:
    """Return the parts of a wrench [N, N, N m] in words, the torque last."""
    x, y, turn = tell.wrench([*wrench], swarm.characteristic_length)
    return f"{x} along x, {y} along y and {turn}"


def _weakest(swarm: Swarm, found: Quality, tell: Telling) -> list[tuple[str, str]]:
    """Tell the weakest wrench and the robots that define it."""
    if not len(swarm):
        return [("Weakest", f"there are no {tell.terms.several}")]
    robots = f"the {tell.terms.several}"

    words = found.weakest_words + (", keeping these sectors" if found.choice is not None else "")
    if found.value > 0.0:
        who = f"{robots} and load come to" if found.criterion.has_load else f"{robots} exert"
        told = _parts(swarm, found.weakest_wrench.tolist(), tell)
        facts = [("Weakest wrench", words), ("", f"{who} at most {told} of torque at once")]
    elif found.criterion.has_load and found.is_force_closure:
        facts = [("Weakest wrench", f"{words}: {robots} fall short most that way")]
    else:
        facts = [("Weakest wrench", f"{words}: {robots} exert nothing that way")]
    if len(found.facet_robots) > 1:
        names = ", ".join(found.facet_robots)
        facts.append(("Set by", f"{names}: their wrenches span the weakest facet"))
    return facts


def _show_robots(report: Report, swarm: Swarm, title: str, tell: Telling) -> None:
    """Write a table of robots."""
    if not len(swarm):
        return

    unit = tell.force
    has_forces, has_groups = not swarm.has_rays_only, bool(swarm.rare.groups)
    to = [Column(tell.way, is_number=True), Column(f"limit [{unit.name}]", is_number=True)]
    columns = [
        Column(tell.terms.robot),
        *xy_columns(tell),
        *([Column("forces")] if has_forces else to),
        *([Column("group")] if has_groups else []), Column("place"),
        Column("off the normal [deg]", is_spare=True),
    ]  # fmt: skip

    def row(name: str) -> list[str]:
        """Return what is told of a robot."""
        robot = swarm[name]
        x, y, _, to_deg, off = spot(swarm.outline, robot, tell)
        return [
            name, x, y,
            *([force_words(robot, tell)] if has_forces else [to_deg, unit.number(robot.limit)]),
            *([robot.group] if has_groups else []), stance(swarm.outline, robot).where, off,
        ]  # fmt: skip

    report.blank()
    if title:
        report.headline(title)
    report.table(columns, map(row, swarm.names), "worst poses" if title == POSES else "robots")
