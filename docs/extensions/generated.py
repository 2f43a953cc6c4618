"""Pages made of the program itself: its commands, the keys of its files, and its tolerances.

They are written when the documents are built, so that they say what the program says on that day.
"""

import ast
import io
import os
from collections.abc import Iterator
from contextlib import chdir, redirect_stderr, redirect_stdout
from itertools import pairwise
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from sphinx.application import Sphinx

from swarmgrasp.cli import main
from swarmgrasp.cli.app import WRONG_INPUT
from swarmgrasp.scenario import scenario_schema

EXAMPLES = {
    "place": "place deck-barge",
    "move": "move escort-ring",
    "count": "count harbour-tugs --quality 400kN",
    "quality": "quality harbour-tugs --losing 1",
    "forces": "forces drillship-azimuths --wrench 1 0 0",
    "capability": "capability escort-ring",
    "simulate": "simulate tugs-and-barge --for 60",
    "study": "study model-ship runs --of gusts --runs 4",
    "verify": "verify answer.json",
    "judge": "judge model-ship",
    "plot": "plot deck-barge plan.png",
    "report": "report escort-ring sheet.html",
    "agents simulate": "agents simulate rectangle-5 --robots 8",
    "paper": None,
    "examples": "examples",
    "convert": "convert pontoon.csv pontoon.yaml",
    "schema": None,
}
"""What each command is shown with; None where it would take minutes, or fill pages."""
BEFORE = {"verify": "place deck-barge --json answer.json"}
FILES = {"convert": ("pontoon.csv", "x,y\n0,0\n60,0\n60,20\n0,20\n")}
LONGEST = 60
"""Lines of an example that are shown."""
CONSTANTS = ("src/swarmgrasp", "TOLERANCE", "ROUNDING", "GAP", "FLOOR", "LEAST", "MOST", "LARGEST")
"""Where constants are looked for, and what is in the names of those that users may meet."""
ROOMS = (
    "outline",
    "swarm",
    "quality",
    "placement",
    "verify",
    "forces",
    "environment",
    "capability",
)
"""Rooms that come first, in the order of the theory."""
NARROW = "\N{NO-BREAK SPACE}"
"""Keeps a short value in one line."""
CALLED = {"cli": "Command line", "gui": "The page in a browser", "plot": "Pictures"}


def said(command: str) -> str:
    """Return what a command prints, its complaints included; it has to know what is asked."""
    printed = io.StringIO()
    with redirect_stdout(printed), redirect_stderr(printed):
        status = main(command.split())
    if status == WRONG_INPUT:
        raise RuntimeError(f"swarmgrasp {command}: {printed.getvalue()}")
    return printed.getvalue().rstrip()


def names() -> list[str]:
    """Return the commands, groups taken apart, in the order of the program's help."""
    from swarmgrasp.cli.app import build

    found: list[str] = []
    for name in build():
        if name.startswith("-"):
            continue
        below = [part for part in build()[name] if not part.startswith("-")]
        found += [f"{name} {part}" for part in below] or [name]
    return found


def shown(command: str) -> str:
    """Return a command with its help, and with an example and what that prints."""
    page = [f"# swarmgrasp {command}", "", "```text", said(f"{command} --help"), "```", ""]
    example = EXAMPLES.get(command)
    if example:
        with TemporaryDirectory() as folder, chdir(folder):
            if command in FILES:
                name, text = FILES[command]
                Path(name).write_text(text)
            if command in BEFORE:
                said(BEFORE[command])
            lines = said(example).splitlines()
        cut = [*lines[:LONGEST], "..."] if len(lines) > LONGEST else lines
        page += ["## Example", "", "```console", f"$ swarmgrasp {example}", *cut, "```", ""]
    return "\n".join(page)


def keys() -> str:
    """Return the keys of scenario files, section by section, as the schema has them."""
    schema = scenario_schema()
    page = [
        "# Keys of scenario files",
        "",
        "Made of the schema that `swarmgrasp schema` prints; [the page on scenario files]"
        "(../scenario.md) says how they go together. `[units.length]` and the like: in the file's "
        "unit, or with a unit of its own.",
        "",
        *_table("The file", schema),
    ]
    for name, section in sorted(schema["$defs"].items()):
        if "properties" in section:
            page += _table(_section(name), section)
    return "\n".join(page)


