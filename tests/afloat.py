"""Objects afloat, to be moved."""

import numpy as np

from swarmgrasp import (
    Current,
    CurrentCoefficients,
    Environment,
    Outline,
    Robot,
    Swarm,
    Wind,
    WindCoefficients,
)
from swarmgrasp.simulation import Actuator, Hull, Plant

BARGE = Outline([(-40.0, -12.0), (35.0, -12.0), (40.0, 0.0), (35.0, 12.0), (-40.0, 12.0)])


def sea_of(current_speed=0.0, **said):
    """Return wind and current around the barge."""
    wind = Wind(180.0, 520.0, WindCoefficients(0.9, 0.6, 0.75, 0.55), 3.0, **said)
    return Environment(wind, Current(60.0, 210.0, current_speed, lateral_centroid=-1.5))


def barge_of(robots, outline=BARGE):
    """Return a swarm, its hull and the sea."""
    sea = sea_of()
    return Swarm(outline, robots), Hull.afloat(outline, sea), sea


ROBOTS = (
    Robot((-40.0, 5.0), 0.0, 300e3, "ray"),
    Robot((-40.0, -5.0), 0.1, 200e3, "cable", least=20e3),
    Robot((10.0, 12.0), -1.5, 250e3, "tunnel", reverse_limit=100e3),
    Robot((-10.0, 12.0), -1.6, 300e3, "steers", steers=0.7),
    Robot((0.0, -3.0), 0.0, 150e3, "azimuth", mounted=True, steers=np.pi),
    Robot((5.0, 4.0), sectors=[(0.5, 2.0), (3.0, 5.0)], limit=90e3, name="gaps", mounted=True),
    Robot((0.0, -12.0), 1.5, 200e3, "finger", friction=0.4),
    Robot((20.0, -12.0), 1.6, name="shape", envelope=[(1e5, 0.0), (-5e4, 6e4), (0.0, -7e4)]),
    Robot((-20.0, -12.0), 1.5, 250e3, "tug", steers=0.6, reverse_limit=80e3),
)
"""One of each kind."""


def random_run(seed, runs):
    """Return a plant with one robot of each kind, and runs from anywhere."""
    rng = np.random.default_rng(seed)
    outline = Outline(BARGE.vertices, origin=BARGE.origin + rng.normal(size=2))
    wind = Wind(180.0, 520.0, WindCoefficients(0.9, 0.6, 0.75, 0.55), 3.0)
    drag = CurrentCoefficients(*rng.uniform(0.05, 1.0, 2))
    sea = Environment(wind, Current(60.0, 210.0, coefficients=drag, lateral_centroid=-1.5), 1.25)
    swarm = Swarm(outline, ROBOTS)
    damping = rng.normal(size=(3, 3)) * np.array([1.0, 1.0, 20.0])
    damping = 1e3 * damping @ damping.T
    base = Hull.afloat(outline, sea)
    hull = Hull(
        base.mass, (1.0, -0.5), base.inertia, base.added, (2.0, 0.3), tuple(map(tuple, damping))
    )
    actuators = {
        name: Actuator(
            *rng.uniform((2.0, 5.0, 0.05, 1.0, 0.5), (9.0, 15.0, 0.3, 4.0, 1.0)),
            mass=rng.uniform(0.0, 1e5) if i % 2 else 0.0,
            follows="hull" if i % 2 else "earth",
        )
        for i, name in enumerate(swarm.names)
    }
    headings = {name: float(h) for name, h in zip(swarm.names, rng.normal(size=9), strict=True)}
    plant = Plant(swarm, hull, sea, Actuator(), actuators, headings)
    states = plant.rest(runs)
    states[:, :6] = rng.normal(size=(runs, 6)) * (30.0, 30.0, 2.0, 2.0, 2.0, 0.05)
    states[:, 6:15] = rng.uniform(0.0, 1.0, (runs, 9)) * swarm.limits
    orders = plant.orders(rng.normal(size=(runs, 9, 2)) * swarm.limits[:, None] / 1.5)
    streams = rng.normal(size=(runs, 4)) * (12.0, 12.0, 0.7, 0.7)
    return plant, states, orders, streams, rng.normal(size=(runs, 3)) * (1e4, 1e4, 1e5)
