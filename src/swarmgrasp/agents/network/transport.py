"""One robot's messages and signs of life over Zenoh."""

import math
import random
from dataclasses import dataclass
from queue import SimpleQueue

import zenoh

from swarmgrasp.agents.network.ears import Ears, Item
from swarmgrasp.agents.network.keys import ALL_ALIVE, ALL_ROUTERS, every, own_keys
from swarmgrasp.agents.network.settings import NetworkSettings
from swarmgrasp.agents.protocol.events import ANYONE, EVERYONE, Cut, Down, Event, Up
from swarmgrasp.agents.protocol.wire import Message, Records, encode

HOLD = 0.02
"""For how long [s] a token that vanished is looked at before its robot counts as ended: if a
router vanishes in the same moment, or the own line breaks, it is the line that has ended."""
GREETING = 2.0
"""How long it is asked who is there [s]."""


@dataclass
class Traffic:
    """What a process has sent and received: messages and their bytes, without Zenoh's own."""

    sent: int = 0
    sent_bytes: int = 0
    received: int = 0
    received_bytes: int = 0


class Transport:
    """One process on the network.

    Parameters
    ----------
    settings : NetworkSettings
    mission : str
        Digest of the mission.
    name : str
        The robot's.
    """

    def __init__(self, settings: NetworkSettings, mission: str, name: str) -> None:
        self.name, self.keys = name, own_keys(mission, name)
        self.traffic = Traffic()
        self.alive: set[str] = set()
        """Other robots of the mission whose token is there."""
        self._lines: set[str] = set()
        self._gone: dict[str, float] = {}
        self._line_gone = False
        self._unsent: Message | None = None
        self._ears = Ears(settings, self.keys)
        self._session = self._ears.session

    @property
    def inbox(self) -> SimpleQueue[Item]:
        """What has come in."""
        return self._ears.inbox

    # -- coming and going -----------------------------------------------------------------

    def is_taken(self) -> bool:
        """Tell whether a process of this robot is on the network already."""
        replies = self._session.liveliness().get(self.keys.alive, timeout=GREETING)
        return any(reply.ok is not None for reply in replies)  # others say that time is up

    def begin(self) -> None:
        """Listen, find out who is there, and be there."""
        ears, life = self._ears, self._session.liveliness()
        ears.hear("all", every(self.keys.to_all))
        ears.hear("to", every(self.keys.to(self.name)))
        ears.hear("body", self.keys.event, own=True)
        ears.hear("wish", self.keys.ask)
        ears.watch_lines()
        ears.watch("token", ALL_ALIVE)
        ears.watch("router", ALL_ROUTERS)
        ears.keep(self._session.declare_queryable(self.keys.records, self._asked))
        for reply in life.get(every(self.keys.alive), timeout=GREETING):
            if reply.ok is not None:
                self.inbox.put(Item("token", str(reply.ok.key_expr), True))
        self._publisher = self._session.declare_publisher(
            self.keys.to_all, congestion_control=zenoh.CongestionControl.BLOCK, express=True
        )
        ears.keep(self._publisher)
        ears.keep(life.declare_token(self.keys.alive))

    def end(self) -> None:
        """Be no longer there."""
        self._ears.close()

    # -- out ------------------------------------------------------------------------------

    def send(self, to: str, message: Message) -> None:
        """Send a message to a robot, to everyone, or to anyone who is there."""
        if to == ANYONE:
            others = sorted(self.alive)
            if not others:
                self._unsent = message  # it is for the first who comes
                return
            to = random.choice(others)
        data = encode(message)
        self.traffic.sent += 1
        self.traffic.sent_bytes += len(data)
        if to == EVERYONE:
            self._publisher.put(data)
        else:
            self._put(self.keys.to(to), data)

    def order(self, data: bytes) -> None:
        """Tell the robot's own software what to do."""
        self._put(self.keys.order, data)

    def say_to_operator(self, data: bytes) -> None:
        """Answer an operator's wish."""
        self._put(self.keys.answer, data)

    def answer(self, item: Item, records: Records) -> None:
        """Answer someone, who is no robot, with all records."""
        item.content.reply(self.keys.records, encode(records))
        item.content.drop()

    # -- in -------------------------------------------------------------------------------

    @property
    def wake(self) -> float:
        """When `due` has something to say at the latest, by the clock [s] it was given."""
        if self._line_gone:
            return -math.inf
        return min(self._gone.values(), default=math.inf) + HOLD

    def due(self, clock: float) -> list[Event]:
        """Return who has ended, once it is sure that it is not the line that has."""
        if self._line_gone:
            self._line_gone = False
            self._gone.clear()
            return [Cut()]
        if not self.inbox.empty():  # that the line has ended may be waiting there
            return []
        ended = [name for name, since in self._gone.items() if clock >= since + HOLD]
        for name in ended:
            del self._gone[name]
        return [Down(name) for name in ended]

    def events(self, clock: float, item: Item) -> list[Event]:
        """Return what an item of the queue says."""
        match item.what:
            case "all" | "to":
                self.traffic.received += 1
                self.traffic.received_bytes += len(item.content)
                return [self._ears.message(item)]
            case "token":
                return self._token(clock, item)
            case "router" if not item.content:
                self._line_gone = True
            case "line":
                had = bool(self._lines)
                (self._lines.add if item.content else self._lines.discard)(item.key)
                self._line_gone |= had != bool(self._lines)
        return []

    def _token(self, clock: float, item: Item) -> list[Event]:
        """Return who is there, and who works on something else; note who may have ended."""
        event = self._ears.token(item)
        match event:
            case None | Up(self.name) | Down(self.name):
                return []
            case Down(name):
                self.alive.discard(name)
                self._gone.setdefault(name, clock)
                return []
            case Up(name):
                self._gone.pop(name, None)
                if name in self.alive:
                    return []
                self.alive.add(name)
                if self._unsent is not None:
                    unsent, self._unsent = self._unsent, None
                    self.send(name, unsent)
        return [event]

    def _asked(self, query: zenoh.Query) -> None:
        """Take a question for all records; called by Zenoh."""
        self.inbox.put(Item("asked", "", query))

    def _put(self, key: str, data: bytes) -> None:
        """Send bytes under a key."""
        block = zenoh.CongestionControl.BLOCK
        self._session.put(key, data, congestion_control=block, express=True)
