"""Plain forms: what is written is read back equal, and what does not fit is told at once."""

import copy
import json
import math

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from strategies import problems
from swarmgrasp import (
    BLENDERMANN,
    Criterion,
    Current,
    CurrentCoefficients,
    Ellipsoid,
    Environment,
    Outline,
    Polytope,
    Problem,
    Robot,
    Summary,
    Swarm,
    Tolerance,
    Waves,
    Wind,
    WindCoefficients,
)
from swarmgrasp.errors import DataInvalid
from swarmgrasp.outline import Contact
from swarmgrasp.plain import read
from swarmgrasp.scenario import example_names, load_example

numbers = st.floats(-1e6, 1e6)
areas = st.floats(1e-3, 1e6)
shares = st.floats(1e-3, 1.0)
names = st.text("ab é", max_size=5).filter(lambda name: not name.isspace())
wrenches = st.lists(st.tuples(numbers, numbers, st.floats(1.0, 1e6)), min_size=1, max_size=3)
tolerances = st.builds(
    Tolerance, st.tuples(st.floats(-9, 0), st.floats(0, 9)), st.floats(0, 3), st.none() | shares,
    st.booleans(),
)  # fmt: skip
winds = st.builds(
    Wind, areas, areas,
    st.builds(WindCoefficients, shares, shares, shares, shares)
    | st.sampled_from(list(BLENDERMANN.values())),
    numbers, areas.map(lambda v: v / 1e3), numbers,
)  # fmt: skip
currents = st.builds(
    Current, areas, areas, shares, st.none() | numbers,
    st.builds(CurrentCoefficients, shares, shares),
)  # fmt: skip
seas = st.builds(Waves, shares, shares, st.none() | numbers, st.none() | shares, st.none() | shares)
parts = (
    tolerances
    | st.builds(Environment, winds, st.none() | currents, st.floats(1.0, 2.0), st.none() | seas)
    | st.builds(
        Criterion, st.integers(0, 9), st.booleans(), st.tuples(numbers, numbers, numbers),
        st.none() | st.builds(Polytope, wrenches) | st.builds(Ellipsoid, wrenches),
    )
    | st.builds(Contact, st.tuples(numbers, numbers), st.integers(0, 9), areas, numbers,
                st.booleans())
    | st.builds(Robot, st.tuples(numbers, numbers), numbers, areas.map(lambda v: v + 1.0),
                names, st.just(False), st.none() | tolerances)
)  # fmt: skip


def there_and_back(thing):
    """Return what is read of what is written as JSON."""
    return type(thing).from_data(json.loads(json.dumps(thing.to_data(), allow_nan=False)))


def assert_same(one, other):
    """Check that two objects are equal, and write the same."""
    assert one == other
    assert one.to_data() == other.to_data()


@pytest.mark.parametrize("name", example_names())
def test_every_built_in_question_comes_back(name):
    """Swarm, newcomer, zones and criterion; and the environment, where there is one."""
    scenario = load_example(name)
    assert_same(there_and_back(scenario.problem()), scenario.problem())
    if scenario.environment:
        assert_same(there_and_back(scenario.environment), scenario.environment)


@given(problems)
def test_every_question_comes_back(problem):
    """To the last bit."""
    assert_same(there_and_back(problem), problem)


@pytest.mark.filterwarnings("ignore::swarmgrasp.errors.DirectionWarning")
@given(parts)
def test_every_part_comes_back(part):
    """Tolerances, environments, criteria with tasks, contacts and robots."""
    assert_same(there_and_back(part), part)


