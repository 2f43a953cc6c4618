"""Tell five tugs how hard to push, for one wrench and for a whole manoeuvre.

Run it from anywhere; the pictures go into the folder it is run in.
"""

from math import radians

import numpy as np
from matplotlib.figure import Figure

import swarmgrasp as sg
from swarmgrasp.plot import forces_plan, save

TONNE_FORCE = 9806.65  # N

# A barge of 76 x 22 m with a raked bow; x forward, y to port.
barge = sg.Outline(
    [(-38, -11), (29, -11), (38, -6), (38, 6), (29, 11), (-38, 11)],
    edge_names=["starboard", "bow rake starboard", "bow", "bow rake port", "port", "stern"],
)


def push(name, edge, along, tonnes):
    """Return a tug that pushes square onto an edge."""
    contact = barge.on_edge(edge, along)
    return sg.Robot(contact.point, contact.inward, tonnes * TONNE_FORCE, name)


tugs = [
    push("Ajax", "starboard", 14.0, 60),
    push("Boreas", "port", 12.0, 45),
    push("Castor", "stern", 9.0, 80),
    sg.Robot(barge.on_edge("bow rake port", 5.0).point, radians(100), 50 * TONNE_FORCE, "Dione"),
    sg.Robot((-38.0, -9.0), radians(-160), 30 * TONNE_FORCE, "Electra"),
]
swarm = sg.Swarm(barge, tugs)


def tell(found):
    """Print who pushes how hard."""
    for tug, force, share in zip(tugs, found.forces, found.shares, strict=True):
        print(f"  {tug.name:8} {force / 1e3:6.1f} kN, {share:4.0%} of its limit")


# Ahead and to port, against a wind that pushes to starboard and turns the bow away.
wanted, wind = (300e3, 120e3, 0.0), (0.0, -80e3, -1.5e6)
found = sg.forces(swarm, wanted, load=wind)
print(f"Made with shares up to {found.largest_share:.0%}; smaller ones do not make it:")
tell(found)
print("  The proof holds." if found.verify() else found.verify().faults)
save(forces_plan(found), "barge-forces.png")

# Three times as much is out of reach: the tugs come as near as they can.
far = sg.forces(swarm, 3.0 * np.array(wanted), load=wind)
missing = sg.wrench_words(far.missing * swarm.scale)
print(f"Three times that is short by {far.shortfall / 1e3:.0f} kN of {missing};")
print(f"  the limits would have to be {far.needed:.2f} times as large.")

# A turn on the spot to either side, then ahead: a thousand wrenches in one call.
t = np.linspace(0.0, 1.0, 1000)
ahead, yaw = 400e3 * np.clip(2 * t - 1, 0, 1), 15e6 * np.sin(4 * np.pi * t) * (t < 0.5)
along = sg.forces_along(swarm, np.column_stack([ahead, 0 * t, yaw]), load=wind)
missed = along.is_degraded
print(
    f"Of the manoeuvre {missed.mean():.0%} is out of reach, by {max(along.shortfalls) / 1e3:.0f} kN"
)
print(f"  at most; the rest takes shares up to {along.largest_shares[~missed].max():.0%}.")

figure = Figure(figsize=(5.2, 2.6), layout="constrained")
axes = figure.add_subplot()
for tug, shares in zip(tugs, along.shares.T, strict=True):
    axes.plot(100 * t, 100 * shares, label=tug.name)
axes.set(xlabel="of the manoeuvre [%]", ylabel="share [% of the limit]", ylim=(0, None))
figure.legend(ncols=5, loc="outside upper center", frameon=False, fontsize=8)
save(figure, "barge-shares.png")