def _section(name: str) -> str:
    """Return what a section is called on the page."""
    words = name.removesuffix("Section")
    return "".join(f" {letter.lower()}" if letter.isupper() else letter for letter in words).strip()


def _table(title: str, section: dict[str, Any]) -> Iterator[str]:
    """Go through the lines of a section."""
    needed = section.get("required", [])
    yield from (f"## {title.capitalize()}", "", section.get("description", ""), "")
    yield from ("| key | when left out | what it is |", "| --- | --- | --- |")
    for key, value in section["properties"].items():
        default = "must be there" if key in needed else _default(value)
        text = value.get("description", "").replace("|", "\\|").replace("\n", " ")
        yield f"| `{key}` | {default} | {text} |"
    yield ""


def _default(value: dict[str, Any]) -> str:
    """Return what a key is when it is left out."""
    default = value.get("default")
    return "" if default in (None, "") or isinstance(default, dict) else f"`{default}`"


def tolerances(root: Path) -> str:
    """Return the constants of the sources by which numbers are judged, with what they say."""
    rooms: dict[str, list[str]] = {room: [] for room in ROOMS}
    folder, *parts = CONSTANTS
    for path in sorted((root / folder).rglob("*.py")):
        body = ast.parse(path.read_text()).body
        where = path.relative_to(root / folder).with_suffix("")
        for line, after in pairwise(body):
            target, value = _assigned(line)
            if not any(part in target.split("_") for part in parts) or target.startswith("_"):
                continue
            if isinstance(after, ast.Expr) and isinstance(after.value, ast.Constant):
                about = " ".join(str(after.value.value).split()).replace("|", "\\|")
                value = value.replace(" ", NARROW) if len(value) < 12 else value
                entry = f"| `{target}` | `{value}` | `{where.as_posix()}` | {about} |"
                rooms.setdefault(where.parts[0], []).append(entry)
    page = [
        "# Tolerances and limits",
        "",
        "Made of the sources: where two numbers count as one, where searches end, the most of all.",
    ]
    for room, entries in rooms.items():
        name = CALLED.get(room, room.replace("_", " ").capitalize())
        head = ("| constant | value | module | what it is |", "| --- | --- | --- | --- |")
        page += ["", f"## {name}", "", *head, *entries] if entries else []
    return "\n".join([*page, ""])


def _assigned(line: ast.stmt) -> tuple[str, str]:
    """Return the name and the value of a constant, or nothing."""
    if isinstance(line, ast.Assign) and isinstance(line.targets[0], ast.Name):
        return line.targets[0].id, ast.unparse(line.value)
    if isinstance(line, ast.AnnAssign) and isinstance(line.target, ast.Name) and line.value:
        return line.target.id, ast.unparse(line.value)
    return "", ""


def write(app: Sphinx) -> None:
    """Write the pages into a folder of the documents that is not kept."""
    os.environ["COLUMNS"] = "84"  # what fits on a page
    folder = Path(app.srcdir) / "generated"
    pages = {f"commands/{name.replace(' ', '-')}.md": shown(name) for name in names()}
    listed = "\n".join(name.removeprefix("commands/").removesuffix(".md") for name in pages)
    contents = f"```{{toctree}}\n:maxdepth: 1\n\n{listed}\n```\n"
    pages["commands/index.md"] = f"# Commands\n\n```text\n{said('--help')}\n```\n\n{contents}"
    pages["keys.md"] = keys()
    pages["tolerances.md"] = tolerances(Path(app.srcdir).parent)
    for name, text in pages.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        if not path.exists() or path.read_text() != text:
            path.write_text(text)


def setup(app: Sphinx) -> dict[str, bool]:
    """Register with Sphinx."""
    app.connect("builder-inited", write)
    return {"parallel_read_safe": True}
