"""The pages show what the program prints today."""

import contextlib
import io
import re
from pathlib import Path

import pytest
from matplotlib.figure import Figure

import swarmgrasp
from shown import assert_same, assert_within
from swarmgrasp import errors, plot
from swarmgrasp.cli import main
from swarmgrasp.plot import sheet_of_run
from swarmgrasp.simulation.export import gif

ROOT = Path(__file__).parent.parent
DOCS = ROOT / "docs"
PAGES = sorted([*DOCS.glob("*.md"), *DOCS.glob("how-to/*.md")])
TOLD = re.compile(r"```console\n\$ swarmgrasp [^\n]*\n(?!\$|```)")
"""A command with some of what it prints."""
SHOWN = re.compile(r"```python\n(.*?)```\n\nprints\n\n```text\n(.*?)```", re.DOTALL)
VERSION = re.compile(r"MuJoCo \d+(\.\d+)+")
"""What judges here may be older or newer."""
PYTHON = re.compile(r"```python\n(.*?)```", re.DOTALL)


@pytest.mark.parametrize(
    "page", [p for p in PAGES if SHOWN.search(p.read_text("utf-8"))], ids=lambda page: page.stem
)
def test_the_code_of_a_page_prints_what_it_shows(page):
    """The blocks run one after the other, each with what those before it left."""
    names = {}
    for code, shown in SHOWN.findall(page.read_text("utf-8")):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(code, names)
        assert_same(shown, printed.getvalue())


@pytest.mark.parametrize(
    "page", [p for p in PAGES if TOLD.search(p.read_text("utf-8"))], ids=lambda page: page.stem
)
def test_the_commands_of_a_page_print_what_it_shows(page, tmp_path, monkeypatch, capsys):
    """They run one after the other, in one folder, with the files that the page shows."""
    monkeypatch.chdir(tmp_path)
    for slow in ("plan", "forces_plan", "capability_diagram"):  # tested where they are at home
        monkeypatch.setattr(plot, slow, lambda *_, **__: Figure())
    monkeypatch.setattr(sheet_of_run, "run_sheet", lambda *_, **__: Figure())
    monkeypatch.setattr(gif, "write_gif", lambda _, path, **__: path)
    text = page.read_text("utf-8")
    for name, written in re.findall(r"```yaml\n# (\S+)\n(.*?)```", text, re.DOTALL):
        Path(name).write_text(written)
    for block in re.findall(r"```console\n(.*?)```", text, re.DOTALL):
        command, _, shown = block.partition("\n")
        assert main(command.removeprefix("$ swarmgrasp ").split()) == 0
        printed = capsys.readouterr().out
        assert_within(*(VERSION.sub("MuJoCo", said) for said in (shown, printed)))


def test_the_python_of_readme_and_pages_passes_a_strict_type_checker(tmp_path, monkeypatch):
    """As it stands: the package is typed all through. Each block of the README is by itself."""
    api = pytest.importorskip("mypy.api")
    monkeypatch.chdir(ROOT)
    shown = {
        f"README_{k}": code
        for k, code in enumerate(PYTHON.findall((ROOT / "README.md").read_text("utf-8")))
    }
    shown |= {page.stem: "\n".join(PYTHON.findall(page.read_text("utf-8"))) for page in PAGES}
    paths = [tmp_path / f"{name.replace('-', '_')}.py" for name in shown]
    for path, code in zip(paths, shown.values(), strict=True):
        path.write_text(code, "utf-8")
    said, complained, status = api.run(["--strict", *map(str, paths)])
    assert (status, complained) == (0, ""), said


def test_every_public_name_has_its_place_in_the_reference():
    """And only one."""
    pages = "".join(page.read_text("utf-8") for page in (DOCS / "api").glob("*.md"))
    part = pages.split("currentmodule:: swarmgrasp\n")[1:]
    named = [name for text in part for name in re.findall(r"auto\w+:: (\w+)\n", text)]
    others = {name for name in swarmgrasp.__all__ if hasattr(errors, name)}  # a module of them
    assert sorted(named) == sorted({*swarmgrasp.__all__} - others)


def test_ten_questions_are_asked_in_their_order():
    """And none is left out."""
    text = (DOCS / "how-to" / "ten-questions.md").read_text("utf-8")
    numbers = re.findall(r"^## (\d+)\.", text, re.MULTILINE)
    assert [*map(int, numbers)] == [*range(1, 11)]
