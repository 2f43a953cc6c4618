"""The criterion of a scenario file: units, the load of the environment, and faults."""

import jsonschema
import pytest

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.quality import Criterion, Ellipsoid, Polytope
from swarmgrasp.scenario import parse_scenario, scenario_schema

HEAD = (
    "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}\n"
    "robots: [{at: 1, direction: 0, limit: 2, tolerance: {direction: 0.1}}]\n"
)
STEADY = "vessel: ferry, frontal_area: 1, lateral_area: 2, speed: 9, from: 1"


def criterion(text: str, units: str = "") -> Criterion:
    """Return the criterion a file asks for."""
    return parse_scenario(f"{units}{HEAD}criterion: {text}\n", "a.yaml").criterion


def test_a_file_that_does_not_say_asks_for_the_nominal_quality() -> None:
    """And so does an empty criterion."""
    assert parse_scenario(HEAD).criterion.is_nominal
    assert criterion("{}").is_nominal


def test_units_of_wrenches() -> None:
    """Forces in tonnes-force and torques in foot tonnes-force become newtons and newton metres."""
    units = "units: {length: ft, force: tonne-force}\n"
    wrench = (9806.65, -2 * 9806.65, 3 * 9806.65 * 0.3048)
    found = criterion("{losing: 1, worst_case: true, load: [1, -2, 3]}", units)
    assert (found.losing, found.worst_case, found.task) == (1, True, None)
    assert found.load == pytest.approx(wrench)
    task = criterion("{task: {polytope: [[1, -2, 3], [0, 0, 1]]}}", units).task
    assert isinstance(task, Polytope)
    assert task.generators[0] == pytest.approx(wrench)
    task = criterion("{task: {ellipsoid: [[1, -2, 3]]}}", units).task
    assert isinstance(task, Ellipsoid)
    assert task.generators[0] == pytest.approx(wrench)


def test_the_load_may_be_that_of_the_environment() -> None:
    """The steady wind and the current, about the outline's origin, with the dynamic factor."""
    current = "current: {frontal_area: 1, lateral_area: 3, speed: 2, from: -1}"
    scenario = parse_scenario(
        f"{HEAD}criterion: {{load: environment}}\n"
        f"environment: {{wind: {{{STEADY}}}, {current}, dynamic_factor: 1.25}}\n"
    )
    assert scenario.environment is not None
    expected = scenario.environment.load(scenario.swarm.outline)
    assert scenario.criterion.load == tuple(expected.tolist())
    assert scenario.criterion.has_load


BUSES = (
    "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}\n"
    "robots:\n"
    "  - {name: Ajax, at: 1, direction: 0, limit: 2, group: bus A}\n"
    "  - {at: 2, direction: 0, limit: 2, group: bus B}\n"
)


def test_failures_name_robots_and_groups() -> None:
    """One by its name, several that fail together by a list; nameless ones as in a swarm."""
    found = parse_scenario(f"{BUSES}criterion: {{failures: [bus A, [Ajax, R1], [bus B]]}}\n")
    assert found.criterion.failures == (("bus A",), ("Ajax", "R1"), ("bus B",))


def test_a_failure_of_nobody_is_told() -> None:
    """Each name with its place, and the nearest that there is."""
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(f"{BUSES}criterion: {{failures: [bus C, [Ajax, Ayax], []]}}\n", "a.yaml")
    assert list(caught.value.faults) == [
        "a.yaml:5:45: criterion.failures.2: should hold 1 or more values, not 0 (got [])"
    ]
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(f"{BUSES}criterion: {{failures: [busA, [Ajax, Ayax]]}}\n", "a.yaml")
    said = "there is no robot or group of that name; did you mean"
    assert list(caught.value.faults) == [
        f"a.yaml:5:24: criterion.failures.0: {said} 'bus A'? (got 'busA')",
        f"a.yaml:5:37: criterion.failures.1.1: {said} 'Ajax'? (got 'Ayax')",
    ]


