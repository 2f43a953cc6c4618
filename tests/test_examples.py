"""The examples run as they stand."""

import re
import runpy
from pathlib import Path

import pytest
from PIL import Image

from shown import assert_same
from swarmgrasp.cli import main

ROOT = Path(__file__).parent.parent
EXAMPLES = sorted((ROOT / "examples").glob("*.py"))
IMAGES = ROOT / "docs" / "images"
REDRAW = runpy.run_path(str(IMAGES / "redraw.py"))


def assert_same_picture(name, drawn):
    """Compare what is written in a picture of the pages with what is drawn today."""
    kept, today = (Image.open(path).text for path in (IMAGES / name, drawn))
    assert kept["Title"] == today["Title"]
    assert_same(kept["Description"], today["Description"])


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
    for name in REDRAW["OF_EXAMPLES"].keys() & written:
        assert_same_picture(REDRAW["OF_EXAMPLES"][name], tmp_path / name)


def test_the_first_example_proves_its_answer(tmp_path, monkeypatch, capsys):
    """The proof holds, and all three pictures are there."""
    printed, written = run(EXAMPLES[0], tmp_path, monkeypatch, capsys)
    assert "The proof holds." in printed
    assert written == {"barge-plan.png", "barge-wrenches.png", "barge-landscape.png"}


def test_the_pages_show_what_a_command_draws_today(tmp_path, monkeypatch):
    """`docs/images/redraw.py` draws them all again."""
    monkeypatch.chdir(tmp_path)
    command = next(command for command in REDRAW["COMMANDS"] if "harbour" in command)
    assert main(command.split()) == 0
    for name in REDRAW["COMMANDS"][command]:
        assert_same_picture(name, tmp_path / name)
