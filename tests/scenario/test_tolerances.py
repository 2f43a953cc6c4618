"""Tolerances in a scenario file: what they mean, their defaults and their faults."""

import math

import jsonschema
import pytest

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.scenario import Scenario, load_example, parse_scenario, scenario_schema
from swarmgrasp.swarm import Tolerance

OUTLINE = "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}\n"
ROBOT = "at: 1, direction: 0, limit: 2"
THRUSTER = "contact: [1, 1], direction: 0, limit: 2, mounted: true"


def told(text: str) -> list[str]:
    """Return the faults of a text without the file's name."""
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(text, "a.yaml")
    return [fault.removeprefix("a.yaml:") for fault in caught.value.faults]


def tolerances(scenario: Scenario) -> list[Tolerance | None]:
    """Return the tolerance of every robot."""
    return [robot.tolerance for robot in scenario.swarm.robots]


def test_units_of_a_tolerance() -> None:
    """Feet, degrees and tonnes-force in the file; metres, radians and newtons behind it."""
    scenario = parse_scenario(
        f"units: {{length: ft, force: tonne-force, angle: deg}}\n{OUTLINE}"
        f"robots: [{{{ROBOT}, tolerance: {{contact: [-1, 2], direction: 180, least_limit: 1}}}}]\n"
        "newcomer: {limit: 3, tolerance: {contact: 2, direction: [0, 90], may_be_absent: true}}\n"
    )
    (robot,) = tolerances(scenario)
    assert robot == Tolerance((-0.3048, 0.6096), math.pi, 9806.65)
    assert scenario.newcomer is not None
    assert scenario.newcomer.tolerance == Tolerance(0.6096, (0.0, math.pi / 2), None, True)


def test_robots_without_their_own_have_the_tolerance_of_the_file() -> None:
    """A robot's own replaces it whole, and `{}` means exactly as said."""
    scenario = parse_scenario(
        f"{OUTLINE}tolerance: {{contact: 1, direction: 0.5}}\n"
        f"robots: [{{{ROBOT}}}, {{{ROBOT}, tolerance: {{contact: 2}}}},"
        f" {{{ROBOT}, tolerance: {{}}}}]\nnewcomer: {{limit: 1}}\n"
    )
    assert tolerances(scenario) == [Tolerance(1.0, 0.5), Tolerance(2.0), None]
    assert scenario.newcomer is not None
    assert scenario.newcomer.tolerance == Tolerance(1.0, 0.5)


def test_the_tolerance_of_the_file_is_cut_to_what_fits() -> None:
    """A mounted robot stays where it is, as does a mounted newcomer, and a newcomer comes."""
    for more, contact in (("", 1.0), (", mounted: true", 0.0)):
        scenario = parse_scenario(
            f"{OUTLINE}tolerance: {{contact: 1, direction: 0.5, may_be_absent: true}}\n"
            f"robots: [{{{THRUSTER}}}]\nnewcomer: {{limit: 1{more}}}\n"
        )
        assert tolerances(scenario) == [Tolerance(0.0, 0.5, None, True)]
        assert scenario.newcomer is not None
        assert scenario.newcomer.tolerance == Tolerance(contact, 0.5)


def test_the_tugs_of_the_deck_barge_are_not_quite_where_they_should_be() -> None:
    """Those on pads slip along the hull, those on lines only swing; no quality asks for it yet."""
    scenario = load_example("deck-barge")
    reaches = [found.offsets[1] for found in tolerances(scenario) if found]
    assert reaches == pytest.approx([1.524, 1.524, 1.524, 0.0, 0.0])
    assert scenario.criterion.is_nominal


