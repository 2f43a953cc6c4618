"""The object: orientation, measures, and contacts by point, arc length, edge and angle."""

import math
import tracemalloc

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from shapely import Point, Polygon

from swarmgrasp.errors import ContactInvalid, OutlineInvalid, SwarmGraspError, ZoneInvalid
from swarmgrasp.outline import Outline

RECTANGLE = [(0.0, 0.0), (4.0, 0.0), (4.0, 2.0), (0.0, 2.0)]
U_SHAPE = [(0, 0), (6, 0), (6, 4), (4, 4), (4, 1), (2, 1), (2, 4), (0, 4)]


def star(rng, corners):
    """Return a random polygon and a middle, every ray from which crosses it once."""
    angles = np.sort(rng.uniform(0.0, 2.0 * math.pi / corners, corners))
    angles += 2.0 * math.pi / corners * np.arange(corners)
    radii = rng.uniform(0.5, 2.0, corners)
    middle = rng.normal(size=2)
    return middle + radii[:, None] * np.column_stack([np.cos(angles), np.sin(angles)]), middle


stars = st.builds(
    lambda seed, corners: star(np.random.default_rng(seed), corners),
    st.integers(0, 2**32),
    st.integers(5, 12),
)


def test_clockwise_vertices_are_turned_and_keep_their_first_corner_and_names():
    """Edge names follow their edges when the orientation is reversed."""
    given_names = ["west", "north", "east", "south"]
    turned = Outline([(0, 0), (0, 2), (4, 2), (4, 0)], edge_names=given_names)
    assert turned.vertices.tolist() == [list(v) for v in RECTANGLE]
    assert turned.edge_names == ("south", "east", "north", "west")


def test_closing_and_repeated_vertices_are_dropped():
    """A closed ring and a stuttering list both give the same rectangle."""
    ring = [RECTANGLE[0], *RECTANGLE, RECTANGLE[0]]
    assert Outline(ring).vertices.tolist() == [list(v) for v in RECTANGLE]


@given(stars)
@settings(deadline=None, max_examples=60)
def test_area_perimeter_and_centroid_agree_with_shapely(drawn):
    """Measures of random non-convex polygons, given either way round."""
    corners, _ = drawn
    truth = Polygon(corners)
    for vertices in (corners, corners[::-1]):
        outline = Outline(vertices)
        assert outline.area == pytest.approx(truth.area, rel=1e-12)
        assert outline.perimeter == pytest.approx(truth.length, rel=1e-12)
        np.testing.assert_allclose(outline.origin, truth.centroid.coords[0], atol=1e-12)


def test_the_given_origin_is_kept_and_the_callers_arrays_are_left_alone():
    """Moments may be taken about any point; only the outline's own copies are read-only."""
    origin, vertices = np.array([1.0, 0.5]), np.array(RECTANGLE)
    outline = Outline(vertices, origin=origin)
    origin[0] = vertices[0, 0] = 9.0
    assert outline.origin.tolist() == [1.0, 0.5]
    assert outline.radius == pytest.approx(math.hypot(3.0, 1.5))
    with pytest.raises(ValueError, match="read-only"):
        outline.vertices[0, 0] = 1.0


@given(stars, st.floats(0.0, 1.0))
@settings(deadline=None, max_examples=60)
def test_arc_length_point_and_angle_name_the_same_contact(drawn, share):
    """Arc length -> point -> arc length, and theta -> point, are round trips."""
    outline = Outline(drawn[0], origin=drawn[1])
    contact = outline.at_arc_length(share * outline.perimeter)
    again = outline.at_point(contact.point)
    gap = abs(again.arc_length - contact.arc_length)
    assert min(gap, outline.perimeter - gap) <= 2.0 * outline.tolerance
    assert math.dist(again.point, contact.point) <= outline.tolerance
    x, y = np.subtract(contact.point, outline.origin)
    by_angle = outline.at_angle(math.atan2(y, x))
    assert math.dist(by_angle.point, contact.point) <= 1e-5 * outline.extent


@given(stars)
@settings(deadline=None, max_examples=30)
def test_inward_normals_point_inside(drawn):
    """A small step along an edge's inward normal ends inside, against it outside."""
    outline = Outline(drawn[0])
    for edge in range(len(outline)):
        p, q = outline.edge_ends(edge)
        step = (
            1e-4
            * outline.extent
            * np.array(
                [math.cos(outline.inward_normal(edge)), math.sin(outline.inward_normal(edge))]
            )
        )
        assert outline.contains(0.5 * (p + q) + step)
        assert not outline.contains(0.5 * (p + q) - step)


