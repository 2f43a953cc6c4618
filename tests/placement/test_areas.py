"""Mounted newcomers: areas inside the outline (T24)."""

import copy
import math

import numpy as np
import pytest
from shapely import Point, Polygon

from swarmgrasp import (
    Newcomer,
    Outline,
    Problem,
    Robot,
    Stretch,
    Swarm,
    Zone,
    place,
    quality,
)
from swarmgrasp.answer_file import document_of
from swarmgrasp.errors import ZoneInvalid
from swarmgrasp.verify import verify_document
from swarmgrasp.verify.digest import digest_of

WAMV = Outline([(-2.45, -1.22), (2.45, -1.22), (2.45, 1.22), (-2.45, 1.22)], origin=(0, 0))
CROSS = [((-2.373776, 1.027135), 0.785), ((-2.373776, -1.027135), -0.785),
         ((1.6, 0.7), -0.785), ((1.6, -0.7), 0.785)]  # fmt: skip
CATAMARAN = Swarm(
    WAMV,
    [Robot(c, a, 250.0, mounted=True, reverse_limit=250.0) for c, a in CROSS],
    characteristic_length=1.0,
)
L_SHAPE = Outline([(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)])
CREW = Swarm(L_SHAPE, [Robot((3, 0.5), 3.0), Robot((0, 0.5), 0.3), Robot((0.5, 2), -1.4),
                       Robot((2, 0), 1.2, steers=0.4)])  # fmt: skip
BAY = Zone(
    area=[(0.2, 0.2), (1.5, 0.2), (1.5, 0.6), (0.6, 0.6), (0.6, 1.5), (0.2, 1.5)], name="bay"
)


def best_inside(problem, rng, count=150):
    """Return the best quality of random places in the areas of a problem."""
    best, newcomer = 0.0, problem.newcomer
    outline = problem.swarm.outline
    shapes = [Polygon(z.area) for z in problem.zones or ()] or [Polygon(outline.vertices)]
    for shape in shapes:
        x, y, to_x, to_y = shape.bounds
        for _ in range(count):
            point = (float(rng.uniform(x, to_x)), float(rng.uniform(y, to_y)))
            if not shape.contains(Point(point)):
                continue
            robot = Robot(
                point, float(rng.uniform(-3.2, 3.2)), newcomer.limit, mounted=True,
                reverse_limit=newcomer.reverse_limit,
            )  # fmt: skip
            swarm = problem.swarm.with_robot(robot)
            best = max(best, quality(swarm, **problem.criterion.keywords).bound)
    return best


def test_a_catamaran_gets_an_inboard_two_way_thruster():
    """Four thrusters in an X hold 500 N, and one more amidships 676.8 N, proven."""
    newcomer = Newcomer(250.0, reverse_limit=250.0, mounted=True)
    answer = place(CATAMARAN, newcomer, gap=1e-4)
    assert answer.quality_before == pytest.approx(499.99984, abs=1e-5)
    assert answer.quality == pytest.approx(676.84691, abs=1e-2)
    assert (answer.place, answer.robot.mounted, answer.stopped_early) == ("inside", True, False)
    verdict = answer.verify()
    assert verdict, verdict.faults
    box = Zone(area=[(-0.5, -0.3), (0.5, -0.3), (0.5, 0.3), (-0.5, 0.3)], name="box")
    inside = place(CATAMARAN, newcomer, [box], gap=1e-4)
    assert inside.quality == pytest.approx(answer.quality, rel=1e-4)
    assert inside.place == "box"


@pytest.mark.parametrize("back", [0.0, 0.5, 1.0])
@pytest.mark.parametrize("zones", [None, (BAY,)])
def test_no_place_inside_beats_the_bound(back, zones):
    """Areas that are not convex too; the robot is inside of them."""
    for terms in ({}, {"load": (0.05, 0.1, -0.05)}):
        answer = place(
            CREW, Newcomer(0.8, reverse_limit=back, mounted=True), zones, gap=1e-3, **terms
        )
        assert best_inside(answer.problem, np.random.default_rng(1)) <= answer.upper_bound
        shape = Polygon(BAY.area if zones else L_SHAPE.vertices)
        assert shape.distance(Point(answer.robot.contact)) <= 1e-9
        assert quality(answer.swarm_after, **terms).value == pytest.approx(answer.quality, rel=1e-7)
        verdict = answer.verify()
        assert verdict, verdict.faults


