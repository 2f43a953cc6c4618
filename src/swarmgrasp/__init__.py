"""Where the next robot should attach to a large object, and which way it should push."""

from swarmgrasp.answer_file import read_answer, write_answer
from swarmgrasp.capability import (
    Capability,
    CapabilityNumbers,
    CapabilityPlacement,
    ThrustUse,
    capability,
    capability_numbers,
    place_for_capability,
    thrust_use,
)
from swarmgrasp.environment import (
    BLENDERMANN,
    Current,
    CurrentCoefficients,
    Environment,
    Waves,
    Wind,
    WindCoefficients,
    WindTable,
)
from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.forces import Forces, ForcesAlong, forces, forces_along
from swarmgrasp.gui import studio
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
from swarmgrasp.swarm import Body, Newcomer, Robot, Swarm, Tolerance, Zone, wrenches
from swarmgrasp.verify import Verdict, verify_document
from swarmgrasp.words import wrench_words
from swarmgrasp.wrench_set import WrenchSet

__all__ = [
    "BLENDERMANN",
    "Body",
    "Capability",
    "CapabilityNumbers",
    "CapabilityPlacement",
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
    "ThrustUse",
    "Together",
    "Tolerance",
    "Verdict",
    "Waves",
    "Wind",
    "WindCoefficients",
    "WindTable",
    "WrenchSet",
    "Zone",
    "best_move",
    "capability",
    "capability_numbers",
    "cell_qualities",
    "forces",
    "forces_along",
    "how_many",
    "losses",
    "place",
    "place_for_capability",
    "place_sequence",
    "place_together",
    "qualities",
    "qualities_with",
    "quality",
    "read_answer",
    "sensitivities",
    "studio",
    "thrust_use",
    "verify_document",
    "wrench_words",
    "wrenches",
    "write_answer",
]


def __dir__() -> list[str]:
    """Return the public names, and no room of the package."""
    return sorted([*__all__, "__version__"])


def __getattr__(name: str) -> str:
    """Return the version, read from the installed package when it is asked for."""
    if name == "__version__":
        from importlib.metadata import version

        return version("swarmgrasp")
    raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
