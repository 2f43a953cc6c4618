"""The pieces of a boundary, on a square of 2 m and an L, by hand."""

import math

import pytest

from strategies import L_SHAPE
from swarmgrasp import Newcomer, Outline, Robot, Stretch, Swarm, Zone
from swarmgrasp.errors import NowhereToAttach, ZoneInvalid
from swarmgrasp.placement import Problem, place

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)], edge_names=["s", "e", "n", "w"])
QUARTER = math.pi / 2


def ask(*zones, robots=(), outline=SQUARE, newcomer=None, **rest):
    """Return the pieces of a problem."""
    newcomer = newcomer or Newcomer(attachment="pull", half_angle=0.0)
    return Problem(Swarm(outline, robots), newcomer, zones or None, **rest).pieces().each


def parts(*zones, **rest):
    """Return (edge, start, end) of each piece, in order."""
    found = [(p.edge, round(p.start, 9), round(p.end, 9)) for p in ask(*zones, **rest)]
    return sorted(found)


# -- where ----------------------------------------------------------------------------


def test_the_whole_boundary():
    """Every edge once for a pull or a push, on both sides for a free robot."""
    assert parts() == [(e, 0.0, 2.0) for e in range(4)]
    assert len(ask(newcomer=Newcomer(attachment="free"))) == 8
    assert [p.place for p in ask()] == ["s", "e", "n", "w"]


@pytest.mark.parametrize(
    ("start", "end", "expected"),
    [
        (1.0, 2.0, [(0, 1.0, 2.0)]),
        (2.0, 4.0, [(1, 0.0, 2.0)]),
        (1.5, 4.5, [(0, 1.5, 2.0), (1, 0.0, 2.0), (2, 0.0, 0.5)]),
        (7.5, 1.0, [(0, 0.0, 1.0), (3, 1.5, 2.0)]),  # wraps the first vertex
        (0.0, 8.0, [(e, 0.0, 2.0) for e in range(4)]),
        (6.0, 8.0, [(3, 0.0, 2.0)]),
        (6.0, 0.0, [(3, 0.0, 2.0)]),  # ends at the first vertex, by its other name
        (8.0, 2.0, [(0, 0.0, 2.0)]),
        (2.0 - 1e-12, 4.0 + 1e-12, [(1, 0.0, 2.0)]),
        (2.5, 2.5, [(1, 0.5, 0.5)]),
        (2.0, 2.0, [(0, 2.0, 2.0), (1, 0.0, 0.0)]),  # a bollard at a corner: both its edges
        (0.0, 0.0, [(0, 0.0, 0.0), (3, 2.0, 2.0)]),
        (8.0, 8.0, [(0, 0.0, 0.0), (3, 2.0, 2.0)]),
    ],
)
def test_a_stretch_is_cut_at_the_corners(start, end, expected):
    """A stretch that only touches an edge's end does not cover it; a point there does."""
    assert parts(Zone(Stretch(start, end))) == expected


@pytest.mark.parametrize(
    ("no_go", "expected"),
    [
        ([(0.5, 1.5)], [(0, 0.0, 0.5), (0, 1.5, 2.0)]),  # splits it
        ([(7.5, 0.5)], [(0, 0.5, 2.0)]),
        ([(0.5, 1.0), (1.0, 1.5)], [(0, 0.0, 0.5), (0, 1.5, 2.0)]),
        ([(0.0, 0.1 + 0.2), (0.3, 1.5)], [(0, 1.5, 2.0)]),
        ([(0.5, 1.5), (1.0, 3.0)], [(0, 0.0, 0.5)]),
    ],
)
def test_no_go_stretches_split_an_edge(no_go, expected):
    """What remains is closed: the ends of a no-go stretch are allowed."""
    assert parts(Zone(Stretch(0, 2)), no_go=tuple(Stretch(*ends) for ends in no_go)) == expected


def test_a_no_go_point_is_refused():
    """It would forbid nothing."""
    with pytest.raises(ZoneInvalid, match="forbids nothing; give it a width"):
        ask(no_go=(Stretch(1.0, 1.0, "cleat"),))


def test_zones_of_one_name_are_told_apart():
    """Each is a place of its own."""
    zones = [Zone(Stretch(0.2, 0.8, "pad")), Zone(Stretch(1.2, 1.8, "pad"))]
    assert [p.place for p in ask(*zones)] == ["pad (1)", "pad (2)"]


@pytest.mark.parametrize(
    ("at", "no_go"), [(1.0, (0.5, 1.5)), (2.0, (1.5, 2.5)), (0.0, (7.5, 0.5)), (8.0, (7.5, 0.5))]
)
def test_a_bollard_inside_a_no_go_stretch_is_gone(at, no_go):
    """Along an edge, round a corner, and round the first vertex."""
    with pytest.raises(NowhereToAttach, match="no boundary point is left to the newcomer: widen"):
        ask(Zone(Stretch(at, at)), no_go=(Stretch(*no_go),))


def test_a_bollard_at_the_end_of_a_no_go_stretch_stays():
    """Its ends are allowed."""
    assert parts(Zone(Stretch(1, 1)), no_go=(Stretch(1, 3),)) == [(0, 1.0, 1.0)]


def test_spacing_is_a_circle_also_round_a_corner():
    """A robot near a corner takes some of both edges, one in reach of a side some of that."""
    near_corner = Robot((0.7, -1), QUARTER)
    left = parts(robots=[near_corner], spacing=0.5)
    assert left == [(0, 0.0, 1.2), (1, 0.4, 2.0), (2, 0.0, 2.0), (3, 0.0, 2.0)]
    wide = parts(robots=[near_corner], spacing=2.5)  # touches w, reaches across to n
    assert wide == [(2, round(0.3 + 1.5, 9), 2.0), (3, 0.0, round(2.0 - math.sqrt(3.36), 9))]


