"""Place a sixth tug at a barge, check the proof, and draw the answer.

Run it from anywhere; the pictures go into the folder it is run in.
"""

from math import pi, radians

import swarmgrasp as sg
from swarmgrasp.plot import landscape, plan, save, wrench_sets

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
before = sg.quality(swarm)
print(f"Five tugs hold {before.value / 1e3:.0f} kN in every direction; weakest is")
print(f"  {sg.wrench_words(before.direction)}, set by", *before.facet_robots)

# The sixth may push onto the fenders of either side, or pull from a bollard at the bow.
fortuna = sg.Newcomer(60 * TONNE_FORCE, attachment="push", half_angle=pi / 6, name="Fortuna")
bollard = barge.at_point((38.0, 4.0)).arc_length
zones = [
    sg.Zone(barge.stretch("starboard", 3.0, 60.0)),
    sg.Zone(barge.stretch("port", 3.0, 60.0)),
    sg.Zone(sg.Stretch(bollard, bollard, "bow bollard"), attachment="pull", half_angle=pi / 3),
]
answer = sg.place(swarm, fortuna, zones, spacing=8.0, runners_up=0.0)
x, y = answer.robot.contact
print(f"{fortuna.name} goes to {answer.place}, ({x:.1f}, {y:.1f}) m, and lifts that to")
print(
    f"  {answer.quality / 1e3:.0f} kN; no allowed place exceeds {answer.upper_bound / 1e3:.0f} kN"
)
for other in answer.runners_up:
    print(f"  {other.place} would give {other.quality / 1e3:.0f} kN")

verdict = answer.verify()
print("The proof holds." if verdict else verdict.faults)

save(plan(swarm, quality=before, placements=[answer]), "barge-plan.png")
save(wrench_sets(swarm, answer.swarm_after), "barge-wrenches.png")
save(landscape(answer), "barge-landscape.png")
