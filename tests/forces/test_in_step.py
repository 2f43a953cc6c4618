"""Forces in step: each wrench as if it were alone, and as good as along a trajectory."""

import numpy as np
import pytest

from crews import crew_of, wrench_for
from strategies import swarm_of
from swarmgrasp.forces import forces_along, forces_in_step

SWARMS = [
    swarm_of("free", 3, 6), swarm_of("free", 4, 12), crew_of(np.random.default_rng(12)),
]  # fmt: skip


@pytest.mark.parametrize("swarm", SWARMS, ids=["rays", "many rays", "any sets"])
def test_each_wrench_is_found_as_if_it_were_alone(swarm) -> None:
    """To the last bit, from nothing and from what was found for others a moment ago."""
    rng = np.random.default_rng(5)
    before = np.array([wrench_for(rng, swarm) for _ in range(9)])
    after = before * rng.uniform(0.9, 1.1, (9, 1))
    last = forces_in_step(swarm, before)
    found = forces_in_step(swarm, after, last)
    for i in range(9):
        alone = forces_in_step(swarm, after[[i]], forces_in_step(swarm, before[[i]]))
        assert alone.vectors[0].tobytes() == found.vectors[i].tobytes()
        assert alone.shares[0].tobytes() == found.shares[i].tobytes()
    assert found.verify()
    along = forces_along(swarm, after)
    np.testing.assert_allclose(found.needed, along.needed, rtol=1e-9)
    np.testing.assert_allclose(found.wrenches, along.wrenches, atol=1e-6 * abs(after).max())


def test_what_was_found_for_fewer_is_no_start() -> None:
    """The wrenches are then found from nothing."""
    swarm, wrenches = SWARMS[0], np.eye(3)
    few = forces_in_step(swarm, wrenches[:2])
    assert forces_in_step(swarm, wrenches, few).needed == pytest.approx(
        forces_in_step(swarm, wrenches).needed
    )
