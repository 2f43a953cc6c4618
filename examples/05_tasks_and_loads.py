"""Tow a caisson ahead and turn it, in a wind: quality for a task instead of in all directions.

One picture shows all wrenches the tugs can exert, with the task in them as large as it fits.
"""

from math import pi, radians

import swarmgrasp as sg
from swarmgrasp.plot import plan, save, wrench_sets

TONNE_FORCE = 9806.65  # N

# A caisson of 60 x 40 m, towed by its forward corners; x forward, y to port.
caisson = sg.Outline(
    [(-30, -20), (30, -20), (30, 20), (-30, 20)],
    edge_names=["starboard", "front", "port", "rear"],
)
tugs = [
    sg.Robot((x, y), radians(heading), tonnes * TONNE_FORCE, name)
    for name, x, y, heading, tonnes in [
        ("Ajax", 30, 16, 40, 70),  # these two tow,
        ("Boreas", 30, -16, -40, 70),
        ("Castor", -30, 0, 180, 40),  # this one brakes,
        ("Dione", -24, 20, -80, 45),  # and these two steer
        ("Electra", -20, -20, 80, 45),
    ]
]
swarm = sg.Swarm(caisson, tugs)
print(f"In every direction the tugs hold {sg.quality(swarm).value / 1e3:.0f} kN.")

# The task: 800 kN ahead, and a turn of 8 MN m either way while 300 kN still go ahead.
tow = sg.Polytope([(800e3, 0, 0), (300e3, 0, 8e6), (300e3, 0, -8e6)])
print(f"Towing ahead and turning: {sg.quality(swarm, task=tow).value:.2f} times the task.")

# A steady wind from port: it pushes the caisson astern and to starboard, and turns it.
wind = (-100e3, -200e3, -2e6)
windy = sg.quality(swarm, task=tow, load=wind)
print(f"The same in a steady wind: {windy.value:.2f} times.")
against = sg.Polytope([[-part for part in wind]])
print(f"The wind alone: {sg.quality(swarm, task=against).value:.1f} times as strong is held.")

# Preferred directions: most of all ahead and astern, some turning, little to the sides.
mostly_ahead = sg.Ellipsoid([(400e3, 0, 0), (0, 100e3, 0), (0, 0, 4e6)])
print(f"Mostly ahead and astern: {sg.quality(swarm, task=mostly_ahead).value:.2f} times.")

# Where should a sixth tug pull: for all directions, or for the task in that wind?
fortuna = sg.Newcomer(50 * TONNE_FORCE, "pull", half_angle=pi / 3, name="Fortuna")
for terms in ({}, {"task": tow, "load": wind}):
    answer = sg.place(swarm, fortuna, spacing=6.0, **terms)
    x, y = answer.robot.contact
    crew = answer.swarm_after
    aim = "the task in the wind" if terms else "all directions"
    print(f"Best for {aim}: {fortuna.name} at ({x:.1f}, {y:.1f}) m, {answer.place},")
    print(
        f"  {sg.quality(crew).value / 1e3:.0f} kN in every direction, "
        f"{sg.quality(crew, task=tow, load=wind).value:.2f} times the task in the wind"
    )

criterion = answer.problem.criterion
save(wrench_sets(swarm, crew, criterion=criterion), "towing-wrenches.png")
save(plan(swarm, quality=windy, placements=[answer]), "towing-plan.png")
