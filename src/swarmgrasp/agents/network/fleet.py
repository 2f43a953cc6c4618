"""Many processes on this machine: started, heard, stopped and killed, for demos and trials."""

import json
import os
import selectors
import signal
import socket
import sys
import time
from collections.abc import Callable, Iterable, Sequence
from contextlib import suppress
from dataclasses import dataclass, field
from multiprocessing import get_context
from multiprocessing.connection import Connection
from multiprocessing.context import ForkServerProcess
from threading import Condition, Thread
from typing import Any, Self

import zenoh

from swarmgrasp.agents.network.keys import own_keys
from swarmgrasp.agents.network.process import steady_clock
from swarmgrasp.agents.network.session import open_session
from swarmgrasp.agents.network.settings import NetworkSettings
from swarmgrasp.errors import NetworkFailed

Main = Callable[[Sequence[str]], int]
NEEDED = ("swarmgrasp.agents.network", "swarmgrasp.scenario")
"""What robots' processes import as they start."""
PATIENCE = 120.0
"""How long something is waited for unless told otherwise [s]."""
LONGEST_END = 5.0
"""How long a process may take to end [s]."""
MOST_WORDS = 5
"""Last words of a process that are told when something does not happen."""


@dataclass
class Member:
    """One process.

    Attributes
    ----------
    name : str
    process : Process
    is_router : bool
    told : list of dict
        What it has told so far, in this life and before.
    words : list of str
        What it has said that was no JSON: its complaints.
    record : dict
        What it says of itself.
    heard : dict
        What it knows of others, by name.
    sees : set of str
        Whose process it knows to be there.
    """

    name: str
    process: ForkServerProcess
    is_router: bool = False
    told: list[dict[str, Any]] = field(default_factory=list)
    words: list[str] = field(default_factory=list)
    record: dict[str, Any] = field(default_factory=dict)
    heard: dict[str, dict[str, Any]] = field(default_factory=dict)
    sees: set[str] = field(default_factory=set)

    @property
    def phase(self) -> str:
        """Where it is on its way."""
        return str(self.record.get("phase", ""))

    def take(self, told: dict[str, Any]) -> None:
        """Take what it tells."""
        self.told.append(told)
        match told:
            case {"record": record}:
                self.record = record
            case {"heard": record}:
                self.heard[record["name"]] = record
            case {"up": name}:
                self.sees.add(name)
            case {"down": name}:
                self.sees.discard(name)

    def reports(self, what: str) -> list[str]:
        """Return what it has reported of a kind."""
        return [each["words"] for each in self.told if each.get("report") == what]


