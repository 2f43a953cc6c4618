"""The rows of a study, and questions put to them."""

import hashlib
import os
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from swarmgrasp.errors import StudyInvalid
from swarmgrasp.packages import check_installed
from swarmgrasp.plain import Told
from swarmgrasp.simulation.study.plan import Plan, read_plan
from swarmgrasp.simulation.study.shard import schema_of
from swarmgrasp.simulation.study.study import Ask, Findings
from swarmgrasp.terms import Terms


@dataclass(frozen=True)
class Gathered(Told):
    """What there is of a study.

    Attributes
    ----------
    plan : Plan
    runs : int
        Those done.
    failed : int
        Runs with a fault.
    faults : tuple of str
        The most frequent ones.
    digest : str
        Of the rows: equal for equal studies, whoever did them.
    findings : Findings
    """

    plan: Plan
    runs: int
    failed: int
    faults: tuple[str, ...]
    digest: str
    findings: Findings

    @property
    def is_whole(self) -> bool:
        """Whether all runs are done."""
        return self.runs == self.plan.runs


SHOWN_FAULTS = 3


def gather(folder: str | os.PathLike[str], terms: Terms | None = None) -> Gathered:
    """Sum up what is done of a study, all of it or a part.

    Parameters
    ----------
    folder : path
    terms : Terms, optional
        Of the headline; those of the study's own file when left out.

    Raises
    ------
    StudyInvalid
        If the folder holds no study, nothing is done yet, or a file of it is damaged.
    PackageMissing
        If pyarrow or duckdb is not installed.
    """
    plan = read_plan(folder)
    with rows(folder) as ask:
        ((runs, failed),) = ask("SELECT count(*), count(fault) FROM all_runs")
        said = ask(
            "SELECT fault, count(*) FROM all_runs WHERE fault IS NOT NULL "
            f"GROUP BY fault ORDER BY count(*) DESC, fault LIMIT {SHOWN_FAULTS}"
        )
        faults = tuple(f"{count} x {fault}" for fault, count in said)
        found = plan.study.find(ask, terms or plan.terms)
        return Gathered(plan, runs, failed, faults, digest(folder), found)


@contextmanager
def rows(folder: str | os.PathLike[str]) -> Iterator[Ask]:
    """Offer the rows of a study as tables `runs`, of runs without a fault, and `all_runs`.

    Raises
    ------
    StudyInvalid
        If nothing is done yet, or a file is damaged.
    PackageMissing
        If pyarrow or duckdb is not installed.

    Yields
    ------
    callable
        Takes a question in SQL; returns a list of rows.
    """
    check_installed("pyarrow", "duckdb", extra="studies", purpose="The report of a study")
    import duckdb
    import pyarrow as pa
    from pyarrow.dataset import dataset

    files = _files(folder)
    _check_files(read_plan(folder), Path(folder), files)
    try:
        parts = dataset([str(path) for path in files], format="parquet")
        with duckdb.connect(config={"threads": 1}) as base:  # sums in one order
            base.register("all_runs", parts)
            base.execute("CREATE VIEW runs AS SELECT * FROM all_runs WHERE fault IS NULL")

            def ask(question: str) -> list[tuple[Any, ...]]:
                """Answer a question."""
                return base.execute(question).fetchall()

            yield ask
    except (pa.ArrowException, OSError, duckdb.Error) as error:
        said = str(error).splitlines()[0]
        raise StudyInvalid(f"{folder}: the rows cannot be read: {said}") from error


def _check_files(plan: Plan, folder: Path, files: list[Path]) -> None:
    """Raise `StudyInvalid` unless each file is that of its shard."""
    wanted = schema_of(plan.study)
    shards = [shard for shard in range(plan.shards) if plan.part(folder, shard) in set(files)]
    faults = [
        f"{path}: {fault}; delete it and run the study again"
        for shard, path in zip(shards, files, strict=True)
        for fault in _file_faults(path, plan, shard, wanted)
    ]
    if faults:
        raise StudyInvalid(faults)


def _file_faults(path: Path, plan: Plan, shard: int, wanted: Any) -> list[str]:
    """Return what is wrong with the file of a shard, by what stands at its end."""
    import pyarrow as pa
    from pyarrow import parquet

    try:
        found = parquet.read_metadata(path)
    except (pa.ArrowException, OSError):
        return ["is damaged"]
    if not found.schema.to_arrow_schema().equals(wanted):
        return ["has not the columns of this study"]
    groups = [found.row_group(k).column(0).statistics for k in range(found.num_row_groups)]
    first = min((group.min for group in groups if group and group.has_min_max), default=-1)
    if (found.num_rows, first) != (plan.count(shard), shard * plan.size):
        return ["has not the runs of its shard"]
    return []


def digest(folder: str | os.PathLike[str]) -> str:
    """Return the digest of a study's rows."""
    found = hashlib.sha256()
    for path in _files(folder):
        found.update(hashlib.sha256(path.read_bytes()).digest())
    return found.hexdigest()[:16]


def _files(folder: str | os.PathLike[str]) -> list[Path]:
    """Return the files of the shards that are done."""
    plan, where = read_plan(folder), Path(folder)
    left = set(plan.missing(where))
    files = [plan.part(where, shard) for shard in range(plan.shards) if shard not in left]
    if not files:
        raise StudyInvalid(f"{folder}: nothing of this study is done yet; run it first")
    return files
