"""Capability: what weather a swarm holds the object in, from every bearing."""

from swarmgrasp.capability.asked import AllRound
from swarmgrasp.capability.numbers import ALLOWANCE, CapabilityNumbers, capability_numbers
from swarmgrasp.capability.place import CapabilityPlacement, place_for_capability
from swarmgrasp.capability.winds import Capability, capability

__all__ = [
    "ALLOWANCE",
    "AllRound",
    "Capability",
    "CapabilityNumbers",
    "CapabilityPlacement",
    "capability",
    "capability_numbers",
    "place_for_capability",
]
