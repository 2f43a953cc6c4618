"""Labels that keep clear of each other, of arrows and of the frame."""

import itertools
import math
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.text import Text
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.plot.style import text as text_size

Vector = NDArray[np.float64]

Choice = tuple[float, Vector, Vector, float]
"""A place for a label: cost, anchor (2,) [px], centre (2,) [px] and the gap between [pt]."""

GAPS: Final = (3.0, 8.0, 15.0, 24.0, 36.0, 54.0)
"""Distances [pt] tried between a label and what it names."""

BEARINGS: Final = tuple(math.radians(a) for a in (0, 25, -25, 50, -50, 80, -80, 120, -120, 180))
"""Bearings [rad] tried, off the preferred one."""

LEADER: Final = 14.0
"""From this gap [pt] on a thin line joins a label to what it names."""

CROWDED: Final = 6.0
"""Price from which on a label that may be left out is left out, and another looks farther."""

HOPELESS: Final = 14.0
"""Price from which on a number takes the place of a label that may not be left out."""

LINE: Final = 1.5
FAINT: Final = 0.15
"""Price of a sample of a line, and of a faint one, below a label."""

ALONG: Final = 7.0
"""Gap [pt] between a line and a label along it: the line may be half of a strip."""

ROUND: Final = np.array([(math.cos(a), math.sin(a)) for a in np.arange(0.0, math.tau, 0.8)])
"""Samples of a dot, of radius 1."""

TAG: Final = 6.5
"""Size of the numbers that stand for labels without room [pt]."""

GRID: Final = 0.7
"""Distance between the places tried all over the page, in heights of the label."""


