"""How fast the page is: from a drag to what is painted, alone and among many.

Run with `python benchmarks/studio.py`; a browser is Playwright's Chromium, or the one that
CHROMIUM names. Figures are milliseconds, medians and 95th percentiles.
"""

import asyncio
import json
import math
import os
import shutil
import statistics
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import msgspec
import numpy as np
import websockets

from swarmgrasp.environment import Environment
from swarmgrasp.gui.frames import packed
from swarmgrasp.gui.messages import PROTOCOL
from swarmgrasp.gui.scenes import doc_of, speech_of
from swarmgrasp.outline import Outline
from swarmgrasp.placement import Problem
from swarmgrasp.scenario import example_text, parse_scenario, scenario_text

MOVES = 120
WINDOWS = 20
FRAME = 1.0 / 60.0


@contextmanager
def served(file: str, *more: str) -> Iterator[tuple[str, str]]:
    """Serve a scenario; yield the address and the key."""
    words = [sys.executable, "-m", "swarmgrasp", "studio", file, "--no-browser", *more]
    with subprocess.Popen(words, stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout is not None
        base, _, key = process.stdout.readline().strip().partition("/#k=")
        try:
            yield base, key
        finally:
            process.terminate()


def ring(count: int) -> dict[str, Any]:
    """Return the escort ring with so many tugs, all on lines square to the hull."""
    scenario = parse_scenario(example_text("escort-ring"))
    doc, outline = msgspec.to_builtins(doc_of(scenario)), scenario.swarm.outline
    robots = doc["problem"]["swarm"]["robots"]
    limit = sum(robot["limit"] for robot in robots) / count
    made = []
    for i in range(count):
        contact = outline.at_arc_length((i + 0.5) * outline.perimeter / count)
        way = math.remainder(contact.inward + math.pi + 0.3 * math.sin(7.0 * i), math.tau)
        made.append(
            {**robots[0], "name": str(i + 1), "contact": list(contact.point), "direction": way,
             "limit": limit, "tolerance": None}
        )  # fmt: skip
    doc["problem"]["swarm"]["robots"] = made
    doc["problem"]["spacing"] = 0.0
    if count > 1000:  # as such a crowd is asked: how well it holds, whatever comes
        doc["problem"]["criterion"] |= {"losing": 0, "load": [0.0, 0.0, 0.0]}
        doc["in_weather"] = False
    return {"doc": doc, "speech": msgspec.to_builtins(speech_of(scenario))}


def columns(message: dict[str, Any]) -> bytes:
    """Return a message as the page sends it when its document holds many robots."""
    swarm = message["doc"]["problem"]["swarm"]
    robots = swarm["robots"]
    head = {
        **message,
        "doc": {
            **message["doc"],
            "problem": {**message["doc"]["problem"], "swarm": {**swarm, "robots": []}},
        },
    }
    arrays = {
        "contacts": np.array([robot["contact"] for robot in robots]),
        "directions": np.array([robot["direction"] for robot in robots]),
        "limits": np.array([robot["limit"] for robot in robots]),
    }
    return packed(json.dumps(head).encode(), arrays)


class Window:
    """A window that drags one tug to and fro."""

    def __init__(self, base: str, key: str, scene: dict[str, Any]) -> None:
        self.base, self.key, self.scene, self.n = base, key, scene, 0
        swarm = scene["doc"]["problem"]["swarm"]
        self.outline = Outline.from_data(swarm["outline"])
        contact = swarm["robots"][len(swarm["robots"]) // 3]["contact"]
        self.start = self.outline.at_point(contact).arc_length

    async def __aenter__(self) -> "Window":
        url = self.base.replace("http", "ws", 1) + "/ws"
        self.socket = await websockets.connect(url, origin=self.base, max_size=None, proxy=None)
        await self.socket.send(json.dumps({"kind": "hello", "key": self.key, "protocol": PROTOCOL}))
        await self.socket.recv()
        return self

    async def __aexit__(self, *_: object) -> None:
        await self.socket.close()

    async def ask(self, moving: bool) -> float:
        """Ask with the tug moved; return the seconds to the answer, at rest to the end of all."""
        self.n += 1
        robots = self.scene["doc"]["problem"]["swarm"]["robots"]
        robot = robots[len(robots) // 3]
        arc = self.start + 0.3 * math.sin(0.3 * self.n)
        robot["contact"] = list(self.outline.at_arc_length(arc).point)
        message = {"kind": "ask", "n": self.n, "moving": moving, **self.scene}
        raw = columns(message) if len(robots) > 500 else json.dumps(message)
        begin = time.perf_counter()
        await self.socket.send(raw)
        while True:
            told = await self.socket.recv()
            head = told if isinstance(told, str) else told[4:200].decode("utf-8", "replace")
            if f'"n":{self.n}' not in head[:120]:
                continue
            if '"refused"' in head[:40]:
                raise RuntimeError(head)
            if ('"answer"' in head[:40]) if moving else ('"done"' in head[:40]):
                return time.perf_counter() - begin


async def drag(window: Window, moves: int) -> list[float]:
    """Drag; return the seconds of each answer."""
    times = []
    for _ in range(moves):
        took = await window.ask(True)
        times.append(took)
        await asyncio.sleep(max(0.0, FRAME - took))
    return times


def told(what: str, times: list[float]) -> None:
    """Print a row."""
    ordered = sorted(times)
    last = ordered[min(len(ordered) - 1, int(0.95 * len(ordered)))]
    print(f"{what:44} {1e3 * statistics.median(times):7.1f} {1e3 * last:7.1f}", flush=True)


async def alone(base: str, key: str) -> None:
    """One window, through the socket."""
    for count in (6, 25, 60, 1000, 10_000):
        async with Window(base, key, ring(count)) as window:
            await drag(window, 5)
            told(f"answer, {count} robots", await drag(window, MOVES if count < 1000 else 30))
            if count <= 60:
                told(f"all parts at rest, {count} robots", [await window.ask(False)])


async def crowd(base: str, key: str) -> None:
    """Many windows that drag at once."""
    for name, count in (("deck of 6", 6), ("60 robots", 60)):
        windows = [Window(base, key, ring(count)) for _ in range(WINDOWS)]
        for window in windows:
            await window.__aenter__()
        found = await asyncio.gather(*(drag(window, MOVES) for window in windows))
        told(f"{WINDOWS} windows at once, {name}", [t for times in found for t in times])
        for window in windows:
            await window.__aexit__()


STAMPS = """root => {
  const times = [];
  let moved = 0;
  root.addEventListener("pointermove", () => { moved ||= performance.now(); }, true);
  new MutationObserver(() => {
    if (moved) times.push(performance.now() - moved);
    moved = 0;
  }).observe(root, { attributes: true, attributeFilter: ["data-answered"] });
  window.taken = times;
}"""
"""From the first move that is not answered to the frame in which its answer is painted."""
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu"]
RESTED = "#studio[data-done]:not([data-busy])"


def painted(folder: Path) -> None:
    """Drag in a browser: from the event to the painted answer."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        path = os.environ.get("CHROMIUM") or shutil.which("chromium")
        browser = playwright.chromium.launch(executable_path=path, args=FLAGS)
        for count in (6, 25, 60):
            scene = ring(count)
            file = folder / f"ring-{count}.yaml"
            file.write_text(text_of(scene))
            with served(str(file)) as (base, key):
                page = browser.new_page(viewport={"width": 1440, "height": 900})
                begin = time.perf_counter()
                page.goto(f"{base}/#k={key}")
                page.wait_for_selector("#studio[data-answered]")
                told(f"first answer painted, {count} robots", [time.perf_counter() - begin])
                page.wait_for_selector(RESTED)
                page.locator("#studio").evaluate(STAMPS)
                name = str(count // 3 + 1)
                box = page.locator(f"[data-robot='{name}'] .foot").bounding_box()
                assert box is not None
                x, y = box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"]
                page.mouse.move(x, y)
                page.mouse.down()
                for i in range(MOVES):
                    page.mouse.move(x + 30.0 * math.sin(0.2 * i), y)
                    time.sleep(FRAME)
                page.mouse.up()
                begin = time.perf_counter()
                page.wait_for_selector(RESTED)
                rest = time.perf_counter() - begin
                taken = page.evaluate("window.taken")
                told(f"drag to painted answer, {count} robots", [1e-3 * t for t in taken])
                told(f"all parts after the hand rests, {count} robots", [rest])
                page.close()
        browser.close()


def text_of(scene: dict[str, Any]) -> str:
    """Return the text of a scene."""
    doc = scene["doc"]
    environment = Environment.from_data(doc["environment"])
    problem = Problem.from_data(doc["problem"])
    return scenario_text(problem, name=doc["name"], environment=environment)


def main() -> None:
    """Measure everything."""
    print(f"{'':44} {'median':>7} {'95 %':>7}   [ms]")
    begin = time.perf_counter()
    with served("escort-ring") as (base, key):
        told("link printed", [time.perf_counter() - begin])
        asyncio.run(alone(base, key))
        asyncio.run(crowd(base, key))
    with TemporaryDirectory() as folder:
        painted(Path(folder))


if __name__ == "__main__":
    main()
