"""Where all windows are served: turns are taken here, and jobs run in threads."""

import asyncio
import itertools
import logging
from collections.abc import Awaitable, Callable, Coroutine
from concurrent.futures import ThreadPoolExecutor
from contextlib import suppress
from dataclasses import dataclass
from time import thread_time
from typing import TYPE_CHECKING, Any

from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.gui.asking import Found, ask
from swarmgrasp.gui.errands import Errand
from swarmgrasp.gui.messages import Ask, Control, Watch
from swarmgrasp.gui.parts import FINER, MOVING, NAMED, PARTS, Sheet, tell
from swarmgrasp.gui.reading import question_of
from swarmgrasp.gui.replies import Done, Error, Refused
from swarmgrasp.gui.scenes import faults_in
from swarmgrasp.gui.sending import write_message
from swarmgrasp.gui.telling import Telling
from swarmgrasp.gui.turns import ANSWER, Job, Turns

if TYPE_CHECKING:
    from swarmgrasp.gui.live import Live, To

NOT_HERE = "This cannot be asked here."
WORKERS = 3
"""Jobs at once: an answer, an errand and a part; more would only wait for each other."""
logger = logging.getLogger(__name__)

Send = Callable[[bytes], Awaitable[None]]


@dataclass
class Work:
    """An ask, and what was found of it."""

    ask: Ask
    found: Found | None = None


