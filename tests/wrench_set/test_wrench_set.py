"""The zonotope of a swarm: support, membership, volume, faces and corners."""

import math

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import reference
from reference import check_closed
from swarmgrasp.errors import MetricInvalid, WrenchInvalid, WrenchSetTooLarge
from swarmgrasp.outline import Outline
from swarmgrasp.swarm import Robot, Swarm
from swarmgrasp.wrench_set import WrenchSet
from swarmgrasp.wrench_set.mesh import MESH_LINES

X, Y, Z = np.eye(3)


def draw(kind, seed, n):
    """Return n generators, (n, 3), of a kind that is easy or hard to get right."""
    rng = np.random.default_rng(seed)
    grid = rng.integers(-2, 3, size=(n, 3)).astype(float)
    if kind == "random":
        return rng.normal(size=(n, 3))
    if kind == "grid":
        return grid
    if kind == "turned grid":  # coplanar and parallel up to rounding
        turn = np.linalg.qr(rng.normal(size=(3, 3)))[0]
        return grid @ turn * rng.uniform(0.1, 3.0, size=(n, 1))
    if kind == "along normals":
        angle, force = rng.choice([0.3, 1.1, 0.3 + math.pi], n), rng.uniform(0.1, 5.0, n)
        return np.column_stack([np.cos(angle), np.sin(angle), rng.normal(size=n)]) * force[:, None]
    # almost coplanar: deviations around the tolerance
    return grid + 10.0 ** rng.uniform(-14, -9) * rng.normal(size=(n, 3))


KINDS = ["random", "grid", "turned grid", "along normals", "almost"]
generators = st.builds(draw, st.sampled_from(KINDS), st.integers(0, 2**32), st.integers(0, 9))


def enclosed(mesh):
    """Volume inside outward faces: sum of tetrahedra over fans of triangles."""
    V = mesh.vertices
    fans = [(f[0], f[i], f[i + 1]) for f in mesh.faces for i in range(1, len(f) - 1)]
    return sum(np.linalg.det(V[list(fan)]) for fan in fans) / 6.0


@pytest.mark.parametrize("name", reference.SOLIDS)
def test_known_solids_have_their_faces_and_corners(name):
    """Parallel pairs merge and coplanar families make one face: 14 faces, 24 corners, ..."""
    B, _, faces, corners = reference.SOLIDS[name]
    mesh = WrenchSet.from_generators(B).mesh()
    assert (len(mesh.faces), len(mesh.vertices)) == (faces, corners)
    check_closed(mesh)


@pytest.mark.parametrize("name", reference.CLOSED_FORMS)
def test_the_nearest_face_is_the_quality_in_closed_form(name):
    """Solids and squares of robots; the slow truth is held to the same numbers."""
    B, exact = reference.CLOSED_FORMS[name]
    assert WrenchSet.from_generators(B).mesh().offsets.min() == pytest.approx(exact, rel=1e-14)
    assert reference.quality(B) == pytest.approx(exact, rel=1e-14)


@given(generators)
@settings(deadline=None, max_examples=120)
def test_a_mesh_is_a_closed_surface_whatever_is_coplanar(B):
    """Faces close up, flat sets are one polygon or less, and all agree with the rank."""
    wrenches = WrenchSet.from_generators(B)
    mesh = wrenches.mesh()
    sizes = len(mesh.vertices), len(mesh.edges), len(mesh.faces)
    if wrenches.rank == 3:
        check_closed(mesh)
    elif wrenches.rank == 2:
        front, back = mesh.faces
        assert sizes[:2] == (len(front), len(front))
        start = back.index(front[0]) + 1
        assert front == (back[start:] + back[:start])[::-1]
        assert wrenches.volume == 0.0
    else:
        assert sizes == ((1, 0, 0), (2, 1, 0))[wrenches.rank]


