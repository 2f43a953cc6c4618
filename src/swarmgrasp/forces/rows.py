"""What kernels find for wrenches, of robots of any force sets (T27)."""

from collections.abc import Sequence
from typing import NamedTuple, NoReturn

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import ForcesNotProven
from swarmgrasp.forces.answer import Array
from swarmgrasp.forces.certificate import SectorsProof
from swarmgrasp.forces.wanted import Triple
from swarmgrasp.frozen import read_only
from swarmgrasp.kernels import shares as kernel
from swarmgrasp.swarm import Swarm


class Rows(NamedTuple):
    """What kernels found for m wrenches, as in `ForcesAlong`."""

    vectors: Array
    shares: Array
    needed: Array
    shortfalls: Array
    is_least_squares: NDArray[np.bool_]
    normals: Array
    prices: Array
    sectors: tuple[SectorsProof, ...] = ()

    def one(self, k: int) -> "Rows":
        """Return the row of one wrench."""
        here = slice(k, k + 1)
        return Rows(
            self.vectors[here], self.shares[here], self.needed[here], self.shortfalls[here],
            self.is_least_squares[here], self.normals[here], self.prices[here],
        )  # fmt: skip

    @classmethod
    def joined(cls, rows: "Sequence[Rows]", sectors: tuple[SectorsProof, ...]) -> "Rows":
        """Return rows below each other."""
        return cls(
            np.concatenate([row.vectors for row in rows]),
            np.concatenate([row.shares for row in rows]),
            np.concatenate([row.needed for row in rows]),
            np.concatenate([row.shortfalls for row in rows]),
            np.concatenate([row.is_least_squares for row in rows]),
            np.concatenate([row.normals for row in rows]),
            np.concatenate([row.prices for row in rows]),
            sectors,
        )


def set_rows(swarm: Swarm, wrenches: Array, load: Triple) -> Rows:
    """Return what the kernel finds for wrenches (m, 3), all in the metric's coordinates.

    Raises
    ------
    ForcesNotProven
        If rounding decides, so that forces can be found but not proven.
    """
    m, n = len(wrenches), len(swarm)
    x, y, z = swarm.scale.tolist()
    elements, counts = swarm.force_sets
    arms = np.ascontiguousarray(swarm.contacts - swarm.outline.origin)
    table = np.frombuffer(
        kernel.push_forces(arms, elements, counts.astype(float), (x, y, z), wrenches, load)
    ).reshape(m, 3 * n + 13)
    rest = table[:, 3 * n :]
    if not rest[:, -1].all():
        refuse_unproven(swarm, wrenches[np.argmin(rest[:, -1])])
    return Rows(table[:, : 2 * n].reshape(m, n, 2), table[:, 2 * n : 3 * n], rest[:, 0],
                rest[:, 1], read_only(rest[:, 11] == 1.0), rest[:, 2:8].reshape(m, 2, 3),
                rest[:, 8:11])  # fmt: skip


def refuse_unproven(swarm: Swarm, wrench: Array) -> NoReturn:
    """Raise `ForcesNotProven` for a wrench in the metric's coordinates."""
    raise ForcesNotProven(
        f"the shares that make {(wrench / swarm.scale).tolist()} [N, N, N m] cannot be "
        f"told from others by more than rounding: limits are from {swarm.limits.min():.3g} to "
        f"{swarm.limits.max():.3g} N, or robots alike to 1e-9; leave out the far weaker ones, "
        "or make those alike equal"
    )
