"""One window: its key, its messages, and what it is told."""

import asyncio
from dataclasses import dataclass
from typing import Any

import msgspec
from starlette.websockets import WebSocket, WebSocketDisconnect

from swarmgrasp.gui.desk import Desk
from swarmgrasp.gui.guard import (
    HELLO_WITHIN,
    MOST_WINDOWS,
    OTHER_PROTOCOL,
    TOO_MANY,
    WRONG_KEY,
    Bucket,
    Guard,
)
from swarmgrasp.gui.messages import PROTOCOL, Ask, Cancel, Control, Hello, Watch, read_message
from swarmgrasp.gui.replies import Error, Welcome
from swarmgrasp.gui.sending import write_message

FLOODED = "Too many messages at once: some were dropped."


@dataclass(frozen=True)
class Session:
    """What windows are served with."""

    guard: Guard
    desk: Desk
    welcome: Welcome

    async def serve(self, socket: WebSocket) -> None:
        """Serve one window to its end."""
        if len(self.desk) >= MOST_WINDOWS:
            await socket.accept()
            await socket.close(TOO_MANY, f"at most {MOST_WINDOWS} windows")
            return
        await socket.accept()
        try:
            if not await self._is_known(socket):
                return
        except WebSocketDisconnect:
            return
        window = self.desk.join(lambda frame: _send(socket, frame))
        try:
            await _send(socket, write_message(self.welcome))
            await self._listen(socket, window)
        except WebSocketDisconnect:
            pass
        finally:
            self.desk.leave(window)

    async def _is_known(self, socket: WebSocket) -> bool:
        """Tell whether a window shows the key in time; else end it."""
        try:
            raw = await asyncio.wait_for(_received(socket), HELLO_WITHIN)
            message: Any = read_message(raw)
        except (TimeoutError, msgspec.DecodeError, RecursionError):
            message = None
        if not isinstance(message, Hello) or not self.guard.knows_key(message.key):
            await socket.close(WRONG_KEY, "the key is wrong, or of a server that has ended")
            return False
        if message.protocol != PROTOCOL:
            await socket.close(OTHER_PROTOCOL, "the page is of another version: load it anew")
            return False
        return True

    async def _listen(self, socket: WebSocket, window: int) -> None:
        """Take the messages of a window."""
        bucket, is_flooded = Bucket(), False
        now = asyncio.get_running_loop().time
        while True:
            raw = await _received(socket)
            if not bucket.take(now()):
                if not is_flooded:
                    await _send(socket, write_message(Error(None, FLOODED)))
                is_flooded = True
                continue
            is_flooded = False
            try:
                message = read_message(raw)
            except (msgspec.DecodeError, RecursionError) as error:
                await _send(socket, write_message(Error(None, f"Not understood: {error}")))
                continue
            await self._take(window, message)

    async def _take(self, window: int, message: Any) -> None:
        """Take a message; no other is read before the window has taken the word for it."""
        if isinstance(message, Ask):
            self.desk.ask(window, message)
        elif isinstance(message, Cancel):
            self.desk.cancel(window)
        elif isinstance(message, Watch):
            self.desk.watch(window, message)
        elif isinstance(message, Control):
            self.desk.order(message)
        elif type(message) in self.desk.errands:
            await self.desk.errand(window, message)
        else:
            await self.desk.refuse(window, message)


async def _received(socket: WebSocket) -> str | bytes:
    """Return the next message."""
    event = await socket.receive()
    if event["type"] == "websocket.disconnect":
        raise WebSocketDisconnect(event.get("code", 1000))
    text = event.get("text")
    raw: str | bytes = event["bytes"] if text is None else text
    return raw


async def _send(socket: WebSocket, frame: bytes) -> None:
    """Send a frame: JSON as text, all else as it is; to a window that has gone, nothing."""
    try:
        if frame[:1] == b"{":
            await socket.send_text(frame.decode())
        else:
            await socket.send_bytes(frame)
    except (RuntimeError, WebSocketDisconnect):
        pass
