"""The plan view of push forces: who pushes how hard to make a wrench."""

from typing import Any, Final, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.collections import PolyCollection
from matplotlib.colors import to_rgba
from matplotlib.figure import Figure
from matplotlib.patches import Patch
from numpy.typing import NDArray

from swarmgrasp.environment import Environment
from swarmgrasp.forces import Forces
from swarmgrasp.plot import style, written
from swarmgrasp.plot.arrows import ArrowEntry, Arrows, draw_arrows, has_area
from swarmgrasp.plot.direction import Pointer, load_pointer
from swarmgrasp.plot.flows import Flow, flows_of
from swarmgrasp.plot.labels import Page
from swarmgrasp.plot.plan import draw_object, in_view, label_edges
from swarmgrasp.plot.robots import FEW, HEAD, MOST_LABELS, outer_spots
from swarmgrasp.plot.sheet import Caption, draw_force_key, frame, new_axes, write_caption
from swarmgrasp.terms import SI, Terms
from swarmgrasp.words import wrench_words

LIMIT: Final = "#C3D3E0"
"""Colour of what a robot could exert."""

WIDTH: Final = 0.026
"""Of the arrows [in]."""

AREA_LOOK: Final[dict[str, Any]] = {
    "facecolor": to_rgba(LIMIT, 0.3),
    "edgecolor": LIMIT,
    "linewidth": 0.8,
}
"""Of all that a robot can exert."""

LEAST_SHARE: Final = 0.002
"""Share below which no force is drawn."""

HARDEST: Final = 2e-6
"""Difference from the largest share that counts as none: twice what the least squares may take."""


def forces_plan(
    found: Forces,
    *,
    environment: Environment | None = None,
    terms: Terms = SI,
    title: str = "",
    width: float = style.WIDTH,
    ax: Axes | None = None,
) -> Figure:
    """Draw the object from above with the forces that make a wrench.

    A pale arrow is the force a robot can exert, the dark part of it the one it does; of robots that
    steer, or have friction or an envelope, all their forces are a pale area. Robots at the
    largest share are orange. A push ends at the contact, a pull starts there. At the origin are
    drawn the wanted wrench, and the load, whose arrow ends there: to the same scale, or hollow
    where they only show a direction, as turns always do.

    Parameters
    ----------
    found : Forces
    environment : Environment, optional
        Draws wind, current and sea, if the load is theirs.
    terms : Terms
        The units, the frame and the words in which it is told.
    title : str
        Such as the name of the object.
    width : float [in]
        Of a figure of its own.
    ax : Axes, optional
        Draw here, at its present size, instead of in a figure of its own.

    Returns
    -------
    Figure
    """
    swarm = found.swarm
    arrows = Arrows(swarm.outline, swarm.robots)
    with style.settings(width, terms):
        pointers = _pointers(arrows, found)
        flows = flows_of(environment, swarm.outline, found.load)
        caption = _caption(found, pointers, flows, title)
        alone = ax is None
        ax = new_axes(arrows, caption) if ax is None else ax
        page = frame(ax, arrows, flows, has_table=alone)
        draw_object(page, swarm.outline)
        _draw_forces(page, arrows, found)
        for gid, pointer in pointers.items():
            pointer.draw(page, gid, pointers.values())
        _label_robots(page, arrows, found)
        label_edges(page, swarm.outline)
        draw_force_key(page, arrows)
        write_caption(page, caption)
        return cast(Figure, ax.get_figure(root=True))


def _hardest(found: Forces) -> NDArray[np.bool_]:
    """Tell which robots have the largest share."""
    top = found.largest_share
    return np.asarray((found.shares >= top - HARDEST) & (top > LEAST_SHARE))


def _is_pushing(found: Forces) -> NDArray[np.bool_]:
    """Tell which robots exert a force that is drawn."""
    return np.asarray(found.forces > LEAST_SHARE * found.swarm.limits)


