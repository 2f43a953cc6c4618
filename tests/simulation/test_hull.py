"""What an object weighs in water, against published vessels and closed forms."""

import math

import numpy as np
import pytest

from swarmgrasp import Outline
from swarmgrasp.errors import OutlineInvalid, SimulationInvalid, SwarmGraspError
from swarmgrasp.scenario import load_example
from swarmgrasp.simulation import Hull
from swarmgrasp.simulation.hull import RECTANGLES, THICKNESSES, inverse_of

BOX = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])


def box(length, beam):
    """Return the outline of a box."""
    return Outline(np.array([(-0.5, -0.5), (0.5, -0.5), (0.5, 0.5), (-0.5, 0.5)]) * (length, beam))


def test_the_deck_barge():
    """A draught of 8 ft: 4072 t, of which 0.117 and 0.349 again is water that moves along."""
    scenario = load_example("deck-barge")
    hull = Hull.afloat(scenario.swarm.outline, scenario.environment, draught=8 * 0.3048)
    assert hull.mass == pytest.approx(4072e3, rel=1e-4)
    assert hull.inertia == pytest.approx(2.04e9, rel=1e-3)
    ratios = np.array(hull.added) / (hull.mass, hull.mass, hull.inertia)
    np.testing.assert_allclose(ratios, (0.117, 0.349, 0.337), atol=5e-4)
    current = scenario.environment.current
    assumed = Hull.afloat(scenario.swarm.outline, scenario.environment)
    area = np.ptp(scenario.swarm.outline.vertices[:, 0]) * assumed.mass / hull.mass * 8 * 0.3048
    assert area == pytest.approx(current.lateral_area)


def added_mass(height, width, panels=60):
    """Return the added mass of a rectangle that moves along its width, over that of a circle.

    Potential flow by a boundary integral: 0.5 p + Int p dG/dn = Int G q, G = ln r / (2 pi).
    """
    share = 0.5 - 0.5 * np.cos(np.linspace(0.0, math.pi, panels + 1)[:-1, None])
    corners = 0.5 * np.array(
        [(height, -width), (height, width), (-height, width), (-height, -width)]
    )
    ends = np.roll(corners, -1, axis=0)
    start = np.vstack([p + share * (q - p) for p, q in zip(corners, ends, strict=True)])
    end = np.roll(start, -1, axis=0)
    lengths = np.hypot(*(end - start).T)
    along = (end - start) / lengths[:, None]
    normals = np.column_stack([along[:, 1], -along[:, 0]])
    middles = 0.5 * (start + end)
    near, far = start - middles[:, None], end - middles[:, None]
    a, b = np.einsum("ijk,jk->ij", near, along), np.einsum("ijk,jk->ij", far, along)
    off = np.einsum("ijk,jk->ij", near, normals)
    off[np.abs(off) < 1e-12] = np.inf  # on the same side: it sees no angle
    angle = np.arctan(b / off) - np.arctan(a / off)
    off[np.isinf(off)] = 0.0
    sizes = b * np.log(np.hypot(*far.T).T) - a * np.log(np.hypot(*near.T).T) - (b - a) + off * angle
    flow = normals[:, 1]
    matrix = 0.5 * np.eye(len(flow)) + angle / (2.0 * math.pi)
    potential = np.linalg.solve(matrix, sizes @ flow / (2.0 * math.pi))
    return -np.sum(potential * flow * lengths) / (0.25 * math.pi * height**2)


def test_the_table_of_rectangles_is_that_of_potential_flow():
    """Of all seven rows, within 1 %."""
    for thickness, published in zip(THICKNESSES, RECTANGLES, strict=True):
        assert added_mass(thickness, 1.0) == pytest.approx(published, rel=0.01)


@pytest.mark.parametrize(
    ("size", "mass", "published"),
    [
        ((76.2, 18.8, 6.25), 6000e3, (0.1274, 0.8902, None)),  # Fossen, Sagatun, Soerensen 1996
        ((83.0, 18.0, 5.0), 4976e3, (0.12, 0.40, 0.58)),  # MSS, osv.m
    ],
)
def test_added_masses_are_of_the_size_of_published_ones(size, mass, published):
    """Of two supply vessels, within a factor of 2."""
    length, beam, draught = size
    block = mass / (1026.0 * length * beam * draught)
    hull = Hull.afloat(box(length, beam), draught=draught, block=block)
    ratios = np.array(hull.added) / (hull.mass, hull.mass, hull.inertia)
    for ours, theirs in zip(ratios, published, strict=True):
        assert theirs is None or 0.5 < ours / theirs < 2.0


