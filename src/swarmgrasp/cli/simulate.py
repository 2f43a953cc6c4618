"""`swarmgrasp simulate`: what becomes of the object and its robots in weather."""

from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from swarmgrasp.cli.amounts import Amount
from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.drawing import USUAL, Drawing
from swarmgrasp.cli.inputs import (
    blaming,
    json_faults,
    output_faults,
    read_scenario,
    whole_faults,
)
from swarmgrasp.cli.lasting import INTERRUPTED
from swarmgrasp.cli.progress import shown_progress
from swarmgrasp.cli.question import asked_before, missing
from swarmgrasp.cli.running import STEPS, run_of, write_files
from swarmgrasp.cli.show.report import complain
from swarmgrasp.cli.weather import AS_FILED, Streams
from swarmgrasp.cli.wording import FILE, Wording
from swarmgrasp.ranges import MOST_SEED

if TYPE_CHECKING:
    from collections.abc import Mapping

    from swarmgrasp.environment import Environment
    from swarmgrasp.scenario import Scenario
    from swarmgrasp.simulation.actuator import Actuator
    from swarmgrasp.simulation.events import Event
    from swarmgrasp.simulation.simulation import Simulation
    from swarmgrasp.terms import Terms

    Named = tuple[str, Actuator]

NOT_HELD = 1
"""Exit status when the object leaves the circle it is to be kept in."""


def simulate(
    file: Dashed,
    /,
    *,
    for_: Annotated[str | None, Parameter(name="--for", metavar="TIME")] = None,
    seed: Annotated[str | None, Parameter(metavar="INT")] = None,
    losing: Annotated[list[str] | None, Parameter(metavar="NAME@TIME", negative="")] = None,
    within: Annotated[str | None, Parameter(metavar="LENGTH")] = None,
    turn: Annotated[str | None, Parameter(metavar="ANGLE")] = None,
    log: Path | None = None,
    plot: Path | None = None,
    drawing: Drawing = USUAL,
    gif: Path | None = None,
    mcap: Path | None = None,
    player: Path | None = None,
    capability: Annotated[bool, Parameter(negative="")] = False,
    json: Dashed | None = None,
    streams: Streams = AS_FILED,
    wording: Wording = FILE,
) -> int:
    """Let the object and its robots move in wind and current, and tell whether they hold it.

    Robots lag behind their orders, turn slowly, fail, travel, make fast and join; the forces are
    shared out anew several times a second. What happens and in which weather is said by the key
    `simulation` of the scenario; without it there are gusts, the robots have the lag of harbour
    tugs, and nothing happens. The exit status is 1 if the object was not held.

    Example: swarmgrasp simulate deck-barge --wind 20kn --from 60deg --losing Castor@60

    Parameters
    ----------
    file
        Scenario in YAML with an environment, "-" for standard input, or a built-in example such as
        escort-ring.
    for_
        How long, such as 300 or 5min, instead of what the file says; events after that are left
        out.
    seed
        Of gusts and of the sensors' noise, instead of the file's.
    losing
        A robot or group that is lost, and when; give it once for each: --losing Castor@60.
    within
        How far the object may be from where it is to be, and be held; 5 m unless given, or a
        fifteenth of its extent if that is less.
    turn
        How far it may be turned from its heading, and be held; 5 degrees unless given.
    log
        Write all numbers to this .parquet file.
    plot
        Draw track and history to this .png, .svg or .pdf file.
    gif
        Draw an animation to this .gif file.
    mcap
        Write an animation to this .mcap file, for Foxglove.
    player
        Write an animation to this .json file, for a page.
    capability
        Instead of one run, find the largest wind held from every bearing: by statics, in a
        simulated steady wind, and in gusts; --plot draws the three curves. Events play no part.
    json
        Also write what became of it, or the winds, to this .json file; "-" prints it and nothing
        else. SI units and radians.
    """
    asked_for = _amounts(for_, within, turn)
    faults = [fault for amount in asked_for.values() for fault in amount.faults()]
    faults += whole_faults("--seed", seed, 0, MOST_SEED) + _loss_faults(losing or [])
    faults += streams.faults() + json_faults(json) + wording.faults(json)
    for path, suffixes in (
        (log, (".parquet",)), (gif, (".gif",)), (mcap, (".mcap",)),
        (player, (".json",)),
    ):  # fmt: skip
        faults += output_faults(path, suffixes)
    faults += drawing.faults(plot)
    if capability:
        others = {"--losing": losing, **streams.given, "--log": log, "--gif": gif, "--mcap": mcap,
                  "--player": player}  # fmt: skip
        faults += [f"{each} is of a run, and --capability makes none" for each, given in
                   others.items() if given]  # fmt: skip
    scenario = read_scenario(file, faults)
    capability = capability or bool(asked_before(scenario, "winds"))
    _check_packages(log, mcap)
    terms = wording.terms(scenario)
    told = {option: amount.value(terms) for option, amount in asked_for.items()}
    environment = _environment(scenario, file, streams, terms, is_calm=capability)
    is_other_wind = capability or bool({"--wind", "--from"} & streams.given.keys())
    with blaming(file):
        asked = _simulation(scenario, environment, is_other_wind)
    asked = _changed(asked, file, told.get("--for"), seed, losing or [], is_quiet=capability)
    from swarmgrasp.simulation.verdict import USUAL_TURN, usual_within, verdict_of

    before = _limits_before(scenario)
    usual = usual_within(scenario.swarm.outline), USUAL_TURN
    far, limit = (
        told.get(option, before.get(key, default))
        for option, key, default in zip(
            ("--within", "--turn"), ("within", "within_turn"), usual, strict=True
        )
    )
    if capability:
        return _capability(
            scenario,
            asked,
            far,
            limit,
            plot,
            drawing,
            json,
            terms,
            wording.csv,
        )
    run = run_of(asked, log)
    from swarmgrasp.answer_file import sealed
    from swarmgrasp.cli.show.simulate import show

    name, verdict = scenario.name, verdict_of(run, far, limit)
    look = drawing.look(name, terms)
    deliver(
        json,
        sealed("run", {**run.summary(), "verdict": verdict.to_data()}, name, terms=scenario.terms),
        lambda: show(name, run, verdict, terms),
        lambda: write_files(run, verdict, log, plot, look, gif, mcap, player),
        csv=wording.csv,
    )
    if not run.is_whole:
        return INTERRUPTED
    return 0 if verdict.held.all() else NOT_HELD