# where the fault is from the start of the tolerance, in columns; the key below it; the fault
FAULTS = {
    "{contact: x}": "10: .contact: should be two offsets, or a number (got 'x')",
    "{contact: {a: 1}}": "10: .contact: should be two offsets, or a number (got {a: 1})",
    "{contact: -1}": "10: .contact: should be at least 0 (got -1)",
    "{contact: [1, 3]}": "11: .contact.0: should be at most 0 (got 1)",
    "{contact: [-1, -3]}": "15: .contact.1: should be at least 0 (got -3)",
    "{contact: [-1]}": "10: .contact: should hold 2 or more values, not 1 (got [-1])",
    "{contact: 7}": "10: .contact: spans 14 m, the whole boundary and more (got 7)",
    "{direction: 4}": "12: .direction: should lie in [0, 3.14159265] rad (got 4)",
    "{direction: [-4, 1]}": "13: .direction.0: should lie in [-3.14159265, 0] rad (got -4)",
    "{direction: .nan}": "12: .direction: should be a finite number (got .nan)",
    "{least_limit: 3}": "14: .least_limit: should be at most 2 N, the limit (got 3)",
    "{least_limit: 0}": "14: .least_limit: should be greater than 0 (got 0)",
    "{may_be_absent: 1}": "16: .may_be_absent: should be true or false (got 1)",
    "{may_be_late: true}": "1: .may_be_late: unknown key; did you mean 'may_be_absent'?",
    "5": "0: : should be a mapping of keys to values (got 5)",
}


@pytest.mark.parametrize("tolerance", FAULTS)
def test_a_faulty_tolerance_is_told_with_its_place(tolerance: str) -> None:
    """Of a robot, of the newcomer and of all: one fault, one sentence."""
    offset, key, said = FAULTS[tolerance].split(": ", 2)
    for line, holder, whose in (
        (f"robots: [{{{ROBOT}, tolerance: {tolerance}}}]", "robots.0.tolerance", ""),
        (f"newcomer: {{limit: 2, tolerance: {tolerance}}}", "newcomer.tolerance", ""),
        (f"tolerance: {tolerance}", "tolerance", " of robots.0"),
    ):
        robots = "" if "robots" in line else f"robots: [{{{ROBOT}}}]\n"
        column = 1 + line.index(f" {tolerance}") + 1 + int(offset)
        expected = said.replace("the limit", f"the limit{whose}")
        assert told(f"{OUTLINE}{line}\n{robots}") == [f"2:{column}: {holder}{key}: {expected}"]


def test_tolerances_that_do_not_go_with_the_rest_are_told_together() -> None:
    """Neither a bad outline nor a bad limit hides them."""
    faults = told(
        "outline: {vertices: [[0, 0], [1, x], [1, 1]]}\n"
        f"robots:\n  - {{{THRUSTER}, tolerance: {{contact: 1}}}}\n"
        "  - {at: 1, direction: 0, limit: -1, tolerance: {direction: 9, least_limit: 5}}\n"
        "newcomer: {limit: 1, tolerance: {may_be_absent: true}}\n"
        "tolerance: {contact: -2}\ncriterion: {worst_case: true}\n"
    )
    assert faults[1:] == [
        "3:83: robots.0.tolerance.contact: a mounted robot stays where it is; leave the contact "
        "out (got 1)",
        "4:34: robots.1.limit: should be greater than 0 (got -1)",
        "4:61: robots.1.tolerance.direction: should lie in [0, 3.14159265] rad (got 9)",
        "5:49: newcomer.tolerance.may_be_absent: a newcomer that may be absent is worth nothing "
        "in the worst case (got true)",
        "6:22: tolerance.contact: should be at least 0 (got -2)",
    ]


@pytest.mark.parametrize(
    ("robot", "is_valid"),
    [
        ({"at": 1, "tolerance": {"contact": [-1, 2], "direction": 5, "least_limit": 1}}, True),
        ({"contact": [1, 1], "mounted": True, "tolerance": {"direction": [-5, 5]}}, True),
        ({"at": 1, "tolerance": {}}, True),
        ({"contact": [1, 1], "mounted": True, "tolerance": {"contact": 1}}, False),
        ({"at": 1, "tolerance": {"contact": [1, 2]}}, False),
        ({"at": 1, "tolerance": {"direction": 270}}, False),
        ({"at": 1, "tolerance": None}, False),
    ],
)
def test_editors_know_tolerances(robot: dict[str, object], is_valid: bool) -> None:
    """The schema accepts what the loader accepts."""
    schema = scenario_schema()
    document = {**schema["examples"][0], "robots": [{**robot, "direction": 0, "limit": 60}]}
    assert jsonschema.Draft202012Validator(schema).is_valid(document) is is_valid
