"""The columns of a log, and what stands beside them."""

import json
from collections.abc import Iterator
from importlib.metadata import version
from pathlib import Path
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import NDArray

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
KEY = b"swarmgrasp"
"""Of what stands beside the table: what was simulated, and what happened, as JSON."""


def growing(path: Path) -> Path:
    """Return where a log is while its run goes on."""
    return path.with_name(f"{path.name}.part")


def asked(run: Run) -> dict[str, Any]:
    """Return what is known of a run from its start on."""
    return {
        "version": version("swarmgrasp"),
        "simulation": plain(run.simulation),
        "seeds": list(run.seeds),
        "names": list(run.names),
        "gusts": plain(run.gusts),
    }


def happened(run: Run) -> dict[str, Any]:
    """Return what is known of a run as far as it has come."""
    return {
        "stints": plain(run.stints),
        "happenings": plain(run.happenings),
        "is_whole": run.is_whole,
    }


def metadata(about: dict[str, Any]) -> dict[bytes, bytes]:
    """Return what stands beside a table as its metadata."""
    return {KEY: json.dumps(about, allow_nan=False).encode()}


def schema_of(run: Run) -> "pa.Schema":
    """Return the names, kinds and units of all columns, and what is known from the start on."""
    import pyarrow as pa

    fields = [
        pa.field(name, pa.from_numpy_dtype(values.dtype), metadata={"unit": unit})
        for name, unit, values in _columns(run, 0)
    ]
    return pa.schema(fields, metadata=metadata(asked(run)))


def rows_of(run: Run, index: int, schema: "pa.Schema") -> "pa.RecordBatch":
    """Return the rows of one of the runs."""
    import pyarrow as pa

    arrays = [pa.array(values) for _, _, values in _columns(run, index)]
    return pa.RecordBatch.from_arrays(arrays, schema=schema)


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
