"""Many random newcomers moved at once towards a soft minimum: good places to climb from (T17).

The quality is the least of what the swarm has along all normals. A climb from anywhere ends at the
first place where the two or three weakest normals hold each other up. Here every one of some
evenly spread normals pulls, the weaker the more, so that newcomers spread before the very weakest
alone counts. The gradient is closed form: no program is solved, and rough directions will do.
"""

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.placement.together.effort import Budget
from swarmgrasp.placement.together.gauge import Gauge
from swarmgrasp.placement.together.stands import Stands
from swarmgrasp.products import dots

Array = NDArray[np.float64]
FLOCKS, MOST_STANDS = 32, 400
"""Sets of newcomers that are moved at once, and the newcomers in them all, at most."""
NORMALS = 200
"""Normals that pull."""
DOUBLINGS, TURNS = (2, 3, 4, 5), 10
"""How often weights are squared, one after the other, and moves with each."""
FIRST_STEP, SHRINK = 4.0, 0.91
"""First move, of a tenth of the outline's radius and a tenth of a radian each, and what each is of
the one before."""
SOFT = 0.05
"""Least difference of levels that halves a weight's root, in units of one newcomer."""
STANDS_A_STEP = 4
"""Newcomers that are moved to the end in the time of a step."""


class Gathering:
    """Newcomers that are pulled by every normal.

    Parameters
    ----------
    gauge : Gauge
    budget : Budget
    """

    def __init__(self, gauge: Gauge, budget: Budget) -> None:
        self.gauge, self.ground, self.budget = gauge, gauge.ground, budget
        levels = gauge.levels(spread_normals(NORMALS))
        self._normals = levels.normals / levels.extents[:, None]
        self._levels = levels.heights[:, -1] / levels.extents
        self._reach = 0.1 * np.array([self.ground.outline.radius, 1.0])

    def flocks(self, count: int) -> int:
        """Return how many sets of so many newcomers are moved at once."""
        return max(min(FLOCKS, MOST_STANDS // count), 2)

    def gathered(self, flocks: list[Stands]) -> list[Stands]:
        """Return sets of as many newcomers each, moved; the best first, and at the spacing only."""
        many, count = len(flocks), len(flocks[0].piece)
        self.budget.spend(many * count // STANDS_A_STEP)
        stands = Stands(
            np.concatenate([each.piece for each in flocks]), np.vstack([e.at for e in flocks])
        )
        step = FIRST_STEP
        for doublings in DOUBLINGS:
            for _ in range(TURNS):
                ways = step * self._reach * self._ways(stands, many, doublings)
                stands = self.ground.clipped(Stands(stands.piece, stands.at + ways))
                step *= SHRINK
        pulls = dots(self.ground.wrenches(stands), self._normals)
        order = np.argsort(-self._reached(pulls, many).min(axis=1), kind="stable")
        found = [stands.take(range(k * count, (k + 1) * count)) for k in order.tolist()]
        return [each for each in found if self.ground.keeps_spacing(each)]

    def _reached(self, pulls: Array, many: int) -> Array:
        """Return what each set has along the normals, (many, m)."""
        added = pulls * self.gauge.exerted(pulls)
        return np.asarray(self._levels + added.reshape(many, -1, pulls.shape[1]).sum(axis=1))

    def _ways(self, stands: Stands, many: int, doublings: int) -> Array:
        """Return where newcomers are pulled, (many count, 2), at most 1 in each set."""
        pulls = dots(self.ground.wrenches(stands), self._normals)
        reached = self._reached(pulls, many) / self.gauge.size
        least = reached.min(axis=1, keepdims=True)
        soft = np.maximum(least, SOFT)
        weights = root = soft / (reached - least + soft)
        for _ in range(doublings):
            weights = weights * weights
        weights = weights * root
        weights /= weights.sum(axis=1, keepdims=True)
        pulling = np.repeat(weights, len(stands.piece) // many, axis=0) * self.gauge.exerted(pulls)
        wanted = dots(pulling, self._normals.T)
        ways = np.column_stack([(wanted * s).sum(axis=1) for s in self.ground.slopes(stands)])
        ways = (ways * self._reach).reshape(many, -1)
        ways /= np.maximum(np.abs(ways).max(axis=1, keepdims=True), 1e-300)
        ways = ways.reshape(-1, 2)
        if self.ground.spacing > 0.0:
            apart = self._apart(stands, many)
            ways[:, 0] = np.where(apart != 0.0, apart, ways[:, 0])
        return ways

    def _apart(self, stands: Stands, many: int) -> Array:
        """Return how far along their edges newcomers want to get away from those too near."""
        points = self.ground.contacts(stands).reshape(many, -1, 2)
        offsets = points[:, :, None] - points[:, None]
        away = np.sqrt((offsets * offsets).sum(axis=-1))
        near = (away < self.ground.spacing) & (away > 0.0)
        ways = offsets / np.where(near, away, np.inf)[..., None]
        return np.asarray((ways.sum(axis=2).reshape(-1, 2) * self.ground.steps(stands)).sum(axis=1))


def spread_normals(count: int) -> Array:
    """Return unit normals (m, 3) all around, by the golden angle."""
    turns = np.arange(count) + 0.5
    heights = 1.0 - 2.0 * turns / count
    angles, radii = turns * np.pi * (3.0 - np.sqrt(5.0)), np.sqrt(1.0 - heights * heights)
    return np.column_stack([radii * np.cos(angles), radii * np.sin(angles), heights])
