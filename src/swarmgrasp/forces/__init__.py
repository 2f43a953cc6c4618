"""Which robot pushes how hard, to make a wrench."""

from swarmgrasp.forces.answer import Forces, ForcesAlong
from swarmgrasp.forces.certificate import ForcesCertificate
from swarmgrasp.forces.least import forces, forces_along, rows_in_step

__all__ = ["Forces", "ForcesAlong", "ForcesCertificate", "forces", "forces_along", "rows_in_step"]
