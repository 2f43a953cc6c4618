"""Axes of pictures that are drawn in metres, ticked in the coordinates of the file."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from matplotlib.axes import Axes
from matplotlib.axis import Axis
from matplotlib.ticker import Formatter, MaxNLocator

from swarmgrasp.plot import style
from swarmgrasp.units import LENGTHS

STRAIGHT: Final = 1e-9
"""Difference of a direction from an axis of the file that counts as none."""
ASKEW: Final = ("ahead of (0, 0)", "to port of (0, 0)")
"""What is ticked where the axes of the file lie askew on the plan."""
STEPS: Final = (1.0, 2.0, 2.5, 5.0, 10.0)
"""Between ticks, times a power of ten."""
CLOSE: Final = 1e-6
"""Part of the distance between ticks that is no decimal worth writing."""


@dataclass(frozen=True)
class Scale:
    """How numbers on an axis are told that is drawn in metres.

    Attributes
    ----------
    size : float [m]
        Of the unit; negative where the numbers grow the other way.
    zero : float [m]
        Where the numbers begin.
    """

    size: float
    zero: float = 0.0

    def told(self, drawn: Any) -> Any:
        """Return numbers as they are told."""
        return (drawn - self.zero) / self.size

    def drawn(self, told: Any) -> Any:
        """Return numbers as they are drawn [m]."""
        return told * self.size + self.zero

    def put_on(self, axis: Axis, most: int) -> None:
        """Tick an axis at round numbers, about so many."""
        axis.set_major_locator(_Ticks(self, most))
        axis.set_major_formatter(_Numbers(self))


class _Ticks(MaxNLocator):
    """Ticks at round numbers of a unit, in which the data are not."""

    def __init__(self, scale: "Scale", nbins: int) -> None:
        super().__init__(nbins=nbins, steps=STEPS)
        self._scale = scale

    def tick_values(self, vmin: float, vmax: float) -> Any:
        """Return where ticks are within limits, in the units of the data."""
        told = super().tick_values(*sorted((self._scale.told(vmin), self._scale.told(vmax))))
        return self._scale.drawn(told)


class _Numbers(Formatter):
    """Ticks written in a unit, all with the decimals that tell them apart."""

    def __init__(self, scale: "Scale") -> None:
        self._scale = scale

    def __call__(self, x: float, pos: int | None = None) -> str:  # noqa: ARG002 - matplotlib's
        """Return one number, as under the pointer."""
        return f"{self._scale.told(x):.4g}"

    def format_ticks(self, values: Sequence[float]) -> list[str]:
        """Return what is written at ticks."""
        told = self._scale.told(np.asarray(values, float))
        apart = CLOSE * float(np.ptp(told)) / max(1, len(told) - 1)
        decimals = next((d for d in range(12) if (np.abs(told - told.round(d)) <= apart).all()), 12)
        return [f"{v + 0.0:.{decimals}f}".replace("-", "\u2212") for v in told.round(decimals)]


def tick_axes(ax: Axes, most: tuple[int, int]) -> None:
    """Tick and name the axes of a plan, which is drawn with x forward and y to port.

    Parameters
    ----------
    ax : Axes
    most : tuple of int
        Numbers on either axis, about.
    """
    terms = style.terms()
    metres = LENGTHS[terms.length]
    axes: tuple[Axis, Axis] = ax.xaxis, ax.yaxis
    ours = terms.frame.to_file(np.eye(2))
    for axis, way, askew, bins, pad in zip(axes, ours, ASKEW, most, (2.0, 3.0), strict=True):
        along = int(np.argmax(np.abs(way)))
        is_straight = abs(way[1 - along]) <= STRAIGHT
        name = "xy"[along] if is_straight else askew
        size = metres * (np.copysign(1.0, way[along]) if is_straight else 1.0)
        Scale(float(size)).put_on(axis, bins)
        axis.set_label_text(
            f"{name} [{terms.length}]", fontsize=style.text(style.RC["axes.labelsize"])
        )
        axis.labelpad = pad
    ax.spines[["top", "right"]].set_visible(False)
    ax.tick_params(length=3.0, labelsize=style.text(style.RC["xtick.labelsize"]))
