"""How an object moves in wind and water, against closed forms, published models and symmetries."""

import math
import pickle

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.linalg import expm

from afloat import BARGE, barge_of, random_run, sea_of
from strategies import outline_of, seeds
from swarmgrasp import (
    Current,
    CurrentCoefficients,
    Environment,
    Outline,
    Robot,
    Swarm,
    Wind,
    WindCoefficients,
    forces,
)
from swarmgrasp.errors import SimulationInvalid, SwarmGraspError, SwarmInvalid
from swarmgrasp.scenario import load_example
from swarmgrasp.simulation import Actuator, Hull, Plant, flow

AT_ONCE = Actuator(lag=0.0, slew=0.0)
NOBODY = np.zeros((1, 0, 2))
CALM = np.zeros((1, 4))
NOTHING = Environment(
    Wind(1e-9, 1e-9, WindCoefficients(1e-6, 1e-6, 1e-6)),
    Current(1e-9, 1e-9, coefficients=CurrentCoefficients(1e-6, 1e-6)),
)
"""Wind and water that exert nothing to speak of."""


@settings(max_examples=40, deadline=None)
@given(seeds, st.sampled_from(["ring", "notched", "weighted", "free"]))
def test_loads_at_rest_are_those_of_wind_and_current(seed, family):
    """Of any outline at any heading, from any bearing, without the dynamic factor: 1e-12."""
    rng = np.random.default_rng(seed)
    outline = outline_of(family, rng)
    areas = rng.uniform(0.5, 9.0, 4)
    shape = WindCoefficients(*rng.uniform(0.1, 2.0, 3), rng.uniform())
    wind = Wind(*areas[:2], shape, rng.normal())
    drag = CurrentCoefficients(*rng.uniform(0.1, 2.0, 2))
    current = Current(*areas[2:], 0.0, coefficients=drag, lateral_centroid=rng.normal())
    hull = Hull(1.0, (0.0, 0.0), 1.0, (0.0, 0.0, 0.0))
    plant = Plant(Swarm(outline, []), hull, Environment(wind, current, 1.25))
    (speed, drift), (bearing, other) = rng.uniform(0, 20, 2), rng.uniform(-7.0, 7.0, 2)
    heading = rng.choice([0.0, rng.uniform(-7.0, 7.0)])
    state = plant.rest()
    state[0, 2] = heading
    water = flow(drift, other + heading)
    state[0, 3:5] = -water  # at rest over the ground
    streams = np.array([[*flow(speed, bearing), *flow(drift, other)]])
    expected = wind.load(outline, bearing + heading, speed)
    reach = np.abs(expected) + 1e-12 * expected[1] * outline.extent
    np.testing.assert_allclose(plant.wind(state, streams)[0], expected, atol=1e-12 * reach.max())
    both = expected + current.load(outline, other + heading, drift)
    scale = np.abs(both).max() * (1.0 + outline.extent)
    np.testing.assert_allclose(plant.load(state, streams)[0], both, atol=1e-12 * scale)


def test_a_push_ahead_is_a_hyperbolic_tangent():
    """The deck barge pushed with 300 kN nears 6.0408 m/s, to 1e-8 in steps of 1 s; order 4."""
    scenario = load_example("deck-barge")
    outline, sea = scenario.swarm.outline, scenario.environment
    hull, push = Hull.afloat(outline, sea), 300e3
    middle = Robot((0.0, outline.origin[1]), 0.0, push, mounted=True)
    airless = Environment(NOTHING.wind, sea.current)
    plant = Plant(Swarm(outline, [middle]), hull, airless, AT_ONCE)
    drag = 0.5 * sea.current.density * sea.current.frontal_area * sea.current.coefficients.surge
    fastest = math.sqrt(push / drag)
    assert fastest == pytest.approx(6.0408, abs=1e-4)
    time = (hull.mass + hull.added[0]) * fastest / push
    state = plant.rest()  # robots that obey at once need no first step to do so
    orders, errors = np.array([[[push, 0.0]]]), []
    for step in (1.0, 2.0, 4.0, 8.0):
        found = plant.advance(state, orders, CALM, None, step, int(192 / step))
        errors.append(abs(found[0, 3] - fastest * math.tanh(192.0 / time)))
    distance = fastest * time * math.log(math.cosh(192.0 / time))
    assert errors[0] < 1e-8
    assert plant.advance(state, orders, CALM, None, 1.0, 192)[0, 0] == pytest.approx(distance)
    orders = np.log2([errors[3] / errors[2], errors[2] / errors[1]])
    assert (np.abs(orders - 4.0) < 0.1).all()


