"""The desk without a server: windows that are slow to read, and the word that ends an ask."""

import asyncio
import json
from collections.abc import Coroutine
from concurrent.futures import ThreadPoolExecutor
from typing import Any, cast

import msgspec
import pytest

from paged import ANSWERED_WITHIN
from swarmgrasp.gui.desk import Desk
from swarmgrasp.gui.live import Live, Tell, To
from swarmgrasp.gui.messages import Ask, Watch
from swarmgrasp.gui.scenes import built_in, scene_of


@pytest.fixture(scope="module")
def asked() -> Ask:
    scene = scene_of(0, "deck-barge", built_in()["deck-barge"])
    return Ask(1, True, scene.doc, scene.speech, wants=("losses",))


def run(play: Coroutine[Any, Any, None]) -> None:
    """Play in a thread of its own: where browsers are tried, this one has a loop already."""
    with ThreadPoolExecutor(1) as pool:
        pool.submit(asyncio.run, play).result()


class Reader:
    """A window that takes what it is sent when it is let."""

    def __init__(self, *, reads: bool) -> None:
        self.frames: list[dict[str, Any]] = []
        self.reads, self.took = asyncio.Event(), asyncio.Event()
        if reads:
            self.reads.set()

    async def send(self, frame: bytes) -> None:
        """Take a frame."""
        await self.reads.wait()
        self.frames.append(json.loads(frame))
        self.took.set()

    async def hears(self, times: int = 1, **wanted: Any) -> None:
        """Wait for frames that say something."""
        async with asyncio.timeout(ANSWERED_WITHIN):
            while sum(wanted.items() <= frame.items() for frame in self.frames) < times:
                self.took.clear()
                await self.took.wait()


def test_a_window_that_does_not_read_keeps_no_other_waiting(asked: Ask) -> None:
    """Its frames lie where they are; another is answered, wholly and again."""

    async def play() -> None:
        desk = Desk({})
        slow, quick = Reader(reads=False), Reader(reads=True)
        first, second = desk.join(slow.send), desk.join(quick.send)
        for n in (1, 2):
            desk.ask(first, msgspec.structs.replace(asked, n=n))
            desk.ask(second, msgspec.structs.replace(asked, n=n))
            await quick.hears(kind="done", n=n)
        assert slow.frames == []
        slow.reads.set()
        await slow.hears(kind="done", n=2)
        desk.close()

    run(play())


def test_an_ask_of_which_all_parts_are_left_out_is_ended_all_the_same(asked: Ask) -> None:
    """In a gesture, where what it wants would take more than its share of the time."""

    async def play() -> None:
        desk, window = Desk({}), Reader(reads=True)
        number = desk.join(window.send)
        for n in range(1, 6):
            desk.ask(number, msgspec.structs.replace(asked, n=n))
            await window.hears(kind="done", n=n)
        desk.close()

    run(play())


def _untold(frame: bytes, to: To) -> None:
    """Tell nobody."""


class Agents:
    """What is known of agents: how often all was told, or a change."""

    def __init__(self) -> None:
        self.tell: Tell = _untold

    def begin(self, tell: Tell) -> None:
        """Tell all that is known."""
        self.tell = tell
        tell(b'{"whole":true}', "new")

    def change(self, at: int) -> None:
        """Tell what has changed."""
        self.tell(json.dumps({"whole": False, "at": at}).encode(), "old")

    def end(self) -> None:
        """End."""


def test_who_watches_slowly_is_told_all_anew_instead_of_every_change() -> None:
    """Nothing is kept for it meanwhile; those that keep up are told every change."""

    async def play() -> None:
        agents = Agents()
        desk = Desk({}, cast("Live", agents))
        slow, quick = Reader(reads=False), Reader(reads=True)
        for reader in (slow, quick):
            desk.watch(desk.join(reader.send), Watch(0, True))
        await quick.hears(whole=True)
        for at in range(50):
            agents.change(at)
            await quick.hears(at=at)
        assert len(quick.frames) == 51
        slow.reads.set()
        await slow.hears(2, whole=True)
        agents.change(50)
        await slow.hears(at=50)
        assert len(slow.frames) == 3
        desk.close()

    run(play())
