"""The text and the document say the same, both ways."""

import json
from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import pytest

from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.gui.errands import errands_of, told_text
from swarmgrasp.gui.messages import Doc, Text, Write
from swarmgrasp.gui.scenes import Source, built_in, doc_of, scene_of
from swarmgrasp.scenario import example_names, example_text, parse_scenario


def written(doc: Doc, text: str) -> str:
    """Return the text of a document."""
    told: str = json.loads(told_text(Write(1, doc, text), {}))["text"]
    return told


@pytest.mark.parametrize("name", example_names())
def test_a_document_that_was_not_changed_leaves_its_text_as_it_is(name: str) -> None:
    """To the last character."""
    scene = scene_of(1, name, built_in()[name])
    assert written(scene.doc, scene.text) == scene.text


def drag(doc: dict[str, Any]) -> None:
    """Move a tug along its side."""
    doc["problem"]["swarm"]["robots"][2]["contact"] = [61.5, -21.0]


def turn_the_wind(doc: dict[str, Any]) -> None:
    """Let the wind blow harder, from another side."""
    doc["environment"]["wind"] |= {"speed": 20.0, "bearing": 2.0}


def lose_more(doc: dict[str, Any]) -> None:
    """Lose two tugs, in the worst poses."""
    doc["problem"]["criterion"] |= {"losing": 2, "worst_case": True}


def bring_less(doc: dict[str, Any]) -> None:
    """Bring a weaker newcomer that pulls closer to square."""
    doc["problem"]["newcomer"] |= {"limit": 6e5, "half_angle": 0.5}


def take_away(doc: dict[str, Any]) -> None:
    """Take a tug away, and a zone."""
    del doc["problem"]["swarm"]["robots"][4]
    del doc["problem"]["zones"][1]


@pytest.mark.parametrize("change", [drag, turn_the_wind, lose_more, bring_less, take_away])
def test_what_is_changed_in_the_page_is_in_the_text(change: Callable[[Any], None]) -> None:
    """Read again, it is the document; comments stay."""
    text = example_text("escort-ring")
    data = msgspec.to_builtins(doc_of(parse_scenario(text)))
    change(data)
    doc = msgspec.convert(data, Doc, strict=False)
    again = written(doc, text)
    assert again != text
    assert "# all pull on a line; a direction is where the line leads" in again
    found = msgspec.to_builtins(doc_of(parse_scenario(again)))
    found["problem"]["criterion"]["load"] = data["problem"]["criterion"]["load"]
    numbers, others = flat(found), flat(data)
    assert numbers.keys() == others.keys()
    for path, value in numbers.items():
        expected = others[path]
        is_number = isinstance(expected, float | int)
        assert value == (pytest.approx(expected, rel=1e-9, abs=1e-9) if is_number else expected)


def flat(data: Any, path: str = "") -> dict[str, Any]:
    """Return what nested data hold, by path."""
    if isinstance(data, dict):
        return {k: v for key in data for k, v in flat(data[key], f"{path}.{key}").items()}
    if isinstance(data, list | tuple):
        return {k: v for i, one in enumerate(data) for k, v in flat(one, f"{path}.{i}").items()}
    return {path: data}


def test_what_a_file_cannot_say_is_told() -> None:
    """A newcomer with nowhere to go."""
    scene = scene_of(1, "escort-ring", built_in()["escort-ring"])
    nowhere = msgspec.structs.replace(scene.doc, problem={**scene.doc.problem, "zones": []})
    with pytest.raises(SwarmGraspError, match="no zone"):
        told_text(Write(1, nowhere, scene.text), {})


IMPORTING = """
units: {length: m, force: kN, angle: deg}
outline: {file: hull.csv}  # from the yard
robots: {file: tugs.csv}
newcomer: {limit: 60 kN, attachment: push}
"""


@pytest.fixture
def importing(tmp_path: Path) -> Source:
    """Give a scene that takes its hull and its robots from files beside it."""
    (tmp_path / "hull.csv").write_text("x,y\n0,0\n40,0\n40,20\n0,20\n")
    rows = ["Ajax,10,0,90,60", "Boreas,30,0,90,60"]
    (tmp_path / "tugs.csv").write_text("\n".join(["name,x,y,direction,limit", *rows]))
    (tmp_path / "secret.csv").write_text("x,y\n0,0\n1,0\n0,1\n")
    return Source.beside(IMPORTING, tmp_path)


def test_a_text_that_takes_from_files_is_edited_and_saved(importing: Source) -> None:
    """What was not changed still comes from its file; what was is said in the text."""
    errands = errands_of({"mine": importing}, "mine")

    def saved(change: Callable[[Any], None]) -> str:
        doc = msgspec.to_builtins(scene_of(1, "mine", importing).doc)
        change(doc["problem"])
        raw = errands[Write](Write(1, msgspec.convert(doc, Doc), importing.text))
        text: str = json.loads(raw)["text"]
        again = json.loads(errands[Text](Text(2, text, "mine")))["doc"]
        assert again["problem"]["swarm"]["robots"] == doc["problem"]["swarm"]["robots"]
        assert again["problem"]["swarm"]["outline"] == doc["problem"]["swarm"]["outline"]
        return text

    def move(problem: Any) -> None:
        problem["swarm"]["robots"][0]["contact"] = [12.0, 0.0]

    def widen(problem: Any) -> None:
        problem["swarm"]["outline"]["vertices"][2] = [45.0, 20.0]

    assert saved(lambda _: None) == IMPORTING
    assert "outline: {file: hull.csv}  # from the yard\n" in saved(move)
    assert "name: Ajax" in saved(move)
    assert "file: hull.csv" not in saved(widen)


@pytest.mark.parametrize("path", ["secret.csv", "../{}/secret.csv", "/etc/passwd", "./hull.csv"])
def test_no_other_file_is_read(importing: Source, tmp_path: Path, path: str) -> None:
    """Whatever path a page says: those that the scene names itself, as it names them."""
    text = IMPORTING.replace("hull.csv", path.format(tmp_path.name))
    raw = errands_of({"mine": importing}, "mine")[Text](Text(1, text, "mine"))
    (fault,) = json.loads(raw)["faults"]
    assert fault["line"] == 3
    assert "only hull.csv and tugs.csv may be read here" in fault["sentence"]
