"""Push a pallet over a floor with ground robots, moved by MuJoCo, where friction holds it.

Needs MuJoCo: pip install 'swarmgrasp[mujoco]'. Run it from anywhere; the picture goes into the
folder it is run in.
"""

from dataclasses import replace
from math import atan2, cos, degrees, hypot, pi, radians, sin

import numpy as np
from matplotlib.figure import Figure

import swarmgrasp as sg
from swarmgrasp.plot import save
from swarmgrasp.simulation import Hull
from swarmgrasp.simulation.mujoco import Floor, World

# A Euro pallet with 300 kg on nine feet; robots lean on it with rubber pads of friction 0.6.
pallet = sg.Outline([(-0.6, -0.4), (0.6, -0.4), (0.6, 0.4), (-0.6, 0.4)])
loaded = Hull.ashore(pallet, mass=300.0)
floor = Floor(friction=0.3, feet=[(x, y) for x in (-0.5, 0.0, 0.5) for y in (-0.3, 0.0, 0.3)])
grip = floor.grip(loaded)

pads = [
    sg.Robot((-0.6, 0.1), 0.0, 700.0, "stern", friction=0.6),
    sg.Robot((0.6, -0.1), pi, 700.0, "bow", friction=0.6),
    sg.Robot((-0.2, -0.4), pi / 2, 700.0, "starboard", friction=0.6),
    sg.Robot((-0.4, 0.4), -pi / 2, 700.0, "port", friction=0.6),
]
swarm = sg.Swarm(pallet, pads)
newcomer = sg.Newcomer(700.0, attachment="push", friction=0.6, name="fifth")
before = sg.quality(swarm).value
swarm = swarm.with_robot(sg.place(sg.Problem(swarm, newcomer)).robot)
print(f"The floor holds the pallet with up to {grip:.0f} N.")
print(f"Four robots exert {before:.0f} N in every direction, five {sg.quality(swarm).value:.0f} N.")


def pushed(load, part, way, corrected=False, seconds=5.0):
    """Return the poses (k, 3) of the pallet, ten a second, pushed with a part of the grip."""
    world = World(swarm, load, floor, step=0.01)
    push = part * grip * np.array([cos(radians(way)), sin(radians(way))])
    orders = sg.forces(swarm, (*push, 0.0)).vectors
    poses = [world.pose]
    for _ in range(round(10 * seconds)):
        heading = poses[-1][2]
        if corrected:  # keep the heading, and the way: what robots exert turns with the pallet
            c, s = cos(heading), sin(heading)
            turn = -2000.0 * heading - 5000.0 * (heading - poses[-2:][0][2])
            ahead, across = push @ np.array([[c, -s], [s, c]])
            orders = sg.forces(swarm, (ahead, across, turn)).vectors
        poses.append(world.advance(orders, steps=10))
    return np.array(poses)


for part in (0.5, 0.98, 1.02):
    ways = [1e3 * hypot(*pushed(loaded, part, way)[-1, :2]) for way in (0, 29, 90)]
    told = ", ".join(f"{moved:.3g}" for moved in ways)
    print(f"Pushed for 5 s with {part:.0%} of that, to 0, 29 and 90 degrees: {told} mm.")

# The load stands askew, and who pushes the middle turns the pallet.
askew = replace(loaded, centre=(-0.15, 0.1))
free, held = (pushed(askew, 1.2, 29, corrected, 2.4) for corrected in (False, True))
print("Loaded askew and pushed with 120 % to 29 degrees:")
for what, (x, y, heading) in (("by the same forces", free[-1]), ("corrected", held[-1])):
    way, turn = degrees(atan2(y, x)), degrees(heading)
    print(f"  {what}, it is {hypot(x, y):.2f} m off to {way:.0f} degrees, turned by {turn:.0f}.")

figure = Figure(figsize=(5.0, 3.8), layout="constrained")
axes = figure.add_subplot(aspect="equal", xlabel="x [m]", ylabel="y [m]")
for poses, colour, label in ((free, "C1", "the same forces"), (held, "C0", "corrected")):
    axes.plot(poses[:, 0], poses[:, 1], color=colour, label=label)
    for x, y, heading in poses[:: len(poses) // 3]:
        c, s = cos(heading), sin(heading)
        corners = pallet.vertices[[0, 1, 2, 3, 0]] @ np.array([[c, s], [-s, c]]) + (x, y)
        axes.plot(*corners.T, color=colour, linewidth=0.8)
axes.legend(frameon=False, loc="upper right")
save(figure, "pallet.png")
