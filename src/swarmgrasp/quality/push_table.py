"""What the kernel of push forces finds, for robots of any force sets without gaps (T27)."""

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.kernels import shares as kernel
from swarmgrasp.swarm import Swarm

Array = NDArray[np.float64]


def push_table(
    swarm: Swarm,
    wrenches: Array,
    load: tuple[float, float, float] = (0.0, 0.0, 0.0),
    scale: Array | None = None,
) -> Array:
    """Return the kernel's rows for wrenches (m, 3), all in the metric's coordinates: (m, 3n + 13).

    Forces in turn (n, 2) and shares (n,) [N], then what is needed, the shortfall, the certificate,
    and whether all of it is proven. A scale (3,) takes the place of the metric's: where it is 0 the
    part of a wrench is not seen.
    """
    x, y, z = (swarm.scale if scale is None else scale).tolist()
    elements, counts = swarm.force_sets
    arms = np.ascontiguousarray(swarm.contacts - swarm.outline.origin)
    wanted = np.ascontiguousarray(wrenches)
    table = kernel.push_forces(arms, elements, counts.astype(float), (x, y, z), wanted, load)
    return np.frombuffer(table).reshape(len(wrenches), 3 * len(swarm) + 13)
