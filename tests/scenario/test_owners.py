"""Questions of owners of vessels, cables and fingers, in files of their kind, by other means."""

import math

import numpy as np
import pytest

from swarmgrasp import WrenchSet, forces, losses, place, quality
from swarmgrasp.scenario import Scenario, parse_scenario

PLATE = """
units: {angle: deg}
outline: {vertices: [[-1.5, -1], [1.5, -1], [1.5, 1], [-1.5, 1]]}
robots:
  - {contact: [1.5, 1], direction: 225, limit: 1}
  - {contact: [-1.5, 1], direction: 315, limit: 1}
  - {contact: [-1.5, -1], direction: 45, limit: 1}
  - {contact: [1.5, -1], direction: %s, limit: 1}
newcomer: {limit: 1, attachment: push}
"""


@pytest.mark.parametrize(
    ("last", "before", "after"), [(135, 0.377964, 0.377964), (154, 0.0, 0.377964)]
)
def test_four_fingers_at_the_corners_of_a_plate(last: float, before: float, after: float) -> None:
    """Form closure or not is their owner's, the numbers are of listed facets and places."""
    answer = place(parse_scenario(PLATE % last).problem())
    assert quality(answer.problem.swarm).value == pytest.approx(before, abs=1e-6)
    assert answer.quality == pytest.approx(after, abs=1e-6)
    assert answer.improves == (before < after)
    assert answer.upper_bound == pytest.approx(after, abs=1e-6)


BOAT = """
units: {angle: deg}
outline: {vertices: [[-2.45, -1.22], [2.45, -1.22], [2.45, 1.22], [-2.45, 1.22]], origin: [0, 0]}
metric: {characteristic_length: 1}
"""
STERN = {"left": (-2.373776, 1.027135), "right": (-2.373776, -1.027135)}
BOW = {"left fore": (1.6, 0.7), "right fore": (1.6, -0.7)}


def boat(places: dict[str, tuple[float, float]], ways: list[float], limit: str) -> str:
    """Return a boat of two-way thrusters."""
    rows = [
        f"  - {{name: {name}, contact: [{x}, {y}], direction: {way} rad, {limit}, mounted: true}}\n"
        for (name, (x, y)), way in zip(places.items(), ways, strict=True)
    ]
    return f"{BOAT}robots:\n{''.join(rows)}"


@pytest.mark.parametrize(
    ("limit", "whole", "left"),
    [
        ("limit: 250, two_way: true", 499.99984, 249.9999),
        ("limit: {ahead: 250, astern: 100}", 199.99994, 99.99997),
    ],
)
def test_a_boat_with_four_thrusters_in_an_x(limit: str, whole: float, left: float) -> None:
    """Both ways alike, and weaker astern; and after the loss of any one."""
    swarm = parse_scenario(boat(STERN | BOW, [0.785, -0.785, -0.785, 0.785], limit)).swarm
    assert quality(swarm).value == pytest.approx(whole, rel=1e-6)
    if "two_way" in limit:
        assert quality(swarm, losing=1).value == pytest.approx(left, rel=1e-6)


def test_where_a_boat_has_a_thruster_inboard_that_pushes_both_ways() -> None:
    """Across, anywhere far enough aft of what turns it: 250 N, as a grid of places finds."""
    more = (
        "newcomer: {limit: 250, mounted: true, two_way: true}\n"
        "zones: [{name: bay, area: [[-1, -0.5], [1.5, -0.5], [1.5, 0.5], [-1, 0.5]]}]\n"
    )
    text = boat(STERN, [0.0, 0.0], "limit: 250, two_way: true")
    answer = place(parse_scenario(text + more).problem())
    assert (answer.quality, answer.upper_bound) == pytest.approx((250.0, 250.0), rel=1e-5)
    assert abs(math.sin(answer.robot.direction)) == pytest.approx(1.0)


def cables(x: float, y: float, *, crossed: bool, limit: float = 100.0) -> str:
    """Return a plate of 0.3 m in a frame of 3 m, on four cables."""
    corners = [(3, 0), (3, 3), (0, 3), (0, 0)]
    ends = [(0.15, -0.15), (0.15, 0.15), (-0.15, 0.15), (-0.15, -0.15)]
    if crossed:
        ends = [(0.15, 0.15), (0.15, -0.15), (-0.15, -0.15), (-0.15, 0.15)]
    rows = [
        f"  - {{contact: [{e[0]}, {e[1]}], limit: {limit}, "
        f"direction: {math.atan2(c[1] - y - e[1], c[0] - x - e[0])!r}}}\n"
        for c, e in zip(corners, ends, strict=True)
    ]
    plate = "[[-0.15, -0.15], [0.15, -0.15], [0.15, 0.15], [-0.15, 0.15]]"
    return (
        f"outline: {{vertices: {plate}, origin: [0, 0]}}\n"
        "metric: {characteristic_length: 0.15}\n"
        f"robots:\n{''.join(rows)}"
        "newcomer: {limit: 100, attachment: pull, half_angle: 80 deg}\n"
    )