def drag_of_turning(plant, u, v, r):
    """Return force abeam and moment about midship of turning at a speed of midship."""
    x, y = 0.5 * (BARGE.vertices.min(axis=0) + BARGE.vertices.max(axis=0)) - BARGE.origin
    states = np.zeros((2, 6))
    states[:, 3:] = (u + y * r, v - x * r, r), (u, v, 0.0)
    turning, straight = plant.load(states, np.zeros((2, 4)))
    force = turning[1] - straight[1]
    return force, turning[2] - straight[2] - x * force


def test_the_drag_of_turning_is_the_sum_over_strips():
    """Against 2001 strips, 1e-5; and it takes energy out whatever the motion."""
    swarm, hull, sea = barge_of([])
    plant, rng = Plant(swarm, hull, sea), np.random.default_rng(2)
    length, current = np.ptp(BARGE.vertices[:, 0]), sea.current
    factor = 0.5 * current.density * current.lateral_area / length * current.coefficients.sway
    at = np.linspace(-0.5 * length, 0.5 * length, 2001)
    for u, v, r in rng.normal(size=(40, 3)) * (2.0, 1.0, 0.05):
        strips = (v + at * r) * np.abs(v + at * r) - v * abs(v)
        truth = [-factor * np.trapezoid(strips * arm, at) for arm in (np.ones_like(at), at)]
        found = drag_of_turning(plant, u, v, r)
        scale = factor * length * (abs(v) + length * abs(r)) ** 2 * np.array([1.0, length])
        assert (np.abs(np.subtract(found, truth)) < 1e-5 * scale).all()
        assert found[0] * v + found[1] * r < 0.0


def test_nothing_drives_itself():
    """Energy is never above that of the start, from 30 starts in still water without air."""
    swarm, hull, sea = barge_of([])
    plant = Plant(swarm, hull, Environment(NOTHING.wind, sea.current))
    rng = np.random.default_rng(3)
    states = plant.rest(30)
    states[:, 3:] = rng.normal(size=(30, 3)) * (2.0, 2.0, 0.05)
    calm, nobody = np.zeros((30, 4)), np.zeros((30, 0, 2))
    start = np.einsum("ki,ij,kj->k", states[:, 3:], hull.matrix, states[:, 3:])
    for _ in range(200):
        states = plant.advance(states, nobody, calm, None, 0.5, 4)
        now = np.einsum("ki,ij,kj->k", states[:, 3:], hull.matrix, states[:, 3:])
        assert (now <= start * (1.0 + 1e-9)).all()


def test_rest_stays_rest():
    """In still air and water with idle robots, to the last bit."""
    robots = [Robot((-40.0, 5.0), 0.2, 3e5), Robot((-10.0, 12.0), -1.6, 3e5, steers=0.7)]
    swarm, hull, sea = barge_of(robots)
    plant = Plant(swarm, hull, sea)
    rest = plant.rest()
    after = plant.advance(rest, plant.orders(np.zeros((1, 2, 2))), CALM, None, 1.0, 300)
    assert (after == rest).all()


def undamped(seed, runs):
    """Return a random run without damping over the ground."""
    plant, states, orders, streams, loads = random_run(seed, runs)
    hull = Hull(plant.hull.mass, (1.0, -0.5), plant.hull.inertia, plant.hull.added, (2.0, 0.3))
    plant = Plant(
        plant.swarm, hull, plant.environment, plant.actuator, plant.actuators, plant.headings
    )
    return plant, states, orders, streams, loads


def test_air_and_water_that_move_alike_carry_the_object():
    """Galileo: the same motion, beside them."""
    plant, states, orders, streams, loads = undamped(4, 4)
    wind = np.array([0.7, -0.4])
    moved = np.add(streams, [*wind, *wind])
    still = plant.advance(states, orders, streams, loads, 0.25, 80)
    carried = plant.advance(states, orders, moved, loads, 0.25, 80)
    carried[:, :2] -= 20.0 * wind
    scale = np.abs(still).max(axis=0)
    assert (np.abs(carried - still) <= 1e-12 * scale).all()


