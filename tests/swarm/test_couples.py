"""Pure torque beside all else that holds an object, and swarms from allocation matrices."""

import json
import math
from dataclasses import replace

import numpy as np
import pytest

from swarmgrasp import (
    Newcomer,
    Outline,
    Problem,
    Robot,
    Swarm,
    Tolerance,
    forces,
    losses,
    place,
    quality,
)
from swarmgrasp.errors import RobotInvalid, RobotOffBoundary
from swarmgrasp.forces import Forces
from swarmgrasp.scenario import parse_scenario, scenario_text

MATRIX = np.array([[0, 0, 0, 0, 1, 1], [1, 1, 1, 1, 0, 0], [30, 22, -22, -30, -8, 8]], float)
LIMITS = np.array([200e3, 200e3, 200e3, 200e3, 798.7e3, 798.7e3])
HULL = Outline([(-38.1, -9), (38.1, -9), (38.1, 9), (-38.1, 9)], origin=(0, 0))
GYRO = Robot((0, 0), limit=1e6, reverse_limit=1e6, lever=1.0, mounted=True, name="gyro")


def ship(torque: float = 0.0) -> Swarm:
    """Return the supply vessel of MSS from its matrix, perhaps with so much pure torque."""
    columns = np.hstack([MATRIX, [[0], [0], [1]]]) if torque else MATRIX
    limits = [*LIMITS, torque] if torque else LIMITS
    return Swarm.from_matrix(columns, limits, frame="NED", outline=HULL, characteristic_length=38.1)


def by_sampling(swarm: Swarm) -> float:
    """Return the least height of a swarm of lines, over many normals: no less than its quality."""
    rows = [(r.limit, r.reverse_limit, r.lever, r) for r in swarm]
    normals = np.random.default_rng(7).normal(size=(200_000, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    height = np.zeros(len(normals))
    for ahead, astern, lever, r in rows:
        c, s = math.cos(r.direction), math.sin(r.direction)
        x, y = np.array(r.contact) - swarm.outline.origin
        column = np.array([0, 0, lever] if lever else [c, s, x * s - y * c]) * swarm.scale
        height += np.maximum(ahead * (normals @ column), -astern * (normals @ column))
    return float(height.min())


def test_a_matrix_is_a_swarm() -> None:
    """The published vessel: quality, and after a loss; with pure torque; by sampling no less."""
    assert quality(ship()).value == pytest.approx(748.323e3, abs=1.0)
    assert losses(ship())[0].quality == pytest.approx(465.147e3, abs=1.0)
    turning = ship(1e6)
    value = quality(turning).value
    assert value == pytest.approx(768.669e3, abs=1.0)
    assert value <= by_sampling(turning) <= value * 1.001
    assert losses(turning)[-1].name == "thruster 7"
    assert losses(turning)[-1].quality == pytest.approx(748.323e3, abs=1.0)
    alone = Swarm.from_matrix(MATRIX, LIMITS, frame="NED", characteristic_length=38.1)
    assert quality(alone).value == quality(ship()).value  # whatever the outline
    assert quality(ship().with_robot(GYRO)).value == pytest.approx(value, rel=1e-12)


def test_a_couple_is_two_opposite_forces() -> None:
    """Rays, both ways, and two pushers one of which would tear loose, come to the same torque."""
    assert ship().with_robot(GYRO).generators[-1] == pytest.approx([0.0, 0.0, 1e6], abs=1e-9)
    pushing = [replace(r, reverse_limit=0.0) for r in ship()]
    pushing += [
        replace(r, reverse_limit=0.0, direction=r.direction + math.pi, name="") for r in ship()
    ]
    turning = [replace(GYRO, reverse_limit=0.0, lever=way, name="") for way in (1.0, -1.0)]
    rays = Swarm(HULL, [*pushing, *turning], 38.1)
    assert rays.has_rays_only
    assert quality(rays).value == pytest.approx(quality(ship(1e6)).value, rel=1e-12)
    for wrench in ((1e5, 2e5, 3e6), (0, 0, 5e6), (0, 0, 5e8)):
        of_rays, of_sets = (forces(swarm, wrench) for swarm in (rays, ship().with_robot(GYRO)))
        assert isinstance(of_sets, Forces)
        assert of_rays.verify()
        assert of_sets.verify()
        assert of_sets.largest_share == pytest.approx(of_rays.largest_share, rel=1e-4)
    assert forces(ship().with_robot(GYRO), (0, 0, 5e8)).forces[-1] == pytest.approx(1e6)


def test_placement_stands_beside_couples() -> None:
    """Of one that pushes and of one that steers, and beside one that steers; the check agrees."""
    tug = Newcomer(600e3, "push", half_angle=0.5)
    azimuth = Robot((-38.1, 0), 0.0, 3e5, steers=0.6, mounted=True)
    one_way = Swarm(HULL, [*ship().without("thruster 3"), GYRO, azimuth], 38.1)
    for newcomer in (tug, replace(tug, steers=True)):
        found = place(Problem(one_way, newcomer))
        assert found.quality > found.quality_before > 0.0
        assert found.verify()
    assert found.quality_before == quality(one_way).value


def test_couples_keep_through_all_that_is_done_to_swarms() -> None:
    """Plain data, scenario files, moves, tolerances and losses."""
    swarm = ship().with_robot(GYRO)
    assert Swarm.from_data(json.loads(json.dumps(swarm.to_data()))) == swarm
    text = scenario_text(Problem(swarm, Newcomer(1e5)))
    assert "limit: 1000, two_way: true, lever: 1, mounted: true" in text
    assert parse_scenario(text).swarm["gyro"] == GYRO
    assert parse_scenario(text.replace("lever: 1", "lever: 100 cm")).swarm["gyro"] == GYRO
    assert swarm.with_pose("thruster 1", (29, 0))["gyro"] == GYRO
    moved = swarm.with_pose("gyro", (10, 3))
    assert moved["gyro"].contact == (10, 3)
    assert quality(moved).value == quality(swarm).value
    half = replace(GYRO, tolerance=None, name="half", limit=5e5, reverse_limit=5e5)
    unsure = Swarm(HULL, [*ship(), replace(half, limit=1e6, reverse_limit=5e5)], 38.1)
    sure = Swarm(HULL, [*ship(), half], 38.1)
    doubtful = unsure.with_tolerance(Tolerance(direction=0.0, least_limit=190e3))
    assert doubtful["half"].tolerance.least_limit == 190e3
    assert quality(doubtful, worst_case=True).value < quality(sure).value
    one_way = replace(GYRO, reverse_limit=0.0)
    pushing = [Robot((38.1, y), math.pi + turn, 3e5) for y in (-8, 8) for turn in (-0.5, 0.5)]
    for swarm in (Swarm(HULL, [*pushing, one_way]), ship().with_robot(one_way)):
        weaker = swarm.with_tolerance(Tolerance(least_limit=2e5))
        worst = quality(weaker, worst_case=True)
        assert worst.worst_swarm["gyro"].limit == 2e5
        assert worst.worst_swarm["gyro"].contact == (0, 0)
        assert quality(worst.worst_swarm).value == pytest.approx(worst.value, rel=1e-6, abs=1e-3)


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ({"mounted": False}, "is mounted"),
        ({"steers": 1.0, "friction": 0.5}, "leave out what it steers and the friction"),
        ({"least": 2.0}, "leave out the least force"),
        ({"lever": math.nan}, "the lever is nan"),
        ({"lever": 1e99}, "the lever is 1e+99"),
    ],
)
def test_what_goes_with_no_couple_is_refused(more: dict, said: str) -> None:
    """All of it in words."""
    with pytest.raises(RobotInvalid) as caught:
        replace(GYRO, **more)
    assert any(said in fault for fault in caught.value.faults)
    with pytest.raises(RobotOffBoundary, match="inside the outline"):
        ship().with_robot(replace(GYRO, contact=(0, 99)))


