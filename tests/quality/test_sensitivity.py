"""Slopes of the quality: against finite differences, on both sides of every kink."""

import math
from itertools import product

import numpy as np
import pytest
from hypothesis import example, given, settings
from hypothesis import strategies as st

import reference
from strategies import FAMILIES, large_swarms, swarm_of, swarms
from swarmgrasp import (
    Ellipsoid,
    Outline,
    Polytope,
    Robot,
    Swarm,
    quality,
    sensitivities,
)
from swarmgrasp.errors import CriterionInvalid, SwarmInvalid
from swarmgrasp.quality.heights import Heights
from swarmgrasp.quality.shares import shares_at
from swarmgrasp.quality.weakest import weakest_of
from swarmgrasp.quality.weakest_facets import weakest_facets

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
STEP = 2e-5
ROUGH = ("giant", "spread limits", "nearly parallel")
"""Families whose kinks are nearer than a finite step."""
TAME = [family for family in FAMILIES if family not in ROUGH]


def moved(swarm, i, kind, x):
    """Return the scaled generators when robot i shifts [m], turns [rad] or strengthens [N] by x."""
    outline = swarm.outline
    contacts, directions, limits = (
        np.array(a) for a in (swarm.contacts, swarm.directions, swarm.limits)
    )
    if kind == 0 and x != 0.0:
        arc = float(outline.nearest(contacts[i])[1][0])
        contacts[i] = outline.at_arc_length((arc + x) % outline.perimeter).point
    directions[i] += x * (kind == 1)
    limits[i] += x * (kind == 2)
    return reference.generators(contacts, directions, limits, outline.origin, swarm.scale)


def differences(swarm, quality_of=reference.quality, robots=None):
    """Finite differences of all slopes, (n, 3, 2), and what each could be at most."""
    slopes, most = np.zeros((2, len(swarm), 3, 2))
    for i, kind, way in product(robots or range(len(swarm)), range(3), range(2)):
        unit = (swarm.outline.extent, 1.0, swarm.limits[i])[kind]
        sign = 2 * way - 1

        def quality_at(x, i=i, kind=kind, sign=sign):
            return quality_of(moved(swarm, i, kind, sign * x))

        slopes[i, kind, way] = reference.one_sided_slope(quality_at, STEP * unit)
        change = moved(swarm, i, kind, sign * STEP * unit) - moved(swarm, i, kind, 0.0)
        most[i, kind, way] = np.linalg.norm(change) / (STEP * unit)
    return slopes, most


def slopes_of(found):
    """Contact, direction and limit, (n, 3, 2)."""
    return np.stack([found.contact, found.direction, found.limit], axis=1)


def assert_close(found, slopes, most, share=3e-4):
    """Compare up to what a finite step bends."""
    assert (np.abs(slopes_of(found) - slopes) <= share * most + 1e-6).all()


# -- against finite differences -------------------------------------------------------


@pytest.mark.parametrize(("family", "seed"), [*product(TAME, range(2))])
def test_slopes_of_few_robots(family, seed):
    """Generic, tied and degenerate swarms, contacts at corners, along normals, in pairs."""
    swarm = swarm_of(family, seed, 7 + seed)
    assert_close(sensitivities(swarm), *differences(swarm))


TASKS = {
    None: None,
    "polytope": Polytope([(2, 1, 0), (-1, 1, 1), (0, -2, -1)]),
    "ellipsoid": Ellipsoid([(2, 0, 0.5), (0, 1, 0), (0, 0.3, 1)]),
}


