"""Hold a barge with tugs that may part a line: what a loss leaves, and where the next tug helps.

The picture compares the best place for all tugs with the best place after the worst loss.
"""

from math import pi, radians

from matplotlib.figure import Figure

import swarmgrasp as sg
from swarmgrasp.plot import plan, save

TONNE_FORCE = 9806.65  # N

# A heavy-lift barge of 120 x 32 m with a raked bow; x forward, y to port.
barge = sg.Outline(
    [(-60, -16), (48, -16), (60, -8), (60, 8), (48, 16), (-60, 16)],
    edge_names=["starboard", "bow rake starboard", "bow", "bow rake port", "port", "stern"],
)
tugs = [
    sg.Robot((x, y), radians(heading), tonnes * TONNE_FORCE, name)
    for name, x, y, heading, tonnes in [
        ("Ajax", -42, -16, 110, 60),
        ("Boreas", 36, -16, 80, 50),
        ("Castor", 41, 16, -70, 60),
        ("Dione", -17, 16, -110, 50),
        ("Electra", -60, 0, 0, 70),
        ("Faunus", 60, 2, 180, 70),
        ("Gaia", -11, 16, -90, 45),
    ]
]
swarm = sg.Swarm(barge, tugs)

print(f"Seven tugs hold {sg.quality(swarm).value / 1e3:.0f} kN in every direction.")
for loss in sg.losses(swarm)[:3]:
    print(f"Without {loss.name} {loss.quality / 1e3:.0f} kN: the loss {loss.words}.")
for losing in (1, 2):
    left = sg.quality(swarm, losing=losing)
    gone = " and ".join(left.lost)
    print(f"The worst loss of {losing}, {gone}, leaves {left.value / 1e3:.0f} kN.")

# An eighth tug may push on the fenders of either side. Best for eight, or for the seven left?
hera = sg.Newcomer(60 * TONNE_FORCE, attachment="push", half_angle=pi / 6, name="Hera")
fenders = [sg.Zone(barge.stretch(side, 3.0, 105.0)) for side in ("starboard", "port")]

figure = Figure(figsize=(5.2, 7.8))
panels = figure.subplots(
    2, gridspec_kw={"left": 0.115, "right": 0.97, "top": 0.9, "bottom": 0.13, "hspace": 0.85}
)
for ax, losing in zip(panels, (0, 1), strict=True):
    answer = sg.place(swarm, hera, fenders, spacing=6.0, losing=losing)
    crew = answer.swarm_after
    whole, left = sg.quality(crew), sg.quality(crew, losing=1)
    x, y = answer.robot.contact
    aim = "after the worst loss" if losing else "for all eight"
    print(f"Best {aim}: {hera.name} at ({x:.1f}, {y:.1f}) m, {answer.place}, gives")
    print(f"  {whole.value / 1e3:.0f} kN with all eight tugs,")
    print(f"  {left.value / 1e3:.0f} kN without {left.lost[0]}, the worst loss.")
    plan(crew, quality=left, zones=fenders, ax=ax)
    heading = f"{hera.name} best {aim}: {whole.value / 1e3:.0f} kN with all of them"
    ax.set_title(heading, loc="left", pad=36, fontsize=9, fontweight="bold")

save(figure, "losing-robots.png")
