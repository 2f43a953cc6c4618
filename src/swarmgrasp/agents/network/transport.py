"""Messages and signs of life over Zenoh: what comes in is queued, and made events of by one thread.

Zenoh calls from threads of its own; what it calls here only puts something into the queue.
"""

import math
import random
from collections.abc import Callable
from dataclasses import dataclass
from queue import SimpleQueue
from typing import Any, Literal

import zenoh

from swarmgrasp.agents.network.keys import ALL_ALIVE, ALL_ROUTERS, Keys, own_keys
from swarmgrasp.agents.network.session import open_session
from swarmgrasp.agents.network.settings import NetworkSettings
from swarmgrasp.agents.protocol.events import (
    ANYONE,
    EVERYONE,
    Cut,
    Down,
    Event,
    Received,
    Refuted,
    Stranger,
    Up,
)
from swarmgrasp.agents.protocol.record import id_fault
from swarmgrasp.agents.protocol.wire import PROTOCOL, Message, Records, decode, encode
from swarmgrasp.errors import MessageInvalid

HOLD = 0.02
"""For how long [s] a token that vanished is looked at before its robot counts as ended: if a
router vanishes in the same moment, or the own line breaks, it is the line that has ended."""
MOST_WAITING = 100_000
"""Messages in the queue; more are dropped, and counted."""
GREETING = 2.0
"""How long it is asked who is there [s]."""

What = Literal["all", "to", "token", "router", "line", "asked", "body", "end", "planned"]


