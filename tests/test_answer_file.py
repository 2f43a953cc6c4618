"""What stands around an answer in its file: what it is, whose, by which program, and when."""

import errno
import json
import os
from datetime import datetime, timedelta, timezone
from importlib.metadata import version

import pytest

from answers import QUESTION, honest_document
from swarmgrasp import Placements, place_sequence, read_answer, write_answer
from swarmgrasp.answer_file import document_of
from swarmgrasp.errors import AnswerInvalid
from swarmgrasp.files import scratch_for
from swarmgrasp.verify import verify_document
from swarmgrasp.verify.digest import digest_of

NOON = datetime(2031, 5, 4, 12, 0, 7, tzinfo=timezone(timedelta(hours=2)))


@pytest.fixture(scope="module")
def answers():
    """Return two newcomers placed one after the other."""
    return place_sequence(QUESTION, 2)


def test_a_file_says_what_it_is(answers, tmp_path):
    """Format, name, version, date in UTC and units stand before the answer; the digest is last."""
    write_answer(tmp_path / "a.json", answers, "Zoë's quay", NOON)
    document = read_answer(tmp_path / "a.json")
    head = {
        "format": "swarmgrasp placements 3", "name": "Zoë's quay",
        "version": version("swarmgrasp"), "date": "2031-05-04T10:00:07Z",
        "units": "SI: m, N, N m, rad",
    }  # fmt: skip
    assert list(document) == [*head, *answers.to_data(), "digest"]
    assert document == {**head, **answers.to_data(), "digest": digest_of(document)}


def test_answers_stand_in_the_order_in_which_they_joined(answers, tmp_path):
    """So do the bounds that the check finds, and each finds the robots before it."""
    write_answer(tmp_path / "a.json", answers)
    document = read_answer(tmp_path / "a.json")
    told = [(p["robot"]["name"], p["quality_before"]) for p in document["placements"]]
    first, second = answers
    assert told == [("Fred 1", first.quality_before), ("Fred 2", second.quality_before)]
    assert first.upper_bound < 0.99 * second.upper_bound
    bounds = [first.upper_bound, second.upper_bound]
    assert verify_document(document).upper_bounds == pytest.approx(bounds, rel=1e-9)


@pytest.mark.parametrize("key", ["format", "name", "version", "date", "units"])
def test_the_digest_covers_what_stands_around(key):
    """An answer said to be of another day or another program is an altered one."""
    document = {**honest_document(), key: "other"}
    assert document["digest"] != digest_of(document)


def test_files_can_be_made_again(answers, monkeypatch):
    """With SOURCE_DATE_EPOCH the same answer is the same file."""
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "86400")
    assert document_of(answers)["date"] == "1970-01-02T00:00:00Z"
    monkeypatch.setenv("SOURCE_DATE_EPOCH", "soon")
    with pytest.raises(AnswerInvalid, match="SOURCE_DATE_EPOCH is 'soon'; it should be a whole"):
        document_of(answers)


def test_a_sequence_is_one_question(answers):
    """Answers that do not follow one from the other are not written as if they did."""
    first, second = answers
    other = place_sequence(QUESTION, 1, gap=1e-3)[0]
    with pytest.raises(AnswerInvalid, match="was placed in another swarm"):
        Placements([second, first])
    with pytest.raises(AnswerInvalid, match="give a list of at least one"):
        Placements([])
    assert json.dumps(Placements([other]).to_data()) == json.dumps(other.to_data())


def test_a_full_disk_is_told_with_the_file(tmp_path):
    """Not with the scratch file beside it, nor without a name; another file keeps its own."""
    target, said = tmp_path / "answer.json", os.strerror(errno.ENOSPC)
    for named in (False, True):

        def write(named=named):
            with scratch_for(target) as scratch:
                raise OSError(errno.ENOSPC, said, scratch if named else None)

        with pytest.raises(OSError, match="No space") as caught:
            write()
        assert (caught.value.filename, list(tmp_path.iterdir())) == (str(target), [])
    with pytest.raises(OSError, match="No space") as caught, scratch_for(target):
        raise OSError(errno.ENOSPC, said, "other.json")
    assert caught.value.filename == "other.json"
