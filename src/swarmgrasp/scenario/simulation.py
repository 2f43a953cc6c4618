"""Build the simulation of a scenario, and find the faults its schema does not see."""

from collections.abc import Callable
from dataclasses import replace
from functools import partial
from typing import TypeVar

import numpy as np

from swarmgrasp.environment import Environment
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.placement import Problem
from swarmgrasp.ranges import nearest_name
from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.in_range import check_section
from swarmgrasp.scenario.newcomer import newcomer_of
from swarmgrasp.scenario.newcomer_schema import NewcomerSection
from swarmgrasp.scenario.simulation_ranges import (
    ACTUATOR,
    CONTROL,
    EVENT,
    HULL,
    RUN,
    STREAM,
    WEATHER,
)
from swarmgrasp.scenario.simulation_schema import (
    ActuatorSection,
    ControlSection,
    EventSection,
    HullSection,
    RobotsSection,
    SimulationSection,
    StreamSection,
    WeatherSection,
)
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.simulation.actuator import Actuator
from swarmgrasp.simulation.control import Control, loop_faults
from swarmgrasp.simulation.events import (
    Change,
    Event,
    Follow,
    Leave,
    Lose,
    Move,
    Send,
    event_faults,
    in_order,
    joining_names,
)
from swarmgrasp.simulation.hull import Hull
from swarmgrasp.simulation.simulation import Simulation
from swarmgrasp.simulation.weather import Series, Weather
from swarmgrasp.swarm import Newcomer
from swarmgrasp.swarm.names import filled
from swarmgrasp.words import list_words

_HERE: Path = ("simulation",)
_KINDS = ("lose", "leave", "send", "move", "follow", "wind", "current")
_STREAMS = ["wind", "current"]
"""Of the kinds, those that one event may have both."""
_GOES_WITH = {
    "noticed": ("lose",),
    "as": ("send",),
    "away": ("send",),
    "from": ("send",),
    "make_fast": ("send",),
    "speed": ("send", "follow"),
}
"""What some keys of an event go with."""
_PARTS: dict[Path, str] = {("hull", "damping"): "hull: the damping", ("hull",): "hull: "}
"""Parts of a simulation that only its outline tells whether they go together."""
_NEWCOMER = "newcomer"
_Made = TypeVar("_Made")


def simulation_of(
    section: SimulationSection,
    units: Units,
    problem: Problem,
    environment: Environment,
    checked: Checked,
) -> Simulation:
    """Return the simulation of a document without faults.

    Raises
    ------
    ScenarioInvalid
        If nothing says the draught, or a number is too small to compute with.
    """
    try:
        actuator = _actuator(section.robots, units)
        return Simulation(
            problem,
            environment,
            _hull(section.hull, problem.swarm.outline, environment, units),
            actuator,
            tuple((each.name, _actuator(each, units, actuator)) for each in section.robots.others),
            _weather(section.weather, units),
            _control(section.control, units),
            tuple(
                _event(event, _sent(event, i, problem.newcomer, checked, units), units)
                for i, event in enumerate(section.events)
            ),
            section.duration,
            section.step,
            section.seed,
        )
    except SimulationInvalid as error:
        for fault in error.faults:
            part = next((key for key in _PARTS if fault.startswith(_PARTS[key])), ())
            checked.fault((*_HERE, *part), fault, got=False)
        raise checked.faults.error() from error


# -- faults -------------------------------------------------------------------------------