@pytest.mark.parametrize(
    ("theta", "point", "edge"),
    [(0.0, (4, 1), 1), (math.pi / 2, (2, 2), 2), (-math.pi, (0, 1), 3), (9.5 * math.pi, (2, 0), 0)],
)
def test_theta_on_a_convex_outline(theta, point, edge):
    """The paper's polar angle names one contact, whatever turn it is given in."""
    contact = Outline(RECTANGLE).at_angle(theta)
    np.testing.assert_allclose(contact.point, point, atol=1e-12)
    assert contact.edge == edge


def test_theta_on_a_non_convex_outline_is_refused_where_it_is_ambiguous():
    """The message gives every point that the ray meets, and the way out."""
    outline = Outline(U_SHAPE, origin=(3, 0.5))
    assert outline.at_angle(math.pi / 2).point == pytest.approx((3, 1))
    with pytest.raises(ContactInvalid, match=r"3 times, at .*by point or arc length"):
        outline.at_angle(math.atan2(1.5, 2.0))
    with pytest.raises(ContactInvalid, match="nowhere"):
        Outline(RECTANGLE, origin=(9, 1)).at_angle(0.0)


def test_a_corner_belongs_to_the_edge_that_starts_there():
    """By arc length from either side, by point and by angle; the last corner is the first."""
    outline = Outline(RECTANGLE)
    for contact in (
        outline.at_arc_length(4.0),
        outline.at_arc_length(4.0 - 1e-9),
        outline.at_point((4, 0)),
        outline.at_angle(math.atan2(-1, 2)),
    ):
        assert (contact.edge, contact.is_corner, contact.arc_length) == (1, True, 4.0)
        assert contact.point == pytest.approx((4, 0), abs=1e-8)
    last = outline.at_arc_length(outline.perimeter)
    assert (last.edge, last.arc_length, last.point) == (0, 0.0, (0.0, 0.0))
    assert not outline.at_arc_length(1.0).is_corner
    named = outline.on_edge(0, 4.0)  # but an edge that is named keeps its own normal
    assert (named.edge, named.point, named.is_corner) == (0, (4.0, 0.0), True)
    assert named.inward == pytest.approx(math.pi / 2)


def test_edges_are_found_by_name_or_index():
    """A stretch of a named edge carries the name; the whole edge is the default."""
    outline = Outline(RECTANGLE, edge_names=["quay", "", "", ""])
    stretch = outline.stretch("quay", 1.0, 3.0)
    assert (stretch.start, stretch.end, stretch.name) == (1.0, 3.0, "quay")
    assert (outline.stretch(1).start, outline.stretch(1).end) == (4.0, 6.0)
    assert outline.stretch(2, 0.5, 0.5).is_point
    assert outline.on_edge(1, 0.5).point == (4.0, 0.5)


@pytest.mark.parametrize(
    ("ask", "error", "says"),
    [
        (lambda o: o.on_edge("key", 1.0), ContactInvalid, "'key'; the named edges: 'quay'"),
        (lambda o: o.on_edge(4, 1.0), ContactInvalid, "edges run from 0 to 3"),
        (lambda o: o.on_edge("quay", 5.0), ContactInvalid, r"should lie in \[0, 4\] m"),
        (lambda o: o.stretch(0, 2.0, 1.0), ZoneInvalid, "2.0 to 1.0 m does not lie on quay"),
        (lambda o: o.at_arc_length(13.0), ContactInvalid, r"in \[0, 12\] m"),
        (lambda o: o.at_arc_length(math.nan), ContactInvalid, "arc length nan"),
        (
            lambda o: o.at_point((2.0, -0.25)),
            ContactInvalid,
            r"0\.25 m off the boundary: .* \(2, 0\) m on quay",
        ),
    ],
)
def test_a_contact_that_is_not_there_is_explained(ask, error, says):
    """Every message shows the value, the range and where the nearest answer is."""
    outline = Outline(RECTANGLE, edge_names=["quay", "", "", ""])
    with pytest.raises(error, match=says):
        ask(outline)


@pytest.mark.parametrize(
    ("vertices", "says"),
    [
        ([(0, 0), (2, 2), (2, 0), (0, 2)], r"crosses or touches itself at \(1, 1\) m"),
        ([(0, 0), (1, 1), (2, 2), (3, 3)], "collinear"),
        ([(0, 0), (1, 0), (0, 0)], "2 distinct vertices; it needs at least 3"),
        ([(0, 0), (1, 0), (math.nan, 1)], "vertex 2 is .nan, 1.0.; coordinates should be finite"),
        ([(0, 0, 0), (1, 0, 0), (0, 1, 0)], r"shape \(3, 3\)"),
        ([(0, 0), (1, 0), (0,)], r"list of \[x, y\] pairs"),
        ([], r"should be \(k, 2\)"),
    ],
)
def test_a_bad_outline_is_named(vertices, says):
    """Crossings, lines, too few corners, and numbers that are none."""
    with pytest.raises(OutlineInvalid, match=says):
        Outline(vertices)