def test_one_way_beside_rays_only_is_searched_as_ever():
    """By bisection on the level: certified to 1e-6, with proofs and no boxes."""
    rays = CREW.without("R4").with_robot(Robot((2, 0), 1.2))
    answer = place(rays, Newcomer(mounted=True), [BAY])
    assert answer.gap <= 1e-6
    assert answer.certificate.proofs
    assert not answer.certificate.boxes
    assert best_inside(answer.problem, np.random.default_rng(2)) <= answer.upper_bound
    verdict = answer.verify()
    assert verdict, verdict.faults


@pytest.mark.parametrize(
    "area", [[(1.0, 0.5)], [(0.3, 0.3), (0.3, 1.7)], [(0.2, 0.2), (0.9, 0.2), (0.5, 0.2 + 1e-13)]]
)
@pytest.mark.parametrize("back", [0.0, 1.0])
def test_spots_lines_and_slivers(area, back):
    """One corner is a spot, and two are a line."""
    zone = Zone(area=area, name="here", directions=(0.0, 3.0))
    answer = place(CREW, Newcomer(reverse_limit=back, mounted=True), [zone], gap=1e-3)
    low, high = np.min(area, axis=0) - 1e-9, np.max(area, axis=0) + 1e-9
    assert ((low <= answer.robot.contact) & (answer.robot.contact <= high)).all()
    assert -1e-9 <= answer.robot.direction <= 3.0 + 1e-9
    verdict = answer.verify()
    assert verdict, verdict.faults


def test_areas_of_one_name_are_told_apart():
    """Runners-up are of other areas, by their labels."""
    halves = [Zone(area=[(x, 0.2), (x + 0.5, 0.2), (x, 0.7)], name="tank") for x in (0.1, 2.2)]
    answer = place(CREW, Newcomer(0.5, mounted=True), halves, runners_up=0.0, gap=1e-3)
    assert {answer.place, *(r.place for r in answer.runners_up)} == {"tank (1)", "tank (2)"}


@pytest.mark.parametrize(
    ("zone", "word"),
    [
        ({"area": [(0, 0), (1, 1), (1, 0), (0, 1)]}, "crosses itself"),
        ({"area": [(0, 0), (1, 1), (2, 2)]}, "crosses itself or is flat"),
        ({"area": []}, "one or more points"),
        ({"area": [(0, 0), (1, math.nan)]}, "one or more points"),
        ({"area": [(0, 0)], "stretch": Stretch(0.0, 1.0)}, "not both"),
        ({"area": [(0, 0)], "attachment": "push"}, "touches no edge"),
        ({}, "Stretch"),
        ({"stretch": Stretch(0.0, 1.0, "a"), "name": "b"}, "a name of its own"),
    ],
)
def test_zones_that_are_none_are_refused(zone, word):
    """Each by what is wrong with it."""
    with pytest.raises(ZoneInvalid, match=word):
        Zone(**zone)


def test_questions_that_do_not_go_together_are_refused():
    """Areas are for mounted newcomers, stretches for others; all faults at once."""
    mounted = Newcomer(mounted=True)
    with pytest.raises(ZoneInvalid, match="not mounted needs a stretch"):
        Problem(CREW, Newcomer(), [BAY])
    with pytest.raises(ZoneInvalid) as caught:
        Problem(CREW, mounted, [Zone(Stretch(0.0, 1.0))], [Stretch(1.0, 2.0)], 0.5)
    assert len(caught.value.faults) == 3
    with pytest.raises(ZoneInvalid, match="leaves the outline"):
        Problem(CREW, mounted, [Zone(area=[(0.5, 0.5), (2.5, 0.5), (0.5, 1.8)])])


def test_areas_survive_their_plain_form():
    """As all that is asked."""
    problem = Problem(CREW, Newcomer(mounted=True), [BAY])
    assert Problem.from_data(problem.to_data()) == problem


def test_a_forged_place_is_refused():
    """In the outline but not in the area, or not mounted."""
    document = document_of(place(CREW, Newcomer(mounted=True), [BAY], gap=1e-3))
    assert verify_document(document)
    for key, value in (("contact", [2.5, 0.5]), ("mounted", False)):
        forged = copy.deepcopy(document)
        forged["placements"][0]["robot"][key] = value
        forged["digest"] = digest_of(forged)
        assert not verify_document(forged)
