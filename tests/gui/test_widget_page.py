"""The notebook's module: two of them on one page, over sockets in the place of a kernel's comms."""

import pytest

MODEL = """
import widget from "/widget.js";
function model(key) {
  const socket = new WebSocket(location.origin.replace("http", "ws") + "/ws");
  socket.binaryType = "arraybuffer";
  const hearers = new Set();
  const opened = new Promise((go) => socket.addEventListener("open", go));
  socket.onmessage = ({ data }) => {
    const text = typeof data === "string";
    const heard = text ? [JSON.parse(data), []] : [{}, [new DataView(data)]];
    for (const hear of hearers) hear(...heard);
  };
  return {
    get: (name) => (name === "height" ? 600 : undefined),
    set: (name, value) => (window[name] = value),
    save_changes: () => undefined,
    on: (_, hear) => hearers.add(hear),
    off: (_, hear) => hearers.delete(hear),
    send: async (content, _, buffers) => {
      await opened;
      const known = content.kind === "hello" ? { ...content, key } : content;
      socket.send(buffers ? buffers[0] : JSON.stringify(known));
    },
  };
}
for (const id of ["one", "two"]) {
  widget.render({ model: model(KEY), el: document.getElementById(id) });
}
"""


@pytest.fixture
def notebook(browser, link):
    """Give a page with two widgets, and nothing of the studio's own page."""
    base, _, key = link.partition("/#k=")
    context = browser.new_context(bypass_csp=True, viewport={"width": 1240, "height": 1240})
    page = context.new_page()
    page.route("**/main.js", lambda route: route.abort())
    page.goto(base)
    page.evaluate(
        """() => {
          document.querySelector("link[rel=stylesheet]").remove();
          document.body.innerHTML = "<div id=one></div><div id=two></div>";
        }"""
    )
    page.add_script_tag(type="module", content=MODEL.replace("KEY", repr(key)))
    for name in ("one", "two"):
        page.locator(f"#{name} .studio[data-done]").wait_for(state="attached")
    yield page
    context.close()


def test_two_widgets_do_not_disturb_each_other(notebook):
    """A key in one changes its own wind; the other keeps its verdict, its choice and its look.

    Keys of theirs are not heard by the notebook.
    """

    def told(name, selector):
        return notebook.locator(f"#{name} {selector}").first.text_content()

    before = told("one", ".first")
    notebook.locator("#two .rose-wind").focus()
    for _ in range(4):
        notebook.keyboard.press("Shift+ArrowUp")
    notebook.locator("#two .first.bad").wait_for()
    assert told("two", ".first").startswith("Not held in ")
    assert told("one", ".first") == before
    notebook.evaluate(
        """() => {
          window.heard = [];
          document.addEventListener("keydown", (event) => window.heard.push(event.key));
        }"""
    )
    for key in ("x", "a", "Escape", "Control+s"):
        notebook.keyboard.press(key)
    assert notebook.evaluate("window.answered") > 0
    assert notebook.evaluate("window.heard") == ["Control", "s"]
    assert notebook.evaluate("localStorage.length") == 0
    family = "[...document.fonts].map((face) => `${face.family} ${face.weight}`).sort()"
    assert notebook.evaluate(family) == ["Inter 400", "Inter 600"]