def test_the_earth_has_no_direction():
    """Turned with everything on it, the motion is turned; forces that follow the earth as well."""
    plant, states, orders, streams, loads = random_run(5, 4)
    turn = 0.8
    c, s = math.cos(turn), math.sin(turn)
    matrix = np.array([[c, s], [-s, c]])
    headings = {name: heading + turn for name, heading in plant.headings.items()}
    other = Plant(
        plant.swarm, plant.hull, plant.environment, plant.actuator, plant.actuators, headings
    )
    turned = states.copy()
    turned[:, :2], turned[:, 2] = states[:, :2] @ matrix, states[:, 2] + turn
    flows = np.hstack([streams[:, :2] @ matrix, streams[:, 2:] @ matrix])
    found = other.advance(turned, orders, flows, loads, 0.25, 80)
    truth = plant.advance(states, orders, streams, loads, 0.25, 80)
    truth[:, :2] = truth[:, :2] @ matrix
    truth[:, 2] += turn
    assert (np.abs(found - truth) <= 1e-12 * np.abs(truth).max(axis=0)).all()


def mirrored(point):
    """Return a point on the other side of the x axis."""
    return (point[0], -point[1])


def test_a_mirrored_object_moves_as_a_mirror_shows():
    """Port for starboard, to the last bit."""
    robots = [
        Robot((-40.0, 5.0), 0.2, 300e3, "ray"),
        Robot((-10.0, 12.0), -1.6, 300e3, "steers", steers=0.7),
        Robot((0.0, -3.0), 0.4, 150e3, "azimuth", mounted=True, steers=np.pi),
    ]
    others = [
        Robot(mirrored(r.contact), -r.direction, r.limit, r.name, r.mounted, steers=r.steers)
        for r in robots
    ]
    damping = ((2e3, 0.0, 0.0), (0.0, 3e3, 1e3), (0.0, 2e3, 1e6))
    one = Hull(4e6, (1.0, -0.5), 2e9, (4e5, 1.4e6, 7e8), (2.0, 0.3), damping)
    two = Hull(4e6, (1.0, 0.5), 2e9, (4e5, 1.4e6, 7e8), (2.0, -0.3), damping)
    shape = BARGE.vertices * (1.0, -1.0)
    plant = Plant(Swarm(Outline(BARGE.vertices, (1.0, 0.5)), robots), one, sea_of())
    mirror = Plant(Swarm(Outline(shape, (1.0, -0.5)), others), two, sea_of())
    rng = np.random.default_rng(6)
    states = plant.rest(5)
    states[:, :6] = rng.normal(size=(5, 6)) * (30.0, 30.0, 2.0, 2.0, 2.0, 0.05)
    orders = plant.orders(rng.normal(size=(5, 3, 2)) * 2e5)
    streams, loads = rng.normal(size=(5, 4)) * (9, 9, 1, 1), rng.normal(size=(5, 3)) * 1e5
    odd = np.array([1.0, -1.0, -1.0, 1.0, -1.0, -1.0, *[1.0] * 3, *[-1.0] * 3])
    flip = [1.0, -1.0, 1.0, -1.0]
    found = mirror.advance(
        states * odd, orders * flip[:2], streams * flip, loads * odd[:3], 0.25, 80
    )
    assert (found == plant.advance(states, orders, streams, loads, 0.25, 80) * odd).all()


def scaled(plant, k):
    """Return a plant of another size by Froude's rule: lengths k, forces k^3, times k^(1/2)."""
    swarm, hull, sea, root = plant.swarm, plant.hull, plant.environment, math.sqrt(k)
    robots = []
    for robot in swarm:
        said = {
            "name": robot.name, "mounted": robot.mounted, "steers": robot.steers,
            "friction": robot.friction, "least": robot.least * k**3, "sectors": robot.sectors,
            "limit": robot.limit * k**3, "reverse_limit": robot.reverse_limit * k**3,
        }  # fmt: skip
        if robot.envelope:
            corners = [(x * k**3, y * k**3) for x, y in robot.envelope]
            said = {"name": robot.name, "envelope": corners}
        x, y = robot.contact
        robots.append(Robot((x * k, y * k), robot.direction, **said))
    outline = Outline(swarm.outline.vertices * k, swarm.outline.origin * k)
    rows = np.array(hull.damping) * k**2.5 * np.array([[1, 1, k], [1, 1, k], [k, k, k * k]])
    other = Hull(
        hull.mass * k**3, tuple(k * x for x in hull.centre), hull.inertia * k**5,
        tuple(m * s for m, s in zip(hull.added, (k**3, k**3, k**5), strict=True)),
        tuple(k * x for x in hull.added_at), tuple(map(tuple, rows)),
    )  # fmt: skip
    wind, current = sea.wind, sea.current
    air = Wind(
        wind.frontal_area * k**2, wind.lateral_area * k**2, wind.coefficients,
        wind.lateral_centroid * k,
    )  # fmt: skip
    water = Current(
        current.frontal_area * k**2, current.lateral_area * k**2,
        coefficients=current.coefficients, lateral_centroid=current.lateral_centroid * k,
    )  # fmt: skip
    actuators = {
        name: Actuator(
            one.lag * root, one.slew * root, one.turn_rate / root, one.turn_lag * root,
            one.efficiency, one.mass * k**3, one.follows,
        )
        for name, one in plant.actuators.items()
    }  # fmt: skip
    return Plant(
        Swarm(outline, robots), other, Environment(air, water), plant.actuator, actuators,
        plant.headings,
    )  # fmt: skip


