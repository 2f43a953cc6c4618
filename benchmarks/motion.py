"""The motion of an object pushed by robots: steps a second, beside NumPy."""

import sys
import time
from pathlib import Path

import numpy as np
from page import Part, difference, digits, duration, power_of_ten, table
from timing import in_turn

import swarmgrasp as sg
from swarmgrasp.simulation import Hull, Plant

sys.path.append(str(Path(__file__).parent.parent / "tests"))
import motion_by_hand

KINDS = {"along lines": 0.0, "that steer": 0.5}
BATCHES = (1, 1000)
ROBOTS, STEP, STEPS = 5, 0.1, 20
TEXT = """## Motion

A barge with five robots in wind and current, by `Plant.advance`: {steps} steps of 0.1 s a call, all
robots on their way to new orders; steps of the object are counted, by the processor's time. Beside
it the same in NumPy, over all runs at once, with which the kernel is tested: by the clock, in turn.
The difference is that of positions [m].

{rows}"""


def barge(steers):
    """Return a barge afloat with its robots."""
    outline = sg.Outline([(-40, -12), (35, -12), (40, 0), (35, 12), (-40, 12)])
    wind = sg.Wind(180.0, 520.0, sg.WindCoefficients(0.9, 0.6, 0.75, 0.55))
    sea = sg.Environment(wind, sg.Current(60.0, 210.0))
    robots = []
    for k in range(ROBOTS):
        at = outline.at_arc_length((k + 0.3) * outline.perimeter / ROBOTS)
        robots.append(sg.Robot(at.point, at.inward, 300e3, steers=steers))
    return Plant(sg.Swarm(outline, robots), Hull.afloat(outline, sea), sea)


def measure(args):
    """Measure steps of motion; return the page's section."""
    rng, rows = np.random.default_rng(13), []
    for kind, steers in KINDS.items():
        plant = barge(steers)
        for runs in BATCHES:
            states = plant.rest(runs)
            states[:, 3:6] = rng.normal(size=(runs, 3)) * (0.5, 0.5, 0.005)
            orders = plant.orders(rng.uniform(-2e5, 2e5, (runs, ROBOTS, 2)))
            streams = rng.normal(size=(runs, 4)) * (10.0, 10.0, 0.5, 0.5)
            given = (states, orders, streams)
            ours, theirs = in_turn(
                lambda p=plant, g=given: p.advance(*g, None, STEP, STEPS),
                lambda p=plant, g=given: motion_by_hand.advance(p, *g, 0.0, STEP, STEPS),
                5 if args.quick else 20,
            )
            mine, rival = (clocked.median / (runs * STEPS) for clocked in (ours, theirs))
            start = time.process_time()
            for _ in range(1 if args.quick else 5):
                plant.advance(*given, None, STEP, 50 * STEPS)
            rate = (1 if args.quick else 5) * 50 * STEPS * runs / (time.process_time() - start)
            apart = np.abs(ours.value - theirs.value)[:, :2].max()
            rows.append(
                (kind, power_of_ten(runs), f"{rate / 1e6:.2f} M", duration(mine),
                 duration(rival), digits(rival / mine), difference(apart))
            )  # fmt: skip
            print("   ", *rows[-1], sep="  ", flush=True)
    heads = ("robots", "runs", "steps a second", "a step", "NumPy", "times ours", "difference")
    return Part(TEXT.format(steps=STEPS, rows=table(heads, rows)))
