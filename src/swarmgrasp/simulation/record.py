"""The log of a run: a table in a Parquet file, a row for each run and instant.

Numbers are in 4 bytes, their bytes sorted by place before they are packed: that makes a file three
times smaller than doubles do. Only the time keeps 8. Each column tells its unit.
"""

import json
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.files import scratch_for
from swarmgrasp.packages import check_installed
from swarmgrasp.plain import plain
from swarmgrasp.simulation.run import Happening, Run, Stint
from swarmgrasp.simulation.simulation import Simulation
from swarmgrasp.swarm import Swarm

if TYPE_CHECKING:
    import pyarrow as pa

Column = tuple[str, str, NDArray[Any]]
"""Name, unit, and the values (m,) of one run."""

WRENCH = (("x", "N"), ("y", "N"), ("turn", "N m"))
POSE = (("x", "m"), ("y", "m"), ("heading", "rad"))
VELOCITY = (("ahead", "m/s"), ("to_port", "m/s"), ("turn", "rad/s"))
STREAM = (("wind_x", "m/s"), ("wind_y", "m/s"), ("water_x", "m/s"), ("water_y", "m/s"))
GROUPS = (
    ("", "poses", POSE),
    ("wanted_", "references", POSE),
    ("speed_", "velocities", VELOCITY),
    ("", "streams", STREAM),
    ("load_", "loads", WRENCH),
    ("asked_", "wanted", WRENCH),
    ("given_", "given", WRENCH),
)
"""Columns by the arrays of a run that they come from: what each name begins with, and its parts."""


def write_log(run: Run, path: str | Path) -> Path:
    """Write a run as a Parquet file, whole or not at all.

    Columns are `seed` and `time`; then the pose and where it should be, speeds through the water,
    the streams of air and water, the wrenches of the weather, asked of the robots and given by
    them, and what is out of reach; and of each robot its `force`, `angle` and `share`, after its
    name and a dot. The unit of each is in its metadata. What was simulated, what happened, and who
    was there when, are in those of the file, as JSON under "swarmgrasp".

    Parameters
    ----------
    run : Run
    path : str or Path

    Returns
    -------
    Path

    Raises
    ------
    PackageMissing
        Without pyarrow.
    """
    check_installed("pyarrow", extra="logs", purpose="A log")
    from pyarrow import parquet

    target = Path(path)
    schema = _schema(run)
    settings: dict[str, Any] = {
        "compression": "zstd",
        "use_dictionary": False,
        "use_byte_stream_split": [name for name in schema.names if name != "seed"],
    }
    with scratch_for(target) as scratch, parquet.ParquetWriter(scratch, schema, **settings) as file:
        for index in range(len(run)):
            file.write_table(_table(run, index, schema))
    return target


def read_log(path: str | Path) -> Run:
    """Read a run from its Parquet file.

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
        If the file cannot be read, or is no log of a run.
    """
    check_installed("pyarrow", extra="logs", purpose="A log")
    from pyarrow import ArrowException, parquet

    try:
        table = parquet.read_table(Path(path))
        about = json.loads((table.schema.metadata or {})[b"swarmgrasp"])
        return _run_of(table, about)
    except (OSError, ArrowException, KeyError, TypeError, ValueError) as error:
        told = error.strerror if isinstance(error, OSError) and error.strerror else None
        raise SimulationInvalid(
            f"{path}: {told or 'is no log of a run, as `swarmgrasp simulate --log` writes it'}"
        ) from None


def _run_of(table: "pa.Table", about: dict[str, Any]) -> Run:
    """Make a run of its table and what stands beside it."""
    names, count = about["names"], len(about["seeds"])

    def column(name: str) -> NDArray[Any]:
        """Return a column (runs, m)."""
        return np.asarray(table[name].to_numpy().reshape(count, -1))

    def columns(*wanted: str) -> NDArray[Any]:
        """Return several (runs, m, k)."""
        return np.stack([column(name) for name in wanted], axis=-1)

    arrays = {
        source: columns(*(f"{begin}{name}" for name, _ in parts)) for begin, source, parts in GROUPS
    }
    arrays["references"] = arrays["references"][0]
    each = {
        kind: columns(*(f"{name}.{one}" for name in names))
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


def _columns(run: Run, index: int) -> Iterator[Column]:
    """Go through the columns of one run."""
    yield "seed", "", np.full(len(run.times), run.seeds[index], np.int64)
    yield "time", "s", run.times
    for begin, source, parts in GROUPS:
        held = getattr(run, source)
        rows = held if held.ndim == 2 else held[index]
        for i, (name, unit) in enumerate(parts):
            yield f"{begin}{name}", unit, rows[:, i]
    yield "error", "m", run.distances[index]
    yield "heading_error", "rad", run.turns[index]
    yield "shortfall", "N", run.shortfalls[index]
    for i, name in enumerate(run.names):
        yield f"{name}.force", "N", run.forces[index, :, i]
        yield f"{name}.angle", "rad", run.angles[index, :, i]
        yield f"{name}.share", "1", run.shares[index, :, i]


def _schema(run: Run) -> "pa.Schema":
    """Return the names, kinds and units of all columns, and what stands beside the table."""
    import pyarrow as pa

    fields = [
        pa.field(name, pa.from_numpy_dtype(values.dtype), metadata={"unit": unit})
        for name, unit, values in _columns(run, 0)
    ]
    about = {
        "version": version("swarmgrasp"),
        "simulation": plain(run.simulation),
        "seeds": list(run.seeds),
        "names": list(run.names),
        "stints": plain(run.stints),
        "happenings": plain(run.happenings),
        "gusts": plain(run.gusts),
        "is_whole": run.is_whole,
    }
    return pa.schema(fields, metadata={"swarmgrasp": json.dumps(about, allow_nan=False)})


def _table(run: Run, index: int, schema: "pa.Schema") -> "pa.Table":
    """Return the rows of one run."""
    import pyarrow as pa

    return pa.table([values for _, _, values in _columns(run, index)], schema=schema)
