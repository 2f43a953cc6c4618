"""Scenarios written from objects: read back equal, and fit for editing."""

import math
from dataclasses import replace

import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from strategies import problems
from swarmgrasp import (
    BLENDERMANN,
    Criterion,
    Ellipsoid,
    Environment,
    Newcomer,
    Outline,
    Polytope,
    Problem,
    Robot,
    Stretch,
    Swarm,
    Tolerance,
    Waves,
    Wind,
    Zone,
)
from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.scenario import (
    example_names,
    load_example,
    load_scenario,
    parse_scenario,
    scenario_text,
    write,
)

BARGE = Outline([(0, 0), (4, 0), (4, 2), (0, 2)])
SWARM = Swarm(BARGE, [Robot((4, 0.5), 3.0, 1.5, "Ajax")])
STRONG = Problem(Swarm(BARGE, [Robot((4, 0.5), 3.0, 1e20)]), Newcomer())


@pytest.mark.parametrize("name", example_names())
def test_every_built_in_scenario_comes_back(name, tmp_path):
    """From its file to objects, to a file, to objects, to the same file."""
    first = load_example(name)
    write(first, tmp_path / "again.yaml")
    again = load_scenario(tmp_path / "again.yaml")
    assert again == first
    assert scenario_text(again) == (tmp_path / "again.yaml").read_text()


@given(problems)
def test_every_problem_comes_back(problem):
    """Whatever its metric, zones and limits; but for robots stronger than a file may say."""
    assume(problem.swarm.limits.max(initial=0.0) <= 1e12)
    text, again = told_and_read(problem)
    assert again.problem() == problem
    assert scenario_text(again) == text


def told_and_read(problem):
    """Return the text of a problem, and what is read of it."""
    text = scenario_text(problem, name="asked")
    return text, parse_scenario(text)


KINDS = (
    {},
    {"steers": 0.5},
    {"steers": math.pi},
    {"reverse_limit": 2.5},
    {"steers": 1.0, "reverse_limit": 0.1},
    {"least": 1.5},
    {"steers": 0.3, "least": 0.1},
    {"friction": 0.7},
    {"friction": 0.7, "least": 0.5},
    {"envelope": ((0.0, 0.5), (2.5, 0.0), (-1.0, 1e3))},
)


@given(problems, st.lists(st.sampled_from(KINDS), min_size=12), st.sampled_from(("", "bus A")))
def test_every_kind_of_robot_comes_back(problem, kinds, group):
    """In either unit of force and of angle, with the groups that fail together."""
    robots = [
        replace(robot, **{"limit": 1.0 if "envelope" in kind else 2.5, **kind})
        for robot, kind in zip(problem.swarm.robots, kinds * 2, strict=False)
    ]
    robots[:1] = [replace(robot, group=group) for robot in robots[:1]]
    swarm = Swarm(problem.swarm.outline, robots)
    text, again = told_and_read(replace(problem, swarm=swarm))
    assert again.problem() == replace(problem, swarm=swarm)
    assert scenario_text(again) == text


@pytest.mark.parametrize(
    ("newcomer", "said"),
    [
        (
            Newcomer(2e3, "push", 0.5, steers=True),
            "attachment: push, half_angle: 0.5, steers: true",
        ),
        (Newcomer(2e3, reverse_limit=2e3), "{limit: 2, two_way: true, attachment: free}"),
        (Newcomer(2e3, reverse_limit=1e3), "{limit: {ahead: 2, astern: 1}, attachment: free}"),
        (Newcomer(2e3, "push", friction=0.5), "{limit: 2, friction: 0.5, attachment: push}"),
        (Newcomer(2e3, mounted=True), "{limit: 2, attachment: free, mounted: true}"),
    ],
)
def test_every_kind_of_newcomer_comes_back(newcomer, said):
    """As people would say it."""
    problem = Problem(SWARM, newcomer)
    text, again = told_and_read(problem)
    assert again.problem() == problem
    assert said in text


def test_numbers_are_in_the_units_of_people_where_that_loses_nothing():
    """Degrees and kilonewtons; or else radians and newtons, to the last bit."""
    robots = [Robot((4, 0.5), 3.141592653589793, 60e3), Robot((1, 0), 0.5235987755982988, 45.5e3)]
    told = scenario_text(Problem(Swarm(BARGE, robots), Newcomer(60e3, "push", 0.5)))
    assert "units: {length: m, force: kN, angle: rad, speed: m/s}" in told
    told = scenario_text(Problem(Swarm(BARGE, robots), Newcomer(60e3, "push")))
    assert "units: {length: m, force: kN, angle: deg, speed: m/s}" in told
    assert "contact: [4, 0.5], direction: 180, limit: 60" in told
    assert "contact: [1, 0], direction: 30, limit: 45.5" in told
    odd = Swarm(BARGE, [*robots, Robot((0, 1), 0.0, 1000.1 / 3.0)])
    assert "force: N, angle: deg" in scenario_text(Problem(odd, Newcomer()))


def test_everything_that_can_be_said_is():
    """Tolerances, criteria, a precision and an origin of one's own, names that need quotes."""
    outline = Outline(BARGE.vertices, (1.0, 1.0), ["no", "a, b", "Zoë's", ""], 0.01)
    loose = Tolerance((-0.1, 0.2), 0.5, 1.0, True)
    robots = [
        Robot((4, 0.5), 3.0, 1.5, "x: {y}", tolerance=loose),
        Robot((2, 1), 0.25, 7.0, "~", mounted=True),
    ]
    swarm = Swarm(outline, robots, 2.5, (0.5, 3.0))
    zones = (Zone(Stretch(0.0, 3.0, "#1"), "pull", 0.0, (-1.0, 0.5)), Zone(Stretch(6.0, 6.0)))
    tow = [(1.0, 2.0, 3.0), (-1.0, 0.0, 0.0)]
    for task in (Polytope(tow), Ellipsoid(tow)):
        named = (("~",), ("x: {y}", "~"))
        criterion = Criterion(2, True, (0.0, -0.3, 1e-7), task, named)
        problem = Problem(swarm, Newcomer(2.0), zones, (Stretch(3.0, 3.5, "!"),), 0.1, criterion)
        again = parse_scenario(scenario_text(problem))
        assert again.problem() == problem


@pytest.mark.parametrize(
    "waves", [Waves(), Waves(bearing=0.3), Waves(2.0, 7.5, -1.0, math.radians(30.0), 0.9, 1000.0)]
)
def test_waves_come_back(waves):
    """The sea of the wind, and a given one with all that can be said of it."""
    around = Environment(Wind(1.0, 2.0, BLENDERMANN["ferry"]), waves=waves)
    assert (
        parse_scenario(scenario_text(Problem(SWARM, Newcomer()), environment=around)).environment
        == around
    )


@pytest.mark.parametrize(
    ("problem", "said"),
    [
        (
            Problem(Swarm(BARGE, [Robot((4, 0.5), 3.0, 1e20)]), Newcomer()),
            r"as written:9:[0-9]+: robots.0.limit: should be at most 1e\+12",
        ),
        (
            Problem(SWARM, Newcomer(), (Zone(Stretch(3.9999999, 5.0)),)),
            "problem.zones.0.stretch.start: 3.9999999 would be read back as 4.0",
        ),
        (
            Problem(SWARM, Newcomer(tolerance=Tolerance())),
            "problem.newcomer.tolerance: .* would be read back as None",
        ),
    ],
)
def test_what_a_file_cannot_say_is_refused(problem, said):
    """Rather than written as something else."""
    with pytest.raises(ScenarioInvalid, match=said):
        scenario_text(problem)
