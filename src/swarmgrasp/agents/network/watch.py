"""What a listener that is no robot sees: who is where, who has confirmed it, who is silent.

Its plain form is what the terminal, logs and pages show; SI and radians.
"""

import math
from collections.abc import Iterable
from typing import Any

from swarmgrasp.agents.network.plain import record_data
from swarmgrasp.agents.protocol.events import Down, Event, Received, Refuted, Stranger, Up
from swarmgrasp.agents.protocol.memory import Memory, Merged
from swarmgrasp.agents.protocol.order import in_order, too_close, view_of
from swarmgrasp.agents.protocol.planner import Planner
from swarmgrasp.agents.protocol.record import Phase, Record
from swarmgrasp.agents.protocol.wire import Ack, Beat, Put, Records
from swarmgrasp.ranges import shown

AGAIN = 0.5
"""Between two questions to one robot for all it knows [s]."""
MOST_TOLD = 100
"""Things told in words that are kept."""


class Watch:
    """A listener's knowledge of a swarm.

    Parameters
    ----------
    planner : Planner
    """

    def __init__(self, planner: Planner) -> None:
        self._planner = planner
        self._memory = Memory()
        self._heard: dict[str, float] = {}
        self._running: set[str] = set()
        self._by: dict[str, set[str]] = {}
        self._asked: dict[str, float] = {}
        self._told: dict[str, None] = {}
        self._refused = 0

    def take(self, clock: float, event: Event) -> str:
        """Take what was heard; return whom to ask for all it knows, or "".

        Parameters
        ----------
        clock : float [s]
            Any steady clock.
        event : Event
            As a robot's transport would tell it.
        """
        match event:
            case Up(name):
                self._running.add(name)
                self._heard[name] = clock
            case Down(name):
                self._running.discard(name)
            case Stranger(name, mission):
                self._tell(f"{name} works on another mission, {mission}")
            case Refuted(sender, fault):
                self._refused += 1
                self._tell(f"{sender} {fault}")
            case Received(sender, message):
                self._heard[sender] = clock
                return self._message(clock, sender, message)
        return ""

    def _message(self, clock: float, sender: str, message: Any) -> str:
        """Take a message; return whom to ask."""
        match message:
            case Put(record) | Ack(_, record) if record.id != sender:
                self._refused += 1
                self._tell(f"{sender} speaks in the name of {shown(record.id)}")
            case Put(record):
                self._learn(record)
            case Ack(of, record):
                self._learn(record)
                for other in self._memory:
                    if other.asks and other.asks_for == of:
                        self._by.setdefault(other.id, set()).add(sender)
            case Records(_, _, records):
                for record in records:
                    self._learn(record)
            case Beat(_, _, digest) if digest != self._memory.digest:
                if clock >= self._asked.get(sender, -math.inf) + AGAIN:
                    self._asked[sender] = clock
                    return sender
            case Beat():
                self._agree(sender)
        return ""

    def _learn(self, record: Record) -> None:
        """Take a record."""
        fault = self._planner.fault(record)
        if fault:
            self._refused += 1
            self._tell(f"{record.id} cannot be what it says: {fault}")
            return
        known = self._memory.get(record.id)
        merged = self._memory.merge(record)
        if merged is Merged.TWO_STORIES:
            self._tell(f"{record.id} tells two stories with one version")
        if merged is Merged.NEW and (known is None or known.asks_for != record.asks_for):
            self._by.pop(record.id, None)

    def _agree(self, sender: str) -> None:
        """Take that a robot knows all that is known here: attached, it confirms who asks."""
        record = self._memory.get(sender)
        if record is not None and record.phase is Phase.ATTACHED:
            for other in self._memory:
                if other.asks and other.id != sender:
                    self._by.setdefault(other.id, set()).add(sender)

    def _tell(self, words: str) -> None:
        """Keep something told in words, once."""
        self._told[words] = None
        while len(self._told) > MOST_TOLD:
            del self._told[next(iter(self._told))]

    def data(self, clock: float) -> dict[str, Any]:
        """Return all that is known as plain data.

        Attributes of the form: `robots`, each as its record says, with `running`, `silent` [s] and
        `confirmed_by`; `alone`, those of the mission without a process; `quality` of all that hold
        the object now, and `certified`, the most that one of them has certified [N]; `conflicts`
        in words; `refused`, messages that were none.
        """
        planner, memory = self._planner, self._memory
        view = view_of(memory, planner.present, (), ())
        holding = in_order(view.holding, planner)
        records = sorted(memory, key=lambda record: record.order)
        lowers = [r.lower for r in records if r.phase >= Phase.ATTACHED]
        return {
            "mission": planner.mission,
            "robots": [self._robot(clock, record) for record in records],
            "alone": [row.id for row in view.fixed],
            "quality": planner.lower(holding),
            "certified": max(lowers, default=0.0),
            "conflicts": [*_close(too_close(view, planner)), *self._told],
            "refused": self._refused,
        }

    def _robot(self, clock: float, record: Record) -> dict[str, Any]:
        """Return one robot as plain data."""
        heard = self._heard.get(record.id)
        return {
            **record_data(record),
            "running": record.id in self._running,
            "silent": None if heard is None else max(0.0, clock - heard),
            "confirmed_by": sorted(self._by.get(record.id, ())),
        }


def _close(pairs: Iterable[tuple[Record, Record]]) -> list[str]:
    """Return who holds the object too close to whom, in words."""
    return [f"{first.id} and {second.id} are too close; {second.id} is the later one"
            for first, second in pairs]  # fmt: skip
