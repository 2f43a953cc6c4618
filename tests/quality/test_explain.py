"""What an explanation says is true, and in words a seaman would use."""

import math
from dataclasses import replace

import numpy as np
import pytest

import reference
from swarmgrasp import Outline, Polytope, Robot, Swarm, quality, wrench_words
from swarmgrasp.scenario import load_example
from swarmgrasp.words import Unit

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
PULLS = [
    Robot((1, -0.4), 0.0, name="Ajax"),
    Robot((-1, 0.4), math.pi, name="Boreas"),
    Robot((-0.4, 1), math.pi / 2, name="Castor"),
    Robot((0.4, -1), -math.pi / 2, name="Dione"),
]
TWICE = [*PULLS, *(replace(robot, name="") for robot in PULLS)]
CENTRED = [Robot((math.cos(a), math.sin(a)), a) for a in np.arange(4) * math.pi / 2]


@pytest.mark.parametrize(
    ("direction", "words"),
    [
        ((1, 0, 0), "moving ahead"),
        ((-1, 0, 0), "moving aft"),
        ((0, 1, 0.2), "moving to port"),
        ((0, 0, -3), "turning to starboard"),
        ((0, 0.1, 0.9), "turning to port"),
        ((-0.4, 0, 0.9), "turning to port while moving aft"),
        ((0.9, 0, -0.4), "moving ahead while turning to starboard"),
        ((0.5, -0.6, 0), "moving to starboard and ahead"),
        ((0.5, 0.6, 0.7), "turning to port while moving to port and ahead"),
        ((0.7, 0.5, 0.6), "moving ahead and to port while turning to port"),
    ],
)
def test_a_direction_in_words(direction, words):
    """The strongest part leads, and small ones go unmentioned."""
    assert wrench_words(direction) == words


def test_an_explanation_names_what_limits_the_swarm():
    """Value, weakest direction, the robots on the facet, those who work and those who do not."""
    swarm = load_example("deck-barge").swarm
    found = quality(swarm)
    first, second, third, fourth, fifth = found.explanation.splitlines()
    assert Unit.for_size(found.value, figures=4).text(found.value) in first
    assert wrench_words(found.direction) in second
    assert third.startswith("Castor and Dione set this limit")
    products = reference.generators(
        swarm.contacts, swarm.directions, swarm.limits, swarm.outline.origin, swarm.scale
    ) @ np.array(found.direction)
    names = [robot.name for robot in swarm.robots]
    working, idle = fourth.removeprefix("There ").split(" work at full force and ")
    assert [name in working for name in names] == (products > 1e-6).tolist()
    assert [name in idle for name in names] == (products < -1e-6).tolist()
    assert "27.7 % of 827.2 kN" in fifth


@pytest.mark.parametrize(
    ("robots", "terms", "says"),
    [
        ([], {}, "There are no robots."),
        (PULLS[:3], {}, "The swarm has no force closure: in some directions it exerts nothing."),
        (
            PULLS,
            {},
            "so that no single newcomer that pushes one way can help: place two, or one that ",
        ),
        (TWICE, {"losing": 1}, "After the worst loss of 1 robot, the swarm exerts at least"),
        (TWICE, {"losing": 1}, "The worst loss is that of "),
        (
            PULLS,
            {"load": (0, 9, 0)},
            "Beside the load, the swarm is 8.000 N short of holding the load, which",
        ),
        (PULLS, {"task": Polytope([(0.5, 0, 0)])}, "The swarm manages 2.000 times the task."),
        (TWICE, {}, "set this limit: they span the weakest facet."),
        (PULLS[:3], {}, "that way it exerts nothing."),
    ],
)
def test_what_is_said_of_special_swarms(robots, terms, says):
    """No closure, the border, balance, losses, loads and tasks."""
    assert says in quality(Swarm(SQUARE, robots, 1.0), **terms).explanation


def test_many_robots_are_counted():
    """A list of names is short."""
    swarm = load_example("rectangle-15").swarm
    assert "There 7 robots work at full force and R1, R2, R8, R9 and R12 add nothing." in (
        quality(swarm).explanation
    )
