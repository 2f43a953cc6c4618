"""One exact quality, beside three other ways to compute it."""

import numpy as np
from page import Part, difference, digits, duration, power_of_ten, table
from pictures import lines
from problems import closed, rectangle
from rivals import all_pairs, hyperplane_shifting, minkowski_hull
from timing import in_turn

import swarmgrasp as sg

RIVALS = {
    hyperplane_shifting: (10, 25, 50, 100, 200),
    minkowski_hull: (10, 25, 50, 100, 200),
    all_pairs: (10, 25, 50, 100, 200, 1000),
}
"""Numbers of robots each is asked for."""
NORMALS = 25
"""Number of robots pulling along the normals, where many share a plane."""
INPUTS, ROUNDS, PATIENCE = 5, 7, 1.0
"""Swarms per row, turns at each, and seconds after which no new turn or swarm begins."""
HEADS = ("method", "robots", "directions", "its time", "ours", "times ours", "largest difference")
TEXT = """## One quality

The exact Max-Transfer quality of robots on random rectangles, in force closure, by
`quality(swarm)`. pycapacity's method lists the
faces of a wrench polytope one pair of robots at a time; the hull of the Minkowski sum grows by one
robot at a time; all pairs is the paper's formula (IV.1) with one matrix product for many normals.
A turn repeats short calls for 5 ms. The difference is that of the two qualities, relative to ours.
"""


def row(rival, count, along_normals):
    """Clock one rival at one number of robots; return (its time, our time, difference)."""
    rng = np.random.default_rng(count)
    ours, theirs, apart = [], [], []
    for _ in range(INPUTS):
        swarm = closed(rectangle(rng), count, rng, along_normals)
        generators = swarm.scaled_generators
        mine, other = in_turn(
            lambda s=swarm: sg.quality(s).value,
            lambda g=generators: rival.quality(g),
            ROUNDS,
            PATIENCE,
        )
        ours += mine.seconds
        theirs += other.seconds
        apart.append(abs(other.value - mine.value) / mine.value)
        if sum(theirs) > PATIENCE * INPUTS:
            break
    return float(np.median(theirs)), float(np.median(ours)), max(apart)


def measure(args):
    """Measure all rows; return the page's section."""
    rows, curves = [], {}
    for rival, sizes in RIVALS.items():
        for count, along in [(n, False) for n in sizes] + [(NORMALS, True)]:
            if count > (50 if args.quick else args.largest):
                continue
            theirs, ours, apart = row(rival, count, along)
            where = "along the normals" if along else "any"
            rows.append(
                (rival.NAME, power_of_ten(count), where, duration(theirs), duration(ours),
                 digits(theirs / ours), difference(apart))
            )  # fmt: skip
            print("   ", *rows[-1], sep="  ", flush=True)
            if not along:
                curves.setdefault(rival.NAME, []).append((count, theirs))
                curves.setdefault("swarmgrasp", {})[count] = ours
    curves["swarmgrasp"] = sorted(curves["swarmgrasp"].items())
    picture = "Time of one quality over the number of robots", lines(curves, "time of one quality")
    return Part(TEXT + "\n" + table(HEADS, rows), {"benchmark-quality.png": picture})
