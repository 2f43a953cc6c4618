"""The answer in words: the verdict, what comes after it, and the order."""

from collections.abc import Callable
from typing import Any

import msgspec
import pytest

from swarmgrasp.gui.asking import ask
from swarmgrasp.gui.messages import Doc
from swarmgrasp.gui.reading import question_of
from swarmgrasp.gui.scenes import built_in, scene_of
from swarmgrasp.gui.telling import Telling
from swarmgrasp.gui.told_parts import AnswerPart

Change = Callable[[dict[str, Any]], object]


def answer(name: str, change: Change) -> AnswerPart:
    """Return the answer to a built-in scene that is changed."""
    scene = scene_of(1, name, built_in()[name])
    data = msgspec.to_builtins(scene.doc)
    change(data)
    doc = msgspec.convert(data, Doc, strict=False)
    return Telling(ask(question_of(doc, scene.speech), None)).part(1, 0.0)


def told(part: AnswerPart) -> tuple[str, str]:
    """Return the first two lines, with plain spaces."""
    return part.first.text.replace("\u00a0", " "), part.second.replace("\u00a0", " ")


def criterion(**terms: Any) -> Change:
    """Ask for something else."""
    return lambda doc: doc["problem"]["criterion"].update(terms)


def calm(doc: dict[str, Any]) -> None:
    """Take the weather away."""
    doc["in_weather"] = False
    doc["problem"]["criterion"]["load"] = [0.0, 0.0, 0.0]


def storm(doc: dict[str, Any]) -> None:
    """Let it blow."""
    doc["environment"]["wind"]["speed"] = 35.0


def two(doc: dict[str, Any]) -> None:
    """Leave one tug, and lose none."""
    calm(doc)
    doc["problem"]["criterion"]["losing"] = 0
    del doc["problem"]["swarm"]["robots"][1:]


@pytest.mark.parametrize(
    ("change", "first", "second"),
    [
        (lambda _: None, "Held in 35 kn from 060°", "also after losing any one of the nine"),
        (storm, "Not held in 68 kn from 060°",
         "at most 63 kn from there, after losing any one of the nine"),
        (calm, "Holds 38 t every way", "also after losing any one of the nine"),
        (criterion(worst_case=True), "Held in 35 kn from 060°",
         "only once Idunn is in place, then also after losing any one of the nine, in the worst "
         "poses"),
        (criterion(losing=3), "Not held in 35 kn from 060°",
         "short by 49 t, after losing any three of the nine"),
        (criterion(losing=30), "Not held in 35 kn from 060°",
         "short by 51 t, after losing all of them"),
        (criterion(failures=[["Aegir", "Dufa"]], losing=0), "Held in 35 kn from 060°",
         "also after the failure of Aegir and Dufa"),
        (two, "Does not hold every way", "with both working"),
        (lambda doc: doc.update(newcomer=False), "Held in 35 kn from 060°",
         "also after losing any one of the eight"),
    ],
)  # fmt: skip
def test_the_first_lines_say_what_is_held_and_after_what(
    change: Change, first: str, second: str
) -> None:
    """A verdict, and its sentence."""
    assert told(answer("escort-ring", change)) == (first, second)


@pytest.mark.parametrize(
    ("name", "order"),
    [
        ("escort-ring", "Pull 80 t towards 097°, 7° aft of square"),
        ("deck-barge", "Push 60 t towards 113°, 23° aft of square"),
        ("harbour-tugs", "Push 300 kN within 30° of 000°"),
        ("drillship-azimuths", "Push 1.5 N towards 274°"),
        ("rectangle-5", "Pull 1.0 N towards 270°, square"),
    ],
)
def test_an_order_says_what_to_do_as_on_a_bridge(name: str, order: str) -> None:
    """Bearings clockwise from the bow; how far off square, and to which side."""
    part = answer(name, lambda _: None)
    assert part.order is not None
    assert part.order.do.replace("\u00a0", " ") == order


def test_nowhere_to_go_says_why() -> None:
    """Without a zone, and with a spacing that leaves no point."""
    part = answer("escort-ring", lambda doc: doc["problem"].update(zones=[]))
    assert "no zone is left to the newcomer" in [fact.text for fact in part.facts]
    part = answer("escort-ring", lambda doc: doc["problem"].update(spacing=1e3))
    assert any("lessen the spacing" in fact.text for fact in part.facts)
    assert part.order is None
