"""The largest wind held at every bearing, beside the linear programs that define it."""

import math
from dataclasses import replace

import numpy as np
import pytest

from reference import largest_wind
from swarmgrasp import (
    BLENDERMANN,
    Current,
    Environment,
    Outline,
    Robot,
    Swarm,
    Tolerance,
    Waves,
    Wind,
    WindCoefficients,
    WrenchSet,
    capability,
    capability_numbers,
)
from swarmgrasp.environment import STEPS
from swarmgrasp.errors import CriterionInvalid, EnvironmentInvalid, SwarmInvalid
from swarmgrasp.scenario import load_example

COMPASS = np.radians(np.arange(0.0, 360.0, 45.0))
BARGE = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
FLAT = WindCoefficients(transverse=0.9, bow=0.7, stern=0.7)


def by_programs(swarm, environment, bearings, losing):
    """Compute the same wind speeds from the generators alone."""
    currents = environment.current_load(swarm.outline, bearings) * swarm.scale
    winds = environment.wind_load(swarm.outline, bearings, 1.0) * swarm.scale
    rows, least = swarm.scaled_generators, -swarm.reverse_limits / swarm.limits
    return [
        math.sqrt(largest_wind(rows, current, wind, losing, least))
        for current, wind in zip(currents, winds, strict=True)
    ]


@pytest.mark.parametrize("name", ["supply-vessel", "deck-barge", "model-ship"])
def test_an_example_holds_what_linear_programs_say(name):
    """Intact and after losing any one, at bearings all round."""
    scenario = load_example(name)
    bearings = np.radians([10.0, 75.0, 130.0, 200.0, 290.0])
    found = capability(scenario.swarm, scenario.environment, bearings)
    for losing, speeds in ((0, found.intact), (1, found.after_loss)):
        expected = by_programs(scenario.swarm, scenario.environment, bearings, losing)
        np.testing.assert_allclose(speeds, expected, rtol=1e-6)


def test_random_crowds_hold_what_linear_programs_say():
    """Six to nine robots anywhere, a current from its own bearing, two of them lost."""
    rng = np.random.default_rng(3)
    for _ in range(6):
        count = rng.integers(6, 10)
        arcs = rng.uniform(0.0, BARGE.perimeter, count)
        contacts = [BARGE.at_arc_length(arc).point for arc in arcs]
        ways, limits = rng.uniform(-math.pi, math.pi, count), rng.uniform(20e3, 90e3, count)
        swarm = Swarm.from_arrays(BARGE, contacts, ways, limits)
        kind = BLENDERMANN[rng.choice(list(BLENDERMANN))]
        current = Current(40.0, 160.0, speed=0.3, bearing=rng.uniform(-3.0, 3.0))
        weather = Environment(Wind(150.0, 500.0, kind, rng.uniform(-5.0, 5.0)), current)
        for losing in (1, 2):
            found = capability(swarm, weather, COMPASS[::2], losing=losing)
            for k, speeds in ((0, found.intact), (losing, found.after_loss)):
                expected = by_programs(swarm, weather, COMPASS[::2], k)
                np.testing.assert_allclose(speeds, expected, rtol=1e-6, atol=1e-6)


def test_the_largest_wind_is_just_held():
    """A little less is in the wrench set, a little more is not, of all robots and of those left."""
    scenario = load_example("supply-vessel")
    swarm, weather = scenario.swarm, scenario.environment
    found = capability(swarm, weather, COMPASS)
    for i, bearing in enumerate(COMPASS):
        left = Swarm(
            swarm.outline,
            [robot for robot in swarm if robot.name not in found.worst_losses[i]],
        )
        for robots, speed in ((swarm, found.intact[i]), (left, found.after_loss[i])):
            wrenches = WrenchSet(robots)
            for share, held in ((0.999, True), (1.001, False)):
                load = weather.wind_load(swarm.outline, bearing, share * speed)
                load += weather.current_load(swarm.outline, bearing)
                assert wrenches.contains(-load) is held


def test_a_thruster_that_pushes_either_way_is_lost_once():
    """The same as without it."""
    scenario = load_example("supply-vessel")
    swarm, weather = scenario.swarm, scenario.environment
    found = capability(swarm, weather, [math.pi / 3])
    assert found.worst_losses == (("port propeller",),)
    assert capability(swarm, weather, [0.0], losing=2).lost_words(0, most=1).endswith(" and 1 more")
    left = capability(swarm.without("port propeller"), weather, [math.pi / 3])
    assert found.after_loss[0] == pytest.approx(left.intact[0], rel=1e-9)


