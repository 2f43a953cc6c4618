"""The built-in deck barge and tanker, held in weather by simulated tugs."""

import math
from dataclasses import replace

from swarmgrasp import place
from swarmgrasp.environment import KNOT
from swarmgrasp.scenario import load_example
from swarmgrasp.simulation.hull import Hull
from swarmgrasp.simulation.simulation import Simulation

AFLOAT = {
    "deck-barge": {"draught": 2.44},
    "escort-ring": {"draught": 14.2, "block": 0.9},
}


def moored(name: str, knots: float, bearing: float, **more: object) -> Simulation:
    """Return a built-in object in a wind from a bearing [degrees] and half a knot or so of current.

    The deck barge has its sixth tug.
    """
    example = load_example(name)
    problem, environment = example.problem(), example.environment
    assert environment is not None
    assert environment.current is not None
    if name == "deck-barge":
        problem = problem.with_swarm(problem.swarm.with_robot(place(problem).robot))
    environment = replace(
        environment,
        wind=replace(environment.wind, speed=knots * KNOT, bearing=math.radians(bearing)),
        current=replace(environment.current, speed=0.5),
    )
    hull = Hull.afloat(problem.swarm.outline, environment, **AFLOAT[name])
    return Simulation(problem, environment, hull, **more)
