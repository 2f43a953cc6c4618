"""`swarmgrasp study`: many runs that are alike but for their seeds."""

import re
import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager, nullcontext
from dataclasses import fields
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.drawing import USUAL, Drawing
from swarmgrasp.cli.inputs import (
    UsageFault,
    blaming,
    json_faults,
    read_scenario,
    whole_faults,
)
from swarmgrasp.cli.progress import shown_pace
from swarmgrasp.cli.wording import Phrasing, csv_faults
from swarmgrasp.errors import SwarmGraspError

if TYPE_CHECKING:
    from swarmgrasp.scenario import Scenario
    from swarmgrasp.simulation.study import Machines, Plan, Study

OF_A_NEW_ONE = ("of", "runs", "robots", "newcomers", "seed")
"""Options that say what a study is."""


def study(
    file: Dashed,
    folder: Path | None = None,
    /,
    *,
    of: Annotated[str | None, Parameter(metavar="KIND")] = None,
    runs: Annotated[str | None, Parameter(metavar="INT")] = None,
    robots: Annotated[str | None, Parameter(metavar="FIRST:LAST")] = None,
    newcomers: Annotated[str | None, Parameter(metavar="INT")] = None,
    seed: Annotated[str | None, Parameter(metavar="INT")] = None,
    workers: Annotated[str | None, Parameter(metavar="INT")] = None,
    dask: Annotated[str | None, Parameter(metavar="ADDRESS")] = None,
    report: Annotated[bool, Parameter(negative="")] = False,
    plot: Path | None = None,
    csv: Dashed | None = None,
    drawing: Drawing = USUAL,
    json: Dashed | None = None,
    units: Literal["file", "si"] = "file",
) -> None:
    """Do many runs that are alike but for their seeds, and sum them up.

    The runs go into a folder, one file for some of them, and what is there is kept whatever is
    interrupted or killed: the same command again, or `swarmgrasp study FOLDER`, does the rest. The
    rows are the same, byte for byte, for any number of workers. They are Parquet files, which
    DuckDB, pandas, polars and others read.

    Example: swarmgrasp study deck-barge sizes --runs 1000000

    Example: swarmgrasp study sizes --report --plot sizes.png

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as deck-barge: the
        object, and the newcomer, which all random robots are like. Without a folder after it, the
        folder of a study that was begun.
    folder
        Where the runs go, created if need be.
    of
        What is asked. Of random robots that are like the newcomer: sizes (quality against their
        number, the default), losses (what the loss of one leaves), together (newcomers placed
        together against one after the other), gusts (whether they hold in weather from anywhere,
        against their margin). Or story: the file's own simulation, with other gusts in each run.
    runs
        How many.
    robots
        How many random robots a swarm has, such as 4:16, each number as likely as another.
    newcomers
        With --of together: how many are placed; 2 unless given.
    seed
        Of all that is random; 1 unless given. The same seed gives the same rows.
    workers
        Processes on this machine; as many as there are cores unless given.
    dask
        Instead of processes on this machine: the workers of the Dask scheduler at this address,
        such as tcp://10.0.0.7:8786, which have the same version of swarmgrasp installed.
    report
        Sum up what is there, and run nothing.
    plot
        Draw what was found to this .png, .svg or .pdf file.
    csv
        Also write the table to this .csv file; "-" prints it and nothing else.
    json
        Also write what was found to this .json file; "-" prints it and nothing else. SI units and
        radians.
    units
        Units of the answer: the file's, or si for metres, newtons and metres per second. The rows
        are in SI units.
    """
    from swarmgrasp.packages import check_installed

    check_installed("duckdb", "pyarrow", extra="studies", purpose="`swarmgrasp study`")
    given = {"of": of, "runs": runs, "robots": robots, "newcomers": newcomers, "seed": seed}
    faults = json_faults(json) + csv_faults(csv, json) + drawing.faults(plot)
    faults += _number_faults(runs, newcomers, seed, workers) + _robots_faults(robots)
    faults += _clashes(report, workers, dask, folder, given)
    where, plan = _plan(file, folder, faults, given, report)
    if not report:
        _run(where, plan, workers, dask)
    from swarmgrasp.cli.show.study import show
    from swarmgrasp.simulation.study import gather

    found = gather(where)
    terms = Phrasing(units).of(found.plan.terms)
    if terms != found.plan.terms:
        found = gather(where, terms)

    def draw() -> list[Path]:
        """Draw what was found if it is wanted."""
        if plot is None:
            return []
        from swarmgrasp.plot import save, study_picture

        return [save(study_picture(found, **drawing.look(found.plan.name, terms)), plot)]

    deliver(json, found.to_data(), lambda: show(where, found, terms), draw, csv=csv)


