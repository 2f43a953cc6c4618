"""Where should the next robot attach to a large object, and which way should it push?"""

from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.outline import Contact, Outline, Stretch
from swarmgrasp.robot import Newcomer, Robot, Zone
from swarmgrasp.swarm import Swarm

__all__ = ["Contact", "Newcomer", "Outline", "Robot", "Stretch", "Swarm", "SwarmGraspError", "Zone"]
