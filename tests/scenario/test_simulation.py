"""The simulation of a scenario file: units, defaults, events and faults."""

import math
import re
from dataclasses import replace
from pathlib import Path

import pytest

from swarmgrasp.environment import KNOT
from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.scenario import parse_scenario, scenario_text
from swarmgrasp.simulation.actuator import Actuator
from swarmgrasp.simulation.control import Control
from swarmgrasp.simulation.events import Change, Follow, Leave, Lose, Move, Send
from swarmgrasp.simulation.hull import Hull
from swarmgrasp.simulation.weather import Weather
from swarmgrasp.swarm import Body, Newcomer

WIND = "wind: {vessel: ferry, frontal_area: 1, lateral_area: 2, speed: 1, from: 0}"
CURRENT = "current: {frontal_area: 1, lateral_area: 8}"
HEAD = (
    "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}\n"
    "robots: [{name: Ajax, at: 1, direction: inward, limit: 1}, {name: Boreas, at: 2, "
    "direction: inward, limit: 1}]\n"
    "newcomer: {name: Hector, limit: 2}\n"
)
UNITS = "units: {length: ft, angle: deg, speed: knot}\n"
AROUND = f"environment: {{{WIND}, {CURRENT}}}\n"


def scenario(text: str, around: str = AROUND, units: str = ""):
    return parse_scenario(f"{units}{HEAD}{around}simulation: {text}\n", "a.yaml")


def told(text: str, around: str = AROUND) -> list[str]:
    """Return the faults of a simulation on line 5."""
    with pytest.raises(ScenarioInvalid) as caught:
        scenario(text, around)
    return [fault.removeprefix("a.yaml:") for fault in caught.value.faults]


def test_units_of_a_simulation() -> None:
    """Feet, degrees and knots in the file; seconds and kilograms whatever the units."""
    asked = scenario(
        """
  hull: {draught: 2, block: 0.5}
  robots: {lag: 2, turn_rate: 6, mass: 3, except: [{name: Ajax, efficiency: 0.9, mass: 0}]}
  weather: {gusts: npd, series: [[0, 10, 90], [60, 20, 180]]}
  control: {position_noise: 1, heading_noise: 0.5, frequency: 0.2}
  events:
    - {at: 95, follow: [[50, 0], [50, 20]], speed: 2}
    - {at: 60, lose: Ajax, noticed: 5}
    - {at: 65, send: newcomer, away: 400, from: 90, speed: 3, make_fast: 60}
    - {at: 70, send: Hector, as: Zoe}
    - {at: 80, leave: Hector}
    - {at: 90, move: [10, 20, 5]}
    - {at: 97, current: {speed: 1, from: 10}}""",
        units=UNITS,
    )
    found, ft = asked.simulation, 0.3048
    assert found.hull == Hull.afloat(
        asked.swarm.outline, asked.environment, draught=2 * ft, block=0.5
    )
    usual = Actuator(lag=2.0, turn_rate=math.radians(6), mass=3.0)
    assert found.actuator == usual
    assert found.actuators == (("Ajax", replace(usual, efficiency=0.9, mass=0.0)),)
    assert found.weather.series.speeds.tolist() == [10 * KNOT, 20 * KNOT]
    assert found.weather.series.bearings.tolist() == [math.radians(90), math.radians(180)]
    assert found.control == Control(
        frequency=0.2, position_noise=ft, heading_noise=math.radians(0.5)
    )
    assert found.events == (
        Lose(60.0, "Ajax", 5.0),
        Send(65.0, None, 400 * ft, 3 * KNOT, 60.0, math.radians(90)),
        Send(70.0, replace(asked.newcomer, name="Zoe")),
        Leave(80.0, "Hector"),
        Move(90.0, 10 * ft, 20 * ft, math.radians(5)),
        Follow(95.0, ((50 * ft, 0.0), (50 * ft, 20 * ft)), 2 * KNOT),
        Change(97.0, current_speed=KNOT, current_bearing=math.radians(10)),
    )
    other = scenario("{events: [{at: 97, wind: {speed: 30, from: 5}}]}", units=UNITS).simulation
    assert other.events == (Change(97.0, wind_speed=30 * KNOT, wind_bearing=math.radians(5)),)


