"""The diagram of capability numbers: the largest step of weather held at every bearing."""

from typing import Any, Final, cast

import numpy as np
from matplotlib.figure import Figure

from swarmgrasp.capability import ALLOWANCE, CapabilityNumbers
from swarmgrasp.environment import KNOT, STEPS
from swarmgrasp.plot import all_round, polar, style, written
from swarmgrasp.plot.all_round import AFTER_LOSS, INTACT, Curve
from swarmgrasp.terms import SI, Terms
from swarmgrasp.words import plural

HEADINGS: Final = ("", "least held", "wind", "waves", "from", "lost")
LAST: Final = len(STEPS) - 1
"""Number of the largest step."""
NUMBERS_AT: Final = 45.0
WINDS_AT: Final = 315.0
"""Bearings [deg] near which the rings are labelled."""


def numbers_diagram(
    found: CapabilityNumbers, title: str = "", *, terms: Terms = SI, width: float = style.WIDTH
) -> Figure:
    """Draw capability numbers as a polar diagram, bow up, bearings clockwise.

    The radius is the number of the largest step of wind, sea and current from that bearing that all
    robots hold (solid), and those left after the worst loss (dashed).

    Parameters
    ----------
    found : CapabilityNumbers
    title : str
        Such as the vessel's name.
    terms : Terms
        The units, the frame and the words in which it is told; bearings are true with a heading.
    width : float [in]

    Returns
    -------
    Figure
    """
    robot = terms.robot
    less = found.less_by if found.failures else f"loss of {found.loss_words(robot)}"
    curves = [
        Curve(_radii(found.intact), INTACT, "intact", f"all {plural(robot)}"),
        Curve(_radii(found.after_loss), AFTER_LOSS, "after-loss", f"after the worst\n{less}", True),
    ]
    with style.settings(width, terms):
        small_print = _small_print(found)
        ax = polar.new_axes(all_round.below(2, len(small_print)))
        page = polar.frame(ax, LAST)
        polar.draw_rings(page, 1.0, LAST)
        all_round.draw_hull(page, found, LAST)
        for curve in curves:  # the last step is drawn: it was held, and the table ends
            all_round.draw_curve(page, found.bearings, curve, LAST + 1.0, fill=True)
        for index, curve in zip((found.worst, found.worst_after_loss), curves, strict=True):
            all_round.mark(page, found.bearings[index], curve.radii[index], curve.look["color"])
        for number in range(1, LAST + 1):
            polar.write_ring(page, number, str(number), NUMBERS_AT, "center")
            if number % 2:
                wind = f"{STEPS[number].wind / KNOT:.0f} kn"
                polar.write_ring(page, number, wind, WINDS_AT, "center")
        for curve in curves:
            all_round.name_curve(page, found.bearings, curve, LAST + 1.0)
        said = f"The largest step of weather held, by where it comes from, {polar.from_words()}"
        all_round.write_caption(ax, title, said, HEADINGS, _rows(found, robot), small_print)
        return cast(Figure, ax.get_figure(root=True))


def _radii(numbers: Any) -> Any:
    """Return the radii of numbers; nothing held is in the middle."""
    return np.maximum(numbers, 0).astype(float)


def _rows(found: CapabilityNumbers, robot: str) -> list[tuple[dict[str, Any], tuple[str, ...]]]:
    """Return the rows of the table: the least steps held."""
    j = found.worst_after_loss
    lost = polar.cut(found.lost_words(j, most=1), all_round.LONGEST_NAME)
    less = "worst failure" if found.failures else f"worst loss of {found.losing}"
    return [
        (INTACT, (f"all {plural(robot)}", *_least(found, found.intact, found.worst), "")),
        (AFTER_LOSS, (less, *_least(found, found.after_loss, j), lost)),
    ]


def _least(found: CapabilityNumbers, numbers: Any, index: int) -> tuple[str, str, str, str]:
    """Write the least number held, its wind and sea, and where it comes from."""
    number = int(numbers[index])
    if number < 0:
        return ("none", "", "", "any")
    step = STEPS[number]
    sea = f"{step.wind / KNOT:.3g} kn", written.length(step.height)
    return (f"{number}", *sea, all_round.degrees(found.bearings[index]))


def _small_print(found: CapabilityNumbers) -> list[str]:
    """Say what the steps are, what was taken into account, and what this is not."""
    factor = found.environment.dynamic_factor
    beside = "" if factor == ALLOWANCE else f" (the standard takes {ALLOWANCE:g})"
    poses = "; worst poses" if found.worst_case else ""
    return [
        "Steps 1 to 11 of DNV-ST-0111: Beaufort winds, their sea and a current, all from there.",
        all_round.drag_words(found.environment),
        f"Loads times {factor:g}{beside}{poses}. No assessment by that standard:",
        "its thrust losses and its power balance are not counted.",
    ]