def check_simulation(section: SimulationSection, units: Units, checked: Checked) -> None:
    """Note what is wrong with how a document says its simulation."""
    _check_surroundings(section, checked)
    parts = (("hull", HULL), ("weather", WEATHER), ("control", CONTROL))
    runs = check_section(section, _HERE, RUN, checked, units)
    wrong = {
        key
        for key, known in parts
        if not check_section(getattr(section, key), (*_HERE, key), known, checked, units)
    }
    if checked.is_sound(*_HERE, "weather") and "weather" not in wrong:
        path = (*_HERE, "weather", "series")
        _made(checked, path, partial(_weather, section.weather, units))
    control = None
    if runs and checked.is_sound(*_HERE, "control") and "control" not in wrong:
        make = partial(_control, section.control, units)
        control = _made(checked, (*_HERE, "control"), make)
    actuators = _check_actuators(section.robots, units, checked)
    newcomer = Newcomer(name=checked.file.newcomer.name if checked.file.newcomer else "")
    events = _check_each_event(section, newcomer, units, checked)
    if not checked.is_known("newcomer") or not _are_names_sound(checked):
        return
    names = filled([robot.name for robot in checked.file.robots])
    ordered = in_order(events.values())
    dropped = set(range(len(section.events))) - set(events)
    if any("send" in _said(i, checked) for i in dropped):
        return  # whom it brings, and when, is not known
    everybody = [*names, *joining_names(names, ordered, newcomer)]
    _check_robots(section, everybody, checked)
    _check_loop(section, control, actuators, everybody, checked)
    paths = {id(event): path for path, event in events.items()}
    groups: dict[str, list[str]] = {}
    for name, robot in zip(names, checked.file.robots, strict=True):
        if robot.group:
            groups.setdefault(robot.group, []).append(name)
    for event, fault in event_faults(names, groups, ordered, newcomer, section.duration):
        checked.fault((*_HERE, "events", paths[id(event)]), fault, got=False)


def _check_surroundings(section: SimulationSection, checked: Checked) -> None:
    """Note that there is no environment, or no wind, to be in."""
    around = checked.file.environment
    if around is None:
        if checked.is_known("environment"):
            said = "needs the environment: what the object shows to the wind, and its speed"
            checked.fault(_HERE, said, got=False)
        return
    if checked.has("environment", "waves"):
        said = "a simulation has no waves: leave them out of a file that has one"
        checked.fault(("environment", "waves"), said, got=False)
    wind: Path = ("environment", "wind")
    if not checked.is_sound(*wind) or section.weather.series is not None:
        return
    if around.wind.speed is None and checked.is_sound(*_HERE, "weather", "series"):
        said = "a simulation needs a wind: its speed, and from, where it comes from; 0 for a calm"
        checked.fault(wind, said, got=False)


def _check_actuators(
    section: RobotsSection, units: Units, checked: Checked
) -> tuple[Actuator, dict[str, Actuator]] | None:
    """Note what does not go together in how robots answer to orders; return it if all does."""
    path: Path = (*_HERE, "robots")
    in_range = check_section(section, path, ACTUATOR, checked, units)
    sound = all(checked.is_sound(*path, key) for key in ActuatorSection.model_fields)
    if not sound or not in_range:
        return None
    usual = _made(checked, path, partial(_actuator, section, units))
    others: dict[str, Actuator] = {}
    for i, each in enumerate(section.others):
        here: Path = (*path, "except", i)
        in_range = check_section(each, here, ACTUATOR, checked, units)
        if usual is not None and in_range and checked.is_sound(*here):
            made = _made(checked, here, partial(_actuator, each, units, usual))
            others |= {} if made is None else {each.name: made}
    is_whole = usual is not None and len(others) == len(section.others)
    return (usual, others) if usual is not None and is_whole else None


def _check_loop(
    section: SimulationSection,
    control: Control | None,
    actuators: tuple[Actuator, dict[str, Actuator]] | None,
    names: list[str],
    checked: Checked,
) -> None:
    """Note what does not go together in control, the lag of those who take part, and duration."""
    if actuators is None or control is None or not checked.is_sound(*_HERE, "duration"):
        return
    usual, others = actuators
    lag = max([others.get(name, usual).lag for name in names], default=usual.lag)
    for part, fault in loop_faults(control, lag, section.duration):
        path: Path = (*_HERE, part) if part == "duration" else (*_HERE, "control", part)
        checked.fault(path if part else path[:-1], fault, got=False)


def _are_names_sound(checked: Checked) -> bool:
    """Tell whether the names of all robots are known."""
    count = len(checked.file.robots)
    sound = all(
        checked.is_known("robots", i) and checked.is_sound("robots", i, "name")
        for i in range(count)
    )
    return sound and checked.is_known("robots")


def _check_robots(section: SimulationSection, names: list[str], checked: Checked) -> None:
    """Note names that no robot has, and robots that are named twice."""
    seen: dict[str, int] = {}
    for i, each in enumerate(section.robots.others):
        path: Path = (*_HERE, "robots", "except", i, "name")
        if not checked.is_sound(*path):
            continue
        first = seen.setdefault(each.name, i)
        if first != i:
            checked.fault(path, f"is the name of except.{first} too; keep one")
        elif each.name not in names:
            said = f"there is no such robot, and none is sent{nearest_name(each.name, names)}"
            checked.fault(path, said)


