"""Documents of many robots come as columns, and say the same."""

import json
from typing import Any

import msgspec
import numpy as np
import pytest

from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.gui.asking import ask
from swarmgrasp.gui.frames import packed
from swarmgrasp.gui.messages import Ask, read_message
from swarmgrasp.gui.reading import question_of
from swarmgrasp.gui.scenes import built_in, scene_of


def framed(change: Any = None, names: list[str] | None = None) -> bytes:
    """Return an ask about the escort ring as a page sends one about a crowd."""
    scene = scene_of(1, "escort-ring", built_in()["escort-ring"])
    doc = msgspec.to_builtins(scene.doc)
    robots = doc["problem"]["swarm"]["robots"]
    columns = {
        "contacts": np.array([robot["contact"] for robot in robots]),
        "directions": np.array([robot["direction"] for robot in robots]),
        "limits": np.array([robot["limit"] for robot in robots]),
    }
    doc["problem"]["swarm"]["robots"] = []
    if change is not None:
        change(doc, columns)
    speech = msgspec.to_builtins(scene.speech)
    head = {"kind": "ask", "n": 1, "moving": True, "doc": doc, "speech": speech, "names": names}
    return packed(json.dumps(head).encode(), columns)


def test_columns_are_the_robots_that_they_stand_for() -> None:
    """The same answer, with names or with numbers for names."""
    scene = scene_of(1, "escort-ring", built_in()["escort-ring"])
    one = ask(question_of(scene.doc, scene.speech), None)
    robots = [robot["name"] for robot in scene.doc.problem["swarm"]["robots"]]
    for names in (robots, None):
        message = read_message(framed(names=names))
        assert isinstance(message, Ask)
        other = ask(question_of(message.doc, message.speech), None)
        assert other.values == one.values
        assert other.newcomer == one.newcomer
        known = robots if names else [f"R{i}" for i in range(1, 9)]
        assert list(other.problem.swarm.names) == known


@pytest.mark.parametrize(
    "raw",
    [
        framed()[:-1],
        framed()[:-8],
        framed(names=["A"]),
        framed()[:3],
        b"\xff\xff\xff\xff" + framed()[4:],
        packed(b'{"kind":"cancel","n":1}', {"x": np.zeros(4)}),
        framed(lambda doc, _: doc["problem"]["swarm"].update(robots=[{}])),
        framed(lambda doc, _: doc["problem"].update(swarm=7)),
    ],
)
def test_a_malformed_frame_is_refused(raw: bytes) -> None:
    """Cut short, with a head that ends beyond it, with columns that nobody asked for."""
    with pytest.raises(msgspec.DecodeError):
        read_message(raw)


def far_off(_: Any, columns: dict[str, Any]) -> None:
    columns["contacts"][3] = (1e3, 0.0)


def not_finite(_: Any, columns: dict[str, Any]) -> None:
    columns["limits"][2] = np.nan


def no_outline(doc: dict[str, Any], _: Any) -> None:
    doc["problem"]["swarm"]["outline"] = {"vertices": []}


@pytest.mark.parametrize("change", [far_off, not_finite, no_outline])
def test_faults_of_a_crowd_are_told(change: Any) -> None:
    """As of any swarm."""
    message = read_message(framed(change))
    assert isinstance(message, Ask)
    with pytest.raises(SwarmGraspError, match=r"problem\.swarm"):
        question_of(message.doc, message.speech)
