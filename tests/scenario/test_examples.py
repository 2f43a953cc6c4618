"""The built-in scenarios load, fit the schema, and have the qualities they promise."""

import math
from dataclasses import replace

import jsonschema
import numpy as np
import pytest
from ruamel.yaml import YAML

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.placement import Problem, place_sequence
from swarmgrasp.quality import Criterion
from swarmgrasp.quality import quality as exact_quality
from swarmgrasp.scenario import example_names, example_text, load_example, scenario_schema
from swarmgrasp.swarm import Swarm


def quality(swarm: Swarm, load: tuple[float, ...] = (0.0, 0.0, 0.0)) -> float:
    """Return the quality [N] beside a load by all pairs of generators, the slow formula (T2)."""
    b = swarm.scaled_generators
    astern = swarm.reverse_limits > 0.0
    b = np.vstack([b, -b[astern] * (swarm.reverse_limits / swarm.limits)[astern, None]])
    j, k = np.triu_indices(len(b), 1)
    normals = np.cross(b[j], b[k])
    size = np.linalg.norm(normals, axis=1)
    keep = size > 1e-9 * np.linalg.norm(b[j], axis=1) * np.linalg.norm(b[k], axis=1)
    normals = normals[keep] / size[keep, None]
    normals = np.vstack([normals, -normals])
    heights = np.maximum(normals @ b.T, 0.0).sum(axis=1) + normals @ (swarm.scale * load)
    return float(heights.min())


@pytest.mark.parametrize("name", example_names())
def test_an_example_loads_and_fits_the_schema(name: str) -> None:
    """The schema that editors use accepts what the loader accepts."""
    scenario = load_example(name)
    assert scenario.newcomer is not None
    jsonschema.Draft202012Validator(scenario_schema()).validate(
        YAML(typ="safe", pure=True).load(example_text(name))
    )


@pytest.mark.parametrize(
    ("name", "robots", "expected"),
    [
        ("drillship-thrusters", 4, 0.8998300),
        ("supply-vessel", 6, 748_420.2756),
        ("rectangle-5", 5, 0.0),
        ("rectangle-15", 15, 2.2557583),
        ("hull-120", 8, 248_774.880),
        ("model-ship", 5, 0.0467866667),
        ("deck-barge", 5, 229_220.380),
        ("escort-ring", 8, 1_006_487.577),
    ],
)
def test_an_example_has_the_quality_it_promises(name: str, robots: int, expected: float) -> None:
    """The first two are closed forms of published vessels; the others guard the files."""
    swarm = load_example(name).swarm
    assert len(swarm) == robots
    assert quality(swarm) == pytest.approx(expected, rel=1e-7, abs=1e-12)


@pytest.mark.parametrize(
    ("name", "expected"),
    [("harbour-tugs", 355_690.0), ("drillship-azimuths", 6.756)],
)
def test_an_example_of_robots_that_steer_has_the_quality_it_promises(
    name: str, expected: float
) -> None:
    """Tugs that can do nothing as rays, and published thrusters by their exact support function."""
    swarm = load_example(name).swarm
    assert not swarm.is_ray.any()
    assert exact_quality(swarm).value == pytest.approx(expected, rel=1e-4)
    told = example_text(name)
    assert f"{exact_quality(swarm).value / (1e3 if expected > 1e3 else 1.0):.3f}" in told


def test_four_equal_tugs_that_steer_have_a_closed_form() -> None:
    """Those of the harbour, each of 300 kN: 700 / sqrt(3) kN; and none without steering."""
    swarm = load_example("harbour-tugs").swarm
    equal = [replace(robot, limit=300e3) for robot in swarm]
    assert exact_quality(Swarm(swarm.outline, equal)).value == pytest.approx(700e3 / math.sqrt(3.0))
    fixed = [replace(robot, steers=0.0) for robot in equal]
    assert exact_quality(Swarm(swarm.outline, fixed)).value == 0.0


def test_a_switchboard_takes_both_of_its_thrusters() -> None:
    """What is left of the azimuth drillship is the worst of the three pairs that may be left."""
    scenario = load_example("drillship-azimuths")
    swarm = scenario.swarm
    pairs = [("bow", "stern"), ("bow port", "stern starboard"), ("bow starboard", "stern port")]
    left = [exact_quality(swarm.without(pair)).value for pair in pairs]
    found = exact_quality(swarm, **scenario.criterion.keywords)
    assert found.value == pytest.approx(min(left), rel=1e-6)


def test_the_escort_ring_has_the_margins_it_promises() -> None:
    """A ninth tug that hardly matters to eight intact lines is much in a gale with one parted."""
    scenario = load_example("escort-ring")
    swarm, load = scenario.swarm, scenario.criterion.load
    margin = min(quality(swarm.without(name), load) for name in swarm.names)
    assert margin == pytest.approx(43_955.6, rel=1e-5)
    assert scenario.newcomer is not None
    problem = Problem(
        swarm, scenario.newcomer, scenario.zones, spacing=scenario.spacing,
        criterion=scenario.criterion,
    )  # fmt: skip
    (asked,) = place_sequence(problem, 1)
    assert asked.quality_before == pytest.approx(margin)
    ring = asked.swarm_after
    assert asked.quality == pytest.approx(
        min(quality(ring.without(name), load) for name in ring.names)
    )
    assert asked.quality == pytest.approx(334_390.0, rel=1e-4)
    (still,) = place_sequence(replace(problem, criterion=Criterion()), 1)
    assert still.quality == pytest.approx(1_007_750.6, rel=1e-5)
    assert asked.verify()


def test_an_unknown_example_is_told_with_the_nearest() -> None:
    """A slip of the pen finds its way."""
    with pytest.raises(ScenarioInvalid, match=r"did you mean 'deck-barge'\? Known: deck-barge, "):
        load_example("deck_barge")


def test_the_schema_is_one() -> None:
    """It is a valid draft 2020-12 schema, with units told and its own example valid."""
    schema = scenario_schema()
    jsonschema.Draft202012Validator.check_schema(schema)
    jsonschema.Draft202012Validator(schema).validate(schema["examples"][0])
    assert schema["additionalProperties"] is False
    assert "[units.force]" in schema["$defs"]["RobotSection"]["properties"]["limit"]["description"]


@pytest.mark.parametrize(
    "robot",
    [
        {"direction": 0, "limit": 1},
        {"at": 1, "contact": [0, 0], "direction": 0, "limit": 1},
        {"edge": 1, "direction": 0, "limit": 1},
        {"at": 1, "direction": "north", "limit": 1},
        {"at": 1, "direction": 0, "limit": 0},
        {"at": 1, "direction": 0, "limit": 1, "color": "red"},
    ],
)
def test_the_schema_refuses_what_the_loader_refuses(robot: dict[str, object]) -> None:
    """An editor underlines it before the program is run."""
    document = {**scenario_schema()["examples"][0], "robots": [robot]}
    assert not jsonschema.Draft202012Validator(scenario_schema()).is_valid(document)
