"""`swarmgrasp place`: where the next robot goes."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from swarmgrasp.cli.criteria import criterion_of, losing_faults
from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.drawing import USUAL, Drawing
from swarmgrasp.cli.for_capability import ForCapability, capability_faults, tell_for_capability
from swarmgrasp.cli.inputs import (
    blaming,
    json_faults,
    read_scenario,
    whole_faults,
)
from swarmgrasp.cli.pictures import Picture
from swarmgrasp.cli.question import asked_before, check_newcomer
from swarmgrasp.cli.weather import CALM, Weather
from swarmgrasp.cli.wording import FILE, Wording
from swarmgrasp.ranges import MOST_PLACED

if TYPE_CHECKING:
    from swarmgrasp.placement import Placements
    from swarmgrasp.placement.grounds import Ground
    from swarmgrasp.quality import Criterion
    from swarmgrasp.scenario import Scenario

FINE, ROUGH = 1e-6, 1e-3
"""Gaps unless told otherwise, of robots one by one and of robots together."""
MOST_AT_ONCE, STEPS = 8, 100
"""Robots up to which it is looked at what they reach all at once, and steps for that."""
SHARE = 0.9
"""Of the best quality, from which on other places are told unless told otherwise."""


def place(
    file: Dashed,
    /,
    *,
    robots: Annotated[str | None, Parameter(metavar="INT")] = None,
    together: Annotated[bool, Parameter(negative="")] = False,
    effort: Annotated[str | None, Parameter(metavar="INT")] = None,
    losing: Annotated[str | None, Parameter(metavar="INT")] = None,
    failures: Annotated[list[str] | None, Parameter(metavar="NAMES", negative="")] = None,
    worst_case: Annotated[bool, Parameter(negative="")] = False,
    gap: float | None = None,
    runners_up: float | None = None,
    aim: Annotated[Literal["quality", "capability"], Parameter(name="--for")] = "quality",
    where_not: Annotated[bool, Parameter(negative="")] = False,
    plot: Path | None = None,
    drawing: Drawing = USUAL,
    json: Dashed | None = None,
    weather: Weather = CALM,
    wording: Wording = FILE,
) -> int:
    """Find where the next robot attaches and which way it pushes.

    Prints the contact, the direction, what the robot adds, how far the answer can be from
    the best, what limits the swarm then, and the next best places.

    Example: swarmgrasp place deck-barge --plot barge.png --json barge.json

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as deck-barge; or an
        answer of this command, whose options hold unless given anew.
    robots
        How many robots like the newcomer to place, one after the other, 1 to 1000: each
        is best given those before it; 1 unless given.
    together
        Place them all at once instead, which is often better; the bound is then for all of
        them. Takes --robots 2 or more. Ctrl-C ends the search with the best so far.
    effort
        Steps of the search for robots placed together, 5000 unless given: about 2 ms each
        for a dozen robots. The same steps give the same answer on every machine.
    losing
        Make the quality after the worst loss of so many robots best, the newcomer perhaps
        among them.
    failures
        Make the quality after the worst of these failures best, before any loss: a robot or a
        group by name, or several that fail together, with commas. Give it once for each:
        --failures "bus A" --failures Ajax,Boreas. Instead of those in the file.
    worst_case
        Make the quality best in the worst poses that the tolerances of the robots, and of the
        newcomer, allow.
    gap
        Stop when no place can be better by more than this share, relative to the answer;
        between 0 and 1, both excluded; 1e-6 unless given, or 1e-3 of robots placed together.
    runners_up
        Also list the best place on every other edge or zone that reaches this share of
        the best quality, from 0 (all that help) to 1 (only equals); 0.9 unless given.
    where_not
        Also tell of every zone and edge how much of it is left to the newcomer, what takes the
        rest, and the best quality there.
    aim
        What is best: the quality, or the least wind held over all bearings, capability: beside the
        current and the waves of the scenario or of the command line.
    plot
        Write pictures of the plan (NAME.png), the wrenches (NAME-wrenches.png) and
        the landscape of all places (NAME-landscape.png); .png, .svg or .pdf.
    json
        Write the answer with its proof to this .json file, which `swarmgrasp verify`
        checks; "-" prints it and nothing else. SI units and radians. Robots placed
        together have no such proof.
    """
    faults = _number_faults(robots, gap, runners_up)
    faults += _together_faults(robots, together, effort, runners_up)
    if aim == "capability":
        alone = not together and not where_not and (robots or "1").lstrip("0") == "1"
        faults += capability_faults(weather, alone=alone)
    if where_not and (together or (robots or "1").lstrip("0") != "1"):
        faults.append("--where-not is of one robot: leave out --robots and --together")
    faults += (
        losing_faults(losing) + json_faults(json) + wording.faults(json) + drawing.faults(plot)
    )
    scenario = read_scenario(file, faults + weather.faults())
    check_newcomer(scenario, file, "place")
    if aim == "capability":
        criterion = criterion_of(scenario, file, losing, worst_case, failures, 1)
        share = SHARE if runners_up is None else runners_up
        needed_by, terms = "`swarmgrasp place --for capability`", wording.terms(scenario)
        around = weather.water.environment(scenario, file, terms, needed_by)
        return tell_for_capability(
            ForCapability(scenario, file, around, criterion, gap or FINE, share),
            _beside(plot) if plot else None, drawing, json, wording,
        )  # fmt: skip
    scenario = weather.on(scenario, file, wording)
    before = asked_before(scenario, "placements", "together")
    together |= robots is None and "robots" in before
    count = int(robots or len(before.get("robots") or before.get("placements") or "1"))
    criterion = criterion_of(scenario, file, losing, worst_case, failures, count)
    if together:
        steps = None if effort is None else int(effort)
        return _tell_together(
            scenario, file, count, gap, steps, criterion, plot, drawing, json, wording
        )
    return _tell_sequence(
        scenario, file, count, gap, runners_up, criterion, plot, drawing, json, wording,
        where_not=where_not and count == 1,
    )  # fmt: skip


def _tell_sequence(
    scenario: "Scenario", file: str, count: int, gap: float | None, runners_up: float | None,
    criterion: "Criterion", plot: Path | None, drawing: Drawing, json: str | None,
    wording: Wording, *, where_not: bool,
) -> int:  # fmt: skip
    """Find and tell robots placed one after the other; what is None is as in the answer read.

    Returns the exit status.
    """
    from swarmgrasp.answer_file import document_of
    from swarmgrasp.cli.lasting import INTERRUPTED
    from swarmgrasp.cli.pictures import pictures
    from swarmgrasp.cli.show.held import weather_of
    from swarmgrasp.cli.show.placement import show

    first = (asked_before(scenario, "placements").get("placements") or [{}])[0]
    near = first.get("asked_gap", FINE) if gap is None else gap
    share = first.get("asked_runners_up", SHARE) if runners_up is None else runners_up
    answers = solve(scenario, file, count, near, share, criterion)
    survey: Sequence[Ground] = ()
    if where_not:
        from swarmgrasp.placement.grounds import grounds

        survey = grounds(solve(scenario, file, 1, near, 0.0, criterion)[0])
    at_once, terms = _at_once(answers), wording.terms(scenario)
    look, weather = drawing.look(scenario.name, terms), weather_of(scenario, terms)
    deliver(
        json,
        document_of(answers, scenario.name, terms=scenario.terms),
        lambda: show(scenario.name, answers, terms, survey, at_once, count, weather),
        lambda: pictures(_beside(plot), scenario, answers, criterion, look) if plot else [],
        csv=wording.csv,
    )
    return INTERRUPTED if len(answers) < count else 0


def _tell_together(
    scenario: "Scenario", file: str, count: int, gap: float | None, effort: int | None,
    criterion: "Criterion", plot: Path | None, drawing: Drawing, json: str | None,
    wording: Wording,
) -> int:  # fmt: skip
    """Find and tell robots placed all at once; what is None is as in the answer read.

    Ctrl-C ends the search with the best so far. Returns the exit status.
    """
    from swarmgrasp.answer_file import document_of
    from swarmgrasp.cli.lasting import INTERRUPTED, stoppable
    from swarmgrasp.cli.pictures import pictures_together
    from swarmgrasp.cli.progress import shown_search
    from swarmgrasp.cli.show.held import weather_of
    from swarmgrasp.cli.show.together import show, so_far
    from swarmgrasp.placement import place_together
    from swarmgrasp.placement.together.effort import EFFORT

    before = asked_before(scenario, "together")
    steps = before.get("asked_effort", EFFORT) if effort is None else effort
    near = before.get("asked_gap", ROUGH) if gap is None else gap
    problem, terms = scenario.problem(criterion), wording.terms(scenario)
    with blaming(file), stoppable() as is_stopped, shown_search("placing together") as tell:

        def progress(quality: float, bound: float) -> bool:
            """Tell how far the search is, and end it on Ctrl-C."""
            tell(so_far(problem, quality, bound, terms))
            return is_stopped()

        found = place_together(problem, count, gap=near, effort=steps, progress=progress)
        stopped = is_stopped() and found.stopped_early
    look, weather = drawing.look(scenario.name, terms), weather_of(scenario, terms)
    deliver(
        json,
        document_of(found, scenario.name, terms=scenario.terms),
        lambda: show(scenario.name, found, terms, is_stopped=stopped, weather=weather),
        lambda: pictures_together(_beside(plot), scenario, found, look) if plot else [],
        csv=wording.csv,
    )
    return INTERRUPTED if stopped else 0


def _at_once(answers: "Placements") -> float:
    """Return the quality [N] of robots that nobody helps, placed all at once; 0 if unasked.

    One after the other, the first few stand where they help nothing yet.
    """
    from swarmgrasp.errors import ForceSetUnsupported
    from swarmgrasp.placement import place_together

    problem = answers[0].problem
    if not 2 <= len(answers) <= MOST_AT_ONCE or answers[0].quality_before > 0.0:
        return 0.0
    try:
        return place_together(problem, len(answers), gap=ROUGH, effort=STEPS).quality
    except ForceSetUnsupported:
        return 0.0


def solve(
    scenario: "Scenario",
    file: str,
    robots: int = 1,
    gap: float = FINE,
    runners_up: float = SHARE,
    criterion: "Criterion | None" = None,
) -> "Placements":
    """Place a scenario's newcomer.

    Parameters
    ----------
    scenario : Scenario
    file : str
        What messages call it.
    robots, gap, runners_up
        As for the command.
    criterion : Criterion, optional
        Instead of the scenario's.

    Raises
    ------
    UsageFault
        If the scenario leaves its newcomer no place, or has a robot of its name.

    Returns
    -------
    Placements
        Fewer than asked for if Ctrl-C ended it after some.
    """
    from swarmgrasp.cli.lasting import stoppable
    from swarmgrasp.cli.progress import shown_progress
    from swarmgrasp.placement import place_sequence

    problem = scenario.problem(criterion)
    if robots == 1:
        with blaming(file):
            return place_sequence(problem, 1, gap=gap, runners_up=runners_up)
    with blaming(file), stoppable() as is_stopped, shown_progress(robots) as show:

        def progress(done: int) -> bool:
            """Show how many are placed, and place no more after Ctrl-C."""
            if show is not None:
                show(done)
            return is_stopped()

        return place_sequence(problem, robots, gap=gap, runners_up=runners_up, progress=progress)


def _number_faults(robots: str | None, gap: float | None, runners_up: float | None) -> list[str]:
    """Return what is wrong with the numbers given as options."""
    faults = whole_faults("--robots", robots, 1, MOST_PLACED)
    if gap is not None and not 0.0 < gap < 1.0:
        faults.append(f"--gap is {gap:g}; it should be between 0 and 1, both excluded")
    if runners_up is not None and not 0.0 <= runners_up <= 1.0:
        faults.append(f"--runners-up is {runners_up:g}; it should be from 0 to 1")
    return faults


def _together_faults(
    robots: str | None, together: bool, effort: str | None, runners_up: float | None
) -> list[str]:
    """Return what is wrong with options that go with --together, or not."""
    faults = whole_faults("--effort", effort)
    if not together and effort is not None:
        faults.append("--effort is for robots placed together: add --together")
    if not together:
        return faults
    if (robots or "1").lstrip("0") == "1":
        faults.append("--together places several robots: add --robots 2 or more")
    if runners_up is not None:
        faults.append("--runners-up is for robots placed one after the other: leave out --together")
    return faults


def _beside(plot: Path) -> dict[Picture, Path]:
    """Return the paths of the three pictures, two of them beside the first."""
    return {
        "plan": plot,
        "wrenches": plot.with_name(f"{plot.stem}-wrenches{plot.suffix}"),
        "landscape": plot.with_name(f"{plot.stem}-landscape{plot.suffix}"),
    }
