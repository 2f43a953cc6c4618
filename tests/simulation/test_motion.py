"""The kernel of motion against NumPy."""

import math

import numpy as np
import pytest

import motion_by_hand
from afloat import barge_of, random_run
from swarmgrasp.simulation import Plant


@pytest.mark.parametrize("seed", range(4))
def test_motion_is_that_of_numpy(seed):
    """Robots of every kind, an origin off midship, gusts, masses attached and damping: 1e-12."""
    plant, states, orders, streams, loads = random_run(seed, 5)
    found = plant.advance(states, orders, streams, loads, 0.3, 40)
    truth = motion_by_hand.advance(plant, states, orders, streams, loads, 0.3, 40)
    n = len(plant)
    turns = slice(6 + n, None)
    apart = np.remainder(found[:, turns] - truth[:, turns] + math.pi, math.tau) - math.pi
    assert np.abs(apart).max() < 1e-11
    scale = np.abs(truth[:, : 6 + n]).max(axis=0)
    assert (np.abs(found - truth)[:, : 6 + n] <= 1e-12 * scale).all()
    wind, water = motion_by_hand.loads(plant, states, streams)
    np.testing.assert_allclose(plant.wind(states, streams), wind, rtol=1e-12, atol=1e-6)
    np.testing.assert_allclose(plant.load(states, streams), wind + water, rtol=1e-12, atol=1e-6)
    given = motion_by_hand.given(plant, states)
    np.testing.assert_allclose(plant.given(states), given, rtol=1e-12, atol=1e-6)


def test_a_run_does_not_know_of_others():
    """The same bytes in a batch of 1 and of 7."""
    plant, states, orders, streams, loads = random_run(0, 7)
    together = plant.advance(states, orders, streams, loads, 0.1, 50)
    for k in range(7):
        one = slice(k, k + 1)
        alone = plant.advance(states[one], orders[one], streams[one], loads[one], 0.1, 50)
        assert alone.tobytes() == together[one].tobytes()
        assert plant.given(alone).tobytes() == plant.given(together)[one].tobytes()
        wind = plant.load(together, streams)[one]
        assert plant.load(alone, streams[one]).tobytes() == wind.tobytes()
    vectors = np.random.default_rng(1).normal(size=(7, len(plant), 2))
    alone = [plant.orders(vectors[k : k + 1]) for k in range(7)]
    assert np.concatenate(alone).tobytes() == plant.orders(vectors).tobytes()


def test_steps_may_be_taken_in_several_calls():
    """Ten and ten steps are twenty."""
    plant, states, orders, streams, loads = random_run(1, 3)
    once = plant.advance(states, orders, streams, loads, 0.2, 20)
    twice = plant.advance(states, orders, streams, loads, 0.2, 10)
    twice = plant.advance(twice, orders, streams, loads, 0.2, 10)
    np.testing.assert_allclose(twice, once, rtol=1e-13, atol=1e-13)


def test_nobody_pushes():
    """A hull without robots drifts with the water."""
    swarm, hull, sea = barge_of([])
    plant = Plant(swarm, hull, sea)
    streams = np.array([[0.5, -0.2, 0.5, -0.2]])
    found = plant.advance(plant.rest(), np.zeros((1, 0, 2)), streams, None, 1.0, 100)
    np.testing.assert_allclose(found, [[50.0, -20.0, 0.0, 0.0, 0.0, 0.0]], atol=1e-12)