def _plan(
    file: str, folder: Path | None, faults: list[str], given: dict[str, str | None], report: bool
) -> "tuple[Path, Plan]":
    """Return the folder and the plan that are asked for.

    Raises
    ------
    UsageFault
        If there is any fault.
    """
    if folder is None or report:
        if faults:
            raise UsageFault(faults)
        from swarmgrasp.simulation.study import read_plan

        where = folder or Path(file)
        return where, read_plan(where)
    scenario = read_scenario(file, faults)
    from swarmgrasp.simulation.study import KINDS, Plan, read_plan
    from swarmgrasp.simulation.study.plan import PLAN, check_folder
    from swarmgrasp.words import either_words

    kind = given["of"] or "sizes"
    runs = given["runs"]
    if kind not in KINDS:
        raise UsageFault(f"--of is {kind}; it should be {either_words(list(KINDS))}")
    if runs is None and not (folder / PLAN).exists():
        raise UsageFault("--runs is missing; say how many, such as --runs 10000")
    _check_options(KINDS[kind], given)
    with blaming(file):
        asked = _study(KINDS[kind], scenario, given)
    many = int(runs) if runs else read_plan(folder).runs
    plan = Plan.of(scenario.name, asked, many, int(given["seed"] or "1"), scenario.terms)
    check_folder(folder, plan)
    return folder, plan


def _taken(kind: "type[Study]") -> set[str]:
    """Return what a kind of study takes."""
    return {part.name for part in fields(kind)}  # type: ignore[arg-type]


def _check_options(kind: "type[Study]", given: dict[str, str | None]) -> None:
    """Raise `UsageFault` if an option is not for a kind of study."""
    faults = [
        f"{option} is not for --of {kind.kind}"
        for option, part in (("--robots", "fewest_robots"), ("--newcomers", "newcomers"))
        if given[option[2:]] and part not in _taken(kind)
    ]
    if faults:
        raise UsageFault(faults)


def _study(kind: "type[Study]", scenario: "Scenario", given: dict[str, str | None]) -> "Study":
    """Return the study that is asked for of a scenario.

    Raises
    ------
    SwarmGraspError
        If the scenario does not say what it needs.
    """
    taken, faults = _taken(kind), list[str]()
    of: dict[str, Any] = {}
    if given["robots"]:
        of["fewest_robots"], of["most_robots"] = _robots(given["robots"])
    if given["newcomers"]:
        of["newcomers"] = int(given["newcomers"])
    if scenario.newcomer is None and "fewest_robots" in taken:
        faults.append(
            "newcomer: is missing; say what the random robots are like, such as `newcomer: "
            "{limit: 60, attachment: push, half_angle: 30}`"
        )
    if scenario.simulation is None and "simulation" in taken:
        faults.append("simulation: is missing; say what is to be simulated, such as `simulation: "
                      "{hull: {draught: 2.4}, weather: {gusts: npd}}`")  # fmt: skip
    if faults:
        raise SwarmGraspError(faults)
    subject = scenario.simulation if "simulation" in taken else scenario.problem()
    making: Callable[..., Study] = kind
    return making(subject, **of)


def _run(folder: Path, plan: "Plan", workers: str | None, dask: str | None) -> None:
    """Do what is left of a study, and tell how to go on if that is interrupted."""
    from swarmgrasp.simulation.study import run_plan

    left = sum(map(plan.count, plan.missing(folder)))
    width = int(workers) if workers else None
    try:
        with _elsewhere(dask) as machines, shown_pace(plan.runs, plan.runs - left) as told:
            if machines is None:
                run_plan(folder, plan, workers=width, progress=told)
            else:
                run_plan(
                    folder, plan, workers=machines.workers, executor=machines.executor,
                    progress=told,
                )  # fmt: skip
    except KeyboardInterrupt:
        done = plan.runs - sum(map(plan.count, plan.missing(folder)))
        print(
            f"stopped: {done} of {plan.runs} runs are done and kept; go on with: swarmgrasp study "
            f"{folder}",
            file=sys.stderr,
        )
        raise


@contextmanager
def _elsewhere(dask: str | None) -> "Iterator[Machines | None]":
    """Offer the machines at an address, if there is one."""
    from swarmgrasp.simulation.study import machines_at

    with machines_at(dask) if dask else nullcontext() as machines:
        yield machines


def _robots(text: str) -> tuple[int, int]:
    """Return the fewest and the most robots."""
    first, _, last = text.partition(":")
    return int(first), int(last or first)


def _robots_faults(text: str | None) -> list[str]:
    """Return what is wrong with numbers of robots."""
    if text is None:
        return []
    if not re.fullmatch(r"[0-9]{1,4}(:[0-9]{1,4})?", text):
        return [f"--robots is {text}; it should be a number, or two such as 4:16"]
    first, last = _robots(text)
    if not 1 <= first <= last:
        return [f"--robots is {text}; it should be 1 <= first <= last"]
    return []


def _number_faults(
    runs: str | None, newcomers: str | None, seed: str | None, workers: str | None
) -> list[str]:
    """Return what is wrong with whole numbers."""
    faults = whole_faults("--runs", runs, 1) + whole_faults("--newcomers", newcomers, 2, 12)
    return faults + whole_faults("--seed", seed) + whole_faults("--workers", workers, 1, 1000)


def _clashes(
    report: bool, workers: str | None, dask: str | None, folder: Path | None,
    given: dict[str, str | None],
) -> list[str]:  # fmt: skip
    """Return which options do not go together."""
    faults = []
    if workers and dask:
        faults.append("--workers and --dask exclude each other: Dask knows its own workers")
    if report and (workers or dask):
        faults.append("--report runs nothing: leave out --workers and --dask")
    new = [f"--{name}" for name in OF_A_NEW_ONE if given[name] is not None]
    if new and (folder is None or report):
        faults.append(
            f"{', '.join(new)}: the study in the folder says that already; to begin one, give a "
            "FILE and a FOLDER and leave out --report"
        )
    return faults
