"""Labels that keep clear of each other, of arrows and of the frame."""

import math
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.text import Text
from numpy.typing import ArrayLike, NDArray

GAPS: Final = (3.0, 8.0, 15.0, 24.0, 36.0, 54.0)
"""Distances [pt] tried between a label and what it names."""

BEARINGS: Final = tuple(math.radians(a) for a in (0, 25, -25, 50, -50, 80, -80, 120, -120, 180))
"""Bearings [rad] tried, off the preferred one."""

LEADER: Final = 14.0
"""From this gap [pt] on a thin line joins a label to what it names."""

CROWDED: Final = 6.0
"""Price from which on a label that may be left out is left out."""


@dataclass
class Page:
    """What is drawn so far on an axes, as far as labels must keep clear of it.

    Attributes
    ----------
    ax : Axes
        Its limits and place on the figure are final.
    points : list of (k, 2) [px, px]
        Samples of the lines to keep clear of.
    boxes : list of tuple [px, px, px, px]
        Labels already placed: left, bottom, right, top.
    """

    ax: Axes
    points: list[NDArray[np.float64]] = field(default_factory=list)
    boxes: list[tuple[float, float, float, float]] = field(default_factory=list)

    @property
    def point_size(self) -> float:
        """One typographic point [px]."""
        return float(self.ax.get_figure(root=True).dpi) / 72.0  # type: ignore[union-attr]

    def keep_clear(self, start: ArrayLike, end: ArrayLike, breadth: float = 0.0) -> None:
        """Note a straight line as taken.

        Parameters
        ----------
        start, end : (2,) [m, m]
        breadth : float [pt]
            Of the line; 0 for a thin one.
        """
        ends = self.ax.transData.transform(np.array([start, end], dtype=float))
        way = ends[1] - ends[0]
        count = 2 + int(np.linalg.norm(way) / (2.5 * self.point_size))
        line = np.linspace(ends[0], ends[1], count)
        if breadth:
            across = np.array([-way[1], way[0]]) / max(float(np.hypot(*way)), 1e-9)
            side = 0.5 * breadth * self.point_size * across
            line = np.concatenate([line - side, line + side])
        self.points.append(line)

    def label(
        self,
        text: str,
        anchors: ArrayLike,
        bearing: float,
        *,
        optional: bool = False,
        **style: Any,
    ) -> Text | None:
        """Write a label where it collides least.

        Parameters
        ----------
        text : str
        anchors : (k, 2) [m, m]
            Points it may sit at, best first.
        bearing : float [rad]
            The preferred direction from anchor to label.
        optional : bool
            Whether to leave it out where there is no room, and never to draw a line to it.
        **style
            Passed to `Axes.text`.

        Returns
        -------
        Text or None
            None if it was left out.
        """
        spots = np.asarray(anchors, dtype=float)
        artist = self.ax.text(
            float(spots[0, 0]),
            float(spots[0, 1]),
            text,
            ha="center",
            va="center",
            linespacing=1.15,
            zorder=6,
            **style,
        )
        extent = artist.get_window_extent()
        best = self._best(self.ax.transData.transform(spots), bearing, extent.width, extent.height)
        price, anchor, centre, gap = best
        if optional and price > CROWDED:
            artist.remove()
            return None
        half = np.array([extent.width, extent.height]) / 2.0
        self.boxes.append((*(centre - half), *(centre + half)))
        artist.set_position(tuple(self.ax.transData.inverted().transform(centre)))
        if not optional and gap >= LEADER:
            self._leader(anchor, centre, half, artist.get_color())
        return artist

    def _best(
        self, anchors: NDArray[np.float64], bearing: float, width: float, height: float
    ) -> tuple[float, NDArray[np.float64], NDArray[np.float64], float]:
        """Return the cheapest (cost, anchor, centre, gap [pt]) of all that are tried."""
        taken = np.concatenate(self.points) if self.points else np.empty((0, 2))
        choices = []
        for rank, anchor in enumerate(anchors):
            for turn in BEARINGS:
                way = np.array([math.cos(bearing + turn), math.sin(bearing + turn)])
                for gap in GAPS:
                    reach = np.array([width, height]) / 2.0 + gap * self.point_size
                    centre = anchor + way * reach
                    cost = 0.6 * abs(turn) + 0.05 * gap + 0.5 * rank
                    cost += self._collisions(centre, width, height, taken)
                    if gap >= LEADER:
                        cost += 1.0 + self._hidden(anchor, centre)
                    choices.append((cost, anchor, centre, gap))
        return min(choices, key=lambda choice: choice[0])

    def _collisions(
        self, centre: NDArray[np.float64], width: float, height: float, taken: NDArray[np.float64]
    ) -> float:
        """Return the price of a label's box: lines and labels under it, and the frame."""
        margin = 1.5 * self.point_size
        half = np.array([width, height]) / 2.0 + margin
        (left, bottom), (right, top) = centre - half, centre + half
        price = 1.5 * np.count_nonzero((np.abs(taken - centre) < half).all(axis=1))
        for a, b, c, d in self.boxes:
            overlap = max(0.0, min(right, c) - max(left, a)) * max(
                0.0, min(top, d) - max(bottom, b)
            )
            price += 60.0 * overlap / (width * height) + 4.0 * (overlap > 0.0)
        frame = self.ax.bbox
        beyond = max(frame.x0 - left, right - frame.x1, frame.y0 - bottom, top - frame.y1, 0.0)
        return float(price + 2.0 * beyond / self.point_size)

    def _hidden(self, anchor: NDArray[np.float64], centre: NDArray[np.float64]) -> float:
        """Return the price of the labels that a line from anchor to label would cross."""
        line = np.linspace(anchor, centre, 9)
        return 1.5 * sum(
            np.count_nonzero(((line >= box[:2]) & (line <= box[2:])).all(axis=1))
            for box in self.boxes
        )

    def _leader(
        self,
        anchor: NDArray[np.float64],
        centre: NDArray[np.float64],
        half: NDArray[np.float64],
        colour: Any,
    ) -> None:
        """Join a label to its anchor by a thin line that ends at the label's box."""
        reach = anchor - centre
        share = float(np.min(half / np.maximum(np.abs(reach), 1e-9)))
        if share >= 1.0:
            return
        ends = self.ax.transData.inverted().transform([anchor, centre + share * reach])
        self.keep_clear(*ends)
        self.ax.plot(*ends.T, color=colour, linewidth=0.5, zorder=3)
