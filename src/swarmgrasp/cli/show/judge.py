"""How `swarmgrasp judge` tells what MuJoCo says."""

import math

from swarmgrasp.cli.show.change import telling_of, unit_of
from swarmgrasp.cli.show.report import Column, Report, metric_note
from swarmgrasp.simulation.mujoco import Judgement
from swarmgrasp.swarm import Swarm
from swarmgrasp.terms import Terms
from swarmgrasp.words import digits, percent, trimmed

ROUNDING = 1e-9
"""Of the object's extent, or of a radian: a motion that is none."""


def show(name: str, swarm: Swarm, found: Judgement, terms: Terms) -> None:
    """Write a judgement for people."""
    report, quality = Report(), found.quality
    tell = telling_of(terms, swarm, [quality.value])
    unit = unit_of(quality.criterion, tell)
    words = quality.criterion.words(swarm, terms.robot)
    held = " ".join(filter(None, [unit.text(quality.value), "is held", words]))
    comma = "," if words else ""
    if found:
        report.headline(f"{name}: MuJoCo agrees: {held}{comma} and 1 % more is not", "good")
    else:
        report.headline(f"{name}: MuJoCo does not agree that {held}{comma} and no more", "bad")
    report.blank()
    report.facts([
        ("Judge", f"MuJoCo {found.version}, {found.duration:.3g} s for each disturbance"),
        ("Object", f"{digits(found.hull.mass, found.hull.mass)} kg, in no water and no wind"),
        ("Disturbance", f"against the weakest wrench: {quality.weakest_words}"),
        *([("Without", ", ".join(quality.gone))] if quality.gone else []),
    ])  # fmt: skip
    report.blank()
    size = max(trial.net for trial in found.trials)
    force, length = tell.force, tell.length
    columns = [
        Column("of the quality", is_number=True), Column("held"),
        Column(f"left over [{force.name}]", is_number=True),
        Column(f"moved by [{length.name}]", is_number=True),
        Column("turned by [deg]", is_number=True),
    ]  # fmt: skip
    report.table(columns, [
        [
            percent(trial.factor), "yes" if trial.is_held else "no",
            force.part(trial.net, size).split()[0],
            trimmed(_seen(trial.distance, swarm.outline.extent) / length.metres, 2),
            trimmed(math.degrees(_seen(trial.turn, 1.0)), 2),
        ]
        for trial in found.trials
    ], "disturbances")  # fmt: skip
    report.blank()
    report.note("Left over: force and torque that act on the object at the start, in the metric.")
    for note in (metric_note(swarm, tell), *tell.notes()):
        report.note(note)


def _seen(moved: float, whole: float) -> float:
    """Return how far something moved; what is rounding beside the whole is nothing."""
    return moved if moved > ROUNDING * whole else 0.0