def test_what_is_left_out_of_a_simulation_is_as_in_python() -> None:
    """One set of defaults: what the schema says of them is what the objects have."""
    asked = scenario("{}")
    found = asked.simulation
    assert found.actuator == Actuator()
    assert (found.weather, found.control, found.events) == (Weather(), Control(), ())
    assert (found.duration, found.step, found.seed) == (600.0, None, 0)
    assert found.hull == Hull.afloat(asked.swarm.outline, asked.environment)
    assert found.problem == asked.problem()
    assert parse_scenario(HEAD).simulation is None


def test_a_simulation_is_written_and_read_back() -> None:
    """Whatever it says, to the last bit; the hull outright, for the draught is not kept."""
    first = scenario(
        """
  hull: {mass: 5000, centre: [0.1, 0.2], damping: [[1, 0, 0], [0, 2, 0.5], [0, 0.5, 3]]}
  duration: 200
  step: 0.05
  seed: 7
  robots: {follows: earth, turn_rate: 0.3, except: [{name: Zoe, slew: 0}]}
  weather: {gusts: npd}
  control: {period: 0.1, heading_noise: 0.001}
  events:
    - {at: 0.1, lose: Ajax, noticed: 5}
    - {at: 65, send: newcomer, as: Zoe, away: 40, from: 1, speed: 0.3, make_fast: 6}
    - {at: 66, send: newcomer}
    - {at: 67, send: {name: Gyges, limit: 30, attachment: push}, away: 40}
    - {at: 68, send: {limit: {ahead: 5, astern: 3}, length: 2, beam: 1}}
    - {at: 69, send: {name: Ida, limit: 7, attachment: pull, half_angle: 0.5, steers: true}}
    - {at: 70, send: {name: Leda, limit: 7, attachment: push, friction: 0.3}}
    - {at: 71, send: {name: Medon, limit: 2, mounted: true, steers: true, two_way: true}}
    - {at: 72, send: {name: Nireus, limit: 2}}
    - {at: 80, leave: Zoe}
    - {at: 90, move: [10, 20, 0.3]}
    - {at: 95, follow: [[50, 0], [50, 20]], speed: 0.2}
    - {at: 97, wind: {speed: 3, from: 2}, current: {speed: 0.1}}"""
    )
    assert first.simulation.hull.damping[1] == (0.0, 2.0, 0.5)
    assert [event.newcomer for event in first.simulation.events if isinstance(event, Send)] == [
        Newcomer(2.0, name="Zoe"),
        None,
        Newcomer(30.0, "push", name="Gyges"),
        Newcomer(5.0, reverse_limit=3.0, body=Body(2.0, 1.0)),
        Newcomer(7.0, "pull", 0.5, "Ida", steers=True),
        Newcomer(7.0, "push", name="Leda", friction=0.3),
        Newcomer(2.0, name="Medon", mounted=True, steers=True, reverse_limit=2.0),
        Newcomer(2.0, name="Nireus"),
    ]
    measured = scenario("{weather: {series: [[0, 10, 1], [60, 20, 2]]}}")
    for asked in (first, measured):
        again = parse_scenario(scenario_text(asked))
        assert again == asked
        assert scenario_text(again) == scenario_text(asked)


