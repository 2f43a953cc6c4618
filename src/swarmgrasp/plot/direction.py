"""A wrench at the origin: its force as an arrow, its torque as a turn.

The arrow has the scale of the robots' arrows where it is then neither too long nor too short, and
is filled. Where it only shows a direction it is hollow, and the legend says so. A turn shows no
more than its sense.
"""

import math
from collections.abc import Iterable
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.plot import style
from swarmgrasp.plot.arrows import ArrowEntry, Arrows, draw_arrows, draw_turn
from swarmgrasp.plot.labels import Page
from swarmgrasp.swarm import Swarm

LEAST_PART: Final = 0.02
"""Share of a wrench below which its force or its torque is not drawn."""

SIZES: Final = (38.0, 13.0)
"""Length of an arrow that only shows a direction, and radius of the turn [pt]."""

SHORTEST: Final = 0.04
"""Length of an arrow relative to the extent of the object, from which on it may be to scale."""

WIDTH: Final = 0.03
"""Of the arrow [in]."""

HOLLOW: Final[dict[str, Any]] = {"facecolor": "white", "linewidth": 0.9}
"""An arrow that only shows a direction."""

OPPOSITE, ASIDE = 0.9, 9.0
"""Cosine of the angle between two arrows from which on they would lie on each other, and how far
one of them then moves aside [pt]."""

ROUND: Final = 9
"""Points that labels keep clear of round the turn."""


class Pointer:
    """A wrench to be drawn at the origin.

    Parameters
    ----------
    arrows : Arrows
        Whose scale it may have.
    swarm : Swarm
        Whose origin and metric are meant.
    wrench : (3,) [N, N, N m]
    label : str
        What it is.
    is_measured : bool
        Whether its size means something, and not its direction alone.
    ends_here : bool
        Whether the arrow ends at the origin, as that of a load on the object, and has no turn.
    colour : str
    """

    def __init__(
        self, arrows: Arrows, swarm: Swarm, wrench: NDArray[np.float64], label: str, *,
        is_measured: bool = True, ends_here: bool = False, colour: str = style.PURPLE,
    ) -> None:  # fmt: skip
        parts = np.asarray(wrench) * swarm.scale
        self.shares = parts / (np.linalg.norm(parts) or 1.0)
        self.force = np.asarray(wrench[:2])
        self.origin = swarm.outline.origin
        self.label, self.colour, self.ends_here = label, colour, ends_here
        self.has_force = bool(np.hypot(*self.shares[:2]) > LEAST_PART)
        self.has_torque = bool(abs(self.shares[2]) > LEAST_PART)
        self.reach = 0.0
        if arrows.strongest:
            self.reach = arrows.length(float(np.hypot(*self.force)))
        off = self.reach * self.way * (-1.0 if ends_here else 1.0)
        low, high = arrows.box()
        fits = bool(((low <= self.origin + off) & (self.origin + off <= high)).all())
        is_long = self.reach >= SHORTEST * swarm.outline.extent
        self.is_to_scale = is_measured and self.has_force and is_long and fits

    @property
    def way(self) -> NDArray[np.float64]:
        """The unit vector (2,) along the force."""
        return np.asarray(self.force / (np.hypot(*self.force) or 1.0))

    def entry(self) -> ArrowEntry:
        """Return the legend entry: what it is, and what of it has no scale."""
        note = ""
        if self.ends_here and self.has_torque:
            note = " (its force)" if self.is_to_scale else " (direction of its force)"
        elif self.has_torque and self.is_to_scale:
            note = " (turn: sense only)"
        elif not self.is_to_scale:
            note = " (direction only)" if self.has_force else " (sense only)"
        look: dict[str, Any] = {"facecolor": self.colour}
        if not self.is_to_scale:
            look = HOLLOW | {"edgecolor": self.colour}
        return ArrowEntry(**look, label=f"{self.label}{note}")

    def draw(self, page: Page, gid: str, others: Iterable["Pointer"] = ()) -> float:
        """Draw it; return the radius [m] of its turn.

        Parameters
        ----------
        page : Page
        gid : str
            Of what is drawn.
        others : iterable of Pointer
            Drawn before: an arrow that would lie on one of them moves aside.
        """
        ax, origin = page.ax, self.origin
        inverse = ax.transData.inverted()
        metres = page.point_size * float(np.ptp(inverse.transform([(0.0, 0.0), (1.0, 0.0)])[:, 0]))
        length, radius = (style.text(size) * metres for size in SIZES)
        if self.has_force:
            part = 1.0 if self.ends_here else float(np.hypot(*self.shares[:2]))
            off = (self.reach if self.is_to_scale else length * part) * self.way
            ends = (origin - off, origin) if self.ends_here else (origin, origin + off)
            if self.ends_here and any(-self.way @ other.way > OPPOSITE for other in others):
                aside = style.text(ASIDE) * metres * np.array([-self.way[1], self.way[0]])
                ends = (ends[0] + aside, ends[1] + aside)
            look = {"color": self.colour}
            if not self.is_to_scale:
                look = HOLLOW | {"edgecolor": self.colour}
            draw_arrows(ax, [ends], **look, width=WIDTH, gid=gid, zorder=5)
            page.keep_clear(*ends, breadth=200.0 * WIDTH)
        if self.ends_here:
            return radius
        if self.has_torque:
            torque = float(self.shares[2])
            sweep = math.copysign(0.6 + 4.0 * abs(torque), torque)
            middle = math.atan2(self.way[1], self.way[0]) + math.pi
            draw_turn(ax, origin, radius, middle, sweep, color=self.colour, linewidth=2.0, gid=gid)
        for turn in np.linspace(0.0, math.pi, ROUND)[:-1]:
            reach = 1.3 * radius * np.array([math.cos(turn), math.sin(turn)])
            page.keep_clear(origin - reach, origin + reach)
        return radius


def load_pointer(arrows: Arrows, swarm: Swarm, load: ArrayLike) -> Pointer:
    """Return a load on the object (3,) [N, N, N m], its arrow ending at the origin."""
    return Pointer(arrows, swarm, np.asarray(load, float), "load", ends_here=True, colour=style.INK)
