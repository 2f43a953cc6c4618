"""Measure one quality or one placement at given sizes; print a line of JSON for each.

``python benchmarks/growth_worker.py quality random 100 300``
"""

import json
import resource
import sys
import time
from pathlib import Path

import numpy as np
from crowds import swarm_of
from rivals import all_pairs
from timing import Clocked

import swarmgrasp as sg

ROUNDS, PATIENCE = 5, 0.5
"""Calls clocked, and seconds after which no new one begins."""
CHECKED = 300
"""Number of distinct robots up to which the quality is compared with that of all pairs."""


def peak():
    """Return the most memory this process has held [byte].

    Linux hands the parent's `ru_maxrss` on to a child, so its own high-water mark comes first.
    """
    status = Path("/proc/self/status")
    marks = status.read_text().splitlines() if status.exists() else []
    for line in marks:
        if line.startswith("VmHWM:"):
            return 1024 * int(line.split()[1])
    unit = 1 if sys.platform == "darwin" else 1024
    return unit * resource.getrusage(resource.RUSAGE_SELF).ru_maxrss


def work_on(task, swarm):
    """Do the task once; return the answer."""
    return sg.quality(swarm) if task == "quality" else sg.place(swarm, sg.Newcomer(), gap=1e-6)


def measure(task, family, count, base):
    """Return the answer for one size, its times [s] and the memory [byte]."""
    swarm = swarm_of(family, count)
    clocked, end = Clocked(), time.perf_counter() + PATIENCE
    for turn in range(ROUNDS):
        if turn and time.perf_counter() > end:
            break
        clocked.run(lambda: work_on(task, swarm))
    return clocked.value, {"seconds": clocked.seconds, "base": base, "peak": peak()}


def difference(family, count, value, direction):
    """Compare a quality [N] with an independent one, relative to the sum of the generators.

    With that of all pairs, equal robots made one as strong as all of them; if too many are
    left, with the support function at the direction that is said to attain it.
    """
    generators = swarm_of(family, count).scaled_generators
    size = np.linalg.norm(generators, axis=1).sum()
    if family == "duplicates":
        distinct, times = np.unique(generators, axis=0, return_counts=True)
        generators = distinct * times[:, None]
    if len(generators) <= CHECKED:
        return abs(all_pairs.quality(generators) - value) / size
    return abs(float(np.maximum(generators @ direction, 0.0).sum()) - value) / size


def main(task, family, *counts):
    """Measure all sizes, and then compare: that takes memory too."""
    work_on(task, swarm_of(family, 4))  # loads what is loaded at the first call
    base = peak()
    measured = [measure(task, family, int(count), base) for count in counts]
    for count, (answer, row) in zip(counts, measured, strict=True):
        if task == "quality":
            row["difference"] = difference(family, int(count), answer.value, answer.direction)
        else:
            row["proven"] = not answer.stopped_early
        print(json.dumps(row))


if __name__ == "__main__":
    main(*sys.argv[1:])
