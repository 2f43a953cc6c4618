"""Time and memory from 4 robots to a million, each size in a process of its own."""

import json
import statistics
import subprocess
import sys
from pathlib import Path

import numpy as np
from crowds import FAMILIES
from page import Part, difference, digits, duration, power_of_ten, table
from pictures import lines

SIZES = (4, 10, 30, 100, 300, 1000, 3000, 10_000, 30_000, 100_000, 300_000, 1_000_000)
PLACED = (16, 100, 1000, 10_000, 100_000, 1_000_000)
SHOWN = (100, 1000, 10_000, 100_000, 1_000_000)
FITTED = 1000
"""Least number of robots that the exponent is fitted to."""
TEXT = """## Growth

One exact quality, `quality(swarm)`, from 4 robots to {largest}, and one placement of a free
newcomer among random robots. The sizes up to {fitted} share a fresh process, each larger one has
its own, after a call on 4 robots; memory is that process's peak, of which {base} MB is the
interpreter with its packages. The exponent is the least-squares slope of log time over log robots
from {fitted} on. A dash is a size that was not measured.

The largest difference is over all sizes, relative to the sum of the generators' lengths. Checked
against an independent exact value, all pairs in NumPy, are the duplicates at every size, for they
are 64 robots of other limits, and all other swarms up to 300 robots. Beyond 300 robots those are
only checked to attain their value: their support function, summed anew at the direction returned.
That no other direction has less is shown there by no second method. Placements are not in this
column.
"""


def run(task, family, counts, patience):
    """Measure some sizes in a fresh process; nothing if that takes longer than the patience [s]."""
    worker = Path(__file__).with_name("growth_worker.py")
    command = [sys.executable, str(worker), task, family, *map(str, counts)]
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, check=True, timeout=patience)
    except subprocess.TimeoutExpired:
        return {}
    return dict(zip(counts, map(json.loads, done.stdout.splitlines()), strict=True))


def curve(task, family, sizes, args):
    """Measure a family's sizes, smallest first, until one takes too long."""
    wanted = [n for n in sizes if n <= args.largest]
    groups = [[n for n in wanted if n <= FITTED], *([n] for n in wanted if n > FITTED)]
    found = {}
    for counts in groups:
        answers = run(task, family, counts, args.patience)
        found |= answers
        for n, a in answers.items():
            time, peak = duration(statistics.median(a["seconds"])), digits(a["peak"] / 1e6)
            print(f"      {task}  {family}  {n}  {time}  {peak} MB", flush=True)
        if not answers:
            print(f"      {task}  {family}  {counts}  over {args.patience:g} s", flush=True)
            break
    return found


def exponent(found):
    """Fit the power of the growth; a dash with fewer than three sizes to fit it to."""
    kept = [(n, statistics.median(a["seconds"])) for n, a in found.items() if n >= FITTED]
    if len(kept) < 3:
        return "-"
    return f"{np.polyfit(*np.log(np.array(kept).T), 1)[0]:.2f}"


def row(name, found, shown):
    """Return a family's row: times at the sizes shown, exponent, memory and agreement."""
    cells = [duration(statistics.median(found[n]["seconds"])) if n in found else "-" for n in shown]
    largest = max(found)
    apart = [a["difference"] for a in found.values() if a.get("difference") is not None]
    return (
        name, *cells, exponent(found),
        f"{digits(found[largest]['peak'] / 1e6)} MB at {power_of_ten(largest)}",
        difference(max(apart)) if apart else "-",
    )  # fmt: skip


def measure(args):
    """Measure all families; return the page's section."""
    sizes = [n for n in SIZES if n in (4, 100, 300, 1000)] if args.quick else SIZES
    curves = {family: curve("quality", family, sizes, args) for family in FAMILIES}
    placed = curve("place", "random", PLACED[:3] if args.quick else PLACED, args)
    base = statistics.median(a["base"] for found in curves.values() for a in found.values())
    largest = max(max(found) for found in curves.values())
    shown = [n for n in SHOWN if n <= largest]
    heads = ("robots", *map(power_of_ten, shown), "exponent", "peak memory", "largest difference")
    rows = [row(family, found, shown) for family, found in curves.items()]
    rows.append(row("one placement, random", placed, shown))
    kinds = "\n".join(f"- {name}: {words}" for name, words in FAMILIES.items())
    said = TEXT.format(
        largest=power_of_ten(largest), base=f"{base / 1e6:.0f}", fitted=power_of_ten(FITTED)
    )
    drawn = {
        name: [(n, statistics.median(a["seconds"])) for n, a in found.items()]
        for name, found in {**curves, "one placement, random": placed}.items()
    }
    early = [power_of_ten(n) for n, a in placed.items() if not a["proven"]]
    proven = "All placements are proven to the gap of 1e-6."
    if early:
        proven = f"The placements among {', '.join(early)} robots stopped before the gap of 1e-6."
    picture = "Time over the number of robots", lines(drawn, "time", compared=True)
    return Part(
        f"{said}\n{kinds}\n\n{table(heads, rows)}\n{proven}\n", {"benchmark-growth.png": picture}
    )
