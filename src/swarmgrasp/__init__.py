"""Where the next robot should attach to a large object, and which way it should push."""

from swarmgrasp.answer_file import read_answer, write_answer
from swarmgrasp.capability import Capability, capability
from swarmgrasp.environment import (
    BLENDERMANN,
    Current,
    CurrentCoefficients,
    Environment,
    Wind,
    WindCoefficients,
)
from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.forces import Forces, ForcesAlong, forces, forces_along
from swarmgrasp.outline import Contact, Outline, Stretch
from swarmgrasp.placement import (
    HowMany,
    Move,
    Placement,
    Placements,
    Problem,
    Relocation,
    Together,
    best_move,
    cell_qualities,
    how_many,
    place,
    place_sequence,
    place_together,
    qualities_with,
)
from swarmgrasp.quality import (
    Criterion,
    Ellipsoid,
    ForceClosure,
    Loss,
    Polytope,
    Quality,
    Sensitivities,
    losses,
    qualities,
    quality,
    sensitivities,
)
from swarmgrasp.summary import Summary
from swarmgrasp.swarm import Newcomer, Robot, Swarm, Tolerance, Zone, wrenches
from swarmgrasp.verify import Verdict, verify_document
from swarmgrasp.words import wrench_words
from swarmgrasp.wrench_set import WrenchSet

__all__ = [
    "BLENDERMANN",
    "Capability",
    "Contact",
    "Criterion",
    "Current",
    "CurrentCoefficients",
    "Ellipsoid",
    "Environment",
    "ForceClosure",
    "Forces",
    "ForcesAlong",
    "HowMany",
    "Loss",
    "Move",
    "Newcomer",
    "Outline",
    "Placement",
    "Placements",
    "Polytope",
    "Problem",
    "Quality",
    "Relocation",
    "Robot",
    "Sensitivities",
    "Stretch",
    "Summary",
    "Swarm",
    "SwarmGraspError",
    "Together",
    "Tolerance",
    "Verdict",
    "Wind",
    "WindCoefficients",
    "WrenchSet",
    "Zone",
    "best_move",
    "capability",
    "cell_qualities",
    "forces",
    "forces_along",
    "how_many",
    "losses",
    "place",
    "place_sequence",
    "place_together",
    "qualities",
    "qualities_with",
    "quality",
    "read_answer",
    "sensitivities",
    "verify_document",
    "wrench_words",
    "wrenches",
    "write_answer",
]