def test_models_move_as_froude_says():
    """A model of 1:16 in a quarter of the time, to the last bit: no constant hides a size."""
    plant, states, orders, streams, loads = random_run(7, 4)
    k = 1.0 / 16.0
    model = scaled(plant, k)
    sizes = np.array([k, k, 1.0, 0.25, 0.25, 4.0, *[k**3] * 9, *[1.0] * 9])
    found = model.advance(
        states * sizes, orders * [k**3, 1.0], streams * 0.25, loads * [k**3, k**3, k**4],
        0.25 * 0.25, 80,
    )  # fmt: skip
    assert (found == plant.advance(states, orders, streams, loads, 0.25, 80) * sizes).all()


@pytest.mark.parametrize(
    ("hull", "mass", "length"),
    [
        (  # CyberShip II, a model of 1:70: Sveen 2003, as in MSS
            Hull(
                23.8, (0.0425, 0.0), 1.76 - 23.8 * 0.0425**2, (2.0, 10.0, 1.0),
                damping=((2.0, 0.0, 0.0), (0.0, 7.0, 0.1), (0.0, 0.0, 0.5)),
            ),
            ((25.8, 0.0, 0.0), (0.0, 33.8, 1.0115), (0.0, 1.0115, 2.76)),
            1.255,
        ),
        (  # a supply vessel in its own units: Fossen, Sagatun and Soerensen 1996
            Hull(
                1.0, (-0.0744, 0.0), 0.1278 - 0.02 - 0.0744**2, (0.1274, 0.8902, 0.02),
                damping=((0.0358, 0.0, 0.0), (0.0, 0.1183, -0.0124), (0.0, -0.0041, 0.0308)),
            ),
            ((1.1274, 0.0, 0.0), (0.0, 1.8902, -0.0744), (0.0, -0.0744, 0.1278)),
            1.0,
        ),
    ],
    ids=["CyberShip II", "supply vessel"],
)  # fmt: skip
def test_published_linear_models(hull, mass, length):
    """Slow motion is that of the matrix exponential, 1e-9."""
    np.testing.assert_allclose(hull.matrix, mass, atol=1e-12)
    outline = Outline(np.array([(-0.5, -0.1), (0.5, -0.1), (0.5, 0.1), (-0.5, 0.1)]) * length)
    plant = Plant(Swarm(outline, []), hull, NOTHING)
    state = plant.rest()
    state[0, 3:] = start = np.array([3.0, -2.0, 1.0]) * 1e-11
    found = plant.advance(state, NOBODY, CALM, None, 0.02, 1000)
    truth = expm(-20.0 * np.linalg.solve(np.array(mass), np.array(hull.damping))) @ start
    np.testing.assert_allclose(found[0, 3:], truth, rtol=1e-9)


def barge_with(wind_speed):
    """Return the deck barge's plant without its dynamic factor's part, its stream and its load."""
    scenario = load_example("deck-barge")
    swarm, sea = scenario.swarm, scenario.environment
    outline, bearing = swarm.outline, math.radians(60.0)
    load = sea.wind.load(outline, bearing, wind_speed)
    load += sea.current.load(outline, bearing, sea.current.speed)
    plant = Plant(swarm, Hull.afloat(outline, sea), sea)
    stream = np.array([[*flow(wind_speed, bearing), *flow(sea.current.speed, bearing)]])
    return plant, stream, load


