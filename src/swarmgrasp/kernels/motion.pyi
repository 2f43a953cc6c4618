"""The motion of an object pushed by robots; `motion.h` beside this file says by what equations.

Arrays are C-contiguous float64 of the sizes given and finite; anything else raises `ValueError`.
What takes long lets other threads run, looks at the keyboard in between, and raises
`KeyboardInterrupt`.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

def advance(
    hull: Array,
    drivers: Array,
    states: Array,
    streams: Array,
    orders: Array,
    loads: Array,
    step: float,
    steps: int,
    /,
) -> bytes:
    """Return states (runs, 6 + 2 n) some steps on, each `step` [s] long.

    The hull (38,) and the drivers (n, 11) are as `motion.h` has `Afloat` and `Driver`. Orders
    (runs, 2 n) [N, rad] are a force and an angle of each robot; streams (runs, 4) [m/s] and loads
    (runs, 3) [N, N, N m] stay as they are. What returns is finite unless the step is far too long.
    """

def exerted(hull: Array, drivers: Array, states: Array, streams: Array, /) -> bytes:
    """Return the wrenches (runs, 9) [N, N, N m] of robots, wind and water on the object."""