def _draw_forces(page: Page, arrows: Arrows, found: Forces) -> None:
    """Draw every robot's limit, its force, and a mark at its contact."""
    robots = arrows.robots
    width = 0.6 * WIDTH if len(robots) > MOST_LABELS else WIDTH
    limits = [shaft for robot in robots if not has_area(robot) for shaft in arrows.shafts(robot)]
    for tail, tip in limits:
        page.keep_clear(tail, tip, breadth=HEAD * width)
    draw_arrows(page.ax, limits, color=LIMIT, width=width, gid="limit", zorder=3.5)
    areas = [area for robot in robots if has_area(robot) for area in arrows.areas(robot)]
    page.ax.add_collection(PolyCollection(areas, **AREA_LOOK, zorder=3.4, gid="limit-area"))
    hardest = _hardest(found)
    for is_hardest, colour, gid in (
        (False, style.BLUE, "force"),
        (True, style.VERMILION, "hardest"),
    ):
        chosen = _is_pushing(found) & (hardest == is_hardest)
        ends = [
            arrows.force_ends(robots[i], found.vectors[i]) for i in np.flatnonzero(chosen).tolist()
        ]
        for tail, tip in ends:
            page.keep_clear(tail, tip, breadth=HEAD * width)
        rim = style.RIM if is_hardest else {}
        draw_arrows(page.ax, ends, facecolor=colour, **rim, width=width, gid=gid)
    page.ax.plot(
        *np.reshape([robot.contact for robot in robots], (-1, 2)).T, "o", markersize=3.2,
        color=style.INK, markeredgecolor="white", markeredgewidth=0.4, zorder=5,
    )  # fmt: skip


def _pointers(arrows: Arrows, found: Forces) -> dict[str, Pointer]:
    """Return the wrenches that are drawn at the origin, if that is in view."""
    wanted = Pointer(arrows, found.swarm, found.wanted, "wrench wanted")
    load = load_pointer(arrows, found.swarm, found.load)
    shown = {"wrench": wanted} if found.wanted.any() else {}
    shown |= {"load": load} if load.has_force else {}
    return shown if in_view(arrows) else {}


def _label_robots(page: Page, arrows: Arrows, found: Forces) -> None:
    """Write the name and the share of every robot, unless there are too many."""
    robots = arrows.robots
    if len(robots) > MOST_LABELS:
        return
    size = 8.0 if len(robots) <= FEW else 7.0
    hardest, pushing = _hardest(found), _is_pushing(found)
    for index in np.argsort(-found.shares, kind="stable").tolist():
        robot, share = robots[index], float(found.shares[index])
        spots, bearing = outer_spots(arrows, robot)
        colour = style.VERMILION if hardest[index] else style.BLUE
        colour = colour if pushing[index] else style.GREY
        text = f"{robot.name}: {_percent(share)}"
        page.label(text, spots, bearing, fontsize=size, color=colour, gid="robot-label")


def _percent(share: float) -> str:
    """Write a share in percent, shortly.

    Examples
    --------
    >>> [_percent(share) for share in (0.1234, 0.0321, 1e-9, 1.0)]
    ['12 %', '3.2 %', '0 %', '100 %']
    """
    if share <= LEAST_SHARE:
        return "0 %"
    return f"{100.0 * share:.{int(share < 0.0995)}f} %"


def _caption(
    found: Forces, pointers: dict[str, Pointer], flows: tuple[Flow, ...], heading: str
) -> Caption:
    """Return what is written round the picture."""
    swarm = found.swarm
    kinds = {"force": style.BLUE, "force at the largest share": style.VERMILION}
    hardest = _hardest(found)
    drawn = [bool(_is_pushing(found)[~hardest].any()), bool(hardest.any())]
    entries: list[Any] = [
        ArrowEntry(facecolor=colour, **(style.RIM if row else {}), label=label)
        for row, ((label, colour), is_drawn) in enumerate(zip(kinds.items(), drawn, strict=True))
        if is_drawn
    ]
    wide = [has_area(robot) for robot in swarm.robots]
    if not all(wide):
        entries.append(ArrowEntry(facecolor=LIMIT, label="limit"))
    if any(wide):
        entries.append(Patch(**AREA_LOOK, label="all it can exert"))
    entries += [pointer.entry() for pointer in pointers.values()]
    words = wrench_words(found.wanted * swarm.scale)
    size = float(np.linalg.norm(found.wanted * swarm.scale))
    title = f"{words}: {written.force(size)}" if size > 0.0 else words
    if size == 0.0 and found.load.any():
        title = "not held" if found.is_degraded else "held"
        if found.shares.any():
            busiest = swarm.names[int(np.argmax(found.shares))]
            title += f": busiest {busiest}, {_percent(found.largest_share)}"
    small_print = [f"Size of a wrench with {written.metric(swarm)}."]
    if found.load.any():
        small_print.append(written.load_sentence(tuple(found.load.tolist()), swarm))
    small_print += written.frame_sentences()
    return Caption(
        heading, _capital(title), _outcome(found), tuple(entries), tuple(small_print), flows
    )


def _outcome(found: Forces) -> str:
    """Say how well the wrench is made."""
    if found.is_degraded:
        return f"out of reach by {written.force(found.shortfall)}, the nearest wrench is made"
    return f"made, with shares up to {_percent(found.largest_share)}" if found.shares.any() else ""


def _capital(text: str) -> str:
    """Return a text that begins with a capital letter."""
    return text[:1].upper() + text[1:]