@dataclass(frozen=True)
class Item:
    """What has come in.

    Attributes
    ----------
    what : str
        From where it came.
    key : str
        Under which key; of a line, whose.
    content : Any
        Bytes; of tokens and lines, whether they are there.
    """

    what: What
    key: str = ""
    content: Any = b""


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
        self.inbox: SimpleQueue[Item] = SimpleQueue()
        self.traffic = Traffic()
        self.alive: set[str] = set()
        """Robots of the mission whose token is there."""
        self._lines: set[str] = set()
        self._gone: dict[str, float] = {}
        self._line_gone = False
        self._strangers: set[str] = set()
        self._dropped = 0
        self._unsent: Message | None = None
        self._session = open_session(settings)
        self._kept: list[Any] = []

    # -- coming and going -----------------------------------------------------------------

    def is_taken(self) -> bool:
        """Tell whether a process of this robot is on the network already."""
        return any(True for _ in self._session.liveliness().get(self.keys.alive, timeout=GREETING))

    def begin(self) -> None:
        """Listen, find out who is there, and be there."""
        session, life = self._session, self._session.liveliness()
        remote = zenoh.Locality.REMOTE
        heard: tuple[tuple[What, str], ...] = (
            ("all", self.keys.to_all),
            ("to", self.keys.to(self.name)),
        )
        for what, key in heard:
            take = self._sampled(what)
            self._keep(session.declare_subscriber(_every(key), take, allowed_origin=remote))
        self._keep(session.declare_subscriber(self.keys.event, self._sampled("body")))
        self._keep(session.declare_queryable(self.keys.records, self._asked))
        self._keep(session.info.declare_transport_events_listener(self._lined, history=True))
        signs: tuple[tuple[What, str], ...] = (("token", ALL_ALIVE), ("router", ALL_ROUTERS))
        for sign, key in signs:
            self._keep(life.declare_subscriber(key, self._sampled(sign), history=True))
        for reply in life.get(_every(self.keys.alive), timeout=GREETING):
            if reply.ok is not None:
                self.inbox.put(Item("token", str(reply.ok.key_expr), True))
        self._publisher = session.declare_publisher(
            self.keys.to_all, congestion_control=zenoh.CongestionControl.BLOCK, express=True
        )
        self._keep(self._publisher)
        self._keep(life.declare_token(self.keys.alive))

    def end(self) -> None:
        """Be no longer there."""
        self._session.close()

    # -- out ------------------------------------------------------------------------------

    def send(self, to: str, message: Message) -> None:
        """Send a message to a robot, to everyone, or to anyone who is there."""
        if to == ANYONE:
            others = sorted(self.alive - {self.name})
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
        ended = [name for name, since in self._gone.items() if clock >= since + HOLD]
        for name in ended:
            del self._gone[name]
        return [Down(name) for name in ended]

    def events(self, clock: float, item: Item) -> list[Event]:
        """Return what an item of the queue says."""
        match item.what:
            case "all" | "to":
                return [self._message(item)]
            case "token":
                return self._token(clock, item)
            case "router" if not item.content:
                self._line_gone = True
            case "line":
                had = bool(self._lines)
                (self._lines.add if item.content else self._lines.discard)(item.key)
                self._line_gone |= had != bool(self._lines)
        return []

    def _message(self, item: Item) -> Event:
        """Return a message, or that it is none."""
        sender = item.key.rpartition("/")[2]
        self.traffic.received += 1
        self.traffic.received_bytes += len(item.content)
        dropped, self._dropped = self._dropped, 0
        if dropped:
            return Refuted(sender, f"is one of those that flood the network: {dropped} lost")
        fault = id_fault(sender)
        if fault:
            return Refuted("somebody", fault)
        try:
            return Received(sender, decode(item.content), item.what == "to")
        except MessageInvalid as error:
            return Refuted(sender, f"sends what is no message: {error.faults[0]}")

    def _token(self, clock: float, item: Item) -> list[Event]:
        """Return who is there, who may have ended, and who works on something else."""
        _, protocol, mission, _, name = item.key.split("/")
        if item.key != Keys(protocol, mission, name).alive or id_fault(name):
            return []
        if (protocol, mission) != (str(PROTOCOL), self.keys.mission):
            if not item.content or item.key in self._strangers:
                return []
            self._strangers.add(item.key)
            other = "" if protocol == str(PROTOCOL) else f" by protocol {protocol}"
            return [Stranger(name, f"{mission}{other}")]
        if name == self.name:
            return []
        if not item.content:
            self.alive.discard(name)
            self._gone.setdefault(name, clock)
            return []
        self._gone.pop(name, None)
        if name in self.alive:
            return []
        self.alive.add(name)
        if self._unsent is not None:
            unsent, self._unsent = self._unsent, None
            self.send(name, unsent)
        return [Up(name)]

    # -- called by Zenoh ------------------------------------------------------------------

    def _sampled(self, what: What) -> Callable[[zenoh.Sample], None]:
        """Return what takes samples of a kind."""
        is_token = what in {"token", "router"}

        def take(sample: zenoh.Sample) -> None:
            if self.inbox.qsize() >= MOST_WAITING:
                self._dropped += 1
                return
            is_there = sample.kind == zenoh.SampleKind.PUT
            content = is_there if is_token else sample.payload.to_bytes()
            if is_token or is_there:
                self.inbox.put(Item(what, str(sample.key_expr), content))

        return take

    def _lined(self, event: zenoh.TransportEvent) -> None:
        """Take that a line to another process is there, or gone."""
        is_there = event.kind == zenoh.SampleKind.PUT
        self.inbox.put(Item("line", str(event.transport.zid), is_there))

    def _asked(self, query: zenoh.Query) -> None:
        """Take a question for all records."""
        self.inbox.put(Item("asked", "", query))

    def _put(self, key: str, data: bytes) -> None:
        """Send bytes under a key."""
        block = zenoh.CongestionControl.BLOCK
        self._session.put(key, data, congestion_control=block, express=True)

    def _keep(self, declared: Any) -> None:
        """Hold on to something declared: it ends when it is forgotten."""
        self._kept.append(declared)


def _every(key: str) -> str:
    """Return a key with any robot at its end."""
    return f"{key.rpartition('/')[0]}/*"
