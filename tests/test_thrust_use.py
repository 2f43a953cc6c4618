"""Thrust use over bearings, beside the linear program of the least largest share."""

import numpy as np
import pytest

from reference import least_largest_share
from swarmgrasp import Swarm, Waves, thrust_use
from swarmgrasp.errors import EnvironmentInvalid
from swarmgrasp.scenario import load_example

BEARINGS = np.radians([0.0, 70.0, 160.0, 250.0])


def test_the_busiest_share_is_the_least_there_can_be():
    """In a gale with a current, at bearings all round; the shares make the opposite of the load."""
    scenario = load_example("deck-barge")
    swarm, around = scenario.swarm, scenario.environment
    found = thrust_use(swarm, around, 20.0, BEARINGS)
    assert found.held.all()
    loads = around.load_in(swarm.outline, BEARINGS, 20.0) * swarm.scale
    for row, load in zip(found.shares, loads, strict=True):
        expected = least_largest_share(swarm.scaled_generators, -load)
        assert row.max() == pytest.approx(expected, rel=1e-5)
        np.testing.assert_allclose(row @ swarm.scaled_generators, -load, atol=1e-3)
    assert found.largest[found.busiest] == found.largest.max()
    index = int(found.shares[found.busiest].argmax())
    assert found.busiest_at(found.busiest) == swarm.names[index]


def test_what_is_not_held_is_told():
    """Where a storm is too much, by how much; nobody holds nothing but a calm."""
    scenario = load_example("deck-barge")
    found = thrust_use(scenario.swarm, scenario.environment, 60.0, BEARINGS)
    assert not found.held.all()
    assert found.shortfalls[found.busiest] == found.shortfalls.max() > 0.0
    nobody = thrust_use(Swarm(scenario.swarm.outline, []), scenario.environment, 5.0, [1.0])
    assert (nobody.held.tolist(), nobody.shares.shape) == ([False], (1, 0))


def test_a_wind_whose_sea_nobody_told_is_refused():
    """And so is one that is no speed."""
    scenario = load_example("deck-barge")
    from dataclasses import replace

    growing = replace(scenario.environment, waves=Waves())
    with pytest.raises(EnvironmentInvalid, match="the sea that goes with a wind is known for"):
        thrust_use(scenario.swarm, growing, 40.0)
    with pytest.raises(EnvironmentInvalid, match="the speed is -1"):
        thrust_use(scenario.swarm, scenario.environment, -1)
