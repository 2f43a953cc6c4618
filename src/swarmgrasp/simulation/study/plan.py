"""The plan of a study: what each shard is, and the folder that holds it."""

import fcntl
import hashlib
import json
import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from functools import cached_property, lru_cache
from importlib.metadata import version
from pathlib import Path
from typing import Any

import numpy as np

from swarmgrasp import kernels
from swarmgrasp.errors import DataInvalid, StudyInvalid, TermsInvalid
from swarmgrasp.files import folder_faults, read_fault, write_whole
from swarmgrasp.plain import Told, picked
from swarmgrasp.ranges import MOST_SEED, is_whole, kind_faults, name_faults, shown
from swarmgrasp.simulation.study.kinds import KINDS
from swarmgrasp.simulation.study.study import Seeds, Study
from swarmgrasp.terms import SI, Terms

FORMAT = "swarmgrasp study 1"
PLAN = "study.json"
MOST_RUNS = 10**9
LARGEST_PLAN = 2**24
"""Bytes of a plan that are read."""
_KEYS = "name", "runs", "seed", "size", "release", "kernels"
_LEFTOVERS = ".part-*", ".study-*"
"""Files that a killed process did not finish."""


@dataclass(frozen=True)
class Plan(Told):
    """A study of so many runs, in shards that are the same on every machine.

    Attributes
    ----------
    name : str
        What it is of: the scenario's.
    study : Study
    runs : int
        From 1 to 1e9.
    seed : int
        Of all that is random, at least 0.
    size : int
        Runs in a shard; the last one may have fewer.
    release, kernels : str
        Of this package, and the digest of its kernels: with others, rows may differ in their bytes.
    terms : Terms
        Those of the file it is of, in which it is told.

    Raises
    ------
    StudyInvalid
        If a value is outside its range; all faults at once.
    """

    name: str
    study: Study
    runs: int
    seed: int
    size: int
    release: str
    kernels: str
    terms: Terms = SI

    def __post_init__(self) -> None:
        """Check the values."""
        faults = name_faults(self.name) + kind_faults(self.study, Study)
        faults += kind_faults(self.terms, Terms)
        for called, value, low, high in (
            ("number of runs", self.runs, 1, MOST_RUNS),
            ("seed", self.seed, 0, MOST_SEED),
            ("number of runs in a shard", self.size, 1, MOST_RUNS),
        ):
            if not is_whole(value) or not low <= value <= high:
                wanted = f"it should be a whole number from {low} to {high}"
                faults.append(f"the {called} is {shown(value)}; {wanted}")
        if faults:
            raise StudyInvalid(faults)

    @classmethod
    def of(cls, name: str, study: Study, runs: int, seed: int = 1, terms: Terms = SI) -> "Plan":
        """Return the plan of a study with the package as it is installed here."""
        release = version("swarmgrasp")
        return cls(name, study, runs, seed, study.size, release, kernels_digest(), terms)

    def to_data(self) -> dict[str, Any]:
        """Return the plan as plain data."""
        named = {"kind": self.study.kind, **self.study.to_data()}
        return {
            "format": FORMAT,
            **picked(self, *_KEYS),
            "terms": self.terms.to_data(),
            "study": named,
        }

    @cached_property
    def text(self) -> str:
        """The plan as JSON: what the folder holds, and what workers are given."""
        return json.dumps(self.to_data(), indent=1, ensure_ascii=False, allow_nan=False) + "\n"

    @property
    def shards(self) -> int:
        """How many shards there are."""
        return -(-self.runs // self.size)

    def count(self, shard: int) -> int:
        """Return how many runs a shard has."""
        return min(self.size, self.runs - shard * self.size)

    def seeds(self, shard: int) -> Seeds:
        """Return the seeds of a shard's runs, which hang on nothing but the plan's own seed."""
        sequence = np.random.SeedSequence(self.seed, spawn_key=(shard,))
        state = sequence.generate_state(self.count(shard), np.uint64)
        return (state >> np.uint64(1)).astype(np.int64)

    def part(self, folder: Path, shard: int) -> Path:
        """Return the file of a shard."""
        return folder / f"part-{shard:06d}.parquet"

    def missing(self, folder: Path) -> list[int]:
        """Return the shards that are still to be done."""
        return [shard for shard in range(self.shards) if not self.part(folder, shard).exists()]


def plan_of(text: str, called: str = PLAN) -> Plan:
    """Read a plan.

    Parameters
    ----------
    text : str
        As `Plan.text` is.
    called : str
        What messages call it.

    Raises
    ------
    StudyInvalid
        If it is none; all faults at once.
    """
    try:
        data = json.loads(text)
    except (ValueError, RecursionError) as error:
        raise StudyInvalid(f"{called}: is no JSON: {error}") from None
    if not isinstance(data, dict) or data.get("format") != FORMAT:
        raise StudyInvalid(f"{called}: is no plan of a study: its format should be {FORMAT!r}")
    study = data.get("study")
    kind = study.pop("kind", None) if isinstance(study, dict) else None
    if kind not in KINDS:
        raise StudyInvalid(f"{called}: study.kind: is {shown(kind)}; known: {', '.join(KINDS)}")
    wanted = {"format", *_KEYS, "terms", "study"}
    if data.keys() != wanted:
        raise StudyInvalid(f"{called}: should have the keys {', '.join(sorted(wanted))}")
    try:
        made = KINDS[kind].from_data(study)
        terms = Terms.from_data(data["terms"])
        return Plan(study=made, terms=terms, **{key: data[key] for key in _KEYS})
    except (DataInvalid, StudyInvalid, TermsInvalid) as error:
        raise StudyInvalid(f"{called}: {fault}" for fault in error.faults) from None


def read_plan(folder: str | os.PathLike[str]) -> Plan:
    """Read the plan of a study's folder.

    Raises
    ------
    StudyInvalid
        If there is none, or it is damaged.
    """
    path = Path(folder) / PLAN
    try:
        with path.open("rb") as file:
            raw = file.read(LARGEST_PLAN)
        return plan_of(raw.decode(), str(path))
    except NotADirectoryError:
        remedy = f"begin a study with `swarmgrasp study {folder} FOLDER --runs N`"
        raise StudyInvalid(f"{folder}: is a file, and no folder of a study; {remedy}") from None
    except FileNotFoundError:
        remedy = "begin one with `swarmgrasp study FILE FOLDER --runs N`"
        raise StudyInvalid(f"{folder}: holds no study; {remedy}") from None
    except OSError as error:
        raise StudyInvalid(read_fault(path, error)) from None
    except UnicodeDecodeError as error:
        raise StudyInvalid(f"{path}: is no text in UTF-8: {error.reason}") from None


@contextmanager
def folder_of(folder: Path, plan: Plan) -> Iterator[None]:
    """Hold a folder for a study: one that is there is gone on with, if it is the same.

    Raises
    ------
    StudyInvalid
        If the folder cannot be written to, holds another study or something else, or another
        process is at work in it.
    """
    check_folder(folder, plan)
    folder.mkdir(parents=True, exist_ok=True)
    with _locked(folder):
        check_folder(folder, plan)  # another process may have begun one meanwhile
        for pattern in _LEFTOVERS:
            for leftover in folder.glob(pattern):
                leftover.unlink(missing_ok=True)
        if not (folder / PLAN).exists():
            write_whole(folder / PLAN, plan.text.encode(), durable=True)
        yield


def check_folder(folder: Path, plan: Plan) -> None:
    """Raise `StudyInvalid` unless a study can be done in a folder, or gone on with."""
    faults = folder_faults(folder)
    if not faults and folder.exists():
        if (folder / PLAN).exists():
            faults = [
                f"{folder}: is the folder of another study: {difference}; choose another folder"
                for difference in _differences(read_plan(folder), plan)
            ]
        elif any(not entry.name.startswith(".") for entry in folder.iterdir()):
            faults = [f"{folder}: holds other files and no {PLAN}; choose an empty folder"]
    if faults:
        raise StudyInvalid(faults)


def _differences(there: Plan, wanted: Plan) -> list[str]:
    """Return in which parts two plans differ, in words."""
    if there.study.kind != wanted.study.kind:
        return [f"it is of {there.study.kind}, not of {wanted.study.kind}"]
    parts = {
        "name": (there.name, wanted.name),
        "number of runs": (there.runs, wanted.runs),
        "seed": (there.seed, wanted.seed),
        "shards' size": (there.size, wanted.size),
        "version of swarmgrasp": (there.release, wanted.release),
        "kernels": (there.kernels, wanted.kernels),
    }
    told = [f"its {what} is {one}, not {two}" for what, (one, two) in parts.items() if one != two]
    mine, theirs = there.study.to_data(), wanted.study.to_data()
    keys = [key for key in theirs if mine[key] != theirs[key]]
    return told + [f"its {key} is another one" for key in keys]


@contextmanager
def _locked(folder: Path) -> Iterator[None]:
    """Keep other processes from working in a folder; the system lets go when this one ends."""
    held = os.open(folder, os.O_RDONLY)
    try:
        fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
        yield
    except BlockingIOError:
        raise StudyInvalid(
            f"{folder}: another process is at work in it; wait for it, or end it"
        ) from None
    finally:
        os.close(held)


@lru_cache(maxsize=1)
def kernels_digest() -> str:
    """Return the digest of the kernels that are installed here."""
    folder = Path(kernels.__path__[0])
    libraries = sorted(path for path in folder.iterdir() if re.search(r"\.(so|pyd)$", path.name))
    digest = hashlib.sha256()
    for path in libraries:
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]
