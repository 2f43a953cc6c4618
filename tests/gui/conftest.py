"""A studio that is served here, and a browser to look at it with."""

import json
import os
import shutil
import threading
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

import pytest

sync_api = pytest.importorskip("playwright.sync_api")
pytest.importorskip("swarmgrasp.gui.server")

from paged import CROWDS, crowd  # noqa: E402
from swarmgrasp.gui.scenes import Source, built_in  # noqa: E402
from swarmgrasp.gui.server import Settings, opened  # noqa: E402

CHROMIUM = shutil.which("chromium")
FLAGS = [
    "--headless",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
]
RESTED = "#studio[data-done]:not([data-busy])"
# A pointer's moves wait for the next frame: after two, what was done has been heard.
HEARD = "new Promise((go) => requestAnimationFrame(() => requestAnimationFrame(go)))"


def sheet(scenario, name, text):
    """Return a sheet about a job, without its pictures."""
    return f"<!doctype html><html><h1>{name}</h1>{scenario.newcomer.name}: {len(text)}</html>"


@contextmanager
def served(port=0, key="k" * 32) -> Iterator[str]:
    """Serve the built-in scenes; give the link."""
    scenes = {**built_in(), **{f"crowd-{count}": Source(crowd(count)) for count in CROWDS}}
    settings = Settings(scenes, "escort-ring", port=port, key=key, reporting=sheet)
    studio = opened(settings)
    thread = threading.Thread(target=studio.run, daemon=True)
    thread.start()
    try:
        yield studio.link
    finally:
        studio.end()
        thread.join()


@pytest.fixture(scope="session")
def link():
    """Serve a studio as long as the tests last; give its link."""
    with served() as found:
        yield found


class ComesAndGoes:
    """A studio of its own, that ends and begins again at its port with its key."""

    def __init__(self):
        self._served = served()
        self.link = self._served.__enter__()

    def end(self):
        """End it."""
        self._served.__exit__(None, None, None)

    def begin(self):
        """Begin it again."""
        port = int(self.link.rpartition(":")[2].partition("/")[0])
        self._served = served(port)
        self._served.__enter__()


@pytest.fixture
def comes_and_goes():
    """Serve a studio that a test may end."""
    found = ComesAndGoes()
    yield found
    found.end()


@pytest.fixture(scope="session")
def browser():
    """One browser for all tests; without one they are left out, unless it must be there."""
    if CHROMIUM is None:
        if os.environ.get("SWARMGRASP_BROWSER"):
            pytest.fail("there is no chromium, and SWARMGRASP_BROWSER says that there must be")
        pytest.skip("there is no chromium to look at the page with")
    with sync_api.sync_playwright() as playwright:
        found = playwright.chromium.launch(executable_path=CHROMIUM, args=FLAGS)
        yield found
        found.close()


# Of what a page has kept only its key is left, each time that it is loaded.
FORGETTING = """if (location.protocol !== "about:") {
  const key = localStorage.getItem("swarmgrasp key");
  localStorage.clear();
  if (key !== null) localStorage.setItem("swarmgrasp key", key);
}"""
WIDE = {"viewport": {"width": 1440, "height": 900}, "reduced_motion": "reduce"}


