"""A log is read back by others, with its units."""

import json

import duckdb
import numpy as np
import pytest
from pyarrow import parquet

from made_runs import made_run
from swarmgrasp.simulation.record import write_log


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
