"""A picture of thrust use: the part of its limit that each robot needs, by bearing."""

from typing import Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from swarmgrasp.capability import ThrustUse
from swarmgrasp.plot import all_round, polar, style, written
from swarmgrasp.plot.figure import Drawn
from swarmgrasp.terms import SI, Terms

MOST_ROWS: Final = 40
"""Robots that have a row each; of more, the busiest."""
ROW: Final = 0.2
"""Height of a row [in]."""
CURVE: Final = 1.5
"""Height of the curve of the busiest [in]."""
LEFT: Final = 1.35
"""Room for names [in]."""
LONGEST_NAME: Final = 18


def thrust_use_picture(
    found: ThrustUse, title: str = "", *, terms: Terms = SI, width: float = style.WIDTH
) -> Figure:
    """Draw thrust use over bearings: the busiest robot's share, and below it every robot's.

    Parameters
    ----------
    found : ThrustUse
    title : str
        Such as the vessel's name.
    terms : Terms
        The units, the frame and the words in which it is told; bearings are true with a heading.
    width : float [in]

    Returns
    -------
    Figure
    """
    chosen = np.argsort(-found.shares.max(axis=0, initial=0.0), kind="stable")[:MOST_ROWS]
    chosen = np.sort(chosen)
    rows = max(1, len(chosen))
    with style.settings(width, terms):
        told = np.array([written.telling().from_degrees(b) for b in found.bearings])
        order = np.argsort(told, kind="stable")
        foot = 0.98
        height = 0.5 + CURVE + 0.12 + ROW * rows + foot
        figure = Drawn(figsize=(width, height))
        room = width - LEFT - 0.75

        def axes(bottom: float, tall: float) -> Axes:
            """Return axes from a height [in] up."""
            return figure.add_axes((LEFT / width, bottom / height, room / width, tall / height))

        degrees = told[order]
        _draw_busiest(axes(foot + ROW * rows + 0.12, CURVE), found, degrees, order)
        _draw_all(figure, axes(foot, ROW * rows), found, degrees, order, chosen)
        _write(figure, found, (title, terms.robot), height)
    return figure


def _draw_busiest(
    ax: Axes, found: ThrustUse, degrees: NDArray[np.float64], order: NDArray[np.int64]
) -> None:
    """Draw the share of the busiest robot, and where the weather is not held."""
    largest = 100.0 * found.largest[order]
    ends, shares = np.append(degrees, degrees[0] + 360.0), np.append(largest, largest[0])
    held = np.append(found.held[order], found.held[order][0])
    ax.plot(ends, np.where(held, shares, np.nan), color=style.BLUE, linewidth=1.6, gid="busiest")
    ax.fill_between(
        ends, 0.0, 105.0, where=(~held).tolist(), step="mid", facecolor="white",
        edgecolor=style.VERMILION, hatch="////", linewidth=0.0, gid="not-held",
    )  # fmt: skip
    ax.axhline(100.0, color=style.INK, linewidth=0.8, linestyle=(0, (2, 2)))
    ax.set(xlim=(0.0, 360.0), ylim=(0.0, 105.0), yticks=[0, 25, 50, 75, 100])
    ax.set_ylabel("busiest [%]")
    ax.set_xticks(range(0, 361, 45), [])
    ax.grid(visible=True)
    for side in ("top", "right"):
        ax.spines[side].set_visible(False)


def _draw_all(
    figure: Figure, ax: Axes, found: ThrustUse, degrees: NDArray[np.float64],
    order: NDArray[np.int64], chosen: NDArray[np.int64],
) -> None:  # fmt: skip
    """Draw the share of each robot, darker for more."""
    shares = np.clip(100.0 * found.shares[np.ix_(order, chosen)].T, 0.0, 100.0)
    shares = np.where(found.held[order][None, :], shares, np.nan)
    gaps = np.diff(np.append(degrees, degrees[0] + 360.0))
    edges = np.concatenate([[degrees[0] - 0.5 * gaps[-1]], degrees + 0.5 * gaps])
    mesh = ax.pcolormesh(
        edges, np.arange(len(chosen) + 1), shares, cmap="Blues", vmin=0.0, vmax=100.0,
        edgecolors="face", linewidth=0.1, rasterized=False, gid="shares",
    )  # fmt: skip
    wraps = edges[0] + 360.0
    if edges[0] < 0.0 and wraps < 360.0:  # the first bearing again, at the right end
        ax.pcolormesh(
            [wraps, 360.0], np.arange(len(chosen) + 1), shares[:, :1], cmap="Blues", vmin=0.0,
            vmax=100.0,
        )  # fmt: skip
    ax.set_facecolor("#F4DDD0")
    ax.set(xlim=(0.0, 360.0), ylim=(len(chosen), 0.0))
    bow, words = polar.quarters()
    quarters = [f"{bearing}° {word}" for bearing, word in words.items()]
    ax.set_xticks(range(0, 361, 90), [*quarters, "360°"])
    if bow:
        ax.plot([bow], [0.0], "v", color=style.INK, markersize=4.0, clip_on=False, gid="bow")
    names = [polar.cut(found.swarm.names[i], LONGEST_NAME) for i in chosen]
    ax.set_yticks(np.arange(len(chosen)) + 0.5, names)
    ax.tick_params(length=0)
    ax.set_xlabel(
        f"where it comes from, {polar.from_words().replace('bow up, at', 'the bow is at')}"
    )
    box = ax.get_position()
    bar = figure.colorbar(
        mesh, cax=figure.add_axes((box.x1 + 0.02, box.y0, 0.018, box.height)), ticks=[0, 50, 100]
    )
    bar.ax.set_yticklabels(["0 %", "50 %", "100 %"])
    bar.outline.set_visible(False)


def _write(figure: Figure, found: ThrustUse, words: tuple[str, str], height: float) -> None:
    """Write the title, the wind, and what was taken into account."""
    (title, robot), top = words, height - 0.2
    heading = polar.cut(title, polar.LONGEST_TITLE) or "Thrust use"
    polar.write(figure, heading, 0.12, top, size=10.0, weight="bold", gid="heading")
    said = f"Part of each {robot}'s limit used in {written.speed(found.speed)}"
    if not found.held.all():
        said += "; hatched: not held"
    polar.write(figure, said, 0.12, top - 0.17, size=9.0, color=style.GREY, gid="title")
    factor = found.environment.dynamic_factor
    around = all_round.water_words(found.environment)
    polar.write(figure, all_round.drag_words(found.environment), 0.12, 0.34, size=7.0,
                color=style.GREY)  # fmt: skip
    allowance = f"loads times {factor:g}" if factor != 1.0 else "steady loads"
    polar.write(figure, f"{around}; {allowance}.", 0.12, 0.19, size=7.0, color=style.GREY)