# -- what is asked ------------------------------------------------------------------------


def _amounts(for_: str | None, within: str | None, turn: str | None) -> dict[str, Amount]:
    """Return the amounts given as options, by option."""
    from swarmgrasp.simulation.simulation import DURATION
    from swarmgrasp.simulation.verdict import TURN_WITHIN, WITHIN

    return {
        option: Amount(option, text, of, ends.low, ends.high)
        for option, text, of, ends in (
            ("--for", for_, "time", DURATION),
            ("--within", within, "length", WITHIN),
            ("--turn", turn, "angle", TURN_WITHIN),
        )
        if text is not None
    }


def _loss(text: str) -> tuple[str, Amount]:
    """Return who is lost, and when."""
    name, _, at = text.rpartition("@")
    return name, Amount(f"--losing is {text}: the time", at, "time", 0.0)


def _loss_faults(losing: list[str]) -> list[str]:
    """Return what is wrong with losses."""
    faults = []
    for text in losing:
        name, at = _loss(text)
        faults += at.faults() if name else [
            f"--losing is {text}; it should be a robot or group and a time, such as Castor@60"
        ]  # fmt: skip
    return faults


def _limits_before(scenario: "Scenario") -> "Mapping[str, Any]":
    """Return within what the object was to be held in the answer that a scenario was read from."""
    winds, run = asked_before(scenario, "winds"), asked_before(scenario, "run")
    return winds or run.get("verdict", {})


def _check_packages(log: Path | None, mcap: Path | None) -> None:
    """Raise before anything is computed if a package is missing."""
    from swarmgrasp.packages import check_installed

    if log is not None:
        check_installed("pyarrow", extra="logs", purpose="--log")
    if mcap is not None:
        check_installed("foxglove", extra="logs", purpose="--mcap")


