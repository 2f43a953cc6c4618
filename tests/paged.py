"""A page's server in a thread, and windows that speak to it without a browser."""

import json
import struct
import threading
from collections.abc import Iterator
from contextlib import ExitStack, contextmanager
from socket import create_connection
from typing import Any

import numpy as np
from websockets.sync.client import ClientConnection, connect

from swarmgrasp.gui.messages import PROTOCOL
from swarmgrasp.gui.scenes import built_in
from swarmgrasp.gui.server import Opened, Settings, opened

CROWDS = (600, 10_000)
"""Robots of the scenes that have many."""
ANSWERED_WITHIN = 60.0
"""Seconds after which an answer that does not come is a failure."""


def crowd(count: int) -> str:
    """Return the text of a hull with so many robots round it."""
    edges = "edges: [starboard side, bow, port side, stern]"
    hull = f"outline: {{vertices: [[-120, -21], [120, -21], [120, 21], [-120, 21]], {edges}}}"
    rows = [
        f"  - {{at: {(i + 0.5) * 564 / count:.3f}, direction: inward, limit: {1 + i % 3}}}"
        for i in range(count)
    ]
    newcomer = "newcomer: {name: Idunn, limit: 50, attachment: push, half_angle: 30}"
    units = "units: {length: m, force: kN, angle: deg}"
    return "\n".join([f"name: Crowd of {count}", units, hull, "robots:", *rows, newcomer])


@contextmanager
def served(**more: Any) -> Iterator[Opened]:
    """Serve the built-in scenes on a port that the system chooses, to the end of the block."""
    serving = opened(Settings(built_in(), "escort-ring", **more))
    thread = threading.Thread(target=serving.run)
    thread.start()
    try:
        yield serving
    finally:
        serving.end()
        thread.join(ANSWERED_WITHIN)
        assert not thread.is_alive()


def address(serving: Opened) -> str:
    """Return where it listens, as http."""
    return serving.link.partition("/#")[0]


class Window:
    """One window: a socket that counts its messages."""

    def __init__(self, serving: Opened, **more: Any) -> None:
        base, _, key = serving.link.partition("/#k=")
        given = {"origin": base, **more}
        host, _, port = base.rpartition("//")[2].rpartition(":")
        line = create_connection((host, int(port)))  # our own: it goes past any proxy
        opening = connect(base.replace("http", "ws", 1) + "/ws", sock=line, max_size=None, **given)
        self._open = ExitStack()
        self.socket: ClientConnection = self._open.enter_context(opening)
        self.key, self.n = key, 0

    def hello(self, key: str | None = None, protocol: int = PROTOCOL) -> dict[str, Any]:
        """Show the key; return the welcome."""
        self.say(kind="hello", key=self.key if key is None else key, protocol=protocol)
        return self.told()

    def say(self, **message: Any) -> None:
        """Send a message."""
        self.socket.send(json.dumps(message))

    def request(self, **message: Any) -> dict[str, Any]:
        """Send a message with the next number; return the first reply."""
        self.n += 1
        self.say(n=self.n, **message)
        return self.told()

    def told(self) -> dict[str, Any]:
        """Return the next message, with the arrays of a binary one under their names."""
        raw = self.socket.recv(timeout=ANSWERED_WITHIN)
        return json.loads(raw) if isinstance(raw, str) else unframed(raw)

    def scene(self, name: str) -> dict[str, Any]:
        """Open a scene."""
        return self.request(kind="open", name=name)

    def ask(self, scene: dict[str, Any], **more: Any) -> dict[str, dict[str, Any]]:
        """Ask of a scene's document; return all parts, the last one of each name."""
        given = {"moving": False, "doc": scene["doc"], "speech": scene["speech"], **more}
        found: dict[str, dict[str, Any]] = {}
        told = self.request(kind="ask", **given)
        while told["kind"] not in ("done", "refused"):
            found[told.get("name") or told["of"]] = told
            told = self.told()
        assert told["n"] == self.n
        return found | {told["kind"]: told}

    def __enter__(self) -> "Window":
        """Return the window."""
        return self

    def __exit__(self, *_: object) -> None:
        """Close the window."""
        self._open.close()


def unframed(raw: bytes) -> dict[str, Any]:
    """Take a binary frame apart."""
    (length,) = struct.unpack_from("<I", raw)
    head: dict[str, Any] = json.loads(raw[4 : 4 + length])
    start = 4 + length
    for array in head.pop("arrays"):
        assert start % 8 == 0
        kind = np.dtype(array["type"]).newbyteorder("<")
        count = int(np.prod(array["shape"]))
        head[array["name"]] = np.frombuffer(raw, kind, count, start).reshape(array["shape"])
        start += -(-count * kind.itemsize // 8) * 8
    assert start == len(raw)
    return head