@given(generators)
@settings(deadline=None, max_examples=80)
def test_faces_are_supporting_planes_and_their_offsets_the_quality(B):
    """No corner lies beyond a face, its own lie on it, and the least offset is Q (T2).

    Robots within an angle a of each other show their common plane to within 1e-15 / a,
    and lie within a of it in any case: sqrt(1e-15) is the worst of both.
    """
    mesh = WrenchSet.from_generators(B).mesh()
    size = np.linalg.norm(B, axis=1).sum()
    heights = mesh.vertices @ mesh.normals.T - mesh.offsets
    assert (heights <= 4e-8 * size).all()
    for k, face in enumerate(mesh.faces):
        assert np.abs(heights[list(face), k]).max() <= 4e-8 * size
    if len(mesh.faces):
        assert mesh.offsets.min() == pytest.approx(reference.quality(B), abs=1e-9 * size)


@pytest.mark.parametrize("seed", range(6))
def test_corners_and_volume_agree_with_the_hull_of_all_sums(seed):
    """All 2^n sums of generators and Qhull know nothing of zonotopes."""
    B = draw("random", seed, 4 + seed % 5)
    wrenches = WrenchSet.from_generators(B)
    volume, corners = reference.corner_hull(B)
    assert wrenches.volume == pytest.approx(volume, rel=1e-12)
    mesh = wrenches.mesh()
    assert len(mesh.vertices) == len(corners)
    gaps = np.linalg.norm(mesh.vertices[:, None] - corners[None], axis=2)
    assert gaps.min(axis=0).max() <= 1e-12
    assert enclosed(mesh) == pytest.approx(volume, rel=1e-12)


@given(generators)
@settings(deadline=None, max_examples=80)
def test_volume_is_the_sum_over_triples(B):
    """The sweep across each generator equals all determinants, flat sets included."""
    size = np.linalg.norm(B, axis=1).max(initial=1.0)
    volume = WrenchSet.from_generators(B).volume
    assert volume == pytest.approx(reference.volume(B), rel=1e-11, abs=1e-9 * size**3)


def test_a_giant_among_dwarfs_counts_and_does_not_swallow_them():
    """Rank, volume and faces with one robot 1e12 times the others."""
    B = draw("grid", 4, 7)
    B[0] *= 1e12
    wrenches = WrenchSet.from_generators(B)
    assert wrenches.rank == 3
    assert wrenches.volume == pytest.approx(reference.volume(B), rel=1e-12)
    check_closed(wrenches.mesh())
    assert wrenches.contains(wrenches.generators.sum(axis=0))


def test_physical_units_pass_through_the_metric():
    """Corners and volume are physical whatever the scale; normals and offsets are scaled."""
    B, scale = draw("random", 5, 6), np.array([2.0, 0.5, 0.1])
    plain, scaled = WrenchSet.from_generators(B), WrenchSet.from_generators(B, scale)
    assert scaled.volume == pytest.approx(plain.volume, rel=1e-12)
    one, two = (sorted(w.mesh().vertices.round(9).tolist()) for w in (plain, scaled))
    assert one == two
    mesh = scaled.mesh()
    np.testing.assert_allclose(np.linalg.norm(mesh.normals, axis=1), 1.0, rtol=1e-14)
    np.testing.assert_allclose(mesh.offsets, scaled.support(mesh.normals * scale), atol=1e-13)


@pytest.mark.parametrize(
    ("B", "rank", "corners", "faces"),
    [
        ([], 0, 1, 0),
        ([[0, 0, 0], [0, 0, 0]], 0, 1, 0),
        ([X], 1, 2, 0),
        ([X, -2 * X, 1e-9 * X], 1, 2, 0),
        ([X, Y], 2, 4, 2),
        ([X, Y, X + Y, -X, 3 * Y], 2, 6, 2),
        ([X, Y, 1e-12 * Z], 3, 8, 6),
        ([X, X, Y, Y, Z, Z], 3, 8, 6),
    ],
)
def test_degenerate_sets(B, rank, corners, faces):
    """Nothing, a segment, a polygon, a sliver and a cube of doubled robots."""
    wrenches = WrenchSet.from_generators(np.reshape(B, (-1, 3)))
    mesh = wrenches.mesh()
    assert (wrenches.rank, len(mesh.vertices), len(mesh.faces)) == (rank, corners, faces)
    lower, upper = wrenches.bounds()
    assert mesh.vertices.min(axis=0).tolist() == pytest.approx(lower.tolist())
    assert mesh.vertices.max(axis=0).tolist() == pytest.approx(upper.tolist())


