"""Say in words what limits a swarm, and which small move of which robot would help.

Run it from anywhere; the picture goes into the folder it is run in.
"""

from dataclasses import replace
from math import radians

import numpy as np

import swarmgrasp as sg
from swarmgrasp.plot import save, sensitivity_plan
from swarmgrasp.scenario import load_example

barge = load_example("deck-barge")
swarm = barge.swarm

# Every quality and every placement explains itself.
print(sg.quality(swarm).explanation)
answer = sg.place(barge.problem(), runners_up=0.5)
print(f"\n{answer.explanation}\n")

# The slopes are exact. The two columns are the one way and the other, clockwise first.
found = sg.sensitivities(swarm)
shift, turn = found.contact / 1e3, found.direction_per_degree / 1e3
print("Gain in quality         shift [kN/m]     turn [kN/deg]")
for robot, metre, degree in zip(swarm.robots, shift, turn, strict=True):
    print("{:20}  {:6.2f}  {:6.2f}  {:7.2f} {:7.2f}".format(robot.name, *metre, *degree))

# Turn the robot that tells most by two degrees, the way that helps.
best, way = np.unravel_index(np.argmax(turn), turn.shape)
robot = swarm.robots[best]
turned = replace(robot, direction=robot.direction + radians(2.0 if way else -2.0))
crew = [turned if i == best else other for i, other in enumerate(swarm.robots)]
after = sg.quality(sg.Swarm(swarm.outline, crew, swarm.characteristic_length)).value
print(
    f"\nTurning {robot.name} by 2 degrees {'counter-' if way else ''}clockwise: "
    f"{found.quality.value / 1e3:.1f} -> {after / 1e3:.1f} kN, where the slope promises "
    f"{found.quality.value / 1e3 + 2.0 * turn[best, way]:.1f} kN"
)

save(sensitivity_plan(found), "sensitivities.png")
