"""The page in a notebook, spoken to as its widget does."""

import subprocess
import sys
from typing import Any

import pytest

import swarmgrasp as sg
from paged import unframed
from swarmgrasp.gui.messages import PROTOCOL
from swarmgrasp.scenario import load_example


class Page:
    """A widget's front end: it hears what is sent."""

    def __init__(self, widget: Any) -> None:
        self.widget, self.heard = widget, []
        widget.send = self._take

    def _take(self, content: Any, buffers: Any = None) -> None:
        """Take a message, or a binary frame."""
        self.heard.append(unframed(bytes(buffers[0])) if buffers else content)

    def say(self, **message: Any) -> list[dict[str, Any]]:
        """Send a message; return all that is answered."""
        self.heard = []
        self.widget._hear(self.widget, message, [])
        return self.heard


@pytest.fixture
def page() -> Page:
    return Page(sg.studio("deck-barge"))


def test_the_kernel_answers_as_the_server_does(page: Page) -> None:
    """All parts at rest; a problem that was dragged comes back."""
    scenario = load_example("deck-barge")
    best = sg.place(scenario.problem())
    assert page.widget.quality == pytest.approx(best.quality, rel=1e-9)  # before it is shown
    assert page.widget.place == best.place
    (welcome,) = page.say(kind="hello", key="", protocol=PROTOCOL)
    (scene,) = page.say(kind="open", n=1, name=welcome["opens"])
    ask = {"kind": "ask", "n": 2, "doc": scene["doc"], "speech": scene["speech"]}
    told = page.say(**ask, moving=False)
    assert told[-1] == {"kind": "done", "n": 2}
    assert {"answer", "mesh", "capability", "losses", "landscape", "proof"} <= {
        one.get("name") for one in told
    }
    assert page.widget.quality == pytest.approx(best.quality, rel=1e-9)
    assert page.widget.place == best.place
    seen = []
    page.widget.observe(lambda change: seen.append(change["new"]), "problem")
    scene["doc"]["problem"]["newcomer"]["limit"] *= 2.0
    page.say(**ask, moving=True)
    (problem,) = seen
    assert problem.newcomer.limit == 2.0 * scenario.newcomer.limit
    assert page.widget.problem == problem


def test_faults_come_back_and_the_widget_lives(page: Page) -> None:
    """A message that is none, and a document that is refused."""
    assert page.say(kind="dance")[0]["kind"] == "error"
    (told,) = page.say(kind="run", n=9, name="run")
    assert (told["kind"], told["n"]) == ("error", 9)
    (scene,) = page.say(kind="open", n=1, name="deck-barge")
    scene["doc"]["problem"]["spacing"] = -1.0
    ask = {"kind": "ask", "n": 2, "moving": True, "doc": scene["doc"], "speech": scene["speech"]}
    assert page.say(**ask)[0]["kind"] == "refused"
    scene["doc"]["problem"]["spacing"] = 1.0
    assert page.say(**ask)[0]["kind"] == "part"


def test_a_fault_of_ours_does_not_end_the_page(page: Page, monkeypatch: pytest.MonkeyPatch) -> None:
    """It is said, and the next question is answered."""
    (scene,) = page.say(kind="open", n=1, name="deck-barge")
    ask = {"kind": "ask", "moving": True, "doc": scene["doc"], "speech": scene["speech"]}
    monkeypatch.setattr("swarmgrasp.gui.notebook.ask", lambda *_: 1 / 0)
    (told,) = page.say(**ask, n=2)
    assert (told["kind"], told["n"]) == ("error", 2)
    monkeypatch.undo()
    assert page.say(**ask, n=3)[0]["kind"] == "part"


def test_a_problem_of_ones_own_is_shown(page: Page) -> None:
    """With its surroundings."""
    scenario = load_example("escort-ring")
    widget = sg.studio(scenario.problem(), name="Mine", environment=scenario.environment)
    (scene,) = Page(widget).say(kind="open", n=1, name="Mine")
    assert scene["doc"]["name"] == "Mine"
    assert scene["doc"]["in_weather"]
    assert widget.problem == scenario.problem()
    assert page.widget is not widget


def test_importing_the_package_imports_no_server_and_no_notebook() -> None:
    """They come when they are asked for."""
    code = (
        "import sys, swarmgrasp; sys.exit('starlette' in sys.modules or 'anywidget' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0
