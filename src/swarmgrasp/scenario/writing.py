"""Write a scenario as a file that people can edit, and that is read back to the last bit."""

import math
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, fields, replace
from pathlib import Path
from typing import Any

from swarmgrasp.environment import Current, Environment, Waves, Wind, WindTable, vessel_type
from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.files import write_whole
from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.placement import Problem
from swarmgrasp.plain import plain
from swarmgrasp.quality import Criterion, Polytope
from swarmgrasp.scenario.reading import parse_scenario
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.units import NAMED, Units
from swarmgrasp.scenario.yaml_lines import lines
from swarmgrasp.swarm import Newcomer, Robot, Tolerance, Zone
from swarmgrasp.terms import SI
from swarmgrasp.units import ANGLES, FORCES

DIGITS = 15
"""Of a number in a unit of its own: more would not be what anybody wrote."""
STRONG = 1000.0
"""Largest limit [N] from which on forces are in kilonewtons."""


def write(asked: Problem | Scenario, path: str | Path, **named: Any) -> None:
    """Write a problem or a scenario to a YAML file, whole or not at all.

    Parameters
    ----------
    asked : Problem or Scenario
    path : str or Path
    name, environment
        As for `scenario_text`.

    Raises
    ------
    ScenarioInvalid
        As for `scenario_text`.
    """
    write_whole(path, scenario_text(asked, **named).encode())


def scenario_text(
    asked: Problem | Scenario, *, name: str = "", environment: Environment | None = None
) -> str:
    """Return a problem or a scenario as the text of a YAML file.

    Lengths are in metres; angles in degrees and forces in kilonewtons where that loses nothing,
    else in radians and newtons. What is read of the text is equal to what was written.

    Parameters
    ----------
    asked : Problem or Scenario
    name : str
        A title for a problem; a scenario has its own.
    environment : Environment, optional
        Of a problem; a scenario has its own.

    Raises
    ------
    ScenarioInvalid
        If a scenario file cannot say it: numbers beyond what files may hold, robots of one name,
        ends of stretches next to a corner but not at it. All faults at once.

    Examples
    --------
    >>> from swarmgrasp import Swarm
    >>> barge = Outline([(0, 0), (4, 0), (4, 2), (0, 2)])
    >>> swarm = Swarm(barge, [Robot((4, 0.5), 3.14, 1.5, "Ajax")], 2.0)
    >>> print(scenario_text(Problem(swarm, Newcomer(2.0, "push")), name="Barge"), end="")
    name: Barge
    units: {length: m, force: N, angle: rad, speed: m/s}
    outline:
      vertices:
        - [0, 0]
        - [4, 0]
        - [4, 2]
        - [0, 2]
    metric: {characteristic_length: 2}
    robots:
      - {name: Ajax, contact: [4, 0.5], direction: 3.14, limit: 1.5}
    newcomer: {limit: 2, attachment: push}
    """
    scenario = asked if isinstance(asked, Scenario) else _scenario(asked, name, environment)
    limits = [float(scenario.swarm.limits.max(initial=0.0))]
    limits += [scenario.newcomer.limit] if scenario.newcomer else []
    file = _File(Units(force="kN" if max(limits) >= STRONG else "N", angle="deg"))
    document = file.document(scenario)
    if file.lost:
        file = _File(replace(file.units, **file.lost))
        document = file.document(scenario)
    text = "\n".join(lines(document)) + "\n"
    again = parse_scenario(text, "as written")
    faults = [*_differences(_told(scenario), _told(again), ())]
    if faults:
        raise ScenarioInvalid(faults)
    return text


def _scenario(problem: Problem, name: str, environment: Environment | None) -> Scenario:
    """Return the scenario of a problem."""
    return Scenario(
        name,
        "",
        problem.swarm,
        problem.newcomer,
        problem.zones,
        problem.no_go,
        problem.spacing,
        environment,
        problem.criterion,
    )


def _told(scenario: Scenario) -> dict[str, Any]:
    """Return what is to come back of a scenario as plain data."""
    return {
        "problem": scenario.problem().to_data(),
        "has_newcomer": scenario.newcomer is not None,
        "environment": plain(scenario.environment),
        "description": scenario.description,
        "simulation": plain(scenario.simulation),
    }


def _differences(one: Any, other: Any, path: tuple[str, ...]) -> Iterator[str]:
    """Tell where plain data are not what they should be."""
    if isinstance(one, dict) and isinstance(other, dict):
        for key in one:
            yield from _differences(one[key], other[key], (*path, key))
    elif isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
        for i, pair in enumerate(zip(one, other, strict=True)):
            yield from _differences(*pair, (*path, str(i)))
    elif one != other:
        yield f"{'.'.join(path)}: {one!r} would be read back as {other!r}; change it to that first"


