"""An answer file can be asked again: the same answer comes out, to the last byte."""

import io
import json
import sys

import pytest

from swarmgrasp.cli.app import COMMANDS

WRENCHES = "fx,fy,tz\n100,0,-50\n0,100,-150\n0,0,-50\n"
ASKED = {
    "place": ["place", "pontoon"],
    "several": ["place", "pontoon", "--robots", 3, "--gap", 1e-4, "--losing", 1],
    "few runners-up": ["place", "deck-barge", "--runners-up", 1],
    "together": ["place", "pontoon", "--robots", 2, "--together", "--effort", 60],
    "move": ["move", "model-ship"],
    "count": ["count", "pontoon", "--quality", 300, "--effort", 60, "--most", 3],
    "quality": ["quality", "rectangle-5"],
    "quality by a criterion": ["quality", "rectangle-15", "--losing", 1, "--sensitivities"],
    "forces": ["forces", "pontoon", "--wrench", 500, 0, -100, "--load", 0, 30, 0],
    "forces along": ["forces", "pontoon", "--wrenches", "wrenches.csv"],
    "run": [
        "simulate",
        "supply-vessel",
        "--wind",
        10,
        "--from",
        60,
        "--for",
        3,
        "--losing",
        "bow tunnel 1@1",
        "--within",
        50,
        "--turn",
        90,
    ],
    "winds": ["simulate", "model-ship", "--for", 0.5, "--capability", "--turn", 2],
    "judgement": ["judge", "model-ship", "--mass", 30],
    "capability": ["capability", "model-ship", "--step", 30, "--losing", 2],
}


@pytest.fixture
def answer_of(run, pontoon, tmp_path, monkeypatch):
    """Return the file of an answer, and what was said beside it."""
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "86400")
    monkeypatch.chdir(tmp_path)
    (tmp_path / "wrenches.csv").write_text(WRENCHES)

    def answer_of(command, *arguments):
        given = [pontoon if each == "pontoon" else each for each in arguments]
        given += [] if command == "capability" else ["--units", "si"]  # the units of answer files
        status, said, complaints = run(command, *given, "--json", "answer.json")
        assert (status, complaints) == (0, "")
        return (tmp_path / "answer.json").read_bytes(), said

    return answer_of


@pytest.mark.parametrize("name", ASKED)
def test_the_same_answer_comes_out(answer_of, tmp_path, name):
    """With the options of the first time; files say what they are, of what, by whom and when."""
    command = ASKED[name][0]
    first, said = answer_of(*ASKED[name])
    (tmp_path / "first.json").write_bytes(first)
    assert answer_of(command, tmp_path / "first.json") == (first, said)
    document = json.loads(first)
    assert document["format"].startswith("swarmgrasp ")
    assert document["date"] == "1970-01-02T00:00:00Z"
    assert document["units"] == "SI: m, N, N m, rad"


def test_every_command_that_reads_a_question_is_asked():
    """But those without an answer file: of pictures, of many runs, and of checks."""
    asked = {arguments[0] for arguments in ASKED.values()}
    assert asked == {command.__name__ for command in COMMANDS} - {
        "agent", "convert", "examples", "paper", "plot", "report", "schema", "studio", "study",
        "verify",
    }  # fmt: skip


def test_options_given_anew_hold(answer_of, tmp_path):
    """More robots, another criterion, another wrench; and any command may read any answer."""
    first, _ = answer_of("place", "pontoon")
    (tmp_path / "first.json").write_bytes(first)
    anew = json.loads(answer_of("place", tmp_path / "first.json", "--robots", 2, "--losing", 1)[0])
    assert len(anew["placements"]) == 2
    assert anew["problem"]["criterion"]["losing"] == 1
    graded = json.loads(answer_of("quality", tmp_path / "first.json")[0])
    assert graded["value"] == json.loads(first)["placements"][0]["quality_before"]


@pytest.mark.parametrize(
    ("change", "said"),
    [
        ({"problem": None}, "a 'swarmgrasp placements 3' holds no question"),
        ({"problem": 3}, "problem: should be a mapping of swarm, newcomer, zones"),
        ({"placements": 5}, "placements: should be a list; it is 5"),
        ({"placements": [5]}, "placements: should be a list of mappings"),
        ({"format": "swarmgrasp together 3", "asked_effort": "a lot"}, "should be a whole number"),
        ({"placements": [{"asked_gap": "wide"}]}, "the gap is 'wide'; it should be 0 < gap < 1"),
    ],
)
def test_a_question_with_faults_is_refused(run, answer_of, tmp_path, change, said):
    """As a scenario is: by name, with status 2."""
    document = json.loads(answer_of("place", "pontoon")[0])
    path = tmp_path / "changed.json"
    path.write_text(json.dumps(document | change))
    status, printed, complaints = run("place", path)
    assert (status, printed) == (2, "")
    assert said in complaints
    assert complaints.startswith(str(path))


