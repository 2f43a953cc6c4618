"""The landscape: the quality a newcomer would bring, over every contact and direction."""

import math
import textwrap
from collections.abc import Sequence
from typing import Any, Final, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection
from matplotlib.figure import Figure
from matplotlib.patches import Rectangle
from matplotlib.patheffects import withStroke
from matplotlib.ticker import MaxNLocator
from numpy.typing import NDArray

from swarmgrasp.outline import Outline
from swarmgrasp.placement import Placement, Problem, cell_qualities
from swarmgrasp.plot import style, written
from swarmgrasp.plot.coordinates import Scale
from swarmgrasp.plot.figure import Drawn
from swarmgrasp.plot.sheet import Caption
from swarmgrasp.terms import SI, Terms
from swarmgrasp.units import LENGTHS
from swarmgrasp.words import TIMES

COLOURS: Final = "cividis"
"""Even in lightness, and the same to every kind of colour vision."""

LEVELS: Final = 7
"""Contour lines, about."""

BOX: Final = (0.6, 0.58, 2.4)
"""Left, bottom and height of the axes [in], before title and small print."""

BESIDE: Final = 0.78
"""Room for the colour bar on the right of the axes [in]."""

ABOVE: Final = (0.3, 0.16)
"""Room for the names of the edges, and for a line above them [in]."""

PRINT_ROW: Final = 0.132
"""Height of a line of the small print [in]."""

RIGHT: Final = 0.99
"""Where the label of the colour bar ends, in shares of the figure."""

MOST_CORNERS: Final = 14
"""With more corners than this the boundary is ticked at round distances instead."""

NEAR: Final = 0.085
"""Corners closer than this share of the boundary share one number."""

HALO: Final = [withStroke(linewidth=2.2, foreground="#00000070")]
"""Makes a white line readable on every colour."""


def landscape(
    subject: Placement | Problem,
    *,
    resolution: tuple[int, int] = (180, 90),
    terms: Terms = SI,
    title: str = "",
    width: float = style.WIDTH,
) -> Figure:
    """Draw the quality after adding the newcomer at each contact, in each direction.

    The vertical axis is the absolute direction of the force and not its angle to the
    normal. The quality depends on contact and force alone, so over the absolute direction
    it is continuous round the whole boundary; over the angle to the normal it would jump
    at every corner, and a round hull of many edges would show a saw. The inward normals
    are drawn as white lines instead. Directions wrap round: the top is the bottom.

    Parameters
    ----------
    subject : Placement or Problem
        With a placement its robot and its runners-up are marked.
    resolution : tuple of int
        Cells along the boundary and over the directions. A cell shows the best of the
        allowed contacts and directions sampled in it, so that bollards and directions
        exactly along the normal are seen too.
    terms : Terms
        The units, the frame and the words in which it is told.
    title : str
        Such as the name of the object.
    width : float [in]

    Returns
    -------
    Figure

    Raises
    ------
    NowhereToAttach
        If the problem leaves no boundary point to the newcomer.
    """
    placement = subject if isinstance(subject, Placement) else None
    problem = subject.problem if isinstance(subject, Placement) else subject
    outline = problem.swarm.outline
    grid = cell_qualities(problem, resolution)
    low, high = float(np.nanmin(grid)), float(np.nanmax(grid))
    if placement is not None:  # the best place may lie between the middles of cells
        low, high = min(low, placement.quality_before), max(high, placement.quality)
    with style.settings(width, terms):
        unit = written.unit_of(high, criterion=problem.criterion)
        words = problem.criterion.words(problem.swarm, terms.robot)
        ax = _new_axes(title, _title(subject), words, _small_print(subject))
        _draw_values(
            ax,
            grid / unit.newtons,
            (low / unit.newtons, high / unit.newtons),
            outline.perimeter,
            unit.name,
        )
        _draw_normals(ax, outline)
        _name_boundary(ax, outline)
        if placement is not None:
            _mark(ax, placement)
        _tick_directions(ax)
    return cast(Figure, ax.figure)


def _new_axes(heading: str, title: str, words: str, small_print: Sequence[str]) -> Axes:
    """Return an axes in a figure, with what is written above and below it."""
    left, bottom, height = BOX
    width = style.width() - left - BESIDE
    caption = Caption(heading, title, words, (), tuple(small_print))
    bottom += PRINT_ROW * len(caption.print_lines)
    rows = [*caption.headings, *caption.lines]
    total = bottom + height + ABOVE[0] + ABOVE[1] * len(rows)
    figure = Drawn(figsize=(style.width(), total))
    across, up = 1.0 / style.width(), 1.0 / total
    looks: list[dict[str, Any]] = [
        *(
            {"fontsize": style.text(10.0), "weight": "bold", "gid": "heading"}
            for _ in caption.headings
        ),
        *({"gid": "title"} for _ in range(caption.title_lines)),
    ]
    below: dict[str, Any] = {"fontsize": style.text(7.5), "color": style.GREY, "gid": "criterion"}
    for row, line in enumerate(rows):
        look = looks[row] if row < len(looks) else below
        figure.text(left * across, 1.0 - (0.2 + ABOVE[1] * row) * up, line, **look)
    figure.text(
        left * across,
        0.06 * up,
        "\n".join(caption.print_lines),
        fontsize=style.text(7.0),
        color=style.GREY,
        linespacing=1.2,
        gid="small-print",
    )
    return figure.add_axes((left * across, bottom * up, width * across, height * up))


