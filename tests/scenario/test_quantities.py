"""Any number of a scenario file may bring a unit of its own."""

import jsonschema
import pytest
from ruamel.yaml import YAML

from swarmgrasp.environment import KNOT
from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.scenario import Scenario, parse_scenario, scenario_schema

PLAIN = """
units: {length: m, force: kN, angle: deg, speed: m/s}
outline: {vertices: [[-40, -10], [40, -10], [40, 10], [-40, 10]], origin: [1, 0]}
metric: {characteristic_length: 40}
robots:
  - {name: a, contact: [0, -10], direction: 90, limit: 500, steers: 30,
     tolerance: {contact: [-1, 2]}}
  - {name: b, at: 100, direction: -90, limit: {ahead: 510, astern: 400}}
  - {name: c, edge: 1, along: 5, direction: inward, limit: [20, 200]}
  - {name: d, theta: 180, sectors: [[-60, -10], [10, 60]], limit: 500, tolerance: {direction: 5}}
  - {name: e, contact: [10, 0], mounted: true, direction: 90, envelope: [[60, 0], [40, 30], [0, 0]]}
newcomer: {limit: 600, attachment: push, half_angle: 30, tolerance: {least_limit: 500}}
zones: [{edge: 3, directions: [-30, 30]}, {from: 5, to: 15}]
spacing: 2
criterion: {load: [0, -20, 100], task: {ellipsoid: [[50, 0, 0], [0, 50, 0], [0, 0, 1000]]}}
environment:
  wind: {vessel: tender, frontal_area: 100, lateral_area: 200, speed: 7.9, from: 45, density: 1.2}
  current: {frontal_area: 10, lateral_area: 20, speed: 0.5, from: -30}
simulation:
  hull: {mass: 400000, added: [10000, 20000, 3e6], inertia: 2e8, centre: [0, 0], added_at: [0, 0]}
  duration: 600
  robots: {lag: 2, turn_rate: 12}
  weather: {series: [[0, 10, 45], [300, 12, 60]]}
  control: {heading_noise: 0.5, position_noise: 0.2}
  events: [{at: 60, lose: a, noticed: 5}, {at: 120, move: [2, 0, 10]}]
"""
TOLD = """
units: {length: ft, force: lbf, angle: rad, speed: knots}
outline:
  vertices: [[-40 m, -10 m], [40 m, -1000 cm], [40m, 10 m], [-40 m, 10 m]]
  origin: [1 m, 0]
metric: {characteristic_length: 0.04 km}
robots:
  - {name: a, contact: [0, -10 m], direction: 90 deg, limit: 500 kN, steers: 30 degrees,
     tolerance: {contact: [-1 m, 2 m]}}
  - {name: b, at: 100 m, direction: -90°, limit: {ahead: 510 kN, astern: 0.4 MN}}
  - {name: c, edge: 1, along: 5 m, direction: inward, limit: [20 kN, 200000 N]}
  - {name: d, theta: 180 deg, sectors: [[-60 deg, -10 deg], [10 deg, 60 deg]], limit: 500 kN,
     tolerance: {direction: 5 deg}}
  - {name: e, contact: [10 m, 0], mounted: true, direction: 90 deg,
     envelope: [[60 kN, 0], [40 kN, 30 kN], [0, 0]]}
newcomer: {limit: 600kN, attachment: push, half_angle: 30 deg, tolerance: {least_limit: 500 kN}}
zones: [{edge: 3, directions: [-30 deg, 30 deg]}, {from: 5 m, to: 15 m}]
spacing: 2 metres
criterion:
  load: [0, -20 kN, 100 kN m]
  task: {ellipsoid: [[50 kN, 0, 0], [0, 50 kN, 0], [0, 0, 1 MN m]]}
environment:
  wind: {vessel: tender, frontal_area: 100 m2, lateral_area: 200 square metres, speed: 4 Bft,
         from: 45 deg, density: 1.2 kg/m³}
  current: {frontal_area: 10 m^2, lateral_area: 20 m^2, speed: 1.8 km/h, from: -30 deg}
simulation:
  hull:
    {mass: 400 t, added: [10 t, 20 t, 3000 t m^2], inertia: 200000 t m2, centre: [0, 0],
     added_at: [0, 0]}
  duration: 10 min
  robots: {lag: 2 s, turn_rate: 12 deg/s}
  weather: {series: [[0, 10 m/s, 45 deg], [5 min, 12 m/s, 60 deg]]}
  control: {heading_noise: 0.5 deg, position_noise: 20 cm}
  events: [{at: 1 min, lose: a, noticed: 5 s}, {at: 2 min, move: [2 m, 0, 10 deg]}]
"""


def told(text: str) -> list[str]:
    """Return the faults of a text without the file's name."""
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(text, "a.yaml")
    return [fault.removeprefix("a.yaml:") for fault in caught.value.faults]


def assert_equal(one: object, other: object, path: str = "") -> None:
    """Compare plain data, numbers to rounding."""
    if isinstance(one, dict) and isinstance(other, dict):
        assert one.keys() == other.keys(), path
        for key in one:
            assert_equal(one[key], other[key], f"{path}.{key}")
    elif isinstance(one, list) and isinstance(other, list):
        assert len(one) == len(other), path
        for i, pair in enumerate(zip(one, other, strict=True)):
            assert_equal(*pair, f"{path}.{i}")
    elif isinstance(one, float):
        assert one == pytest.approx(other, rel=1e-12, abs=1e-9), path
    else:
        assert one == other, path


