"""How `swarmgrasp simulate` tells its answer."""

import math

from swarmgrasp.cli.show.report import Column, Mood, Report
from swarmgrasp.environment import KNOT
from swarmgrasp.simulation.run import Happening, Run
from swarmgrasp.simulation.verdict import Circle, Verdict
from swarmgrasp.words import Unit, digits, percent

SLOW = 2.0
"""Speed [m/s] below which knots are not told."""
AFTER = ("lost", "left", "weather", "start")
"""Kinds of happenings after which the load may be out of reach."""


def show(name: str, run: Run, verdict: Verdict) -> None:
    """Write a run for people."""
    report = Report()
    report.headline(f"{name}: {_headline(run, verdict)}", _mood(run, verdict))
    report.blank()
    report.facts(_facts(run, verdict))
    report.blank()
    _show_happenings(report, run, verdict)
    report.blank()
    limits = f"{verdict.within:.3g} m or {math.degrees(verdict.within_turn):.3g} deg"
    for note in (
        f"Held: never off by more than {limits}. Off by, turned: the largest until the next line, "
        "and what 95 % of the time is within.",
        "Margin: what the robots can exert in any direction beside the mean load; below 0, how far "
        f"that is out of reach; {run.simulation.problem.swarm.metric_sentence}.",
        f"Foretold: how long the missing part of the mean load takes to move the object {limits}.",
        "Bearings: degrees clockwise from the bow at the start; 90 is starboard.",
        "The loads are those of the environment: this tries robots and control, no coefficients.",
    ):
        report.note(note)


def _mood(run: Run, verdict: Verdict) -> Mood:
    """Return the mood of the headline."""
    if not verdict.held.all():
        return "bad"
    return "good" if run.is_whole else "caution"


def _headline(run: Run, verdict: Verdict) -> str:
    """Say whether the object was held, and within what."""
    end = float(run.times[-1])
    far = max(float(c.distance[0]) for c in verdict.circles)
    turned = max(float(c.turn[0]) for c in verdict.circles)
    within = f"{_metres(far)} and {_degrees(turned)}"
    whole = (
        f"for {end:g} s"
        if run.is_whole
        else (f"until it was stopped at {end:g} of {run.simulation.duration:g} s")
    )
    if verdict.held.all():
        return f"held within {within} {whole}"
    at = float(verdict.left_at[0])
    cause = [h for h in run.happenings if h.time <= at and h.kind in AFTER][-1]
    since = f", {at - cause.time:.3g} s after {_cause(cause)}" if cause.kind != "start" else ""
    if cause.shortfall:
        since += f", {Unit.for_size(cause.shortfall, figures=3).text(cause.shortfall)} out of reach"
    off = run.poses[0, -1].astype(float) - run.references[-1]
    now = f"{_metres(math.hypot(off[0], off[1]))} and {_degrees(math.remainder(off[2], math.tau))}"
    later = f"; off by {within} at most, {now} at {end:g} s"
    stopped = "" if run.is_whole else f"; stopped at {end:g} of {run.simulation.duration:g} s"
    return f"not held from {at:.4g} s on{since}{later}{stopped}"


def _cause(at: Happening) -> str:
    """Say what changed."""
    words = {"lost": "is lost", "left": "leaves"}
    return f"{at.robot} {words[at.kind]}" if at.kind in words else "the weather changes"


