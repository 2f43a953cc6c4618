"""The robots that hold the object, and the one that looks for a place."""

from swarmgrasp.swarm.body import Body
from swarmgrasp.swarm.names import Names
from swarmgrasp.swarm.robot import Newcomer, Robot, Zone
from swarmgrasp.swarm.swarm import Swarm, wrenches
from swarmgrasp.swarm.tolerance import Tolerance

__all__ = ["Body", "Names", "Newcomer", "Robot", "Swarm", "Tolerance", "Zone", "wrenches"]
