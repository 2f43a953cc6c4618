"""Doing a study: the same rows whoever does them, and nothing lost by whatever is killed."""

import json
import multiprocessing
import os
import signal
import subprocess
import sys
from concurrent.futures import Future, ThreadPoolExecutor

import pyarrow.parquet as pq
import pytest

from moored import moored
from swarmgrasp.errors import StudyInvalid, StudyStopped
from swarmgrasp.simulation.study import Gusts, Sizes, Story, machines_at, run_plan, work
from swarmgrasp.simulation.study.gather import digest
from swarmgrasp.simulation.study.machines import Cluster
from swarmgrasp.simulation.study.plan import folder_of
from swarmgrasp.simulation.study.shard import shard_bytes
from workers import Deadly, Inline, needs_proc, wait_for_the_end

PARENT = """
import multiprocessing, os, signal, sys
from pathlib import Path
from swarmgrasp.simulation.study import read_plan, run_plan

def killed(done):
    print(*(child.pid for child in multiprocessing.active_children()), flush=True)
    os.kill(os.getpid(), signal.SIGKILL)

if __name__ == "__main__":
    folder = Path(sys.argv[1])
    run_plan(folder, read_plan(folder), workers=2, progress=killed)
"""


@pytest.fixture
def wanted(tmp_path):
    """Return the digest of a study done in this process."""

    def wanted(plan):
        run_plan(tmp_path / "wanted", plan, executor=Inline())
        return digest(tmp_path / "wanted")

    return wanted


def test_the_rows_are_whole_and_in_order(plan_of, tmp_path):
    """With units, one row for each run, the last shard shorter."""
    run_plan(tmp_path / "a", plan_of(25, 10), executor=Inline())
    tables = [pq.read_table(path) for path in sorted((tmp_path / "a").glob("part-*"))]
    assert [table.num_rows for table in tables] == [10, 10, 5]
    assert [run for table in tables for run in table["run"].to_pylist()] == list(range(25))
    assert tables[0].schema.field("quality").metadata[b"unit"] == b"N"
    assert all(table["fault"].null_count == table.num_rows for table in tables)


def test_a_run_that_throws_is_a_row_with_its_fault(plan_of, tmp_path, monkeypatch):
    """Alone: all others of its batch are measured."""
    plan = plan_of(20, 10)
    bad, measure = plan.seeds(1)[3], Sizes.measure

    def thrown(study, seeds):
        if bad in seeds:
            raise ZeroDivisionError("of all things")
        return measure(study, seeds)

    monkeypatch.setattr(Sizes, "measure", thrown)
    run_plan(tmp_path / "a", plan, executor=Inline())
    table = pq.read_table(tmp_path / "a" / "part-000001.parquet")
    faults = dict(zip(table["run"].to_pylist(), table["fault"].to_pylist(), strict=True))
    assert {run for run, fault in faults.items() if fault} == {13}
    assert faults[13] == "ZeroDivisionError: of all things"
    assert table["quality"].null_count == 1
    assert table["quality"][3].as_py() is None


def test_a_study_is_gone_on_with(plan_of, wanted, tmp_path):
    """Only what is missing is done; what is whole is left alone."""
    plan, folder = plan_of(50, 10), tmp_path / "a"
    digest_wanted = wanted(plan)
    run_plan(folder, plan, executor=Inline())
    for shard in (1, 3):
        plan.part(folder, shard).unlink()
    again, told = Inline(), []
    run_plan(folder, plan, executor=again, progress=told.append)
    assert again.given == [1, 3]
    assert told == [40, 50]
    assert digest(folder) == digest_wanted
    nothing = Inline()
    run_plan(folder, plan, executor=nothing)
    assert nothing.given == []


def test_a_worker_of_another_version_is_refused(plan_of):
    """Its rows might differ in their bytes."""
    with pytest.raises(StudyInvalid, match=r"of swarmgrasp 0\.0\.9 .* install the same"):
        shard_bytes(plan_of(10, 5, version="0.0.9").text, 0)


def test_a_shard_that_ends_its_process_again_and_again_is_told(plan_of, tmp_path, monkeypatch):
    """By its runs; all others are done, whatever they were handed out with."""

    class Once(Deadly):
        def submit(self, work, *arguments):
            is_deadly = arguments[-1] == self.deadly
            if broke and not is_deadly and not self.broken:
                return Inline.submit(self, work, *arguments)
            broke.extend([1] * (is_deadly and not self.broken))
            return super().submit(work, *arguments)

        def close(self):
            pass

    broke = []
    monkeypatch.setattr(work, "Pool", lambda _: Once(7))
    plan = plan_of(100, 10)
    with pytest.raises(StudyStopped) as caught:
        run_plan(tmp_path / "a", plan, workers=3)
    assert plan.missing(tmp_path / "a") == [7]
    assert caught.value.faults[0].startswith("runs 70 to 79 were lost 3 times with the process")
    assert len(broke) == 3


