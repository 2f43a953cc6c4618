"""A run on one sheet: its track above, its history below."""

from matplotlib.figure import Figure

from swarmgrasp.plot import style
from swarmgrasp.plot.figure import Drawn
from swarmgrasp.plot.history import HEIGHT, PANELS, draw_history, panels
from swarmgrasp.plot.track import height_of, legend_columns, stages_of, track
from swarmgrasp.simulation.run import Run
from swarmgrasp.simulation.verdict import Verdict
from swarmgrasp.terms import SI, Terms

LEFT, RIGHT, TOP = 0.6, 0.14, 0.34
"""Of the track's axes [in]."""


def run_sheet(
    run: Run,
    verdict: Verdict,
    title: str = "",
    *,
    index: int = 0,
    terms: Terms = SI,
    width: float = style.WIDTH,
) -> Figure:
    """Draw one of the runs: its track from above, and its history.

    Parameters
    ----------
    run : Run
    verdict : Verdict
        Of the run.
    title : str
    index : int
        Which of the runs.
    terms : Terms
        The units, the frame and the words in which it is told.
    width : float [in]

    Returns
    -------
    Figure
    """
    with style.settings(width, terms):
        room = style.width() - LEFT - RIGHT
        height = height_of(run, verdict, index, room)
        legend = 0.5 + 0.17 * (len(stages_of(run, verdict, index)) // legend_columns() + 1)
        below = HEIGHT * len(PANELS) + 0.8
        total = TOP + height + legend + below
        figure = Drawn(figsize=(style.width(), total))
        above = figure.add_axes(
            (LEFT / style.width(), (below + legend) / total, room / style.width(), height / total)
        )
        track(run, verdict, index=index, terms=terms, width=width, ax=above)
        figure.text(
            LEFT / style.width(),
            1.0 - 0.2 / total,
            title,
            fontsize=style.text(10.0),
            weight="bold",
            gid="heading",
        )
        axes = panels(figure, 0.4 / total, (below - 0.35) / total)
        draw_history(axes, run, verdict, index)
    return figure
