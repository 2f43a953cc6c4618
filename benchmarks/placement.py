"""Time placements over random and degenerate inputs, beside one exact quality of the same swarm.

Prints a table and writes it to docs/benchmarks.md. Each row holds inputs of up to 16 robots: the
kernel's time for one placement at a gap of 1e-6, the time of the same swarm's exact quality, and
the ratio of the two, measured in turn in one run.
"""

import platform
import statistics
import sys
import time
from datetime import date
from importlib.metadata import version
from pathlib import Path

import numpy as np

from swarmgrasp import Newcomer, Outline, Problem, Robot, Swarm, place_sequence
from swarmgrasp.placement.optimum import Search
from swarmgrasp.quality.facets import facets_of

INPUTS = int(sys.argv[1]) if len(sys.argv) > 1 else 1000
PAGE = Path(__file__).parent.parent / "docs" / "benchmarks.md"
FAMILIES = (
    "rectangle, 15 + 1", "free", "along normals", "integer grid", "one giant", "limits 1e-6 to 1e6",
    "balanced", "duplicated", "ring of 120 edges",
)  # fmt: skip


def problem_of(family, rng):
    """Draw one problem of a family."""
    a, b = rng.uniform(0.4, 2.0, 2)
    if family == "integer grid":
        a, b = rng.integers(1, 4, 2)
    corners = [(-a, -b), (a, -b), (a, b), (-a, b)]
    if family == "ring of 120 edges":
        turn = np.arange(120) * np.pi / 60
        corners = np.column_stack([2 * np.cos(turn), np.sin(turn)])
    outline = Outline(corners)
    count = 15 if family == "rectangle, 15 + 1" else int(rng.integers(3, 16))
    if family in ("balanced", "duplicated"):
        count = count // 2 + 1
    shares = rng.integers(0, 5, count) / 4 if family == "integer grid" else rng.random(count)
    contacts = [outline.at_arc_length(float(s) * outline.perimeter) for s in shares]
    normal = family in ("rectangle, 15 + 1", "along normals", "integer grid")
    directions = [c.inward + np.pi if normal else rng.uniform(-np.pi, np.pi) for c in contacts]
    limits = np.ones(count)
    if family == "one giant":
        limits[0] = 10.0 ** rng.integers(1, 9)
    if family == "limits 1e-6 to 1e6":
        limits = 10.0 ** rng.uniform(-6, 6, count)
    crew = [Robot(c.point, d, u) for c, d, u in zip(contacts, directions, limits, strict=True)]
    if family == "balanced":
        crew += [Robot(r.contact, r.direction + np.pi, r.limit) for r in crew]
    if family == "duplicated":
        crew += crew
    kind = rng.choice(["push", "pull", "free"])
    half_angle = None if kind == "free" else rng.choice([0.0, np.pi / 6, np.pi / 3, np.pi / 2])
    return Problem(Swarm(outline, crew[:15], 1.0), Newcomer(1.0, str(kind), half_angle))


def timed(work):
    """Return the seconds that a call takes."""
    start = time.perf_counter()
    work()
    return time.perf_counter() - start


def measure(family):
    """Return (search, quality, whole call) seconds for every input of a family."""
    rng = np.random.default_rng(1)
    rows = []
    for _ in range(INPUTS):
        problem = problem_of(family, rng)
        place = timed(Search(problem).solve)
        if place > 1e-3:  # a hiccup of the machine, or a hard input? once more
            place = min(place, timed(Search(problem).solve))
        generators = problem.swarm.scaled_generators
        one_quality = timed(lambda g=generators: facets_of(g, margin=0.0))
        rows.append((place, one_quality, timed(lambda p=problem: place_sequence(p, 1))))
    return rows


def main():
    """Measure, print and write."""
    place_sequence(problem_of("free", np.random.default_rng(0)), 3)  # compiles
    lines = [
        "| inputs | median [us] | 99th percentile [us] | slowest [us] | times one quality "
        "| whole call [us] |",
        "| --- | --- | --- | --- | --- | --- |",
    ]
    for family in FAMILIES:
        rows = measure(family)
        times = np.array([place for place, _, _ in rows]) * 1e6
        ratio = statistics.median(place / quality for place, quality, _ in rows)
        whole = statistics.median(whole for _, _, whole in rows) * 1e6
        lines.append(
            f"| {family} | {np.median(times):.0f} | {np.quantile(times, 0.99):.0f} "
            f"| {times.max():.0f} | {ratio:.1f} | {whole:.0f} |"
        )
        print(lines[-1], flush=True)
    machine = f"{platform.machine()}, Python {platform.python_version()}"
    packages = ", ".join(f"{name} {version(name)}" for name in ("swarmgrasp", "numba", "numpy"))
    PAGE.write_text(
        "# Benchmarks\n\nWritten by `make bench`.\n\n## One placement\n\n"
        f"{INPUTS} inputs per row of up to 15 robots and a newcomer, gap 1e-6: what the search "
        "takes once compiled\nand set up, the median of its ratio to one exact quality of the "
        "same swarm, and the median of the whole\n`place`, with its set-up, tie-break and exact "
        "re-evaluation; measured in turn.\n\n" + "\n".join(lines)
        + f"\n\n{date.today()}; {machine}; {packages}. The machine is shared: the ratios say more "
        "than the times.\n"
    )  # fmt: skip


if __name__ == "__main__":
    main()