def _title(subject: Placement | Problem) -> str:
    """Return the picture in a line."""
    problem = subject.problem if isinstance(subject, Placement) else subject
    title = f"+{written.force(problem.newcomer.limit)}, {problem.newcomer.attachment}"
    if not isinstance(subject, Placement):
        return title
    gain = written.gain(subject.quality_before, subject.quality, problem.criterion)
    return f"{title}: {gain}"


def _small_print(subject: Placement | Problem) -> list[str]:
    """Return what the picture's numbers and marks mean, in lines."""
    problem = subject.problem if isinstance(subject, Placement) else subject
    lines = [f"Quality with {written.metric(problem.swarm)}."]
    if problem.criterion.has_load:
        lines.append(written.load_sentence(problem.criterion.load, problem.swarm))
    marks = "White lines: inward normals."
    if isinstance(subject, Placement):
        others = ", dots: runners-up" if subject.runners_up else ""
        marks = f"Star: the answer{others}. {marks}"
    lines.append(marks)
    if problem.is_tolerant:
        lines.append(
            "Colours: as if the newcomer hit its place exactly; the answer's quality is the worst "
            "of where it may end up."
        )
    return lines


def _draw_values(
    ax: Axes,
    grid: NDArray[np.float64],
    scale: tuple[float, float],
    perimeter: float,
    unit: str,
) -> None:
    """Draw the qualities as colours and contour lines, hatching where nothing is allowed.

    Parameters
    ----------
    ax : Axes
    grid : (columns, rows) [unit]
    scale : tuple of float [unit]
        The qualities of the darkest and of the brightest colour.
    perimeter : float [m]
    unit : str
    """
    look: dict[str, Any] = {"facecolor": "#F4F4F4", "edgecolor": "#C4C4C4", "hatch": "////"}
    ax.add_patch(Rectangle((0.0, -180.0), perimeter, 360.0, zorder=0, linewidth=0.0, **look))
    low, high = scale
    flat = high - low <= 1e-9 * high
    image = ax.imshow(
        grid.T, origin="lower", aspect="auto", cmap=COLOURS, interpolation="nearest", zorder=1,
        extent=(0.0, perimeter, -180.0, 180.0), vmin=low, vmax=1.0 + low if flat else high,
    )  # fmt: skip
    ax.set(xlim=(0.0, perimeter), ylim=(-180.0, 180.0))
    if flat:
        value = f"{written.number(low)} {unit} everywhere"
        paper = {"boxstyle": "round", "facecolor": "white", "linewidth": 0.0, "alpha": 0.9}
        ax.text(
            0.5, 0.5, value, transform=ax.transAxes, bbox=paper, ha="center", va="center", zorder=6
        )
        return
    room = ax.inset_axes((1.03, 0.0, 0.035, 1.0))
    bar = cast(Figure, ax.figure).colorbar(image, cax=room)
    label = "quality with the newcomer"
    bar.set_label(label if unit == TIMES else f"{label} [{unit}]")
    bar.formatter.set_useOffset(False)  # type: ignore[attr-defined]
    _make_room(ax, room)
    levels = np.asarray(MaxNLocator(LEVELS).tick_values(low, high))
    levels = levels[(levels > low) & (levels < high)]
    room.hlines(levels, 0.0, 1.0, colors="white", linewidth=0.5, alpha=0.8)
    _draw_contours(ax, grid, perimeter, levels)


def _make_room(ax: Axes, room: Axes) -> None:
    """Narrow the axes until the colour bar in `room` ends, with its label, on the page."""
    figure = cast(Figure, ax.figure)
    for _ in range(2):  # the bar itself narrows too
        figure.draw_without_rendering()
        drawn = room.get_tightbbox()
        beyond = 0.0 if drawn is None else drawn.x1 / figure.bbox.width - RIGHT
        x, y, width, height = ax.get_position().bounds
        if beyond > 0.0:
            ax.set_position((x, y, width - beyond, height))


