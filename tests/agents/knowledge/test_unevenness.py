"""What is not known, over all directions (T30)."""

import numpy as np
import pytest

import reference
from swarmgrasp.agents.knowledge.beliefs import (
    EVEN,
    KNOWN,
    NOTHING,
    SIGHT,
    known_in,
    lost,
    summary_of,
)
from swarmgrasp.agents.knowledge.cases import BARGE, FREE, HULL, PUSH, STEER, TANK, Case
from swarmgrasp.agents.knowledge.unevenness import CLOSE, LEAST, unevenness
from swarmgrasp.summary import Summary

CASES = [Case(BARGE, PUSH, 9, 12), Case(TANK, FREE, 14, 20), Case(HULL, STEER, 6, 8)]
ASKED = [NOTHING, SIGHT, EVEN, lost(50), summary_of(12), summary_of(1024)]


def sampled(true, believed, rng):
    """Return max e - min e over directions drawn at random and walked from the best of them."""

    def e(normals):
        if isinstance(believed, Summary):
            return reference.height_of_sets(true, normals) - believed.support.lower(normals)
        return reference.height_of_sets(true, normals) - reference.height_of_sets(believed, normals)

    ends = []
    for sign in (1.0, -1.0):
        near, reach = rng.normal(size=(1, 3)), 10.0
        while reach > 1e-3:
            normals = near + reach * rng.normal(size=(3000, 3))
            normals /= np.linalg.norm(normals, axis=1)[:, None]
            values = sign * e(normals)
            near, reach = normals[values.argmax()][None], 0.3 * reach
        ends.append(values.max())
    return sum(ends)


@pytest.mark.parametrize(
    ("case", "known"), [(c, k) for c in CASES for k in ASKED if k in known_in(c)], ids=str
)
def test_it_is_above_what_any_direction_shows_and_close_to_it(case, known):
    """Of all beliefs, for rays and sectors, against support functions from the robots' fields."""
    rng = np.random.default_rng(7)
    swarm = case.start(rng)
    believed = KNOWN[known](case, swarm, rng)
    bound, seen = unevenness(swarm, believed), sampled(swarm, believed, rng)
    assert seen <= bound + 1e-9 <= seen + 3.0 * max(CLOSE * seen, LEAST)


def test_nothing_is_uneven_about_what_is_known():
    """The swarm itself, in another order, and its summary in fine bins."""
    swarm = CASES[0].start(np.random.default_rng(3))
    other = type(swarm)(swarm.outline, swarm.robots[::-1])
    assert unevenness(swarm, other) == 0.0
    assert unevenness(swarm, Summary.of(swarm, 2_000_000)) <= 2.0 * LEAST
