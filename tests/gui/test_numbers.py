"""Every number that a page is told is the library's, for every built-in scene."""

import json
import math
from dataclasses import replace
from typing import Any

import msgspec
import numpy as np
import pytest

from paged import unframed
from swarmgrasp import Swarm, WrenchSet, capability, forces, losses, place, quality
from swarmgrasp.gui.asking import Found, ask
from swarmgrasp.gui.errands import told_forces, told_sequence
from swarmgrasp.gui.messages import Forces, Sequence
from swarmgrasp.gui.parts import Sheet, rounded, tell
from swarmgrasp.gui.reading import question_of
from swarmgrasp.gui.scenes import built_in, scene_of
from swarmgrasp.gui.sending import write_message
from swarmgrasp.gui.sphere import sphere
from swarmgrasp.gui.telling import Telling
from swarmgrasp.scenario import example_names, load_example

NEAR = pytest.approx
SCENES = example_names()


def found_of(name: str) -> Found:
    """Ask of a built-in scene as a page does that has not changed it."""
    scene = scene_of(1, name, built_in()[name])
    return ask(question_of(scene.doc, scene.speech), None)


def part(name: str, found: Found) -> dict[str, Any]:
    """Return a part as the page has it."""
    raw = tell(name, Sheet(1, found, lambda: False), lambda: 0.0)
    return json.loads(raw) if raw.startswith(b"{") else unframed(raw)


@pytest.mark.parametrize("name", SCENES)
def test_the_answer_is_that_of_place(name: str) -> None:
    """Place, direction, qualities, bound; the criterion is the file's."""
    scenario, found = load_example(name), found_of(name)
    answer = place(scenario.problem())
    told = json.loads(write_message(Telling(found).part(1, 0.0)))
    after = quality(answer.swarm_after, **scenario.criterion.keywords)
    assert told["question"] == "quality"
    assert told["newcomer"] == answer.robot.to_data()
    assert (told["before"], told["after"], told["bound"]) == NEAR(
        (answer.quality_before, answer.quality, answer.upper_bound), rel=1e-9, abs=0.0
    )
    assert told["load"] == NEAR(scenario.criterion.load, rel=1e-9, abs=1e-9)
    assert told["weakest"]["wrench"] == NEAR(after.weakest_wrench, rel=1e-9, abs=1e-9)
    assert told["order"]["place"] == answer.place
    assert told["worst_loss"] == (list(after.lost) or None)


@pytest.mark.parametrize("name", SCENES)
def test_losses_are_those_of_the_library(name: str) -> None:
    """One by one, the worst first, with the newcomer in place."""
    found, criterion = found_of(name), load_example(name).criterion
    told = part("losses", found)
    beside = {**criterion.keywords, "losing": max(0, criterion.losing - 1)}
    rows = losses(found.swarm, **beside)
    assert [(row["name"], row["value"]) for row in told["rows"]] == [
        (row.name, NEAR(row.quality, rel=1e-9)) for row in rows
    ]
    assert told["all"] == NEAR(quality(found.swarm, **beside).value, rel=1e-9)


@pytest.mark.parametrize("name", ["escort-ring", "deck-barge", "supply-vessel"])
def test_winds_are_those_of_the_library(name: str) -> None:
    """Intact and after losses, with the newcomer and without, as far as float32 goes."""
    scenario, found = load_example(name), found_of(name)
    told = part("capability", found)
    bearings = told["bearings"].astype(float)
    assert np.allclose(np.degrees(bearings), np.arange(0.0, 360.0, 15.0), atol=1e-4)
    exact, losing = np.radians(np.arange(0.0, 360.0, 15.0)), scenario.criterion.losing or 1
    for swarm, names in (
        (found.swarm, ("intact", "lost")),
        (scenario.swarm, ("before_intact", "before_lost")),
    ):
        held = capability(swarm, scenario.environment, exact, losing)
        assert np.allclose(told[names[0]], held.intact, rtol=1e-6, atol=1e-6)
        assert np.allclose(told[names[1]], held.after_loss, rtol=1e-6, atol=1e-6)


@pytest.mark.parametrize("name", ["escort-ring", "rectangle-15", "harbour-tugs", "hull-120"])
def test_the_body_is_that_of_the_worst_case(name: str) -> None:
    """No corner is farther out than the robots reach, and the farthest ones reach so far."""
    found = found_of(name)
    told = part("mesh", found)
    worst, load = found.after.worst_swarm, np.array(found.problem.criterion.load)
    corners = told["corners"] * told["unit"]
    normals = told["normals"] / 127.0
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    height = WrenchSet(worst).support(normals * worst.scale) + normals @ (load * worst.scale)
    slack = height - (corners @ normals.T).max(axis=0)
    assert slack.min() >= -2.0 * told["unit"]
    assert slack.max() <= 0.03 * np.abs(corners).max()
    assert told["ball"]["radius"] * told["unit"] == NEAR(found.after.value, rel=1e-9)
    if told["ball"]["face"] is not None:
        way = normals[told["ball"]["face"]]
        assert way @ found.after.direction == NEAR(1.0, abs=1e-3)
    assert len(told["starts"]) == len(told["normals"]) + 1


