"""The examples run as they stand."""

import re
import runpy
from pathlib import Path

import pytest

EXAMPLES = sorted((Path(__file__).parent.parent / "examples").glob("*.py"))


def run(path, folder, monkeypatch, capsys):
    """Return what an example prints, and the names of the files it writes."""
    monkeypatch.chdir(folder)
    runpy.run_path(str(path), run_name="__main__")
    return capsys.readouterr().out, {file.name for file in folder.iterdir()}


@pytest.mark.parametrize("path", EXAMPLES[1:], ids=lambda path: path.stem)
def test_an_example_runs(path, tmp_path, monkeypatch, capsys):
    """It prints its findings and writes the pictures it names, at least one."""
    printed, written = run(path, tmp_path, monkeypatch, capsys)
    promised = re.findall(r'"([\w-]+\.(?:png|svg|pdf))"', path.read_text(encoding="utf-8"))
    assert printed
    assert promised
    assert written >= set(promised)


def test_the_first_example_proves_its_answer(tmp_path, monkeypatch, capsys):
    """The proof holds, and all three pictures are there."""
    printed, written = run(EXAMPLES[0], tmp_path, monkeypatch, capsys)
    assert "The proof holds." in printed
    assert written == {"barge-plan.png", "barge-wrenches.png", "barge-landscape.png"}
