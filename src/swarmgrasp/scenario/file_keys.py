"""What is asked by the keys of a scenario file."""

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass, field, fields
from typing import Any

from swarmgrasp.environment import Current, Environment, Waves, Wind, WindTable, vessel_type
from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.plain import plain
from swarmgrasp.quality import Criterion, Polytope
from swarmgrasp.quality.criterion import Load
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.units import NAMED, Units
from swarmgrasp.swarm import Newcomer, Robot, Swarm, Tolerance, Zone
from swarmgrasp.terms import SI
from swarmgrasp.units import ANGLES, FORCES, LENGTHS, SPEEDS

DIGITS = 15
"""Of a number in a unit of its own: more would not be what anybody wrote."""
LENGTHS_OF = ("lateral_centroid", "height")
"""Of wind, current and waves, what is a length,"""
AREAS_OF = ("frontal_area", "lateral_area")
"""and what an area."""


@dataclass
class FileKeys:
    """What is asked by the keys of a file, in its units and its frame.

    Attributes
    ----------
    units : Units
    lost : dict
        SI units to be taken instead, by kind: of the others, some number lost something.
    """

    units: Units
    lost: dict[str, Any] = field(default_factory=dict)

    def angle(self, value: float) -> float:
        """Return an angle [rad] in the file's unit."""
        return self._told(value, ANGLES[self.units.angle], "angle", "rad")

    def force(self, value: float) -> float:
        """Return a force [N], or a torque [N m], in the file's unit."""
        return self._told(value, FORCES[self.units.force], "force", "N")

    def length(self, value: float) -> float:
        """Return a length [m] in the file's unit."""
        return self._told(value, LENGTHS[self.units.length], "length", "m")

    def speed(self, value: float) -> Any:
        """Return a speed [m/s] in the file's unit; with a unit of its own if that is a scale."""
        if self.units.speed not in SPEEDS:
            return f"{value:.{DIGITS}g} m/s"
        return self._told(value, SPEEDS[self.units.speed], "speed", "m/s")

    def point(self, point: Sequence[float]) -> list[float]:
        """Return a point [m, m] in the file's unit and frame."""
        return [self.length(part) for part in self._turned(point)]

    def direction(self, value: float) -> float:
        """Return a direction [rad] in the file's unit and frame."""
        return self.angle(self.units.frame.direction_to_file(value))

    def span(self, ends: Sequence[float]) -> list[float]:
        """Return directions from one to another [rad] as the file counts them."""
        first, last = map(self.direction, ends)
        return [last, first] if self.units.frame.mirrored else [first, last]

    def wrench(self, wrench: Load) -> list[float]:
        """Return a wrench [N, N, N m] in the file's units and frame."""
        along, across, turn = wrench
        surge, sway = self._turned((along, across))
        arm = LENGTHS[self.units.length]
        turn *= self._side
        return [self.force(surge), self.force(sway), self.force(turn if arm == 1.0 else turn / arm)]

    @property
    def _side(self) -> float:
        """Return -1 if the file's angles run clockwise, or 1."""
        return -1.0 if self.units.frame.mirrored else 1.0

    def _turned(self, vector: Sequence[float]) -> list[float]:
        """Return a vector of two in the file's frame."""
        if self.units.frame.bow == 0.0 and not self.units.frame.mirrored:
            return list(vector)
        turned: list[float] = self.units.frame.to_file(vector).tolist()
        return turned

    def _told(self, value: float, factor: float, kind: str, instead: str) -> float:
        told = float(f"{value / factor:.{DIGITS}g}")
        if factor != 1.0 and told * factor != value:
            self.lost[kind] = instead
        return value if factor == 1.0 else told

    def document(self, scenario: Scenario) -> dict[str, Any]:
        """Return everything by the keys of a file; what is left out has no value."""
        swarm, outline = scenario.swarm, scenario.swarm.outline
        heading, word = scenario.terms.frame.heading, scenario.terms.robot
        return _given(
            name=scenario.name,
            description=scenario.description,
            units={of: getattr(self.units, of) for of in NAMED},
            words=None if word == SI.robot else word,
            outline=self.outline(outline),
            metric=self.metric(swarm),
            newcomer=scenario.newcomer and self.newcomer(scenario.newcomer),
            zones=None if scenario.zones is None else list(map(self.zone, scenario.zones)),
            no_go=[self.stretch(stretch) for stretch in scenario.no_go],
            spacing=self.length(scenario.spacing),
            criterion=self.criterion(scenario.criterion),
            environment=scenario.environment and self.environment(scenario.environment),
            simulation=self.simulation(scenario),
        ) | {
            **({} if heading is None else {"heading": self.angle(heading)}),
            "robots": list(map(self.robot, swarm.robots)),
        }

    def metric(self, swarm: Swarm) -> dict[str, Any]:
        """Return the metric, where it is not the usual one."""
        length, weights = swarm.characteristic_length, swarm.force_weights
        return _given(
            force_weights=None if weights == (1, 1) else list(weights),
            characteristic_length=(None if length == swarm.outline.radius else self.length(length)),
        )

    def robot(self, robot: Robot) -> dict[str, Any]:
        """Return a robot."""
        is_azimuth = robot.steers == math.pi
        steers = self.angle(0.0 if is_azimuth else robot.steers)
        told = _given(name=robot.name, contact=self.point(robot.contact))
        sectors = [self.span(sector) for sector in robot.sectors or ()]
        if not (sectors or robot.lever) and (robot.direction or not is_azimuth):
            told["direction"] = self.direction(robot.direction)
        if robot.envelope is None:
            told |= self.forces(robot, robot.least)
        else:
            told["envelope"] = [
                [self.force(x), self.force(self._side * y)] for x, y in robot.envelope
            ]
        return told | _given(
            steers="any" if is_azimuth else steers,
            sectors=sectors,
            lever=self.length(self._side * robot.lever),
            group=robot.group,
            mounted=robot.mounted,
            **self.body(robot),
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
                **self.body(newcomer),
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
            contact=self._ends(tolerance.offsets, self.length),
            direction=self._ends(tolerance.turns, self.angle),
            least_limit=None if least is None else self.force(least),
            may_be_absent=tolerance.may_be_absent,
        )

    def zone(self, zone: Zone) -> dict[str, Any]:
        """Return a zone."""
        ways, stretch = zone.directions, zone.stretch
        area = {**_given(name=zone.name), "area": list(map(self.point, zone.area or ()))}
        return {
            **(area if stretch is None else self.stretch(stretch)),
            **self.attachment(zone),
            **_given(directions=None if ways is None else self.span(ways)),
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
            load=self.wrench(criterion.load) if criterion.has_load else None,
            task=_given(**{kind: list(map(self.wrench, rows))}),
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
        for key in LENGTHS_OF:
            if told.get(key) is not None:
                told[key] = self.length(told[key])
        for key in AREAS_OF:
            if key in told:
                told[key] = self.length(told[key] / LENGTHS[self.units.length])
        if told.get("speed") is not None:
            told["speed"] = self.speed(told["speed"])
        if part.bearing is not None:
            told["from"] = self.angle(told.pop("bearing"))
        return told

    def outline(self, outline: Outline) -> dict[str, Any]:
        """Return an outline; origin and precision only if they are not those of its vertices."""
        usual, origin = Outline(outline.vertices), outline.origin.tolist()
        told: dict[str, Any] = {"vertices": list(map(self.point, outline.vertices.tolist()))}
        if any(outline.edge_names):
            told["edges"] = list(outline.edge_names)
        if origin != usual.origin.tolist():
            told["origin"] = self.point(origin)
        if outline.precision != usual.precision:
            told["precision"] = self.length(outline.precision)
        return told

    def stretch(self, stretch: Stretch) -> dict[str, Any]:
        """Return a stretch or a point by arc length, of a file whose angles run as ours."""
        named = _given(name=stretch.name)
        if stretch.is_point:
            return {**named, "at": self.length(stretch.start)}
        return {**named, "from": self.length(stretch.start), "to": self.length(stretch.end)}

    def body(self, holder: Robot | Newcomer) -> dict[str, float]:
        """Return the room that a robot takes up."""
        body = holder.body
        if body is None:
            return {}
        return {"length": self.length(body.length), "beam": self.length(body.beam)}

    def _ends(self, ends: tuple[float, float], told: Callable[[float], float]) -> Any:
        """Return two offsets as the file counts them, or one for both ways."""
        first, last = self.units.either_way(ends)
        return told(last) if -first == last else [told(first), told(last)]


def unusual(part: Any) -> dict[str, Any]:
    """Return what of an object's fields is not as it is when left out."""
    told = {each.name: (getattr(part, each.name), each.default) for each in fields(part)}
    return {name: plain(value) for name, (value, usual) in told.items() if value != usual}


def _given(**values: Any) -> dict[str, Any]:
    """Return what has a value other than nothing, none, no and zero."""
    return {key: value for key, value in values.items() if value}
