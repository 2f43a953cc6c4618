"""`swarmgrasp count`: how many robots a required quality takes."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from swarmgrasp.cli.amounts import Amount
from swarmgrasp.cli.criteria import criterion_of, losing_faults
from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.drawing import USUAL, Drawing
from swarmgrasp.cli.inputs import (
    UsageFault,
    blaming,
    json_faults,
    read_scenario,
    whole_faults,
)
from swarmgrasp.cli.question import asked_before, check_newcomer
from swarmgrasp.cli.weather import CALM, Weather
from swarmgrasp.cli.wording import FILE, Wording
from swarmgrasp.ranges import MOST_PLACED, STRONGEST, WEAKEST

if TYPE_CHECKING:
    from swarmgrasp.placement import HowMany, Problem
    from swarmgrasp.quality import Criterion
    from swarmgrasp.terms import Terms

MOST = 20
"""Robots tried unless told otherwise."""


def count(
    file: Dashed,
    /,
    *,
    quality: Annotated[str | None, Parameter(metavar="FORCE")] = None,
    most: Annotated[str | None, Parameter(metavar="INT")] = None,
    effort: Annotated[str | None, Parameter(metavar="INT")] = None,
    losing: Annotated[str | None, Parameter(metavar="INT")] = None,
    failures: Annotated[list[str] | None, Parameter(metavar="NAMES", negative="")] = None,
    worst_case: Annotated[bool, Parameter(negative="")] = False,
    plot: Path | None = None,
    drawing: Drawing = USUAL,
    json: Dashed | None = None,
    weather: Weather = CALM,
    wording: Wording = FILE,
) -> int:
    """Find the fewest robots like the newcomer that bring a required quality.

    They are placed together. Prints where they go, and whether fewer are proven not to be
    enough. Ctrl-C ends the search with what is known so far.

    Example: swarmgrasp count deck-barge --quality 600kN

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as deck-barge; or an
        answer of this command, whose options hold unless given anew.
    quality
        The quality required, such as 600kN; with a task, a factor.
    most
        The most robots to try, 1 to 1000; 20 unless given.
    effort
        Steps of the search, 5000 unless given: about 2 ms each for a dozen robots. The same
        steps give the same answer on every machine.
    losing
        Require it after the worst loss of so many robots.
    failures
        Require it after the worst of these failures, before any loss: a robot or a group by
        name, or several that fail together, with commas. Give it once for each:
        --failures "bus A" --failures Ajax,Boreas. Instead of those in the file.
    worst_case
        Require it in the worst poses that the tolerances allow.
    plot
        Draw the plan to this .png, .svg or .pdf: the object from above with its robots, its zones,
        the weather and the newcomers.
    json
        Also write the answer to this .json file; "-" prints it and nothing else. SI units
        and radians.
    """
    faults = (
        _number_faults(quality, most, effort)
        + losing_faults(losing)
        + json_faults(json)
        + wording.faults(json)
        + weather.faults()
        + drawing.faults(plot)
    )
    scenario = weather.on(read_scenario(file, faults), file, wording)
    check_newcomer(scenario, file, "count")
    before = asked_before(scenario, "count")
    if quality is None and not before:
        raise UsageFault("--quality is missing; give the quality required, such as 600kN")
    tried = before.get("most", MOST) if most is None else int(most)
    criterion = criterion_of(scenario, file, losing, worst_case, failures, tried)
    from swarmgrasp.placement.together.effort import EFFORT

    terms = wording.terms(scenario)
    required = before["required"] if quality is None else _required(quality, criterion, terms)
    steps = before.get("asked_effort", EFFORT) if effort is None else int(effort)
    look = drawing.look(scenario.name, terms)
    with blaming(file):
        found, stopped = _counted(scenario.problem(criterion), required, tried, steps, terms)
    from swarmgrasp.answer_file import document_of
    from swarmgrasp.cli.lasting import INTERRUPTED
    from swarmgrasp.cli.pictures import picture_of_plan
    from swarmgrasp.cli.show.count import show

    deliver(
        json,
        document_of(found, scenario.name, terms=scenario.terms),
        lambda: show(weather.title(scenario, terms), found, terms, is_stopped=stopped),
        lambda: picture_of_plan(plot, scenario, found.answer or (), criterion, look),
        csv=wording.csv,
    )
    return INTERRUPTED if stopped else 0


def _counted(
    problem: "Problem", required: float, most: int, effort: int, terms: "Terms"
) -> "tuple[HowMany, bool]":
    """Search, showing how far that is; return what is found, and whether Ctrl-C ended it."""
    from swarmgrasp.cli.lasting import stoppable
    from swarmgrasp.cli.progress import shown_search
    from swarmgrasp.placement import how_many

    with stoppable() as is_stopped, shown_search("counting") as tell:

        def progress(count: int, enough: int) -> bool:
            """Tell how far the search is, and end it on Ctrl-C."""
            known = f"{enough} are enough" if enough <= most else f"at most {most}"
            tell(f"trying {terms.robots(count)}, {known}")
            return is_stopped()

        found = how_many(problem, required, most=most, effort=effort, progress=progress)
        return found, is_stopped() and not found.is_proven


def _required(text: str, criterion: "Criterion", terms: "Terms") -> float:
    """Return the quality required [N], or a factor of the task.

    Raises
    ------
    UsageFault
        If it has a unit and the criterion has a task.
    """
    from swarmgrasp.terms import SI
    from swarmgrasp.units import is_quantity

    if criterion.task is None:
        return _quality(text).value(terms)
    if is_quantity(text):
        raise UsageFault(
            f"--quality is {text}; the criterion has a task, and quality is how many times the "
            "task is left: give a number without a unit"
        )
    return _quality(text).value(SI)


def _quality(text: str) -> Amount:
    """Return the quality that an option gives."""
    return Amount("--quality", text, "force", WEAKEST, STRONGEST)


def _number_faults(quality: str | None, most: str | None, effort: str | None) -> list[str]:
    """Return what is wrong with the numbers given as options."""
    return [
        *([] if quality is None else _quality(quality).faults()),
        *whole_faults("--most", most, 1, MOST_PLACED),
        *whole_faults("--effort", effort),
    ]
