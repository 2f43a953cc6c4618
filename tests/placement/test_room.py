"""Newcomers that take up room: clear of the object and of the bodies already there."""

import math

import numpy as np
import pytest
from shapely import Polygon, convex_hull, multipoints

from strategies import RECTANGLE, rectangle, twisted
from swarmgrasp import Body, Newcomer, Outline, Robot, Swarm, Zone, place, quality
from swarmgrasp.answer_file import document_of
from swarmgrasp.errors import (
    ForceSetUnsupported,
    NowhereToAttach,
    RobotInvalid,
    ScenarioInvalid,
)
from swarmgrasp.placement import Problem, place_together
from swarmgrasp.placement.room import Room
from swarmgrasp.plot import plan
from swarmgrasp.scenario import parse_scenario
from swarmgrasp.scenario.writing import scenario_text
from swarmgrasp.verify import verify_document

KINDS = ({}, {"steers": True}, {"reverse_limit": 0.5})


def shape(robot, outline):
    """Return the body of a robot that does not steer, as a polygon."""
    inward = outline.at_point(robot.contact).inward
    pushes = math.cos(robot.direction - inward) > 0.0
    away = robot.direction + (math.pi if pushes else 0.0)
    return Polygon(robot.body.corners([robot.contact], [away])[0])