def test_an_executor_of_somebody_else_that_breaks_stops_the_study(plan_of, tmp_path):
    """With a word that what is done is kept."""
    with pytest.raises(StudyStopped, match="what is done is kept: go on with another one"):
        run_plan(tmp_path / "a", plan_of(50, 10), workers=2, executor=Deadly(2))


def test_what_is_asked_of_a_study_is_checked(tmp_path):
    """All faults at once."""
    with pytest.raises(StudyInvalid) as caught:
        run_plan(tmp_path / "a", "plan", workers=0, executor=3, progress=4)
    assert [fault.split(";")[0].split(":")[0] for fault in caught.value.faults] == [
        "'plan' is no Plan", "progress is 4", "the workers are 0", "3 is no Executor"
    ]  # fmt: skip


def test_an_executor_that_takes_no_more_stops_the_study(plan_of, tmp_path):
    """As one does that was shut down."""
    over = ThreadPoolExecutor(1)
    over.shutdown()
    with pytest.raises(StudyStopped, match=r"takes no more work .RuntimeError: cannot schedule"):
        run_plan(tmp_path / "a", plan_of(50, 10), executor=over)


def test_an_interrupt_keeps_what_is_done(plan_of, wanted, tmp_path):
    """What workers have done and was not yet written, too; going on gives the same."""
    plan, folder = plan_of(50, 10), tmp_path / "a"

    def interrupt(done):
        if done >= 20:
            raise KeyboardInterrupt

    with pytest.raises(KeyboardInterrupt):
        run_plan(folder, plan, workers=1, executor=Inline(), progress=interrupt)
    assert plan.missing(folder) == [4]  # four are handed out at once
    assert not list(folder.glob(".part*"))
    run_plan(folder, plan, executor=Inline())
    assert digest(folder) == wanted(plan)


def test_a_pool_worker_that_is_killed_costs_nothing(plan_of, wanted, tmp_path):
    """Other processes take its place; the rows are those of one process, byte for byte."""
    plan, killed = plan_of(10_000, 500), []

    def kill(_):
        if not killed:
            killed.append(multiprocessing.active_children()[0].pid)
            os.kill(killed[0], signal.SIGKILL)

    run_plan(tmp_path / "a", plan, workers=2, progress=kill)
    assert killed
    assert digest(tmp_path / "a") == wanted(plan)
    assert not multiprocessing.active_children()


@needs_proc
def test_a_parent_that_is_killed_leaves_whole_shards_and_no_worker(plan_of, wanted, tmp_path):
    """Its study is gone on with, to the same bytes."""
    plan, folder = plan_of(10_000, 500), tmp_path / "a"
    with folder_of(folder, plan):
        pass
    (tmp_path / "parent.py").write_text(PARENT)
    command = [sys.executable, tmp_path / "parent.py", folder]
    parent = subprocess.run(command, stdout=subprocess.PIPE, text=True, check=False)
    assert parent.returncode == -signal.SIGKILL
    children = parent.stdout.split()
    assert len(children) == 2
    wait_for_the_end(children)
    left = plan.missing(folder)
    assert len(left) == plan.shards - 1
    run_plan(folder, plan, executor=Inline())
    assert digest(folder) == wanted(plan)


@pytest.mark.long
@pytest.mark.parametrize("workers", [1, 2, 3])
def test_any_number_of_workers_gives_the_same_bytes(plan_of, wanted, tmp_path, workers):
    """In a pool of processes."""
    plan = plan_of(60_000, 2_000)
    run_plan(tmp_path / "a", plan, workers=workers)
    assert digest(tmp_path / "a") == wanted(plan)


@pytest.fixture
def cluster():
    """Offer two processes of a Dask cluster on this machine."""
    distributed = pytest.importorskip("distributed")
    with distributed.LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, host="127.0.0.1"
    ) as cluster:
        yield cluster


@pytest.mark.long
@pytest.mark.filterwarnings("default")  # of Dask's own
def test_dask_gives_the_same_bytes(plan_of, wanted, tmp_path, cluster):
    """As this process."""
    plan = plan_of(10_000, 500)
    with machines_at(cluster.scheduler_address) as machines:
        assert machines.workers == 2
        run_plan(
            tmp_path / "a", plan, workers=machines.workers, executor=machines.executor
        )  # fmt: skip
    assert digest(tmp_path / "a") == wanted(plan)


