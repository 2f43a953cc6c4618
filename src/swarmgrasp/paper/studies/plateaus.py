"""How large the sets of equally good places are, and what one robot cannot do (T17)."""

from collections.abc import Iterable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.pages.runner import Runner
from swarmgrasp.pages.statements import Statement, largest, median, percent
from swarmgrasp.paper.draws import FREE, NEWCOMERS, NORMAL, Task, pulling, tasks
from swarmgrasp.paper.sizes import ROBOTS
from swarmgrasp.placement import place, qualities_with
from swarmgrasp.swarm import Swarm

Array = NDArray[np.float64]

EQUAL = 1e-6
"""Relative difference to the best within which a place counts as equally good."""
CELLS = (120, 90)
"""Contacts and directions looked at, in the middles of cells."""
ALONG = 1000
"""Contacts looked at for a newcomer along the normal."""


class Plateau(NamedTuple):
    """The optimal set of one draw.

    Attributes
    ----------
    helps : bool
        Whether a newcomer free in its direction raises the quality.
    share : float
        Of all contacts and directions, that are within 1e-6 of the best; 0 when the set is thin.
    helps_normal, share_normal : bool, float
        Of all contacts, for a newcomer along the normal.
    """

    helps: bool
    share: float
    helps_normal: bool
    share_normal: float


@dataclass(frozen=True, eq=False)
class Plateaus:
    """All draws of one number of robots.

    Attributes
    ----------
    draws : list of Task
    helps : dict of str to (k,) of bool
        By kind of newcomer.
    shares : dict of str to (k,)
    """

    draws: list[Task]
    helps: dict[str, NDArray[np.bool_]]
    shares: dict[str, Array]

    @property
    def widest(self) -> Task:
        """The draw with the largest optimal set among those where a robot helps."""
        return self.draws[int(np.where(self.helps[FREE], self.shares[FREE], -1.0).argmax())]


def plateau_of(task: Task) -> Plateau:
    """Measure a draw's optimal sets."""
    swarm = pulling(task)
    free, normal = (place(swarm, NEWCOMERS[kind]) for kind in (FREE, NORMAL))
    values, _ = landscape(swarm)
    along = qualities_with(swarm, *_normals(swarm, ALONG))
    return Plateau(
        free.improves,
        float(np.mean(values >= free.quality * (1.0 - EQUAL))),
        normal.improves,
        float(np.mean(along >= normal.quality * (1.0 - EQUAL))),
    )


def landscape(swarm: Swarm, cells: tuple[int, int] = CELLS) -> tuple[Array, Array]:
    """Compute the quality with a newcomer of 1 N in the middle of every cell.

    Returns
    -------
    values : (contacts, directions) [N]
    arcs : (contacts,) [m]
        Where the contacts are along the outline.
    """
    outline, (columns, rows) = swarm.outline, cells
    arcs = (np.arange(columns) + 0.5) / columns * outline.perimeter
    contacts = np.array([outline.at_arc_length(float(arc)).point for arc in arcs])
    directions = ((np.arange(rows) + 0.5) / rows * 2.0 - 1.0) * np.pi
    values = qualities_with(swarm, np.repeat(contacts, rows, axis=0), np.tile(directions, columns))
    return values.reshape(columns, rows), arcs


def _normals(swarm: Swarm, count: int) -> tuple[Array, Array]:
    """Return contacts (m, 2) [m, m] along the outline, and their outward normals (m,) [rad]."""
    outline = swarm.outline
    arcs = (np.arange(count) + 0.5) / count * outline.perimeter
    found = [outline.at_arc_length(float(arc)) for arc in arcs]
    return np.array([c.point for c in found]), np.array([c.inward + np.pi for c in found])


def measure(runner: Runner, seed: int, count: int) -> dict[int, Plateaus]:
    """Measure the draws of all numbers of robots."""
    return {n: _plateaus(runner, tasks(seed, n, count)) for n in ROBOTS}


def _plateaus(runner: Runner, draws: list[Task]) -> Plateaus:
    """Measure those of one number of robots."""
    helps, share, helps_normal, share_normal = map(
        np.array, zip(*runner.map(plateau_of, draws), strict=True)
    )
    return Plateaus(draws, {FREE: helps, NORMAL: helps_normal}, {FREE: share, NORMAL: share_normal})


def statements(found: dict[int, Plateaus]) -> list[Statement]:
    """State how large the optimal sets are where a robot helps."""
    free, normal = (_helped(found.values(), kind) for kind in (FREE, NORMAL))
    return [
        Statement(
            f"Where a newcomer helps at all, the best place is a whole plateau on "
            f"{percent(float(np.mean(free > 0.0)))} of the draws if it may push in any direction, "
            f"covering {percent(median(free[free > 0.0]))} of all contacts and directions in the "
            f"median and {percent(largest(free))} at most; and on "
            f"{percent(float(np.mean(normal > 0.0)))} if along the normal, covering "
            f"{percent(median(normal[normal > 0.0]))} of the boundary in the median and "
            f"{percent(largest(normal))} at most.",
            bool((free > 0.0).any() and (normal > 0.0).any()),
            rests_on=("T5", "T9"),
        )
    ]


def _helped(found: Iterable[Plateaus], kind: str) -> Array:
    """Return the shares of all draws where a newcomer of a kind helps."""
    return np.concatenate([one.shares[kind][one.helps[kind]] for one in found])