# -- the keys of a file -------------------------------------------------------------------


@dataclass
class _File:
    """The content of a file in some units, and which of those lose something."""

    units: Units
    lost: dict[str, Any] = field(default_factory=dict)
    """SI units to be taken instead, by kind."""

    def angle(self, value: float) -> float:
        """Return an angle [rad] in the file's unit."""
        return self._told(value, ANGLES[self.units.angle], "angle", "rad")

    def force(self, value: float) -> float:
        """Return a force [N], or a torque [N m], in the file's unit."""
        return self._told(value, FORCES[self.units.force], "force", "N")

    def _told(self, value: float, factor: float, kind: str, instead: str) -> float:
        told = float(f"{value / factor:.{DIGITS}g}")
        if factor != 1.0 and told * factor != value:
            self.lost[kind] = instead
        return value if factor == 1.0 else told

    def document(self, scenario: Scenario) -> dict[str, Any]:
        """Return everything by the keys of a file; what is left out has no value."""
        swarm, outline = scenario.swarm, scenario.swarm.outline
        heading, word = scenario.terms.frame.heading, scenario.terms.robot
        is_usual = swarm.characteristic_length == outline.radius
        return _given(
            name=scenario.name,
            description=scenario.description,
            units={of: getattr(self.units, of) for of in NAMED},
            words=None if word == SI.robot else word,
            outline=_outline(outline),
            metric=_given(
                force_weights=None if swarm.force_weights == (1, 1) else list(swarm.force_weights),
                characteristic_length=None if is_usual else swarm.characteristic_length,
            ),
            newcomer=scenario.newcomer and self.newcomer(scenario.newcomer),
            zones=None if scenario.zones is None else list(map(self.zone, scenario.zones)),
            no_go=[_stretch(stretch) for stretch in scenario.no_go],
            spacing=scenario.spacing,
            criterion=self.criterion(scenario.criterion),
            environment=scenario.environment and self.environment(scenario.environment),
            simulation=self.simulation(scenario),
        ) | {
            **({} if heading is None else {"heading": self.angle(heading)}),
            "robots": list(map(self.robot, swarm.robots)),
        }

    def robot(self, robot: Robot) -> dict[str, Any]:
        """Return a robot."""
        is_azimuth = robot.steers == math.pi
        steers = self.angle(0.0 if is_azimuth else robot.steers)
        told = _given(name=robot.name, contact=list(robot.contact))
        sectors = [list(map(self.angle, sector)) for sector in robot.sectors or ()]
        if not (sectors or robot.lever) and (robot.direction or not is_azimuth):
            told["direction"] = self.angle(robot.direction)
        if robot.envelope is None:
            told |= self.forces(robot, robot.least)
        else:
            told["envelope"] = [list(map(self.force, corner)) for corner in robot.envelope]
        return told | _given(
            steers="any" if is_azimuth else steers,
            sectors=sectors,
            lever=robot.lever,
            group=robot.group,
            mounted=robot.mounted,
            **_body(robot),
            tolerance=self.tolerance(robot.tolerance),
        )

    def forces(self, holder: Robot | Newcomer, least: float = 0.0) -> dict[str, Any]:
        """Return the limits and the friction of a robot, or of a newcomer."""
        most, other_way = self.force(holder.limit), self.force(holder.reverse_limit)
        limit: Any = most
        if least:
            limit = [self.force(least), most]
        elif other_way not in (0.0, most):
            limit = {"ahead": most, "astern": other_way}
        return {
            "limit": limit,
            **_given(two_way=other_way == most, friction=holder.friction),
        }

    def newcomer(self, newcomer: Newcomer) -> dict[str, Any]:
        """Return a newcomer."""
        return {
            **_given(name=newcomer.name),
            **self.forces(newcomer),
            **self.attachment(newcomer),
            **_given(
                steers=newcomer.steers,
                mounted=newcomer.mounted,
                **_body(newcomer),
                tolerance=self.tolerance(newcomer.tolerance),
            ),
        }

    def attachment(self, holder: Newcomer | Zone) -> dict[str, Any]:
        """Return how a newcomer may attach."""
        half = holder.half_angle
        told = _given(attachment=holder.attachment)
        return told if half is None else {**told, "half_angle": self.angle(half)}

    def tolerance(self, tolerance: Tolerance | None) -> dict[str, Any] | None:
        """Return a tolerance; None if there is none, or only none."""
        if tolerance is None:
            return None
        least = tolerance.least_limit
        return _given(
            contact=_ends(tolerance.offsets, float),
            direction=_ends(tolerance.turns, self.angle),
            least_limit=None if least is None else self.force(least),
            may_be_absent=tolerance.may_be_absent,
        )

    def zone(self, zone: Zone) -> dict[str, Any]:
        """Return a zone."""
        ways, stretch = zone.directions, zone.stretch
        area = {**_given(name=zone.name), "area": list(map(list, zone.area or ()))}
        return {
            **(area if stretch is None else _stretch(stretch)),
            **self.attachment(zone),
            **_given(directions=None if ways is None else list(map(self.angle, ways))),
        }

    def criterion(self, criterion: Criterion) -> dict[str, Any]:
        """Return what quality means."""
        task = criterion.task
        kind = "polytope" if isinstance(task, Polytope) else "ellipsoid"
        rows = [] if task is None else task.generators.tolist()
        return _given(
            losing=criterion.losing,
            failures=[names[0] if len(names) == 1 else list(names) for names in criterion.failures],
            worst_case=criterion.worst_case,
            load=list(map(self.force, criterion.load)) if criterion.has_load else None,
            task=_given(**{kind: [list(map(self.force, row)) for row in rows]}),
        )

    def environment(self, around: Environment) -> dict[str, Any]:
        """Return wind, current and waves."""
        told = unusual(around)
        told["wind"] = self.wind(around.wind)
        if around.current:
            told["current"] = self.weather(around.current)
        if around.waves:
            told["waves"] = self.weather(around.waves)
            if around.waves.goes_with_wind:
                told["waves"]["with_wind"] = True
            if around.waves.bow_angle is not None:
                told["waves"]["bow_angle"] = self.angle(around.waves.bow_angle)
        return told

    def simulation(self, scenario: Scenario) -> dict[str, Any] | None:
        """Return what becomes of it all in time."""
        if scenario.simulation is None:
            return None
        from swarmgrasp.scenario.simulation_writing import simulation_keys

        return simulation_keys(scenario.simulation, self.angle, self.newcomer)

    def wind(self, wind: Wind | WindTable) -> dict[str, Any]:
        """Return a wind: what it meets, or the table of its loads."""
        told = self.weather(wind)
        if isinstance(wind, Wind):
            vessel = vessel_type(wind.coefficients)
            if vessel:
                told = {"vessel": vessel, **told}
                del told["coefficients"]
            return told
        about = told.pop("about", None)
        rows = [
            [speed, self.angle(bearing), *map(self.force, load)]
            for speed, loads in zip(wind.speeds, wind.loads, strict=True)
            for bearing, load in zip(wind.bearings, loads, strict=True)
        ]
        moving: dict[str, Any] = {key: told[key] for key in ("speed", "from") if key in told}
        return {"table": {"rows": rows, **_given(about=about)}, **moving}

    def weather(self, part: Wind | WindTable | Current | Waves) -> dict[str, Any]:
        """Return what wind, current or waves meet, and how they come from where."""
        told = unusual(part)
        if part.bearing is not None:
            told["from"] = self.angle(told.pop("bearing"))
        return told


