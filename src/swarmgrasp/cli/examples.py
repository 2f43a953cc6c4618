"""`swarmgrasp examples`: the built-in scenarios."""

import os
from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from swarmgrasp.cli.inputs import UsageFault


def examples(
    name: str | None = None,
    /,
    *,
    write: Path | None = None,
    force: Annotated[bool, Parameter(negative="")] = False,
) -> None:
    """List, print or write the built-in scenarios.

    Example: swarmgrasp examples deck-barge > my.yaml

    Parameters
    ----------
    name
        Print this one; with --write, write only this one.
    write
        Folder to write NAME.yaml files into, created if need be. Existing files are kept,
        and then nothing is written at all.
    force
        Overwrite existing files.
    """
    from swarmgrasp.scenario import example_names, example_text

    if write is not None:
        texts = {n: example_text(n) for n in ([name] if name else example_names())}
        _write(write, texts, force)
    elif force:
        raise UsageFault("--force goes with --write")
    elif name is not None:
        print(example_text(name), end="")
    else:
        _list()


def _write(folder: Path, texts: dict[str, str], force: bool) -> None:
    """Write the texts, all or none."""
    from swarmgrasp.cli.show.report import told_written
    from swarmgrasp.files import folder_faults, write_whole

    paths = {name: folder / f"{name}.yaml" for name in texts}
    faults = folder_faults(folder)
    if faults:
        raise UsageFault(faults)
    folder.mkdir(parents=True, exist_ok=True)
    there = [path for path in paths.values() if os.path.lexists(path)]
    if there and not force:
        raise UsageFault(f"{path}: exists already; --force overwrites it" for path in there)
    for name, path in paths.items():
        write_whole(path, texts[name].encode())
    told_written(paths.values())


def _list() -> None:
    """List the built-in scenarios."""
    from swarmgrasp.cli.show.report import Column, Report
    from swarmgrasp.scenario import example_names, load_example

    rows = []
    for name in example_names():
        scenario = load_example(name)
        rows.append([name, str(len(scenario.swarm)), scenario.description])
    report = Report()
    report.table([Column("name"), Column("robots", is_number=True), Column("what")], rows)
    report.blank()
    report.sentence("Try one: swarmgrasp place deck-barge")
    report.sentence("Start from one: swarmgrasp examples deck-barge > my.yaml")
