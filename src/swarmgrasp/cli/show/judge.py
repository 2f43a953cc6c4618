"""How `swarmgrasp judge` tells what MuJoCo says."""

import math

from swarmgrasp.cli.show.report import Column, Report
from swarmgrasp.simulation.mujoco import Judgement
from swarmgrasp.swarm import Swarm
from swarmgrasp.words import Unit, digits, percent


def show(name: str, swarm: Swarm, found: Judgement) -> None:
    """Write a judgement for people."""
    report, quality = Report(), found.quality
    unit = quality.criterion.unit(quality.value)
    words = quality.criterion.words(swarm)
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
    force = Unit.for_size(size)
    columns = [
        Column("of the quality", is_number=True), Column("held"),
        Column(f"left over [{force.name}]", is_number=True), Column("moved by [m]", is_number=True),
        Column("turned by [deg]", is_number=True),
    ]  # fmt: skip
    report.table(columns, [
        [
            percent(trial.factor), "yes" if trial.is_held else "no",
            force.part(trial.net, size).split()[0], f"{trial.distance:.2g}",
            f"{math.degrees(trial.turn):.2g}",
        ]
        for trial in found.trials
    ])  # fmt: skip
    report.blank()
    report.note("Left over: force and torque that act on the object at the start, in the metric.")
    report.note(f"Metric: {swarm.metric_sentence}.")
