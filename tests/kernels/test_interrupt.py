"""Ctrl-C stops a long run at once, and other threads go on meanwhile."""

import signal
import sys

import numpy as np
import pytest

from afloat import random_run
from alongside import while_it_computes
from swarmgrasp.quality.weakest import weakest_of

TURN = np.arange(400_000) * (np.pi / 200_000)
RING = np.column_stack([np.cos(TURN), np.sin(TURN), 0.3 * (-1.0) ** np.arange(len(TURN))])
"""Every facet of a perfectly regular ring is the weakest: nothing takes longer."""


@pytest.fixture
def keyboard():
    """Have Python listen to the keyboard, though tests that run in the background may not."""
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


@pytest.mark.skipif(sys.platform == "win32", reason="signals differ")
@pytest.mark.usefixtures("keyboard")
def test_a_search_is_interrupted_from_the_keyboard():
    """The kernel returns long before it is done, as KeyboardInterrupt."""
    with (
        while_it_computes(lambda: signal.raise_signal(signal.SIGINT)),
        pytest.raises(KeyboardInterrupt),
    ):
        weakest_of(RING)


@pytest.mark.skipif(sys.platform == "win32", reason="signals differ")
@pytest.mark.usefixtures("keyboard")
def test_motion_is_interrupted_from_the_keyboard():
    """One long run as well as many."""
    plant, states, orders, streams, loads = random_run(0, 1)
    with (
        while_it_computes(lambda: signal.raise_signal(signal.SIGINT)),
        pytest.raises(KeyboardInterrupt),
    ):
        plant.advance(states, orders, streams, loads, 1e-3, 10**7)


def test_other_threads_go_on():
    """While one computes, the others are not kept waiting."""
    said = []
    with while_it_computes(lambda: said.append("still here")):
        weakest_of(RING[::4])
        assert said == ["still here"]
