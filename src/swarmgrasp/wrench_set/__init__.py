"""All wrenches that a swarm can exert."""

from swarmgrasp.wrench_set.wrench_set import WrenchSet

__all__ = ["WrenchSet"]
