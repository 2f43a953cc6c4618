"""Generators, the metric, and robots that hold nothing."""

import math

import numpy as np
import pytest

import reference
from swarmgrasp.errors import MetricInvalid, RobotOffBoundary
from swarmgrasp.outline import Outline
from swarmgrasp.robot import Robot
from swarmgrasp.swarm import Swarm

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]


def test_generators_by_hand():
    """(F_x, F_y, c x F) times the limit: pulling, pushing, and along the edge."""
    robots = [
        Robot((1, 0.5), 0.0, 2.0),
        Robot((0.25, 1), -math.pi / 2, 4.0),
        Robot((-1, 1), math.pi / 4, math.sqrt(2.0)),
    ]
    expected = [[2, 0, -1], [0, -4, -1], [1, 1, -2]]
    np.testing.assert_allclose(Swarm(Outline(SQUARE), robots).generators, expected, atol=1e-15)


def test_moments_are_about_the_origin_wherever_the_object_lies():
    """Moving the frame changes nothing; moving the origin changes the torque."""
    far = Outline(np.add(SQUARE, (100, 50)))
    tug = Robot((101, 50.5), 0.0)
    assert Swarm(far, [tug]).generators.tolist() == [[1.0, 0.0, -0.5]]
    off = Outline(np.add(SQUARE, (100, 50)), origin=(100, 49))
    assert Swarm(off, [tug]).generators.tolist() == [[1.0, 0.0, -1.5]]


def test_generators_agree_with_the_reference():
    """Random robots on a random stretch of boundary, in a weighted metric."""
    rng = np.random.default_rng(3)
    outline = Outline([(0, 0), (5, 1), (4, 3), (1, 2)])
    contacts = [outline.at_arc_length(s).point for s in rng.uniform(0, outline.perimeter, 9)]
    angles, limits = rng.uniform(0, 7, 9), rng.uniform(0.1, 5, 9)
    robots = [Robot(*row) for row in zip(contacts, angles, limits, strict=True)]
    swarm = Swarm(outline, robots, characteristic_length=2.5, force_weights=(4.0, 0.25))
    truth = reference.generators(contacts, angles, limits, outline.origin, (2.0, 0.5, 0.4))
    np.testing.assert_allclose(swarm.scaled_generators, truth, atol=1e-13)


def test_the_metric_defaults_to_the_largest_radius():
    """Unit force weights and the distance to the farthest corner, said in a sentence."""
    swarm = Swarm(Outline(SQUARE), [])
    assert swarm.characteristic_length == math.sqrt(2.0)
    assert swarm.force_weights == (1.0, 1.0)
    assert "characteristic length 1.41421 m" in swarm.metric_sentence


def test_nobody_is_a_swarm():
    """No robots give an empty (0, 3) array; one more gives one row in the same metric."""
    nobody = Swarm(Outline(SQUARE), [], characteristic_length=3.0, force_weights=(1.0, 2.0))
    assert nobody.generators.shape == (0, 3)
    one = nobody.with_robot(Robot((1, 0), 0.0, name="tug"))
    assert (len(one), one.robot_label(0), one.metric_sentence) == (1, "tug", nobody.metric_sentence)


def test_every_robot_off_the_boundary_is_named_at_once():
    """Each with its distance, the nearest boundary point and the remedy."""
    robots = [
        Robot((1, 0), 0.0),
        Robot((1.5, 0), 0.0, name="tug"),
        Robot((0, 0), 0.0),
        Robot((0, -3), 0.0, name="pod", mounted=True),
    ]
    with pytest.raises(RobotOffBoundary) as caught:
        Swarm(Outline(SQUARE), robots)
    tug, nameless, pod = caught.value.faults
    assert tug.startswith("tug at (1.5, 0) m is 0.5 m off the boundary")
    assert "(1, 0) m on edge 1" in tug
    assert nameless.startswith("robot 2 at (0, 0) m is 1 m off")
    assert nameless.endswith("declare it mounted if it sits inside the outline")
    assert pod.endswith("a mounted robot should be inside the outline")


def test_a_mounted_robot_may_sit_inside_or_on_the_boundary():
    """A thruster of the vessel itself."""
    robots = [Robot((0.5, 0.5), 0.0, mounted=True), Robot((1, 0), 0.0, mounted=True)]
    assert Swarm(Outline(SQUARE), robots).generators[:, 2].tolist() == [-0.5, 0.0]


@pytest.mark.parametrize("bad", [0.0, -1.0, math.inf, math.nan])
def test_the_metric_is_positive_and_finite(bad):
    """All three numbers are checked, and all faults shown."""
    with pytest.raises(MetricInvalid) as caught:
        Swarm(Outline(SQUARE), [], characteristic_length=bad, force_weights=(bad, bad))
    assert len(caught.value.faults) == 3
    assert "1e-100 <= value <= 1e+100 [m]" in caught.value.faults[0]
