"""Ctrl-C stops a long run at once."""

import signal
import subprocess
import sys
import threading
import time

import numpy as np
import pytest

from swarmgrasp.quality.weakest import weakest_of

RING = """
import numpy as np
from swarmgrasp.quality.weakest import weakest_of
turn = np.arange(400_000) * (np.pi / 200_000)
ring = np.column_stack([np.cos(turn), np.sin(turn), 0.3 * (-1.0) ** np.arange(len(turn))])
print("begins", flush=True)
try:
    weakest_of(ring)
except KeyboardInterrupt:
    print("stopped")
"""
"""Every facet of a perfectly regular ring is the weakest: nothing takes longer."""


@pytest.mark.skipif(sys.platform == "win32", reason="signals differ")
def test_a_search_is_interrupted_from_the_keyboard():
    """The kernel returns long before it is done, as KeyboardInterrupt."""
    with subprocess.Popen([sys.executable, "-c", RING], stdout=subprocess.PIPE, text=True) as run:
        assert run.stdout.readline() == "begins\n"
        time.sleep(0.7)
        run.send_signal(signal.SIGINT)
        said, _ = run.communicate(timeout=5.0)
    assert said == "stopped\n"


def test_other_threads_go_on():
    """While one computes, the others are not kept waiting."""
    turn = np.arange(20_000) * (np.pi / 10_000)
    ring = np.column_stack([np.cos(turn), np.sin(turn), 0.3 * (-1.0) ** np.arange(len(turn))])
    worker = threading.Thread(target=weakest_of, args=(ring,))
    worker.start()
    ticks = 0
    while worker.is_alive():
        time.sleep(0.005)
        ticks += 1
    assert ticks > 10