def _check_each_event(
    section: SimulationSection, newcomer: Newcomer, units: Units, checked: Checked
) -> dict[int, Event]:
    """Note what is wrong with events by themselves; return those with no fault, by their index."""
    found = {}
    for i, event in enumerate(section.events):
        path: Path = (*_HERE, "events", i)
        sent = _named(event, newcomer)
        make: Callable[[], Event] = partial(_event, event, sent, units)
        in_range = _is_event_in_range(event, path, checked, units)
        if not _is_event_said(event, i, checked) or not in_range or not checked.is_sound(*path):
            is_named = checked.is_sound(*path, "as") and checked.is_sound(*path, "send", "name")
            if event.send is None or not is_named:
                continue
            at = event.at if checked.is_sound(*path, "at") else 0.0  # there from the start, perhaps
            make = partial(Send, at, sent)  # others may name it
        made = _made(checked, path, make)
        if made is not None:
            found[i] = made
    return found


def _is_event_in_range(event: EventSection, path: Path, checked: Checked, units: Units) -> bool:
    """Tell whether the numbers of an event are in range; note a fault for each that is not."""
    found = check_section(event, path, EVENT, checked, units)
    for key in _STREAMS:
        stream = getattr(event, key)
        if stream is not None:
            found &= check_section(stream, (*path, key), STREAM, checked, units)
    return found


def _said(index: int, checked: Checked) -> list[str]:
    """Return the kinds that are written of an event."""
    return [kind for kind in _KINDS if checked.has(*_HERE, "events", index, kind)]


def _is_event_said(event: EventSection, index: int, checked: Checked) -> bool:
    """Tell whether an event says one thing with what belongs to it; note a fault otherwise."""
    path: Path = (*_HERE, "events", index)
    if not checked.is_known(*path):
        return False
    kinds = _said(index, checked)
    if len(kinds) != 1 and kinds != _STREAMS:
        said = f"{list_words(kinds)} are more than one event; give each an item of its own"
        if not kinds:
            said = f"should say what happens, by {', '.join(_KINDS[:-1])} or {_KINDS[-1]}"
        checked.fault(path, said, got=False)
        return False
    strange = [
        (key, f"goes with {' or '.join(others)}")
        for key, others in _GOES_WITH.items()
        if checked.has(*path, key) and kinds[0] not in others
    ]
    missing = [
        (key, "should say speed or from")
        for key, stream in (("wind", event.wind), ("current", event.current))
        if stream is not None and not stream.model_fields_set and checked.is_sound(*path, key)
    ]
    missing += _kind_faults(event, kinds[0], path, checked)
    for faults, got in ((strange, True), (missing, False)):
        for key, said in faults:
            checked.fault((*path, key), said, got=got)
    return not strange and not missing


def _kind_faults(
    event: EventSection, kind: str, path: Path, checked: Checked
) -> list[tuple[str, str]]:
    """Return what is missing for one kind of event, each with its key."""
    file = checked.file
    around = file.environment
    if kind == "follow" and not checked.has(*path, "speed"):
        return [("follow", "also needs speed")]
    if kind == "current" and around and not around.current and checked.is_known("environment"):
        return [("current", "there is no current in the environment; say what the object shows it")]
    if isinstance(event.send, NewcomerSection) and checked.has(*path, "as"):
        return [("as", "goes with a newcomer that is sent by its name; write its own in send")]
    if not isinstance(event.send, str) or not checked.is_known("newcomer"):
        return []
    if file.newcomer is None:
        return [("send", "there is no newcomer; say here what comes, or by the key newcomer")]
    known = [_NEWCOMER, *filter(None, [file.newcomer.name])]
    if event.send in known:
        return []
    wanted = " or ".join(map(repr, known))
    said = (
        f"{event.send!r} should be {wanted}, or say what comes: {{name: {event.send}, limit: ..}}; "
        "another name alone is given by `as`"
    )
    return [("send", said)]


def _made(checked: Checked, path: Path, make: Callable[[], _Made]) -> _Made | None:
    """Return what is made, or None after noting what is wrong with it."""
    try:
        return make()
    except SimulationInvalid as error:
        for fault in error.faults:
            checked.fault(path, fault, got=False)
        return None


# -- objects ------------------------------------------------------------------------------


