"""How `swarmgrasp simulate` tells its answer."""

import math
from dataclasses import replace

from swarmgrasp.cli.show.all_round import clockwise_note
from swarmgrasp.cli.show.change import telling_of
from swarmgrasp.cli.show.report import Column, Mood, Report, metric_note
from swarmgrasp.simulation.run import Happening, Run
from swarmgrasp.simulation.sentences import from_text
from swarmgrasp.simulation.verdict import Circle, Verdict
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms
from swarmgrasp.words import digits, percent, plain_seconds, span, trimmed

AFTER = ("lost", "left", "weather", "start")
"""Kinds of happenings after which the load may be out of reach."""


def show(name: str, run: Run, verdict: Verdict, terms: Terms) -> None:
    """Write a run for people."""
    report, swarm = Report(), run.simulation.problem.swarm
    tell = _telling(run, verdict, terms)
    report.headline(f"{name}: {_headline(run, verdict, tell)}", _mood(run, verdict))
    report.blank()
    report.facts(_facts(run, verdict, tell))
    report.blank()
    _show_happenings(report, run, verdict, tell)
    report.blank()
    far = tell.length.short(verdict.within)
    limits = f"{far} or {math.degrees(verdict.within_turn):.3g} deg"
    for note in (
        f"Held: never off by more than {limits}. Off by, turned: the largest until the next line, "
        "and what 95 % of the time is within.",
        f"Margin: what the {terms.several} can exert in any direction beside the mean load; below "
        "0, how far that is out of reach.",
        f"Foretold: how long the missing part of the mean load takes to move the object {limits}.",
        clockwise_note(tell, " at the start"),
        f"The loads are those of the environment: this tries {terms.several} and control, no "
        "coefficients.",
        metric_note(swarm, tell),
        tell.notes()[0],
    ):
        report.note(note)


def _telling(run: Run, verdict: Verdict, terms: Terms) -> Telling:
    """Choose how to tell a run: three digits are enough."""
    sizes = [at.margin + at.shortfall for at in run.happenings] + [float(verdict.spreads[0])]
    tell = telling_of(terms, run.simulation.problem.swarm, sizes)
    return replace(tell, force=replace(tell.force, figures=3))


def _mood(run: Run, verdict: Verdict) -> Mood:
    """Return the mood of the headline."""
    if not verdict.held.all():
        return "bad"
    return "good" if run.is_whole else "caution"


def _headline(run: Run, verdict: Verdict, tell: Telling) -> str:
    """Say whether the object was held, and within what."""
    end, whole = span(float(run.times[-1])), span(run.simulation.duration)
    far = max(float(c.distance[0]) for c in verdict.circles)
    turned = max(float(c.turn[0]) for c in verdict.circles)
    within = f"{_far(far, tell)} and {_degrees(turned)}"
    if verdict.held.all():
        when = f"for {end}" if run.is_whole else f"until it was stopped at {end} of {whole}"
        return f"held within {within} {when}"
    at = float(verdict.left_at[0])
    cause = [h for h in run.happenings if h.time <= at and h.kind in AFTER][-1]
    since = f", {span(at - cause.time)} after {_cause(cause)}" if cause.kind != "start" else ""
    if cause.shortfall:
        since += f", {tell.force.text(cause.shortfall)} out of reach"
    off = run.poses[0, -1].astype(float) - run.references[-1]
    now = (
        f"{_far(math.hypot(off[0], off[1]), tell)} and {_degrees(math.remainder(off[2], math.tau))}"
    )
    later = f"; off by {within} at most, {now} at {end}"
    stopped = "" if run.is_whole else f"; stopped at {end} of {whole}"
    return f"not held from {span(at)} on{since}{later}{stopped}"


def _cause(at: Happening) -> str:
    """Say what changed."""
    words = {"lost": "is lost", "left": "leaves"}
    return f"{at.robot} {words[at.kind]}" if at.kind in words else "the weather changes"


