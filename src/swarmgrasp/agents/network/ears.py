"""What a process hears on the network, queued, and made events of by one thread.

Zenoh calls from threads of its own; what it calls here only puts something into the queue.
"""

from collections.abc import Callable
from dataclasses import dataclass
from queue import SimpleQueue
from typing import Any, Literal

import zenoh

from swarmgrasp.agents.network.keys import Keys
from swarmgrasp.agents.network.session import open_session
from swarmgrasp.agents.network.settings import NetworkSettings
from swarmgrasp.agents.protocol.events import Down, Received, Refuted, Stranger, Up
from swarmgrasp.agents.protocol.record import id_fault
from swarmgrasp.agents.protocol.wire import PROTOCOL, decode
from swarmgrasp.errors import MessageInvalid

MOST_WAITING = 100_000
"""Messages in the queue; more are dropped, and counted."""

What = Literal[
    "all", "to", "token", "router", "line", "asked", "told", "body", "wish", "end", "planned"
]
_SIGNS = ("token", "router")


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


class Ears:
    """One process's ears.

    Parameters
    ----------
    settings : NetworkSettings
    keys : Keys
        Of the mission that is listened to.
    """

    def __init__(self, settings: NetworkSettings, keys: Keys) -> None:
        self.inbox: SimpleQueue[Item] = SimpleQueue()
        self.session = open_session(settings)
        self._keys = keys
        self._kept: list[Any] = []
        self._strangers: set[str] = set()
        self._dropped = 0

    def close(self) -> None:
        """Hear nothing any longer."""
        self.session.close()

    def keep(self, declared: Any) -> None:
        """Hold on to something declared: it ends when it is forgotten."""
        self._kept.append(declared)

    def hear(self, what: What, key: str, *, own: bool = False) -> None:
        """Queue what is said under a key; what this process says itself only if asked."""
        origin = zenoh.Locality.ANY if own else zenoh.Locality.REMOTE
        take = self._taker(what)
        self.keep(self.session.declare_subscriber(key, take, allowed_origin=origin))

    def watch(self, what: What, key: str) -> None:
        """Queue whose tokens are there, and whose vanish."""
        life = self.session.liveliness()
        self.keep(life.declare_subscriber(key, self._taker(what), history=True))

    def watch_lines(self) -> None:
        """Queue which lines to other processes are there, and which are gone."""
        listener = self.session.info.declare_transport_events_listener(self._lined, history=True)
        self.keep(listener)

    def message(self, item: Item) -> Received | Refuted:
        """Return the message that an item holds, or that it holds none."""
        sender = item.key.rpartition("/")[2]
        fault = id_fault(sender)
        if fault:
            return Refuted("somebody", fault)
        dropped, self._dropped = self._dropped, 0
        if dropped:
            return Refuted(sender, f"is one of those that flood the network: {dropped} lost")
        try:
            return Received(sender, decode(item.content), item.what == "to")
        except MessageInvalid as error:
            return Refuted(sender, f"sends what is no message: {error.faults[0]}")

    def token(self, item: Item) -> Up | Down | Stranger | None:
        """Return whose token is there, or has vanished; None if it is of no concern."""
        _, protocol, mission, _, name = item.key.split("/")
        if item.key != Keys(protocol, mission, name).alive or id_fault(name):
            return None
        if item.key == Keys(self._keys.protocol, self._keys.mission, name).alive:
            return Up(name) if item.content else Down(name)
        if not item.content or item.key in self._strangers:
            return None
        self._strangers.add(item.key)
        other = "" if protocol == str(PROTOCOL) else f" by protocol {protocol}"
        return Stranger(name, f"{mission}{other}")

    # -- called by Zenoh ------------------------------------------------------------------

    def _taker(self, what: What) -> Callable[[zenoh.Sample], None]:
        """Return what takes samples of a kind."""

        def take_sign(sample: zenoh.Sample) -> None:
            is_there = sample.kind == zenoh.SampleKind.PUT
            self.inbox.put(Item(what, str(sample.key_expr), is_there))

        def take(sample: zenoh.Sample) -> None:
            if self.inbox.qsize() >= MOST_WAITING:
                self._dropped += 1
            elif sample.kind == zenoh.SampleKind.PUT:
                self.inbox.put(Item(what, str(sample.key_expr), sample.payload.to_bytes()))

        return take_sign if what in _SIGNS else take

    def _lined(self, event: zenoh.TransportEvent) -> None:
        """Take that a line to another process is there, or gone."""
        is_there = event.kind == zenoh.SampleKind.PUT
        self.inbox.put(Item("line", str(event.transport.zid), is_there))