def test_a_current_that_is_not_held_leaves_no_wind():
    """Even where a wind against it would help: before it blows, the object drifts."""
    crew = [Robot((-40, 0), 0.0, 50e3), Robot((0, -10), math.pi / 2, 50e3)]
    crew += [Robot((0, 10), -math.pi / 2, 50e3)]
    swarm = Swarm(BARGE, crew)
    astern = Current(60.0, 240.0, speed=2.0, bearing=math.pi)
    weather = Environment(Wind(150.0, 500.0, FLAT), astern)
    found = capability(swarm, weather, [0.0, math.pi])
    assert found.intact.tolist() == [0.0, 0.0]
    assert found.holds_calm.tolist() == [False, False]
    ahead = replace(weather, current=replace(astern, bearing=0.0))
    held = capability(swarm, ahead, [0.0, math.pi / 4])
    assert held.intact[0] > 0.0
    assert held.holds_calm.tolist() == [True, True]  # though no wind from the bow quarter
    assert held.intact[1] == 0.0
    assert not held.holds_calm_after_loss.any()


def test_a_hull_alike_on_both_sides_holds_alike():
    """Mirrored bearings give the same winds; the default is every 5 degrees."""
    scenario = load_example("supply-vessel")
    found = capability(scenario.swarm, scenario.environment)
    assert len(found.bearings) == 72
    mirrored = np.roll(found.intact[::-1], 1)
    np.testing.assert_allclose(found.intact, mirrored, rtol=1e-9)
    assert (found.after_loss <= found.intact).all()
    assert found.intact[found.worst] == pytest.approx(found.intact.min(), rel=1e-9)
    assert not found.intact.flags.writeable


def test_tolerances_count_in_the_worst_case_only():
    """Robots that may be weaker than they are said to be hold less."""
    ways = {(-40, 0): 0.0, (40, 0): math.pi, (0, -10): math.pi / 2, (0, 10): -math.pi / 2}
    weak = Tolerance(least_limit=30e3)
    swarm = Swarm(BARGE, [Robot(c, way, 60e3, tolerance=weak) for c, way in ways.items()])
    weather = Environment(Wind(150.0, 500.0, FLAT))
    said = capability(swarm, weather, [0.0]).intact[0]
    certain = capability(swarm, weather, [0.0], worst_case=True).intact[0]
    assert certain == pytest.approx(said / math.sqrt(2.0), rel=1e-6)


def test_nobody_holds_nothing():
    """No robots: no wind, but still water is held."""
    found = capability(Swarm(BARGE, []), Environment(Wind(150.0, 500.0, FLAT)), [0.0, 1.0])
    assert found.intact.tolist() == [0.0, 0.0]
    assert found.holds_calm.tolist() == [True, True]
    assert found.worst_losses == ((), ())


def test_wrong_questions_are_refused():
    """Each by its own error."""
    swarm, weather = Swarm(BARGE, []), Environment(Wind(150.0, 500.0, FLAT))
    with pytest.raises(EnvironmentInvalid, match="Wind is no Environment"):
        capability(swarm, weather.wind)
    with pytest.raises(EnvironmentInvalid, match=r"numbers \(m,\)"):
        capability(swarm, weather, 0.0)
    with pytest.raises(EnvironmentInvalid, match="the bearing is nan"):
        capability(swarm, weather, [0.0, math.nan])
    with pytest.raises(CriterionInvalid, match="robots to lose is -1"):
        capability(swarm, weather, [0.0], losing=-1)
    with pytest.raises(SwarmInvalid, match="no Swarm"):
        capability(BARGE, weather)


def test_a_group_of_azimuths_is_lost_as_one():
    """Ahead, three of five azimuths hold three fifths of the wind's force."""
    hull = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    places = [(30, 0, "bus A"), (-30, 0, "bus A"), (25, 0, "bus B"), (-25, 0, "bus B"), (0, 0, "")]
    robots = [
        Robot((x, y), 0.0, 60e3, f"{x} {y}", mounted=True, steers=math.pi, group=group)
        for x, y, group in places
    ]
    weather = Environment(Wind(150.0, 500.0, WindCoefficients(0.9, 0.7, 0.7)))
    found = capability(Swarm(hull, robots), weather, [0.0, math.pi / 2])
    assert found.loss_words() == "one robot or group"
    assert set(found.worst_losses[0]) <= {"bus A", "bus B"}
    ahead = (found.after_loss[0] / found.intact[0]) ** 2
    assert ahead == pytest.approx(3.0 / 5.0)


SEAWORTHY = replace(load_example("supply-vessel").environment, waves=Waves())


def times_by_programs(swarm, load, losing):
    """Compute by how many times a load could grow, from the generators alone."""
    rows, least = swarm.scaled_generators, -swarm.reverse_limits / swarm.limits
    return largest_wind(rows, np.zeros(3), load * swarm.scale, losing, least)


def test_the_largest_wind_in_its_sea_is_the_end_of_those_held():
    """By linear programs: everything up to it is held, and a little more is not."""
    swarm = load_example("supply-vessel").swarm
    found = capability(swarm, SEAWORTHY, [0.3, 1.6, 4.0])
    assert found.most_told == 32.6
    for i, bearing in enumerate(found.bearings):
        for losing, speed in ((0, found.intact[i]), (1, found.after_loss[i])):
            for share in (0.2, 0.5, 0.8, 1.0 - 1e-6, 1.0 + 1e-6):
                if share * speed > 32.6:
                    continue
                load = SEAWORTHY.load_in(swarm.outline, bearing, share * speed)
                assert bool(times_by_programs(swarm, load, losing) >= 1.0) is (share < 1.0)