@pytest.mark.parametrize(
    ("family", "losing", "load", "kind"),
    [
        ("free", 1, (0, 0, 0), None),
        ("balanced", 1, (0, 0, 0), None),
        ("duplicated", 1, (0, 0, 0), None),
        ("along normals", 0, (0.3, -0.2, 0.4), None),
        ("integer grid", 0, (0, 0, 0.5), "polytope"),
        ("free", 0, (0.2, 0, 0), "ellipsoid"),
        ("balanced", 1, (0, 0.1, 0), "polytope"),
    ],
)
def test_slopes_by_a_criterion(family, losing, load, kind):
    """With robots to lose, several of them alike, beside a load, relative to a task."""
    swarm = swarm_of(family, 3, 14 if family == "duplicated" else 10)
    task = TASKS[kind]
    rows = None if task is None else task.generators * swarm.scale

    def quality_of(B):
        return reference.quality_by_criterion(B, losing, load * swarm.scale, rows, kind)

    found = sensitivities(swarm, losing=losing, load=load, task=task)
    assert found.quality.value > 0.0
    assert found.quality.value == pytest.approx(quality_of(swarm.scaled_generators), rel=1e-9)
    robots = range(0, len(swarm), 3)
    slopes, most = differences(swarm, quality_of, robots)
    near = np.abs(slopes_of(found) - slopes) <= 1e-3 * most + 1e-6
    assert near[list(robots)].all()


@pytest.mark.parametrize("family", ["free", "balanced", "ring"])
def test_slopes_of_many_robots(family):
    """Beyond the number whose pairs are all listed."""
    swarm = swarm_of(family, 4, 90)
    robots = [0, 17, 51, 88]
    slopes, most = differences(swarm, lambda B: weakest_of(B).quality, robots)
    near = np.abs(slopes_of(sensitivities(swarm)) - slopes) <= 1e-3 * most + 1e-6
    assert near[robots].all()


# -- known numbers --------------------------------------------------------------------


def test_shares_are_those_of_the_weakest_wrench():
    """Those on the facet make up for what those above it do across: by half, or with a choice."""
    normal = np.array([-1.0, 0.0, 0.0])
    above, first, second = [-1.0, -0.5, -0.5], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]
    below, third = [1.0, 0.0, 0.0], [0.0, -1.0, -1.0]
    shares = shares_at(Heights(np.array([above, first, second, below])), normal, 1.0)
    np.testing.assert_allclose(shares, [[1, 1], [0.5, 0.5], [0.5, 0.5], [0, 0]])
    shares = shares_at(Heights(np.array([above, first, second, third])), normal, 1.0)
    np.testing.assert_allclose(shares, [[1, 1], [0.5, 1], [0.5, 1], [0, 0.5]])


def test_a_fixed_normal_would_be_wrong():
    """A robot on the facet has one slope, its share times n . db, not max(0, n . db)."""
    found = sensitivities(swarm_of("free", 0, 9))
    on = list(map(found.swarm.index, found.quality.facet_robots))
    assert len(found.weakest) == 1
    assert len(on) == 2
    assert not found.kinks[on].any()
    np.testing.assert_allclose(found.direction[on].sum(axis=1), 0.0, atol=1e-9)
    assert (np.abs(found.direction[on]) > 1e-3).all()


def test_a_corner_has_two_edges():
    """From a corner the torque of a force at angle a grows by sin a per metre, or by -cos a."""
    rng = np.random.default_rng(5)
    spots = [SQUARE.at_arc_length(s).point for s in rng.uniform(0.0, 8.0, 6)]
    crew = [Robot(*row) for row in zip(spots, rng.uniform(-3.0, 3.0, 6), strict=True)]
    swarm = Swarm(SQUARE, [Robot((-1, -1), 0.4), *crew], 1.0)
    found = sensitivities(swarm)
    assert_close(found, *differences(swarm))
    assert found.contact[0, 0] > 0.1
    assert found.contact[0, 1] == pytest.approx(-math.tan(0.4) * found.contact[0, 0])
    assert np.flatnonzero(found.kinks[0]).tolist() == [0]


def test_where_the_slightest_move_holds_the_object():
    """At quality 0 slopes are never negative, and positive on the border of closure."""
    centred = [Robot((math.cos(a), math.sin(a)), a) for a in np.arange(4) * math.pi / 2]
    found = sensitivities(Swarm(SQUARE, [*centred, Robot((1, 0.5), math.pi / 2)], 1.0))
    np.testing.assert_allclose(found.contact[:4], [[0, 1]] * 4, atol=1e-12)
    np.testing.assert_allclose(found.direction[:4], [[1, 0]] * 4, atol=1e-12)
    assert not found.limit.any()


