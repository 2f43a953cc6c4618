"""The pictures of the page, in the style of the package's own."""

import numpy as np
from matplotlib.figure import Figure
from page import duration, power_of_ten

from swarmgrasp.plot import style

LOOKS = tuple(
    zip(
        (style.BLUE, style.VERMILION, style.GREEN, style.ORANGE,
         style.SKY, style.PURPLE, style.WINE, style.GREY),
        "osD^vPX*",
        strict=True,
    )
)  # fmt: skip
"""Colour and marker of each curve: either tells them apart."""
OURS = {"swarmgrasp", "one placement, random"}
"""Drawn in ink and heavier."""
FROM = 1000.0
"""Number of robots at which the line to compare with begins."""


def lines(curves, label, compared=False):
    """Draw times over the number of robots, both on logarithmic axes.

    Parameters
    ----------
    curves : dict
        From a name to a list of (robots, seconds).
    label : str
        Of the vertical axis.
    compared : bool
        Add a dotted line in proportion to the robots.

    Returns
    -------
    Figure
    """
    with style.settings():
        figure, ax = new_axes("robots", label)
        looks = iter(LOOKS)
        for name, curve in curves.items():
            ours = name in OURS
            colour, marker = (style.INK, "o") if ours else next(looks)
            ax.plot(
                *np.array(curve).T, color=colour, marker=marker, ms=3.5,
                lw=1.8 if ours else 1.1, label=name,
            )  # fmt: skip
        points = np.array([point for curve in curves.values() for point in curve])
        if compared and points[:, 0].max() > FROM:
            ends = np.array([FROM, points[:, 0].max()])
            low = points[points[:, 0] == FROM, 1].min() / 3.0
            ax.plot(ends, low * ends / FROM, color=style.GREY, ls=":", lw=1.0, label="linear")
        ax.set(xscale="log", yscale="log")
        ax.xaxis.set_major_formatter(lambda n, _: power_of_ten(round(n)))
        ax.yaxis.set_major_formatter(lambda seconds, _: duration(seconds))
        figure.legend(loc="outside lower center", ncols=2 if len(curves) < 5 else 3, fontsize=7.5)
    return figure


def shortfalls(shares):
    """Draw the share of inputs on which a method falls short by at most so much.

    Parameters
    ----------
    shares : dict
        From a name to qualities relative to ours.

    Returns
    -------
    Figure
    """
    with style.settings():
        figure, ax = new_axes("quality short of ours by at most [%]", "share of inputs [%]")
        least, most = 1e-4, 100.0  # the gap is 1e-4 %
        for (name, values), (colour, _) in zip(shares.items(), LOOKS, strict=False):
            short = np.sort(np.clip(100.0 * (1.0 - np.asarray(values)), least, most))
            part = 100.0 * np.arange(1, len(short) + 1) / len(short)
            ax.step([*short, most], [*part, 100.0], where="post", color=colour, lw=1.4, label=name)
        ax.set(xscale="log", xlim=(least, most), ylim=(0.0, 102.0))
        ax.xaxis.set_major_formatter(lambda part, _: f"{part:g}" if part > least else "none")
        figure.legend(loc="outside lower center", ncols=2, fontsize=7.5)
    return figure


def new_axes(x, y):
    """Return a figure and its axes with labels, a light grid and no frame above or right."""
    figure = Figure(figsize=(style.WIDTH, 3.7), layout="constrained")
    ax = figure.add_subplot(xlabel=x, ylabel=y)
    ax.spines[["top", "right"]].set_visible(False)
    ax.grid(True, which="major")
    ax.set_axisbelow(True)
    return figure, ax