def _simulation(
    scenario: "Scenario", environment: "Environment", is_other_wind: bool
) -> "Simulation":
    """Return the simulation that a scenario says, or a plain one, in an environment."""
    from swarmgrasp.simulation.hull import Hull
    from swarmgrasp.simulation.simulation import Simulation
    from swarmgrasp.simulation.weather import Weather

    told = scenario.simulation
    if told is not None:
        weather = replace(told.weather, series=None) if is_other_wind else told.weather
        return replace(told, environment=environment, weather=weather)
    hull = Hull.afloat(scenario.swarm.outline, environment)
    return Simulation(scenario.problem(), environment, hull, weather=Weather("npd"))


def _environment(
    scenario: "Scenario", file: str, streams: Streams, terms: "Terms", *, is_calm: bool
) -> "Environment":
    """Return the surroundings, with a steady mean wind.

    Raises
    ------
    UsageFault
        If the scenario has none.
    """
    environment = scenario.environment
    if environment is None:
        advice = (
            "environment: is missing; say what the object shows to wind and water, such as "
            "`environment: {wind: {vessel: offshore supply vessel, frontal_area: 280, "
            "lateral_area: 700, speed: 15, from: 60}, current: {frontal_area: 110, "
            "lateral_area: 465}}`"
        )
        raise missing(scenario, file, "environment", "`swarmgrasp simulate`", advice)
    if is_calm:
        return replace(environment, wind=replace(environment.wind, speed=0.0, bearing=0.0))
    if streams.given:
        environment = streams.environment(scenario, file, terms, next(iter(streams.given)))
    if not environment.is_steady and scenario.simulation is None:
        advice = (
            "environment.wind: a simulation needs its speed, and from, where it comes from; or "
            "give --wind and --from, such as --wind 20kn --from 60deg"
        )
        raise missing(scenario, file, "wind", "`swarmgrasp simulate`", advice)
    return environment


def _changed(
    asked: "Simulation", file: str, for_: float | None, seed: str | None, losing: list[str],
    *, is_quiet: bool,
) -> "Simulation":  # fmt: skip
    """Return a simulation with another duration and seed, and robots lost; or with no events."""
    from swarmgrasp.simulation.events import Lose

    duration = asked.duration if for_ is None else for_
    events = [event for event in asked.events if event.at < duration and not is_quiet]
    left = len(asked.events) - len(events)
    if left and not is_quiet:
        complain([f"left out: {left} event{'s' * (left > 1)} after {duration:g} s"])
    with blaming(file if for_ is None else "--for"):
        asked = replace(
            asked,
            duration=duration,
            seed=asked.seed if seed is None else int(seed),
            events=tuple(events),
            actuators=_of_those_there(asked, events),
        )
    losses: list[Lose] = []
    for text in losing:
        name, at = _loss(text)
        losses.append(Lose(at.value(), name))
    with blaming("--losing"):
        return replace(asked, events=(*events, *losses))


def _of_those_there(asked: "Simulation", events: "list[Event]") -> "tuple[Named, ...]":
    """Return the actuators of all robots that ever take part with some of the events."""
    from swarmgrasp.simulation.events import joining_names

    problem = asked.problem
    present = problem.swarm.names
    names = (*present, *joining_names(present, events, problem.newcomer))
    return tuple(pair for pair in asked.actuators if pair[0] in names)


# -- the largest winds --------------------------------------------------------------------


def _capability(
    scenario: "Scenario",
    asked: "Simulation",
    within: float,
    turn: float,
    plot: Path | None,
    drawing: Drawing,
    json: str | None,
    terms: "Terms",
    csv: str | None,
) -> int:
    """Find, draw and tell the largest winds held."""
    from swarmgrasp.answer_file import sealed
    from swarmgrasp.cli.show.limits import show
    from swarmgrasp.simulation.limits import limits

    with shown_progress(STEPS, "trying winds") as told:
        done = None if told is None else (lambda part: told(round(STEPS * part)))
        found = limits(asked, within=within, within_turn=turn, progress=done)

    def draw() -> list[Path]:
        """Draw the curves if they are wanted."""
        if plot is None:
            return []
        from swarmgrasp.plot import save
        from swarmgrasp.plot.limits import limits_diagram

        return [save(limits_diagram(found, **drawing.look(scenario.name, terms)), plot)]

    document = sealed("winds", found.to_data(), scenario.name, terms=scenario.terms)
    deliver(json, document, lambda: show(scenario.name, found, terms), draw, csv=csv)
    return 0
