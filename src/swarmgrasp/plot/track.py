"""The track of a run from above: where the object went, and within which circles it was kept."""

import itertools
import math
from dataclasses import dataclass
from typing import Any, Final, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.lines import Line2D
from matplotlib.patches import Circle as Ring
from matplotlib.patches import Polygon
from numpy.typing import NDArray

from swarmgrasp.environment import KNOT
from swarmgrasp.plot import style, written
from swarmgrasp.plot.arrows import draw_arrows
from swarmgrasp.plot.coordinates import tick_axes
from swarmgrasp.plot.figure import Drawn
from swarmgrasp.plot.labels import Page
from swarmgrasp.simulation.run import Run
from swarmgrasp.simulation.verdict import Verdict
from swarmgrasp.terms import SI, Terms

Vector = NDArray[np.float64]

COLOURS: Final = (style.BLUE, style.VERMILION, style.GREEN, style.PURPLE, style.ORANGE, style.SKY)
"""Of the stages of a run, in turn."""
TURNS: Final = ("lost", "left", "joined", "aim", "weather")
"""Kinds of happenings that begin a stage: what is noticed or sent changes nothing yet."""
STILL: Final = 1e-6
"""How far a reference may move, relative to the object's extent, and a circle still be drawn."""
CALM: Final = 1e-6
"""Variation of a wind, relative to its mean, that counts as none."""
WIND_ROW: Final = 28.0
"""Room for the wind above all else [pt]."""
TWO_COLUMNS: Final = 4.6
"""Width [in] from which on the legend has two columns."""
HEIGHTS: Final = (2.0, 4.4)
"""Least and greatest height of the axes [in]."""
APART: Final = 1.2
"""Least way between the outlines of one stage, relative to the object's extent."""
MOST_SHOWN: Final = 6
"""Outlines of one stage."""
MARGIN: Final = 0.08
"""Around what is drawn, relative to its width."""


@dataclass(frozen=True)
class Stage:
    """A part of a run between two turns.

    Attributes
    ----------
    start, end : float [s]
    words : str
        What it is called.
    rows : slice
        Its instants.
    distance : float [m]
    turn : float [rad]
        The largest errors.
    colour : str
    """

    start: float
    end: float
    words: str
    rows: slice
    distance: float
    turn: float
    colour: str

    @property
    def line(self) -> dict[str, Any]:
        """How its way is drawn."""
        dashes = style.DASHES[COLOURS.index(self.colour) % len(style.DASHES)]
        return {"color": self.colour, "linewidth": 1.6, "linestyle": dashes}


def stages_of(run: Run, verdict: Verdict, index: int = 0) -> tuple[Stage, ...]:
    """Return the stages of one of the runs, in order.

    Parameters
    ----------
    run : Run
    verdict : Verdict
        Of the run.
    index : int
        Which of the runs.
    """
    pairs = list(zip(run.happenings, verdict.circles, strict=True))
    begins = [k for k, (at, _) in enumerate(pairs) if k == 0 or at.kind in TURNS]
    found = []
    for stage, (first, last) in enumerate(zip(begins, [*begins[1:], len(pairs)], strict=True)):
        start, end = pairs[first][1].start, pairs[last - 1][1].end
        if end <= start and stage:
            continue
        circles = [circle for _, circle in pairs[first:last]]
        rows = slice(*np.searchsorted(run.times, (start, end)).tolist())
        found.append(
            Stage(
                start, end, _stage_words(pairs[first][0], stage, len(begins)),
                slice(rows.start, rows.stop + 1),
                max(float(circle.distance[index]) for circle in circles),
                max(float(circle.turn[index]) for circle in circles),
                COLOURS[stage % len(COLOURS)],
            )
        )  # fmt: skip
    return tuple(found)


def _stage_words(at: Any, stage: int, count: int) -> str:
    """Return what a stage is called."""
    if stage == 0:
        return "from the start" if count > 1 else "the whole run"
    words = {"lost": "lost", "left": "gone", "joined": "there"}
    if at.kind in words:
        return f"{at.robot} {words[at.kind]}"
    return "new aim" if at.kind == "aim" else "new weather"