class Desk:
    """Serves all windows.

    Parameters
    ----------
    errands : mapping of type to callable
        What answers a message that is no ask, in a thread.
    live : Live, optional
        Agents to watch.
    """

    def __init__(self, errands: dict[type, Errand], live: "Live | None" = None) -> None:
        self.live = live
        self._watching: dict[int, bool] = {}  # whether they know all that has been told
        self._reading: set[int] = set()  # those to which something is on its way
        self.turns = Turns(WORKERS, FINER)
        self.errands = errands
        self._pool = ThreadPoolExecutor(WORKERS, thread_name_prefix="studio")
        self._sends: dict[int, Send] = {}
        self._numbers = itertools.count(1)
        self._running: set[asyncio.Task[None]] = set()

    def __len__(self) -> int:
        """Return the number of windows."""
        return len(self._sends)

    def join(self, send: Send) -> int:
        """Take up a window; return its number."""
        number = next(self._numbers)
        self._sends[number] = send
        self.turns.join(number)
        return number

    def leave(self, window: int) -> None:
        """Forget a window."""
        self._sends.pop(window, None)
        self._watching.pop(window, None)
        self.turns.leave(window)

    def ask(self, window: int, message: Ask) -> None:
        """Take an ask of a window."""
        wanted = list(MOVING if message.moving else PARTS)
        if message.wants is not None:
            wanted = [part for part in wanted if NAMED.get(part, part) in message.wants]
        self.turns.ask(window, Work(message), message.moving, wanted)
        self.pump()

    def cancel(self, window: int) -> None:
        """Leave the parts of a window's ask that are not begun."""
        self.turns.cancel(window)
        self.pump()

    async def errand(self, window: int, message: Any) -> None:
        """Take any other message of a window that is computed."""
        overtaken = self.turns.errand(window, type(message).__name__, message)
        self.pump()
        if overtaken is not None:
            await self._send(window, write_message(Done(overtaken.n)))

    async def refuse(self, window: int, message: Any) -> None:
        """Say of a message that nobody here answers it."""
        if hasattr(message, "n"):
            await self._send(window, write_message(Error(message.n, NOT_HERE)))

    def watch(self, window: int, message: Watch) -> None:
        """Begin to tell a window of the agents, or end it."""
        if not message.on or self.live is None:
            self._watching.pop(window, None)
            return
        self._watching[window] = False
        self._tell_new(self.live)

    def _tell_new(self, live: "Live") -> None:
        """Have all that is known told to those that know nothing yet."""
        loop = asyncio.get_running_loop()

        def tell(frame: bytes, to: "To") -> None:
            """Tell those that watch, from any thread."""
            with suppress(RuntimeError):  # the loop has ended, and with it all windows
                loop.call_soon_threadsafe(self._spread, frame, to)

        live.begin(tell)

    def order(self, message: Control) -> None:
        """Do something to an agent of a demonstration."""
        if self.live is not None:
            self.live.order(message)

    def _spread(self, frame: bytes, to: "To") -> None:
        """Tell windows that watch; one that has not taken the last frame is told all anew then."""
        for window, knows in self._watching.items():
            if to != "all" and knows is not (to == "old"):
                continue
            if window in self._reading:
                self._watching[window] = False
                continue
            self._watching[window] = knows or to == "new"
            self._reading.add(window)
            self._start(self._show(window, frame))

    async def _show(self, window: int, frame: bytes) -> None:
        """Send a window what is told of the agents."""
        await self._send(window, frame)
        self._reading.discard(window)
        if self.live is not None and self._watching.get(window) is False:
            self._tell_new(self.live)

    def pump(self) -> None:
        """Begin whatever may begin, and say to windows that all of what they asked is told."""
        loop = asyncio.get_running_loop()
        while (job := self.turns.next(loop.time())) is not None:
            self._start(self._run(job))
        for window, work in self.turns.finished():
            self._start(self._send(window, write_message(Done(work.ask.n))))

    def _start(self, doing: Coroutine[Any, Any, None]) -> None:
        """Begin something, and keep it until it is done."""
        task = asyncio.get_running_loop().create_task(doing)
        self._running.add(task)
        task.add_done_callback(self._running.discard)

    async def _run(self, job: Job) -> None:
        """Compute a job, send what came of it, and go on; others go on before it is taken."""
        loop = asyncio.get_running_loop()
        cost = 0.0
        try:
            frame, cost = await loop.run_in_executor(self._pool, self._computed, job)
        finally:
            self.turns.finish(job, cost, loop.time())
        if job.kind == ANSWER and job.work.found is None:
            self.turns.refuse(job.window)
        self.pump()
        await self._send(job.window, frame)
        self.turns.take(job)
        self.pump()

    async def _send(self, window: int, frame: bytes) -> None:
        """Send to a window, if it is still there."""
        send = self._sends.get(window)
        if send is not None and frame:
            await send(frame)

    def _computed(self, job: Job) -> tuple[bytes, float]:
        """Compute a job in a thread; return the frame, and the thread time [s] that it took."""
        start = thread_time()
        try:
            frame = self._frame(job, start)
        except Exception:  # a fault of ours: the window lives on
            logger.exception("%s failed", job.kind)
            n = job.work.n if job.is_errand else job.work.ask.n
            frame = write_message(Error(n, f"This could not be done: {job.kind} failed."))
        return frame, thread_time() - start

    def _frame(self, job: Job, start: float) -> bytes:
        """Return what a job gives."""

        def spent() -> float:
            """Return the milliseconds of thread time so far."""
            return 1e3 * (thread_time() - start)

        if job.is_errand:
            return self._errand(job.work)
        work: Work = job.work
        if job.kind == ANSWER:
            return self._answer(work, spent)
        if work.found is None:
            return b""
        sheet = Sheet(work.ask.n, work.found, lambda: self.turns.is_overtaken(job.window, work))
        return tell(job.kind, sheet, spent)

    def _errand(self, message: Any) -> bytes:
        """Do an errand."""
        try:
            return self.errands[type(message)](message)
        except SwarmGraspError as error:
            if hasattr(message, "doc"):
                return write_message(Refused(message.n, faults_in(error.faults)))
            return write_message(Error(message.n, error.faults[0]))

    def _answer(self, work: Work, spent: Callable[[], float]) -> bytes:
        """Answer an ask."""
        try:
            question = question_of(work.ask.doc, work.ask.speech)
            work.found = ask(question, None if work.ask.moving else 0.0)
        except SwarmGraspError as error:
            return write_message(Refused(work.ask.n, faults_in(error.faults)))
        return write_message(Telling(work.found).part(work.ask.n, spent()))

    def close(self) -> None:
        """End the threads."""
        self._pool.shutdown(wait=False, cancel_futures=True)
        if self.live is not None:
            self.live.end()