def _hull(section: HullSection, outline: Outline, environment: Environment, units: Units) -> Hull:
    """Return the hull of an object: as it is said, and else as it floats."""
    told = section.model_dump(exclude_none=True, exclude={"draught", "block"})
    for key in ("centre", "added_at"):
        if key in told:
            told[key] = units.point(told[key])
    if "damping" in told:
        rows = units.frame.wrench_from_file(told["damping"])
        told["damping"] = units.frame.wrench_from_file(rows.T).T.tolist()
    if {"mass", "inertia", "centre", "added", "added_at"} <= set(told):
        return Hull(**told)
    draught = None if section.draught is None else units.metres(section.draught)
    afloat = Hull.afloat(
        outline, environment, draught=draught, block=section.block, mass=section.mass
    )
    return replace(afloat, **told)


def _actuator(section: ActuatorSection, units: Units, other: Actuator | None = None) -> Actuator:
    """Return how robots answer to orders: what is left out, as another does."""
    terms = section.model_dump(
        include=set(ActuatorSection.model_fields),
        exclude_none=True,
        exclude_unset=other is not None,
    )
    if "turn_rate" in terms:
        terms["turn_rate"] = units.radians(terms["turn_rate"])
    return Actuator(**terms) if other is None else replace(other, **terms)


def _weather(section: WeatherSection, units: Units) -> Weather:
    """Return the weather."""
    rows = section.series
    if rows is None:
        return Weather(section.gusts)
    times, speeds, bearings = zip(*rows, strict=True)
    return Weather(
        section.gusts,
        Series(
            np.array(times),
            np.array([units.metres_per_second(speed) for speed in speeds]),
            np.array([units.radians(bearing) for bearing in bearings]),
        ),
    )


def _control(section: ControlSection, units: Units) -> Control:
    """Return how the object is kept."""
    terms = section.model_dump(exclude_none=True)
    if "position_noise" in terms:
        terms["position_noise"] = units.metres(terms["position_noise"])
    if "heading_noise" in terms:
        terms["heading_noise"] = units.radians(terms["heading_noise"])
    return Control(**terms)


def _event(section: EventSection, sent: Newcomer | None, units: Units) -> Event:
    """Return what happens at an instant."""
    at = section.at
    if section.lose is not None:
        return Lose(at, section.lose, section.noticed)
    if section.leave is not None:
        return Leave(at, section.leave)
    if section.send is not None:
        return _send(section, sent, units)
    if section.move is not None:
        x, y, heading = (*section.move, 0.0)[:3]
        return Move(at, *units.point((x, y)), units.turned(heading))
    if section.follow is not None:
        path = tuple(map(units.point, section.follow))
        return Follow(at, path, units.metres_per_second(section.speed or 0.0))
    return Change(
        at, **_stream("wind", section.wind, units), **_stream("current", section.current, units)
    )


def _send(section: EventSection, sent: Newcomer | None, units: Units) -> Send:
    """Return the sending of a newcomer."""
    terms = section.model_dump(include={"away", "speed", "make_fast", "bearing"}, exclude_none=True)
    for key, told in (
        ("away", units.metres),
        ("speed", units.metres_per_second),
        ("bearing", units.radians),
    ):
        if key in terms:
            terms[key] = told(terms[key])
    return Send(section.at, sent, **terms)


def _sent(
    section: EventSection, index: int, newcomer: Newcomer, checked: Checked, units: Units
) -> Newcomer | None:
    """Return who is sent, None for the problem's own newcomer."""
    if isinstance(section.send, NewcomerSection):
        return newcomer_of(section.send, (*_HERE, "events", index, "send"), checked, units)
    return _named(section, newcomer)


def _named(section: EventSection, newcomer: Newcomer) -> Newcomer | None:
    """Return who is sent by its right name, None for the problem's own newcomer."""
    if isinstance(section.send, NewcomerSection):
        return Newcomer(name=section.send.name)
    return None if section.name is None else replace(newcomer, name=section.name)


def _stream(name: str, section: StreamSection | None, units: Units) -> dict[str, float]:
    """Return what changes of the wind or the current, by the keywords of an event."""
    found = {}
    if section is not None and section.speed is not None:
        found[f"{name}_speed"] = units.metres_per_second(section.speed)
    if section is not None and section.bearing is not None:
        found[f"{name}_bearing"] = units.radians(section.bearing)
    return found
