"""What robots can exert, in a scenario file: what it means, and its faults."""

import math
import re

import jsonschema
import pytest

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.scenario import parse_scenario, scenario_schema, scenario_text
from swarmgrasp.swarm import Newcomer, Robot, Zone

# line 3 is the first robot, line 4 what follows it
HEAD = (
    "units: {force: kN, angle: deg}\n"
    "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]], edges: [s, e, n, w]}\n"
)
AT = (4.0, 1.0)
EAST = "edge: e, along: 1"
PUSH = math.pi / 6.0

ROBOTS = {
    "direction: 90, limit: 5, steers: 30": {"direction": math.pi / 2, "limit": 5e3, "steers": PUSH},
    "limit: 5, steers: any": {"direction": 0.0, "limit": 5e3, "steers": math.pi},
    "direction: 0, limit: 5, steers: 180": {"direction": 0.0, "limit": 5e3, "steers": math.pi},
    "direction: 0, limit: {ahead: 51, astern: 40}": {
        "direction": 0.0, "limit": 51e3, "reverse_limit": 40e3,
    },
    "direction: 0, limit: [2, 20]": {"direction": 0.0, "limit": 20e3, "least": 2e3},
    "limit: 5, friction: 0.5": {"direction": math.pi, "limit": 5e3, "friction": 0.5},
    "direction: outward, limit: 5, friction: 0.5": {
        "direction": 0.0, "limit": 5e3, "friction": 0.5,
    },
    "direction: 0, envelope: [[3, 4], [0, 0], [3, -4]]": {
        "direction": 0.0, "envelope": ((3e3, 4e3), (0.0, 0.0), (3e3, -4e3)),
    },
    "limit: 5, sectors: [[20, 160], [200, 340]]": {
        "limit": 5e3,
        "sectors": ((math.radians(20), math.radians(160)), (math.radians(200), math.radians(340))),
    },
    "limit: 5, sectors: [[60, 90], [90, 120]]": {
        "direction": math.pi / 2, "limit": 5e3, "steers": PUSH,
    },
    "direction: 0, limit: 5, group: bus A": {"direction": 0.0, "limit": 5e3, "group": "bus A"},
}  # fmt: skip


@pytest.mark.parametrize("said", ROBOTS)
def test_a_robot_exerts_what_its_file_says(said: str) -> None:
    """Angles and forces in the units of the file; a finger pushes inward unless told otherwise."""
    (robot,) = parse_scenario(f"{HEAD}robots: [{{{EAST}, {said}}}]").swarm.robots
    assert robot == Robot(AT, name="R1", **ROBOTS[said])


NEWCOMERS = {
    "limit: 5, attachment: push, half_angle: 30, steers: true": Newcomer(
        5e3, "push", PUSH, steers=True
    ),
    "limit: {ahead: 51, astern: 40}": Newcomer(51e3, reverse_limit=40e3),
    "limit: 5, two_way: true": Newcomer(5e3, reverse_limit=5e3),
    "limit: 5, attachment: push, friction: 0.5": Newcomer(5e3, "push", friction=0.5),
    "limit: 5, mounted: true, steers: true": Newcomer(5e3, steers=True, mounted=True),
}


@pytest.mark.parametrize("said", NEWCOMERS)
def test_a_newcomer_exerts_what_its_file_says(said: str) -> None:
    """It steers, reverses, has friction or goes inboard."""
    found = parse_scenario(f"{HEAD}robots: []\nnewcomer: {{{said}}}").newcomer
    assert found == NEWCOMERS[said]


