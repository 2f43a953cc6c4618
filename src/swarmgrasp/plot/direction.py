"""Which way a wrench acts, drawn at the origin: its force as an arrow, its torque as a turn."""

import math
from typing import Final

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.plot import style
from swarmgrasp.plot.arrows import draw_arrows, draw_turn
from swarmgrasp.plot.labels import Page
from swarmgrasp.swarm import Swarm

LEAST_PART: Final = 0.02
"""Share of a wrench below which its force or its torque is not drawn."""

SIZES: Final = (38.0, 13.0)
"""Length of the arrow and radius of the turn [pt]: they show a direction, so their size follows
the paper and not the object."""


def draw_direction(page: Page, swarm: Swarm, wrench: NDArray[np.float64], gid: str) -> float:
    """Draw which way a wrench acts; return the radius [m] of its turn.

    Parameters
    ----------
    page : Page
    swarm : Swarm
        Whose origin and metric are meant.
    wrench : (3,) unit vector
        In the metric's coordinates.
    gid : str
        Of what is drawn.
    """
    ax, origin = page.ax, swarm.outline.origin
    inverse = ax.transData.inverted()
    metres = page.point_size * float(np.ptp(inverse.transform([(0.0, 0.0), (1.0, 0.0)])[:, 0]))
    length, radius = (size * metres for size in SIZES)
    force, torque = wrench[:2], float(wrench[2])
    way = force / swarm.scale[:2]
    if np.hypot(*force) > LEAST_PART:
        tip = origin + length * np.hypot(*force) * way / np.hypot(*way)
        draw_arrows(ax, [(origin, tip)], color=style.PURPLE, width=0.03, gid=gid, zorder=5)
        page.keep_clear(origin, tip)
    if abs(torque) > LEAST_PART:
        sweep = math.copysign(0.6 + 4.0 * abs(torque), torque)
        look = {"color": style.PURPLE, "linewidth": 2.0, "gid": gid}
        draw_turn(ax, origin, radius, math.atan2(way[1], way[0]) + math.pi, sweep, **look)
    for turn in np.linspace(0.0, math.pi, 9)[:-1]:
        reach = 1.3 * radius * np.array([math.cos(turn), math.sin(turn)])
        page.keep_clear(origin - reach, origin + reach)
    return radius
