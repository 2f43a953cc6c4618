"""The sixteenth robot: our placement beside the paper's algorithm and general optimisers."""

import numpy as np
from page import Part, digits, duration, paragraph, table
from pictures import shortfalls
from problems import MOST, closed, oval, rectangle
from rivals import algorithm_1, all_pairs, evolution, grid, nelder_mead, plain_evolution
from timing import Clocked, calls_in

import swarmgrasp as sg

RIVALS = (algorithm_1, plain_evolution, evolution, nelder_mead, grid)
OBJECTS = {"rectangle": rectangle, "12-gon": oval}
GAP = 1e-6
HEADS = (
    "object", "newcomer", "method", "its time", "ours", "times ours",
    "quality, median", "lowest", "highest",
)  # fmt: skip
TEXT = """## The sixteenth robot

15 random robots in force closure hold a random object, a rectangle or a 12-gon in an ellipse; the
newcomer pushes, pulls or is free. Ours is the whole `place(swarm, newcomer)` with its proof, gap
1e-6, repeated for 5 ms at each turn. Quality is that of the swarm with the robot a method
chose, recomputed for every method from all pairs, relative to ours.

- Algorithm 1 is the paper's, corrected: bisection to 1e-4; SLSQP with analytic derivatives
  maximises the slack over the cylinder of wrenches, from the weakest facet's normal first and then
  from the last success; then the nearest wrench that a robot can make.
- Differential evolution has SciPy's settings, and the paper's formula in NumPy as its objective.
- With our compiled exact quality as the objective instead, a generation per call, and Nelder-Mead
  from 10 random starts with the same.
- The grid lays 180 contacts by 180 directions.
"""


class Rows:
    """Times and qualities of one object and newcomer, over its inputs.

    Parameters
    ----------
    draw : callable
        Draws an outline from a generator.
    kind : {"push", "pull", "free"}
    inputs, seed : int
    """

    def __init__(self, draw, kind, inputs, seed):
        self.ours = {rival: Clocked() for rival in RIVALS}
        self.theirs = {rival: Clocked() for rival in RIVALS}
        self.shares = {rival: [] for rival in RIVALS}
        self.promises, self.errors = [], []
        rng = np.random.default_rng(seed)
        for _ in range(inputs):
            self.add(sg.Problem(closed(draw(rng), MOST, rng), sg.Newcomer(1.0, kind)))

    def add(self, problem):
        """Clock every method on one problem, ours before each."""
        swarm = problem.swarm

        def attained(wrench):
            """Recompute the quality with a unit wrench."""
            one = wrench * swarm.scale * problem.newcomer.limit
            return all_pairs.quality(np.vstack([swarm.scaled_generators, one]))

        for rival in RIVALS:

            def ours():
                """Place, and prove it."""
                return sg.place(swarm, problem.newcomer, gap=GAP)

            answer = self.ours[rival].run(ours, calls_in(ours))
            wrench, claimed = self.theirs[rival].run(lambda r=rival: r.place(problem))
            mine = all_pairs.quality(answer.swarm_after.scaled_generators)
            quality = attained(wrench)
            self.shares[rival].append(quality / mine)
            self.errors.append(abs(answer.quality - mine) / mine)
            if rival is algorithm_1:
                self.promises.append(claimed / mine)
            else:
                self.errors.append(abs(claimed - quality) / mine)

    def cells(self, rival):
        """Return the numbers of a rival's row, as text."""
        theirs, ours, shares = (
            self.theirs[rival].median,
            self.ours[rival].median,
            self.shares[rival],
        )
        return (
            duration(theirs), duration(ours), digits(theirs / ours),
            f"{np.median(shares):.6f}", f"{min(shares):.4f}", f"{max(shares):.7f}",
        )  # fmt: skip


def measure(args):
    """Measure all rows; return the page's section."""
    rows, groups = [], []
    inputs = 3 if args.quick else 40
    Rows(rectangle, "free", 1, 0)  # loads what is loaded at the first call
    for name, draw in OBJECTS.items():
        for kind in ("push", "pull", "free"):
            groups.append(Rows(draw, kind, inputs, 1 + len(groups)))
            for rival in RIVALS:
                rows.append((name, kind, rival.NAME, *groups[-1].cells(rival)))
                print("   ", *rows[-1], sep="  ", flush=True)
    shares = {r.NAME: np.concatenate([g.shares[r] for g in groups]) for r in RIVALS}
    return Part(
        TEXT + "\n" + summary(groups, inputs) + "\n" + table(HEADS, rows),
        {"benchmark-placement.png": ("How far other methods fall short", shortfalls(shares))},
    )


def summary(groups, inputs):
    """Say in words what the rows show together."""
    above = max(max(shares) for group in groups for shares in group.shares.values()) - 1.0
    promises = np.concatenate([group.promises for group in groups])
    errors = max(max(group.errors) for group in groups)
    return paragraph(
        f"{inputs} inputs per object and newcomer. No method's robot is better than ours by more "
        f"than {max(above, 0.0):.1e}, the gap being {GAP:.0e}. Algorithm 1 promises up to "
        f"{promises.max():.3f} of the best that any robot can attain, and more than 1.001 of it on "
        f"{np.mean(promises > 1.001):.0%} of the inputs. The qualities reported, by the other "
        f"methods and by ours, agree with those recomputed to {errors:.0e}."
    )