def _facts(run: Run, verdict: Verdict) -> list[tuple[str, str]]:
    """Tell the weather that acts, the margin, and what the robots do."""
    start = run.happenings[0]
    sizes = [at.margin for at in run.happenings] + [float(verdict.spreads[0])]
    unit = Unit.for_size(*sizes, figures=3)
    margin = f"{unit.text(start.margin)} beside the mean load at the start"
    if start.shortfall:
        margin = f"none: the mean load is out of reach by {unit.text(start.shortfall)}"
    elif math.isfinite(verdict.margins_over_spread[0]):
        margin += (
            f", {verdict.margins_over_spread[0]:.2g} times the standard deviation of the gusts' "
            f"load, {unit.text(float(verdict.spreads[0]))}"
        )
    share, use = float(verdict.largest_share[0]), float(verdict.use[0])
    facts = [
        ("Wind", _wind_words(run)),
        ("Current", _current_words(run)),
        ("Margin", margin),
        (
            "Thrust",
            f"largest share {share:.2f} of a limit, {use:.2f} at the mean; forces travel "
            f"{digits(float(verdict.travel[0]), float(verdict.travel[0]), 2)} limits a second",
        ),
    ]
    if math.isfinite(verdict.least_excess):
        excess = percent(verdict.least_excess)
        facts.append(
            ("Length", f"a run so long tells a load that is {excess} beyond reach, or more")
        )
    return facts


def _speed(speed: float) -> str:
    """Return a speed [m/s] as text."""
    if speed < SLOW:
        return f"{speed:.3g} m/s"
    return f"{speed / KNOT:.3g} kn ({speed:.3g} m/s)"


def _wind_words(run: Run) -> str:
    """Tell the wind that acts, and how much it varies."""
    asked = run.simulation
    spread = float(run.gusts[0])
    gusts = f", gusts of standard deviation {_speed(spread)}" if spread else ", no gusts"
    wind = asked.environment.wind
    if asked.weather.series is None and wind.speed is not None:
        if not wind.speed:
            return "none at the start"
        bearing = math.degrees(wind.bearing or 0.0) % 360.0
        return f"{_speed(wind.speed)} from {round(bearing, 1):g} deg{gusts}"
    x, y = run.streams[0, :, :2].astype(float).mean(axis=0).tolist()
    return f"a series, at the mean {_speed(math.hypot(x, y))} from {_bearing(x, y)} deg{gusts}"


def _current_words(run: Run) -> str:
    """Tell the current that acts."""
    x, y = run.streams[0, :, 2:].astype(float).mean(axis=0).tolist()
    speed = math.hypot(x, y)
    return f"{_speed(speed)} from {_bearing(x, y)} deg" if speed else "none"


def _bearing(x: float, y: float) -> str:
    """Return where a stream (x, y) comes from, in degrees clockwise from the bow."""
    return f"{round(math.degrees(math.atan2(y, -x)) % 360.0, 1) % 360.0:g}"


def _show_happenings(report: Report, run: Run, verdict: Verdict) -> None:
    """Write the table of what happened."""
    sizes = [at.margin + at.shortfall for at in run.happenings]
    unit = Unit.for_size(*sizes, figures=3)
    columns = [
        Column("at [s]", is_number=True),
        Column("what happens"),
        Column(f"margin [{unit.name}]", is_number=True),
        Column("off by [m]", is_number=True),
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
                f"{at.time:.4g}",
                at.words,
                unit.number(at.margin - at.shortfall),
                *_circle(circle),
                *_leaving(run, verdict, i),
            ]
        )
    report.table(columns, rows)


def _circle(circle: Circle) -> list[str]:
    """Tell a watch circle."""
    found = []
    for largest, usual in (
        (circle.distance, circle.usual_distance),
        (circle.turn, circle.usual_turn),
    ):
        scale = 1.0 if largest is circle.distance else math.degrees(1.0)
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
    gone = f"{left - at.time:.3g}" if at.time <= left < until else ""
    return [gone, f"{foretold:.3g}" if math.isfinite(foretold) else "never"]


def _metres(distance: float) -> str:
    """Return a distance to two digits."""
    return f"{digits(distance, max(distance, 1e-3), 2)} m"


def _degrees(turn: float) -> str:
    """Return a turn [rad] in degrees, to two digits."""
    value = abs(math.degrees(turn))
    return f"{digits(value, max(value, 1e-2), 2)} deg"
