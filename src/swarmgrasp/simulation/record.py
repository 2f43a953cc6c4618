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

from swarmgrasp.files import scratch_for
from swarmgrasp.packages import check_installed
from swarmgrasp.plain import plain
from swarmgrasp.simulation.run import Run

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
