"""The examples, run as the documents are built: a page of pictures, and a page for each."""

import subprocess
import sys
from ast import get_docstring, parse
from pathlib import Path

from sphinx.application import Sphinx


def ran(example: Path, folder: Path) -> str:
    """Run an example in a folder, where its pictures go; return what it prints."""
    folder.mkdir(parents=True, exist_ok=True)
    done = subprocess.run(
        [sys.executable, "-W", "error", example],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
    )
    if done.returncode:
        raise RuntimeError(f"{example} ended with {done.returncode}:\n{done.stderr}")
    return done.stdout.rstrip()


def page_of(example: Path, folder: Path) -> tuple[str, str]:
    """Return an example's page, and its entry among all: its first picture and its sentence."""
    text = example.read_text("utf-8")
    about = (get_docstring(parse(text)) or "").splitlines()[0].rstrip(".").split(":")[0]
    printed, name = ran(example, folder / example.stem), example.stem
    drawn = sorted(path.name for path in (folder / name).glob("*.png"))
    drawn.sort(key=text.index)
    pictures = "\n\n".join(f"![{about}]({name}/{picture})" for picture in drawn)
    code = f"```{{literalinclude}} ../../../examples/{example.name}\n:language: python\n```"
    page = f"# {about}\n\n{pictures}\n\n```text\n{printed}\n```\n\n{code}\n"
    return page, f"[![{about}]({name}/{drawn[0]})]({name}.md)\n[{about}]({name}.md)"


def write(app: Sphinx) -> None:
    """Write the pages into a folder of the documents that is not kept."""
    source = Path(app.srcdir)
    folder = source / "generated" / "gallery"
    examples = sorted((source.parent / "examples").glob("*.py"))
    entries = []
    for example in examples:
        page, entry = page_of(example, folder)
        (folder / f"{example.stem}.md").write_text(page)
        entries.append(entry)
    listed = "\n".join(example.stem for example in examples)
    (folder / "index.md").write_text(
        "# Gallery\n\nThe examples that come with the sources, run as this page was built.\n\n"
        "`````{container} gallery\n" + "\n\n".join(entries) + "\n`````\n\n"
        f"```{{toctree}}\n:hidden:\n\n{listed}\n```\n"
    )


def setup(app: Sphinx) -> dict[str, bool]:
    """Register with Sphinx."""
    app.connect("builder-inited", write)
    return {"parallel_read_safe": True}