def test_robots_along_one_line_of_action_are_a_segment():
    """All through a point and parallel: pushing on one side, pulling on the other."""
    square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    line = [Robot((1, 0.5), 0.0), Robot((-1, 0.5), math.pi, 2.0), Robot((-1, 0.5), 0.0, 3.0)]
    wrenches = WrenchSet(Swarm(square, line))
    assert wrenches.rank == 1
    corners = sorted(wrenches.mesh().vertices.tolist())
    np.testing.assert_allclose(corners, [[-2, 0, 1], [4, 0, -2]], atol=1e-15)


@given(generators, st.integers(0, 2**32))
@settings(deadline=None, max_examples=60)
def test_support_is_the_furthest_corner(B, seed):
    """h(n) = max n . w over the corners, for many directions and for one."""
    wrenches = WrenchSet.from_generators(B)
    normals = np.random.default_rng(seed).normal(size=(20, 3))
    furthest = (wrenches.mesh().vertices @ normals.T).max(axis=0)
    np.testing.assert_allclose(wrenches.support(normals), furthest, atol=1e-9)
    assert wrenches.support(normals[0]) == pytest.approx(furthest[0], abs=1e-9)


@given(generators, st.integers(0, 2**32))
@settings(deadline=None, max_examples=40)
def test_every_sum_of_forces_is_contained_and_nothing_beyond_the_support(B, seed):
    """Members by construction; a corner pushed outward is separated, so refused."""
    rng = np.random.default_rng(seed)
    wrenches = WrenchSet.from_generators(B)
    members = rng.uniform(size=(3, len(B))) @ B
    n = rng.normal(size=3)
    corner = B[B @ n > 0.0].sum(axis=0)
    beyond = corner + 1e-6 * (1.0 + np.linalg.norm(B, axis=1).sum()) * n / np.linalg.norm(n)
    assert wrenches.contains(np.vstack([members, corner, beyond])).tolist() == [True] * 4 + [False]


def test_membership_of_a_flat_set_is_membership_in_its_plane():
    """In the polygon, in the plane but outside, off the plane, and within the tolerance."""
    flat = WrenchSet.from_generators([X, Y, X + Y])
    wanted = [[1, 1, 0], [2.5, 0, 0], [1, 1, 1e-6], [1, 1, 1e-10], [2, 2, 0]]
    assert flat.contains(wanted).tolist() == [True, False, False, True, True]
    assert flat.contains([1, 1, 1e-6], tolerance=1e-6) is True


@pytest.mark.parametrize(
    ("bad", "says"),
    [
        ([[0, 0, 1], [0, math.nan, 0]], r"\[1\] is \[0.0, nan, 0.0\]; it should be finite"),
        ([math.inf, 0, 0], "should be finite"),
        ([1.0, 2.0], r"shape \(2,\); it should be \(m, 3\) or \(3,\)"),
        (["force", 0, 0], "triples of numbers"),
    ],
)
def test_bad_vectors_are_named(bad, says):
    """The same sentence for wrenches, normals and generators."""
    cube = WrenchSet.from_generators(np.eye(3))
    for ask in (cube.contains, cube.support, WrenchSet.from_generators):
        with pytest.raises(WrenchInvalid, match=says):
            ask(bad)


@pytest.mark.parametrize("scale", [(1, 1), (1, 1, 0), (1, 1, math.inf)])
def test_a_bad_scale_is_refused(scale):
    """Three positive finite numbers."""
    with pytest.raises(MetricInvalid, match="1e-100 <= s"):
        WrenchSet.from_generators([X], scale)


def test_a_mesh_of_too_many_directions_is_refused_with_the_remedy():
    """Parallel robots do not count twice."""
    B = draw("random", 0, MESH_LINES + 1)
    with pytest.raises(WrenchSetTooLarge, match="use support"):
        WrenchSet.from_generators(B).mesh()
    assert len(WrenchSet.from_generators(np.vstack([B[:3]] * 99)).mesh().vertices) == 8
