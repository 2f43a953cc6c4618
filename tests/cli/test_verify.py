import io
import json
import re
import sys

import pytest

from swarmgrasp.verify.digest import digest_of


@pytest.fixture
def answer(run, pontoon, tmp_path):
    """Write an answer file for two newcomers."""
    path = tmp_path / "answer.json"
    assert run("place", pontoon, "--robots", 2, "--json", path)[0] == 0
    return path


def tamper(path, change, *, sealed):
    """Change an answer file; a sealed one gets a digest that fits."""
    document = json.loads(path.read_text())
    change(document["placements"][0])
    if sealed:
        document["digest"] = digest_of(document)
    path.write_text(json.dumps(document))


def move(placement):
    placement["robot"]["contact"][0] += 1e-3


def lower(placement):
    placement["upper_bound"] -= 1e-3 * placement["upper_bound"]


def rename(placement):
    placement["robot"]["name"] = "F"


def test_a_good_answer_is_verified(run, answer):
    """The verdict shows each robot with its recomputed bound."""
    status, said, complaints = run("verify", answer)
    assert (status, complaints) == (0, "")
    assert said.startswith(f"{answer}: verified\n")
    assert said.count("no allowed place exceeds") == 2
    assert len(re.findall(r"the answer is (at most \S+ % below )?the best possible", said)) == 2
    question = "a robot of 1.5 kN, pushing within 28.65 deg of the normal; the whole boundary, "
    assert f"Question  {question}no no-go stretches, no spacing\n" in said
    assert "It does not check whether the file asks your question" in said
    assert "Metric: force weights 1 and 1, characteristic length" in said


def test_an_answer_is_told_in_the_units_and_the_frame_of_its_file(run, tmp_path):
    """They are kept in the answer, whose numbers are SI's; every command reads them again."""
    barge = tmp_path / "barge.yaml"
    barge.write_text(
        "units: {length: ft, force: tf, angle: deg}\nframe: NED\nwords: tug\n"
        "outline: {vertices: [[-130, -33], [130, -33], [130, 33], [-130, 33]]}\n"
        "robots: []\nspacing: 15\nnewcomer: {name: Ajax, limit: 40, attachment: push}\n"
        "criterion: {load: [1, 2, 30]}\n"
    )
    path = tmp_path / "answer.json"
    assert run("place", barge, "--json", path)[0] == 0
    said = run("verify", path)[1]
    assert "Question  a tug of 40 tf, pushing within 90 deg of the normal; the whole" in said
    assert "spacing 15 ft\n" in said
    assert "beside a load of 1.0000 tf, 2.0000 tf and 30.00 tf ft\n" in said
    assert re.search(r"Ajax      at \(\S+ \S+\) ft, ", said)
    assert "Frame: x forward, y to starboard, as in the file" in said
    assert "a tug of 392.27 kN" in run("verify", path, "--units", "si")[1]
    assert "bearing" in run("verify", path, "--bearings")[1]
    assert "out of reach by 2.2472 tf" in run("quality", path)[1]
    document = json.loads(path.read_text())
    document["terms"]["length"] = "cubit"
    path.write_text(json.dumps(document | {"digest": digest_of(document)}))
    status, _, complaints = run("verify", path)
    assert (status, complaints.count("\n")) == (2, 1)
    assert f"{path}: terms: the unit of length is 'cubit'; it should be one of m, " in complaints


def test_standard_input_and_json(run, answer, monkeypatch):
    """`place --json - | verify - --json -` works."""
    monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(answer.read_bytes())))
    status, said, _ = run("verify", "-", "--json", "-")
    verdict = json.loads(said)
    assert status == 0
    assert (verdict["verified"], verdict["faults"]) == (True, [])
    assert len(verdict["upper_bounds"]) == 2
    assert 0.0 <= verdict["gap"] <= 2e-6


@pytest.mark.parametrize("change", [move, lower, rename])
def test_an_altered_answer_is_refused(run, answer, change):
    """A moved contact, a lower bound or another name: the digest tells."""
    tamper(answer, change, sealed=False)
    status, said, complaints = run("verify", answer)
    assert (status, complaints) == (1, "")
    assert said.startswith(f"{answer}: refused")
    assert "- the digest does not fit the content: the file was altered\n" in said


@pytest.mark.parametrize("change", [move, lower])
def test_a_forged_digest_does_not_help(run, answer, change):
    """What the answer claims is recomputed, whatever its digest says."""
    tamper(answer, change, sealed=True)
    status, said, _ = run("verify", answer)
    assert status == 1
    assert "the digest does not fit" not in said
    assert said.count("\n- ") >= 1


@pytest.mark.parametrize(
    ("text", "fault"),
    [
        (None, ": there is no such file\n"),
        ("{", ":1:2: "),
        ("[]", "an answer is a JSON object"),
        ("{}", ": not an answer file; `swarmgrasp place --json` writes one\n"),
        ("name: x", ": not an answer file; `swarmgrasp place --json` writes one\n"),
        ('{"format": "swarmgrasp placements 3"}', "placements: is missing"),
    ],
)
def test_what_is_no_answer_is_malformed(run, tmp_path, text, fault):
    """A missing file, broken JSON or missing entries give status 2, with the file's name."""
    path = tmp_path / "broken.json"
    if text is not None:
        path.write_text(text)
    status, said, complaints = run("verify", path)
    assert (status, said) == (2, "")
    assert all(line.startswith(str(path)) for line in complaints.splitlines())
    assert fault in complaints
