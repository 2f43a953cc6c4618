"""`swarmgrasp agents demo`: a swarm of processes on this machine, through what goes wrong."""

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Annotated

from cyclopts import Parameter

from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.inputs import UsageFault, blaming, read_scenario, whole_faults
from swarmgrasp.cli.lasting import say

DIFFERS = 1


def demo(
    file: Dashed = "deck-barge",
    /,
    *,
    robots: Annotated[str, Parameter(metavar="INT")] = "12",
) -> int:
    """Run robots as processes on this machine, let things go wrong, and check what comes of it.

    They join and attach; one is killed, one hangs, the network is split while two more come,
    and heals. At the end their places are compared, to the last bit, with those of one robot
    placed after the other by one computer.

    Exit status: 0 when they are the same, 1 when they differ.

    Example: swarmgrasp agents demo

    Parameters
    ----------
    file
        Scenario in YAML, or a built-in example; deck-barge unless given.
    robots
        How many, those of the scenario among them; 12 unless given.
    """
    from swarmgrasp.packages import check_installed

    check_installed("msgspec", "zenoh", purpose="A robot on the network")
    faults = whole_faults("--robots", robots)
    if file == DASH:
        faults.append("FILE is read by each robot's process; standard input cannot be")
    if faults:
        raise UsageFault(faults)
    scenario = read_scenario(file)
    from swarmgrasp.agents.network.demo import Demo
    from swarmgrasp.agents.protocol import ProblemPlanner
    from swarmgrasp.cli.app import main

    with blaming(file):
        planner = ProblemPlanner(scenario.problem())
    with TemporaryDirectory() as folder:
        story = Demo(file, planner, int(robots), main, Path(folder), say)
        differences = story.run()
    for difference in differences:
        say(f"DIFFERS: {difference}.")
    if not differences:
        say("All places are those of one robot placed after the other, to the last bit.")
    return DIFFERS if differences else 0
