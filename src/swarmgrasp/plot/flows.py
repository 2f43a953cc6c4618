"""Wind, current and sea on a plan: an arrow the way each of them goes, and words."""

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.environment import Environment
from swarmgrasp.outline import Outline
from swarmgrasp.plot import style, written
from swarmgrasp.plot.arrows import draw_arrows
from swarmgrasp.plot.labels import Page

ROW: Final = 24.0
"""Height of a row [pt]: the arrow, whichever way it goes, and a gap."""

ARROW: Final = 20.0
"""Length of an arrow [pt]."""

LETTER: Final = 4.9
"""Width of a letter [pt], at most on average."""

LOOKS: Final[dict[str, dict[str, Any]]] = {
    "wind": {"color": style.INK, "width": 0.028},
    "current": {"facecolor": "white", "edgecolor": style.INK, "linewidth": 0.9, "width": 0.034},
    "sea": {"facecolor": "#BBBBBB", "edgecolor": style.INK, "linewidth": 0.7, "width": 0.05},
}
"""The arrow of each kind: filled, hollow, and broad and grey."""


@dataclass(frozen=True)
class Flow:
    """What blows or flows.

    Attributes
    ----------
    kind : {"wind", "current", "sea"}
    words : str
        Its speed and where it comes from.
    toward : float [rad]
        The way it goes, on the plan.
    """

    kind: str
    words: str
    toward: float


def flows_of(
    environment: Environment | None, outline: Outline, load: ArrayLike
) -> tuple[Flow, ...]:
    """Return wind, current and sea, if a load is theirs.

    Parameters
    ----------
    environment : Environment or None
    outline : Outline
    load : (3,) [N, N, N m]
        On the object; of something else nothing is drawn.
    """
    if environment is None or not environment.exerts(outline, load):
        return ()
    wind, current, waves = environment.wind, environment.current, environment.waves
    from_, speed = wind.bearing or 0.0, wind.speed or 0.0
    found = [_flow("wind", written.speed(speed), from_)] if speed else []
    if current is not None and current.speed:
        bearing = from_ if current.bearing is None else current.bearing
        found.append(_flow("current", written.speed(current.speed), bearing))
    if waves is not None:
        bearing = from_ if waves.bearing is None else waves.bearing
        size = "of that wind"
        if waves.height is not None and waves.period is not None:
            size = f"{written.length(waves.height)}, {waves.period:.3g} s"
        found.append(_flow("sea", size, bearing))
    return tuple(found)


def height_of(flows: tuple[Flow, ...]) -> float:
    """Return the height [pt] that flows take at the top of a plan."""
    return ROW * len(_rows(flows, 72.0 * (style.width() - 0.74)))


def draw_flows(page: Page, flows: tuple[Flow, ...]) -> None:
    """Draw flows at the top of a plan, from left to right."""
    size, box, inverse = page.point_size, page.ax.bbox, page.ax.transData.inverted()
    y = box.y1 - 0.5 * ROW * size
    for row in _rows(flows, 72.0 * (style.width() - 0.74)):
        x = box.x0 + 0.7 * ARROW * size
        for flow in row:
            way = 0.5 * ARROW * size * np.array([math.cos(flow.toward), math.sin(flow.toward)])
            middle = np.array([x, y])
            ends = inverse.transform([middle - way, middle + way])
            draw_arrows(page.ax, [(ends[0], ends[1])], **LOOKS[flow.kind], gid=flow.kind)
            left, height = inverse.transform((x + 0.7 * ARROW * size, y)).tolist()
            artist = page.ax.text(
                left,
                height,
                f"{flow.kind} {flow.words}",
                ha="left",
                va="center",
                fontsize=style.text(8.0),
                color=style.INK,
                gid="flow-label",
                zorder=6,
            )
            area = artist.get_window_extent()
            half = 0.6 * ARROW * size
            page.boxes += [area.extents, (x - half, y - half, x + half, y + half)]
            x += 2.0 * ARROW * size + area.width
        y -= ROW * size


def _rows(flows: tuple[Flow, ...], room: float) -> list[list[Flow]]:
    """Return the flows of each row, as many as fit into the room [pt]."""
    rows: list[list[Flow]] = []
    taken = math.inf
    for flow in flows:
        need = 2.0 * ARROW + style.text(LETTER) * len(f"{flow.kind} {flow.words}")
        if taken + need > room:
            rows, taken = [*rows, []], 0.0
        rows[-1].append(flow)
        taken += need
    return rows


def _flow(kind: str, words: str, bearing: float) -> Flow:
    """Return what comes from a bearing [rad], clockwise from the bow."""
    return Flow(kind, f"{words} {written.from_words(bearing)}", math.pi - bearing)