def _facts(run: Run, verdict: Verdict, tell: Telling) -> list[tuple[str, str]]:
    """Tell the weather that acts, the margin, and what the robots do."""
    start, unit = run.happenings[0], tell.force
    margin = f"{unit.text(start.margin)} beside the mean load at the start"
    if start.shortfall:
        margin = f"none: the mean load is out of reach by {unit.text(start.shortfall)}"
    elif math.isfinite(verdict.margins_over_spread[0]):
        times = trimmed(float(verdict.margins_over_spread[0]), 2)
        spread = unit.text(float(verdict.spreads[0]))
        margin += f", {times} times the standard deviation of the gusts' load, {spread}"
    share, use = float(verdict.largest_share[0]), float(verdict.use[0])
    facts = [
        ("Wind", _wind_words(run, tell)),
        ("Current", _current_words(run, tell)),
        ("Margin", margin),
        (
            "Thrust",
            f"largest share {share:.2f} of a limit, {use:.2f} at the mean; forces change by "
            f"{digits(float(verdict.activity[0]), float(verdict.activity[0]), 2)} limits a second",
        ),
    ]
    if math.isfinite(verdict.least_excess):
        facts.append(("Length", _length_words(verdict.least_excess)))
    return facts


def _length_words(excess: float) -> str:
    """Tell which loads out of reach a run of this length would have shown."""
    if excess > 1.0:
        return "too short a run to tell even a load twice as large as the robots can hold"
    return f"a run so long tells a load that is {percent(excess)} beyond reach, or more"


def _wind_words(run: Run, tell: Telling) -> str:
    """Tell the wind that acts, and how much it varies."""
    asked = run.simulation
    spread = float(run.gusts[0])
    gusts = f", gusts of standard deviation {tell.speed(spread)}" if spread else ", no gusts"
    wind = asked.environment.wind
    if asked.weather.series is None and wind.speed is not None:
        if not wind.speed:
            return "none at the start"
        return f"{tell.speed(wind.speed)} {tell.from_words(wind.bearing or 0.0)}{gusts}"
    x, y = run.streams[0, :, :2].astype(float).mean(axis=0).tolist()
    return f"a series, at the mean {tell.speed(math.hypot(x, y))} {from_text(x, y, tell)}{gusts}"


def _current_words(run: Run, tell: Telling) -> str:
    """Tell the current that acts."""
    x, y = run.streams[0, :, 2:].astype(float).mean(axis=0).tolist()
    speed = math.hypot(x, y)
    return f"{tell.speed(speed)} {from_text(x, y, tell)}" if speed else "none"


def _show_happenings(report: Report, run: Run, verdict: Verdict, tell: Telling) -> None:
    """Write the table of what happened."""
    unit = tell.force
    columns = [
        Column("at [s]", is_number=True),
        Column("what happens"),
        Column(f"margin [{unit.name}]", is_number=True),
        Column(f"off by [{tell.length.name}]", is_number=True),
        Column("95 %", is_number=True, is_spare=True),
        Column("turned [deg]", is_number=True),
        Column("95 %", is_number=True, is_spare=True),
        Column("leaves after [s]", is_number=True),
        Column("foretold", is_number=True),
    ]
    rows = []
    for i, (at, circle) in enumerate(zip(run.happenings, verdict.circles, strict=True)):
        rows.append(
            [
                plain_seconds(at.time),
                at.told(tell),
                unit.number(at.margin - at.shortfall),
                *_circle(circle, tell),
                *_leaving(run, verdict, i),
            ]
        )
    report.table(columns, rows, "happenings")


def _circle(circle: Circle, tell: Telling) -> list[str]:
    """Tell a watch circle."""
    found = []
    for largest, usual in (
        (circle.distance, circle.usual_distance),
        (circle.turn, circle.usual_turn),
    ):
        is_far = largest is circle.distance
        scale = 1.0 / tell.length.metres if is_far else math.degrees(1.0)
        pair = [scale * float(largest[0]), scale * float(usual[0])]
        found += [digits(value, max(pair[0], 1e-9), 3) for value in pair]
    return found


def _leaving(run: Run, verdict: Verdict, i: int) -> list[str]:
    """Tell how long after a happening the object left its circle, and how long was foretold."""
    at, foretold = run.happenings[i], verdict.foretold[i]
    if at.kind not in AFTER:
        return ["", ""]
    left, later = float(verdict.left_at[0]), [h for h in run.happenings[i + 1 :] if h.kind in AFTER]
    until = later[0].time if later else math.inf
    gone = plain_seconds(left - at.time) if at.time <= left < until else ""
    return [gone, plain_seconds(foretold) if math.isfinite(foretold) else "never"]


def _far(distance: float, tell: Telling) -> str:
    """Return a distance [m] to two digits."""
    value = distance / tell.length.metres
    return f"{digits(value, value, 2)} {tell.length.name}"


def _degrees(turn: float) -> str:
    """Return a turn [rad] in degrees, to two digits."""
    value = abs(math.degrees(turn))
    return f"{digits(value, value, 2)} deg"
