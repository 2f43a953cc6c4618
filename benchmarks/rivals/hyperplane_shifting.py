"""Quality by pycapacity's hyperplane shifting method: the faces of a robot's wrench polytope."""

import numpy as np
from pycapacity.algorithms import hyper_plane_shift_method

NAME = "pycapacity 2.1.9, hyperplane shifting"


def quality(generators):
    """Compute the least distance d / |H| of a face H w <= d of {G' u, 0 <= u <= 1}.

    Parameters
    ----------
    generators : (n, 3) [N]
        In the metric's coordinates.
    """
    low, high = np.zeros(len(generators)), np.ones(len(generators))
    H, d = hyper_plane_shift_method(generators.T, low, high)
    return float(np.min(np.ravel(d) / np.linalg.norm(H, axis=1)))