@pytest.mark.parametrize(
    ("asked", "command", "holds", "needs"),
    [
        ("forces", ["place"], "push forces, with no newcomer", "`swarmgrasp place` needs one"),
        ("quality", ["count", "--quality", 3], "quality, with no newcomer", "`swarmgrasp count`"),
        ("forces along", ["plot", "a.svg", "--what", "landscape"], "push forces", "needs one"),
        ("capability", ["place"], "the largest wind held, with no newcomer", "needs one"),
        ("move", ["capability"], "which robot should move, with no environment", "needs one"),
        ("place", ["place", "--worst-case"], "where robots go, with no tolerance", "--worst-case"),
    ],
)
def test_another_command_may_need_more(run, answer_of, tmp_path, asked, command, holds, needs):
    """Said of the answer's question; nothing is advised that only scenario files can hold."""
    (tmp_path / "first.json").write_bytes(answer_of(*ASKED[asked])[0])
    status, said, complaints = run(command[0], "first.json", *command[1:])
    assert (status, said) == (2, "")
    assert complaints.startswith("first.json holds a question about ")
    assert complaints.endswith("; ask it of the scenario\n")
    assert holds in complaints
    assert needs in complaints


@pytest.mark.parametrize(
    ("asked", "command", "lacking"),
    [
        ("capability", ["quality"], "load or task"),
        ("capability", ["forces", "--wrench", 1, 0, 0], "load"),
        ("capability", ["forces", "--wrench", 1, 0, 0, "--load", 0, 0, 0], ""),
        ("forces", ["quality"], "loss, failure, worst case or task"),
        ("forces along", ["quality", "--losing", 1], "failure, worst case or task"),
        ("quality", ["move"], "newcomer"),
        ("quality", ["forces", "--wrench", 1, 0, 0], ""),
        ("move", ["quality"], ""),
        ("quality", ["plot", "a.svg"], "newcomer"),
    ],
)
def test_what_another_command_goes_without_is_said(
    run, answer_of, tmp_path, asked, command, lacking
):
    """In one line on standard error, unless an option says it instead."""
    (tmp_path / "first.json").write_bytes(answer_of(*ASKED[asked])[0])
    status, _, complaints = run(command[0], "first.json", *command[1:])
    assert status == 0
    line = f", with no {lacking}: `swarmgrasp {command[0]}` goes without\n"
    assert complaints.endswith(line if lacking else "")
    assert complaints.count("holds a question") == bool(lacking)


def test_what_another_question_holds_is_kept(run, answer_of, tmp_path):
    """The load of push forces counts in the quality that is left beside it."""
    (tmp_path / "first.json").write_bytes(answer_of(*ASKED["forces"])[0])
    told = json.loads(run("quality", "first.json", "--json", "-")[1])
    assert told["criterion"]["load"] == [0, 30, 0]


@pytest.mark.parametrize(
    ("tail", "said"),
    [
        ('"a": ' + "[" * 19 + "]" * 19 + "}", "holds no question"),
        ('"a": ' + "[" * 20 + "]" * 20 + "}", "nested too deep; at most 20 levels are read"),
        ('"a": ' + "[" * 100_000, "nested too deep; at most 20 levels are read"),
        ('"a": 1' + "0" * 4300 + "}", "holds a number of more than 4300 digits"),
        ('"a": 1', "Expecting ',' delimiter"),
    ],
)
@pytest.mark.parametrize("source", ["file", "-"])
def test_an_answer_that_cannot_be_read_is_no_scenario(
    run, tmp_path, monkeypatch, tail, said, source
):
    """Told in one sentence by every command, the check included; never as keys of a scenario."""
    path = tmp_path / "answer.json"
    path.write_text('{"format": "swarmgrasp placements 3", ' + tail)
    for command in ("place", "quality", "verify"):
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(path.read_bytes())))
        status, printed, complaints = run(command, path if source == "file" else source)
        assert (status, printed) == (2, "")
        assert all(line.startswith(("<stdin>", str(path))) for line in complaints.splitlines())
        assert "outline" not in complaints
        assert said in complaints or (command, said) == ("verify", "holds no question")