def data_of(scenario: Scenario) -> object:
    """Return all that a scenario asks as plain data."""
    assert scenario.environment is not None
    assert scenario.simulation is not None
    return {
        "problem": scenario.problem().to_data(),
        "environment": scenario.environment.to_data(),
        "simulation": scenario.simulation.to_data(),
    }


def test_a_file_of_quantities_asks_what_one_of_numbers_asks() -> None:
    """Whatever the units of the file; an editor with the schema sees no fault in either."""
    assert_equal(data_of(parse_scenario(TOLD)), data_of(parse_scenario(PLAIN)))
    for text in (TOLD, PLAIN):
        jsonschema.validate(YAML(typ="safe", pure=True).load(text), scenario_schema())


HEAD = "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}\n"


def test_a_quantity_in_the_unit_of_the_file_is_the_number_itself() -> None:
    """To the last bit: 0.1 deg is what 0.1 is."""
    texts = [
        f"units: {{angle: deg, force: t}}\n{HEAD}robots: [{{at: 1, direction: {d}, limit: {f}}}]"
        for d, f in (("0.1", "0.3"), ("0.1 degrees", "0.3 tonne-force"))
    ]
    one, other = (parse_scenario(text).swarm.robots[0] for text in texts)
    assert one == other


@pytest.mark.parametrize(
    ("vertices", "precision"),
    [
        ("[[0, 0], [10.125, 0], [10.125, 5]]", 0.0005),
        ("[[0, 0], [10.125 m, 0], [10.125, 5 m]]", 0.0005),
        ("[[0, 0], [10.125 ft, 0], [10.125 ft, 5 ft]]", 0.0005 * 0.3048),
        ("[[0, 0], [60 ft, 0], [60 ft, 20 ft]]", 0.0),
        ("[[0, 0], [60 ft, 0], [60 ft, 5.125]]", 0.0),
    ],
)
def test_an_outline_is_known_as_well_as_it_is_written(vertices: str, precision: float) -> None:
    """By its decimals in the unit that it is written in, not by those that conversion gives it."""
    outline = parse_scenario(f"outline: {{vertices: {vertices}}}\nrobots: []").swarm.outline
    assert outline.precision == pytest.approx(precision, rel=1e-12)


def test_one_anchor_is_a_force_here_and_a_mass_there() -> None:
    """A t is what is wanted where it stands."""
    text = (
        f"{HEAD}robots: [{{at: 1, direction: inward, limit: &it 5 t}}]\n"
        "environment:\n"
        "  wind: {vessel: tender, frontal_area: 1, lateral_area: 2, speed: 1, from: 0}\n"
        "  current: {frontal_area: 1, lateral_area: 2}\n"
        "simulation: {hull: {mass: *it, draught: 0.5}}\n"
    )
    scenario = parse_scenario(text)
    assert scenario.swarm.limits.tolist() == [5 * 9806.65]
    assert scenario.simulation is not None
    assert scenario.simulation.hull.mass == 5000.0


def test_every_slip_is_told_with_its_place() -> None:
    """Of several quantities at once, and beside other faults."""
    text = (
        f"{HEAD}robots:\n"
        "  - {at: 1 s, direction: 90 dg, limit: 25 kn}\n"
        "  - {at: 1, direction: inward, limit: {ahead: 5 tons, astern: '5'}}\n"
        "spacing: 1,5\n"
    )
    assert told(text) == [
        "3:10: robots.0.at: 's' is a unit of time, not of length; "
        "known: m, mm, cm, km, ft, in (got '1 s')",
        "3:26: robots.0.direction: there is no unit of angle 'dg'; did you mean 'deg'? "
        "(got '90 dg')",
        "3:40: robots.0.limit: 'kn' is a unit of speed, not of force; did you mean 'kN'? "
        "(got '25 kn')",
        "4:47: robots.1.limit.ahead: a ton may be short, long or metric; write t for the metric "
        "one, or kip, 1000 pounds-force (got '5 tons')",
        "4:63: robots.1.limit.astern: should be a number (got '5')",
        "5:10: spacing: '1,5' has a comma; write decimals after a point",
    ]


def test_a_file_in_beaufort_means_the_strongest_wind_of_each_number() -> None:
    """Of the wind; a current needs a unit of its own."""
    wind = "frontal_area: 1, lateral_area: 2, speed: 4, from: 0"
    text = (
        f"units: {{speed: Bft}}\n{HEAD}robots: []\n"
        f"environment: {{wind: {{vessel: tender, {wind}}}, "
        "current: {frontal_area: 1, lateral_area: 2, speed: 1 kn}}\n"
    )
    environment = parse_scenario(text).environment
    assert environment is not None
    assert environment.current is not None
    assert (environment.wind.speed, environment.current.speed) == (7.9, KNOT)
    assert told(text.replace("speed: 4", "speed: 4.5"))[0].startswith(
        "4:79: environment.wind.speed: Beaufort 4.5 is no step of the scale"
    )
