"""The notebooks of the documents: kept without what they show, and each runs."""

import json
from pathlib import Path

import pytest

DOCS = Path(__file__).parent.parent / "docs"
NOTEBOOKS = sorted((DOCS / "notebooks").glob("*.ipynb"))
each = pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)


@each
def test_a_notebook_is_kept_without_what_it_shows(path):
    """That is made anew as the documents are built, where it has its place."""
    notebook = json.loads(path.read_text("utf-8"))
    codes = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
    assert len(codes) > 3
    assert all(not cell["outputs"] and cell["execution_count"] is None for cell in codes)
    assert f"\nnotebooks/{path.stem}\n" in (DOCS / "index.md").read_text("utf-8")


@pytest.mark.long
@each
def test_a_notebook_runs_and_shows_answers(path):
    """From its first cell to its last, in a kernel of its own."""
    nbformat, nbclient = pytest.importorskip("nbformat"), pytest.importorskip("nbclient")
    notebook = nbformat.read(path, as_version=4)
    nbclient.NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    shown = [
        kind
        for cell in notebook.cells
        for output in cell.get("outputs", ())
        for kind in output.get("data", ())
    ]
    assert {"text/html", "image/svg+xml"} & set(shown)
    assert "application/vnd.jupyter.widget-view+json" in shown or "ipywidgets" not in str(notebook)
