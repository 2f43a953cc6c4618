"""The server of the page: a few files, and one socket."""

import contextlib
import functools
import gzip
import logging
import socket as sockets
from collections.abc import AsyncIterator, Callable, Iterator, Mapping
from dataclasses import dataclass, field
from importlib.metadata import version
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING

import uvicorn
from starlette.applications import Starlette
from starlette.datastructures import Headers
from starlette.requests import Request
from starlette.responses import PlainTextResponse, Response
from starlette.routing import Route, WebSocketRoute
from starlette.types import ASGIApp, Receive, Scope, Send

from swarmgrasp.gui.desk import Desk
from swarmgrasp.gui.errands import Reporting, errands_of
from swarmgrasp.gui.guard import HEADERS, LIMITS, MOST_BYTES, Guard, new_key
from swarmgrasp.gui.messages import PROTOCOL
from swarmgrasp.gui.replies import Welcome
from swarmgrasp.gui.scenes import Source, titles
from swarmgrasp.gui.session import Session

if TYPE_CHECKING:
    from swarmgrasp.gui.live import Live
    from swarmgrasp.gui.runs import Recorded

LOOPBACK = ("127.0.0.1", "localhost", "[::1]")
TYPES = {
    ".html": "text/html; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".woff2": "font/woff2",
    ".svg": "image/svg+xml",
}
"""What files of the page are, by their suffix; no others are sent."""
PACKED = {"content-encoding": "gzip"}
ENDING = 2
"""Seconds that windows have to close when the server ends."""


@dataclass(frozen=True)
class Settings:
    """What is served.

    Attributes
    ----------
    scenes : mapping of str to Source
    opens : str
        The scene that a window opens with.
    host : str
        The address to listen at.
    port : int
        0 for any that is free.
    reporting : callable, optional
        Makes the sheet about a job.
    run : Recorded, optional
        A run to play.
    live : Live, optional
        Agents to watch.
    certificate, private_key : Path, optional
        Files of TLS.
    """

    scenes: Mapping[str, Source]
    opens: str
    host: str = "127.0.0.1"
    port: int = 0
    reporting: Reporting | None = None
    run: "Recorded | None" = None
    live: "Live | None" = None
    certificate: Path | None = None
    private_key: Path | None = None
    key: str = field(default_factory=new_key, repr=False)

    @property
    def scheme(self) -> str:
        """How it is asked."""
        return "http" if self.certificate is None else "https"


class _Guarded:
    """Refuses what does not name this server, or comes from another site's page."""

    def __init__(self, app: ASGIApp, guard: Guard) -> None:
        self.app, self.guard = app, guard

    async def __call__(self, scope: Scope, receive: Receive, send: Send) -> None:
        """Serve a request, or refuse it."""
        if scope["type"] == "lifespan":
            await self.app(scope, receive, send)
            return
        headers = Headers(scope=scope)
        refusal = self._refusal(scope["type"], headers)
        if refusal is None:
            await self.app(scope, receive, send)
        elif scope["type"] == "http":
            await refusal(scope, receive, send)
        else:
            await send({"type": "websocket.close", "code": 1008, "reason": ""})

    def _refusal(self, kind: str, headers: Headers) -> Response | None:
        """Return why a request is refused; None if it is not."""
        if not self.guard.knows_host(headers.get("host")):
            return PlainTextResponse("This server has another name.\n", 421, HEADERS)
        if headers.get("sec-fetch-site") in {"cross-site", "same-site"}:
            return PlainTextResponse("Not for pages of other sites.\n", 403, HEADERS)
        if kind == "websocket" and not self.guard.knows_origin(headers.get("origin")):
            return PlainTextResponse("Not for pages of other sites.\n", 403, HEADERS)
        return None


@dataclass(frozen=True)
class PageFile:
    """A file of the page: its content and its kind."""

    raw: bytes
    kind: str

    def response(self, encodings: str) -> Response:
        """Return the file, packed for those that can unpack it; fonts are packed already."""
        headers = {**HEADERS, "content-type": self.kind, "vary": "accept-encoding"}
        if "gzip" in encodings and not self.kind.startswith("font/"):
            return Response(self._packed, headers=headers | PACKED)
        return Response(self.raw, headers=headers)

    @functools.cached_property
    def _packed(self) -> bytes:
        """The content packed, once it is asked for: the link need not wait for that."""
        return gzip.compress(self.raw, mtime=0)


