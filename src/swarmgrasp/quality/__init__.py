"""How good a grasp is: one module per quality."""

from swarmgrasp.quality.criterion import Criterion
from swarmgrasp.quality.losses import Loss, losses
from swarmgrasp.quality.max_transfer import ForceClosure, Quality, quality
from swarmgrasp.quality.sensitivity import Sensitivities, sensitivities
from swarmgrasp.quality.task import Ellipsoid, Polytope
from swarmgrasp.quality.weakest import qualities

__all__ = [
    "Criterion",
    "Ellipsoid",
    "ForceClosure",
    "Loss",
    "Polytope",
    "Quality",
    "Sensitivities",
    "losses",
    "qualities",
    "quality",
    "sensitivities",
]