class Fleet:
    """Processes of robots and routers; all are ended with it.

    They are forked from one that has imported what they need: a hundred of them start in seconds.

    Parameters
    ----------
    main : callable
        Runs this program with the words of a command line; one that can be imported by its name.
    """

    def __init__(self, main: Main) -> None:
        self._main = main
        self._context = get_context("forkserver")
        self._context.set_forkserver_preload([main.__module__, *NEEDED])
        self.members: dict[str, Member] = {}
        self._news = Condition()
        self._selector = selectors.DefaultSelector()
        self._ends = False
        self._waker, waking = socket.socketpair()
        self._selector.register(waking, selectors.EVENT_READ, None)
        self._reader = Thread(target=self._read, daemon=True)
        self._reader.start()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.end()

    def start(self, name: str, *options: object, file: str | None = None) -> Member:
        """Start a robot's process, or, without a file, a router's."""
        who = ["--router"] if file is None else [file, "--name", name]
        words = ["agent", *who, "--json", *map(str, options)]
        reading, writing = self._context.Pipe(duplex=False)
        process = self._context.Process(target=_be, args=(self._main, words, writing), daemon=True)
        process.start()
        writing.close()
        before = self.members.get(name)
        member = Member(name, process, file is None, before.told if before else [])
        self.members[name] = member
        os.set_blocking(reading.fileno(), False)
        self._selector.register(reading, selectors.EVENT_READ, (member, reading, bytearray()))
        self._waker.send(b".")
        return member

    def kill(self, name: str) -> float:
        """Kill a process with signal 9; return when [s]."""
        process = self.members[name].process
        when = steady_clock()
        process.kill()
        process.join()
        return when

    def signal(self, name: str, number: int) -> float:
        """Send a signal to a process; return when [s]."""
        when = steady_clock()
        _send(self.members[name].process, number)
        return when

    def wait(
        self, happens: Callable[[], bool], what: str, *, patience: float = PATIENCE,
        beside: Iterable[str] = (),
    ) -> None:  # fmt: skip
        """Wait until something happens.

        Parameters
        ----------
        happens : callable
            Looked at whenever a process has told something.
        what : str
            What is waited for, for when it does not happen.
        patience : float [s]
        beside : iterable of str
            Processes that may end meanwhile.

        Raises
        ------
        NetworkFailed
            If it does not happen, or a process ends that should not.
        """
        until = time.monotonic() + patience
        with self._news:
            while not happens():
                ended = [m for m in self.members.values()
                         if m.process.exitcode not in {None, -signal.SIGKILL}
                         and m.name not in beside]  # fmt: skip
                left = until - time.monotonic()
                if ended or left <= 0.0:
                    raise NetworkFailed(self._lament(what, ended))
                self._news.wait(min(left, 1.0))

    def end(self) -> None:
        """End all processes: the robots', then the routers that they speak through."""
        if self._ends:
            return
        for routers in (False, True):
            ending = [m.process for m in self.members.values() if m.is_router is routers]
            for process in ending:
                for number in (signal.SIGCONT, signal.SIGTERM):
                    _send(process, number)
            until = time.monotonic() + LONGEST_END
            for process in ending:
                process.join(max(0.0, until - time.monotonic()))
                if process.is_alive():
                    process.kill()
                    process.join()
        self._ends = True
        self._waker.send(b".")
        self._reader.join()
        self._selector.close()
        self._waker.close()

    def _lament(self, what: str, ended: Sequence[Member]) -> list[str]:
        """Return what did not happen, and what the processes said last."""
        faults = [f"{what} did not happen"]
        for member in ended or self.members.values():
            last = [each.get("words", "") for each in member.told if "words" in each]
            words = "; ".join([*last, *member.words][-MOST_WORDS:])
            state = f"ended with status {member.process.exitcode}" if member in ended else "runs"
            faults.append(f"{member.name} {state}, {member.phase or 'of no phase'}: {words}")
        return faults

    def _read(self) -> None:
        """Take what processes tell, until the end."""
        while not self._ends:
            for key, _ in self._selector.select():
                if key.data is None:
                    os.read(key.fd, 64)
                else:
                    self._take(*key.data)
        for key in list(self._selector.get_map().values()):
            with suppress(OSError):
                key.fileobj.close()  # type: ignore[union-attr]

    def _take(self, member: Member, stream: Connection, rest: bytearray) -> None:
        """Take what a process has told."""
        try:
            data = os.read(stream.fileno(), 1 << 16)
        except BlockingIOError:
            return
        if not data:
            self._selector.unregister(stream)
            stream.close()
        rest += data
        *lines, last = rest.split(b"\n")
        rest[:] = last
        with self._news:
            for line in lines:
                try:
                    member.take(json.loads(line))
                except ValueError:
                    member.words.append(line.decode("utf-8", "replace"))
            self._news.notify_all()


def _be(main: Main, words: list[str], telling: Connection) -> None:
    """Be a process that runs a command; what it prints is told."""
    for descriptor in (1, 2):
        os.dup2(telling.fileno(), descriptor)
    telling.close()
    # the streams as they were forked may believe that they are files
    sys.stdout = os.fdopen(1, "w", encoding="utf-8", closefd=False)
    sys.stderr = os.fdopen(2, "w", encoding="utf-8", closefd=False)
    sys.exit(main(words))


def _send(process: ForkServerProcess, number: int) -> None:
    """Send a signal to a process, if it is there."""
    if process.pid is not None and process.is_alive():
        with suppress(ProcessLookupError):
            os.kill(process.pid, number)


def ask(router: str, mission: str, names: Iterable[str], event: str) -> None:
    """Tell robots behind a router of an event without more to say, as "join"."""
    session = open_session(NetworkSettings(mode="client", connect=(router,)))
    block = zenoh.CongestionControl.BLOCK  # a busy router would drop some otherwise
    for name in names:
        told = json.dumps({"event": event})
        session.put(own_keys(mission, name).event, told, congestion_control=block)
    session.close()


def free_ports(count: int) -> list[int]:
    """Return ports of this machine that nobody listens at."""
    sockets = [socket.socket() for _ in range(count)]
    try:
        for each in sockets:
            each.bind(("127.0.0.1", 0))
        return [each.getsockname()[1] for each in sockets]
    finally:
        for each in sockets:
            each.close()