def test_mass_is_spread_over_the_outline():
    """An L, whose area is taken as three squares."""
    outline = Outline([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)])
    hull = Hull.afloat(outline, draught=0.1, mass=3.0)
    middles = np.array([(0.5, 0.5), (1.5, 0.5), (0.5, 1.5)])
    arms = middles - middles.mean(axis=0)
    assert hull.inertia == pytest.approx(3.0 / 6.0 + np.sum(arms**2))
    np.testing.assert_allclose(hull.centre, (0.0, 0.0), atol=1e-15)
    np.testing.assert_allclose(hull.added_at, np.array([1.0, 1.0]) - outline.origin)


def test_the_matrix_is_that_of_kinetic_energy():
    """Of the hull about its centre, and of the water about a point of its own."""
    rng = np.random.default_rng(0)
    hull = Hull(3.0, (0.4, -0.2), 1.5, (0.3, 1.1, 0.7), (-0.5, 0.6))
    for u, v, r in rng.normal(size=(5, 3)):
        at = [(u - y * r, v + x * r) for x, y in (hull.centre, hull.added_at)]
        energy = 3.0 * np.sum(np.square(at[0])) + 1.5 * r * r
        energy += 0.3 * at[1][0] ** 2 + 1.1 * at[1][1] ** 2 + 0.7 * r * r
        assert np.array([u, v, r]) @ hull.matrix @ [u, v, r] == pytest.approx(energy)
    np.testing.assert_allclose(inverse_of(hull.matrix) @ hull.matrix, np.eye(3), atol=1e-15)


def test_robots_add_their_masses():
    """Two and then one are three at once, and energy is that of points."""
    hull, rng = Hull(3.0, (0.4, -0.2), 1.5, (0.3, 1.1, 0.7)), np.random.default_rng(1)
    masses, contacts = rng.uniform(0.0, 2.0, 3), rng.normal(size=(3, 2))
    loaded = hull.with_robots(masses, contacts)
    apart = hull.with_robots(masses[:2], contacts[:2]).with_robots(masses[2:], contacts[2:])
    np.testing.assert_allclose(loaded.matrix, apart.matrix, rtol=1e-14)
    u, v, r = rng.normal(size=3)
    speeds = np.column_stack([u - contacts[:, 1] * r, v + contacts[:, 0] * r])
    more = np.array([u, v, r]) @ (loaded.matrix - hull.matrix) @ [u, v, r]
    assert more == pytest.approx(np.sum(masses * np.sum(speeds**2, axis=1)))
    assert hull.with_robots([], []) == hull


def test_hulls_are_told_as_plain_data():
    """And come back the same."""
    hull = Hull.afloat(BOX, draught=2.0)
    assert Hull.from_data(hull.to_data()) == hull


def test_every_fault_is_told_at_once():
    """Negative masses, points that are none, damping that drives, draughts that mean nothing."""
    drives = ((1.0, 0.0, 0.0), (0.0, -1.0, 0.0), (0.0, 0.0, 1.0))
    with pytest.raises(SimulationInvalid) as caught:
        Hull(-1.0, (0.0,), float("nan"), (1.0, -2.0, "3"), (1e99, 0.0), drives)
    assert len(caught.value.faults) == 7
    with pytest.raises(SwarmGraspError) as caught:
        Hull.afloat("barge", 3, draught=-1.0, block=2.0, mass=0.0)
    assert isinstance(caught.value, OutlineInvalid)
    assert len(caught.value.faults) == 5
    with pytest.raises(
        SimulationInvalid, match=r"nothing tells how deep it floats; give a draught"
    ):
        Hull.afloat(BOX)
    with pytest.raises(
        SimulationInvalid, match=r"draught is 81.0; it should be 0 < draught <= 80,"
    ):
        Hull.afloat(BOX, draught=81.0)
    hull = Hull.afloat(BOX, mass=1e6)
    with pytest.raises(SimulationInvalid, match=r"0 <= mass <= 1e\+12"):
        hull.with_robots([-1.0], [(0.0, 0.0)])
    with pytest.raises(SimulationInvalid, match=r"finite numbers \(1, 2\)"):
        hull.with_robots([1.0], [(0.0, 0.0), (1.0, 1.0)])
