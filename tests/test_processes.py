"""Worker processes: what they are told, and that none is left behind."""

import os
import signal
import subprocess
import sys
from concurrent.futures import BrokenExecutor

import pytest

from swarmgrasp.processes import THREADS, Pool, one_thread_each
from workers import needs_proc, wait_for_the_end

PARENT = """
import multiprocessing, signal
from swarmgrasp.processes import Pool
if __name__ == "__main__":
    pool = Pool(2)
    futures = [pool.submit(signal.pause) for _ in range(2)]
    print(*(child.pid for child in multiprocessing.active_children()), flush=True)
    signal.pause()
"""

INTERRUPTED = """
import os, signal
from swarmgrasp.processes import Pool
if __name__ == "__main__":
    signal.signal(signal.SIGINT, signal.default_int_handler)  # whatever it was started with
    pool = Pool(1)
    future = pool.submit(abs, -3)
    try:
        os.killpg(0, signal.SIGINT)
        signal.pause()
    except KeyboardInterrupt:
        print(future.result())
    pool.close()
"""


def test_ctrl_c_is_not_heard_by_a_worker_that_is_just_starting(tmp_path):
    """A terminal sends it to all processes; this one decides what becomes of the work."""
    script = tmp_path / "interrupted.py"
    script.write_text(INTERRUPTED)
    done = subprocess.run(
        [sys.executable, script], capture_output=True, text=True, check=True,
        start_new_session=True,
    )  # fmt: skip
    assert (done.stdout, done.stderr) == ("3\n", "")


@needs_proc
def test_no_worker_outlives_a_parent_that_is_killed(tmp_path):
    """Not even one in the middle of its work."""
    script = tmp_path / "parent.py"
    script.write_text(PARENT)
    with subprocess.Popen([sys.executable, script], stdout=subprocess.PIPE, text=True) as parent:
        workers = [int(word) for word in parent.stdout.readline().split()]
        assert len(workers) == 2
        os.kill(parent.pid, signal.SIGKILL)
    wait_for_the_end(workers)


def test_a_pool_that_is_closed_ends_what_it_is_at():
    """Without waiting for it, and calls what is lost broken."""
    pool = Pool(1)
    assert pool.submit(abs, -3).result() == 3
    endless = pool.submit(signal.pause)
    while not endless.running():
        os.sched_yield()
    pool.close()
    with pytest.raises(BrokenExecutor):
        endless.result()


def test_workers_use_one_thread_and_leave_ctrl_c_alone(monkeypatch):
    """The settings of this process are as before."""
    monkeypatch.setenv(THREADS[0], "7")
    monkeypatch.delenv(THREADS[1], raising=False)
    with one_thread_each():
        pool = Pool(1)
        told = [pool.submit(os.getenv, name).result() for name in THREADS]
        held_back = pool.submit(signal.pthread_sigmask, signal.SIG_BLOCK, set()).result()
        pool.close()
    assert told == ["1", "1", "1"]
    assert signal.SIGINT in held_back
    assert signal.SIGINT not in signal.pthread_sigmask(signal.SIG_BLOCK, set())
    assert (os.environ[THREADS[0]], os.environ.get(THREADS[1])) == ("7", None)