FAULTS = {
    "{hull: {mass: -3}}": "5:27: simulation.hull.mass: should be greater than 0 (got -3)",
    "{seed: 1.5}": "5:20: simulation.seed: should be a whole number (got 1.5)",
    "{duraton: 3}": "5:14: simulation.duraton: unknown key; did you mean 'duration'?",
    "{robots: {lags: 3}}": (
        "5:23: simulation.robots.lags: unknown key; did you mean 'lag'?"
    ),
    "{robots: {except: [{name: Ajx}]}}": (
        "5:39: simulation.robots.except.0.name: there is no such robot, and none is sent; did you "
        "mean 'Ajax'? (got 'Ajx')"
    ),
    "{robots: {except: [{name: Ajax}, {name: Ajax}]}}": (
        "5:53: simulation.robots.except.1.name: is the name of except.0 too; keep one (got 'Ajax')"
    ),
    "{robots: {except: [{lag: 1}]}}": (
        "5:32: simulation.robots.except.0.name: is missing; say which robot"
    ),
    "{weather: {gusts: big}}": (
        "5:31: simulation.weather.gusts: should be 'none' or 'npd' (got 'big')"
    ),
    "{weather: {series: [[1, 2, 0], [0, 2, 0]]}}": (
        "5:32: simulation.weather.series: weather: the times of a series should increase"
    ),
    "{weather: {series: [[0, 2, 0]]}, events: [{at: 5, wind: {speed: 1}}]}": (
        "5:13: simulation: a series says the wind, and an event changes it; leave out one of them"
    ),
    "{control: {period: 1e-9}}": (
        "5:32: simulation.control.period: should lie in [1e-05, 1000] s (got 1e-9)"
    ),
    "{control: {heading_noise: 9}}": (
        "5:39: simulation.control.heading_noise: should lie in [0, 3.142] rad (got 9)"
    ),
    "{hull: {added: [1, 1e200, 1]}}": (
        "5:32: simulation.hull.added.1: should lie in [0, 1e+15] kg (got 1e200)"
    ),
    "{hull: {draught: 1, damping: [[-1, 0, 0], [0, 1, 0], [0, 0, 1]]}}": (
        "5:42: simulation.hull.damping: hull: the damping is [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], "
        "[0.0, 0.0, 1.0]]; it should take energy out of any motion: u' D u >= 0"
    ),
    "{weather: {series: [[0, 2, 0], [1, 1e4, 0]]}}": (
        "5:48: simulation.weather.series.1.1: should lie in [0, 1000] m/s (got 1e4)"
    ),
    "{events: [{at: 5, move: [1, 1e8]}]}": (
        "5:41: simulation.events.0.move.1: should lie in [-1e+07, 1e+07] m (got 1e8)"
    ),
    "{duration: 1e-9}": "5:24: simulation.duration: should lie in [0.001, 1e+06] s (got 1e-9)",
    "{events: [{at: 5, lose: Ajx}]}": (
        "5:23: simulation.events.0: lose at 5 s: there is no robot called 'Ajx' then; did you mean "
        "'Ajax'?"
    ),
    "{events: [{at: 6, lose: Ajax}, {at: 5, leave: Ajax}]}": (
        "5:23: simulation.events.0: lose at 6 s: 'Ajax' is gone since 5 s"
    ),
    "{events: [{at: 5, move: [1, 1]}, {at: 5, follow: [[1, 0]], speed: 1}]}": (
        "5:46: simulation.events.1: follow at 5 s: move says another aim at the same instant"
    ),
    "{events: [{at: 600, leave: Ajax}]}": (
        "5:23: simulation.events.0: leave at 600 s: the run ends at 600 s; it should be before"
    ),
    "{events: [{at: 5, send: Hetor}]}": (
        "5:37: simulation.events.0.send: 'Hetor' should be 'newcomer' or 'Hector', or say what "
        "comes: {name: Hetor, limit: ..}; another name alone is given by `as`"
    ),
    "{events: [{at: 5, send: 7}]}": (
        "5:37: simulation.events.0.send: should be a newcomer's name, or a mapping of keys to "
        "values (got 7)"
    ),
    "{events: [{at: 5, send: {name: Zoe}}, {at: 6, leave: Zoe}]}": (
        "5:37: simulation.events.0.send.limit: is missing; give the largest force"
    ),
    "{events: [{at: 5, send: {limit: 7, half_angle: 1}}]}": (
        "5:60: simulation.events.0.send.half_angle: goes with attachment: push or pull only; a "
        "free one pushes in any direction (got 1)"
    ),
    "{events: [{at: 5, send: {limit: 7, friction: 1}}]}": (
        "5:58: simulation.events.0.send.friction: goes with attachment: push only; a finger pushes "
        "along the normal (got 1)"
    ),
    "{events: [{at: 5, send: {limit: 7, length: 1}}]}": (
        "5:56: simulation.events.0.send.length: goes with beam; give both or neither (got 1)"
    ),
    "{events: [{at: 5, send: {limit: 7}, as: Zoe}]}": (
        "5:53: simulation.events.0.as: goes with a newcomer that is sent by its name; write its "
        "own in send"
    ),
    "{events: [{lose: Ajax}]}": (
        "5:23: simulation.events.0.at: is missing; give the time since the start [s]"
    ),
    "{events: [{at: 5}]}": (
        "5:23: simulation.events.0: should say what happens, by lose, leave, send, move, follow, "
        "wind or current"
    ),
    "{events: [{at: 5, lose: Ajax, leave: Boreas}]}": (
        "5:23: simulation.events.0: lose and leave are more than one event; give each an item of "
        "its own"
    ),
    "{events: [{at: 5, leave: Ajax, noticed: 3}]}": (
        "5:53: simulation.events.0.noticed: goes with lose (got 3)"
    ),
    "{events: [{at: 5, follow: [[1, 0]]}]}": (
        "5:39: simulation.events.0.follow: also needs speed"
    ),
    "{events: [{at: 5, wind: {}}]}": "5:37: simulation.events.0.wind: should say speed or from",
}  # fmt: skip


