"""What the kernel of motion refuses."""

import numpy as np
import pytest

from swarmgrasp.kernels import motion

HULL, DRIVERS, STATES = np.ones((1, 38)), np.ones((2, 11)), np.zeros((3, 10))
STREAMS, ORDERS, LOADS = np.zeros((3, 4)), np.zeros((3, 4)), np.zeros((3, 3))


def test_refuses_arrays_that_do_not_go_together():
    """Rows too few or too wide, a robot that follows nothing there is, no number, no step."""
    given = [HULL, DRIVERS, STATES, STREAMS, ORDERS, LOADS]
    strange = DRIVERS.copy()
    strange[1, 7] = 4.0
    for place, wrong in (
        (0, np.ones((2, 38))), (1, strange), (2, np.zeros((3, 5))), (2, np.zeros((2, 10))),
        (3, np.zeros((2, 4))), (4, np.zeros((3, 2))), (5, np.zeros((4, 3))),
    ):  # fmt: skip
        asked = [*given[:place], wrong, *given[place + 1 :]]
        with pytest.raises(ValueError, match=r"a row of each array|rows of"):
            motion.advance(*asked, 0.1, 1)
        if place < 4:
            with pytest.raises(ValueError, match=r"a row of each array|rows of"):
                motion.exerted(*asked[:4])
    with pytest.raises(ValueError, match="finite"):
        motion.advance(*given[:5], np.full((3, 3), np.nan), 0.1, 1)
    for step, steps in ((0.0, 1), (np.inf, 1), (0.1, -1)):
        with pytest.raises(ValueError, match="a positive step"):
            motion.advance(*given, step, steps)
    assert len(motion.advance(*given, 0.1, 2)) == STATES.nbytes
