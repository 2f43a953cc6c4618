"""Push forces of robots that steer: how hard, and which way, each pushes for a wrench."""

import numpy as np
from force_sets import crew
from page import Part, difference, digits, duration, power_of_ten, table
from rivals import clarabel_cones
from timing import in_turn

import swarmgrasp as sg

COUNTS = (4, 8, 15, 50)
PART = 0.6
"""Of the quality that the wrenches ask for: they can all be made."""
TEXT = """## Push forces

Mixed robots as above, and wrenches in random directions of 0.6 times their quality: the least
largest share, then the least sum of squares, by `forces(swarm, wrench)` as called, with its
certificate. Beside it Clarabel, which solves two cone programs; told is only the time that it
states for itself, without what it takes to set them up. The difference is that of the largest
shares.

{rows}"""


def measure(args):
    """Measure the push forces; return the page's section."""
    rng, rows = np.random.default_rng(12), []
    for count in COUNTS:
        ours, theirs, apart = [], [], []
        for _ in range(5 if args.quick else 50):
            swarm = crew("mixed", count, rng)
            way = rng.normal(size=3)
            way *= PART * sg.quality(swarm).value / np.linalg.norm(way)
            wrench = tuple((way / swarm.scale).tolist())
            found, other = in_turn(
                lambda s=swarm, w=wrench: sg.forces(s, w),
                lambda s=swarm, w=wrench: clarabel_cones.forces(s, w),
                3,
            )
            ours.append(found.median)
            theirs.append(other.value[2])
            apart.append(abs(found.value.needed - other.value[0]))
        mine, rival = np.median(ours), np.median(theirs)
        rows.append(
            (power_of_ten(count), duration(mine), duration(rival), digits(rival / mine),
             difference(max(apart)))
        )  # fmt: skip
        print("   ", *rows[-1], sep="  ", flush=True)
    heads = ("mixed robots", "median", "Clarabel", "times ours", "difference")
    return Part(TEXT.format(rows=table(heads, rows)))
