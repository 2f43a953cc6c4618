"""A mission that is cheap to place robots in, for simulated networks."""

import functools
import math

from swarmgrasp import Newcomer, Outline, Problem, Robot, Swarm
from swarmgrasp.agents.simulator import Mode, draw, mission_of, simulate

BARGE = Outline([(-20, -5), (20, -5), (20, 5), (-20, 5)])


@functools.cache
def mission(mode=Mode.MAIN):
    """Return the planner of a barge that four pushing robots hold; in a cold start, of none."""
    held = [
        Robot((-12.0, -5.0), math.pi / 2 - 0.3, 1.0, "A1"),
        Robot((0.0, 5.0), -math.pi / 2 - 0.3, 1.0, "A2"),
        Robot((-20.0, -3.0), 0.0, 1.0, "A3"),
        Robot((20.0, 3.0), math.pi, 1.0, "A4"),
    ]
    problem = Problem(Swarm(BARGE, held), Newcomer(1.0, "push", 0.5), spacing=4.0)
    return mission_of(problem, mode if mode is Mode.COLD else Mode.MAIN)


def drawn(mode, seed, **fixed):
    """Return a schedule."""
    return draw(mode, seed, first=[row.id for row in planner_of(mode).present], **fixed)


def planner_of(mode):
    """Return the planner of a mode: one for all modes but the cold start."""
    return mission(Mode.COLD if mode is Mode.COLD else Mode.MAIN)


def run(schedule, **more):
    """Run a schedule."""
    return simulate(planner_of(schedule.mode), schedule, **more)
