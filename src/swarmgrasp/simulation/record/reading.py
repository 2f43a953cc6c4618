"""Reading a log, also one whose run goes on or was cut off."""

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import DataInvalid, SimulationInvalid
from swarmgrasp.files import read_fault
from swarmgrasp.packages import check_installed
from swarmgrasp.simulation.record.columns import GROUPS, KEY, growing
from swarmgrasp.simulation.run import Happening, Run, Stint
from swarmgrasp.simulation.simulation import Simulation
from swarmgrasp.swarm import Swarm

TABLE, STREAM = b"PAR1", b"\xff\xff\xff\xff"
"""How a Parquet file begins, and how a stream of Arrow does."""


def read_log(path: str | Path) -> Run:
    """Read a run from its log.

    Of a run that goes on, or was killed, there is only the part beside it, such as
    `run.parquet.part`: it is read instead, as far as it was written, and is not whole.

    Parameters
    ----------
    path : str or Path

    Returns
    -------
    Run

    Raises
    ------
    PackageMissing
        Without pyarrow.
    SimulationInvalid
        If the file cannot be read, is no log of a run, or holds no instant yet.
    """
    check_installed("pyarrow", extra="logs", purpose="A log")
    from pyarrow import ArrowException

    found = Path(path)
    if not found.exists() and growing(found).exists():
        found = growing(found)
    try:
        about, tables = _parts(found)
        if tables:
            return _run_of(about, tables)
    except OSError as error:
        if error.errno is not None:
            raise SimulationInvalid(read_fault(found, error)) from None
        raise _stranger(found) from None
    except (ArrowException, DataInvalid, KeyError, TypeError, ValueError):
        raise _stranger(found) from None
    raise SimulationInvalid(f"{found}: nothing of the run has been written yet")


def _stranger(path: Path) -> SimulationInvalid:
    """Return the fault of a file that is no log."""
    return SimulationInvalid(
        f"{path}: is no log of a run, as `swarmgrasp simulate --log` writes it, or a damaged one"
    )


def _parts(path: Path) -> tuple[dict[str, Any], list[Any]]:
    """Return what stands beside the rows, and the rows piece by piece, each of one run in turn."""
    from pyarrow import ipc, parquet

    with path.open("rb") as file:
        begin = file.read(4)
        file.seek(0)
        if begin == TABLE:
            table = parquet.ParquetFile(file)
            about = json.loads((table.schema_arrow.metadata or {})[KEY])
            return about, [table.read_row_group(k) for k in range(table.num_row_groups)]
        if begin and begin != STREAM:
            raise ValueError("neither a table nor a stream")
        if not begin:
            return {}, []
        rows = ipc.open_stream(file)
        about = json.loads((rows.schema.metadata or {})[KEY])
        tables: list[Any] = []
        for batch, more in _whole_pieces(rows, len(about["seeds"])):
            tables.append(batch)
            about |= json.loads(more[KEY]) | {"is_whole": False}
        return about, tables


def _whole_pieces(rows: Any, runs: int) -> Iterator[tuple[Any, Any]]:
    """Go through a stream up to its end, or to the last piece of which all runs are written."""
    from pyarrow import ArrowException

    piece: list[tuple[Any, Any]] = []
    while True:
        try:
            found = rows.read_next_batch_with_custom_metadata()
        except (StopIteration, ArrowException, OSError):  # at its end, or cut off
            return
        piece.append((found.batch, found.custom_metadata))
        if len(piece) == runs:
            yield from piece
            piece = []


def _run_of(about: dict[str, Any], tables: list[Any]) -> Run:
    """Make a run of its rows and what stands beside them."""
    names, count = about["names"], len(about["seeds"])

    def column(name: str) -> NDArray[Any]:
        """Return a column (runs, m)."""
        parts = [np.asarray(table[name].to_numpy()) for table in tables]
        return np.stack([np.concatenate(parts[run::count]) for run in range(count)])

    def columns(*wanted: str) -> NDArray[Any]:
        """Return several (runs, m, k)."""
        return np.stack([column(name) for name in wanted], axis=-1)

    arrays = {
        source: columns(*(f"{begin}{name}" for name, _ in parts)) for begin, source, parts in GROUPS
    }
    arrays["references"] = arrays["references"][0]
    each = {
        kind: columns(*(f"{name}.{one}" for name in names))
        if names
        else np.zeros((*column("time").shape, 0), np.float32)
        for kind, one in (("forces", "force"), ("angles", "angle"), ("shares", "share"))
    }
    swarm = Swarm.from_data
    return Run(
        simulation=Simulation.from_data(about["simulation"]),
        seeds=tuple(about["seeds"]),
        times=column("time")[0],
        distances=column("error"),
        turns=column("heading_error"),
        shortfalls=column("shortfall"),
        names=tuple(names),
        stints=tuple(Stint(**{**s, "swarm": swarm(s["swarm"])}) for s in about["stints"]),
        happenings=tuple(
            Happening(**{**h, "swarm": swarm(h["swarm"]), "load": np.array(h["load"])})
            for h in about["happenings"]
        ),
        gusts=np.array(about["gusts"]),
        is_whole=about["is_whole"],
        **arrays,
        **each,
    )
