"""One schedule, in the world that its mode asks for."""

from dataclasses import replace

from swarmgrasp.agents.protocol import ProblemPlanner, Settings
from swarmgrasp.agents.simulator.faults import Mode, Schedule
from swarmgrasp.agents.simulator.group_world import GroupWorld
from swarmgrasp.agents.simulator.outcome import Outcome
from swarmgrasp.agents.simulator.world import World
from swarmgrasp.placement import Problem
from swarmgrasp.quality import Criterion
from swarmgrasp.swarm import Swarm

EFFORT = 10
"""Steps of a joint search for a plan."""


def mission_of(problem: Problem, mode: Mode) -> ProblemPlanner:
    """Return the planner of a problem for a mode: nobody is at the object in a cold start.

    Joint plans are searched for briefly: whether robots agree does not depend on how good they are.

    Parameters
    ----------
    problem : Problem
    mode : Mode
    """
    if mode is Mode.COLD:
        swarm = problem.swarm
        empty = Swarm(swarm.outline, [], swarm.characteristic_length, swarm.force_weights)
        problem = replace(problem, swarm=empty, criterion=Criterion())
    return ProblemPlanner(problem, effort=EFFORT)


def simulate(
    planner: ProblemPlanner, schedule: Schedule, settings: Settings | None = None
) -> Outcome:
    """Run a schedule to its end.

    Parameters
    ----------
    planner : ProblemPlanner
    schedule : Schedule
    settings : Settings, optional
        How the agents behave; as the mode asks when left out.

    Returns
    -------
    Outcome

    Raises
    ------
    AgentInvalid
        If the schedule is of groups, and the mission is not for them.
    ScheduleInvalid
        If it is, and so many robots have no room, or the names of some.
    """
    kind = GroupWorld if schedule.mode is Mode.GROUPS else World
    return kind(planner, schedule, settings).run()
