import sys

import pytest

from swarmgrasp.pages.statements import Statement
from swarmgrasp.pages.writing import Report
from swarmgrasp.paper import report
from swarmgrasp.paper.sizes import FULL, QUICK


@pytest.fixture
def asked(monkeypatch):
    """Replace the report by what was asked for; its second statement fails."""
    asked = []

    def write(folder, size, seed, progress):
        asked.append((folder, size, seed, progress))
        said = Statement("One is one.", holds=True), Statement("One is two.", holds=size is FULL)
        return Report((folder / "paper.html",), said)

    monkeypatch.setattr(report, "write_report", write)
    return asked


def test_it_says_what_holds_and_what_was_written(run, asked, tmp_path):
    """All is well; no bar, as standard error is no terminal."""
    status, said, complaints = run("paper", tmp_path / "new")
    assert (status, complaints) == (0, "")
    assert said == f"All 2 statements of the report hold\n\nwrote {tmp_path}/new/paper.html\n"
    assert asked == [(tmp_path / "new", FULL, 1, None)]


def test_what_does_not_hold_is_told(run, asked, tmp_path):
    """In full, on standard output; the report is written all the same."""
    status, said, _ = run("paper", tmp_path, "--quick", "--seed", "7")
    assert status == 1
    assert said.splitlines()[:2] == [
        "1 of 2 statements of the report hold", "not so: One is two."
    ]  # fmt: skip
    assert asked == [(tmp_path, QUICK, 7, None)]


def test_faults_come_before_any_measurement(run, asked, tmp_path):
    """A file in the way and a seed that is none, at once; nothing is created."""
    (tmp_path / "file").write_text("")
    status, said, complaints = run("paper", tmp_path / "file" / "new", "--seed", "1.5")
    assert (status, said, asked) == (2, "", [])
    assert complaints.splitlines() == [
        f"{tmp_path}/file: is no folder; choose another",
        "--seed is 1.5; it should be a whole number from 0 to 999999999",
    ]


def test_a_folder_that_may_not_be_written_to(run, asked, tmp_path, monkeypatch):
    """The nearest folder there is decides."""
    monkeypatch.setattr("os.access", lambda *_: False)
    status, _, complaints = run("paper", tmp_path / "a" / "b")
    assert (status, asked) == (2, [])
    assert complaints == f"{tmp_path}: the folder may not be written to; choose another\n"


def test_without_scipy_nothing_is_measured(run, tmp_path, monkeypatch):
    """The remedy is told, and no folder is left."""
    monkeypatch.setitem(sys.modules, "scipy.optimize", None)
    status, said, complaints = run("paper", tmp_path / "new", "--quick")
    assert (status, said) == (2, "")
    assert "pip install 'swarmgrasp[paper]'" in complaints
    assert not (tmp_path / "new").exists()
