"""A listener on the network: it hears all that robots say, and says nothing that they heed."""

from collections.abc import Iterator
from queue import Empty

import zenoh

from swarmgrasp.agents.network.ears import Ears, Item
from swarmgrasp.agents.network.keys import ALL_ALIVE, Keys, own_keys
from swarmgrasp.agents.network.settings import NetworkSettings
from swarmgrasp.agents.protocol.events import Event

ANSWER = 2.0
"""How long an answer is waited for [s]."""


class Listener:
    """A process that listens and is no robot.

    Parameters
    ----------
    settings : NetworkSettings
    mission : str
        Digest of the mission.
    """

    def __init__(self, settings: NetworkSettings, mission: str) -> None:
        keys = own_keys(mission, "*")
        self._keys = keys
        self._ears = Ears(settings, keys)
        self._ears.hear("all", keys.to_all)
        self._ears.hear("to", keys.to("*"))
        self._ears.watch("token", ALL_ALIVE)

    def close(self) -> None:
        """Hear nothing any longer."""
        self._ears.close()

    def events(self, seconds: float) -> Iterator[Event]:
        """Return what is heard, waiting for it at most for so many seconds."""
        inbox = self._ears.inbox
        try:
            items = [inbox.get(timeout=seconds)]
        except Empty:
            return
        while not inbox.empty():
            items.append(inbox.get_nowait())
        for item in items:
            event = self._ears.token(item) if item.what == "token" else self._ears.message(item)
            if event is not None:
                yield event

    def ask(self, name: str) -> None:
        """Ask a robot for all it knows; what it answers is heard as if it had told everyone."""
        keys = Keys(self._keys.protocol, self._keys.mission, name)

        def take(reply: zenoh.Reply) -> None:
            if reply.ok is not None:
                self._ears.inbox.put(Item("all", keys.to_all, reply.ok.payload.to_bytes()))

        self._ears.session.get(keys.records, take, timeout=ANSWER)
