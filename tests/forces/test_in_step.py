"""Forces in step: each wrench as if it were alone, and as good as along a trajectory."""

import numpy as np
import pytest

from crews import crew_of, wrench_for
from strategies import swarm_of
from swarmgrasp.forces import forces_along, rows_in_step

SWARMS = [
    swarm_of("free", 3, 6), swarm_of("free", 4, 12), crew_of(np.random.default_rng(12)),
]  # fmt: skip


@pytest.mark.parametrize("swarm", SWARMS, ids=["rays", "many rays", "any sets"])
def test_each_wrench_is_found_as_if_it_were_alone(swarm) -> None:
    """To the last bit, from nothing and from what was found for others a moment ago."""
    rng = np.random.default_rng(5)
    before = np.array([wrench_for(rng, swarm) for _ in range(9)])
    after = before * rng.uniform(0.9, 1.1, (9, 1))
    last = rows_in_step(swarm, before, np.zeros((9, 3)))
    starts = np.ascontiguousarray(last.normals[:, 0])
    found = rows_in_step(swarm, after, starts)
    for i in range(9):
        alone = rows_in_step(swarm, after[[i]], starts[[i]])
        assert alone.vectors[0].tobytes() == found.vectors[i].tobytes()
        assert alone.shares[0].tobytes() == found.shares[i].tobytes()
    along = forces_along(swarm, after)
    np.testing.assert_allclose(found.needed, along.needed, rtol=1e-9)
    np.testing.assert_allclose(found.vectors, along.vectors, atol=1e-6 * swarm.limits.max())