@dataclass
class Page:
    """What is drawn so far on an axes, as far as labels must keep clear of it.

    Attributes
    ----------
    ax : Axes
        Its limits and place on the figure are final.
    points : list of (k, 2) [px, px]
        Samples of the lines to keep clear of.
    faint : list of (k, 2) [px, px]
        Of those that a label may lie across where there is no better place.
    boxes : list of tuple [px, px, px, px]
        Labels already placed: left, bottom, right, top.
    tags : list of str, or None
        Labels that found no room: a number stands where they would, and a table says of what. None
        where there is no table; labels then lie across what is there.
    """

    ax: Axes
    points: list[Vector] = field(default_factory=list)
    faint: list[Vector] = field(default_factory=list)
    boxes: list[tuple[float, float, float, float]] = field(default_factory=list)
    tags: list[str] | None = None

    @property
    def point_size(self) -> float:
        """One typographic point [px]."""
        return float(self.ax.get_figure(root=True).dpi) / 72.0  # type: ignore[union-attr]

    def keep_clear(
        self, start: ArrayLike, end: ArrayLike, breadth: float = 0.0, is_faint: bool = False
    ) -> None:
        """Note a straight line as taken, or a dot.

        Parameters
        ----------
        start, end : (2,) [m, m]
        breadth : float [pt]
            Of the line; 0 for a thin one. Of the dot where start and end are the same.
        is_faint : bool
            Whether a label may lie across it where there is no better place.
        """
        points = self.faint if is_faint else self.points
        ends = self.ax.transData.transform(np.array([start, end], dtype=float))
        way = ends[1] - ends[0]
        if breadth and not way.any():
            radius = 0.5 * breadth * self.point_size
            points.append(ends[0] + radius * ROUND)
            return
        count = 2 + int(np.linalg.norm(way) / (2.5 * self.point_size))
        line = np.linspace(ends[0], ends[1], count)
        if breadth:
            across = np.array([-way[1], way[0]]) / max(float(np.hypot(*way)), 1e-9)
            side = 0.5 * breadth * self.point_size * across
            line = np.concatenate([line - side, line + side])
        points.append(line)

    def keep_clear_of(self, line: Vector) -> None:
        """Note a line through points (m, 2) as taken, but for where it is broken by nan."""
        ends = self.ax.transData.transform(line)
        ways = np.diff(ends, axis=0)
        longest = np.nan_to_num(np.hypot(*ways.T)).max(initial=0.0)
        count = 1 + int(longest / (2.5 * self.point_size))
        shares = np.arange(count)[:, None] / count
        samples = (ends[:-1, None] + shares * ways[:, None]).reshape(-1, 2)
        self.points.append(samples[np.isfinite(samples).all(axis=1)])

    def label(
        self,
        text: str,
        anchors: ArrayLike,
        bearing: ArrayLike,
        *,
        optional: bool = False,
        reach: float = GAPS[-1],
        fits: Callable[[Vector], bool] | None = None,
        **style: Any,
    ) -> Text | None:
        """Write a label where it collides least, joined by a line to what is not next to it.

        Parameters
        ----------
        text : str
        anchors : (k, 2) [m, m]
            Points it may sit at, best first.
        bearing : float or (k,) [rad]
            The preferred direction from each anchor to the label.
        optional : bool
            Whether to leave it out where there is no room.
        reach : float [pt]
            Largest distance of an optional label from its anchor; the others take any
            free place on the page when all near ones are taken.
        fits : callable
            Tells whether an optional label may be centred at a point (2,) [m, m].
        **style
            Passed to `Axes.text`.

        Returns
        -------
        Text or None
            None if it was left out.
        """
        spots = np.asarray(anchors, dtype=float)
        artist = self._text(text, spots[0], style)
        size = np.array(artist.get_window_extent().size)
        anchors = self.ax.transData.transform(spots)
        inverse = self.ax.transData.inverted()
        choices = sorted(self._near(anchors, np.broadcast_to(bearing, len(spots)), size), key=_cost)
        if optional:
            cheap = [c for c in choices if c[0] <= CROWDED and c[3] <= reach]
            fit = (c for c in cheap if fits is None or fits(inverse.transform(c[2])))
            choices = [*itertools.islice(fit, 1)]
        elif choices[0][0] > CROWDED:
            most = choices[0][0] if self.tags is None else min(choices[0][0], HOPELESS)
            choices = self._anywhere(anchors[0], size, most) or choices[:1]
            if choices[0][0] > HOPELESS and self.tags is not None:
                artist.remove()
                return self._tag(text, spots, bearing, style)
        if not choices:
            artist.remove()
            return None
        _, anchor, centre, gap = choices[0]
        self._put(artist, centre, size)
        if gap >= LEADER:
            self._leader(anchor, centre, size / 2.0, artist.get_color())
        return artist

    def label_along(self, text: str, line: tuple[Vector, Vector], **style: Any) -> Text | None:
        """Write a label along a line, on its left, or leave it out where there is no room.

        Parameters
        ----------
        text : str
        line : tuple of two (2,) [m, m]
            Start and end.
        **style
            Passed to `Axes.text`.

        Returns
        -------
        Text or None
            None if it was left out.
        """
        artist = self._text(text, line[0], style)
        size = np.array(artist.get_window_extent().size)
        start, end = self.ax.transData.transform(np.array(line))
        way = end - start
        length = float(np.hypot(*way))
        tilt = math.atan2(way[1], way[0])
        tilt -= math.pi * round(tilt / math.pi - 1e-6)  # never upside down
        left = np.array([-way[1], way[0]]) / length
        taken = self._taken()
        aside = (0.5 * size[1] + ALONG * self.point_size) * left
        play = 0.5 * max(0.0, 1.0 - size[0] / length)
        centres = [start + (0.5 + play * s) * way + aside for s in (0.0, -0.5, 0.5, -1.0, 1.0)]
        prices = [self._collisions(centre, size, taken, tilt) for centre in centres]
        best = int(np.argmin(prices))
        if size[0] > length or prices[best] > CROWDED:
            artist.remove()
            return None
        artist.set_rotation(math.degrees(tilt))
        self._put(artist, centres[best], np.array(artist.get_window_extent().size))
        return artist

    def _tag(
        self, text: str, spots: Vector, bearing: ArrayLike, style: dict[str, Any]
    ) -> Text | None:
        """Write a number in a circle instead of a label, and note what it stands for."""
        tags, self.tags = self.tags or [], None
        tags.append(text.replace("\n", ", "))
        colour = style.get("color")
        circle = {"boxstyle": "circle,pad=0.15", "facecolor": "white", "edgecolor": colour}
        look: dict[str, Any] = {
            "fontsize": TAG, "weight": "bold", "color": colour, "gid": "tag",
            "bbox": circle | {"linewidth": 0.6},
        }  # fmt: skip
        artist = self.label(f"{len(tags)}", spots, bearing, **look)
        self.tags = tags
        return artist

    def _text(self, text: str, spot: Vector, style: dict[str, Any]) -> Text:
        """Write a text centred somewhere, to be measured and moved."""
        look: dict[str, Any] = {"ha": "center", "va": "center", "linespacing": 1.15, "zorder": 6}
        look |= style | {"fontsize": text_size(style["fontsize"])}
        return self.ax.text(float(spot[0]), float(spot[1]), text, **look)

    def _put(self, artist: Text, centre: Vector, size: Vector) -> None:
        """Move a text's centre [px] and note its box as taken."""
        self.boxes.append((*(centre - size / 2.0), *(centre + size / 2.0)))
        artist.set_position(tuple(self.ax.transData.inverted().transform(centre)))

    def _taken(self) -> Vector:
        """Return all points (k, 2) [px] to keep clear of."""
        return np.concatenate(self.points) if self.points else np.empty((0, 2))

    def _near(self, anchors: Vector, bearings: Vector, size: Vector) -> list[Choice]:
        """Price the places round the anchors."""
        taken = self._taken()
        choices = []
        for rank, (anchor, bearing) in enumerate(zip(anchors, bearings, strict=True)):
            for turn in BEARINGS:
                way = np.array([math.cos(bearing + turn), math.sin(bearing + turn)])
                for gap in GAPS:
                    centre = anchor + way * (size / 2.0 + gap * self.point_size)
                    cost = 0.6 * abs(turn) + 0.05 * gap + 0.5 * rank
                    cost += self._collisions(centre, size, taken)
                    if gap >= LEADER:
                        cost += 1.0 + self._crossed(anchor, centre, taken)
                    choices.append((cost, anchor, centre, gap))
        return choices

    def _anywhere(self, anchor: Vector, size: Vector, most: float) -> list[Choice]:
        """Return the best place on the page for a label far from its anchor, if below a price."""
        taken, frame = self._taken(), self.ax.bbox
        x = np.arange(frame.x0 + size[0] / 2.0, frame.x1 - size[0] / 2.0, GRID * size[1])
        y = np.arange(frame.y0 + size[1] / 2.0, frame.y1 - size[1] / 2.0, GRID * size[1])
        centres = np.column_stack([part.ravel() for part in np.meshgrid(x, y, indexing="ij")])
        beyond = np.maximum(np.abs(centres - anchor) - size / 2.0, 0.0)
        gaps = np.hypot(*beyond.T) / self.point_size
        found: list[Choice] = []
        for index in np.argsort(gaps, kind="stable").tolist():
            centre, gap = centres[index], float(gaps[index])
            cost = 1.0 + 0.08 * gap
            if cost >= most:
                break
            cost += self._collisions(centre, size, taken)
            if cost < most:
                cost += self._crossed(anchor, centre, taken)
            if cost < most:
                most, found = cost, [(cost, anchor, centre, gap)]
        return found

    def _collisions(self, centre: Vector, size: Vector, taken: Vector, tilt: float = 0.0) -> float:
        """Return the price of a label's box: lines and labels under it, and the frame."""
        c, s = math.cos(tilt), math.sin(tilt)
        half = size / 2.0 + 2.0 * self.point_size
        turn = np.array([[c, -s], [s, c]])
        prices = ((LINE, taken), (FAINT, np.concatenate([np.empty((0, 2)), *self.faint])))
        price = sum(
            each * np.count_nonzero((np.abs((points - centre) @ turn) < half).all(axis=1))
            for each, points in prices
        )
        half = np.abs([[c, -s], [s, c]]) @ half
        (left, bottom), (right, top) = centre - half, centre + half
        apart = 4.0 * self.point_size  # more between two labels, lest they read as one
        for a, b, c, d in self.boxes:
            overlap = max(0.0, min(right, c + apart) - max(left, a - apart)) * max(
                0.0, min(top, d) - max(bottom, b)
            )
            price += 60.0 * overlap / (size[0] * size[1]) + 4.0 * (overlap > 0.0)
        frame = self.ax.bbox
        beyond = max(frame.x0 - left, right - frame.x1, frame.y0 - bottom, top - frame.y1, 0.0)
        return float(price + 2.0 * beyond / self.point_size)

    def _crossed(self, anchor: Vector, centre: Vector, taken: Vector) -> float:
        """Return the price of the labels and lines that a line from anchor to label would cross."""
        line = np.linspace(anchor, centre, 33)[:, None]
        boxes = np.reshape(self.boxes, (-1, 4))
        is_in = ((line >= boxes[:, :2]) & (line <= boxes[:, 2:])).all(axis=-1).any(axis=0)
        price = 5.0 * np.count_nonzero(is_in)
        way = centre - anchor
        length = float(np.hypot(*way))
        along, across = np.array([way, (-way[1], way[0])]) @ (taken - anchor).T / length
        near = 8.0 * self.point_size  # at the anchor there is always something
        hits = (along > near) & (along < length) & (np.abs(across) < 1.3 * self.point_size)
        return price + 0.8 * np.count_nonzero(hits)

    def _leader(
        self,
        anchor: Vector,
        centre: Vector,
        half: Vector,
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


def _cost(choice: Choice) -> float:
    """Return the cost of a place for a label."""
    return choice[0]