def test_all_faults_are_told_at_once_with_their_keys():
    """Unknown and missing keys, wrong kinds, and what a class refuses of its own."""
    data = load_example("supply-vessel").problem().to_data()
    swarm, robots = data["swarm"], data["swarm"]["robots"]
    swarm["outline"]["vertices"][1] = [0.0, "far"]
    swarm["force_weights"] = [1.0]
    robots[0]["limit"], robots[1]["limit"], robots[2]["limit"] = "3", -3.0, 10**400
    robots[3] |= {"mounted": 1, "contact": None, "colour": "red"}
    data["newcomer"]["attachment"] = "glue"
    data["criterion"] |= {"losing": True, "task": {"axes": [[1.0, 2.0]]}}
    del data["spacing"]
    with pytest.raises(DataInvalid) as caught:
        Problem.from_data(data)
    told = dict(fault.split(": ", 1) for fault in caught.value.faults)
    assert told["swarm.robots.2.limit"].startswith("should be a number; it is 10000000")
    assert told["swarm.robots.1"].endswith("the limit is -3.0; it should be 1e-100 <= limit <= "
                                           "1e+100 [N]")  # fmt: skip
    assert told["criterion.task"].startswith("the axes have shape (1, 2)")
    known = "unknown key; known: contact, direction, limit"
    assert told.pop("swarm.robots.3.colour").startswith(known)
    del told["swarm.robots.2.limit"], told["swarm.robots.1"], told["criterion.task"]
    assert told == {
        "spacing": "is missing",
        "swarm.outline.vertices": "should be numbers only; it is 'far'",
        "swarm.force_weights": "should be a list of 2; it is [1.0]",
        "swarm.robots.0.limit": "should be a number; it is '3'",
        "swarm.robots.3.contact": "should be a list; it is None",
        "swarm.robots.3.mounted": "should be true or false; it is 1",
        "newcomer.attachment": "should be 'push' or 'pull' or 'free'; it is 'glue'",
        "criterion.losing": "should be a whole number; it is True",
    }


@pytest.mark.parametrize("data", [None, 3, [], "outline", {}, math.nan])
@pytest.mark.parametrize("cls", [Outline, Swarm, Problem, Environment, Polytope])
def test_what_is_no_mapping_of_the_right_keys_is_refused(cls, data):
    """By name, and not by a traceback."""
    with pytest.raises(DataInvalid, match=r"should be a mapping of|is missing"):
        cls.from_data(data)


def test_any_single_key_left_out_or_added_is_refused():
    """In every mapping of a question, however deep."""
    whole = load_example("deck-barge").problem().to_data()
    rng = np.random.default_rng(0)
    for _ in range(200):
        data = copy.deepcopy(whole)
        spot = data
        while rng.random() < 0.8:
            inner = [v for v in (spot.values() if isinstance(spot, dict) else spot)
                     if isinstance(v, dict) or (isinstance(v, list) and v and
                                                isinstance(v[0], dict))]  # fmt: skip
            if not inner:
                break
            spot = inner[rng.integers(len(inner))]
        if isinstance(spot, list):
            spot = spot[0]
        if rng.random() < 0.5:
            del spot[str(rng.choice(list(spot)))]
        else:
            spot["more"] = 1
        with pytest.raises(DataInvalid):
            Problem.from_data(data)


def test_bounds_of_summaries_are_told():
    """Of a quality and of a placement: by the names of their attributes, as JSON."""
    scenario = load_example("deck-barge")
    summary = Summary.of(scenario.swarm)
    graded = summary.quality()
    placed = summary.place(scenario.swarm.outline, scenario.newcomer)
    for bounds in (graded, placed):
        told = json.loads(json.dumps(bounds.to_data(), allow_nan=False))
        assert (told["lower"], told["upper"]) == (bounds.lower, bounds.upper)
        assert told["direction"] == bounds.direction.tolist()
    assert Robot.from_data(placed.to_data()["robot"]) == placed.robot


def test_rows_of_numbers_are_read_whatever_numpy_calls_them():
    """From Python 3.12 on its `NDArray` is a name of its own; here one is made."""
    typing_extensions = pytest.importorskip("typing_extensions")
    kept = typing_extensions.TypeVar("kept")
    named = typing_extensions.TypeAliasType("named", NDArray[kept], type_params=(kept,))
    faults = []
    assert read([[1.0, 2.0]], named[np.float64], (), faults) == [[1.0, 2.0]]
    read([[1.0, "two"]], named[np.float64], (), faults)
    assert faults == ["should be numbers only; it is 'two'"]
