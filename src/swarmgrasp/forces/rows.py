"""What kernels find for wrenches, of robots of any force sets (T27)."""

from collections.abc import Sequence
from typing import Any, NamedTuple, NoReturn

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import ForcesNotProven
from swarmgrasp.forces.answer import Array
from swarmgrasp.forces.certificate import SectorsProof
from swarmgrasp.forces.wanted import Triple
from swarmgrasp.frozen import read_only
from swarmgrasp.quality.push_table import push_table
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

    @property
    def columns(self) -> tuple[Any, ...]:
        """All that has a row for each wrench."""
        *columns, _ = self
        return tuple(columns)

    def one(self, k: int) -> "Rows":
        """Return the row of one wrench."""
        return Rows(*(column[k : k + 1] for column in self.columns))

    @classmethod
    def joined(cls, rows: "Sequence[Rows]", sectors: tuple[SectorsProof, ...]) -> "Rows":
        """Return rows below each other."""
        columns = zip(*(row.columns for row in rows), strict=True)
        below: list[Any] = [np.concatenate(column) for column in columns]
        return cls(*below)._replace(sectors=sectors)


def set_rows(swarm: Swarm, wrenches: Array, load: Triple, scale: Array | None = None) -> Rows:
    """Return what the kernel finds for wrenches (m, 3), all in the metric's coordinates.

    A scale (3,) takes the place of the metric's.

    Raises
    ------
    ForcesNotProven
        If rounding decides, so that forces can be found but not proven.
    """
    m, n = len(wrenches), len(swarm)
    table = push_table(swarm, wrenches, load, scale)
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