@pytest.mark.parametrize("count", range(4))
def test_fewer_than_four_robots_stay_without(count):
    """No slope, whatever they do; no robots have none at all."""
    swarm = swarm_of("free", 2, count)
    for found in (sensitivities(swarm), sensitivities(swarm, losing=1)):
        assert slopes_of(found).shape == (count, 3, 2)
        assert not slopes_of(found).any()


def test_a_load_that_is_not_held_has_no_slope():
    """Quality is clamped at 0 far below the border."""
    found = sensitivities(swarm_of("free", 0, 9), load=(100.0, 0, 0))
    assert not slopes_of(found).any()


def test_a_mounted_robot_turns_and_does_not_move():
    """A thruster's contact is no matter of the boundary."""
    robots = [*swarm_of("free", 0, 9).robots, Robot((0.1, 0.1), 0.2, mounted=True)]
    found = sensitivities(Swarm(swarm_of("free", 0, 9).outline, robots))
    assert np.isnan(found.contact[-1]).all()
    assert not found.kinks[-1, 0]
    assert np.isfinite(found.contact[:-1]).all()
    np.testing.assert_allclose(found.direction_per_degree, found.direction * math.pi / 180.0)


# -- what slopes obey -----------------------------------------------------------------


@given(st.one_of(swarms, large_swarms))
@example(swarm_of("nearly parallel", 38, 85))
@settings(max_examples=80)
def test_no_slope_exceeds_the_change_of_the_wrench(swarm):
    """|dQ| <= |db| (T4), also with robots of very different strength; more force never hurts."""
    found = sensitivities(swarm)
    arms = np.linalg.norm(swarm.contacts - swarm.outline.origin, axis=1) * swarm.scale[2]
    reach = (1.0 + arms) * max(1.0, *swarm.scale[:2])
    limits = swarm.limits[:, None] * (1.0 + 1e-6)
    assert (np.abs(found.contact) <= limits * swarm.scale[2]).all()
    assert (np.abs(found.direction) <= limits * reach[:, None]).all()
    assert (found.limit[:, 0] <= 1e-6).all()
    assert (found.limit[:, 1] >= -1e-6).all()


@pytest.mark.parametrize(("family", "n"), [("balanced", 70), ("integer grid", 80), ("ring", 65)])
def test_all_weakest_facets_are_found(family, n):
    """The search over triangles finds what listing all pairs does."""
    swarm = swarm_of(family, 1, n)
    B = swarm.scaled_generators
    weakest = quality(swarm)
    value = weakest.value
    normals, heights = reference.facet_normals(B)
    tied = normals[heights <= value + 1e-11 * np.linalg.norm(B, axis=1).sum()]
    found = weakest_facets(Heights(B), value, weakest.direction, np.zeros((0, 3)))
    far = np.abs(tied[:, None] - found[None]).max(axis=2).min(axis=1)
    assert len(found) > 0
    assert far.max() < 1e-7
    np.testing.assert_allclose(reference.support(B, found), value, rtol=1e-10)


def test_a_regular_ring_is_as_weak_all_around():
    """All 200 facets are found, and robots that are turns of each other have the same slopes."""
    turns = 2.0 * math.pi * np.arange(100) / 100
    ring = Outline(np.column_stack([np.cos(turns), np.sin(turns)]))
    directions = turns + math.pi + np.where(np.arange(100) % 2, 0.3, -0.3)
    swarm = Swarm.from_arrays(ring, ring.vertices, directions)
    found = sensitivities(swarm)
    assert len(found.weakest) == 200
    assert found.is_ridge
    for slopes in (found.direction[::2], found.direction[1::2]):
        np.testing.assert_allclose(slopes, slopes[:1] * np.ones((50, 1)), rtol=1e-6)


# -- what is refused ------------------------------------------------------------------


def test_what_is_refused():
    """The worst case, which moves every pose by itself, and what is no swarm."""
    with pytest.raises(CriterionInvalid, match="sensitivities are of robots whose poses are known"):
        sensitivities(swarm_of("free", 0, 5), worst_case=True)
    with pytest.raises(SwarmInvalid, match="is no Swarm"):
        sensitivities([])
