"""How fast the page is: from a drag to what is painted, alone and among many.

Run with `python benchmarks/studio.py`; a browser is Playwright's Chromium, or the one that
CHROMIUM names. It prints the table of docs/studio.md.
"""

import asyncio
import json
import math
import os
import re
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
from swarmgrasp.simulation import Hull, simulate
from swarmgrasp.simulation.control import Control
from swarmgrasp.simulation.record import write_log
from swarmgrasp.simulation.simulation import Simulation

MOVES = 120
RESTS = 15
WINDOWS = 20
FRAME = 1.0 / 60.0
PLAYERS, PLAYED, INSTANTS = 12, 900.0, 10.0
"""Robots of the run that is played, its seconds, and instants a second."""
WATCHED = 10.0
"""Seconds that it is played for, thirty times as fast as it was."""
NAMED = re.compile(r'"name":"(\w+)"')


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

    async def ask(self, moving: bool) -> dict[str, float]:
        """Ask with the tug moved; return the seconds until each part came the first time.

        In a gesture what comes behind the answer is left to the next ask; at rest "done" is the
        end of all.
        """
        self.n += 1
        robots = self.scene["doc"]["problem"]["swarm"]["robots"]
        robot = robots[len(robots) // 3]
        arc = self.start + 0.3 * math.sin(0.3 * self.n)
        robot["contact"] = list(self.outline.at_arc_length(arc).point)
        message = {"kind": "ask", "n": self.n, "moving": moving, **self.scene}
        raw = columns(message) if len(robots) > 500 else json.dumps(message)
        came: dict[str, float] = {}
        begin = time.perf_counter()
        await self.socket.send(raw)
        while ("answer" if moving else "done") not in came:
            told = await self.socket.recv()
            head = (told if isinstance(told, str) else told[4:200].decode("utf-8", "replace"))[:120]
            if f'"n":{self.n}' not in head:
                continue
            if '"refused"' in head:
                raise RuntimeError(told)
            name = NAMED.search(head)
            came.setdefault(name[1] if name else "done", time.perf_counter() - begin)
        return came


async def drag(window: Window, moves: int) -> list[float]:
    """Drag; return the seconds of each answer."""
    times = []
    for _ in range(moves):
        took = (await window.ask(True))["answer"]
        times.append(took)
        await asyncio.sleep(max(0.0, FRAME - took))
    return times


async def rests(window: Window, times: int) -> list[dict[str, float]]:
    """Drag a little and rest, so many times; return the seconds of each part each time."""
    found = []
    for _ in range(times):
        await drag(window, 10)
        found.append(await window.ask(False))
    return found


def told(what: str, times: list[float]) -> None:
    """Print a row: milliseconds, their median and their 95th percentile."""
    ordered = sorted(times)
    last = ordered[min(len(ordered) - 1, int(0.95 * len(ordered)))]
    row(what, f"{1e3 * statistics.median(times):.1f}", f"{1e3 * last:.1f}")


def row(what: str, value: str, last: str = "") -> None:
    """Print a row of the table."""
    print(f"| {what} | {value} | {last} |", flush=True)


async def alone(base: str, key: str) -> None:
    """One window, through the socket."""
    for count in (6, 25, 60, 1000, 10_000):
        async with Window(base, key, ring(count)) as window:
            await drag(window, 5)
            told(f"answer, {count} robots", await drag(window, MOVES if count < 1000 else 30))
            if count <= 60:
                found = await rests(window, RESTS)
                both = [max(came["capability"], came["losses"]) for came in found]
                told(f"capability and losses, {count} robots", both)
                told(f"all parts at rest, {count} robots", [came["done"] for came in found])


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


STAMPS = """{
  const painted = (then) => requestAnimationFrame(() => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = then;
    port2.postMessage(null);
  });
  const named = (data) => {
    const raw = typeof data === "string" ? data
      : new TextDecoder().decode(new Uint8Array(data, 4, Math.min(200, data.byteLength - 4)));
    return [/"name":"(\\w+)"/.exec(raw)?.[1], Number(/"n":(\\d+)/.exec(raw)?.[1])];
  };
  let [moved, rested, asked] = [0, 0, 0];
  let owed = new Set();
  window.answered = [];
  window.rest = [];
  window.WebSocket = class extends WebSocket {
    constructor(...given) {
      super(...given);
      this.addEventListener("message", ({ data }) => {
        const [name, n] = named(data);
        if (rested === 0 || n !== asked || !owed.delete(name) || owed.size > 0) return;
        painted(() => {
          window.rest.push(performance.now() - rested);
          rested = 0;
        });
      });
    }
    send(data) {
      if (typeof data === "string" && data.includes('"moving":false')) asked = named(data)[1];
      super.send(data);
    }
  };
  addEventListener("pointermove", ({ buttons }) => {
    moved ||= buttons && performance.now();
  }, true);
  addEventListener("pointerup", () => {
    rested = performance.now();
    owed = new Set(["capability", "losses"]);
  }, true);
  const answered = new MutationObserver(() => {
    if (moved) window.answered.push(performance.now() - moved);
    moved = 0;
  });
  addEventListener("DOMContentLoaded", () => answered.observe(
    document.getElementById("studio"), { attributes: true, attributeFilter: ["data-answered"] },
  ));
}"""
"""Of a page: from the first move that is not answered to the frame with its answer, and from when
the hand lets go to the frame with what it asks for first.
"""
FRAMES = """{
  const ask = window.requestAnimationFrame.bind(window);
  let [begun, waiting] = [0, false];
  window.frames_worked = [];
  const { port1, port2 } = new MessageChannel();
  port1.onmessage = () => {
    window.frames_worked.push(performance.now() - begun);
    waiting = false;
  };
  window.requestAnimationFrame = (run) => ask((now) => {
    if (!waiting) {
      [begun, waiting] = [performance.now(), true];
      port2.postMessage(null);
    }
    run(now);
  });
}"""
"""Of a page: how long each frame takes it, from its first script to the end of layout and paint."""
FLAGS = ["--headless", "--no-sandbox", "--disable-gpu"]
RESTED = "#studio[data-done]:not([data-busy])"
DRAGS = 6


@contextmanager
def browsed() -> Iterator[Any]:
    """Begin a browser."""
    from playwright.sync_api import sync_playwright

    with sync_playwright() as playwright:
        path = os.environ.get("CHROMIUM") or shutil.which("chromium")
        browser = playwright.chromium.launch(executable_path=path, args=FLAGS)
        yield browser
        browser.close()


def opened(browser: Any, script: str) -> Any:
    """Open an empty page that counts by a script."""
    page = browser.new_page(viewport={"width": 1440, "height": 900})
    page.add_init_script(script)
    return page


def weighed(browser: Any) -> None:
    """Count what is fetched to open the page: requests, and bytes with their heads."""
    with served("escort-ring") as (base, key):
        page, requests = opened(browser, ""), []
        page.on("requestfinished", lambda request: requests.append(request))
        page.goto(f"{base}/#k={key}")
        page.wait_for_selector(RESTED)
        sizes = [request.sizes() for request in requests]
        page.close()
    size = sum(one["responseBodySize"] + one["responseHeadersSize"] for one in sizes)
    row("requests of the page", f"{len(requests)}")
    row("weight of the page [kB]", f"{1e-3 * size:.0f}")


def painted(browser: Any, folder: Path) -> None:
    """Drag in a browser: from the event to the painted answer."""
    for count in (6, 25, 60):
        file = folder / f"ring-{count}.yaml"
        file.write_text(text_of(ring(count)))
        with served(str(file)) as (base, key):
            page = opened(browser, STAMPS)
            begin = time.perf_counter()
            page.goto(f"{base}/#k={key}")
            page.wait_for_selector("#studio[data-answered]")
            told(f"first answer painted, {count} robots", [time.perf_counter() - begin])
            page.wait_for_selector(RESTED)
            name, all_parts = str(count // 3 + 1), []
            for _ in range(DRAGS):
                box = page.locator(f"[data-robot='{name}'] .foot").bounding_box()
                assert box is not None
                x, y = box["x"] + 0.5 * box["width"], box["y"] + 0.5 * box["height"]
                page.mouse.move(x, y)
                page.mouse.down()
                for i in range(MOVES // DRAGS):
                    page.mouse.move(x + 30.0 * math.sin(0.2 * i), y)
                    time.sleep(FRAME)
                page.mouse.up()
                begin = time.perf_counter()
                page.wait_for_selector(RESTED)
                all_parts.append(time.perf_counter() - begin)
            taken, rest = page.evaluate("[window.answered, window.rest]")
            told(f"drag to painted answer, {count} robots", [1e-3 * t for t in taken])
            told(f"capability and losses painted, {count} robots", [1e-3 * t for t in rest])
            told(f"all parts painted, {count} robots", all_parts)
            page.close()


def played(browser: Any, folder: Path) -> None:
    """Play a long run, fast: what a frame takes the page."""
    file, log = folder / "played.yaml", folder / "run.parquet"
    file.write_text(text_of(ring(PLAYERS)))
    scenario = parse_scenario(file.read_text())
    simulation = Simulation(
        scenario.problem(), scenario.environment,
        Hull.afloat(scenario.swarm.outline, scenario.environment),
        control=Control(period=1.0 / INSTANTS), duration=PLAYED,
    )  # fmt: skip
    write_log(simulate(simulation, every=1), log)
    with served(str(file), "--run", str(log)) as (base, key):
        page = opened(browser, FRAMES)
        page.goto(f"{base}/#k={key}")
        page.wait_for_selector("[data-time=run]")
        page.wait_for_selector(RESTED)
        for _ in range(3):
            page.keyboard.press(">")
        page.evaluate("window.frames_worked.length = 0")
        page.keyboard.press(" ")
        time.sleep(WATCHED)
        frames = page.evaluate("window.frames_worked")
        page.close()
    row(f"frames of the player a second, {PLAYERS} robots", f"{len(frames) / WATCHED:.0f}")
    told(f"work of a frame of the player, {PLAYERS} robots", [1e-3 * t for t in frames])


def text_of(scene: dict[str, Any]) -> str:
    """Return the text of a scene."""
    doc = scene["doc"]
    environment = Environment.from_data(doc["environment"])
    problem = Problem.from_data(doc["problem"])
    return scenario_text(problem, name=doc["name"], environment=environment)


def main() -> None:
    """Measure everything."""
    row("what", "median [ms]", "95 % [ms]")
    row("---", "---", "---")
    begin = time.perf_counter()
    with served("escort-ring") as (base, key):
        told("link printed", [time.perf_counter() - begin])
        asyncio.run(alone(base, key))
        asyncio.run(crowd(base, key))
    with TemporaryDirectory() as folder, browsed() as browser:
        weighed(browser)
        painted(browser, Path(folder))
        played(browser, Path(folder))


if __name__ == "__main__":
    main()