def question(seed):
    """Return a swarm with bodies, and a newcomer with one."""
    rng = np.random.default_rng(seed)
    outline = twisted(rng) if seed % 2 else rectangle(rng)
    body = Body(outline.extent * rng.uniform(0.05, 0.4), outline.extent * rng.uniform(0.03, 0.15))
    robots = []
    for arc in rng.uniform(0.0, outline.perimeter, 5):
        contact = outline.at_arc_length(arc)
        turn = rng.uniform(-0.5, 0.5) + math.pi * (rng.random() < 0.3)
        robots.append(Robot(contact.point, contact.inward + turn, body=body))
    attachment = ("push", "pull")[seed // 2 % 2]
    newcomer = Newcomer(1.0, attachment, rng.uniform(0.1, 0.8), body=body, **KINDS[seed % 3])
    return Problem(Swarm(outline, robots), newcomer), rng


@pytest.mark.parametrize("seed", [0, 1, 2, 3, 4, 6])
def test_bodies_are_clear_and_the_proof_holds(seed):
    """Of every kind; robots drawn at random that are clear by a wide margin are no better."""
    problem, rng = question(seed)
    outline, newcomer = problem.swarm.outline, problem.newcomer
    try:
        answer = place(problem)
    except NowhereToAttach:
        pytest.skip("these leave no room")
    assert answer.verify()
    assert not [pair for pair in Room(answer.swarm_after).crossings() if answer.robot.name in pair]
    if seed % 3:
        return
    taken = [shape(robot, outline) for robot in problem.swarm]
    hull = Polygon(outline.vertices)
    side = 0.0 if newcomer.attachment == "push" else math.pi
    for arc in rng.uniform(0.0, outline.perimeter, 80):
        contact = outline.at_arc_length(arc)
        turn = rng.uniform(-newcomer.half_angle, newcomer.half_angle)
        robot = Robot(contact.point, contact.inward + side + turn, body=newcomer.body)
        # as a cell has it: turned and moved by as much as a cell is wide
        points = [
            newcomer.body.corners([p], [robot.direction + math.pi + side + off], 1.01)[0]
            for off in (-0.05, 0.05)
            for p in neighbours(outline, contact, newcomer.body.beam / 4.0)
        ]
        room = convex_hull(multipoints(np.concatenate(points)))
        if not any(room.intersects(other) for other in taken) and not room.overlaps(hull):
            found = quality(problem.swarm.with_robot(robot)).value
            assert found <= answer.upper_bound * (1.0 + 1e-9)


def neighbours(outline, contact, distance):
    """Return the contacts so far to either side on the same edge."""
    p, q = outline.edge_ends(contact.edge)
    along = (q - p) / outline.lengths[contact.edge]
    at = (np.array(contact.point) - p) @ along
    places = np.clip([at - distance, at + distance], 0.0, outline.lengths[contact.edge])
    return [p + s * along for s in places]


def test_tugs_that_would_cross_are_refused():
    """Contacts far from each other, bodies that would meet: the newcomer turns away."""
    outline = Outline([(-20, -5), (20, -5), (20, 5), (-20, 5)])
    tug = Robot((-3.0, 5.0), math.radians(-45.0), body=Body(15.0, 4.0))
    back = Robot((0.0, -5.0), math.pi / 2)
    swarm = Swarm(outline, [tug, back, Robot((20.0, 0.0), math.pi)])
    zones = [Zone(outline.stretch(2, 28.0, 28.0))]  # at (-8, 5), under the tug's quarter
    wide = Newcomer(1.0, "push", 0.7)
    assert place(swarm, wide, zones).robot.contact == pytest.approx((-8.0, 5.0))
    with pytest.raises(NowhereToAttach, match="its body needs room"):
        place(swarm, Newcomer(1.0, "push", 0.0, body=Body(15.0, 4.0)), zones)
    turned = place(swarm, Newcomer(1.0, "push", 0.7, body=Body(5.0, 2.0)), zones)
    assert not Room(turned.swarm_after).crossings()


def test_the_check_sees_a_body_that_is_in_another():
    """A robot moved beside another one, and a body that shrank, are refused."""
    problem, _ = question(0)
    document = document_of(place(problem))
    first = problem.swarm.robots[0]
    robot = document["placements"][0]["robot"]
    robot |= {"contact": list(first.contact), "direction": first.direction}
    assert any("no room for its body" in fault for fault in verify_document(document).faults)
    robot["body"]["beam"] *= 0.5
    assert any("another body" in fault for fault in verify_document(document).faults)


def test_what_cannot_be_is_refused():
    """Bodies of nothing and of mounted robots; several newcomers with bodies at once."""
    with pytest.raises(RobotInvalid) as error:
        Body(0.0, -1.0)
    assert len(error.value.faults) == 2
    with pytest.raises(RobotInvalid, match="takes up no room"):
        Robot((0.0, 0.0), 0.0, mounted=True, body=Body(1.0, 1.0))
    with pytest.raises(RobotInvalid, match=r"should be a Body|Body\(length, beam\)"):
        Newcomer(body=3.0)
    swarm = Swarm(Outline(RECTANGLE), [Robot((0.0, -1.0), math.pi / 2)])
    with pytest.raises(ForceSetUnsupported, match="leave out the body"):
        place_together(Problem(swarm, Newcomer(body=Body(1.0, 1.0))), 2)


def test_a_robot_that_steers_sweeps_its_room():
    """What it may turn into is taken; what steers all round lies along the normal."""
    outline = Outline(RECTANGLE)
    swinging = Robot((2.0, 0.0), math.pi, steers=0.8, body=Body(2.0, 0.2))
    still = Robot((2.0, 0.0), math.pi, body=Body(2.0, 0.2))
    azimuth = Robot((2.0, 0.0), math.pi, steers=math.pi, body=Body(2.0, 0.2))
    asked = Newcomer(1.0, "push", 0.0, body=Body(1.0, 0.2))
    zone = [Zone(outline.stretch(1, 1.4, 1.4))]
    with pytest.raises(NowhereToAttach):
        place(Swarm(outline, [swinging]), asked, zone)
    for robot in (still, azimuth):
        assert place(Swarm(outline, [robot]), asked, zone).verify()


def test_files_say_bodies_and_plans_show_them():
    """By length and beam, both or neither; written and read again; drawn as areas."""
    text = """
units: {angle: deg}
outline: {vertices: [[-4, -1], [4, -1], [4, 1], [-4, 1]]}
robots: [{name: Ajax, at: 2, direction: inward, limit: 1, length: 2, beam: 50 cm}]
newcomer: {name: Echo, limit: 1, length: 3, beam: 1}
"""
    scenario = parse_scenario(text)
    assert scenario.swarm["Ajax"].body == Body(2.0, 0.5)
    assert scenario.newcomer.body == Body(3.0, 1.0)
    again = parse_scenario(scenario_text(scenario.problem()))
    assert again.swarm["Ajax"].body == Body(2.0, 0.5)
    assert again.newcomer.body == Body(3.0, 1.0)
    with pytest.raises(ScenarioInvalid, match="goes with beam; give both or neither"):
        parse_scenario(text.replace(", beam: 1}", "}"))
    figure = plan(scenario.swarm, placements=[place(scenario.problem())])
    drawn = [each for each in figure.axes[0].collections if each.get_gid() == "room"]
    assert [len(each.get_paths()) for each in drawn] == [1, 1]
