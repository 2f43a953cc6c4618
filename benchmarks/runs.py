"""Simulated runs in closed loop: periods of control a second, many runs in step."""

import time
from dataclasses import replace

from page import Part, digits, power_of_ten, table

from swarmgrasp.environment import KNOT
from swarmgrasp.scenario import load_example
from swarmgrasp.simulation import Hull, Simulation, Weather, simulate

BATCHES = (1, 10, 100, 1000)
DURATION, QUICK = 600.0, 20.0
TEXT = """## Simulated runs

The deck barge with its five tugs in gusts of 25 knots and a current, sensors with noise: each tenth
of a second a look, an estimate, push forces for the wanted wrench with their check, and motion. In
one batch all runs go in step; by the processor's time, on one core.

{rows}"""


def gale(duration):
    """Return the barge in a gale."""
    example = load_example("deck-barge")
    problem, sea = example.problem(), example.environment
    sea = replace(sea, wind=replace(sea.wind, speed=25.0 * KNOT, bearing=1.0))
    hull = Hull.afloat(problem.swarm.outline, sea, draught=2.44)
    return Simulation(problem, sea, hull, weather=Weather("npd"), duration=duration)


def measure(args):
    """Measure runs; return the page's section."""
    rows, duration = [], QUICK if args.quick else DURATION
    for runs in BATCHES:
        asked = gale(duration)
        start = time.process_time()
        simulate(asked, range(runs))
        spent = time.process_time() - start
        steps = runs * duration / asked.tuning.period / spent
        rows.append(
            (power_of_ten(runs), f"{digits(spent)} s", f"{steps / 1e3:.0f} k",
             digits(runs * duration / spent))
        )  # fmt: skip
        print("   ", *rows[-1], sep="  ", flush=True)
    heads = ("runs", f"for {duration:.0f} s", "periods a second", "times real time")
    return Part(TEXT.format(rows=table(heads, rows)))
