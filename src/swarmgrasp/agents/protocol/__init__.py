"""The rules by which robots agree: no clock, no chance, no network."""

from swarmgrasp.agents.protocol.agent import Agent
from swarmgrasp.agents.protocol.planner import Planner, ProblemPlanner
from swarmgrasp.agents.protocol.record import Kind, Phase, Place, Record, Row
from swarmgrasp.agents.protocol.settings import Settings
from swarmgrasp.agents.protocol.state import State, read_state, state_bytes

__all__ = [
    "Agent",
    "Kind",
    "Phase",
    "Place",
    "Planner",
    "ProblemPlanner",
    "Record",
    "Row",
    "Settings",
    "State",
    "read_state",
    "state_bytes",
]