@pytest.mark.parametrize("name", ["escort-ring", "deck-barge"])
def test_places_have_the_quality_with_the_newcomer_there(name: str) -> None:
    """A cell of each piece is the quality of the swarm with a robot in it."""
    found = found_of(name)
    told = part("landscape", found)
    swarm, outline = found.problem.swarm, found.problem.swarm.outline
    limit = found.problem.newcomer.limit
    strip = iter(told["strip"].tolist())
    for piece in told["pieces"]:
        columns, rows = piece["columns"], piece["rows"]
        cells = told["values"][piece["first"] :][: len(columns) * len(rows)]
        cells = cells.reshape(len(columns), len(rows))
        assert [next(strip) for _ in columns] == cells.max(axis=1).tolist()
        i, j = len(columns) // 2, len(rows) // 3
        contact = outline.at_arc_length(columns[i])
        way = outline.inward_normal(piece["edge"]) + rows[j]
        robot = found.newcomer
        assert robot is not None
        there = replace(robot, contact=contact.point, direction=way, limit=limit)
        value = quality(swarm.with_robot(there), **found.problem.criterion.keywords).value
        assert (float(cells[i, j]) - 1.0) * told["unit"] == NEAR(value, abs=told["unit"])
    assert told["high"] <= found.after.value * (1.0 + 1e-6)


def test_a_wind_that_is_not_held_asks_for_the_most_that_is() -> None:
    """The largest wind from there is that of `capability` with the newcomer in place."""
    scene = scene_of(1, "escort-ring", built_in()["escort-ring"])
    scene.doc.environment["wind"]["speed"] = 35.0
    found = ask(question_of(scene.doc, scene.speech), 0.0)
    told = json.loads(write_message(Telling(found).part(1, 0.0)))
    environment = found.question.environment
    assert environment is not None
    bearing = environment.wind.bearing
    for swarm, value in ((found.swarm, told["after"]), (found.problem.swarm, told["before"])):
        held = capability(swarm, environment, [bearing], losing=1)
        assert value == NEAR(float(held.after_loss[0]), rel=1e-6)
    assert (told["question"], told["first"]["good"]) == ("wind", False)
    assert told["next"]
    assert all(0.0 < row["value"] <= told["after"] for row in told["next"])


def test_a_load_that_is_not_held_asks_how_much_of_it_is() -> None:
    """The share of the load that is held, where no weather makes it."""
    scene = scene_of(1, "deck-barge", built_in()["deck-barge"])
    scene.doc.problem["criterion"]["load"] = [0.0, 4e6, 0.0]
    found = ask(question_of(scene.doc, scene.speech), None)
    assert found.about == "load"
    share = found.values[1]
    for held, part_of in ((True, 0.999 * share), (False, 1.001 * share)):
        load = (0.0, part_of * 4e6, 0.0)
        assert (quality(found.swarm, load=load).value > 0.0) is held


def test_push_forces_are_those_of_the_library() -> None:
    """Of the robots that are there, beside the load."""
    scene = scene_of(1, "escort-ring", built_in()["escort-ring"])
    wrench = (4e5, -2e5, 1e6)
    told = json.loads(told_forces(Forces(1, scene.doc, scene.speech, wrench)))
    scenario = load_example("escort-ring")
    found = forces(scenario.swarm, wrench, load=scenario.criterion.load)
    assert [row["force"] for row in told["robots"]] == NEAR(found.vectors, rel=1e-9, abs=1e-6)
    assert told["top"] == NEAR(found.largest_share, rel=1e-9)
    assert told["held"] is not found.is_degraded


def test_several_newcomers_follow_each_other() -> None:
    """Each finds those before it; together they are at least as good."""
    scene = scene_of(1, "rectangle-5", built_in()["rectangle-5"])
    ways = [
        json.loads(told_sequence(Sequence(1, scene.doc, scene.speech, 2, together=together)))
        for together in (False, True)
    ]
    for told in ways:
        assert len(told["answers"]) == 2
        assert told["answers"][0]["newcomer"]["name"] != told["answers"][1]["newcomer"]["name"]
    assert ways[0]["answers"][0]["after"] == ways[0]["answers"][1]["before"]
    assert ways[1]["answers"][-1]["after"] >= ways[0]["answers"][-1]["after"] * (1.0 - 1e-6)


def test_nobody_to_place_and_nowhere_to_go_are_judged_all_the_same() -> None:
    """Without a newcomer, and with no zone, the robots that are there are told."""
    scene = scene_of(1, "escort-ring", built_in()["escort-ring"])
    value = quality(
        load_example("escort-ring").swarm, **load_example("escort-ring").criterion.keywords
    )
    nobody = msgspec.structs.replace(scene.doc, newcomer=False)
    nowhere = msgspec.structs.replace(scene.doc, problem={**scene.doc.problem, "zones": []})
    for doc in (nobody, nowhere):
        told = json.loads(
            write_message(Telling(ask(question_of(doc, scene.speech), 0.0)).part(1, 0))
        )
        assert told["order"] is None
        assert told["newcomer"] is None
        assert told["after"] == NEAR(value.value, rel=1e-9)
        assert math.isfinite(told["margin"])


def test_a_body_of_many_is_told_by_its_farthest_wrenches() -> None:
    """In every direction there is none farther than the corner that stands for it."""
    outline = load_example("escort-ring").swarm.outline
    arcs = np.random.default_rng(3).uniform(0.0, outline.perimeter, 60)
    contacts = [outline.at_arc_length(arc) for arc in arcs.tolist()]
    ways = np.array([contact.inward + np.pi for contact in contacts])
    swarm = Swarm.from_arrays(outline, [contact.point for contact in contacts], ways, 5e5)
    body, (directions, triangles) = rounded(swarm), sphere()
    reach = WrenchSet(swarm).support(directions * swarm.scale)
    assert (body.corners * directions).sum(axis=1) == NEAR(reach, rel=1e-9)
    assert np.array_equal(body.faces.reshape(-1, 3), triangles)
    assert np.linalg.norm(body.normals, axis=1) == NEAR(1.0, rel=1e-9)
    assert (len(body.corners) - len(triangles) * 3 // 2 + len(triangles)) == 2