# the text that the fault is at, the key below the robot, the sentence
FAULTS = {
    "direction: 0, limit: 5, steers: 181": (
        "181", ".steers", "should lie in [0, 180] deg, or be any (got 181)"
    ),
    "direction: 0, limit: 5, steers: -1": ("-1", ".steers", "should be at least 0 (got -1)"),
    "direction: 0, limit: 5, steers: all": (
        "all", ".steers", "should be an angle or 'any' (got 'all')"
    ),
    "direction: 0, limit: 5, steers: true": (
        "true", ".steers", "should be 'any', or a number (got true)"
    ),
    "limit: 5, sectors: [[20, 160], [90, 200]]": (
        "[[20", ".sectors", "sectors 1 and 2 overlap; say them as one"
    ),
    "direction: 0, limit: 5, sectors: [[20, 160], [200, 340]]": (
        "0, limit", ".direction", "the sectors tell all directions already; leave it out (got 0)"
    ),
    "limit: {ahead: 5, astern: 3}, sectors: [[20, 160], [200, 340]]": (
        "{ahead",
        ".limit",
        "should be one limit beside sectors, the same in all (got {ahead: 5, astern: 3})",
    ),
    "direction: 0, limit: {ahead: 5}": (
        "{ahead", ".limit.astern", "is missing; give the largest force against the direction"
    ),
    "direction: 0, limit: {ahead: 5, astern: 0}": (
        "0}", ".limit.astern", "should be greater than 0 (got 0)"
    ),
    "direction: 0, limit: {ahead: 5, aster: 4, astern: 4}": (
        "aster:", ".limit.aster", "unknown key; did you mean 'astern'?"
    ),
    "direction: 0, limit: [2]": ("[2]", ".limit", "should hold 2 or more values, not 1 (got [2])"),
    "direction: 0, limit: [20, 2]": (
        "[20", ".limit", "should be the least force, then the largest (got [20, 2])"
    ),
    "direction: 0, limit: [2, 20], two_way: true": (
        "true", ".two_way",
        "goes with one limit; what always exerts some force has no other way (got true)",
    ),
    "direction: 0, limit: {ahead: 5, astern: 4}, two_way: true": (
        "true", ".two_way", "the limits ahead and astern say so already; leave it out (got true)"
    ),
    "limit: 5, friction: 0.5, steers: 30": (
        "0.5", ".friction",
        "a finger with friction only pushes: it neither steers nor pushes both ways (got 0.5)",
    ),
    "limit: 5, friction: 0": ("0}", ".friction", "should be greater than 0 (got 0)"),
    "limit: 5": (
        "{edge", ".direction",
        "is missing; give the direction of the force: an angle, inward or outward",
    ),
    "direction: 0": ("{edge", ".limit", "is missing; give the largest force"),
    "direction: 0, envelope: [[1, 0]]": (
        "[[1", ".envelope", "should hold 2 or more values, not 1 (got [[...]])"
    ),
    "direction: 0, envelope: [[0, 0], [0, 0]]": (
        "[[0", ".envelope", "should hold a force that is not zero (got [[...], [...]])"
    ),
    "direction: 0, envelope: [[1, 0], [0, 1]], limit: 1": (
        "1}", ".limit", "the envelope tells all forces already; keep one (got 1)"
    ),
    "direction: 0, limit: 1, grupp: A": ("grupp", ".grupp", "unknown key; did you mean 'group'?"),
}  # fmt: skip


@pytest.mark.parametrize("said", FAULTS)
def test_a_faulty_force_is_told_with_its_place(said: str) -> None:
    """One fault, one sentence, with line, column and key path."""
    where, key, sentence = FAULTS[said]
    line = f"robots: [{{{EAST}, {said}}}]"
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(f"{HEAD}{line}\n", "a.yaml")
    column = line.index(where) + 1
    assert list(caught.value.faults) == [f"a.yaml:3:{column}: robots.0{key}: {sentence}"]


def test_all_that_does_not_go_together_is_told_at_once() -> None:
    """Of robots and of the newcomer, whatever the outline is."""
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(
            "outline: {vertices: [[0, 0], [1, x], [1, 1]]}\n"
            "robots:\n"
            "  - {contact: [1, 1], limit: 5, friction: 0.5, mounted: true}\n"
            "  - {at: 1, limit: {ahead: 1, astern: 1}, two_way: true, friction: 1}\n"
            "newcomer: {limit: [1, 2], friction: 0.5, mounted: true, attachment: pull}\n",
            "a.yaml",
        )
    assert [fault.split(": ", 2)[1:] for fault in caught.value.faults[1:]] == [
        ["robots.0.direction", "is missing; give the direction of the force: an angle"],
        ["robots.1.two_way", "the limits ahead and astern say so already; leave it out (got true)"],
        ["robots.1.friction", "a finger with friction only pushes: it neither steers nor pushes "
         "both ways (got 1)"],
        ["newcomer.limit", "should be a number (got [1, 2])"],
        ["newcomer.friction", "goes with attachment: push only; a finger pushes along the normal "
         "(got 0.5)"],
        ["newcomer.mounted", "a mounted newcomer touches no edge; leave the attachment out, or "
         "make it free (got true)"],
    ]  # fmt: skip


def test_a_finger_at_a_corner_has_no_normal() -> None:
    """Unless the edge is said."""
    with pytest.raises(ScenarioInvalid, match=r"robots\.0\.direction: the normal is ambiguous"):
        parse_scenario(f"{HEAD}robots: [{{contact: [4, 2], limit: 5, friction: 0.5}}]")
    (robot,) = parse_scenario(
        f"{HEAD}robots: [{{edge: e, along: 2, limit: 5, friction: 0.5}}]"
    ).swarm.robots
    assert robot.direction == pytest.approx(math.pi)


@pytest.mark.parametrize(
    "said",
    [
        {"limit": 5},
        {"direction": 0},
        {"direction": 0, "limit": 5, "envelope": [[1, 0], [0, 1]]},
        {"direction": 0, "limit": {"ahead": 5}},
        {"direction": 0, "limit": [5]},
        {"direction": 0, "limit": 5, "steers": "all"},
        {"direction": 0, "limit": 5, "steers": 270},
    ],
)
def test_editors_refuse_what_the_loader_refuses(said: dict[str, object]) -> None:
    """And accept all that it accepts."""
    schema = scenario_schema()
    judge = jsonschema.Draft202012Validator(schema)
    example = schema["examples"][0]
    assert not judge.is_valid({**example, "robots": [{"at": 1, **said}]})
    for good in (
        {"limit": 5, "steers": "any"},
        {"limit": 5, "friction": 0.5},
        {"direction": 0, "limit": [1, 5], "group": "A"},
        {"direction": 0, "limit": {"ahead": 5, "astern": 1}, "steers": 30},
        {"direction": "inward", "envelope": [[1, 0], [0, 1]]},
    ):
        judge.validate({**example, "robots": [{"at": 1, **good}]})


