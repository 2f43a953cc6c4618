"""Hold a barge in a gale with a controller of one's own, beside the one that is there.

A controller sees noisy poses and the wind, and decides on the wrench that the object is to receive;
the robots share it out. This one takes an error back in proportion to it, to how fast it grows,
and to its sum. After a loss that sum grows while the robots can do nothing about it, and has to
be undone later: it winds up. The controller that is there learns the load from what the robots
really exert, and does not.

Run it from anywhere; the picture goes into the folder it is run in.
"""

import math

import matplotlib as mpl
import numpy as np

import swarmgrasp as sg
from swarmgrasp.environment import KNOT
from swarmgrasp.scenario import load_example
from swarmgrasp.simulation import Hull, Lose, Send, Simulation, Weather, simulate, verdict_of

mpl.use("Agg")
import matplotlib.pyplot as plt


class Summing:
    """Proportional, derivative and integral action on the error in the object's frame."""

    def begin(self, known, tuning, poses, rests):
        """Start with the sum that holds what acts."""
        self.known, self.tuning = known, tuning
        self.last, self.speeds = poses, np.zeros_like(poses)
        self.sums = -rests

    def change(self, known):
        """Take the new masses."""
        self.known = known

    def wrenches(self, look):
        """Return the wanted wrench of each run."""
        period, w = self.tuning.period, self.tuning.frequency
        pole = 4.0 * w * period  # looks are noisy: smooth the speed
        self.speeds += pole * ((look.poses - self.last) / period - self.speeds)
        self.last = look.poses
        off = self.in_object(look.poses, look.reference.pose - look.poses)
        speed = self.in_object(look.poses, look.reference.velocity - self.speeds)
        self.sums = self.sums + period * (w**3 / 6.0) * off @ self.known.matrix.T
        pull = (w**2 * off + 2.0 * w * speed) @ self.known.matrix.T
        return pull + self.sums - self.known.wind_loads(look.poses[:, 2], look.air)

    @staticmethod
    def in_object(poses, rows):
        """Turn vectors of the earth's frame into the object's."""
        cos, sin = np.cos(poses[:, 2]), np.sin(poses[:, 2])
        x, y, turn = rows.T
        return np.column_stack([cos * x + sin * y, cos * y - sin * x, turn])


scenario = load_example("deck-barge")
problem = scenario.problem()
problem = problem.with_swarm(problem.swarm.with_robot(sg.place(problem).robot))
sea = scenario.environment
wind = sg.Wind(
    sea.wind.frontal_area, sea.wind.lateral_area, sea.wind.coefficients, sea.wind.lateral_centroid,
    speed=60.0 * KNOT, bearing=math.radians(60.0),
)  # fmt: skip
gale = Simulation(
    problem,
    sg.Environment(wind, sea.current),
    Hull.afloat(problem.swarm.outline, sea, draught=2.44),
    weather=Weather("npd"),
    events=(Lose(60.0, "Boreas", noticed=5.0), Send(65.0)),
    duration=480.0,
)

figure, axes = plt.subplots(figsize=(8, 3.5), layout="constrained")
for name, controller in (("with a sum of errors", Summing()), ("that is there", None)):
    run = simulate(gale, controller=controller)
    joined = run.happenings[-1].time
    after = verdict_of(run).circles[-1]
    off, turn = after.distance[0], math.degrees(after.turn[0])
    print(
        f"The controller {name}: {off:.1f} m and {turn:.0f} degrees off at most after the newcomer "
        f"has joined, {run.distances[0, -1]:.1f} m at the end."
    )
    axes.plot(run.times, np.degrees(run.turns[0]), label=f"controller {name}")
axes.axvline(60.0, color="0.6", linestyle="--")
axes.axvline(joined, color="0.6", linestyle=":")
axes.set(xlabel="time [s]", ylabel="heading off by [deg]")
axes.legend()
figure.savefig("own-controller.png", dpi=120)
