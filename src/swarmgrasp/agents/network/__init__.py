"""Robots as real processes on a network: the only place that has a clock, chance and a network."""

from swarmgrasp.agents.network.asking import ask_robot
from swarmgrasp.agents.network.body import RealBody, StandIn
from swarmgrasp.agents.network.certificates import make_papers
from swarmgrasp.agents.network.ears import Item
from swarmgrasp.agents.network.listener import Listener
from swarmgrasp.agents.network.process import Process, Store, incarnation_of, steady_clock
from swarmgrasp.agents.network.router import Router
from swarmgrasp.agents.network.settings import NetworkSettings
from swarmgrasp.agents.network.transport import Transport
from swarmgrasp.agents.network.watch import Watch

__all__ = [
    "Item",
    "Listener",
    "NetworkSettings",
    "Process",
    "RealBody",
    "Router",
    "StandIn",
    "Store",
    "Transport",
    "Watch",
    "ask_robot",
    "incarnation_of",
    "make_papers",
    "steady_clock",
]
