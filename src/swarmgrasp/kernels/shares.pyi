"""The least shares that make wrenches; `forces.h` beside this file says how they are found.

Arrays are C-contiguous float64 of the sizes given and finite; anything else raises `ValueError`.
What takes long lets other threads run, looks at the keyboard in between, and raises
`KeyboardInterrupt`.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

def least_shares(
    generators: Array,
    wrenches: Array,
    load: tuple[float, float, float],
    starts: Array = ...,
    /,
) -> bytes:
    """Return a row for each wrench (m, 3) [N] of generators (n, 3) [N] beside a load (3,) [N].

    All are in the metric's coordinates. Each search starts from a normal of starts (m, 3), unless
    that is 0; without them, from where that of the row before ended. A row (n + 15,) holds the
    shares (n,); the least largest load of the wrench, above 1 and perhaps infinite if it is out of
    reach; the distance [N] of the nearest attainable wrench, which is then made, and else 0; and
    the proof: three normals (9,), those not needed 0, and a price (3,) [1/N]. Last is 1 if a quick
    check of its own confirms them, and else 0.
    """

def push_forces(
    arms: Array,
    elements: Array,
    counts: Array,
    scale: tuple[float, float, float],
    wrenches: Array,
    load: tuple[float, float, float],
    /,
) -> bytes:
    """Return a row for each wrench (m, 3) [N] of robots with force sets beside a load (3,) [N].

    Arms (n, 2) [m], elements (k, 5) [N] and how many each robot has (n,), at least 1, are as in
    `force_set.h`; the scale (3,) [1, 1, 1/m] turns wrenches into the metric's coordinates, in which
    all others are. A row (3 n + 13,) holds the forces (2 n,) [N], the shares (n,), the least
    largest share, the distance [N] of the nearest attainable wrench, and the proof: two normals
    (6,), those not needed 0, and a price (3,) [1/N]. Last are 1 or 0: whether the sum of squares is
    known to be the least, and whether all else is proven but for rounding.
    """
