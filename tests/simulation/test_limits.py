"""Limits: what simulated robots hold is what statics says, and less in gusts."""

import math
from dataclasses import replace

import numpy as np
import pytest

from moored import moored
from swarmgrasp import Swarm, capability, place
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.scenario import load_example
from swarmgrasp.simulation import Actuator, Hull, Simulation, simulate
from swarmgrasp.simulation.limits import limits
from swarmgrasp.simulation.weather import Weather


def test_in_a_steady_wind_the_barge_holds_what_statics_says() -> None:
    """What stays at its place for a minute is in reach, at one bearing and another."""
    calm = moored("deck-barge", 10.0, 0.0, duration=60.0)
    found = limits(calm, [0.6, 2.2], seeds=(), within=0.05, within_turn=1e-3)
    np.testing.assert_allclose(found.steady / found.static, 1.0, atol=0.003)
    assert found.gusty.shape == (0, 2)


@pytest.mark.long
@pytest.mark.timeout(1800)
@pytest.mark.parametrize("name", ["deck-barge", "escort-ring"])
def test_in_a_steady_wind_statics_is_right_all_around(name: str) -> None:
    """A little more where a hull that yields finds a smaller load, within 5 m and 5 degrees."""
    found = limits(moored(name, 10.0, 0.0, duration=600.0), seeds=())
    ratio = found.steady / found.static
    assert len(ratio) == 24
    assert ratio.min() > 0.99
    assert ratio.max() < 1.02


@pytest.mark.long
@pytest.mark.timeout(1800)
def test_gusts_cost_the_tanker_about_what_the_rule_allows() -> None:
    """The rule of DNV-ST-0111 has a dynamic factor of 1.25, in winds that people work in.

    In ten minutes whose wind is below its mean it may be less than 1.
    """
    calm = moored("escort-ring", 10.0, 0.0, duration=600.0, weather=Weather("npd"))
    swarm = calm.problem.swarm
    weaker = Swarm(
        swarm.outline, [replace(robot, limit=0.3 * robot.limit, tolerance=None) for robot in swarm]
    )
    calm = replace(calm, problem=calm.problem.with_swarm(weaker))
    found = limits(calm, np.arange(0.0, math.tau - 0.1, math.tau / 8), seeds=[1, 2])
    factor = (found.static / found.gusty) ** 2
    assert factor.min() > 0.9
    assert 1.0 < np.median(factor) < 1.25
    assert factor.max() < 1.35


def test_what_limits_cannot_be_of_is_told_at_once() -> None:
    """All faults."""
    with pytest.raises(
        SimulationInvalid,
        match=r"bearings are 3(.|\n)*seeds are 3(.|\n)*within is(.|\n)*gap is 1",
    ):
        limits(moored("deck-barge", 10.0, 0.0), 3, seeds=3, within=-1.0, gap=1)


def test_the_model_ship_of_the_paper_is_held_up_to_its_limit() -> None:
    """Six thrusters of half a newton on a hull of a metre: everything is quicker there."""
    example = load_example("model-ship")
    problem, sea = example.problem(), example.environment
    problem = problem.with_swarm(problem.swarm.with_robot(place(problem).robot))
    reach = capability(problem.swarm, sea, [1.0]).intact[0]
    breeze = replace(sea, wind=replace(sea.wind, speed=0.99 * reach, bearing=1.0))
    ship = Simulation(
        problem, breeze, Hull.afloat(problem.swarm.outline, breeze, draught=0.08),
        Actuator(lag=0.3, slew=1.0), duration=10.0,
    )  # fmt: skip
    assert simulate(ship).distances.max() < 0.1
    gale = replace(breeze, wind=replace(breeze.wind, speed=1.4 * reach))
    assert simulate(replace(ship, environment=gale)).distances.max() > 0.5
