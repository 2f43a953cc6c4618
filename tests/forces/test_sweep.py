"""A hundred thousand wrenches of random and degenerate swarms: none refused by its check."""

import math

import numpy as np
import pytest

import reference
from strategies import FAMILIES, swarm_of
from swarmgrasp import Outline, Robot, Swarm, forces_along

BARGE = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
PADS = [((x, y), -math.copysign(math.pi / 2, y)) for x in range(-40, 41, 20) for y in (-10, 10)]
PADS += [((x, y), math.pi if x > 0 else 0.0) for x in (-40, 40) for y in (-10, 0, 10)]
ONCE_REFUSED = [2616, 2927, 4409, 5163, 15704, 18448]
"""Dwarfs beside giants, and a flat set whose plane rounding hides."""
SIZES = [*range(13), 16, 40]
ON_ONE_LINE = [((-40, 0), 0.0), ((40, 0), math.pi), ((-40, 0), 0.0)]


def crowd_at_pads(rng, n):
    """Return robots square to a barge, several at one pad, mostly of other limits."""
    limits = rng.choice([60.0, 100.0, 200.0, 250.0, 300.0], n) ** (rng.random() < 0.8)
    if rng.random() < 0.1:
        limits = limits * 10.0 ** rng.integers(-6, 7, n)
    turns = math.pi * (rng.random(n) < 0.2)
    pads = PADS if rng.random() < 0.8 else ON_ONE_LINE
    places = [pads[k] for k in rng.integers(len(pads), size=n)]
    rows = zip(places, turns, limits, strict=True)
    robots = [Robot(contact, angle + turn, limit) for (contact, angle), turn, limit in rows]
    length = None if rng.random() < 0.7 else rng.uniform(1.0, 100.0)
    weights = tuple(rng.uniform(0.3, 3.0, 2)) if rng.random() < 0.2 else (1.0, 1.0)
    return Swarm(BARGE, robots, length, weights)


def wrench_for(rng, swarm):
    """Return a wrench inside, on the boundary, outside, along one robot, or next to 0."""
    G = swarm.generators
    n = len(G)
    kind = rng.integers(11) if n else 0
    if kind == 0:
        return rng.normal(size=3) * [1e3, 1e3, 1e4]
    if kind == 1:
        return rng.choice([-1e3, 0.0, 200.0, 1e3], 3) * [1.0, 1.0, 10.0]
    if kind == 2:
        return G[rng.integers(n)] * rng.choice([-0.3, 0.3, 1.0, 2.0])
    if kind == 3:
        return rng.normal(size=3) * np.abs(G).sum(axis=0) * 10.0 ** rng.uniform(-3.0, 1.0)
    if kind == 4:
        return rng.normal(size=3) * np.abs(G).sum() * 1e-6
    if kind == 5:  # on a face, which may be an edge, and near it
        a, b = G[rng.integers(n, size=2)]
        front = np.where(G @ np.cross(a, b) > 1e-12 * np.abs(G).max() ** 3, 1.0, 0.0)
        return rng.choice([0.5, 1.0, 1.0001]) * (front @ G + rng.random() * a + rng.random() * b)
    shares = {
        6: rng.random(n),
        7: rng.choice([0.0, 1.0], n),
        8: 3.0 * rng.random(n),
        9: rng.choice([0.0, 1.0], n) * rng.random(),
        10: rng.random(n) * (rng.random(n) < 0.2),
    }
    return shares[kind] @ G


def sweep(seeds, check_every):
    """Ask four wrenches of a swarm per seed; return what is wrong with the answers."""
    for seed in seeds:
        rng = np.random.default_rng([seed, 3])
        swarm, family = crowd_at_pads(rng, int(rng.choice(SIZES))), "pads"
        if rng.random() < 0.5:
            family = FAMILIES[rng.integers(len(FAMILIES))]
            swarm = swarm_of(family, seed, int(rng.choice(SIZES)))
        sizes = np.linalg.norm(swarm.scaled_generators, axis=1)
        is_even = not len(swarm) or sizes.max() < 1e3 * sizes.min()
        is_even &= family != "nearly parallel"
        wrenches = np.array([wrench_for(rng, swarm) for _ in range(4)])
        load = wrench_for(rng, swarm) * (0.1 if rng.random() < 0.3 else 0.0)
        for k, found in enumerate(forces_along(swarm, wrenches, load=load)):
            yield from (f"seed {seed}, wrench {k}: {fault}" for fault in found.verify().faults)
            wanted = (wrenches[k] - load) * swarm.scale
            if is_even and seed % check_every == 0 and np.linalg.norm(wanted) > 1e-9:
                truth = reference.least_largest_share(swarm.scaled_generators, wanted)
                if found.needed != pytest.approx(truth, rel=1e-9, abs=1e-9):
                    yield f"seed {seed}, wrench {k}: needed {found.needed}, and it is {truth}"


def test_the_first_of_the_sweep():
    """Two thousand wrenches, every tenth swarm's beside a linear program, and what was hard."""
    faults = list(sweep([*range(500), *ONCE_REFUSED], 10))
    assert not faults, "\n".join(faults)


@pytest.mark.long
def test_a_hundred_thousand():
    """Every fortieth swarm's beside a linear program."""
    faults = list(sweep(range(500, 25_500), 40))
    assert not faults, "\n".join(faults)