def track(
    run: Run,
    verdict: Verdict,
    *,
    index: int = 0,
    terms: Terms = SI,
    width: float = style.WIDTH,
    ax: Axes | None = None,
) -> Figure:
    """Draw where the object went, in the earth's frame.

    A line for the way of its origin, coloured by what had happened; the object as it lay at the
    beginning of each stage, along long ways, and at the end; where it was to be, dashed; and
    circles that hold all of a stage in which that stayed the same.

    Parameters
    ----------
    run : Run
    verdict : Verdict
        Of the run.
    index : int
        Which of the runs.
    terms : Terms
        The units, the frame and the words in which it is told.
    width : float [in]
        Of the figure.
    ax : Axes, optional
        Draw here, at its present size, instead of in a figure of its own.

    Returns
    -------
    Figure
    """
    with style.settings(width, terms):
        stages = stages_of(run, verdict, index)
        low, high = _box(run, stages, index)
        ax = _new_axes(low, high, len(stages)) if ax is None else ax
        page = _frame(ax, low, high)
        _draw_reference(page, run)
        for stage in stages:
            _draw_stage(page, run, stage, index)
        _draw_wind(page, run, index)
        _draw_end(page, run, index)
        _write_legend(ax, stages)
        return cast(Figure, ax.get_figure(root=True))


def height_of(run: Run, verdict: Verdict, index: int, width: float) -> float:
    """Return the height [in] that suits the axes of a track of some width [in]."""
    low, high = _box(run, stages_of(run, verdict, index), index)
    return float(np.clip(width * (high[1] - low[1]) / (high[0] - low[0]), *HEIGHTS))


def legend_columns() -> int:
    """Return how many columns of stages the page is wide enough for."""
    return 2 if style.width() >= TWO_COLUMNS else 1


def _new_axes(low: Vector, high: Vector, stages: int) -> Axes:
    """Return axes in a figure with room for the legend."""
    left, right, top, bottom = 0.6, 0.14, 0.12, 0.5 + 0.17 * math.ceil(stages / legend_columns())
    width = style.width() - left - right
    height = float(np.clip(width * (high[1] - low[1]) / (high[0] - low[0]), *HEIGHTS))
    total = height + top + bottom
    figure = Drawn(figsize=(style.width(), total))
    return figure.add_axes(
        (left / style.width(), bottom / total, width / style.width(), height / total)
    )


def _outlines(run: Run, poses: Any) -> Vector:
    """Return the outline (k, c, 2) [m, m] at poses (k, 3)."""
    outline = run.simulation.problem.swarm.outline
    corners = outline.vertices - outline.origin
    x, y, turn = np.reshape(np.asarray(poses, float), (-1, 3)).T[:, :, None]
    cos, sin = np.cos(turn), np.sin(turn)
    return np.stack(
        [x + cos * corners[:, 0] - sin * corners[:, 1],
         y + sin * corners[:, 0] + cos * corners[:, 1]], axis=-1,
    )  # fmt: skip


def _box(run: Run, stages: tuple[Stage, ...], index: int) -> tuple[Vector, Vector]:
    """Return the corners (2,) [m, m] round all that is drawn."""
    points = [_outlines(run, run.poses[index]), _outlines(run, run.references)]
    for stage in stages:
        if _is_still(run, stage):
            middle = run.references[stage.rows][0, :2]
            points.append(np.array([[middle - stage.distance, middle + stage.distance]]))
    every = np.concatenate([np.reshape(p, (-1, 2)) for p in points])
    low, high = every.min(axis=0), every.max(axis=0)
    room = MARGIN * float((high - low).max())
    return low - room, high + room


def _frame(ax: Axes, low: Vector, high: Vector) -> Page:
    """Set equal axes whose limits fill the axes' box and leave room for the wind at the top."""
    page = Page(ax)
    box = np.array([ax.bbox.width, ax.bbox.height])
    strip = np.array([0.0, WIND_ROW * page.point_size])
    metres = float(np.max((high - low) / (box - strip)))
    middle = 0.5 * (low + high + strip * metres)
    (left, bottom), (right, top) = middle - 0.5 * metres * box, middle + 0.5 * metres * box
    ax.set(xlim=(left, right), ylim=(bottom, top))
    ax.set_aspect("equal", adjustable="box")
    tick_axes(ax, (max(3, round(style.width() / 0.62)), 6))
    return page


def _draw_reference(page: Page, run: Run) -> None:
    """Draw where the object was to be: its way, and its outline at the start and at the end."""
    ways = run.references
    look: dict[str, Any] = {"color": style.GREY, "linewidth": 0.8, "linestyle": (0, (4, 3))}
    page.ax.plot(ways[:, 0], ways[:, 1], **look, zorder=2, gid="reference")
    for corners in _outlines(run, ways[[0, -1]]):
        page.ax.add_patch(Polygon(corners, fill=False, **look, zorder=2))


