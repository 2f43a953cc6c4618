"""Draw the wind that eight tugs can hold a barge against, intact and after the worst loss.

Run it from anywhere; the picture goes into the folder it is run in.
"""

from dataclasses import replace

import numpy as np

import swarmgrasp as sg
from swarmgrasp.environment import KNOT, beaufort_number
from swarmgrasp.plot import capability_diagram, save

TONNE_FORCE = 9806.65  # N

# A barge of 76 x 22 m, 8 m high above the water and 2.5 m below; x forward, y to port.
barge = sg.Outline(
    [(-38, -11), (29, -11), (38, -6), (38, 6), (29, 11), (-38, 11)],
    edge_names=["starboard", "bow rake starboard", "bow", "bow rake port", "port", "stern"],
)


def push(name, edge, along, tonnes):
    """Return a tug that pushes square onto an edge."""
    contact = barge.on_edge(edge, along)
    return sg.Robot(contact.point, contact.inward, tonnes * TONNE_FORCE, name)


swarm = sg.Swarm(
    barge,
    [
        push("Ajax", "starboard", 6.0, 45),
        push("Boreas", "starboard", 60.0, 45),
        push("Castor", "port", 7.0, 45),
        push("Dione", "port", 61.0, 45),
        push("Electra", "bow", 1.5, 30),
        push("Fortuna", "bow", 10.5, 30),
        push("Gaia", "stern", 2.0, 30),
        push("Hector", "stern", 20.0, 30),
    ],
)

# What the barge shows to the wind and to a knot of current from where the wind comes.
wind = sg.Wind(
    frontal_area=22.0 * 8.0,
    lateral_area=76.0 * 8.0,
    coefficients=sg.WindCoefficients(transverse=0.9, bow=0.7, stern=0.7),
)
current = sg.Current(
    frontal_area=22.0 * 2.5,
    lateral_area=72.0 * 2.5,
    speed=1.0 * KNOT,
    coefficients=sg.CurrentCoefficients(surge=0.3, sway=0.6),  # blunt ends
)
weather = sg.Environment(wind, current, dynamic_factor=1.25)

found = sg.capability(swarm, weather)
for what, speeds, i in (
    ("All tugs", found.intact, found.worst),
    ("After the worst loss they", found.after_loss, found.worst_after_loss),
):
    print(
        f"{what} hold {speeds[i] / KNOT:.0f} kn of wind, Beaufort {beaufort_number(speeds[i])}, "
        f"from any bearing; the worst is {np.degrees(found.bearings[i]):.0f} degrees"
    )
print("That loss is", " and ".join(found.worst_losses[found.worst_after_loss]))

# A gale on the starboard bow, and what is left beside it for everything else.
gale = replace(wind, speed=34 * KNOT, bearing=np.radians(45))
load = sg.Environment(gale, current).load(barge)
left = sg.quality(swarm, load=tuple(load)).value
print(f"Beside a gale from 45 degrees {left / 1e3:.0f} kN are left in every direction,")
print(f"  of {sg.quality(swarm).value / 1e3:.0f} kN in calm weather")

save(capability_diagram(found, "Barge and eight tugs"), "capability.png")