FAULTS = {
    "{losing: 1.5}": "3:21: .losing: should be a whole number (got 1.5)",
    "{losing: -1}": "3:21: .losing: should be at least 0 (got -1)",
    "{worst_case: yes}": "3:25: .worst_case: should be true or false (got 'yes')",
    "{failures: R1}": "3:23: .failures: should be a list (got 'R1')",
    "{load: wind}": "3:19: .load: should be [fx, fy, tz] or 'environment' (got 'wind')",
    "{load: 5}": "3:19: .load: should be 'environment', or a list (got 5)",
    "{load: [1, 2]}": "3:19: .load: should hold 3 or more values, not 2 (got [1, 2])",
    "{load: [1, 2, x]}": "3:26: .load.2: should be a number (got 'x')",
    "{load: environment}": (
        "3:19: .load: needs an environment, its wind with speed and from (got 'environment')"
    ),
    "{load: environment}\nenvironment: {wind: {vessel: ferry, frontal_area: 1, lateral_area: 2}}": (
        "3:19: .load: needs a steady wind: give environment.wind its speed and from "
        "(got 'environment')"
    ),
    "{task: {}}": "3:19: .task: should say its wrenches, by polytope or by ellipsoid",
    "{task: {polytope: [[1, 0, 0]], ellipsoid: [[1, 0, 0]]}}": (
        "3:19: .task: polytope and ellipsoid each say the wrenches; keep one"
    ),
    "{task: {polytope: []}}": (
        "3:30: .task.polytope: should hold 1 or more values, not 0 (got [])"
    ),
    "{task: {polytope: [[1, 0]]}}": (
        "3:31: .task.polytope.0: should hold 3 or more values, not 2 (got [1, 0])"
    ),
    "{task: {ellipsoid: [[0, 0, 0]]}}": (
        "3:31: .task.ellipsoid: should hold a wrench that is not zero (got [[...]])"
    ),
    "{task: {ellipsoid: [[0, 0, 1e-200]]}}": (
        "3:12: : the axes should be finite numbers, the largest of them 1e-100 <= size <= 1e+100; "
        "they are [[0.0, 0.0, 1e-200]]"
    ),
    "{lose: 1}": "3:13: .lose: unknown key; did you mean 'losing'?",
    "nominal": "3:12: : should be a mapping of keys to values (got 'nominal')",
}


@pytest.mark.parametrize("text", FAULTS)
def test_a_fault_is_told_with_its_place(text: str) -> None:
    """One fault, one sentence, with line, column and key path."""
    place, key, said = FAULTS[text].split(": ", 2)
    with pytest.raises(ScenarioInvalid) as caught:
        criterion(text)
    assert list(caught.value.faults) == [f"a.yaml:{place}: criterion{key}: {said}"]


def test_a_worst_case_of_nothing_is_a_slip() -> None:
    """Where no robot has a tolerance, there is nothing to be worse."""
    with pytest.raises(ScenarioInvalid, match="worst_case: asks for nothing, as no robot has a"):
        parse_scenario(
            HEAD.replace("tolerance: {direction: 0.1}", "") + "criterion: {worst_case: true}"
        )
    for tolerance in ("newcomer: {limit: 1, tolerance: {contact: 1}}", "tolerance: {contact: 1}"):
        text = f"robots: []\n{tolerance}\ncriterion: {{worst_case: true}}\n"
        assert parse_scenario(HEAD.partition("robots")[0] + text).criterion.worst_case


@pytest.mark.parametrize(
    ("asked", "is_valid"),
    [
        ({"load": "environment", "losing": 2}, True),
        ({"load": [1, 2, 3], "task": {"ellipsoid": [[1, 0, 0]]}}, True),
        ({"task": {}}, False),
        ({"task": {"polytope": [[1, 0, 0]], "ellipsoid": [[1, 0, 0]]}}, False),
        ({"task": {"polytope": [[1, 0]]}}, False),
        ({"load": "wind"}, False),
        ({"losing": 0.5}, False),
        ({"failures": ["bus A", ["Ajax", "Castor"]]}, True),
        ({"failures": [[]]}, False),
    ],
)
def test_editors_know_criteria(asked: dict[str, object], is_valid: bool) -> None:
    """The schema accepts what the loader accepts."""
    schema = scenario_schema()
    document = {**schema["examples"][0], "criterion": asked}
    assert jsonschema.Draft202012Validator(schema).is_valid(document) is is_valid
