"""`swarmgrasp move`: which one robot should attach elsewhere."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from swarmgrasp.cli.criteria import criterion_of, losing_faults
from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.drawing import USUAL, Drawing
from swarmgrasp.cli.inputs import blaming, json_faults, read_scenario
from swarmgrasp.cli.question import tell_omitted
from swarmgrasp.cli.weather import CALM, Weather
from swarmgrasp.cli.wording import FILE, Wording


def move(
    file: Dashed,
    /,
    *,
    losing: Annotated[str | None, Parameter(metavar="INT")] = None,
    failures: Annotated[list[str] | None, Parameter(metavar="NAMES", negative="")] = None,
    worst_case: Annotated[bool, Parameter(negative="")] = False,
    plot: Path | None = None,
    drawing: Drawing = USUAL,
    json: Dashed | None = None,
    weather: Weather = CALM,
    wording: Wording = FILE,
) -> int:
    """Find the one robot that should attach elsewhere, and where.

    Each robot in turn lets go and is placed anew beside all the others. Prints the best
    move, what it is worth, what is left meanwhile, and the best move of every robot. Ctrl-C ends
    the search with those looked at so far.

    Example: swarmgrasp move deck-barge

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as
        deck-barge. Robots may go where its newcomer may, and hold on as it does, each at
        its own limit; without a newcomer, anywhere and in any direction.
    losing
        Look at the quality after the worst loss of so many robots.
    failures
        Look at the quality after the worst of these failures, before any loss: a robot or a group
        by name, or several that fail together, with commas. Give it once for each:
        --failures "bus A" --failures Ajax,Boreas. Instead of those in the file.
    worst_case
        Look at the quality in the worst poses that the robots' tolerances allow.
    plot
        Draw the plan to this .png, .svg or .pdf: the object from above with its robots, its zones,
        the weather and the robot that had better move.
    json
        Also write the moves to this .json file; "-" prints them and nothing else. SI
        units and radians.
    """
    faults = losing_faults(losing) + json_faults(json) + wording.faults(json) + weather.faults()
    faults += drawing.faults(plot)
    scenario = weather.on(read_scenario(file, faults), file, wording)
    criterion = criterion_of(scenario, file, losing, worst_case, failures)
    tell_omitted(
        scenario, file, "move",
        newcomer=None, losing=losing, failures=failures, worst_case=worst_case,
        load=weather.given, task=None,
    )  # fmt: skip
    from swarmgrasp.cli.lasting import INTERRUPTED, stoppable
    from swarmgrasp.cli.progress import shown_progress
    from swarmgrasp.placement import best_move

    total = len(scenario.swarm)
    moving = f"moving {scenario.terms.several}"
    with blaming(file), stoppable() as is_stopped, shown_progress(total, moving) as bar:

        def progress(tried: int) -> bool:
            """Tell how far the search is, and end it on Ctrl-C."""
            if bar is not None:
                bar(tried)
            return is_stopped()

        found = best_move(scenario.problem(criterion), progress=progress)
    from swarmgrasp.answer_file import document_of
    from swarmgrasp.cli.pictures import picture_of_plan
    from swarmgrasp.cli.show.move import show

    terms = wording.terms(scenario)
    look = drawing.look(scenario.name, terms)
    deliver(
        json,
        document_of(found, scenario.name, terms=scenario.terms),
        lambda: show(weather.title(scenario, terms), found, terms),
        lambda: picture_of_plan(plot, scenario, found, criterion, look),
        csv=wording.csv,
    )
    return INTERRUPTED if found.untried else 0
