"""Hold a barge ten times a second, with poses as they are measured.

Tugs slide along the fenders and swing while they push. A loop that goes on pushing as if they stood
where they were sent makes another wrench than it wants; one that asks anew for what is measured
makes what it wants, as far as the tugs can.

Run it from anywhere; the picture goes into the folder it is run in.
"""

from dataclasses import replace

import matplotlib as mpl
import numpy as np

import swarmgrasp as sg
from swarmgrasp.scenario import load_example

mpl.use("Agg")
import matplotlib.pyplot as plt

PERIOD, STEPS = 0.1, 300
NOISE = 0.05, np.radians(0.5)  # of a measured contact [m] and direction [rad]
WANTED = (0.0, 150e3, 1.5e6)  # N, N, N m, about the outline's origin

barge = load_example("deck-barge")
sent = sg.place(barge.problem()).swarm_after
outline, rng = sent.outline, np.random.default_rng(7)
phases = rng.uniform(0.0, 2.0 * np.pi, len(sent))


def true_robots(time):
    """Return the tugs where they are: up to 2 m along the hull and 15 degrees off."""
    for robot, phase in zip(sent, phases, strict=True):
        swing = np.sin(0.4 * time + phase)
        arc = outline.at_point(robot.contact).arc_length + 2.0 * swing
        contact = outline.at_arc_length(arc % outline.perimeter).point
        yield replace(robot, contact=contact, direction=robot.direction + 0.26 * swing)


def measured(robots):
    """Return the swarm as it is measured: a little off the hull, so moved to the nearest of it."""
    contacts = np.array([robot.contact for robot in robots])
    directions = np.array([robot.direction for robot in robots])
    return sg.Swarm.from_arrays(
        outline,
        contacts + rng.normal(0.0, NOISE[0], contacts.shape),
        directions + rng.normal(0.0, NOISE[1], directions.shape),
        sent.limits,
        characteristic_length=sent.characteristic_length,
        snap=0.5,
    )


def error(robots, shares):
    """Return by how much the tugs miss the wanted wrench, in the metric [N]."""
    made = shares @ sg.Swarm(outline, robots).generators
    return float(np.linalg.norm((made - WANTED) * sent.scale))


blind = sg.forces(sent, WANTED).shares  # worked out once
errors, qualities, short = [], [], 0
for step in range(STEPS):
    there = list(true_robots(step * PERIOD))
    swarm = measured(there)  # a new one for each look: it takes no time
    found = sg.forces(swarm, WANTED)
    short += found.is_degraded
    qualities.append(sg.quality(swarm).value)
    errors.append((error(there, blind), error(there, found.shares)))

worst = np.max(errors, axis=0) / 1e3
low, high = min(qualities) / 1e3, max(qualities) / 1e3
print(f"{STEPS} looks at {len(sent)} tugs: quality {low:.0f} to {high:.0f} kN")
print(f"{short} times the wanted wrench was out of reach")
print(f"shares worked out once:      off by {worst[0]:.0f} kN at worst")
print(f"shares for what is measured: off by {worst[1]:.0f} kN at worst")

figure, ax = plt.subplots(figsize=(6.0, 2.8), layout="constrained")
times = PERIOD * np.arange(STEPS)
for label, row in zip(
    ("worked out once", "for what is measured"), np.transpose(errors), strict=True
):
    ax.plot(times, row / 1e3, label=label)
ax.set(xlabel="time [s]", ylabel="wrench off by [kN]", ylim=(0.0, None))
ax.legend(frameon=False, loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=2)
figure.savefig("measured-poses.png", dpi=150)