@pytest.mark.parametrize(
    ("at", "crossed", "wanted"),
    [
        ((1.5, 1.5), False, 0.0),
        ((1.5, 1.5), True, 98.01980),
        ((1.0, 2.0), False, 0.0),
        ((1.0, 2.0), True, 62.43179),
    ],
)
def test_a_plate_on_four_cables(at: tuple[float, float], crossed: bool, wanted: float) -> None:
    """Straight ones turn nothing; of crossed ones the sum of intervals has been listed."""
    swarm = parse_scenario(cables(*at, crossed=crossed)).swarm
    assert quality(swarm).value == pytest.approx(wanted, abs=1e-5)


def test_a_fifth_cable_and_a_least_force_in_each() -> None:
    """A cable that always has 10 N is one of 90 N beside what all of them then pull."""
    text = cables(1.0, 2.0, crossed=True)
    assert place(parse_scenario(text).problem()).quality == pytest.approx(102.90725, abs=1e-5)
    taut = parse_scenario(text.replace("limit: 100.0", "limit: [10, 100]")).swarm
    assert quality(taut).value == pytest.approx(49.62375, abs=1e-5)


def tank(corners: int, tugs: int) -> Scenario:
    """Return a round tank of 25 m with tugs that push inward, as a many-sided file has it."""
    turns = [math.tau * k / corners for k in range(corners)]
    points = ", ".join(f"[{25 * math.cos(t):.6f}, {25 * math.sin(t):.6f}]" for t in turns)
    rows = [
        f"  - {{edge: {k * corners // tugs}, along: {math.pi * 25 / corners:.6f}, "
        "direction: inward, limit: 40}\n"
        for k in range(tugs)
    ]
    return parse_scenario(
        f"units: {{force: t}}\noutline: {{vertices: [{points}]}}\nrobots:\n{''.join(rows)}"
    )


@pytest.mark.parametrize(("corners", "tugs"), [(36, 4), (360, 5)])
def test_inward_pushes_turn_no_round_tank(corners: int, tugs: int) -> None:
    """What the last decimals of its corners leave is told as no quality."""
    found = quality(tank(corners, tugs).swarm)
    assert found.value <= found.noise
    assert not found.is_force_closure


def test_how_far_a_hexacopter_can_turn() -> None:
    """The published index of two ways to turn its rotors, in N m."""
    turns = np.radians(60.0 * np.arange(6))
    for senses, index in (([1, -1, 1, -1, 1, -1], 1.4861), ([1, 1, -1, -1, 1, -1], 1.1295)):
        arms = [0.275 * np.sin(turns), -0.275 * np.cos(turns), 0.1 * np.array(senses)]
        shape = WrenchSet.from_generators(6.125 * np.column_stack(arms)).mesh()
        assert shape.offsets.min() == pytest.approx(index, abs=5e-5)


SHIP = """
units: {length: m, force: t, angle: deg}
outline:
  vertices: [[-150, -20], [150, -20], [150, 20], [-150, 20]]
  edges: [starboard, bow, port, stern]
  origin: [0, 0]
robots:
  - {name: fwd tug, edge: starboard, along: 220, direction: inward, limit: 59}
  - {name: aft tug, edge: starboard, along: 80, direction: inward, limit: 59}
newcomer: {name: third, limit: 59, attachment: push, half_angle: 20}
criterion: {load: [0, -771.8 kN, 0], task: {polytope: [[0, 1, 0]]}}
"""


def test_two_tugs_of_59_t_hold_a_wind_of_772_kn_one_and_a_half_times() -> None:
    """118 t of 78.7; a third amidships adds all that it has, and one alone does not hold."""
    scenario = parse_scenario(SHIP)
    needed = 771.8 / 9.80665
    load = scenario.criterion.load
    assert 1.0 / forces(scenario.swarm, (0, 0, 0), load=load).largest_share == pytest.approx(
        118.0 / needed, rel=1e-6
    )
    found = quality(scenario.swarm, **scenario.criterion.keywords)
    assert found.value == pytest.approx(118.0 - needed, rel=1e-6)
    answer = place(scenario.problem())
    assert answer.quality == pytest.approx(118.0 + 59.0 - needed, rel=1e-6)
    assert max(loss.after.value for loss in losses(scenario.swarm, load=load)) == 0.0