def test_a_given_sea_is_one_more_steady_load():
    """Whatever the wind: the formula in the square of the speed holds, and not held is told."""
    swarm = load_example("supply-vessel").swarm
    swell = replace(SEAWORTHY, waves=Waves(3.0, 9.0, bearing=1.0))
    found = capability(swarm, swell, COMPASS[::2])
    calm = swell.load_in(swarm.outline, COMPASS[::2], 0.0) * swarm.scale
    winds = swell.wind_load(swarm.outline, COMPASS[::2], 1.0) * swarm.scale
    rows, least = swarm.scaled_generators, -swarm.reverse_limits / swarm.limits
    for losing, speeds in ((0, found.intact), (1, found.after_loss)):
        expected = [
            math.sqrt(largest_wind(rows, load, wind, losing, least))
            for load, wind in zip(calm, winds, strict=True)
        ]
        np.testing.assert_allclose(speeds, expected, rtol=1e-6)
    high = capability(swarm, replace(swell, waves=Waves(12.0, 9.0, bearing=1.5)), [0.0])
    assert not high.holds_calm.any()


def test_numbers_are_what_linear_programs_say():
    """A step is held and the next is not, at bearings all round, intact and after any loss."""
    scenario = load_example("supply-vessel")
    swarm, around = scenario.swarm, scenario.environment
    found = capability_numbers(swarm, around, COMPASS)
    assert set(found.intact) > {8, 11}
    for i, bearing in enumerate(COMPASS):
        for lost, number in ((0, found.intact[i]), (1, found.after_loss[i])):
            for wind, height, period, speed in STEPS[number : number + 2]:
                water = around.current.load(swarm.outline, bearing, speed)
                load = around.wind.load(swarm.outline, bearing, wind) + water
                load += Waves().load(swarm.outline, bearing, height, period)
                held = times_by_programs(swarm, 1.25 * load, lost) >= 1.0
                assert bool(held) is (wind == STEPS[number].wind)


@pytest.mark.parametrize(
    ("cables", "calm"),
    [
        ([(0.0, 5.0), (math.pi, 5.0)], True),
        ([(0.0, 5.0), (0.1, 5.0)], False),
        ([(0.0, 5.0), (math.pi, 0.0)], True),
        ([(0.0, 30.0), (math.pi, 0.0)], False),
    ],
)
def test_who_always_pulls_may_not_even_hold_a_calm(cables, calm):
    """Two cables against each other may be as taut as each other; two the same way may not."""
    limits = [20.0, 40.0]
    robots = [
        Robot((0.0, 0.0), way, max(limit, least), mounted=True, least=least)
        for (way, least), limit in zip(cables, limits, strict=True)
    ]
    if not calm and cables[1][1] == 0.0:
        robots[1] = replace(robots[1], limit=25.0)
    swarm = Swarm(BARGE, robots)
    around = Environment(Wind(150.0, 500.0, FLAT), Current(60.0, 240.0))
    found = capability(swarm, around, [0.0, 1.0], losing=0)
    assert found.holds_calm.tolist() == [calm, calm]
    numbers = capability_numbers(swarm, around, [1.0], losing=0)
    assert numbers.intact.tolist() == [0 if calm else -1]
    in_its_sea = replace(around, waves=Waves())
    assert capability(swarm, in_its_sea, [1.0], losing=0).holds_calm.tolist() == [calm]


def test_an_envelope_off_the_origin_always_pushes():
    """One that has no force among its forces does not; two opposite ones hold a calm."""
    off = ((3.0, -1.0), (5.0, 0.0), (3.0, 1.0))
    around = Environment(Wind(150.0, 500.0, FLAT))
    one = Robot((-40.0, 0.0), 0.0, 1.0, envelope=off)
    for robots, calm in (
        ([one], False),
        ([replace(one, envelope=(*off, (0.0, 0.0)))], True),
        ([one, Robot((40.0, 0.0), math.pi, 1.0, envelope=off)], True),
    ):
        found = capability(Swarm(BARGE, robots), around, [1.0], losing=0)
        assert found.holds_calm.tolist() == [calm]


def test_numbers_need_a_current_and_end_with_the_table():
    """A swarm of no limits to speak of holds step 11; without a current nothing is asked."""
    ways = {(-40, 0): 0.0, (40, 0): math.pi, (-9, -10): 1.57, (9, -10): 1.57}
    ways |= {(-9, 10): -1.57, (9, 10): -1.57}
    strong = Swarm(BARGE, [Robot(contact, way, 60e6) for contact, way in ways.items()])
    around = Environment(Wind(150.0, 500.0, FLAT), Current(60.0, 240.0))
    assert capability_numbers(strong, around, [0.0, 1.0]).intact.tolist() == [11, 11]
    with pytest.raises(EnvironmentInvalid, match="has no current, and every step has one"):
        capability_numbers(strong, Environment(Wind(150.0, 500.0, FLAT)))
