"""The run of `swarmgrasp simulate`: a bar, a log that grows with it, other files at its end."""

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Any

from swarmgrasp.cli.lasting import stoppable
from swarmgrasp.cli.progress import shown_progress

if TYPE_CHECKING:
    from swarmgrasp.simulation.run import Run
    from swarmgrasp.simulation.simulation import Simulation
    from swarmgrasp.simulation.verdict import Verdict

STEPS = 1000
"""Of the bar that shows how much is done."""


def run_of(asked: "Simulation", log: Path | None) -> "Run":
    """Run a simulation, with a bar on a terminal; Ctrl-C keeps what was run.

    The log is written as the run goes on.
    """
    from swarmgrasp.simulation.simulate import simulate as run

    with (
        _log_of(log) as sink,
        stoppable() as is_stopped,
        shown_progress(STEPS, "simulating") as told,
    ):

        def tell(part: float) -> None:
            """Show what part is done, and stop where the run may be stopped."""
            if told is not None:
                told(round(STEPS * part))
            if is_stopped():
                raise KeyboardInterrupt

        return run(asked, sink=sink, progress=tell)


@contextmanager
def _log_of(log: Path | None) -> "Iterator[Callable[[Run], None] | None]":
    """Offer what takes a run piece by piece, if there is to be a log."""
    if log is None:
        yield None
        return
    from swarmgrasp.simulation.record import Log

    with Log(log) as found:
        yield found.add


def write_files(
    run: "Run", verdict: "Verdict", log: Path | None, plot: Path | None,
    look: dict[str, Any], gif: Path | None, mcap: Path | None, player: Path | None,
) -> list[Path]:  # fmt: skip
    """Write the files that are wanted; return their paths."""
    written = [] if log is None else [log]
    if plot is not None:
        from swarmgrasp.plot import save
        from swarmgrasp.plot.sheet_of_run import run_sheet

        written.append(save(run_sheet(run, verdict, **look), plot))
    if gif is not None:
        from swarmgrasp.simulation.export.gif import write_gif

        written.append(write_gif(run, gif, terms=look["terms"]))
    if mcap is not None:
        from swarmgrasp.simulation.export.mcap import write_mcap

        written.append(write_mcap(run, mcap))
    if player is not None:
        from swarmgrasp.simulation.export.player import write_player

        written.append(write_player(run, player))
    return written
