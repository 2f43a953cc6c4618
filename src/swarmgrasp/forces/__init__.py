"""Which robot pushes how hard, to make a wrench."""

from swarmgrasp.forces.answer import Forces, ForcesAlong
from swarmgrasp.forces.certificate import ForcesCertificate
from swarmgrasp.forces.free import largest_multiple, with_free_parts
from swarmgrasp.forces.least import forces, forces_along, rows_in_step

__all__ = [
    "Forces",
    "ForcesAlong",
    "ForcesCertificate",
    "forces",
    "forces_along",
    "largest_multiple",
    "rows_in_step",
    "with_free_parts",
]
