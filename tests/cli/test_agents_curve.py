"""`swarmgrasp agents curve`."""

import pytest

from swarmgrasp.agents.knowledge import FULL, QUICK
from swarmgrasp.pages import curve
from swarmgrasp.pages.statements import Statement
from swarmgrasp.pages.writing import Report


@pytest.fixture
def asked(monkeypatch):
    """Replace the study by what was asked for; its second statement fails."""
    asked = []

    def write(folder, size, seed, progress):
        asked.append((folder, size, seed, progress))
        said = Statement("One is one.", holds=True), Statement("One is two.", holds=size is FULL)
        return Report((folder / "communication.html",), said), None

    monkeypatch.setattr(curve, "write_curve", write)
    return asked


def test_it_says_what_holds_and_what_was_written(run, asked, tmp_path):
    """A full run in which all is well, and a quick one in which something is not."""
    status, said, complaints = run("agents", "curve", tmp_path / "new")
    assert (status, complaints) == (0, "")
    assert (
        said == f"All 2 statements of the report hold\n\nwrote {tmp_path}/new/communication.html\n"
    )
    _, said, _ = run("agents", "curve", tmp_path, "--quick", "--seed", "7")
    assert said.splitlines()[:2] == [
        "1 of 2 statements of the report hold", "not so: One is two."
    ]  # fmt: skip
    assert asked == [(tmp_path / "new", FULL, 1, None), (tmp_path, QUICK, 7, None)]


def test_faults_come_before_any_measurement(run, asked, tmp_path):
    """A file in the way and a seed that is none, at once."""
    (tmp_path / "file").write_text("")
    status, said, complaints = run("agents", "curve", tmp_path / "file", "--seed", "x")
    assert (status, said, asked) == (2, "", [])
    assert len(complaints.splitlines()) == 2