def test_all_faults_of_names_and_origin_are_shown_at_once():
    """A wrong count, a name used twice and a bad origin come in one error."""
    with pytest.raises(SwarmGraspError) as caught:
        Outline(RECTANGLE, origin=(0, math.inf), edge_names=["a", "a", "b"])
    assert len(caught.value.faults) == 3


def test_contains_counts_the_boundary_and_not_the_bay():
    """Inside a U, on its edge, in its bay, and outside."""
    outline = Outline(U_SHAPE)
    inside = [outline.contains(p) for p in [(1, 3), (2, 3), (3, 3), (3, 1), (7, 1)]]
    assert inside == [True, True, False, True, False]


@given(stars, st.integers(0, 2**32))
@settings(deadline=None, max_examples=40)
def test_nearest_points_and_insides_agree_with_shapely(drawn, seed):
    """Random points, corners and middles of edges, against a random non-convex polygon."""
    outline = Outline(drawn[0])
    points = drawn[1] + np.random.default_rng(seed).uniform(-2.5, 2.5, (40, 2))
    ends = np.roll(outline.vertices, -1, axis=0)
    points = np.vstack([points, outline.vertices, 0.5 * (outline.vertices + ends)])
    truth = Polygon(outline.vertices)
    distances, arc_lengths = outline.nearest(points)
    for point, distance, arc_length in zip(points, distances, arc_lengths, strict=True):
        assert distance == pytest.approx(truth.exterior.distance(Point(point)), abs=1e-12)
        reached = outline.at_arc_length(arc_length).point
        assert math.dist(reached, point) == pytest.approx(distance, abs=2.0 * outline.tolerance)
    inside = [truth.covers(Point(point)) for point in points[:40]] + [True] * (2 * len(outline))
    assert outline.contains_each(points).tolist() == inside


def test_many_points_are_taken_in_parts_with_the_same_answers():
    """A part's border shows nowhere, whatever the number of edges; no points are no answers."""
    rng = np.random.default_rng(5)
    outline = Outline(star(rng, 120)[0])
    points = rng.uniform(-2.0, 2.0, (700, 2))
    each = [np.concatenate(values) for values in zip(*map(outline.nearest, points), strict=True)]
    np.testing.assert_array_equal(outline.nearest(points), each)
    np.testing.assert_array_equal(
        outline.contains_each(points), [outline.contains(point) for point in points]
    )
    assert [values.shape for values in outline.nearest([])] == [(0,), (0,)]


def test_a_million_points_take_little_memory():
    """Far less than points times edges."""
    outline = Outline(star(np.random.default_rng(5), 40)[0])
    points = np.random.default_rng(6).uniform(-2.0, 2.0, (1_000_000, 2))
    tracemalloc.start()
    outline.nearest(points)
    _, peak = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    assert peak < 100e6


def test_a_point_out_of_this_world_is_merely_far_away():
    """Its distance overflows, without a warning."""
    assert Outline(RECTANGLE).nearest((1e300, 0.0))[0].tolist() == [math.inf]


def test_normals_and_lengths_are_kept_for_all_edges():
    """Arrays that nobody can change, the same as edge by edge."""
    outline = Outline(U_SHAPE)
    assert outline.inward_normals.tolist() == [outline.inward_normal(e) for e in range(8)]
    np.testing.assert_allclose(outline.inward_normals[:3] / math.pi, [0.5, 1.0, -0.5])
    assert outline.lengths.tolist() == [math.dist(*outline.edge_ends(e)) for e in range(8)]
    for array in (outline.inward_normals, outline.lengths, outline.edge_ends(3)[1]):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 9.0


def test_an_outline_goes_to_shapely_and_comes_back() -> None:
    """With its names and origin where they are given; no hole is swallowed."""
    square = Polygon([(0, 0), (0, 2), (4, 2), (4, 0)])
    found = Outline.from_shapely(square, (1.0, 1.0), ["left", "top", "right", "bottom"])
    assert found.to_shapely().equals(square)
    assert found.area == 8.0
    assert found.inward_normal("left") == 0.0
    assert "4 m by 2 m" in found._repr_svg_()
    with pytest.raises(OutlineInvalid, match="has 1 holes"):
        Outline.from_shapely(square.difference(Polygon([(1, 1), (2, 1), (2, 1.5)])))
    with pytest.raises(OutlineInvalid, match="it should be a shapely Polygon"):
        Outline.from_shapely(square.exterior)