def test_a_couple_in_a_file_says_what_is_wrong() -> None:
    """With the line; clockwise where the file's angles are."""
    text = scenario_text(Problem(ship().with_robot(GYRO), Newcomer(1e5)))
    wrong = text.replace("lever: 1, mounted: true", "lever: 0, direction: 3")
    with pytest.raises(Exception, match="no direction") as caught:
        parse_scenario(wrong)
    assert len(caught.value.faults) == 4  # of the contact, too: what is not on board is outside
    assert parse_scenario("frame: NED\n" + text).swarm["gyro"].lever == -1.0


def test_wrong_matrices_are_refused() -> None:
    """All faults at once: shapes, limits, names, columns of nothing, lines past the outline."""
    with pytest.raises(RobotInvalid) as caught:
        Swarm.from_matrix(
            [[1, 0, 0], [0, 1, 0], [0, 1, 0]], [3, -1, (2, 1)], names=["a", "b", 3], frame="SWE"
        )
    assert len(caught.value.faults) == 5
    with pytest.raises(RobotInvalid, match="3 rows of n finite numbers"):
        Swarm.from_matrix([[1, 2], [3, math.inf]], 5.0)
    with pytest.raises(
        RobotInvalid, match=r"thruster 1: its line of action is 40 m from the origin"
    ):
        Swarm.from_matrix([[1], [0], [40]], [3.0], outline=HULL)
    far = Swarm.from_matrix(
        [[0.6], [0.8], [0]],
        [(-40, 51)],
        outline=Outline([(6, 6), (9, 6), (9, 12), (6, 12)], (0, 0)),
    )
    assert far.robots[0].contact == pytest.approx((6.0, 8.0))
    assert (far.limits[0], far.reverse_limits[0]) == (51.0, 40.0)
    assert Swarm.from_matrix([[1], [0], [0]], [(-51, 0)])["thruster 1"].direction == pytest.approx(
        math.pi
    )
