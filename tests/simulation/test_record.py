"""A log is read back by others, with its units; and by us as far as it was written."""

import json
from dataclasses import fields, replace

import duckdb
import numpy as np
import pyarrow as pa
import pytest
from pyarrow import parquet

from made_runs import made_run
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.simulation.record import Log, read_log, write_log


@pytest.fixture(scope="module")
def run():
    return made_run()


@pytest.fixture(scope="module")
def log(run, tmp_path_factory):
    return write_log(run, tmp_path_factory.mktemp("logs") / "run.parquet")


def test_every_number_of_a_run_is_in_its_log(run, log):
    """A row for each run and instant; what a run keeps comes back to the last bit."""
    table = parquet.read_table(log)
    assert table.num_rows == len(run) * len(run.times)
    second = table.filter(np.asarray(table["seed"]) == run.seeds[1])
    assert np.array_equal(second["time"], run.times)
    assert np.array_equal(second["heading"], run.poses[1, :, 2])
    assert np.array_equal(second["wanted_y"], run.references[:, 1])
    assert np.array_equal(second["given_turn"], run.given[1, :, 2])
    assert np.array_equal(second["Castor.force"], run.forces[1, :, run.names.index("Castor")])
    fortuna = np.asarray(second["Fortuna.angle"])
    assert np.array_equal(fortuna, run.angles[1, :, run.names.index("Fortuna")], equal_nan=True)


def test_units_are_in_the_columns_and_the_question_is_in_the_file(run, log):
    """Whoever has the file alone knows what it is."""
    schema = parquet.read_schema(log)
    unit = {field.name: field.metadata[b"unit"].decode() for field in schema}
    assert (unit["x"], unit["heading"], unit["load_turn"]) == ("m", "rad", "N m")
    assert (unit["Castor.share"], unit["wind_x"], unit["speed_turn"]) == ("1", "m/s", "rad/s")
    about = json.loads(schema.metadata[b"swarmgrasp"])
    assert about["simulation"] == run.simulation.to_data()
    assert [happening["kind"] for happening in about["happenings"]][-1] == "joined"


def test_a_log_is_small_and_asked_by_duckdb(run, log):
    """Bytes sorted by place and packed; a question in SQL finds the largest error of each run."""
    described = parquet.ParquetFile(log).metadata.row_group(0)
    column = next(
        described.column(i)
        for i in range(described.num_columns)
        if described.column(i).path_in_schema == "load_x"
    )
    assert column.encodings == ("BYTE_STREAM_SPLIT",) or "BYTE_STREAM_SPLIT" in column.encodings
    assert (column.compression, column.physical_type) == ("ZSTD", "FLOAT")
    rows = duckdb.sql(
        f"select seed, max(error) from read_parquet('{log}') group by seed order by seed"
    ).fetchall()
    assert rows == [(s, float(run.distances[i].max())) for i, s in enumerate(run.seeds)]


IN_TIME = (
    "poses", "velocities", "distances", "turns", "streams", "loads", "wanted", "given",
    "shortfalls", "forces", "angles", "shares",
)  # fmt: skip


def piece_of(run, first, last):
    """Return some instants of a run as a run of its own."""
    rows = slice(first, last)
    held = {name: getattr(run, name)[:, rows] for name in IN_TIME}
    return replace(run, times=run.times[rows], references=run.references[rows], **held)


def assert_same_run(found, wanted):
    """Compare all numbers, to the last bit."""
    for field in fields(wanted):
        one, two = getattr(found, field.name), getattr(wanted, field.name)
        if isinstance(two, np.ndarray):
            assert np.array_equal(one, two, equal_nan=True), field.name
    assert (found.names, found.seeds, found.is_whole) == (
        wanted.names,
        wanted.seeds,
        wanted.is_whole,
    )
    assert [h.to_data() for h in found.happenings] == [h.to_data() for h in wanted.happenings]
    assert found.simulation.to_data() == wanted.simulation.to_data()


def test_a_log_is_read_while_its_run_goes_on(run, tmp_path):
    """As far as it was written; at its end it is whole, and the part beside it is gone."""
    path = tmp_path / "run.parquet"
    with Log(path) as log:
        with pytest.raises(SimulationInvalid, match="nothing of the run has been written yet"):
            read_log(path)
        log.add(piece_of(run, 0, 70))
        assert_same_run(read_log(path), replace(piece_of(run, 0, 70), is_whole=False))
        with (
            pytest.raises(SimulationInvalid, match="another process is writing this log"),
            Log(path),
        ):
            pass
        log.add(piece_of(run, 70, 100))
        log.add(piece_of(run, 100, 151))
    assert_same_run(read_log(path), run)
    assert list(tmp_path.iterdir()) == [path]
    write_log(piece_of(run, 0, 3), path)  # over one that is there
    assert_same_run(read_log(path), piece_of(run, 0, 3))


def test_what_was_written_before_a_kill_is_read(run, tmp_path):
    """Cut off anywhere, all pieces before that are there; the next run begins anew."""
    path, part = tmp_path / "run.parquet", tmp_path / "run.parquet.part"
    ends = []

    def killed():
        with Log(path) as log:
            for first in (0, 50, 100):
                log.add(piece_of(run, first, first + 50))
                ends.append(part.stat().st_size)
            raise ZeroDivisionError  # as a full disk might

    with pytest.raises(ZeroDivisionError):
        killed()
    whole = part.read_bytes()
    assert_same_run(read_log(part), replace(piece_of(run, 0, 150), is_whole=False))
    for size in np.linspace(1, len(whole) - 1, 23).astype(int).tolist():
        part.write_bytes(whole[:size])
        count = 50 * sum(size >= end for end in ends)
        if count:
            assert len(read_log(path).times) == count
        else:
            with pytest.raises(SimulationInvalid, match=r"part: (nothing of|is no log of)"):
                read_log(path)
    write_log(run, path)
    assert list(tmp_path.iterdir()) == [path]


def test_a_file_that_is_no_log_is_told(run, tmp_path):
    """Text, nothing, a table of others, a log cut short, a folder, no file at all."""
    table, cut = tmp_path / "table.parquet", tmp_path / "cut.parquet"
    parquet.write_table(pa.table({"seed": [1], "time": [2.0]}), table)
    cut.write_bytes(write_log(run, cut).read_bytes()[:-9])
    for name, content in (("text", b"time, x\n0, 1\n"), ("arrow", b"\xff\xff\xff\xff" + bytes(60))):
        (tmp_path / name).write_bytes(content)
    for name in ("table.parquet", "cut.parquet", "text", "arrow"):
        with pytest.raises(SimulationInvalid, match="is no log of a run, as"):
            read_log(tmp_path / name)
    with pytest.raises(SimulationInvalid, match="is a folder"):
        read_log(tmp_path)
    with pytest.raises(SimulationInvalid, match="there is no such file"):
        read_log(tmp_path / "none.parquet")
