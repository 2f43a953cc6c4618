"""Networks of robots that decide for themselves, simulated: one thread, one seed, every fault."""

from swarmgrasp.agents.simulator.checks import Book, Broken
from swarmgrasp.agents.simulator.drawing import crowded, draw
from swarmgrasp.agents.simulator.faults import (
    FLAT,
    RANGES,
    Fault,
    Mode,
    Schedule,
    What,
    number_faults,
    read_faults,
)
from swarmgrasp.agents.simulator.group_world import GroupWorld
from swarmgrasp.agents.simulator.outcome import Census, Outcome
from swarmgrasp.agents.simulator.shrink import MOST_SCHEDULES, shrink
from swarmgrasp.agents.simulator.simulate import mission_of, simulate
from swarmgrasp.agents.simulator.world import World, settings_of

__all__ = [
    "FLAT",
    "MOST_SCHEDULES",
    "RANGES",
    "Book",
    "Broken",
    "Census",
    "Fault",
    "GroupWorld",
    "Mode",
    "Outcome",
    "Schedule",
    "What",
    "World",
    "crowded",
    "draw",
    "mission_of",
    "number_faults",
    "read_faults",
    "settings_of",
    "shrink",
    "simulate",
]
