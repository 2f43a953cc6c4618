"""The plain data of a summary."""

from dataclasses import dataclass, field

import numpy as np

from swarmgrasp.frozen import Frozen
from swarmgrasp.summary.cells import Array
from swarmgrasp.summary.moments import Moments

MOST_ROBOTS = 2**63 - 1
"""What Python can still tell as a length."""


@dataclass(frozen=True, eq=False)
class Content(Frozen):
    """What a summary holds, and a message carries.

    Attributes
    ----------
    count : int
        Number of robots.
    side : int
        Cells along an edge of each of the three faces; there are 3 side^2 bins.
    force_weights : tuple of float
        The metric's a1 and a2.
    characteristic_length : float [m]
        The metric's L.
    origin : tuple of float [m, m]
        The point that moments are taken about, in the frame of the outline's vertices.
    total : (3,) [N]
        Sum of the generators of all rays, in the metric's coordinates.
    rounding : float [N]
        By how much rounding may have moved that sum, the bins' sums together, and `wrenches`.
    moments : Moments
        Weight, mean position and spread of each occupied bin of rays.
    wrenches : (k, 3) [N]
        Of all robots that are no rays together, the wrench that is the farthest along each
        direction of the lattice; (0, 3) if there are none.
    """

    count: int
    side: int
    force_weights: tuple[float, float]
    characteristic_length: float
    origin: tuple[float, float]
    total: Array = field(repr=False)
    rounding: float = field(repr=False)
    moments: Moments = field(repr=False)
    wrenches: Array = field(repr=False)

    @property
    def has_sets(self) -> bool:
        """Whether some robots are no rays."""
        return len(self.wrenches) > 0

    @property
    def size(self) -> float:
        """What rounding is relative to [N]: a bound on the sum of all robots' wrenches, about."""
        reach = np.linalg.norm(self.wrenches, axis=1).max(initial=0.0)
        return self.moments.size + float(reach)
