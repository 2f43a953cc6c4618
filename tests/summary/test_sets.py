"""Summaries of robots that steer, reverse, or have other sets of forces."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from crews import BARGE, crew_of
from reference import height_of_sets
from summary.crowds import directions
from swarmgrasp import Newcomer, Robot, Swarm, place, quality
from swarmgrasp.errors import ForceSetUnsupported
from swarmgrasp.summary import Summary
from swarmgrasp.summary.lattice import OVERREACH, lattice, mixtures

seeds = st.integers(0, 2**32 - 1)
bin_numbers = st.sampled_from([12, 108, 1024])


@given(seeds, bin_numbers)
def test_heights_and_quality_lie_between_their_bounds(seed, bins):
    """In every direction, as sharply as can be along the axes, before and after a message."""
    swarm, normals = crew_of(np.random.default_rng(seed)), directions(seed)
    h, value = height_of_sets(swarm, normals), quality(swarm)
    summary = Summary.of(swarm, bins)
    assert summary.count == len(swarm)
    for known in (summary, Summary.from_bytes(summary.to_bytes())):
        lower, upper, bounds = (
            known.support.lower(normals),
            known.support.upper(normals),
            known.quality(),
        )
        assert (lower <= h).all()
        assert (h <= upper).all()
        assert (upper - lower)[-6:].max() <= 1e-4 * known.size
        assert bounds.lower <= value.value
        assert value.bound <= bounds.upper


@given(seeds, st.integers(2, 4))
def test_any_grouping_bounds_the_whole(seed, groups):
    """Though each came by message; some of them may be rays only, or empty."""
    rng = np.random.default_rng(seed)
    swarm, normals = crew_of(rng), directions(seed)
    owner, rows = rng.integers(groups, size=len(swarm)), np.arange(len(swarm))
    parts = [swarm.without_rows(rows[owner != k].tolist()) for k in range(groups)]
    known = [Summary.from_bytes(Summary.of(part, 108).to_bytes()) for part in parts]
    merged, h = Summary.merge(known), height_of_sets(swarm, normals)
    assert merged.count == len(swarm)
    assert (merged.support.lower(normals) <= h).all()
    assert (h <= merged.support.upper(normals)).all()
    assert Summary.from_bytes(merged.to_bytes()).to_bytes() == merged.to_bytes()
    assert len(merged.to_bytes()) <= 108 + 18 * merged.bins + 12 * len(lattice(merged.side))


@pytest.mark.parametrize(("bins", "share"), [(1024, 0.002), (16_384, 0.0003)])
def test_two_azimuths(bins, share):
    """The closed form lies between the bounds, and they come nearer."""
    pair = [Robot((x, 0), 0.0, 3.0, steers=math.pi, mounted=True) for x in (10.0, -10.0)]
    bounds = Summary.of(Swarm(BARGE, pair, characteristic_length=10.0), bins).quality()
    assert bounds.lower <= 6.0 / math.sqrt(2.0) <= bounds.upper
    assert bounds.is_force_closure
    assert bounds.width <= share * bounds.upper


def test_a_hundred_thousand_of_which_some_steer():
    """The message is that of few robots, and the bounds are within half a percent."""
    rng, n = np.random.default_rng(8), 100_000
    spots = np.array([BARGE.at_arc_length(s).point for s in rng.uniform(0.0, BARGE.perimeter, 500)])
    contacts, turns = spots[rng.integers(500, size=n)], rng.uniform(-math.pi, math.pi, n)
    steers = np.where(np.arange(n) % 20 == 0, rng.choice([0.5, 1.2, math.pi], n), 0.0)
    swarm = Swarm.from_arrays(BARGE, contacts, turns, rng.uniform(0.5, 2.0, n), steers=steers)
    summary = Summary.of(swarm)
    bounds, value = summary.quality(), quality(swarm).value
    assert bounds.lower <= value <= bounds.upper <= 1.005 * bounds.lower
    assert len(summary.to_bytes()) <= 108 + 18 * 972 + 12 * 1298
    found = summary.place(BARGE, Newcomer(100.0, "push"))
    assert bounds.lower < found.lower <= found.upper <= 1.005 * found.lower
    assert found.best_possible <= 1.005 * found.lower


@given(seeds, st.sampled_from([12, 108]), st.sampled_from(["push", "pull", "free"]))
@settings(max_examples=40)
def test_a_place_is_as_good_as_said(seed, bins, attachment):
    """The robot is within its bounds, and no place beats the best possible."""
    rng = np.random.default_rng(seed)
    swarm = crew_of(rng)
    newcomer = Newcomer(float(10.0 ** rng.uniform(1.0, 3.5)), attachment)
    found = Summary.of(swarm, bins).place(BARGE, newcomer)
    truth = quality(swarm.with_robot(found.robot))
    assert found.lower <= truth.value
    assert truth.bound <= found.upper
    assert place(swarm, newcomer).quality <= found.best_possible
    assert found.regret >= 0.0


@pytest.mark.parametrize("more", [{"steers": True}, {"reverse_limit": 0.5}, {"friction": 0.3}])
@pytest.mark.parametrize("steers", [0.0, 0.4])
def test_newcomers_that_are_no_rays_are_refused(more, steers):
    """None is placed as if it pushed along one ray."""
    summary = Summary.of(Swarm(BARGE, [Robot((40, 0), 3.0, steers=steers)]), 12)
    with pytest.raises(ForceSetUnsupported, match="beside a summary is for a newcomer"):
        summary.place(BARGE, Newcomer(1.0, "push", **more))


@given(seeds, st.sampled_from([2, 6, 18]))
def test_directions_are_mixtures_of_three_of_a_lattice(seed, side):
    """Up to rounding, with weights that are not negative; also on the lattice itself."""
    for normals in (directions(seed), lattice(side)):
        numbers, weights = mixtures(normals, side)
        assert len(lattice(side)) == 4 * side**2 + 2
        assert (weights >= 0.0).all()
        assert weights.sum(axis=1).max() <= OVERREACH * (1.0 + 1e-12)
        mixed = np.einsum("ij,ijk->ik", weights, lattice(side)[numbers])
        assert np.allclose(mixed, normals, rtol=0.0, atol=1e-14)