def page_files() -> dict[str, PageFile]:
    """Return the files of the page by their paths."""
    found = {}
    for file in (files("swarmgrasp.gui") / "page").iterdir():
        kind = TYPES.get("." + file.name.rpartition(".")[2])
        if kind is not None:
            found[f"/{file.name}"] = PageFile(file.read_bytes(), kind)
    if "/index.html" in found:
        found["/"] = found["/index.html"]
    return found


def _sent(file: PageFile) -> Callable[[Request], Response]:
    """Return what sends a file."""
    return lambda request: file.response(request.headers.get("accept-encoding", ""))


def _named(host: str) -> str:
    """Return an address or a name as links have it."""
    return f"[{host}]" if ":" in host else host.lower()


def _hosts(settings: Settings, port: int) -> frozenset[str]:
    """Return the names under which the server is asked, each with its port if it is told."""
    names = {*LOOPBACK, _named(settings.host)}
    usual = port == (80 if settings.certificate is None else 443)
    return frozenset(f"{name}:{port}" for name in names) | (names if usual else set())


def application(settings: Settings, port: int) -> Starlette:
    """Return the application that is served at a port."""
    guard = Guard(_hosts(settings, port), settings.scheme, settings.key)
    served = settings.scenes, settings.opens, settings.reporting, settings.run
    desk = Desk(errands_of(*served), settings.live)
    welcome = Welcome(
        PROTOCOL, version("swarmgrasp"), LIMITS,
        titles(settings.scenes), settings.opens,
        None if settings.run is None else settings.run.name, watch=settings.live is not None,
        demonstration=settings.live is not None and settings.live.is_demonstration,
        reports=settings.reporting is not None,
    )  # fmt: skip
    session = Session(guard, desk, welcome)

    routes = [Route(path, _sent(file)) for path, file in page_files().items()]

    @contextlib.asynccontextmanager
    async def lifespan(app: Starlette) -> AsyncIterator[None]:  # noqa: ARG001
        """End the threads with the server."""
        yield
        desk.close()

    app = Starlette(routes=[*routes, WebSocketRoute("/ws", session.serve)], lifespan=lifespan)
    app.add_middleware(_Guarded, guard=guard)
    return app


class Server(uvicorn.Server):
    """A server that leaves signals to who starts it."""

    @contextlib.contextmanager
    def capture_signals(self) -> Iterator[None]:
        """Capture none."""
        yield


@dataclass(frozen=True)
class Opened:
    """A server that listens, and is not yet served.

    Attributes
    ----------
    server : Server
    socket : socket
    link : str
        With the key in its fragment.
    """

    server: Server
    socket: sockets.socket
    link: str

    def run(self) -> None:
        """Serve until told to end."""
        self.server.run(sockets=[self.socket])

    def end(self) -> None:
        """End; may be called from a signal's handler."""
        self.server.should_exit = True


def _told_plainly(record: logging.LogRecord) -> bool:
    """Leave out where in the program a client's text was found to be none: it is not its fault."""
    if record.exc_info is not None and isinstance(record.exc_info[1], UnicodeDecodeError):
        record.exc_info = None
    return True


def opened(settings: Settings) -> Opened:
    """Listen.

    Raises
    ------
    OSError
        If the port is taken, or the address not this machine's.
    """
    family = sockets.AF_INET6 if ":" in settings.host else sockets.AF_INET
    listening = sockets.create_server((settings.host, settings.port), family=family)
    # those it accepts inherit this: an answer must not wait for the last one's acknowledgement
    listening.setsockopt(sockets.IPPROTO_TCP, sockets.TCP_NODELAY, 1)
    port = listening.getsockname()[1]
    config = uvicorn.Config(
        application(settings, port), log_level="warning", access_log=False, server_header=False,
        ws="websockets-sansio", ws_max_size=MOST_BYTES, ws_per_message_deflate=False,
        timeout_graceful_shutdown=ENDING, ssl_certfile=settings.certificate,
        ssl_keyfile=settings.private_key,
    )  # fmt: skip
    logging.getLogger("uvicorn.error").addFilter(_told_plainly)
    link = f"{settings.scheme}://{_named(settings.host)}:{port}/#k={settings.key}"
    return Opened(Server(config), listening, link)
