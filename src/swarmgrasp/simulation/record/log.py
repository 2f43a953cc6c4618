"""Writing a log as its run goes on."""

import fcntl
import os
from collections.abc import Iterator
from contextlib import contextmanager, suppress
from pathlib import Path
from types import TracebackType
from typing import Any, Self

from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.files import scratch_for
from swarmgrasp.packages import check_installed
from swarmgrasp.simulation.record.columns import (
    asked,
    growing,
    happened,
    metadata,
    rows_of,
    schema_of,
)
from swarmgrasp.simulation.run import Run
from swarmgrasp.words import span

TOGETHER = 65_536
"""Rows of a log of one run that are packed together."""


class Log:
    """A log that is written as its run goes on: `simulate(simulation, sink=log.add)`.

    Columns are `seed` and `time`; then the pose and where it should be, speeds through the water,
    the streams of air and water, the wrenches of the weather, asked of the robots and given by
    them, and what is out of reach; and of each robot its `force`, `angle` and `share`, after its
    name and a dot. The unit of each is in its metadata. What was simulated, what happened, and who
    was there when, are in those of the file, as JSON under "swarmgrasp".

    At the end of the `with` block the file is there, whole. If the block raises, what was written
    until then stays beside it, and `read_log` reads it.

    Parameters
    ----------
    path : str or Path

    Raises
    ------
    PackageMissing
        Without pyarrow.
    SimulationInvalid
        If another process is writing this log.
    OSError
        If the file cannot be written.
    """

    def __init__(self, path: str | Path) -> None:
        check_installed("pyarrow", extra="logs", purpose="A log")
        self._path = Path(path)
        self._part = growing(self._path)
        self._held = -1
        self._file: Any = None
        self._writer: Any = None
        self._schema: Any = None
        self._last: Run | None = None

    def __enter__(self) -> Self:
        """Begin: a part that a killed process left is begun anew."""
        import pyarrow as pa

        self._held = self._hold()
        self._file = pa.OSFile(str(self._part), "wb")
        return self

    def _hold(self) -> int:
        """Keep other processes from writing the part; the system lets go when this one ends."""
        while True:
            held = os.open(self._part, os.O_RDWR | os.O_CREAT, 0o666)
            try:
                fcntl.flock(held, fcntl.LOCK_EX | fcntl.LOCK_NB)
                if os.path.samestat(os.fstat(held), self._part.stat()):
                    return held
            except BlockingIOError:
                os.close(held)
                raise SimulationInvalid(
                    f"{self._path}: another process is writing this log; wait for it, or choose "
                    "another file"
                ) from None
            except FileNotFoundError:
                pass
            os.close(held)  # of one that has just ended

    def add(self, run: Run) -> None:
        """Write the instants of a run, which come after those written before."""
        from pyarrow import ipc

        if self._writer is None:
            options = ipc.IpcWriteOptions(compression="zstd")
            self._schema = schema_of(run)
            self._writer = ipc.new_stream(self._file, self._schema, options=options)
        more = metadata(happened(run))
        with self._blaming():
            for index in range(len(run)):
                self._writer.write_batch(rows_of(run, index, self._schema), custom_metadata=more)
        self._last = run

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None,
        trace: TracebackType | None,
    ) -> None:  # fmt: skip
        """End: the rows go into their place, or stay where they are if the block raises."""
        try:
            with suppress(OSError) if kind else self._blaming():
                if self._writer is not None:
                    self._writer.close()
                self._file.close()
            if kind is None and self._last is not None:
                with self._blaming():
                    self._finish(self._last)
            if kind is None or self._last is None:
                self._part.unlink(missing_ok=True)
        finally:
            os.close(self._held)

    @contextmanager
    def _blaming(self) -> Iterator[None]:
        """Name the file that cannot be written, which Arrow does not, and what there is of it."""
        try:
            yield
        except OSError as error:
            said = os.strerror(error.errno) if error.errno else str(error)
            if self._last is not None:
                said += (
                    f"; what was run until {span(float(self._last.times[-1]))} is in {self._part}"
                )
            raise OSError(error.errno, said, str(self._path)) from None

    def _finish(self, run: Run) -> None:
        """Write all rows as a table, whole or not at all."""
        from pyarrow import ipc, parquet

        about = metadata({**asked(run), **happened(run)})
        with self._part.open("rb") as file, ipc.open_stream(file) as rows:
            schema = rows.schema.with_metadata(about)
            settings: dict[str, Any] = {
                "compression": "zstd",
                "use_dictionary": False,
                "use_byte_stream_split": [name for name in schema.names if name != "seed"],
            }
            with (
                scratch_for(self._path) as scratch,
                parquet.ParquetWriter(scratch, schema, **settings) as table,
            ):
                for piece in _pieces(rows, len(run)):
                    table.write_table(piece, row_group_size=piece.num_rows)


def _pieces(rows: Any, runs: int) -> Iterator[Any]:
    """Go through the rows of a stream: those of several runs in turn, of one many at once."""
    import pyarrow as pa

    batches: list[Any] = []
    for batch in rows:
        batches.append(batch)
        if runs > 1 or sum(each.num_rows for each in batches) >= TOGETHER:
            yield pa.Table.from_batches(batches)
            batches = []
    if batches:
        yield pa.Table.from_batches(batches)


def write_log(run: Run, path: str | Path) -> Path:
    """Write a run as a log, whole or not at all.

    Parameters
    ----------
    run : Run
    path : str or Path

    Returns
    -------
    Path

    Raises
    ------
    PackageMissing, SimulationInvalid, OSError
        As for `Log`.
    """
    with Log(path) as log:
        log.add(run)
    return Path(path)