class Window:
    """One window of the studio, as somebody has it before them.

    The page paints once a frame: whatever is done through a window is painted when it returns.
    """

    def __init__(self, page, link):
        self.context = page.context
        self.page = page
        self.page.set_default_timeout(20_000)
        self.complaints = []
        self.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.page.on("console", self._heard)
        self.page.goto(link)
        self.rest()

    def _heard(self, message):
        is_of_icon = message.location["url"].endswith("/favicon.ico")  # of a file that is no page
        if message.type == "error" and "WebSocket" not in message.text and not is_of_icon:
            self.complaints.append(message.text)

    def rest(self):
        """Wait until all that was done is heard, all that was asked answered, and it is painted."""
        self.page.evaluate(HEARD)
        self.page.wait_for_selector(RESTED)
        return self

    def open(self, title):
        """Open a scene from the menu."""
        self.page.click(".scene-name")
        self.page.click(f".menu-item:has(span:text-is('{title}'))")
        self.page.wait_for_selector(f".scene-title:text-is('{title}')")
        return self.rest()

    def press(self, *keys):
        """Press keys, one after the other."""
        for key in keys:
            self.page.keyboard.press(key)
        return self.rest()

    def click(self, selector):
        """Click on an element."""
        self.page.click(selector)
        return self.rest()

    def tap(self, selector):
        """Touch an element."""
        self.page.tap(selector)
        return self.rest()

    def hover(self, selector):
        """Hold the pointer over an element."""
        self.page.hover(selector)
        return self.rest()

    def focus(self, selector):
        """Give an element the keys."""
        self.page.locator(selector).focus()
        return self.rest()

    def text(self, selector):
        """Return a text of the page, all its spaces and breaks made plain."""
        found = self.page.locator(selector).first.evaluate(
            "one => one.innerText ?? one.textContent"
        )
        return " ".join(found.split())

    def spin(self, label, value):
        """Type a number into one of the sentence's controls."""
        self.focus(f"[role=spinbutton][aria-label='{label}']")
        self.page.keyboard.type(str(value))
        self.page.keyboard.press("Enter")
        return self.rest()

    def middle(self, selector):
        """Return the middle of an element."""
        box = self.page.locator(selector).bounding_box()
        return box["x"] + box["width"] / 2, box["y"] + box["height"] / 2

    def drag(self, selector, right, down, keys=()):
        """Drag an element by pixels, in several moves."""
        return self.pull(*self.middle(selector), right, down, keys)

    def pull(self, x, y, right, down, keys=()):
        """Press at a pixel and drag from there."""
        mouse = self.page.mouse
        mouse.move(x, y)
        mouse.down()
        for key in keys:
            self.page.keyboard.down(key)
        mouse.move(x + right, y + down, steps=6)
        mouse.up()
        for key in keys:
            self.page.keyboard.up(key)
        return self.rest()

    def swipe(self, selector, right, down):
        """Drag an element by pixels with a finger."""
        x, y = self.middle(selector)
        line = self.context.new_cdp_session(self.page)
        steps = [(x + right * k / 6, y + down * k / 6) for k in range(7)]
        for k, (across, along) in enumerate(steps):
            kind = "touchStart" if k == 0 else "touchMove"
            points = [{"x": across, "y": along}]
            line.send("Input.dispatchTouchEvent", {"type": kind, "touchPoints": points})
        line.send("Input.dispatchTouchEvent", {"type": "touchEnd", "touchPoints": []})
        line.detach()
        return self.rest()

    def robot(self, name):
        """Return the sentence of a robot, as those who hear the page hear it."""
        found = self.page.locator(f".robot[data-robot='{name}']")
        return found.get_attribute("aria-valuetext").replace("\u00a0", " ")

    def kept(self, scene):
        """Return what the browser keeps of a scene's changes; None where there are none."""
        self.page.evaluate("window.dispatchEvent(new Event('pagehide'))")
        found = self.page.evaluate(f"localStorage.getItem('swarmgrasp:{scene}')")
        return None if found is None else json.loads(found)

    def download(self, item):
        """Choose an item of the menu that saves a file; return the file's bytes."""
        self.page.click(".scene-name")
        with self.page.expect_download() as waiting:
            self.page.click(f".menu-item:has(span:text-is('{item}'))")
        return Path(waiting.value.path()).read_bytes()


@pytest.fixture
def window(browser, link):
    """Give a function that opens windows, prepared if need be; none may complain in its console."""
    contexts, windows = [], []

    def one(prepare=None, beside=None, at=link, **settings):
        if beside is None:
            contexts.append(browser.new_context(**WIDE | settings))
        page = (beside.context if beside else contexts[-1]).new_page()
        if prepare is not None:
            prepare(page)
        windows.append(Window(page, at))
        return windows[-1]

    yield one
    for context in contexts:
        context.close()
    assert [complaint for found in windows for complaint in found.complaints] == []


@pytest.fixture(scope="session")
def lent():
    """Keep the window that tests have one after the other, while it is there."""
    return []


@pytest.fixture
def one(browser, link, lent, request):
    """Give a window as if it had just been opened; it may not complain in its console."""
    if lent:
        lent[0].page.mouse.up()
        lent[0].page.mouse.move(0, 0)
        lent[0].page.goto(link)
        lent[0].rest()
    else:
        page = browser.new_context(**WIDE).new_page()
        page.add_init_script(FORGETTING)
        lent.append(Window(page, link))
    failed = request.session.testsfailed
    yield lent[0]
    # An open line would go on beside tests of other rooms. Gone to the same server, the old page
    # has written what it keeps; gone elsewhere, it may still do so while the next test begins.
    lent[0].page.goto(link.partition("#")[0] + "page.css")
    complaints = lent[0].complaints
    if complaints or request.session.testsfailed > failed:
        lent.pop().context.close()
    assert complaints == []
