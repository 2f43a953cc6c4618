"""Weather: gusts of the published spectrum, each run's own, whatever the batch."""

import math

import numpy as np
import pytest

from moored import moored
from swarmgrasp.simulation.weather import Gusts, Mean, Streams, Weather, mean_of, npd_spectrum


@pytest.mark.parametrize("mean", [10.0, 18.0])
def test_gusts_are_as_strong_as_the_rule_says_and_a_little_more(mean: float) -> None:
    """Standard deviation of 40 hours against 0.06 (1 + 0.043 U) U (NORSOK N-003)."""
    speeds = Gusts(range(40)).speeds(0, 3600, 1.0, np.array([mean]))
    rule = 0.06 * (1.0 + 0.043 * mean) * mean
    assert 1.0 < speeds.std() / rule < 1.1
    assert abs(speeds.mean()) < 0.1


def test_the_spectrum_falls_as_turbulence_does_and_has_the_spread_that_is_told() -> None:
    """With the power -5/3 at high frequencies; its integral is the variance."""
    high = np.array([20.0, 60.0])
    slope = np.diff(np.log(npd_spectrum(high, np.array(15.0)))) / np.diff(np.log(high))
    assert slope[0] == pytest.approx(-5.0 / 3.0, abs=0.04)
    edges = np.geomspace(1.0 / 1200.0, 0.5, 4001)
    middle = np.sqrt(edges[1:] * edges[:-1])
    variance = np.sum(npd_spectrum(middle, np.array(15.0)) * np.diff(edges))
    spread = Gusts(range(200)).spread(np.array([15.0]))
    assert np.sqrt(np.mean(spread**2)) == pytest.approx(math.sqrt(variance), rel=0.01)
    assert np.ptp(spread) > 0.0


def test_gusts_are_sums_of_cosines() -> None:
    """As written out, from any instant on, with its own waves for each seed."""
    gusts, mean = Gusts([5, 6, 7]), np.array([12.0])
    rng = np.random.default_rng(np.random.SeedSequence(6, spawn_key=(0,)))
    draws, edges = rng.random((2, 80)), np.geomspace(1.0 / 1200.0, 0.5, 81)
    frequencies = edges[:-1] + draws[0] * np.diff(edges)
    sizes = np.sqrt(2.0 * npd_spectrum(frequencies, mean) * np.diff(edges))
    times = 0.1 * np.arange(500, 560)
    waves = np.cos(2.0 * np.pi * (frequencies * times[:, None] + draws[1]))
    found = gusts.speeds(500, 60, 0.1, mean)
    np.testing.assert_allclose(found[1], waves @ sizes, atol=1e-9)


def test_a_calm_has_no_gusts() -> None:
    """Nor does the spectrum fail there."""
    speeds = Gusts([1]).speeds(0, 10, 0.1, np.zeros(1))
    assert np.abs(speeds).max() < 1e-3


def test_streams_go_where_bearings_do_not_come_from() -> None:
    """Wind from starboard goes to port; gusts are along it; a current may come with it."""
    mean = Mean(*map(np.array, ([8.0], [math.pi / 2], [0.5], [math.pi])))
    block = Streams(Weather("npd"), mean, (1, 2), 0.1).block(3, 4)
    assert block.shape == (4, 2, 4)
    np.testing.assert_allclose(block[..., 0], 0.0, atol=1e-12)
    assert (block[..., 1] > 4.0).all()
    np.testing.assert_allclose(block[..., 2:], np.broadcast_to((0.5, 0.0), (4, 2, 2)), atol=1e-12)
    environment = moored("deck-barge", 20.0, 90.0).environment
    assert mean_of(environment).current_bearing == pytest.approx(math.pi / 2)
