"""Many machines: the workers of a Dask cluster."""

from collections.abc import Iterator
from concurrent.futures import Executor
from contextlib import contextmanager
from typing import NamedTuple

from swarmgrasp.errors import StudyInvalid
from swarmgrasp.packages import check_installed

RETRIES = 2
"""How often Dask itself tries a shard again whose worker was lost."""
PATIENCE = 10.0
"""How long a scheduler may take to answer [s]."""


class Machines(NamedTuple):
    """Those of a cluster.

    Attributes
    ----------
    executor : Executor
    workers : int
        Shards that are done at once.
    """

    executor: Executor
    workers: int


@contextmanager
def machines_at(address: str) -> Iterator[Machines]:
    """Offer the workers of a Dask cluster, which have this package installed, the same version.

    Parameters
    ----------
    address : str
        Of the scheduler, such as "tcp://10.0.0.7:8786".

    Raises
    ------
    StudyInvalid
        If none answers there, or it has no workers.
    PackageMissing
        If distributed is not installed.
    """
    check_installed("distributed", extra="dask", purpose="A study on many machines")
    from distributed import Client

    try:
        client = Client(address, timeout=PATIENCE)
    except (OSError, TimeoutError, ValueError) as error:
        raise StudyInvalid(
            f"{address}: no Dask scheduler answers there ({type(error).__name__}); it should be an "
            "address such as tcp://10.0.0.7:8786"
        ) from None
    with client:
        threads = sum(client.nthreads().values())
        if not threads:
            raise StudyInvalid(f"{address}: the Dask scheduler has no workers; start some")
        yield Machines(client.get_executor(pure=False, retries=RETRIES), threads)
