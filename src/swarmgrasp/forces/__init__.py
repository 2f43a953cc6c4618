"""Which robot pushes how hard, to make a wrench."""

from swarmgrasp.forces.answer import Forces, ForcesAlong
from swarmgrasp.forces.certificate import LoadCertificate
from swarmgrasp.forces.least import forces, forces_along

__all__ = ["Forces", "ForcesAlong", "LoadCertificate", "forces", "forces_along"]
