"""The form of an answer file: every fault of it is told, and none is a crash."""

import copy
import math

import pytest

from answers import first, honest_document
from swarmgrasp import read_answer
from swarmgrasp.errors import AnswerInvalid
from swarmgrasp.verify import verify_document
from swarmgrasp.verify.digest import digest_of

TOLERANCE = {
    "contact": [-0.1, 0.1], "direction": [0.0, 0.0], "least_limit": None, "may_be_absent": False
}  # fmt: skip
NOTHING, ONE = [[0.0, 0.0, 0.0]], [[1.0, 0.0, 0.0]]
SWARM = ("problem", "swarm")
ROBOT = (*SWARM, "robots", 0)


@pytest.fixture
def document():
    """Return an honest document to spoil."""
    return copy.deepcopy(honest_document())


@pytest.mark.parametrize(
    ("where", "value", "says"),
    [
        (("format",), "swarmgrasp answer 2", "format: Input should be 'swarmgrasp placements 3'"),
        ((*SWARM, "characteristic_length"), math.nan, "should be a finite number"),
        ((*SWARM, "characteristic_length"), 0.0, "greater than 0"),
        ((*SWARM, "characteristic_length"), 5e-324, "should be at least 1e-100"),
        ((*SWARM, "force_weights"), [1.0], "swarm.force_weights"),
        ((*SWARM, "force_weights"), [-1.0, 1.0], "swarm.force_weights"),
        ((*SWARM, "force_weights"), [0.0, 1.0], "swarm.force_weights"),
        ((*SWARM, "outline", "vertices"), [[0, 0], [1, 0]], "at least 3"),
        ((*SWARM, "outline", "vertices"), [[0, 0], [1, 0], [1, math.inf]], "finite"),
        ((*SWARM, "outline", "vertices"), [[1, 1]] * 4, "outline"),
        (
            (*SWARM, "outline", "vertices"),
            [[-2, 1], [2, 1], [2, -1], [-2, -1]],
            "outline",
        ),  # clockwise
        (
            (*ROBOT, "limit"),
            "1",
            "robots.0.limit: Input should be a valid number",
        ),
        ((*ROBOT, "limit"), -1.0, "robots.0.limit"),
        ((*ROBOT, "mounted"), 0, "robots.0.mounted"),
        ((*ROBOT, "envelope"), [], "robots.0.envelope: List should have at least 2 items"),
        (("placements",), [], "placements"),
        (("placements", 0, "quality"), True, "placements.0.quality"),
        (("placements", 0, "quality"), 10**400, "placements.0.quality"),
        (("placements", 0, "robot", "contact"), [0.0], "placements.0.robot.contact"),
        (("problem", "newcomer", "attachment"), "glue", "newcomer.attachment"),
        (("problem", "newcomer", "half_angle"), 10.0, "half_angle"),
        (("problem", "zones", 0, "stretch", "start"), -1.0, "zones.0.stretch.start"),
        (("problem", "zones", 0, "stretch", "end"), 1e9, "zones.0"),
        (("problem", "spacing"), 1e308, ""),
        (("placements", 0, "proofs", 0, "normals"), [[1.0, 0.0]], "proofs.0.normals"),
        (("placements", 0, "proofs", 0, "weights"), [], "proofs.0.weights"),
        (
            (*ROBOT, "tolerance"),
            {},
            "robots.0.tolerance.contact: is missing",
        ),
        (
            (*ROBOT, "tolerance"),
            {**TOLERANCE, "contact": [0.1, 0.2]},
            "tolerance.contact.0",
        ),
        (
            (*ROBOT, "tolerance"),
            {**TOLERANCE, "direction": [0.0, 4.0]},
            "direction.1",
        ),
        (
            (*ROBOT, "tolerance"),
            {**TOLERANCE, "least_limit": 0.0},
            "least_limit",
        ),
        (
            (*ROBOT, "tolerance"),
            {**TOLERANCE, "may_be_absent": 1},
            "may_be_absent",
        ),
        (("problem", "criterion"), None, "problem.criterion"),
        (("problem", "criterion", "losing"), -1, "criterion.losing"),
        (("problem", "criterion", "losing"), 0.5, "criterion.losing"),
        (("problem", "criterion", "load"), [0.0, 0.0], "criterion.load"),
        (("problem", "criterion", "task"), {"ball": [[1, 0, 0]]}, "task.ball: unknown key"),
        (("problem", "criterion", "task"), {"vertices": []}, "task.vertices"),
        (("problem", "criterion", "task"), {"axes": NOTHING}, "at least 1e-100"),
        (("problem", "criterion", "task"), {"axes": ONE, "vertices": ONE}, "either"),
        (("problem", "criterion", "task"), {}, "either"),
        (("digest",), 5, "digest"),
    ],
)
def test_a_malformed_entry_is_named(document, where, value, says):
    """Wrong kinds, wrong signs, numbers that are none: refused before anything is computed."""
    spot = document
    for key in where[:-1]:
        spot = spot[key]
    spot[where[-1]] = value
    with pytest.raises(AnswerInvalid) as caught:
        verify_document(document)
    assert any(says in fault for fault in caught.value.faults), caught.value.faults


