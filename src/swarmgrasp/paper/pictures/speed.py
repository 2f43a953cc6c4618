"""Fig. 6: the time of one placement over the number of robots."""

import numpy as np
from matplotlib.figure import Figure

from swarmgrasp.pages.statements import seconds, spaced
from swarmgrasp.paper.pictures.axes import below, chart
from swarmgrasp.paper.published import MACHINE, ROBOTS_TIMED, TIME_FITS
from swarmgrasp.paper.studies.speed import Speeds
from swarmgrasp.plot import style


def speed(found: Speeds, beyond: Speeds) -> Figure:
    """Draw the times, each with its range from best to worst, both axes logarithmic.

    Parameters
    ----------
    found, beyond : Speeds
        Within the paper's numbers of robots, and with larger ones.
    """
    counts = np.concatenate([found.robots, beyond.robots])
    ours = np.vstack([found.ours, beyond.ours])
    theirs = np.vstack([found.theirs, beyond.theirs])
    with style.settings():
        figure, (ax,) = chart(height=3.9)
        looks = (
            ("the certified optimum, with its proof", ours, style.INK),
            ("Algorithm 1 with SLSQP, on the same machine", theirs, style.BLUE),
        )
        for label, times, colour in looks:
            ax.fill_between(counts, times.min(1), times.max(1), color=colour, alpha=0.2, lw=0)
            ax.plot(counts, np.median(times, 1), "o-", color=colour, ms=3.0, label=label)
        robots = np.linspace(*ROBOTS_TIMED, 50)
        low, middle, high = (TIME_FITS[name] * robots**2 for name in ("best", "median", "worst"))
        ax.fill_between(robots, low, high, color=style.VERMILION, alpha=0.15, linewidth=0.0)
        label = f"the paper's fit C N², {MACHINE}"
        ax.plot(robots, middle, color=style.VERMILION, linestyle=(0, (4, 2)), label=label)
        ax.set(xscale="log", yscale="log", xlabel="robots already there", ylabel="time")
        ticks = [n for n in (5, 10, 15, 25, 50, 100, 200) if n <= counts[-1]]
        ax.set_xticks(ticks, [spaced(n) for n in ticks])
        ax.set_xticks([], minor=True)
        ax.yaxis.set_major_formatter(lambda value, _: seconds(value))
        below(figure, ax, 1)
    return figure
