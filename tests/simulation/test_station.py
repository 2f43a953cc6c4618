"""Parts of station keeping: the reference, the observer, and who is thought to push how hard."""

import math

import numpy as np
import pytest

from moored import moored
from swarmgrasp.simulation.allotting import Allotment
from swarmgrasp.simulation.crew import Crew
from swarmgrasp.simulation.observer import Observer
from swarmgrasp.simulation.reference import Reference

W = 0.07


def test_the_reference_goes_as_a_critically_damped_spring() -> None:
    """The same for any period; its derivatives are those of its pose."""
    fine, coarse = Reference(W), Reference(W)
    for reference in (fine, coarse):
        reference.move((10.0, -4.0), 0.3)
    for k in range(1000):
        fine.advance(0.1 * k, 0.1)
    for k in range(20):
        coarse.advance(5.0 * k, 5.0)
    one, other, gone = fine.at(100.0), coarse.at(100.0), W * 100.0
    left = (1.0 + gone) * math.exp(-gone)
    np.testing.assert_allclose(one.pose, (1.0 - left) * np.array([10.0, -4.0, 0.3]), rtol=1e-9)
    for part, same in zip(one, other, strict=True):
        np.testing.assert_allclose(part, same, rtol=1e-9)
    fine.advance(100.0, 1e-4)
    after = fine.at(100.0001)
    np.testing.assert_allclose((after.pose - one.pose) / 1e-4, one.velocity, rtol=1e-4)
    np.testing.assert_allclose((after.velocity - one.velocity) / 1e-4, one.acceleration, rtol=1e-4)


def test_a_path_begins_where_the_object_is_to_be_then() -> None:
    """It goes from the last aim on, at its speed, and stays at the end."""
    reference = Reference(W)
    reference.move((5.0, 0.0), 0.2)
    reference.follow([(15.0, 0.0), (15.0, 10.0)], 2.0, 50.0)
    for k in range(4000):
        reference.advance(50.0 + 0.1 * k, 0.1)
    np.testing.assert_allclose(reference.at(450.0).pose, (15.0, 10.0, 0.2), atol=1e-6)


def test_the_observer_finds_a_load_that_nobody_told_it_of() -> None:
    """Also in a turned hull with coupled masses: errors die away."""
    matrix = np.array([[4e6, 0.0, -1e6], [0.0, 6e6, 2e7], [-1e6, 2e7, 3e9]])
    load, heading = np.array([3e4, -2e4, 1e6]), 1.1
    poses = np.array([[1.0, 2.0, heading]])
    seen = Observer(0.2, matrix, poses, np.zeros((1, 3)))
    cos, sin = math.cos(heading), math.sin(heading)
    push = np.array([[cos * load[0] + sin * load[1], cos * load[1] - sin * load[0], load[2]]])
    for _ in range(2000):
        seen.predict(-push, 0.1)  # robots that hold the object at rest
        seen.correct(poses, 0.1)
    np.testing.assert_allclose(seen.biases[0], load, rtol=1e-6)
    np.testing.assert_allclose(seen.poses, poses, atol=1e-6)
    np.testing.assert_allclose(seen.velocities, 0.0, atol=1e-6)


def test_robots_are_thought_to_follow_as_they_do() -> None:
    """The model of what they make is what the plant's robots make, also with slews and losses."""
    plant = Crew(moored("deck-barge", 30.0, 60.0)).there
    state, stream = plant.rest(), np.zeros((1, 4))
    allotment = Allotment(plant, np.zeros((1, len(plant), 2)), 0.1)
    for k in range(300):
        wanted = np.array([[2e5, 1e5 * math.sin(0.05 * k), 3e6]])
        vectors = allotment.share_out(wanted).vectors
        state = plant.advance(state, plant.orders(vectors), stream, None, 0.1, 1)
        allotment.follow(vectors)
        given = plant.given(state)
        np.testing.assert_allclose(allotment.made, given, rtol=2e-3, atol=2e3)
    assert plant.given(state)[0, 0] == pytest.approx(2e5, rel=0.01)
