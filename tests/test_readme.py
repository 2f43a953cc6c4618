"""The README shows what the program prints today."""

import contextlib
import io
import re
import runpy
from pathlib import Path

import pytest

from shown import assert_same, assert_within
from swarmgrasp.cli import main

ROOT = Path(__file__).parent.parent
README = (ROOT / "README.md").read_text(encoding="utf-8")


def blocks(kind):
    return re.findall(rf"```{kind}\n(.*?)```", README, re.DOTALL)


@pytest.mark.parametrize("block", [b for b in blocks("console") if "$ .venv" in b])
def test_a_command_prints_what_the_readme_shows(block, capsys, monkeypatch):
    """Standard output of a command that works, the complaints of one that does not.

    A line "..." stands for lines left out.
    """
    monkeypatch.chdir(ROOT)
    command, _, shown = block.partition("\n")
    status = main(command.removeprefix("$ .venv/bin/swarmgrasp ").split())
    said = capsys.readouterr()
    assert_within(shown, said.out if status == 0 else said.err)


def test_the_python_examples_print_what_the_readme_shows():
    """The code blocks run as they stand."""
    for code, shown in zip(blocks("python"), blocks("text"), strict=True):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(code, {})
        assert_same(shown, printed.getvalue())


def test_every_file_the_readme_links_is_there():
    """No dead links."""
    for target in re.findall(r"\]\(([^)#:]+)\)", README):
        assert (ROOT / target).exists(), target


def test_an_index_shows_no_link_that_leads_nowhere(monkeypatch):
    """Pictures and links into the sources go; what they are on stays, and code is as it was."""
    setuptools = pytest.importorskip("setuptools")
    given = {}
    monkeypatch.setattr(setuptools, "setup", lambda **words: given.update(words))
    monkeypatch.chdir(ROOT)
    runpy.run_path("setup.py")
    shown = given["long_description"]
    assert not re.findall(
        r"\]\((?!https?:)[^)\s]*\)", re.sub(r"```.*?```", "", shown, flags=re.DOTALL)
    )
    assert "the conventions" in shown
    assert re.findall(r"```.*?```", shown, re.DOTALL) == re.findall(r"```.*?```", README, re.DOTALL)