def unusual(part: Any) -> dict[str, Any]:
    """Return what of an object's fields is not as it is when left out."""
    told = {each.name: (getattr(part, each.name), each.default) for each in fields(part)}
    return {name: plain(value) for name, (value, usual) in told.items() if value != usual}


def _given(**values: Any) -> dict[str, Any]:
    """Return what has a value other than nothing, none, no and zero."""
    return {key: value for key, value in values.items() if value}


def _outline(outline: Outline) -> dict[str, Any]:
    """Return an outline; origin and precision only if they are not those of its vertices."""
    usual, origin = Outline(outline.vertices), outline.origin.tolist()
    told = {"vertices": outline.vertices.tolist()}
    if any(outline.edge_names):
        told["edges"] = list(outline.edge_names)
    if origin != usual.origin.tolist():
        told["origin"] = origin
    if outline.precision != usual.precision:
        told["precision"] = outline.precision
    return told


def _stretch(stretch: Stretch) -> dict[str, Any]:
    """Return a stretch or a point by arc length."""
    named = _given(name=stretch.name)
    if stretch.is_point:
        return {**named, "at": stretch.start}
    return {**named, "from": stretch.start, "to": stretch.end}


def _body(holder: Robot | Newcomer) -> dict[str, float]:
    """Return the room that a robot takes up."""
    body = holder.body
    return {} if body is None else {"length": body.length, "beam": body.beam}


def _ends(ends: tuple[float, float], told: Callable[[float], float]) -> Any:
    """Return two offsets, or one for both ways."""
    first, last = ends
    return told(last) if -first == last else [told(first), told(last)]
