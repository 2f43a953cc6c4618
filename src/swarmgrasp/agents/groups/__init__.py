"""Above a size: robots in groups, each along a part of the boundary, that share summaries.

Within its group a robot keeps the rules of all robots; of the other groups it knows what they can
do together. Groups are so far apart that nobody need be asked beyond the own one.
"""

from swarmgrasp.agents.groups.member import Member
from swarmgrasp.agents.groups.parts import Parts
from swarmgrasp.agents.groups.planner import GroupPlanner
from swarmgrasp.agents.groups.slot import Slot
from swarmgrasp.agents.groups.slots import Slots

__all__ = ["GroupPlanner", "Member", "Parts", "Slot", "Slots"]
