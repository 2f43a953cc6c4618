"""The log of a run: a table in a Parquet file, a row for each run and instant.

Numbers are in 4 bytes, their bytes sorted by place before they are packed: that makes a file three
times smaller than doubles do. Only the time keeps 8. Each column tells its unit.

While the run goes on the rows go into a file beside it, `run.parquet.part`, a stream of Arrow,
which can be read at any time, also after the run was killed.
"""

from swarmgrasp.simulation.record.log import Log, write_log
from swarmgrasp.simulation.record.reading import read_log

__all__ = ["Log", "read_log", "write_log"]
