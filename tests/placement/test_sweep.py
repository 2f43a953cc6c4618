"""Thousands of random and degenerate placements: each closes its gap and proves its bound."""

import numpy as np
import pytest

import reference
from strategies import FAMILIES, problem_of
from swarmgrasp import place_sequence
from swarmgrasp.errors import NowhereToAttach


def sweep(seeds, verify_every):
    """Answer one problem per family and seed; return the failures."""
    failures = []
    for seed in seeds:
        n = int(np.random.default_rng([seed, 2]).integers(0, 17))
        for family in FAMILIES:
            problem = problem_of(family, seed, n)
            try:
                (answer,) = place_sequence(problem, 1)
            except NowhereToAttach:
                continue
            faults = faults_of(answer, (seed % verify_every) == 0)
            failures += [f"problem_of({family!r}, {seed}, {n}): {fault}" for fault in faults]
    return failures


def faults_of(answer, thorough):
    """Return what is wrong with an answer; a thorough check verifies it too."""
    swarm = answer.swarm_after
    reach = np.linalg.norm(swarm.scale[:2]) + swarm.outline.radius * swarm.scale[2]
    total = np.linalg.norm(swarm.scaled_generators, axis=1).sum() + answer.robot.limit * reach
    if not 0.0 <= answer.upper_bound - answer.quality <= 1e-6 * answer.quality + 4e-12 * total:
        yield f"bound {answer.upper_bound:.12g} N at {answer.quality:.12g} N"
    if thorough:
        truth = reference.quality(swarm.scaled_generators)
        if abs(truth - answer.quality) > 1e-9 * truth + 2e-12 * total:
            yield f"quality {answer.quality!r} N instead of {truth!r} N"
        yield from answer.verify().faults


def test_a_few_hundred():
    """The first of the long sweep."""
    failures = sweep(range(30), 3)
    assert not failures, "\n".join(failures)


@pytest.mark.long
@pytest.mark.parametrize("first", range(30, 870, 42))
def test_ten_thousand(first):
    """All families, 0 to 16 robots (balanced ones in pairs), newcomers of any strength."""
    failures = sweep(range(first, first + 42), 10)
    assert not failures, "\n".join(failures)