def _draw_stage(page: Page, run: Run, stage: Stage, index: int) -> None:
    """Draw a stage: the object at its beginning, its way, and its circle."""
    poses = run.poses[index, stage.rows]
    extent = run.simulation.problem.swarm.outline.extent
    gone = np.hypot(*np.diff(poses[:, :2], axis=0).T).cumsum()
    marks = np.arange(1, MOST_SHOWN) * max(
        APART * extent, float(gone.max(initial=0.0)) / MOST_SHOWN
    )
    rows = np.searchsorted(gone, marks[marks < gone.max(initial=0.0)])
    for corners in _outlines(run, poses[[0, *rows.tolist()]]):
        page.ax.add_patch(
            Polygon(corners, facecolor=style.PALE, edgecolor=stage.colour, linewidth=0.8,
                    alpha=0.6, zorder=3)
        )  # fmt: skip
    page.ax.plot(*poses[:, :2].T, **stage.line, zorder=6, gid="way")
    if _is_still(run, stage):
        x, y = run.references[stage.rows][0, :2].tolist()
        page.ax.add_patch(
            Ring((x, y), stage.distance, fill=False, color=stage.colour, linewidth=1.0, zorder=5,
                 gid="circle")
        )  # fmt: skip


def _is_still(run: Run, stage: Stage) -> bool:
    """Tell whether the place where the object was to be stays the same in a stage."""
    moved = np.ptp(run.references[stage.rows][:, :2], axis=0).max(initial=0.0)
    return bool(moved <= STILL * run.simulation.problem.swarm.outline.extent)


def _draw_end(page: Page, run: Run, index: int) -> None:
    """Draw the object as it lies at the end, with the robots that hold it."""
    (corners,) = _outlines(run, run.poses[index, -1])
    page.ax.add_patch(Polygon(corners, fill=False, edgecolor=style.INK, linewidth=1.3, zorder=4))
    for start, end in itertools.pairwise(np.vstack([corners, corners[:1]])):
        page.keep_clear(start, end)
    swarm = run.stints[-1].swarm
    x, y, turn = run.poses[index, -1].tolist()
    cos, sin = math.cos(turn), math.sin(turn)
    off = np.reshape([robot.contact for robot in swarm], (-1, 2)) - swarm.outline.origin
    spots = off @ np.array([[cos, sin], [-sin, cos]]) + np.array([x, y])
    page.ax.plot(*spots.T, "o", markersize=3.5, color=style.INK, linestyle="none", zorder=6)
    for robot, spot, way in zip(swarm, spots, spots - np.array([x, y]), strict=True):
        page.label(
            robot.name, spot[None], math.atan2(way[1], way[0]), optional=True, fontsize=7.0,
            color=style.INK, gid="robot-label",
        )  # fmt: skip


def _draw_wind(page: Page, run: Run, index: int) -> None:
    """Draw the wind, its mean over the run, in the corner."""
    wind = np.asarray(run.streams[index, :, :2], float).mean(axis=0)
    speed = float(np.hypot(*wind))
    if speed == 0.0:
        return
    inverse, box, size = page.ax.transData.inverted(), page.ax.bbox, page.point_size
    middle = np.array([box.x1 - 16.0 * size, box.y1 - 16.0 * size])
    way = 11.0 * size * wind / speed
    ends = [(inverse.transform(middle - way), inverse.transform(middle + way))]
    draw_arrows(page.ax, ends, color=style.GREY, width=0.02, gid="wind")
    from_ = math.radians(round(math.degrees(math.pi - math.atan2(wind[1], wind[0]))))
    text = f"{speed / KNOT:.0f} kn" if speed > 2.0 else f"{speed:.2g} m/s"
    varies = np.ptp(run.streams[index, :, :2], axis=0).max() > CALM * speed
    text = f"{'mean wind' if varies else 'wind'} {text} {written.from_words(from_)}"
    artist = page.ax.annotate(
        text,
        (1.0, 1.0),
        xycoords="axes fraction",
        xytext=(-32.0, -16.0),
        textcoords="offset points",
        ha="right",
        va="center",
        fontsize=style.text(8.0),
        color=style.GREY,
    )
    page.boxes.append(artist.get_window_extent().extents)
    page.keep_clear(*ends[0], breadth=12.0)


def _write_legend(ax: Axes, stages: tuple[Stage, ...]) -> None:
    """Write what each stage is, and within what the object was."""
    handles: list[Any] = [
        Line2D([], [], **stage.line,
               label=f"{stage.words}: {written.length(stage.distance)}, "
               f"{written.number(math.degrees(stage.turn))}°")
        for stage in stages
    ]  # fmt: skip
    handles.append(
        Line2D([], [], color=style.GREY, linewidth=0.8, linestyle=(0, (4, 3)), label="wanted")
    )
    page = Page(ax)
    ax.legend(
        handles=handles, ncols=legend_columns(), loc="upper left", borderaxespad=0.0, borderpad=0.0,
        bbox_to_anchor=(0.0, -34.0 * page.point_size / ax.bbox.height), labelspacing=0.35,
    )  # fmt: skip
