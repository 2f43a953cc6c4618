"""A run on one sheet: its track above, its history below."""

from matplotlib.figure import Figure

from swarmgrasp.plot import style
from swarmgrasp.plot.history import HEIGHT, PANELS, draw_history, panels
from swarmgrasp.plot.track import height_of, stages_of, track
from swarmgrasp.simulation.run import Run
from swarmgrasp.simulation.verdict import Verdict

LEFT, RIGHT, TOP = 0.6, 0.14, 0.34
"""Of the track's axes [in]."""


def run_sheet(run: Run, verdict: Verdict, title: str = "", *, index: int = 0) -> Figure:
    """Draw one of the runs: its track from above, and its history.

    Parameters
    ----------
    run : Run
    verdict : Verdict
        Of the run.
    title : str
    index : int
        Which of the runs.

    Returns
    -------
    Figure
    """
    with style.settings():
        width = style.WIDTH - LEFT - RIGHT
        height = height_of(run, verdict, index, width)
        legend = 0.5 + 0.17 * (len(stages_of(run, verdict, index)) // 2 + 1)
        below = HEIGHT * len(PANELS) + 0.8
        total = TOP + height + legend + below
        figure = Figure(figsize=(style.WIDTH, total))
        above = figure.add_axes(
            (LEFT / style.WIDTH, (below + legend) / total, width / style.WIDTH, height / total)
        )
        track(run, verdict, index=index, ax=above)
        figure.text(LEFT / style.WIDTH, 1.0 - 0.2 / total, title, fontsize=10.0, weight="bold")
        axes = panels(figure, 0.4 / total, (below - 0.35) / total)
        draw_history(axes, run, verdict, index)
    return figure
