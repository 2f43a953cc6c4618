"""How forces follow orders, against closed forms."""

import math

import numpy as np
import pytest

from afloat import barge_of
from swarmgrasp import Robot
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.simulation import Actuator, Plant

LIMIT = 100.0
CALM = np.zeros((1, 4))


def held(actuator, **robot):
    """Return a plant of one robot, mounted at the middle."""
    swarm, hull, sea = barge_of([Robot((0.0, 0.0), 0.3, LIMIT, "R", mounted=True, **robot)])
    return Plant(swarm, hull, sea, actuator)


def after(plant, start, order, time, steps):
    """Return force and angle some time after an order."""
    state = plant.rest()
    state[0, 6:] = start
    found = plant.advance(state, np.array([[order]]), CALM, None, time / steps, steps)
    return found[0, 6:]


@pytest.mark.parametrize("steps", [1, 7, 100])
def test_forces_follow_exactly(steps):
    """Lag alone, slew alone, both across the instant at which one takes over, and neither."""
    alone = held(Actuator(lag=5.0, slew=0.0))
    assert after(alone, (0.0, 0.3), (80.0, 0.3), 8.0, steps)[0] == pytest.approx(
        80.0 * -math.expm1(-8.0 / 5.0), rel=1e-12
    )
    slew = held(Actuator(lag=0.0, slew=10.0))
    assert after(slew, (90.0, 0.3), (20.0, 0.3), 3.0, steps)[0] == pytest.approx(60.0, rel=1e-12)
    assert after(slew, (90.0, 0.3), (20.0, 0.3), 7.5, steps)[0] == pytest.approx(20.0, rel=1e-12)
    both = held(Actuator(lag=4.0, slew=10.0))  # 10 N/s to 60 N from the end 4 s x 10 N/s before it
    assert after(both, (0.0, 0.3), (100.0, 0.3), 6.0, steps)[0] == pytest.approx(60.0, rel=1e-12)
    assert after(both, (0.0, 0.3), (100.0, 0.3), 9.0, steps)[0] == pytest.approx(
        100.0 - 40.0 * math.exp(-3.0 / 4.0), rel=1e-12
    )
    assert after(held(Actuator(0.0, 0.0)), (0.0, 0.3), (70.0, 0.3), 1e-3, steps)[0] == 70.0


def test_angles_follow_as_far_as_they_may():
    """12 deg/s and a lag of 3 s; around the shorter way, but never through what a sector leaves."""
    turning = Actuator(turn_rate=math.radians(12.0), turn_lag=3.0)
    azimuth, sector = held(turning, steers=math.pi), held(turning, steers=math.radians(170.0))
    start, order = math.radians(150.0), math.radians(-150.0)
    around = after(azimuth, (50.0, start), (50.0, order), 1.0, 10)[1]
    assert math.remainder(around - math.radians(162.0), math.tau) == pytest.approx(0.0, abs=1e-12)
    within = after(sector, (50.0, start), (50.0, order), 1.0, 10)[1]
    assert within == pytest.approx(math.radians(138.0), abs=1e-12)
    left = after(azimuth, (50.0, start), (50.0, order), 5.0, 10)[1] - order  # 36 deg are not ramped
    expected = -math.radians(36.0) * math.exp(-3.0 / 3.0)
    assert math.remainder(left, math.tau) == pytest.approx(expected, rel=1e-11)
    line = held(turning)
    assert after(line, (50.0, 0.3), (50.0, 1.0), 5.0, 10)[1] == 0.3


def test_forces_of_convex_sets_stay_in_them():
    """From one side of a friction cone to the other the force goes straight, not around."""
    finger = held(Actuator(slew=0.0, lag=5.0), friction=0.5)
    start, end = 60.0 * np.exp(1j * 0.7), 50.0 * np.exp(-1j * 0.1)
    for time in (0.5, 3.0, 12.0):
        force, angle = after(finger, (60.0, 0.7), (50.0, -0.1), time, 6)
        wanted = end + (start - end) * math.exp(-time / 5.0)
        assert force * np.exp(1j * angle) == pytest.approx(wanted, rel=1e-12)


def test_orders_are_the_forces_wanted():
    """Signed along a line, within the sector where it turns, back to its own angle for nothing."""
    vectors = np.array([[[-30.0 * math.cos(0.3), -30.0 * math.sin(0.3)]]])
    both_ways = held(Actuator(), reverse_limit=40.0).orders(vectors)
    np.testing.assert_allclose(both_ways, [[[-30.0, 0.3]]])
    steers = held(Actuator(), steers=0.5)
    np.testing.assert_allclose(steers.orders([[[0.0, 40.0]]]), [[[40.0, 0.8]]])
    np.testing.assert_allclose(steers.orders([[[0.0, 0.0]]]), [[[0.0, 0.3]]])
    least = held(Actuator(), least=15.0)
    np.testing.assert_allclose(least.rest(), [[0, 0, 0, 0, 0, 0, 15.0, 0.3]])


def test_efficiency_and_the_earth():
    """What is lost does not arrive; a force on a line stays while the object turns under it."""
    plant = held(Actuator(efficiency=0.8, follows="earth"))
    turned = Plant(plant.swarm, plant.hull, plant.environment, plant.actuator, {}, {"R": 0.2})
    state = plant.rest()
    state[0, 2], state[0, 6] = 0.9, 50.0
    for one, kept in ((plant, 0.0), (turned, 0.2)):
        x, y, _ = one.given(state)[0]
        assert math.hypot(x, y) == pytest.approx(40.0)
        assert math.atan2(y, x) == pytest.approx(0.3 + kept - 0.9)


def test_every_fault_is_told_at_once():
    """Negative times, an efficiency of more than all, and a mass at the end of a line."""
    with pytest.raises(SimulationInvalid) as caught:
        Actuator(-1.0, "2", 0.0, float("inf"), 1.1, -5.0, "ship")
    assert len(caught.value.faults) == 7
    with pytest.raises(SimulationInvalid, match="on a line and moves by itself"):
        Actuator(mass=1e5, follows="earth")
    assert Actuator.from_data(Actuator().to_data()) == Actuator()