def test_forces_that_balance_a_load_hold_it_for_ever():
    """What `forces` asks against a load within reach keeps the object where it is."""
    plant, stream, load = barge_with(10.0)
    asked = forces(plant.swarm, (0.0, 0.0, 0.0), load=load)
    assert not asked.is_degraded
    orders = plant.orders(asked.vectors[None])
    state = plant.rest(1, stream)
    n = len(plant)
    state[:, 6 : 6 + n], state[:, 6 + n :] = orders[..., 0], orders[..., 1]
    after = plant.advance(state, orders, stream, None, 0.5, 1200)
    np.testing.assert_allclose(after[0, :3], 0.0, atol=1e-6)


def test_a_load_out_of_reach_accelerates_by_what_is_missing():
    """The first acceleration is that of the missing wrench and the mass, in still water."""
    plant, _, load = barge_with(10.0)
    load *= 100.0
    asked = forces(plant.swarm, (0.0, 0.0, 0.0), load=load)
    orders = plant.orders(asked.vectors[None])
    state, n, step = plant.rest(), len(plant), 1e-3
    state[:, 6 : 6 + n], state[:, 6 + n :] = orders[..., 0], orders[..., 1]
    after = plant.advance(state, orders, CALM, load[None], step, 1)
    expected = np.linalg.solve(plant.matrix, -asked.missing)
    np.testing.assert_allclose(after[0, 3:6] / step, expected, rtol=1e-4)


def test_attached_robots_are_moved_too():
    """Mass of those that are attached, wherever they hold; none of those on lines."""
    robots = [Robot((-40.0, 5.0), 0.0, 3e5, "A"), Robot((0.0, 12.0), -1.5, 3e5, "B")]
    swarm, hull, sea = barge_of(robots)
    plant = Plant(swarm, hull, sea, Actuator(mass=2e5), {"B": Actuator(follows="earth")})
    loaded = hull.with_robots([2e5], [np.array([-40.0, 5.0]) - BARGE.origin])
    np.testing.assert_allclose(plant.matrix, loaded.matrix, rtol=1e-15)
    assert plant.hull == hull


def test_plants_are_equal_by_value_and_travel():
    """To other processes and back, and then move to the same bytes."""
    plant, states, orders, streams, loads = random_run(8, 2)
    other = pickle.loads(pickle.dumps(plant))
    assert other == plant
    assert hash(other) == hash(plant)
    assert other != Plant(plant.swarm, plant.hull, plant.environment)
    found = other.advance(states, orders, streams, loads, 0.1, 10)
    assert found.tobytes() == plant.advance(states, orders, streams, loads, 0.1, 10).tobytes()


def test_every_fault_is_told_at_once():
    """Of what a plant is made of, and of what it is asked to do."""
    swarm, hull, sea = barge_of([Robot((-40.0, 5.0), 0.0, 3e5, "Ajax")])
    with pytest.raises(SimulationInvalid) as caught:
        Plant(swarm, None, Environment(sea.wind), 3, {"Ajx": Actuator()}, {"Bo": "north"})
    assert len(caught.value.faults) == 6
    assert "there is no robot called 'Ajx'" in caught.value.faults[3]
    assert "did you mean 'Ajax'?" in caught.value.faults[3]
    assert "the speed may be 0" in caught.value.faults[1]
    with pytest.raises(SwarmGraspError) as caught:
        Plant(None, hull, sea, actuators=[Actuator()])
    assert isinstance(caught.value, SwarmInvalid)
    assert len(caught.value.faults) == 2
    plant = Plant(swarm, hull, sea)
    with pytest.raises(SimulationInvalid) as caught:
        plant.advance(np.zeros((2, 7)), "go", [[1.0]], [[np.nan] * 3], 0.0, 1.5)
    assert len(caught.value.faults) == 6
    with pytest.raises(SimulationInvalid, match=r"that at \[0, 2\] is inf"):
        plant.given([[0.0, 0.0, np.inf, 0.0, 0.0, 0.0, 0.0, 0.0]])
    state = plant.rest()
    state[0, 3:5] = 1e3
    with pytest.raises(SimulationInvalid, match="take shorter steps"):
        plant.advance(state, np.zeros((1, 1, 2)), CALM, None, 1e6, 10)
    with pytest.raises(SimulationInvalid, match="runs is 0"):
        plant.rest(0)