def test_spacing_removes_a_bollard_but_not_at_its_exact_distance():
    """The circle is open."""
    robot = Robot((0, -1), QUARTER)
    assert parts(Zone(Stretch(1.5, 1.5)), robots=[robot], spacing=0.5) == [(0, 1.5, 1.5)]
    with pytest.raises(NowhereToAttach):
        ask(Zone(Stretch(1.5, 1.5)), robots=[robot], spacing=0.51)


def test_mounted_robots_need_no_spacing():
    """A vessel's own thruster leaves the boundary to tugs."""
    robots = [Robot((0, -1), QUARTER, mounted=True), Robot((0.9, 0), 0.0, mounted=True)]
    assert parts(robots=robots, spacing=1.5) == [(e, 0.0, 2.0) for e in range(4)]


def test_nowhere_left():
    """By spacing, by no-go, and by a zone that wants the other side."""
    with pytest.raises(NowhereToAttach):
        ask(robots=[Robot((1, 0), 0.0), Robot((-1, 0), 0.0)], spacing=2.0)
    with pytest.raises(NowhereToAttach):
        ask(no_go=(Stretch(0, 8),))
    with pytest.raises(NowhereToAttach):
        place(Swarm(SQUARE, []), Newcomer(), [Zone(Stretch(0, 2), "push", directions=(4.0, 5.0))])


# -- which way ------------------------------------------------------------------------


def sectors(side, angle=None, **zone):
    """Return the sectors on edge e (inward normal pi), as (lo, hi) turned into [0, 2 pi)."""
    newcomer = Newcomer(attachment=side, half_angle=angle)
    found = ask(Zone(SQUARE.stretch("e"), **zone), newcomer=newcomer)
    return sorted((round(p.lo % (2 * math.pi), 9), round(p.hi - p.lo, 9), p.inward) for p in found)


def test_sectors_about_the_normal():
    """Push inward, pull outward, free both; at most half a turn each."""
    assert sectors("push", 0.25) == [(round(math.pi - 0.25, 9), 0.5, True)]
    assert sectors("pull", 0.0) == [(0.0, 0.0, False)]
    half = round(math.pi, 9)
    expected = [(round(QUARTER, 9), half, True), (round(3 * QUARTER, 9), half, False)]
    assert sectors("free") == expected


def test_a_zone_overrides_the_attachment():
    """Its own, with its own half angle."""
    assert sectors("push", 0.25, attachment="pull", half_angle=0.5) == [
        (round(2 * math.pi - 0.5, 9), 1.0, False)
    ]
    assert len(sectors("push", 0.25, attachment="free")) == 2


@pytest.mark.parametrize("turns", [-2, -1, 0, 1, 3])
@pytest.mark.parametrize("which", ["both", "first", "last"])
def test_an_absolute_range_across_half_a_turn(turns, which):
    """From 170 to 190 degrees is 20 degrees wide, however many turns its ends are given with."""
    lo = math.radians(170) + 2 * math.pi * turns * (which != "last")
    hi = math.radians(-170) + 2 * math.pi * turns * (which != "first")
    expected = [(round(math.radians(170), 9), round(math.radians(20), 9), True)]
    assert sectors("push", directions=(lo, hi)) == expected


def test_an_absolute_range_can_meet_a_side_twice():
    """All but a wedge about the inward normal leaves two sectors of it."""
    lo, hi = math.radians(190), math.radians(170)
    widths = [w for _, w, inward in sectors("push", directions=(lo, hi)) if inward]
    assert widths == [round(math.radians(80), 9)] * 2
    assert len(sectors("free", directions=(lo, hi))) == 3


def test_a_full_turn_is_any_direction():
    """From -180 to 180 degrees nothing is excluded."""
    for ends in ((-math.pi, math.pi), (0.0, 2.0 * math.pi)):
        assert sectors("free", directions=ends) == sectors("free")


def test_edges_of_an_l_shape_face_their_own_ways():
    """Both sides of the notch push into the body."""
    outline = Outline(L_SHAPE)
    found = ask(outline=outline, newcomer=Newcomer(attachment="push", half_angle=0.0))
    assert [round(p.lo / QUARTER) % 4 for p in found] == [1, 2, 3, 2, 3, 0]
    assert sum(p.end - p.start for p in found) == pytest.approx(outline.perimeter)


# -- the question itself --------------------------------------------------------------


def test_every_fault_of_a_question_is_named():
    """Stretches off the boundary, empty zones, a spacing that is no length."""
    swarm = Swarm(SQUARE, [])
    with pytest.raises(ZoneInvalid) as caught:
        Problem(swarm, Newcomer(), (Zone(Stretch(7, 9, "q")),), (Stretch(9, 2),))
    zone, no_go = caught.value.faults
    assert zone == "zone 'q' runs from 7 to 9 m; both ends should lie in [0, 8] m"
    assert no_go.startswith("no-go stretch '' runs from 9 to 2 m")
    with pytest.raises(ZoneInvalid) as caught:
        Problem(swarm, Newcomer(), [3], "q", math.nan)
    assert len(caught.value.faults) == 3
    assert caught.value.faults[0].startswith("the spacing is nan; it should be 0 <= spacing <=")
    with pytest.raises(ZoneInvalid, match="give None for the whole boundary"):
        Problem(swarm, Newcomer(), ())
