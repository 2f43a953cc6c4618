"""Choices of sectors: which of them each robot with gaps pushes in, and the search for the best.

The forces of a robot with gaps are a union of convex sectors, so what a swarm reaches is the union
over all choices of one sector each (T28). For some of the robots chosen and the hull of all others'
sectors, anything that more force can only help is at least as good as with any choice that
agrees: branch and bound. Quality, push forces and placement all choose with this.
"""

import heapq
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from math import prod
from typing import Any, NamedTuple

from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Told
from swarmgrasp.swarm.sectors import Sector, convex_parts
from swarmgrasp.swarm.swarm import Swarm

MOST_ASKED = 4096
"""Choices, whole ones and parts, that one search may ask for: 12 robots of two sectors each."""
TIE = 1e-6
"""Relative difference of two costs that is none, from branch to branch."""
OPEN = -1
"""Of a robot whose sector is not chosen yet."""

Taken = tuple[int, ...]
"""The sector taken by each robot with gaps, or `OPEN`."""
Cost = tuple[float, ...]
"""What is to be least: first the first number, then the next."""


class Asked(NamedTuple):
    """What is known of a choice, whole or in part."""

    cost: Cost
    """No choice that agrees costs less."""
    split: int | None
    """Which robot with gaps to decide next; None if the cost is one that can be had as it is."""
    what: Any
    """What else is known."""


@dataclass(frozen=True, eq=False)
class Choice(Frozen, Told):
    """One sector of each robot with gaps.

    Attributes
    ----------
    sectors : mapping of str to (float, float) [rad, rad]
        By the robots' names.
    is_best : bool
        Whether no other choice is better: otherwise there are too many to tell.
    """

    sectors: Mapping[str, Sector]
    is_best: bool

    def to_data(self) -> dict[str, Any]:
        """Return the choice as plain data."""
        sectors = {name: list(sector) for name, sector in self.sectors.items()}
        return {"sectors": sectors, "is_best": self.is_best}


class Found(NamedTuple):
    """The best choice that a search has found."""

    taken: Taken
    asked: Asked
    others: tuple[tuple[Taken, Asked], ...]
    """Choices in part that cost no less: with the one taken they are all there are."""
    is_best: bool
    """Whether that is known: otherwise the work was spent, and the others are not all."""


class Choices:
    """The choices of sectors that the robots with gaps of a swarm have.

    Parameters
    ----------
    swarm : Swarm

    Attributes
    ----------
    rows : tuple of int
        The robots with gaps, by their rows in the arrays.
    options : tuple of Sectors
        The sectors of each, cut so that they are convex.

    Examples
    --------
    >>> from swarmgrasp import Outline, Robot
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> two = [Robot((x, 0.0), sectors=[(0.4, 2.7), (3.5, 5.9)], mounted=True) for x in (0.5, -0.5)]
    >>> choices = Choices(Swarm(square, two))
    >>> choices.count, choices.swarm((0, 1)).steers.round(3).tolist()
    (4, [1.15, 1.2])
    """

    def __init__(self, swarm: Swarm) -> None:
        self._swarm = swarm
        self.rows = tuple(sorted(swarm.rare.gaps))
        self.options = tuple(convex_parts(swarm.rare.gaps[i]) for i in self.rows)
        self._swarms: dict[Taken, Swarm] = {}

    @property
    def count(self) -> int:
        """How many choices there are."""
        return prod(map(len, self.options))

    @property
    def none(self) -> Taken:
        """The choice of nothing: all gaps are filled."""
        return (OPEN,) * len(self.rows)

    def sectors(self, taken: Taken) -> dict[int, Sector]:
        """Return the sectors taken, by the robots' rows."""
        each = zip(self.rows, self.options, taken, strict=True)
        return {i: options[k] for i, options, k in each if k != OPEN}

    def swarm(self, taken: Taken) -> Swarm:
        """Return the swarm with the sectors taken, and the gaps of all other robots filled."""
        if taken not in self._swarms:
            if len(self._swarms) >= MOST_ASKED:
                self._swarms.clear()
            self._swarms[taken] = self._swarm.choosing(self.sectors(taken))
        return self._swarms[taken]

    def told(self, taken: Taken, is_best: bool) -> Choice:
        """Return a choice by the robots' names."""
        names = self._swarm.names
        return Choice({names[i]: each for i, each in self.sectors(taken).items()}, is_best)

    def first_open(self, taken: Taken) -> int | None:
        """Return the first robot with gaps that is not decided yet."""
        return taken.index(OPEN) if OPEN in taken else None

    def least(self, ask: Callable[[Taken], Asked], most: int = MOST_ASKED) -> Found:
        """Find the choice of least cost by branch and bound, of so many asked for at most.

        The search goes down to a whole choice first, where the cost grows least, and improves that
        one robot at a time if the work ends before all others are known to cost no less.

        Parameters
        ----------
        ask : callable
            Tells of a choice what it costs at least.
        most : int
        """
        asked: dict[Taken, Asked] = {}

        def tell(taken: Taken) -> Asked:
            """Return what is known of a choice; ask for it once."""
            if taken not in asked:
                asked[taken] = ask(taken)
            return asked[taken]

        best = self._descend(self.none, tell)
        heap, closed = [(tell(self.none).cost, self.none)], []
        while heap:
            cost, taken = heapq.heappop(heap)
            split = asked[taken].split
            if taken != best and is_less(cost, asked[best].cost):
                if split is None:
                    best = taken
                elif len(asked) > most:
                    best = self._improve(best, tell)
                    return Found(best, asked[best], (), False)
                else:
                    for more in self._decided(taken, split):
                        heapq.heappush(heap, (tell(more).cost, more))
                    continue
            closed.append(taken)
        others = tuple((taken, asked[taken]) for taken in closed if taken != best)
        return Found(best, asked[best], others, True)

    def _decided(self, taken: Taken, k: int) -> list[Taken]:
        """Return a choice with each sector of one more robot, or instead of the one it has."""
        return [(*taken[:k], j, *taken[k + 1 :]) for j in range(len(self.options[k]))]

    def _descend(self, taken: Taken, tell: Callable[[Taken], Asked]) -> Taken:
        """Decide one robot after the other for the sector that costs least."""
        while (split := tell(taken).split) is not None:
            taken = min(self._decided(taken, split), key=lambda more: tell(more).cost)
        return taken

    def _improve(self, taken: Taken, tell: Callable[[Taken], Asked]) -> Taken:
        """Change the sector of one robot after the other for as long as that costs less."""
        is_better = True
        while is_better:
            is_better = False
            for k, now in enumerate(taken):
                if now == OPEN:
                    continue
                for other in self._decided(taken, k):
                    if tell(other).split is None and is_less(tell(other).cost, tell(taken).cost):
                        taken, is_better = other, True
        return taken


def is_less(cost: Cost, other: Cost) -> bool:
    """Tell whether a cost is less than another, by more than `TIE` of the smaller.

    Examples
    --------
    >>> is_less((1.0, 2.0), (1.0 + 1e-9, 3.0)), is_less((1.0, 3.0), (1.0 + 1e-9, 3.0))
    (True, False)
    """
    for one, two in zip(cost, other, strict=True):
        if one != two and abs(one - two) > TIE * min(abs(one), abs(two)):
            return one < two
    return False
