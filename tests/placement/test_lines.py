"""Newcomers that pull on a line: it never runs through the object."""

import math
from pathlib import Path

import numpy as np
import pytest

from strategies import twisted
from swarmgrasp import Newcomer, Outline, Robot, Swarm, Zone, place, quality
from swarmgrasp.answer_file import document_of
from swarmgrasp.errors import NowhereToAttach
from swarmgrasp.outline.lines import meeting
from swarmgrasp.placement import Problem
from swarmgrasp.scenario import load_scenario
from swarmgrasp.verify import verify_document

CASE = Path(__file__).parents[1] / "data" / "cases" / "floating-dock-pull.yaml"
KINDS = ({}, {"steers": True}, {"reverse_limit": 0.5})


def test_no_answer_for_the_dock_pulls_through_it():
    """Neither the best place nor the runners-up; from its bottom only what the opening allows."""
    problem = load_scenario(CASE).problem()
    answer = place(problem, runners_up=0.0)
    for robot in (answer.robot, *(each.robot for each in answer.runners_up)):
        assert meeting(problem.swarm.outline, robot.contact, robot.direction) is None
    assert answer.verify()


@pytest.mark.parametrize("seed", range(9))
def test_lines_run_free_and_the_proof_holds(seed):
    """Of every kind, in outlines full of bights; a grid of free pulls finds nothing better."""
    rng = np.random.default_rng(seed)
    outline = twisted(rng)
    at = rng.uniform(0.0, outline.perimeter, 6)
    contacts = [outline.at_arc_length(s) for s in at]
    turns = rng.uniform(-0.5, 0.5, 6)
    swarm = Swarm(
        outline, [Robot(c.point, c.inward + t) for c, t in zip(contacts, turns, strict=True)]
    )
    kind = KINDS[seed % 3]
    answer = place(swarm, Newcomer(1.0, "pull", half_angle=1.2, **kind))
    assert answer.verify()
    for turn in (-answer.robot.steers, 0.0, answer.robot.steers):
        assert meeting(outline, answer.robot.contact, answer.robot.direction + turn) is None
    if not kind:
        for arc in rng.uniform(0.0, outline.perimeter, 60):
            contact = outline.at_arc_length(arc)
            # a window may be wider than its cell by a degree: keep clear of that
            way = contact.inward + math.pi + rng.uniform(-1.2, 1.2)
            if all(
                meeting(outline, contact.point, way + off) is None for off in (-0.02, 0.0, 0.02)
            ):
                with_it = quality(swarm.with_robot(Robot(contact.point, way))).value
                assert with_it <= answer.upper_bound * (1.0 + 1e-9)


def test_a_forged_pull_through_the_object_is_refused():
    """The check has its own eyes for lines."""
    problem = load_scenario(CASE).problem()
    document = document_of(place(problem))
    robot = document["placements"][0]["robot"]
    robot |= {"contact": [12.96, 14.0], "direction": math.radians(-150.0)}
    faults = verify_document(document).faults
    assert any("is not an allowed one" in fault for fault in faults), faults


def test_where_no_line_runs_free_there_is_no_place():
    """A zone at the bottom of a closed hook."""
    outer = [(0, 0), (6, 0), (6, 5), (2, 5), (2, 3), (3, 3)]
    outline = Outline([*outer, (3, 4), (5, 4), (5, 1), (1, 1), (1, 5), (0, 5)])
    swarm = Swarm(outline, [Robot((3.0, 0.0), math.pi / 2)])
    zone = Zone(outline.stretch(8, 0.5, 2.4), attachment="pull", half_angle=0.2)
    with pytest.raises(NowhereToAttach, match="a line that pulls has to run free"):
        Problem(swarm, Newcomer(), [zone]).pieces()
    assert Problem(swarm, Newcomer(attachment="push"), [Zone(zone.stretch)]).pieces()
