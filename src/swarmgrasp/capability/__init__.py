"""Capability: what weather a swarm holds the object in, from every bearing."""

from swarmgrasp.capability.asked import AllRound
from swarmgrasp.capability.joined import CapabilityJoined, capability_joined
from swarmgrasp.capability.numbers import ALLOWANCE, CapabilityNumbers, capability_numbers
from swarmgrasp.capability.place import CapabilityPlacement, place_for_capability
from swarmgrasp.capability.use import ThrustUse, thrust_use
from swarmgrasp.capability.winds import Capability, capability

__all__ = [
    "ALLOWANCE",
    "AllRound",
    "Capability",
    "CapabilityJoined",
    "CapabilityNumbers",
    "CapabilityPlacement",
    "ThrustUse",
    "capability",
    "capability_joined",
    "capability_numbers",
    "place_for_capability",
    "thrust_use",
]
