"""Where the next robot goes, with a proof that no place is better."""

from swarmgrasp.placement.answer import Placement, Placements, RunnerUp
from swarmgrasp.placement.certificate import BoxProof, Certificate, Proof
from swarmgrasp.placement.landscape import Patch, Strip, landscape, strips
from swarmgrasp.placement.many import cell_qualities, qualities_with
from swarmgrasp.placement.place import place, place_sequence
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.together import (
    HowMany,
    Move,
    Relocation,
    Together,
    best_move,
    how_many,
    place_together,
)

__all__ = [
    "BoxProof",
    "Certificate",
    "HowMany",
    "Move",
    "Patch",
    "Placement",
    "Placements",
    "Problem",
    "Proof",
    "Relocation",
    "RunnerUp",
    "Strip",
    "Together",
    "best_move",
    "cell_qualities",
    "how_many",
    "landscape",
    "place",
    "place_sequence",
    "place_together",
    "qualities_with",
    "strips",
]
