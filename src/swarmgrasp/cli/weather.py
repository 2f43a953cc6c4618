"""Weather on the command line: options that all commands share which ask what is held in it."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, NamedTuple

from cyclopts import Parameter

from swarmgrasp.cli.inputs import UsageFault, blaming, noting, source_of
from swarmgrasp.cli.question import missing
from swarmgrasp.cli.show.report import complain
from swarmgrasp.cli.streams import bearing_given, sea_given, speed_given
from swarmgrasp.cli.wording import Phrasing
from swarmgrasp.units import SPEEDS

if TYPE_CHECKING:
    from swarmgrasp.environment import Current, Environment, Waves, Wind, WindTable
    from swarmgrasp.scenario import Scenario
    from swarmgrasp.terms import Terms

WITH_WIND = "wind"
"""What --waves says for the sea that goes with the wind."""
Speed = Annotated[str | None, Parameter(metavar="SPEED")]
Bearing = Annotated[str | None, Parameter(metavar="BEARING")]


@dataclass(frozen=True)
class _Options:
    """Options that say something of the weather, each in the place of what the file says.

    What the object shows to wind, current and sea stands in the file's environment. Bearings are
    degrees clockwise from the bow, or true ones, 225true, or points of the compass, NE, where the
    file gives the heading.
    """

    @property
    def given(self) -> dict[str, str]:
        """What is given, by option."""
        return {
            f"--{name.removeprefix('wind_').replace('_', '-')}": value
            for name, value in vars(self).items()
            if value is not None
        }

    def faults(self) -> list[str]:
        """Return what is wrong with the options, whatever the file."""
        faults: list[str] = []
        for option, text in self.given.items():
            with noting(faults):
                if option.endswith("from"):
                    bearing_given(option, text, 0.0)
                elif option != "--waves":
                    faults += speed_given(option, text).faults()
                elif text != WITH_WIND:
                    faults += [fault for amount in sea_given(text) for fault in amount.faults()]
        return faults

    def environment(
        self, scenario: "Scenario", file: str, terms: "Terms", needed_by: str
    ) -> "Environment":
        """Return the surroundings to compute with.

        Parameters
        ----------
        scenario : Scenario
        file : str
            What messages call it.
        terms : Terms
            In whose units numbers without one are.
        needed_by : str
            The command or option that cannot do without.

        Raises
        ------
        UsageFault
            If the scenario has none, or does not say what the object shows to the current, or an
            option does not fit.
        """
        around = scenario.environment
        if around is None:
            advice = (
                "environment: is missing; say what the object shows to the wind, such as "
                "`environment: {wind: {vessel: offshore supply vessel, frontal_area: 280, "
                "lateral_area: 700}}`"
            )
            raise missing(scenario, file, "environment", needed_by, advice)
        asked = _Asked(scenario, file, terms)
        faults: list[str] = []
        wind, current, waves = around.wind, around.current, around.waves
        with noting(faults):
            wind = self._wind(asked, wind)
        with noting(faults):
            current = self._current(asked, current)
        with noting(faults):
            waves = self._waves(asked, waves)
        faults += self._sea_faults(asked, wind, waves)
        if faults:
            raise UsageFault(faults)
        complain(self._slips(wind, current, waves))
        with blaming("--waves" if "--waves" in self.given else source_of(file)):
            return replace(around, wind=wind, current=current, waves=waves)

    def _slips(
        self, wind: "Wind | WindTable", current: "Current | None", waves: "Waves | None"
    ) -> list[str]:
        """Return what of the weather given is beyond anything real."""
        from swarmgrasp.scenario.unreal import FASTEST_CURRENT, FASTEST_WIND, highest

        sea = (waves.height or 0.0, waves.period) if waves is not None else (0.0, None)
        found = (
            ("--wind", (wind.speed or 0.0) > FASTEST_WIND, "faster than any wind"),
            ("--current", current and current.speed > FASTEST_CURRENT, "faster than any current"),
            ("--waves", sea[1] and sea[0] > highest(sea[1]), "higher than such a sea can be"),
        )
        return [
            f"warning: {option} is {self.given[option]}, {said}"
            for option, is_odd, said in found
            if is_odd and option in self.given
        ]

    def _sea_faults(
        self, asked: "_Asked", wind: "Wind | WindTable", waves: "Waves | None"
    ) -> list[str]:
        """Return what is wrong with a wind that its sea is to go with."""
        if waves is None or not waves.goes_with_wind or wind.speed is None:
            return []
        from swarmgrasp.environment.sea import STRONGEST_SEA

        if wind.speed <= STRONGEST_SEA:
            return []
        unit = asked.terms.speed
        most, speed = (v / SPEEDS[unit] for v in (STRONGEST_SEA, wind.speed))
        said = f"{speed:.4g} {unit} of wind: the sea that goes with it is known up to {most:.4g} "
        where = "--wind is" if "--wind" in self.given else f"{source_of(asked.file)}:"
        return [f"{where} {said}{unit}; give --waves a height and a period, such as 2.1m,7.5s"]

    def _wind(self, asked: "_Asked", wind: "Wind | WindTable") -> "Wind | WindTable":  # noqa: ARG002
        """Return what the object shows to the wind; its own speed and bearing play no part."""
        return replace(wind, speed=None, bearing=None)

    def _current(self, asked: "_Asked", current: "Current | None") -> "Current | None":  # noqa: ARG002
        """Return the current to compute with."""
        return current

    def _waves(self, asked: "_Asked", waves: "Waves | None") -> "Waves | None":  # noqa: ARG002
        """Return the sea to compute with."""
        return waves


class _Asked(NamedTuple):
    """What options are asked of: a scenario, what it was read from, the units of numbers."""

    scenario: "Scenario"
    file: str
    terms: "Terms"

    @property
    def heading(self) -> float | None:
        """The true bearing of the bow [rad], if the file gives it."""
        return self.scenario.terms.frame.heading


@dataclass(frozen=True)
class _Wind(_Options):
    """The wind."""

    wind: Speed = None
    """Speed of the wind, such as 25kn or 6Bft."""
    wind_from: Annotated[str | None, Parameter(name="--from", metavar="BEARING")] = None
    """Where the wind comes from, such as 60deg, 225true or NE."""

    def _wind(self, asked: _Asked, wind: "Wind | WindTable") -> "Wind | WindTable":
        """Return the wind to compute with."""
        speed, from_ = wind.speed, wind.bearing
        if self.wind is not None:
            speed = speed_given("--wind", self.wind).value(asked.terms)
        if self.wind_from is not None:
            from_ = bearing_given("--from", self.wind_from, asked.heading)
        if from_ is None and speed is not None:
            raise UsageFault("--from is missing: where the wind comes from, such as --from 60deg")
        if speed is None and from_ is not None:
            raise UsageFault("--wind is missing: how fast the wind is, such as --wind 25kn")
        return replace(wind, speed=speed, bearing=from_)


@dataclass(frozen=True)
class _Current(_Options):
    """The current."""

    current: Speed = None
    """Speed of the current, such as 1.5kn."""
    current_from: Bearing = None
    """Where the current comes from, such as 90deg; from where the wind comes unless given."""

    def _current(self, asked: _Asked, current: "Current | None") -> "Current | None":
        """Return the current to compute with."""
        if self.current is None and self.current_from is None:
            return current
        if current is None:
            option = "--current" if self.current is not None else "--current-from"
            advice = (
                f"environment.current: is missing, so {option} has nothing to set; say what the "
                "object shows to it, such as `current: {frontal_area: 110, lateral_area: 465}`"
            )
            raise missing(asked.scenario, asked.file, "current", option, advice)
        if self.current is not None:
            speed = speed_given("--current", self.current).value(asked.terms)
            current = replace(current, speed=speed)
        if self.current_from is None:
            return current
        from_ = bearing_given("--current-from", self.current_from, asked.heading)
        return replace(current, bearing=from_)


@dataclass(frozen=True)
class _Sea(_Options):
    """The sea."""

    waves: Annotated[str | None, Parameter(metavar="SEA")] = None
    """The sea: wind for the one that goes with the wind, or its significant height and peak
    period, such as 2.1m,7.5s."""
    waves_from: Bearing = None
    """Where the sea comes from; from where the wind comes unless given."""

    def _waves(self, asked: _Asked, waves: "Waves | None") -> "Waves | None":
        """Return the sea to compute with."""
        from swarmgrasp.environment import Waves

        if self.waves is not None:
            height, period = None, None
            if self.waves != WITH_WIND:
                height, period = (each.value(asked.terms) for each in sea_given(self.waves))
            waves = replace(waves or Waves(), height=height, period=period)
        if self.waves_from is None:
            return waves
        if waves is None:
            raise UsageFault("--waves-from is of no sea: give --waves, such as --waves wind")
        return replace(waves, bearing=bearing_given("--waves-from", self.waves_from, asked.heading))


@Parameter(name="*", group="Weather")
@dataclass(frozen=True)
class Water(_Sea, _Current):
    """The current and the sea, instead of those of the file."""


@Parameter(name="*", group="Weather")
@dataclass(frozen=True)
class Streams(_Current, _Wind):
    """The wind and the current, instead of those of the file."""


@Parameter(name="*", group="Weather")
@dataclass(frozen=True)
class Weather(_Sea, _Current, _Wind):
    """Wind, current and sea to hold the object in, instead of the load of the file."""

    @property
    def water(self) -> Water:
        """What is given of the current and the sea."""
        return Water(self.current, self.current_from, self.waves, self.waves_from)

    def environment(
        self, scenario: "Scenario", file: str, terms: "Terms", needed_by: str
    ) -> "Environment":
        """Return the surroundings to compute with, a steady wind among them.

        Raises
        ------
        UsageFault
            As for `Water`, or if nothing says where the wind comes from, or how fast it is.
        """
        around = super().environment(scenario, file, terms, needed_by)
        return around if around.is_steady else _without_wind(around)

    def on(self, scenario: "Scenario", file: str, phrasing: Phrasing) -> "Scenario":
        """Return a scenario whose criterion is to hold the object in this weather, if it is given.

        Raises
        ------
        UsageFault
            If the scenario does not say what the object shows to it, or an option does not fit.
        """
        if not self.given:
            return scenario
        around = self.environment(scenario, file, phrasing.terms(scenario), next(iter(self.given)))
        outline, criterion = scenario.swarm.outline, scenario.criterion
        if criterion.has_load and not scenario.is_in_weather:
            complain([f"{source_of(file)}: the weather given takes the place of the file's load"])
        surge, sway, yaw = around.load(outline).tolist()
        return replace(
            scenario, environment=around, criterion=replace(criterion, load=(surge, sway, yaw))
        )

    def title(self, scenario: "Scenario", terms: "Terms") -> str:
        """Return the scenario's name, and in which weather it is asked about if that was given."""
        if not self.given:
            return scenario.name
        from swarmgrasp.cli.show.held import weather_of

        return f"{scenario.name} {weather_of(scenario, terms)}"


STILL = Water()
"""As the file has it."""
AS_FILED = Streams()
"""As the file has it."""
CALM = Weather()
"""As the file has it."""


def _without_wind(around: "Environment") -> "Environment":
    """Return surroundings in which no wind blows; what comes with it then comes from nowhere."""
    lacking = [
        f"{option} is missing: where the {what} comes from, such as {option} 90deg"
        for option, what, part in (
            ("--current-from", "current", around.current),
            ("--waves-from", "sea", around.waves),
        )
        if part is not None and part.bearing is None
    ]
    if lacking:
        raise UsageFault(lacking)
    return replace(around, wind=replace(around.wind, speed=0.0, bearing=0.0))
