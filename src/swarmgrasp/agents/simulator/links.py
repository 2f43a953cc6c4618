"""The links between robots: which are cut, and what is lost, late or comes twice on them."""

import math
from collections import Counter
from collections.abc import Sequence

from swarmgrasp.agents.simulator.chance import mixed, share_of
from swarmgrasp.agents.simulator.faults import Schedule
from swarmgrasp.agents.simulator.node import Node

CALM_DELAY = 0.01
"""How long a message takes in calm, at the mean [s]."""

_LINK = 0  # what chance is drawn for; all else is in world.py


class Links:
    """All links of a simulated network, one for each direction.

    Parameters
    ----------
    schedule : Schedule
    """

    def __init__(self, schedule: Schedule) -> None:
        self._schedule = schedule
        self._cuts: Counter[tuple[str, ...]] = Counter()
        self._chances: dict[tuple[int, int], int] = {}
        self._sent: Counter[tuple[int, int]] = Counter()

    def cut(self, pairs: Sequence[tuple[str, ...]]) -> None:
        """Let messages from the first to the second of each pair be lost."""
        self._cuts.update(pairs)

    def mend(self, pairs: Sequence[tuple[str, ...]]) -> None:
        """Let messages pass again, where nothing else cuts them."""
        self._cuts.subtract(pairs)
        self._cuts = +self._cuts

    def is_cut(self, sender: str, receiver: str) -> bool:
        """Tell whether messages from one to another are lost."""
        return bool(self._cuts) and (sender, receiver) in self._cuts

    def carry(self, sender: Node, receiver: Node, time: float) -> list[float]:
        """Return after how long a message comes [s]: once, twice, or never."""
        if self.is_cut(sender.name, receiver.name):
            return []
        pair, schedule = (sender.index, receiver.index), self._schedule
        link = self._chances.get(pair)
        if link is None:
            link = self._chances[pair] = mixed(schedule.seed, *pair, _LINK)
        self._sent[pair] += 1
        bits = mixed(link + self._sent[pair])
        is_calm = time >= schedule.calm
        if not is_calm and share_of(bits) < schedule.loss:
            return []
        delay, more = CALM_DELAY if is_calm else schedule.delay, bits >> 32
        late = -delay * math.log(1.0 - share_of(more))
        if not is_calm and share_of(bits * 0x9E3779B9 >> 7) < schedule.doubled:
            return [late, late + delay * share_of(more * 0x9E3779B9)]
        return [late]