def test_a_mounted_robot_stays_where_it_is(document):
    """It may turn the wrong way, and not drift along the boundary."""
    document["problem"]["swarm"]["robots"][0].update(mounted=True, tolerance=TOLERANCE)
    with pytest.raises(AnswerInvalid, match="a mounted robot's contact has no tolerance"):
        verify_document(document)


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ({"envelope": [[1.0, 0.0], [0.0, 1.0]], "steers": 0.5}, "an envelope says all forces"),
        ({"friction": 0.5, "reverse_limit": 1.0}, "friction goes with neither steering nor"),
        ({"least": 0.5, "reverse_limit": 1.0}, "the least force is at most the limit"),
        ({"least": 1e9}, "the least force is at most the limit"),
    ],
)
def test_a_robot_is_of_one_kind(document, more, says):
    """What no robot can be is refused, whatever the check would make of it."""
    document["problem"]["swarm"]["robots"][0].update(more)
    with pytest.raises(AnswerInvalid, match=says):
        verify_document(document)


def test_every_missing_and_every_unknown_entry_is_named(document):
    """All faults at once."""
    del document["problem"]["swarm"]["outline"], first(document)["robot"]["limit"]
    document["extra"] = first(document)["quality_afterwards"] = 1
    with pytest.raises(AnswerInvalid) as caught:
        verify_document(document)
    named = {fault.partition(":")[0] for fault in caught.value.faults}
    assert named == {
        "problem.swarm.outline", "placements.0.robot.limit", "extra",
        "placements.0.quality_afterwards",
    }  # fmt: skip


@pytest.mark.parametrize("document", [{}, [], None, "text", {"placements": object()}])
def test_what_is_no_answer_at_all(document):
    """Empty, of another kind, or not even data."""
    with pytest.raises(AnswerInvalid):
        verify_document(document)


@pytest.mark.parametrize(
    "text",
    ["", "{", "[1]", "nul", '{"a": ' + "[" * 5000, '{"a": ' + "1" * 5000 + "}", "\ufeff{}", "\x00"],
    ids=["empty", "open", "list", "word", "deep", "long number", "mark", "zero"],
)
def test_a_file_that_is_no_json_object(tmp_path, text):
    """Refused with the file's name."""
    path = tmp_path / "answer.json"
    path.write_text(text, encoding="utf-8")
    with pytest.raises(AnswerInvalid, match=r"answer\.json"):
        read_answer(path)


def test_a_file_that_is_not_there_or_not_text(tmp_path):
    """Neither is a crash."""
    (tmp_path / "bytes.json").write_bytes(b"\xff\xfe{}")
    for name in ("none.json", "bytes.json", "."):
        with pytest.raises(AnswerInvalid):
            read_answer(tmp_path / name)


def test_a_number_beyond_all_others_has_a_digest_and_is_refused():
    """Also in a document that no file was read for."""
    document = copy.deepcopy(honest_document())
    document["placements"][0]["quality"] = 10**400
    assert digest_of(document).startswith("sha256:")
    with pytest.raises(AnswerInvalid):
        verify_document(document)
