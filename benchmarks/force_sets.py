"""Robots that steer or go astern: qualities, losses and placements."""

import itertools
import math

import numpy as np
from page import Part, difference, digits, duration, power_of_ten, table
from problems import rectangle
from rivals import hyperplane_shifting
from timing import Clocked, clock, in_turn

import swarmgrasp as sg

KINDS = {
    "two ways": {},
    "60 degrees": {"steers": math.pi / 6},
    "azimuths": {"steers": math.pi},
    "mixed": None,
}
"""What robots can exert; mixed ones a third each of rays, sectors and azimuths."""
COUNTS, LARGE = (15, 50), 5000
SIDES = 4
"""Two-way thrusters whose sum stands for an azimuth: a polygon of twice as many sides."""
GAP = 1.1e-6
"""Of a placement that is certified, with its rounding."""
MOST_LISTED = 30
"""Robots up to which pycapacity is asked."""
TEXT = """## Robots that steer or go astern

Random robots on random rectangles, in force closure; `quality(swarm)` to a proven 1e-9, or to what
its work allows. Robots that go two ways are pairs of opposite rays to pycapacity, and exact; an
azimuth is a sum of {sides} two-way thrusters, a polygon of {corners} sides inside its circle, and
the difference is what that costs.

{quality}
After the worst loss of some robots, beside our own quality of every set of robots left:

{losses}
A newcomer that keeps all it can exert, beside robots of the same kind; the last column says how
many are certified to 1e-6:

{placement}"""


def crew(kind, count, rng):
    """Draw robots of a kind on a rectangle, in force closure."""
    while True:
        outline = rectangle(rng)
        robots = []
        for i in range(count):
            at = outline.at_arc_length(float(rng.random()) * outline.perimeter)
            look = KINDS[kind]
            if look is None:
                look = ({}, KINDS["60 degrees"], KINDS["azimuths"])[i % 3]
            turn, limit = at.inward + rng.uniform(-1.0, 1.0), rng.uniform(0.5, 1.5)
            astern = limit if kind == "two ways" else 0.0
            robots.append(sg.Robot(at.point, turn, limit, reverse_limit=astern, **look))
        swarm = sg.Swarm(outline, robots, 1.0)
        if sg.quality(swarm).is_force_closure:
            return swarm


def pairs(swarm):
    """Return generators (m, 3) [N] whose sum is the swarm's wrench set, or a little less."""
    rows = []
    for robot in swarm:
        count = SIDES if robot.steers else 1
        # a regular polygon is a sum of segments; in a circle of the limit
        size = robot.limit * (math.sin(math.pi / (2 * count)) if robot.steers else 1.0)
        for k in range(count):
            turn = robot.direction + k * math.pi / count
            x, y = np.array(robot.contact) - swarm.outline.origin
            way = np.array([math.cos(turn), math.sin(turn)])
            wrench = size * np.array([*way, x * way[1] - y * way[0]]) * swarm.scale
            rows += [wrench, -wrench]
    return np.array(rows)


def quality_rows(args, rng):
    """Measure the qualities."""
    rows = []
    counts = COUNTS if args.quick else (*COUNTS, LARGE)
    for kind, count in itertools.product(KINDS, counts):
        swarms = [
            crew(kind, count, rng) for _ in range(10 if args.quick or count == LARGE else 200)
        ]
        times = [clock(lambda s=swarm: sg.quality(s)) for swarm in swarms]
        cells = ["", "", ""]
        if kind in ("two ways", "azimuths") and count <= MOST_LISTED:
            swarm, generators = swarms[0], pairs(swarms[0])
            ours, theirs = in_turn(
                lambda s=swarm: sg.quality(s).value,
                lambda g=generators: hyperplane_shifting.quality(g),
                3,
            )
            cells = [
                duration(theirs.median), digits(theirs.median / ours.median),
                difference(abs(theirs.value / ours.value - 1.0)),
            ]  # fmt: skip
        rows.append(
            (kind, power_of_ten(count), duration(np.median(times)), duration(max(times)), *cells)
        )
        print("   ", *rows[-1], sep="  ", flush=True)
    heads = ("robots", "number", "median", "slowest", "pycapacity", "times ours", "difference")
    return table(heads, rows)


def loss_rows(args, rng):
    """Measure the qualities after losses."""
    rows = []
    for count, losing in itertools.product(COUNTS, (1, 2, 3)):
        swarms = [crew("mixed", count, rng) for _ in range(5 if args.quick else 50)]
        times = [clock(lambda s=s, k=losing: sg.quality(s, losing=k)) for s in swarms]
        cells = ["", "", ""]
        if math.comb(count, losing) < 2000:
            swarm, sets = swarms[0], list(itertools.combinations(range(count), losing))
            ours, theirs = in_turn(
                lambda s=swarm, k=losing: sg.quality(s, losing=k).value,
                lambda s=swarm, c=sets: min(sg.quality(s.without_rows(rows)).value for rows in c),
                3,
            )
            apart = abs(theirs.value - ours.value) / max(ours.value, 1e-9)
            cells = [
                duration(theirs.median), digits(theirs.median / ours.median), difference(apart)
            ]  # fmt: skip
        rows.append((power_of_ten(count), str(losing), duration(np.median(times)), *cells))
        print("   ", *rows[-1], sep="  ", flush=True)
    heads = ("mixed robots", "lost", "median", "every set", "times ours", "difference")
    return table(heads, rows)


def placement_rows(args, rng):
    """Measure the placements."""
    newcomers = {
        "60 degrees": sg.Newcomer(1.0, "push", half_angle=math.pi / 6, steers=True),
        "azimuths": sg.Newcomer(1.0, "free", steers=True),
        "two ways": sg.Newcomer(1.0, "free", reverse_limit=1.0),
    }
    rows = []
    for kind, newcomer in newcomers.items():
        swarms = [crew(kind, COUNTS[0], rng) for _ in range(5 if args.quick else 50)]
        found = Clocked()
        answers = [found.run(lambda s=s, n=newcomer: sg.place(s, n)) for s in swarms]
        proven = sum(answer.gap <= GAP for answer in answers) / len(answers)
        rows.append(
            (kind, power_of_ten(COUNTS[0]), duration(found.median), duration(max(found.seconds)),
             f"{proven:.0%}")
        )  # fmt: skip
        print("   ", *rows[-1], sep="  ", flush=True)
    return table(("newcomer", "robots", "median", "slowest", "certified"), rows)


def measure(args):
    """Measure all three; return the page's section."""
    rng = np.random.default_rng(11)
    text = TEXT.format(
        sides=SIDES,
        corners=2 * SIDES,
        quality=quality_rows(args, rng),
        losses=loss_rows(args, rng),
        placement=placement_rows(args, rng),
    )
    return Part(text)
