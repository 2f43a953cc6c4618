"""Place tugs around an empty barge together, and see why one after the other is not enough.

Run it from anywhere; the picture goes into the folder it is run in.
"""

from math import radians

import swarmgrasp as sg
from swarmgrasp.plot import plan, save

TONNE_FORCE = 9806.65  # N

# A barge of 76 x 22 m with a raked bow; x forward, y to port.
barge = sg.Outline(
    [(-38, -11), (29, -11), (38, -6), (38, 6), (29, 11), (-38, 11)],
    edge_names=["starboard", "bow rake starboard", "bow", "bow rake port", "port", "stern"],
)
empty = sg.Swarm(barge, [])
tug = sg.Newcomer(60 * TONNE_FORCE, attachment="push", half_angle=radians(30), name="tug")
problem = sg.Problem(empty, tug, spacing=8.0)

six = sg.place_together(problem, 6)
one_by_one, together, bound = (
    round(quality / 1e3) for quality in (six.sequential, six.quality, six.upper_bound)
)
print(f"Six tugs placed one after the other hold {one_by_one} kN in every direction,")
print(f"{together} kN together; no places exceed {bound} kN.")
print("With six,", six.reason)

# How many tugs does it take to hold 1 MN in every direction?
found = sg.how_many(problem, 1e6)
print("For 1 MN,", found.reason)

# One of the six was sent to the wrong place: which should move, and where?
astray = barge.on_edge("port", 30.0)
crew = [*six.robots[1:], sg.Robot(astray.point, astray.inward, tug.limit, "stray")]
move = sg.best_move(sg.Problem(sg.Swarm(barge, crew), tug, spacing=8.0))
print(f"From {move.quality_before / 1e3:.0f} to {move.quality / 1e3:.0f} kN:", move.reason)

save(plan(six.swarm_after, quality=sg.quality(six.swarm_after)), "barge-together.png")
