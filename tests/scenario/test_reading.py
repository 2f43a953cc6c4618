"""A scenario file means what it says: units, places, directions."""

import math
from pathlib import Path

import pytest

from swarmgrasp.outline import Stretch
from swarmgrasp.scenario import load_scenario, parse_scenario
from swarmgrasp.swarm import Robot, Zone

SQUARE = "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]], edges: [s, e, n, w]}\n"
CLOCKWISE = "outline: {vertices: [[0, 0], [0, 2], [4, 2], [4, 0]], edges: [w, n, e, s]}\n"


def contact(robot: str, outline: str = SQUARE) -> tuple[float, ...]:
    """Return the contact and direction of one robot."""
    scenario = parse_scenario(f"{outline}robots: [{{limit: 1, {robot}}}]")
    (only,) = scenario.swarm.robots
    return (*only.contact, only.direction)


@pytest.mark.parametrize(
    "where",
    ["contact: [4, 1]", "theta: 0", "at: 5", "edge: e, along: 1", "edge: 1, along: 1"],
)
def test_a_contact_can_be_said_in_five_ways(where: str) -> None:
    """All of them name the middle of the east edge."""
    assert contact(f"{where}, direction: inward") == pytest.approx((4, 1, math.pi))


@pytest.mark.parametrize("edge", ["e", "2"])
def test_edges_are_named_and_counted_as_the_file_lists_them(edge: str) -> None:
    """A clockwise outline keeps its names; distances still count counter-clockwise."""
    where = contact(f"edge: {edge}, along: 0.5, direction: outward", CLOCKWISE)
    assert where == pytest.approx((4, 0.5, 0))


def test_a_file_without_a_title_goes_by_its_name_whatever_that_holds(tmp_path: Path) -> None:
    """A name that no terminal or picture could take is made plain."""
    path = tmp_path / "a\x1b[31m\udcff.yaml"
    path.write_text(f"{SQUARE}robots: []\n")
    assert load_scenario(path).name == "a?[31m?"


def test_at_a_corner_the_named_edge_gives_the_normal() -> None:
    """The far end of the south edge is a corner, but the robot holds the south edge."""
    where = contact("edge: s, along: 4, direction: inward")
    assert where == pytest.approx((4, 0, math.pi / 2))


def test_units_are_converted_once_at_the_border() -> None:
    """Feet, tonnes-force and degrees in the file; metres, newtons and radians behind it."""
    scenario = parse_scenario(
        "units: {length: ft, force: tonne-force, angle: deg}\n"
        "outline: {vertices: [[0, 0], [250, 0], [250, 72], [0, 72]], origin: [125, 36]}\n"
        "metric: {characteristic_length: 100}\n"
        "robots: [{at: 250, direction: 90, limit: 2}]\n"
        "newcomer: {limit: 60, attachment: push, half_angle: 90}\n"
        "zones: [{edge: 3, directions: [-30, 30]}]\n"
        "spacing: 10\n"
    )
    assert scenario.swarm.outline.origin == pytest.approx([38.1, 10.9728])
    assert scenario.swarm.characteristic_length == pytest.approx(30.48)
    robot, newcomer = scenario.swarm.robots[0], scenario.newcomer
    assert (*robot.contact, robot.limit) == pytest.approx((76.2, 0, 19613.3))
    assert robot.direction == pytest.approx(math.pi / 2)
    assert newcomer is not None
    assert (newcomer.limit, newcomer.half_angle) == pytest.approx((588_399, math.pi / 2))
    assert scenario.zones is not None
    assert scenario.zones[0].directions == pytest.approx((-math.pi / 6, math.pi / 6))
    assert scenario.spacing == pytest.approx(3.048)


def test_a_two_way_thruster_is_one_robot() -> None:
    """It pushes as hard the other way."""
    scenario = parse_scenario(
        SQUARE + "robots: [{name: X, contact: [1, 1], direction: 0.5, limit: 3, mounted: true,"
        " two_way: true}]"
    )
    assert scenario.swarm.robots == (Robot((1, 1), 0.5, 3.0, "X", mounted=True, reverse_limit=3.0),)


def test_zones_and_no_go_stretches() -> None:
    """Edges, parts of edges, arc lengths across the first vertex, bollards."""
    scenario = parse_scenario(
        SQUARE + "robots: []\n"
        "zones:\n"
        "  - {edge: n}\n"
        "  - {name: part, edge: e, from: 0.5, to: 1, attachment: pull, half_angle: 0}\n"
        "  - {name: bollard, contact: [2, 0]}\n"
        "no_go: [{name: round, from: 11, to: 1}, {from: 12, to: 1}, {from: 11, to: 0}]\n"
    )
    assert scenario.zones == (
        Zone(Stretch(6.0, 10.0, "n")),
        Zone(Stretch(4.5, 5.0, "part"), "pull", 0.0),
        Zone(Stretch(2.0, 2.0, "bollard")),
    )
    assert scenario.no_go == (
        Stretch(11.0, 1.0, "round"),
        Stretch(0.0, 1.0),
        Stretch(11.0, 12.0),
    )


def test_a_small_file_is_enough(tmp_path: Path) -> None:
    """An outline and a list of robots, even an empty one; the file's name is its title."""
    path = tmp_path / "dock.yaml"
    path.write_text("\ufeff" + SQUARE + "robots: []\n", encoding="utf-8")
    scenario = load_scenario(path)
    assert (scenario.name, scenario.newcomer, scenario.zones) == ("dock", None, None)
    assert (len(scenario.swarm), scenario.no_go, scenario.spacing) == (0, (), 0.0)


def test_anchors_and_aliases_save_typing() -> None:
    """The same robot data may be written once."""
    text = "robots: [{at: &here 1, direction: 0, limit: 1}, {at: *here, direction: 1, limit: 1}]"
    first, second = parse_scenario(SQUARE + text).swarm.robots
    assert first.contact == second.contact
