"""Tugs that are not quite where they should be: what they do for certain, and a careful newcomer.

The picture shows where every tug may be, which way it may push, and the worst of it.
"""

from math import degrees, pi, radians

import swarmgrasp as sg
from swarmgrasp.plot import plan, save

TONNE_FORCE = 9806.65  # N

# A dock of 90 x 28 m with a raked bow; x forward, y to port.
dock = sg.Outline(
    [(-45, -14), (35, -14), (45, -9), (45, 9), (35, 14), (-45, 14)],
    edge_names=["starboard", "bow rake starboard", "bow", "bow rake port", "port", "stern"],
)


def tug(name, place, heading, tonnes, **doubt):
    """Return a tug, with its tolerance if there is a doubt: metres along the side, radians."""
    tolerance = sg.Tolerance(**doubt) if doubt else None
    return sg.Robot(place, radians(heading), tonnes * TONNE_FORCE, name, tolerance=tolerance)


swarm = sg.Swarm(
    dock,
    [
        tug("Ajax", (-12, -14), 110, 50, contact=2, direction=radians(8)),
        tug("Boreas", (2, -14), 100, 50, contact=2, direction=radians(8)),
        tug("Castor", (30, 14), -80, 45, contact=3, direction=radians(10)),
        tug("Dione", (-11, 14), -110, 45, contact=1, least_limit=30 * TONNE_FORCE),
        tug("Electra", (-45, -2), 0, 60, contact=2, direction=radians(8)),
        tug("Faunus", (45, 5), 160, 60),  # moored: this one stays
        tug("Hebe", (-35, -14), 90, 15, may_be_absent=True),
    ],
)
worst = sg.quality(swarm, worst_case=True)
print(f"Seven tugs hold {sg.quality(swarm).value / 1e3:.0f} kN where they should be,")
print(f"  and {worst.value / 1e3:.0f} kN for certain. In the worst case:")
meant = {robot.name: robot for robot in swarm.robots}
for robot in worst.worst_swarm.robots:
    should = meant.pop(robot.name)
    apart = [at - by for at, by in zip(robot.contact, should.contact, strict=True)]
    turn = degrees(robot.direction - should.direction)
    if should.tolerance:
        print(
            f"  {robot.name:8} off by ({apart[0]:+.1f}, {apart[1]:+.1f}) m and {turn:+.0f} deg, "
            f"{robot.limit / TONNE_FORCE:.0f} t"
        )
print(" ", *meant, "not there")

# An eighth tug may push on either side, but cannot stop within 6 m or steer within 12 degrees.
iris = sg.Newcomer(
    60 * TONNE_FORCE, "push", pi / 6, "Iris", sg.Tolerance(contact=6, direction=radians(12))
)
fenders = [sg.Zone(dock.stretch(side, 3.0, 77.0)) for side in ("starboard", "port")]
for worst_case in (False, True):
    answer = sg.place(swarm, iris, fenders, spacing=6.0, worst_case=worst_case)
    crew, x = answer.swarm_after, answer.robot.contact[0]
    certain = sg.quality(crew, worst_case=True).value
    print("Best in the worst case:" if worst_case else "Best if all goes well:")
    print(
        f"  {iris.name} at x = {x:.1f} m to {answer.place}, {degrees(answer.robot.direction):.0f} "
        f"deg: {sg.quality(crew).value / 1e3:.0f} kN, for certain {certain / 1e3:.0f} kN"
    )

save(plan(swarm, quality=worst, placements=[answer]), "uncertain-poses.png")
