"""The proof that no forces are better (T18, T27)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Told
from swarmgrasp.swarm.sectors import Sector

Kept = tuple[tuple[int, Sector], ...]
"""Robots, by their index, that keep one sector each."""


@dataclass(frozen=True, eq=False)
class SectorsProof(Frozen, Told):
    """Why no other sectors serve better, of robots whose sectors have gaps between (T28).

    Attributes
    ----------
    kept : tuple of (int, (float, float))
        Robots that keep one sector, of half a turn or less. Of these, and of all others with their
        gaps filled, the normals and the price prove that no forces are better.
    others : tuple of (kept, (3,))
        Robots that keep other sectors, and a unit normal, in the metric's coordinates, that proves
        that they need as large a share, or come no nearer. With those kept these are all choices.
    is_best : bool
        Whether that is so: otherwise there are too many choices to ask for all of them.
    """

    kept: Kept
    others: tuple[tuple[Kept, NDArray[np.float64]], ...]
    is_best: bool


@dataclass(frozen=True, eq=False)
class ForcesCertificate(Frozen, Told):
    """Directions and a price that prove forces to be the least.

    For the first normal n, a largest share t and any shares x_i <= t, n . sum x_i b_i <= t h(n):
    where equality holds, no smaller t would do, robots in front of the plane across n have to
    give t, and those behind it nothing. The next normals say the same of robots that lie in the
    planes across all before. Robots across all of them have x_i = y . b_i, clipped to [0, t],
    which makes their sum of squares the least.

    Of robots that steer, reverse, have friction or an envelope, h is the support function of what
    all exert together beyond their least forces. Then there is one normal: that which proves the
    largest share or, of a wrench out of reach, that nothing is nearer; if the robots exert nothing
    along that one, a second proves the largest share. With t up to 1e-6 of itself above what is
    proven, each robot exerts the force of t times its set that is nearest to ``r_i^2 J_i^T y``: r_i
    is its largest force, and J_i turns its force into a wrench. That makes the sum of
    ``|F_i|^2 / r_i^2`` the least.

    Attributes
    ----------
    normals : (k, 3)
        Unit directions in the metric's coordinates, at most 3; none for no wrench.
    price : (3,) [1/N]
        y, in the metric's coordinates.
    sectors : SectorsProof, optional
        If robots have sectors with gaps between.
    """

    normals: NDArray[np.float64]
    price: NDArray[np.float64]
    sectors: SectorsProof | None = None
