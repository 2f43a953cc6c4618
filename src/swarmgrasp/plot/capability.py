"""The capability diagram, as for dynamic positioning: the wind held at every bearing."""

from typing import Any, Final, cast

import numpy as np
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from numpy.typing import NDArray

from swarmgrasp.capability import Capability
from swarmgrasp.environment import KNOT, beaufort_number
from swarmgrasp.plot import all_round, polar, style, written
from swarmgrasp.plot.all_round import AFTER_LOSS, INTACT, Curve
from swarmgrasp.terms import SI, Terms
from swarmgrasp.words import plural

Vector = NDArray[np.float64]

BEFORE: Final[dict[str, Any]] = {"color": style.GREY, "linewidth": 1.1, "linestyle": "-"}
LOSS_BEFORE: Final[dict[str, Any]] = {**BEFORE, "linestyle": (0, (4, 2))}
"""The curves of the robots before one joins."""
BEYOND: Final = 2.0
"""Times the strongest wind tried, at which lines end that go on beyond it."""
HEADINGS: Final = ("", "least wind held", "", "Beaufort", "from", "lost")


def capability_diagram(
    found: Capability,
    title: str = "",
    *,
    ax: Axes | None = None,
    before: Capability | None = None,
    terms: Terms = SI,
    width: float = style.WIDTH,
) -> Figure:
    """Draw a capability as a polar diagram, bow up, bearings clockwise.

    The radius is the largest wind from that bearing that the robots hold beside current and waves:
    all of them (solid), and those left after the worst loss (dashed). In the middle lies the
    object, its robots' forces as arrows. No line is drawn where more is held than the outer ring
    shows, or than the strongest wind whose sea is known.

    Parameters
    ----------
    found : Capability
    title : str
        Such as the vessel's name.
    ax : Axes, optional
        Draw here, at its present size, instead of in a figure of its own; then without caption.
    before : Capability, optional
        The same without the robot that joined last: in grey.
    terms : Terms
        The units, the frame and the words in which it is told; bearings are true with a heading.
    width : float [in]
        Of a figure of its own.

    Returns
    -------
    Figure
    """
    robot, joined = terms.robot, _joined(found, before)
    curves = _curves(found, before, robot)
    with style.settings(width, terms):
        alone = ax is None
        print_ = _small_print(found, curves)
        ax = polar.new_axes(all_round.below(len(curves), len(print_))) if ax is None else ax
        fastest = max(float(curve.radii.max()) for curve in curves) * KNOT
        step, top = polar.rings(min(fastest, found.most_told))
        most = min(top, found.most_told / KNOT)
        page = polar.frame(ax, top)
        polar.draw_rings(page, step, top)
        all_round.draw_hull(page, found, top, joined)
        for index, curve in enumerate(curves):
            all_round.draw_curve(page, found.bearings, curve, most, fill=index < 2)
        for index, curve in zip((found.worst, found.worst_after_loss), curves, strict=False):
            if curve.radii[index] < most:
                all_round.mark(page, found.bearings[index], curve.radii[index], curve.look["color"])
        polar.label_rings(page, step, top)
        for curve in curves:
            all_round.name_curve(page, found.bearings, curve, most)
        if alone:
            said = f"The largest wind held, by where it comes from, {polar.from_words()}"
            all_round.write_caption(ax, title, said, HEADINGS, _rows(found, before, robot), print_)
        return cast(Figure, ax.get_figure(root=True))


def _joined(found: Capability, before: Capability | None) -> str:
    """Return the name of the robot that joined; nothing if none did."""
    if before is None:
        return ""
    known = set(before.swarm.names)
    return next((name for name in found.swarm.names if name not in known), "")


def _curves(found: Capability, before: Capability | None, robot: str) -> list[Curve]:
    """Return the curves: now, and before if that is asked."""
    less = found.less_by if found.failures else f"loss of {found.loss_words(robot)}"
    told = [
        (found.intact, INTACT, "intact", f"all {plural(robot)}", False),
        (found.after_loss, AFTER_LOSS, "after-loss", f"after the worst\n{less}", True),
    ]
    if before is not None:
        joined = _joined(found, before)
        told += [
            (before.intact, BEFORE, "intact-before", f"without {joined}", True),
            (
                before.after_loss, LOSS_BEFORE, "after-loss-before",
                f"without {joined},\nafter the worst {before.less_by}", True,
            ),
        ]  # fmt: skip
    return [
        Curve(_radii(found, speeds), look, gid, _named(name, speeds), inside)
        for speeds, look, gid, name, inside in told
    ]


def _named(name: str, speeds: Vector) -> str:
    """Return the name of a curve, and that it is none if no wind is held."""
    return name if speeds.any() else f"no wind held\n{name}"


def _radii(found: Capability, speeds: Vector) -> Vector:
    """Return the radii [kn] of winds; well beyond those tried where all of them are held."""
    return np.where(speeds >= found.most_told, BEYOND * speeds, speeds) / KNOT


def _rows(
    found: Capability, before: Capability | None, robot: str
) -> list[tuple[dict[str, Any], tuple[str, ...]]]:
    """Return the rows of the table: the least winds held."""

    def both(
        one: Capability, looks: tuple[dict[str, Any], dict[str, Any]], whole: str
    ) -> list[tuple[dict[str, Any], tuple[str, ...]]]:
        """Return the rows of one capability."""
        lost = polar.cut(one.lost_words(one.worst_after_loss, most=1), all_round.LONGEST_NAME)
        less = "worst failure" if one.failures else f"worst loss of {one.losing}"
        return [
            (looks[0], (whole, *_least(one, one.intact, one.worst), "")),
            (looks[1], (less, *_least(one, one.after_loss, one.worst_after_loss), lost)),
        ]

    rows = both(found, (INTACT, AFTER_LOSS), f"all {plural(robot)}")
    if before is not None:
        joined = polar.cut(_joined(found, before), 9)
        rows += both(before, (BEFORE, LOSS_BEFORE), f"without {joined}")
    return rows


def _least(found: Capability, speeds: Vector, index: int) -> tuple[str, str, str, str]:
    """Write the least of some speeds [m/s]: in two units, as Beaufort, and its bearing."""
    speed = float(speeds[index])
    bearing = all_round.degrees(found.bearings[index])
    if speed == 0.0:
        return ("none", "", "", bearing if speeds.any() else "any")
    most = min(polar.MOST_SHOWN * KNOT, found.most_told)
    size, name = written.other_speed()
    told, over, bearing = (most, "over ", "any") if speed >= most else (speed, "", bearing)
    winds = f"{over}{told / KNOT:.3g} kn", f"{told / size:.3g} {name}"
    return (*winds, f"{beaufort_number(told)}", bearing)


def _small_print(found: Capability, curves: list[Curve]) -> list[str]:
    """Say what was taken into account, and where no line is drawn."""
    factor = found.environment.dynamic_factor
    allowance = f"loads times {factor:g}" if factor != 1.0 else "steady loads"
    poses = "; worst poses" if found.worst_case else ""
    lines = [
        all_round.drag_words(found.environment),
        f"{all_round.water_words(found.environment)}; {allowance}{poses}.",
    ]
    most = min(polar.MOST_SHOWN, found.most_told / KNOT)
    if any((curve.radii >= most).any() for curve in curves):
        lines.append(f"Where no line is drawn, more than {most:.3g} kn is held.")
    return lines
