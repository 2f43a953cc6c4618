"""The page as a widget of Jupyter and marimo; the kernel answers, and has one thread."""

import logging
from collections.abc import Mapping
from importlib.metadata import version
from importlib.resources import files
from time import thread_time
from typing import Any

import anywidget
import msgspec
import traitlets

from swarmgrasp.environment import Environment
from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.gui.asking import Found, ask
from swarmgrasp.gui.desk import NOT_HERE
from swarmgrasp.gui.errands import errands_of
from swarmgrasp.gui.guard import LIMITS
from swarmgrasp.gui.messages import PROTOCOL, Ask, FromPage, Hello, read_message
from swarmgrasp.gui.parts import MOVING, NAMED, PARTS, Sheet, tell
from swarmgrasp.gui.reading import question_of
from swarmgrasp.gui.replies import Done, Error, Refused, Welcome
from swarmgrasp.gui.scenes import Source, doc_of, faults_in, speech_of, titles
from swarmgrasp.gui.sending import write_message
from swarmgrasp.gui.telling import Telling
from swarmgrasp.placement import Problem
from swarmgrasp.scenario import Scenario, example_text, parse_scenario, scenario_text

logger = logging.getLogger(__name__)
CHEAP = 0.015
"""Seconds up to which a part is told in a gesture."""


def text_of(
    asked: Problem | Scenario | str, name: str, environment: Environment | None
) -> tuple[str, str]:
    """Return the title and the text of a scenario."""
    if isinstance(asked, str):
        return asked, example_text(asked)
    if isinstance(asked, Scenario):
        return asked.name, scenario_text(asked)
    return name or "Problem", scenario_text(asked, name=name or "Problem", environment=environment)


class Studio(anywidget.AnyWidget):
    """A scenario in a notebook.

    Attributes
    ----------
    problem : Problem
        What is asked, as it was dragged last.
    quality : float [N]
        With the newcomer in its place.
    place : str
        Where that is; "" where there is nobody to place.
    answered : int
        Changes when all of that is told, and the hand rests.
    """

    _esm = files("swarmgrasp.gui") / "page" / "widget.js"
    answered = traitlets.Int().tag(sync=True)
    problem = traitlets.Any()
    quality = traitlets.Float().tag(sync=True)
    place = traitlets.Unicode().tag(sync=True)

    def __init__(self, title: str, text: str) -> None:
        scenario = parse_scenario(text, title)
        super().__init__(problem=scenario.problem())
        self._keep(ask(question_of(doc_of(scenario), speech_of(scenario)), None))
        self._scenes: Mapping[str, Source] = {title: Source(text, scenario=scenario)}
        self._title = title
        self._errands = errands_of(self._scenes, title)
        self._costs: dict[str, float] = {}
        self.on_msg(self._hear)

    def _hear(self, _: Any, content: Any, buffers: list[Any]) -> None:
        """Answer a message of the page."""
        try:
            if buffers:
                message: Any = read_message(bytes(buffers[0]))
            else:
                message = msgspec.convert(content, FromPage, strict=True)
        except (msgspec.DecodeError, RecursionError) as error:
            self._say(write_message(Error(None, f"Not understood: {error}")))
            return
        try:
            self._answer(message)
        except Exception:  # a fault of ours: the page lives on
            logger.exception("%s failed", type(message).__name__)
            self._say(write_message(Error(getattr(message, "n", None), "This could not be done.")))

    def _answer(self, message: Any) -> None:
        """Answer what is understood."""
        if isinstance(message, Hello):
            self._say(write_message(self._welcome()))
        elif isinstance(message, Ask):
            self._ask(message)
        elif type(message) in self._errands:
            self._errand(message)
        elif hasattr(message, "n"):
            self._say(write_message(Error(message.n, NOT_HERE)))

    def _welcome(self) -> Welcome:
        """Return what a page is told first."""
        return Welcome(
            PROTOCOL, version("swarmgrasp"),
            LIMITS, titles(self._scenes),
            self._title, None, watch=False, demonstration=False, reports=False,
        )  # fmt: skip

    def _errand(self, message: Any) -> None:
        """Do an errand."""
        try:
            self._say(self._errands[type(message)](message))
        except SwarmGraspError as error:
            self._say(write_message(Refused(message.n, faults_in(error.faults))))

    def _ask(self, message: Ask) -> None:
        """Answer an ask: while moving, with the parts that are cheap."""
        start = thread_time()
        try:
            question = question_of(message.doc, message.speech)
            found = ask(question, None if message.moving else 0.0)
        except SwarmGraspError as error:
            self._say(write_message(Refused(message.n, faults_in(error.faults))))
            return
        self._say(write_message(Telling(found).part(message.n, 1e3 * (thread_time() - start))))
        self._keep(found)
        for part in MOVING if message.moving else PARTS:
            is_wanted = message.wants is None or NAMED.get(part, part) in message.wants
            if is_wanted and not (message.moving and self._costs.get(part, 0.0) > CHEAP):
                self._part(part, Sheet(message.n, found, lambda: False))
        self._say(write_message(Done(message.n)))

    def _part(self, part: str, sheet: Sheet) -> None:
        """Tell a part, and note what it takes."""
        start = thread_time()
        self._say(tell(part, sheet, lambda: 1e3 * (thread_time() - start)))
        self._costs[part] = thread_time() - start

    def _keep(self, found: Found) -> None:
        """Keep what was found, for other cells of the notebook."""
        self.problem = found.problem
        self.quality = found.after.value
        self.place = found.placement.place if found.placement is not None else ""

    def _say(self, frame: bytes) -> None:
        """Send a frame: JSON as it is, all else as a buffer."""
        if frame[:1] == b"{":
            self.send(msgspec.json.decode(frame))
        else:
            self.send({}, buffers=[frame])
