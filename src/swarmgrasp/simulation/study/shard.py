"""What a worker does: measure the runs of one shard, and return them as the bytes of a file."""

from collections.abc import Mapping
from functools import lru_cache
from typing import Any

import numpy as np
import pyarrow as pa
import pyarrow.parquet as pq

from swarmgrasp.errors import StudyInvalid
from swarmgrasp.simulation.study.plan import Plan, plan_of
from swarmgrasp.simulation.study.study import Column, Seeds, Study

TYPES = {"count": pa.int64(), "number": pa.float64(), "flag": pa.bool_()}
LONGEST_FAULT = 300
"""Characters of a fault that are kept."""


def shard_bytes(text: str, shard: int) -> bytes:
    """Measure a shard.

    Parameters
    ----------
    text : str
        The plan.
    shard : int
        Which, from 0.

    Returns
    -------
    bytes
        Of a Parquet file: `run`, the study's columns, and `fault`, which is null unless the run
        failed; units and words are in the fields' metadata.

    Raises
    ------
    StudyInvalid
        If the plan is of another version or of other kernels than are installed here.
    """
    plan = _plan(text)
    study = plan.study
    seeds, schema = plan.seeds(shard), schema_of(study)
    first = shard * plan.size
    batches: list[pa.RecordBatch] = []
    for start in range(0, len(seeds), study.batch):
        numbers = np.arange(first + start, first + min(start + study.batch, len(seeds)))
        batches += _measured(study, seeds[start : start + study.batch], numbers, schema)
    table = pa.Table.from_batches(batches, schema).combine_chunks()
    return _as_file(table)


def schema_of(study: Study) -> pa.Schema:
    """Return the columns of a study's files."""
    run = Column("count", "", "number of the run, from 0")
    return pa.schema(
        [_field(name, column) for name, column in {"run": run, **study.columns}.items()]
        + [pa.field("fault", pa.string(), metadata={"words": "what made the run fail"})]
    )


def _field(name: str, column: Column) -> pa.Field:
    """Return a column as Arrow has it."""
    told = {"unit": column.unit, "words": column.words}
    return pa.field(name, TYPES[column.type], metadata=told)


@lru_cache(maxsize=1)
def _plan(text: str) -> Plan:
    """Return the plan that a worker is given with each shard, checked once."""
    plan = plan_of(text)
    here = Plan.of(plan.name, plan.study, plan.runs, plan.seed)
    if (plan.release, plan.kernels) != (here.release, here.kernels):
        raise StudyInvalid(
            f"the study is of swarmgrasp {plan.release} with kernels {plan.kernels}, and a worker "
            f"has {here.release} with {here.kernels}; install the same there, or choose another "
            "folder"
        )
    return plan


def _measured(study: Study, seeds: Seeds, runs: Seeds, schema: pa.Schema) -> list[pa.RecordBatch]:
    """Measure a batch; if it fails, each run alone, and what fails then is a row with its fault."""
    try:
        return [_batch(study.measure(seeds), runs, schema)]
    except Exception as error:  # whatever it is, the other runs are not to be lost
        if len(seeds) > 1:
            alone = zip(seeds.reshape(-1, 1), runs.reshape(-1, 1), strict=True)
            return [row for seed, run in alone for row in _measured(study, seed, run, schema)]
        fault = f"{type(error).__name__}: {error}"[:LONGEST_FAULT]
        return [_batch({}, runs, schema, fault)]


def _batch(
    told: Mapping[str, Any], runs: Seeds, schema: pa.Schema, fault: str | None = None
) -> pa.RecordBatch:
    """Return what runs tell as Arrow has it; null where there is nothing to tell."""
    count = len(runs)
    columns = {"run": runs, "fault": [fault] * count, **told}
    arrays = [
        pa.array(columns[field.name], field.type, from_pandas=True)  # nan as null
        if field.name in columns
        else pa.nulls(count, field.type)
        for field in schema
    ]
    return pa.RecordBatch.from_arrays(arrays, schema=schema)


def _as_file(table: pa.Table) -> bytes:
    """Return a table as the bytes of a Parquet file, the same for the same table."""
    sink = pa.BufferOutputStream()
    encodings = {f.name: "BYTE_STREAM_SPLIT" for f in table.schema if f.type == pa.float64()}
    pq.write_table(table, sink, compression="zstd", use_dictionary=False, column_encoding=encodings)
    content: bytes = sink.getvalue().to_pybytes()
    return content
