"""Wrench sets of robots that steer, reverse, rub or pull with a least force (T20)."""

import itertools
import math

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from reference import check_closed
from swarmgrasp.errors import WrenchInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.swarm import Robot, Swarm
from swarmgrasp.wrench_set import WrenchSet

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
KINDS = {
    "ray": {},
    "sector": {"steers": 0.6},
    "half turn": {"steers": math.pi / 2},
    "azimuth": {"steers": math.pi},
    "two ways": {"reverse_limit": 0.6},
    "steers both ways": {"reverse_limit": 0.5, "steers": 0.3},
    "friction": {"friction": 0.5},
    "taut": {"least": 0.3},
    "envelope": {"envelope": [(1.0, 0.0), (0.5, 0.8), (-0.2, 0.4), (0.0, -0.6)]},
}
STRAIGHT = ("ray", "two ways", "friction", "taut", "envelope")


def draw(seed, count, kinds=tuple(KINDS)):
    """Return a swarm of thrusters of random kinds."""
    rng = np.random.default_rng(seed)
    robots = []
    for kind in rng.choice(kinds, count):
        direction = 0.0 if kind == "envelope" else rng.uniform(-3.0, 3.0)
        limit = 1.0 if kind == "envelope" else rng.uniform(0.6, 2.0)
        contact = tuple(rng.uniform(-1.0, 1.0, 2))
        robots.append(Robot(contact, direction, limit, mounted=True, **KINDS[kind]))
    return Swarm(SQUARE, robots)


def corners(robot):
    """Return forces (k, 2) that span what a robot can exert; arcs by 2 000 of theirs."""
    if robot.envelope:
        return np.array(robot.envelope)
    if robot.friction:
        pairs = [
            (s, side * robot.friction * s) for s in (robot.least, robot.limit) for side in (-1, 1)
        ]
        local = np.array(pairs)
    else:
        turns = np.linspace(-robot.steers, robot.steers, 2001) if robot.steers else np.zeros(1)
        arc = np.column_stack([np.cos(turns), np.sin(turns)])
        low = -robot.reverse_limit if robot.reverse_limit else robot.least
        local = np.concatenate([robot.limit * arc, low * arc])
    c, s = math.cos(robot.direction), math.sin(robot.direction)
    return local @ np.array([[c, s], [-s, c]])


def wrenches(robot):
    """Return the wrenches (k, 3) of `corners`."""
    F, (x, y) = corners(robot), robot.contact
    return np.column_stack([F, x * F[:, 1] - y * F[:, 0]])


@pytest.mark.parametrize("seed", range(20))
def test_a_mesh_is_certified_from_inside_and_outside(seed):
    """Vertices are wrenches of the set, and no wrench is farther beyond a face than the gap."""
    swarm = draw(seed, 2 + seed % 7)
    whole = WrenchSet(swarm)
    mesh = whole.mesh(0.01)
    assert whole.rank == 3
    check_closed(mesh)
    assert whole.contains(mesh.vertices[::17]).all()
    reach = sum((mesh.normals * swarm.scale @ wrenches(r).T).max(axis=1) for r in swarm)
    size = float(np.abs(mesh.vertices * swarm.scale).max())
    np.testing.assert_allclose(mesh.offsets, reach, rtol=0.0, atol=2e-6 * size)
    inside = (mesh.vertices * swarm.scale @ mesh.normals.T).max(axis=0)
    assert (mesh.offsets - inside).max() <= mesh.gap + 1e-9 * size <= 0.021 * size


@pytest.mark.parametrize("seed", range(12))
def test_sets_without_arcs_are_exact(seed):
    """As the hull of all sums of corners has it: volume and corners."""
    swarm = draw(seed, 3 + seed % 3, STRAIGHT)
    sums = [sum(chosen) for chosen in itertools.product(*map(wrenches, swarm))]
    hull = ConvexHull(np.array(sums) * swarm.scale)
    whole = WrenchSet(swarm)
    assert whole.volume * swarm.scale.prod() == pytest.approx(hull.volume, rel=1e-9)
    mesh = whole.mesh()
    assert len(mesh.vertices) == len(hull.vertices)
    assert mesh.gap <= 1e-8
    check_closed(mesh)


@pytest.mark.parametrize("seed", range(6))
def test_sums_of_forces_are_contained_and_nothing_beyond_the_support(seed):
    """Mixtures of what each can exert; and the farthest wrench, moved outward."""
    rng = np.random.default_rng(seed)
    swarm = draw(seed, 5)
    members = np.zeros((5, 3))
    for robot in swarm:
        W = wrenches(robot)
        members += rng.dirichlet(np.ones(len(W)), 5) @ W
    whole = WrenchSet(swarm)
    assert whole.contains(members).all()
    n = rng.normal(size=3)
    farthest = sum(W[(W @ n).argmax()] for W in map(wrenches, swarm))
    assert whole.contains(farthest)
    assert not whole.contains(farthest + 1e-3 * n)
    assert whole.support(n) == pytest.approx(n @ farthest, abs=1e-5)


def test_a_drum():
    """An azimuth at the centre and a two-way thruster across: volume 2 pi, sections discs."""
    drum = Swarm(
        SQUARE,
        [
            Robot((0, 0), 0.0, steers=math.pi, mounted=True),
            Robot((0, 1), 0.0, reverse_limit=1.0),
        ],
    )
    whole = WrenchSet(drum)
    assert 0.995 * math.tau <= whole.volume <= math.tau
    lower, upper = whole.bounds()
    np.testing.assert_allclose([lower, upper], [(-2, -1, -1), (2, 1, 1)], atol=1e-12)
    cut = whole.mesh(1e-4).section(0.5)
    assert np.hypot(cut[:, 0] + 0.5, cut[:, 1]) == pytest.approx(np.ones(len(cut)), abs=1e-3)


def test_one_robot_that_steers_is_flat():
    """A sector has no volume: one polygon, seen from both sides."""
    whole = WrenchSet(Swarm(SQUARE, [Robot((1, 0.5), 3.0, 2.0, steers=0.4)]))
    mesh = whole.mesh(1e-4)
    assert (whole.rank, len(mesh.faces), whole.volume) == (2, 2, 0.0)
    fan = mesh.vertices[1:] - mesh.vertices[0]
    area = np.linalg.norm(np.cross(fan[:-1], fan[1:]), axis=1).sum() / 2.0
    lean = math.hypot(1.0, math.hypot(1.0, 0.5))
    assert area == pytest.approx(0.4 * 4.0 * lean, rel=1e-3)
    assert whole.contains([0.0, 0.0, 0.0])


@pytest.mark.parametrize("tolerance", [0.0, 0.2, math.nan, "fine"])
def test_a_tolerance_out_of_range_is_refused(tolerance):
    """With the range."""
    with pytest.raises(WrenchInvalid, match=r"1e-6 <= tolerance <= 0\.1"):
        WrenchSet(draw(0, 3)).mesh(tolerance)