@pytest.mark.long
@pytest.mark.filterwarnings("default")
def test_a_dask_worker_that_is_killed_costs_nothing(plan_of, wanted, tmp_path, cluster):
    """What it was at is done again."""
    plan, killed = plan_of(10_000, 500), []
    with machines_at(cluster.scheduler_address) as machines:
        victim = machines.executor.submit(os.getpid).result()

        def kill(_):
            if not killed:
                killed.append(victim)
                os.kill(victim, signal.SIGKILL)

        run_plan(
            tmp_path / "a", plan, workers=machines.workers, executor=machines.executor,
            progress=kill,
        )  # fmt: skip
    assert killed
    assert digest(tmp_path / "a") == wanted(plan)


def test_a_scheduler_that_is_gone_breaks_what_it_was_given(plan_of, tmp_path):
    """Instead of leaving the study waiting; what was done before stays done."""

    class Client:
        """Does one thing, and is gone then."""

        status = "running"

        def get_executor(self, **_):
            return self

        def submit(self, work, *arguments):
            if self.status == "closed":
                raise ValueError("Client is closed")
            future = Future()
            if arguments[-1] == 0:
                future.set_result(work(*arguments))
            return future

    def gone(_):
        client.status = "closed"
        assert not cluster.look()

    client = Client()
    cluster, plan = Cluster(client), plan_of(50, 10)
    assert cluster.look()
    with pytest.raises(StudyStopped, match=r"broke: the Dask scheduler is gone; what is done is"):
        run_plan(tmp_path / "a", plan, workers=1, executor=cluster, progress=gone)
    assert plan.missing(tmp_path / "a") == [1, 2, 3, 4]
    with pytest.raises(StudyStopped, match=r"broke: the Dask scheduler is gone; what is done is"):
        run_plan(tmp_path / "a", plan, workers=1, executor=cluster)  # which takes no more work


@pytest.mark.filterwarnings("default")
def test_where_no_scheduler_answers_is_told(monkeypatch):
    """In one sentence, with the address."""
    monkeypatch.setattr("swarmgrasp.simulation.study.machines.PATIENCE", 0.1)
    with (
        pytest.raises(StudyInvalid, match=r"tcp://127\.0\.0\.1:9: no Dask scheduler answers there"),
        machines_at("tcp://127.0.0.1:9"),
    ):
        pass


@pytest.mark.long
@pytest.mark.parametrize("kind", [Gusts, Story])
def test_runs_of_simulations_are_the_same_bytes_too(plan_of, wanted, tmp_path, kind):
    """In two processes as in this one."""
    plan = plan_of(120, 30, kind(moored("deck-barge", 35.0, 60.0, duration=20.0)))
    run_plan(tmp_path / "a", plan, workers=2)
    assert digest(tmp_path / "a") == wanted(plan)


@pytest.mark.long
@pytest.mark.filterwarnings("default")
def test_a_study_ends_when_its_scheduler_is_killed(plan_of, wanted, tmp_path, monkeypatch):
    """With what is done kept; another one does the rest."""
    monkeypatch.setattr("swarmgrasp.simulation.study.machines.PATIENCE", 2.0)
    plan, folder, told = plan_of(40_000, 2_000), tmp_path / "a", tmp_path / "scheduler.json"
    program = [sys.executable, "-m", "distributed.cli.dask_scheduler", "--no-dashboard"]
    command = [*program, "--host", "127.0.0.1", "--port", "0", "--scheduler-file", told]
    with subprocess.Popen(command, stderr=subprocess.DEVNULL) as scheduler:
        while not told.exists() or not told.read_text().endswith("}"):
            os.sched_yield()
        address = json.loads(told.read_text())["address"]
        worker = [sys.executable, "-m", "distributed.cli.dask_worker", address, "--nthreads", "1"]
        quiet = {"stderr": subprocess.DEVNULL, "cwd": tmp_path}
        with subprocess.Popen([*worker, "--no-dashboard", "--no-nanny"], **quiet) as one:
            while not workers_at(address):
                os.sched_yield()
            with (
                pytest.raises(StudyStopped, match="the Dask scheduler is gone"),
                machines_at(address) as machines,
            ):
                run_plan(
                    folder, plan, workers=1, executor=machines.executor,
                    progress=lambda _: scheduler.kill(),
                )  # fmt: skip
            one.kill()
    assert 0 < len(plan.missing(folder)) < plan.shards
    run_plan(folder, plan, executor=Inline())
    assert digest(folder) == wanted(plan)


def workers_at(address):
    """Return how many workers a scheduler has."""
    try:
        with machines_at(address) as machines:
            return machines.workers
    except StudyInvalid:
        return 0
