"""Networks of robots that decide for themselves, simulated: one thread, one seed, every fault."""

from swarmgrasp.agents.simulator.checks import Book, Broken
from swarmgrasp.agents.simulator.faults import (
    Fault,
    Mode,
    Schedule,
    What,
    draw,
    number_faults,
    read_faults,
)
from swarmgrasp.agents.simulator.shrink import MOST_RUNS, shrink
from swarmgrasp.agents.simulator.world import Outcome, World, mission_of, settings_of, simulate

__all__ = [
    "MOST_RUNS",
    "Book",
    "Broken",
    "Fault",
    "Mode",
    "Outcome",
    "Schedule",
    "What",
    "World",
    "draw",
    "mission_of",
    "number_faults",
    "read_faults",
    "settings_of",
    "shrink",
    "simulate",
]
