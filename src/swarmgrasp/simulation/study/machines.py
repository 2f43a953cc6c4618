"""Many machines: the workers of a Dask cluster."""

from collections.abc import Callable, Iterator
from concurrent.futures import BrokenExecutor, Executor, Future, InvalidStateError
from contextlib import contextmanager, suppress
from threading import Event, Thread
from typing import Any, NamedTuple, ParamSpec, TypeVar
from weakref import WeakSet

from swarmgrasp.errors import StudyInvalid
from swarmgrasp.packages import check_installed

Given = ParamSpec("Given")
Found = TypeVar("Found")

RETRIES = 2
"""How often Dask itself tries a shard again whose worker was lost."""
PATIENCE = 10.0
"""How long a scheduler may take to answer, or to come back [s]."""
LOOK = 1.0
"""How often it is looked whether it is still there [s]."""

ENDED = ("closing", "closed")
"""What a client of Dask says of itself whose scheduler is gone."""
GONE = "the Dask scheduler is gone"


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
        cluster, over = Cluster(client), Event()
        watch = Thread(target=_watch, args=(cluster, over), daemon=True)
        watch.start()
        try:
            yield Machines(cluster, threads)
        finally:
            over.set()
            watch.join()


class Cluster(Executor):
    """The workers of a Dask client, as an executor that breaks when their scheduler is gone.

    Dask's own leaves those that wait for its futures waiting then.

    Parameters
    ----------
    client : distributed.Client
    """

    def __init__(self, client: Any) -> None:
        self._client = client
        self._workers = client.get_executor(pure=False, retries=RETRIES)
        self._given: WeakSet[Future[Any]] = WeakSet()

    def submit(
        self, work: Callable[Given, Found], /, *args: Given.args, **kwargs: Given.kwargs
    ) -> Future[Found]:
        """Hand out work."""
        try:
            future: Future[Found] = self._workers.submit(work, *args, **kwargs)
        except Exception as error:  # of Dask's own make
            if self._client.status in ENDED:
                raise BrokenExecutor(GONE) from error
            raise
        self._given.add(future)
        return future

    def look(self) -> bool:
        """Tell whether the scheduler is there; if not, what was handed out is broken."""
        if self._client.status != "closed":
            return True
        for future in list(self._given):
            with suppress(InvalidStateError):  # one that is done
                future.set_exception(BrokenExecutor(GONE))
        return False


def _watch(cluster: Cluster, over: Event) -> None:
    """Look after a cluster until it is gone, or all is over."""
    while not over.wait(LOOK) and cluster.look():
        pass
