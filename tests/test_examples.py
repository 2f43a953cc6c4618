"""The examples run as they stand."""

import runpy
from pathlib import Path

import pytest

EXAMPLES = sorted((Path(__file__).parent.parent / "examples").glob("*.py"))


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda path: path.stem)
def test_an_example_runs(path, tmp_path, monkeypatch, capsys):
    """It prints something and writes the pictures it promises."""
    monkeypatch.chdir(tmp_path)
    runpy.run_path(str(path), run_name="__main__")
    assert "The proof holds." in capsys.readouterr().out
    assert {p.name for p in tmp_path.iterdir()} == {
        "barge-plan.png", "barge-wrenches.png", "barge-landscape.png"
    }  # fmt: skip
