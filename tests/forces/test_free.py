"""Wrenches with parts that do not matter, beside a linear program; and multiples within reach."""

import numpy as np
import pytest
from scipy.optimize import linprog

from swarmgrasp import Swarm
from swarmgrasp.errors import WrenchInvalid
from swarmgrasp.forces import forces, largest_multiple, with_free_parts
from swarmgrasp.forces.free import PARTS
from swarmgrasp.scenario import load_example


@pytest.mark.parametrize("name", ["deck-barge", "rectangle-15"])
@pytest.mark.parametrize("free", [["fx"], ["tz"], ["fy", "tz"]])
def test_no_choice_of_the_free_parts_takes_less(name: str, free: list[str]) -> None:
    """The least largest share of a linear program in which the free parts have no rows."""
    swarm, rng = load_example(name).swarm, np.random.default_rng(3)
    columns, n = swarm.generators.T, len(swarm)
    wanted = columns @ rng.uniform(0.0, 0.5, n)
    kept = [i for i, part in enumerate(PARTS) if part not in free]
    rows = np.hstack([columns[kept], np.zeros((len(kept), 1))])
    caps = np.hstack([np.eye(n), -np.ones((n, 1))])
    least = linprog([0] * n + [1], caps, np.zeros(n), rows, wanted[kept]).fun
    found = with_free_parts(swarm, wanted, free)
    assert found[kept].tolist() == wanted[kept].tolist()
    answer = forces(swarm, found)
    assert not answer.is_degraded
    assert answer.largest_share == pytest.approx(least, rel=1e-9)


def test_a_multiple_is_the_largest() -> None:
    """It is within reach, and a thousandth more is not; beside a load, too."""
    swarm = load_example("harbour-tugs").swarm
    wrench, load = np.array([4e5, 2e5, 1e6]), (1e4, -3e4, 0.0)
    for beside in ((0.0, 0.0, 0.0), load):
        times = largest_multiple(swarm, wrench, load=beside)
        assert not forces(swarm, times * wrench, load=beside).is_degraded
        assert forces(swarm, 1.001 * times * wrench, load=beside).is_degraded


def test_one_part_at_least_is_asked_for() -> None:
    """And only parts that there are can be free."""
    swarm: Swarm = load_example("rectangle-5").swarm
    for free in (PARTS, ["fz"], [*PARTS, "fz"]):
        with pytest.raises(WrenchInvalid, match="one or two of fx, fy, tz"):
            with_free_parts(swarm, (1, 0, 0), free)