@pytest.mark.parametrize("text", FAULTS)
def test_a_fault_of_a_simulation_is_told_with_its_place(text: str) -> None:
    """One fault, one sentence, with line, column and key path."""
    assert told(text) == [FAULTS[text]]


def test_faults_of_a_simulation_are_told_at_once() -> None:
    """A wrong number, a wrong robot, two events that exclude each other; none hides another."""
    faults = told(
        "{hull: {mass: -3}, robots: {except: [{name: Zoe}]}, events: [{at: x, leave: Boreas}, "
        "{at: 1, lose: Ajax}, {at: 2, lose: Ajax}, {at: 3, send: Hetor, as: Zoe}, "
        "{at: 4, leave: Zoe}, {at: 5, leave: Nobody}, {at: -1, send: Hector, as: Ida}, "
        "{at: 7, leave: Ida}, {at: 8, leave: Ida}]}"
    )
    keys = [fault.split(": ")[1] for fault in faults]
    assert keys == [
        "simulation.hull.mass",
        "simulation.events.0.at",
        "simulation.events.2",
        "simulation.events.3.send",
        "simulation.events.5",
        "simulation.events.6.at",
        "simulation.events.8",
    ]


@pytest.mark.parametrize(
    ("around", "fault"),
    [
        (
            "",
            "4:13: simulation: needs the environment: what the object shows to the wind, and its "
            "speed",
        ),
        (
            "environment: {wind: {vessel: ferry, frontal_area: 1, lateral_area: 2}}\n",
            "4:21: environment.wind: a simulation needs a wind: its speed, and from, where it "
            "comes from; 0 for a calm",
        ),
        (
            f"environment: {{{WIND}}}\n",
            "5:60: simulation.events.0.current: there is no current in the environment; say what "
            "the object shows it",
        ),
        (
            f"environment: {{{WIND}, waves: {{with_wind: true}}}}\n",
            "4:98: environment.waves: a simulation has no waves: leave them out of a file that has "
            "one",
        ),
    ],
)
def test_what_a_simulation_needs_of_its_file(around: str, fault: str) -> None:
    """An environment, a wind, and a current before it can change."""
    assert told("{hull: {draught: 1}, events: [{at: 1, current: {speed: 1}}]}", around)[0] == fault


def test_nobody_is_sent_where_there_is_no_newcomer() -> None:
    """The file says what comes."""
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(
            f"{HEAD.rpartition('newcomer')[0]}{AROUND}"
            "simulation: {events: [{at: 1, send: newcomer}]}",
            "a.yaml",
        )
    assert list(caught.value.faults) == [
        "a.yaml:4:37: simulation.events.0.send: there is no newcomer; say here what comes, or by "
        "the key newcomer"
    ]


def test_another_kind_is_sent_where_there_is_no_newcomer() -> None:
    """Whom an event describes need not be the one to place; units are those of the file."""
    asked = parse_scenario(
        f"units: {{force: kN, angle: deg}}\n{HEAD.rpartition('newcomer')[0]}{AROUND}"
        "simulation: {events: [{at: 1, send: {limit: 3 t, attachment: push, half_angle: 30}}]}"
    )
    (sent,) = asked.simulation.events
    assert sent.newcomer == Newcomer(3 * 9806.65, "push", math.radians(30))
    assert parse_scenario(scenario_text(asked)) == asked


def test_the_file_on_the_page_is_read_and_written() -> None:
    """What the documentation shows says all of it, and comes back."""
    page = Path(__file__).parents[2].joinpath("docs", "simulation.md").read_text(encoding="utf-8")
    (text,) = re.findall(r"```yaml\n(.*?)```", page, re.DOTALL)
    asked = parse_scenario(text)
    kinds = {type(event) for event in asked.simulation.events}
    assert kinds == {Change, Follow, Leave, Lose, Move, Send}
    assert parse_scenario(scenario_text(asked)) == asked
