"""Where the next robot should attach to a large object, and which way it should push."""

from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.outline import Contact, Outline, Stretch
from swarmgrasp.placement import (
    Placement,
    Problem,
    cell_qualities,
    place,
    place_sequence,
    qualities_with,
    read_answer,
    verify_document,
    write_answer,
)
from swarmgrasp.quality import ForceClosure, Quality, qualities, quality, wrench_words
from swarmgrasp.robot import Newcomer, Robot, Zone
from swarmgrasp.summary import Summary
from swarmgrasp.swarm import Swarm, wrenches
from swarmgrasp.wrench_set import WrenchSet

__all__ = [
    "Contact",
    "ForceClosure",
    "Newcomer",
    "Outline",
    "Placement",
    "Problem",
    "Quality",
    "Robot",
    "Stretch",
    "Summary",
    "Swarm",
    "SwarmGraspError",
    "WrenchSet",
    "Zone",
    "cell_qualities",
    "place",
    "place_sequence",
    "qualities",
    "qualities_with",
    "quality",
    "read_answer",
    "verify_document",
    "wrench_words",
    "wrenches",
    "write_answer",
]
