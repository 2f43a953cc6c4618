"""Placement over random and degenerate families: the slowest input counts."""

import statistics

import numpy as np
from ours import bare_quality, search_of
from page import Part, digits, duration, power_of_ten, table
from problems import FAMILIES, problem_of
from timing import clock

import swarmgrasp as sg

HEADS = ("inputs", "median", "99th percentile", "slowest", "times one quality", "whole call")
TEXT = """## One placement, whatever the input

{inputs} inputs per row of up to 15 robots and a newcomer that pushes, pulls or is free, gap 1e-6:
the search alone once set up, the median of its ratio to one bare exact quality of the same swarm,
and the median of the whole `place` on an outline it has met, with its set-up, tie-break and exact
re-evaluation; measured in turn. A search beyond 0.1 ms is clocked twice, and the quicker time
counts.
"""
GAP = 1e-6
HICCUP = 1e-4
"""Time [s] beyond which a search is clocked again: a hard input, or a busy machine?"""


def search_time(problem):
    """Return the seconds a search takes once set up."""
    search = search_of(problem)
    return clock(lambda: search.solve(GAP))


def times_of(family, inputs):
    """Return (search, quality, whole call) in seconds for every input, (inputs, 3)."""
    rng = np.random.default_rng(1)
    rows = np.empty((inputs, 3))
    for row in rows:
        problem = problem_of(family, rng)
        generators = problem.swarm.scaled_generators
        row[0] = search_time(problem)
        if row[0] > HICCUP:
            row[0] = min(row[0], search_time(problem))
        row[1] = clock(lambda g=generators: bare_quality(g))
        row[2] = clock(lambda p=problem: sg.place(p.swarm, p.newcomer, gap=GAP))
    return rows


def measure(args):
    """Measure all families; return the page's section."""
    inputs = 50 if args.quick else 1000
    rows, slowest = [], {}
    for family in FAMILIES:
        search, one_quality, whole = times_of(family, inputs).T
        slowest[family] = search.max()
        ratio = statistics.median(search / one_quality)
        times = np.median(search), np.quantile(search, 0.99), search.max()
        rows.append((family, *map(duration, times), digits(ratio), duration(np.median(whole))))
        print("   ", *rows[-1], sep="  ", flush=True)
    worst = max(slowest, key=slowest.get)
    said = (
        f"Slowest of all {power_of_ten(inputs * len(FAMILIES))} inputs: {duration(slowest[worst])} "
        f"({worst}).\n"
    )
    return Part(TEXT.format(inputs=inputs) + "\n" + table(HEADS, rows) + "\n" + said)
