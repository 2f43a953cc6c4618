"""`swarmgrasp quality`: how well the robots hold the object."""

from typing import TYPE_CHECKING, Any

from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.inputs import json_faults, json_text, print_json, put_json, read_scenario
from swarmgrasp.cli.report import told_written

if TYPE_CHECKING:
    from swarmgrasp.cli.report import Forces, Report
    from swarmgrasp.quality import Quality
    from swarmgrasp.scenario import Scenario
    from swarmgrasp.swarm import Swarm


def quality(file: Dashed, /, *, json: Dashed | None = None) -> None:
    """Tell how well the robots hold the object, and where worst.

    The quality is the force, in newtons, that the robots can exert in every direction,
    turning included: the worst direction decides. It is 0 without force closure.

    Example: swarmgrasp quality supply-vessel

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as
        supply-vessel. Its newcomer is left out.
    json
        Also write the numbers to this .json file; "-" prints them and nothing else.
        SI units.
    """
    scenario = read_scenario(file, json_faults(json))
    from swarmgrasp.quality import quality as quality_of

    found = quality_of(scenario.swarm)
    data = data_of(scenario, found)
    if json == DASH:
        print_json(json_text(data))
        return
    written = put_json(json, data)  # before the report, whose reader may leave
    show(scenario, found)
    told_written(written)


def data_of(scenario: "Scenario", found: "Quality") -> dict[str, Any]:
    """Return a quality as plain data, in SI units."""
    swarm = scenario.swarm
    return {
        "name": scenario.name,
        "quality": found.value,
        "force_closure": str(found.force_closure),
        "weakest_direction": found.direction.tolist(),
        "weakest_wrench": found.weakest_wrench.tolist(),
        "weakest_robots": [swarm.robot_label(i) for i in found.facet_robots],
        "efficiency": found.efficiency,
        "metric": {
            "force_weights": list(swarm.force_weights),
            "characteristic_length": swarm.characteristic_length,
        },
    }


def show(scenario: "Scenario", found: "Quality") -> None:
    """Write a quality for people."""
    from swarmgrasp.cli.report import NOTES, Forces, Report, percent

    report, swarm = Report(), scenario.swarm
    unit = Forces.for_size(found.value or max((r.limit for r in swarm.robots), default=0.0))
    held = found.value > 0.0
    report.headline(f"{scenario.name}: quality {unit.text(found.value)}", "good" if held else "bad")
    report.blank()
    weighted = "" if swarm.force_weights == (1.0, 1.0) else "weighted "
    share = percent(found.efficiency)
    facts = [
        ("Force closure", f"{found.force_closure}: {_CLOSURE[str(found.force_closure)]}"),
        *_weakest(swarm, found, unit),
    ]
    if len(swarm):
        facts.append((
            "Efficiency",
            f"{share} of {unit.text(found.ceiling)}, the {weighted}sum of the limits / pi, which "
            "these robots could not exceed wherever they were",
        ))  # fmt: skip
    report.facts(facts)
    _show_robots(report, swarm)
    report.blank()
    report.note(f"Metric: {swarm.metric_sentence}.")
    for note in NOTES:
        report.note(note)


_CLOSURE = {
    "yes": "the robots can push and turn the object in every direction",
    "no": "there are directions in which the robots can exert nothing",
    "marginal": "the slightest change of a pose decides whether the robots hold the object",
}


def _weakest(swarm: "Swarm", found: "Quality", unit: "Forces") -> list[tuple[str, str]]:
    """Tell the weakest wrench and the robots that define it."""
    if not len(swarm):
        return [("Weakest", "there are no robots")]
    from swarmgrasp.quality import wrench_words

    words = wrench_words(found.direction)
    if found.value > 0.0:
        x, y, turn = (float(v) for v in found.weakest_wrench)
        length = swarm.characteristic_length
        most_there = (
            f"the robots exert at most {unit.part(x, found.value)} along x, "
            f"{unit.part(y, found.value)} along y and "
            f"{unit.part(turn, found.value * length, ' m')} of torque at once"
        )
        facts = [("Weakest wrench", words), ("", most_there)]
    else:
        facts = [("Weakest wrench", f"{words}: the robots exert nothing that way")]
    if len(found.facet_robots) > 1:
        names = ", ".join(swarm.robot_label(i) for i in found.facet_robots)
        facts.append(("Set by", f"{names}: their wrenches span the weakest facet"))
    return facts


def _show_robots(report: "Report", swarm: "Swarm") -> None:
    """Write the table of robots."""
    if not len(swarm):
        return
    from swarmgrasp.cli.report import Column, Forces, Lengths
    from swarmgrasp.cli.words import degrees, stance

    unit = Forces.for_size(*(robot.limit for robot in swarm.robots))
    lengths = Lengths.for_outline(swarm.outline)
    columns = [
        Column("robot"),
        *(Column(text, is_number=True) for text in ("x [m]", "y [m]", "to [deg]")),
        Column(f"limit [{unit.name}]", is_number=True), Column("place"),
        Column("off the normal [deg]", is_spare=True),
    ]  # fmt: skip
    rows = []
    for index, robot in enumerate(swarm.robots):
        where, way = "on board", ""
        if not robot.mounted:
            placed = stance(swarm.outline, robot)
            where, way = placed.where, placed.short
        x, y = (lengths.number(v) for v in robot.contact)
        limit = unit.number(robot.limit)
        rows.append([swarm.robot_label(index), x, y, degrees(robot.direction), limit, where, way])
    report.blank()
    report.table(columns, rows)
