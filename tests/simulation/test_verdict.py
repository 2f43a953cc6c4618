"""Verdicts: what was held, and what was foretold of what was not."""

import math
from dataclasses import replace

import numpy as np
import pytest

from moored import moored
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.simulation.events import Lose
from swarmgrasp.simulation.simulate import simulate
from swarmgrasp.simulation.verdict import verdict_of
from swarmgrasp.simulation.weather import Weather


def lose(knots: float, name: str, duration: float) -> None:
    """Assert that the loss of a robot of the barge turns out as foretold: held, or lost when."""
    sea = moored("deck-barge", knots, 60.0, duration=duration, events=(Lose(10, name),))
    found = verdict_of(simulate(sea, every=5))
    foretold = found.foretold[1]
    assert found.foretold[0] == math.inf
    assert found.held[0] == (foretold == math.inf), name
    if not found.held[0]:
        assert 1 / 1.6 < (found.left_at[0] - 10.0) / foretold < 1.6, name


@pytest.mark.parametrize("name", ["Boreas", "Castor"])
def test_a_loss_out_of_reach_moves_the_barge_when_foretold(name: str) -> None:
    """By what is missing of the load over the mass."""
    lose(60.0, name, 60.0)


@pytest.mark.long
@pytest.mark.parametrize("knots", [20.0, 60.0])
@pytest.mark.parametrize("name", ["Ajax", "Boreas", "Castor", "Dione", "Electra", "Fortuna"])
def test_each_loss_turns_out_as_the_load_says(name: str, knots: float) -> None:
    """Four that are held have a quality of 0: whether the load is in reach decides."""
    lose(knots, name, 350.0)


def test_circles_and_shares_are_those_of_the_run() -> None:
    """From each happening to the next."""
    gale = moored("deck-barge", 60.0, 60.0, weather=Weather("npd"), duration=30.0)
    run = simulate(replace(gale, events=(Lose(10, "Castor"),)), [3, 4], every=1)
    found = verdict_of(run)
    before, after = found.circles
    early = run.times <= 10.0
    np.testing.assert_array_equal(before.distance, run.distances[:, early].max(axis=1))
    np.testing.assert_array_equal(after.turn, run.turns[:, ~early].max(axis=1))
    assert (before.usual_distance <= before.distance).all()
    np.testing.assert_array_equal(found.largest_share, run.shares.max(axis=(1, 2)))
    assert ((found.use > 0.0) & (found.use < 1.0)).all()


def test_the_spread_of_the_load_is_that_of_gusts() -> None:
    """The load goes with the square of the wind, so its spread with twice that of the speed."""
    calm = moored("escort-ring", 35.0, 60.0, duration=1.0)
    assert verdict_of(simulate(calm)).margins_over_spread[0] == math.inf
    gusty = replace(calm, weather=Weather("npd"), duration=100.0)
    run = simulate(gusty, range(24))
    found = verdict_of(run)
    scale = run.happenings[0].swarm.scale
    spread = np.linalg.norm((run.loads * scale).std(axis=(0, 1)))
    np.testing.assert_allclose(found.spreads.mean(), spread, rtol=0.2)
    np.testing.assert_allclose(found.margins_over_spread, run.happenings[0].margin / found.spreads)


def test_how_little_too_much_a_run_can_tell_falls_with_the_square_of_its_length() -> None:
    """Half of its acceleration times the square of the time is what moves the object."""
    calm = moored("escort-ring", 35.0, 60.0, duration=2.0)
    short, long = (verdict_of(simulate(replace(calm, duration=t))) for t in (2.0, 4.0))
    assert short.least_excess == pytest.approx(4.0 * long.least_excess)


def test_a_verdict_is_of_a_run_within_something() -> None:
    """All faults at once."""
    with pytest.raises(SimulationInvalid, match=r"no Run(.|\n)*within is 0(.|\n)*turn within is"):
        verdict_of(None, 0.0, -1.0)