BAY = "{name: bay, area: [[1, 0.5], [2, 0.5], [2, 1.5]], directions: [0, 90]}"
MOUNTED = "robots: []\nnewcomer: {limit: 5, mounted: true}\n"


def test_a_zone_may_be_an_area_inside() -> None:
    """In the file's units, and written as it was read."""
    scenario = parse_scenario(f"{HEAD}{MOUNTED}zones: [{BAY}]")
    bay = Zone(directions=(0.0, math.pi / 2), area=((1.0, 0.5), (2.0, 0.5), (2.0, 1.5)), name="bay")
    assert scenario.zones == (bay,)
    text = scenario_text(scenario)
    assert parse_scenario(text).zones == scenario.zones
    assert "{name: bay, area: [[1, 0.5], [2, 0.5], [2, 1.5]], directions: [0, 90]}" in text


AREAS = {
    "{area: [[1, 1], [5, 1], [1, 0.5]]}": (
        "5:25: zones.0.area.1: an area should be inside; the nearest boundary point is [4, 1] m on "
        "e, 1 m away (got [5, 1])"
    ),
    "{area: [[1, 1], [2, 1.5], [2, 1], [1, 1.5]]}": (
        "5:16: zones.0.area: the area crosses itself or is flat: list its corners in order around "
        "it, or the two ends of a line"
    ),
    "{area: [[1, 1]], edge: s}": "5:9: zones.0: edge and area each say where; keep one",
    "{area: [[1, 1]], attachment: push}": (
        "5:38: zones.0.attachment: an area touches no edge; leave the attachment out (got 'push')"
    ),
    "{edge: s}": (
        "5:9: zones.0: is on the boundary, and a mounted newcomer goes inside; give an area instead"
    ),
    "{area: []}": "5:16: zones.0.area: should hold 1 or more values, not 0 (got [])",
}


@pytest.mark.parametrize("zone", AREAS)
def test_a_faulty_area_is_told_with_its_place(zone: str) -> None:
    """One fault, one sentence, with line, column and key path."""
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(f"{HEAD}{MOUNTED}zones: [{zone}]", "a.yaml")
    assert list(caught.value.faults) == [f"a.yaml:{AREAS[zone]}"]


def test_sectors_are_written_as_they_are_read() -> None:
    """Degrees where these lose nothing, the direction left out; and the schema takes them."""
    line = "{contact: [4, 1], limit: 5, sectors: [[20, 160], [200, 340]]}"
    found = parse_scenario(f"{HEAD}robots: [{line}]\nnewcomer: {{limit: 5}}")
    text = scenario_text(found)
    assert "limit: 5, sectors: [[20, 160], [200, 340]]}" in text
    assert parse_scenario(text).swarm == found.swarm
    turned = parse_scenario(f"{HEAD}robots: [{line.replace('200, 340', '-160, -20')}]\n").swarm
    for one, other in zip(found.swarm.robots[0].sectors, turned.robots[0].sectors, strict=True):
        assert one == pytest.approx(other)
    robot = {"contact": [4, 1], "limit": 5, "sectors": [[20, 160], [200, 340]]}
    outline = {"vertices": [[0, 0], [4, 0], [4, 2], [0, 2]]}
    jsonschema.validate({"outline": outline, "robots": [robot]}, scenario_schema())
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate(
            {"outline": outline, "robots": [robot | {"sectors": [[20]]}]}, scenario_schema()
        )


def test_what_goes_only_inside_or_only_on_the_boundary_is_told_with_its_place() -> None:
    """Zones, no-go stretches and spacing: all faults, each with line and column."""
    zone, asked = "zones: [{area: [[1, 1]]}]", "no_go: [{edge: s}]\nspacing: 1"
    ashore = f"robots: []\nnewcomer: {{limit: 5}}\n{zone}"
    for said, faults in (
        (ashore, ["zones.0.area: is for a mounted newcomer"]),
        (
            f"{MOUNTED}{asked}",
            ["no_go: is for a newcomer on the boundary", "spacing: a mounted newcomer keeps no"],
        ),
    ):
        with pytest.raises(ScenarioInvalid) as caught:
            parse_scenario(f"{HEAD}{said}", "a.yaml")
        assert len(caught.value.faults) == len(faults)
        for told, fault in zip(caught.value.faults, faults, strict=True):
            assert re.match(rf"a\.yaml:\d+:\d+: {re.escape(fault)}", told)