def _draw_contours(
    ax: Axes, grid: NDArray[np.float64], perimeter: float, levels: NDArray[np.float64]
) -> None:
    """Draw lines of equal quality through the middles of the cells."""
    levels = levels[(levels > np.nanmin(grid)) & (levels < np.nanmax(grid))]
    if not (_has_area(grid) and len(levels)):
        return
    x, y = ((np.arange(n) + 0.5) / n for n in grid.shape)
    ax.contour(
        x * perimeter, y * 360.0 - 180.0, np.ma.masked_invalid(grid).T,
        levels=levels, colors="white", linewidths=0.5, alpha=0.8, zorder=2,
    )  # fmt: skip


def _has_area(grid: NDArray[np.float64]) -> bool:
    """Tell whether four neighbouring cells are known somewhere, as contours need."""
    known = np.isfinite(grid)
    return bool((known[:-1, :-1] & known[1:, :-1] & known[:-1, 1:] & known[1:, 1:]).any())


def _draw_normals(ax: Axes, outline: Outline) -> None:
    """Draw the direction of the inward normal along every edge, and the corners."""
    lines = []
    for edge in range(len(outline)):
        start, end = outline.corner_arc_lengths[edge : edge + 2]
        inward = math.degrees(outline.inward_normal(edge))
        angles = (inward, inward - 360.0) if inward > 179.0 else (inward,)
        lines += [[(start, angle), (end, angle)] for angle in angles]
    ax.add_collection(
        LineCollection(
            lines, colors="white", linewidths=1.0, zorder=3, capstyle="butt", path_effects=HALO
        ),
        autolim=False,
    )
    if len(outline) <= MOST_CORNERS:
        for corner in outline.corner_arc_lengths[1:-1]:
            ax.axvline(corner, color="white", linewidth=0.7, linestyle=(0, (2, 2)), zorder=2.5)


def _name_boundary(ax: Axes, outline: Outline) -> None:
    """Tick the corners by arc length and write the edges' names above them."""
    terms = style.terms()
    is_clockwise = terms.frame.mirrored
    sense = "clockwise" if is_clockwise else "counter-clockwise"
    words = f"along the boundary, {sense} from the first corner [{terms.length}]"
    ax.set_xlabel(textwrap.fill(words, int(72.0 * (style.width() - BOX[0]) / 4.9)))
    ax.xaxis.set_inverted(is_clockwise)
    metres = LENGTHS[terms.length]
    scale = Scale(-metres, outline.perimeter) if is_clockwise else Scale(metres)
    if len(outline) > MOST_CORNERS:
        scale.put_on(ax.xaxis, MOST_CORNERS // 2)
        return
    near = NEAR * outline.perimeter * max(1.0, style.WIDTH / style.width())
    ticks = [0.0, outline.perimeter]
    for corner in outline.corner_arc_lengths[1:-1]:
        if min(abs(corner - tick) for tick in ticks) > near:
            ticks.append(float(corner))
    digits = max(0, 2 - math.floor(math.log10(outline.perimeter / metres)))
    ax.set_xticks(ticks, [f"{scale.told(tick) + 0.0:.{digits}f}" for tick in ticks])
    ax.set_xticks(outline.corner_arc_lengths, minor=True)
    for edge in range(len(outline)):
        start, end = outline.corner_arc_lengths[edge : edge + 2]
        artist = ax.text(
            0.5 * (start + end), 1.02, outline.edge_label(edge), ha="center", va="bottom",
            transform=ax.get_xaxis_transform(), fontsize=style.text(7.0), fontstyle="italic",
            color=style.GREY, gid="edge-label",
        )  # fmt: skip
        room = (end - start) / outline.perimeter * ax.bbox.width
        if artist.get_window_extent().width > room:
            artist.remove()


def _tick_directions(ax: Axes) -> None:
    """Tick the directions as the file counts them, or as bearings, and let them grow upwards."""
    tell = written.telling()
    is_clockwise = tell.terms.bearings or tell.terms.frame.mirrored
    said = "bearing" if tell.terms.bearings else "direction"
    ax.set_ylabel(f"{said} of the force [°]")
    ticks = range(-180, 181, 90)
    words = [tell.short(math.radians(tick)).replace("-", "\u2212") for tick in ticks]
    ax.set_yticks(ticks, words)
    ax.set_yticks(range(-180, 181, 30), minor=True)
    ax.yaxis.set_inverted(is_clockwise)


def _mark(ax: Axes, placement: Placement) -> None:
    """Mark the best contact and direction, and those of the runners-up."""
    outline = placement.problem.swarm.outline
    chosen = [(runner.robot, "o", 5.0, style.ORANGE) for runner in placement.runners_up]
    chosen.append((placement.robot, "*", 13.0, style.VERMILION))
    for robot, marker, size, colour in chosen:
        ax.plot(
            outline.at_point(robot.contact).arc_length,
            math.degrees(math.remainder(robot.direction, 2.0 * math.pi)),
            marker, color=colour, markersize=size, markeredgecolor="white",
            markeredgewidth=0.8, clip_on=False, zorder=5,
            gid="best" if marker == "*" else "runner-up",
        )  # fmt: skip
