"""Robots, newcomers and zones refuse values outside their range, all faults at once."""

import math

import pytest

from swarmgrasp.errors import RobotInvalid, ZoneInvalid
from swarmgrasp.outline import Stretch
from swarmgrasp.swarm import Newcomer, Robot, Zone


def test_a_robot_keeps_its_contact_as_two_floats():
    """Integers and lists are welcome."""
    robot = Robot([1, 2], direction=0.5)
    assert robot.contact == (1.0, 2.0)
    assert (robot.limit, robot.name, robot.mounted) == (1.0, "", False)


def test_a_robot_names_every_fault_at_once():
    """Contact, direction and limit each get a sentence that begins with the name."""
    with pytest.raises(RobotInvalid) as caught:
        Robot((math.nan, 0.0), direction=math.inf, limit=0.0, name="tug")
    assert len(caught.value.faults) == 3
    assert all(fault.startswith("tug: ") for fault in caught.value.faults)
    assert "1e-100 <= limit <= 1e+100 [N]" in caught.value.faults[2]


@pytest.mark.parametrize("limit", [-1.0, 0.0, math.inf, math.nan])
def test_a_limit_is_positive_and_finite(limit):
    """For robots in place and for newcomers alike."""
    with pytest.raises(RobotInvalid, match=r"1e-100 <= limit <= 1e\+100"):
        Robot((0, 0), 0.0, limit)
    with pytest.raises(RobotInvalid, match="newcomer: the limit is"):
        Newcomer(limit)


@pytest.mark.parametrize("contact", [(), (1.0,), (1.0, 2.0, 3.0)])
def test_a_contact_is_two_numbers(contact):
    """Not one, not three."""
    with pytest.raises(RobotInvalid, match="two finite numbers"):
        Robot(contact, 0.0)


@pytest.mark.parametrize(
    ("attachment", "half_angle", "says"),
    [
        ("glue", None, "'glue'; it should be push, pull or free"),
        ("free", 0.1, "takes no half angle"),
        ("push", -0.1, "0 <= half angle <= pi/2"),
        ("pull", 1.6, "0 <= half angle <= pi/2"),
        ("push", math.nan, "0 <= half angle <= pi/2"),
    ],
)
def test_attachments_and_half_angles_are_checked(attachment, half_angle, says):
    """The same rules for a newcomer and for a zone that overrides it."""
    with pytest.raises(RobotInvalid, match=says):
        Newcomer(attachment=attachment, half_angle=half_angle)
    with pytest.raises(ZoneInvalid, match=says):
        Zone(Stretch(0.0, 1.0, "quay"), attachment=attachment, half_angle=half_angle)


@pytest.mark.parametrize("half_angle", [None, 0.0, math.pi / 2])
def test_the_ends_of_the_half_angle_range_are_allowed(half_angle):
    """Exactly along the normal, and the whole side."""
    assert Newcomer(attachment="push", half_angle=half_angle).half_angle == half_angle


def test_a_zone_names_every_fault_at_once():
    """A half angle alone and a bad direction range."""
    with pytest.raises(ZoneInvalid) as caught:
        Zone(Stretch(0.0, 1.0, "quay"), half_angle=0.1, directions=(0.0, math.nan))
    assert len(caught.value.faults) == 2
    assert all(fault.startswith("zone 'quay': ") for fault in caught.value.faults)
