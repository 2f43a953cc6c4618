"""`swarmgrasp place`: where the next robot goes."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from swarmgrasp.cli.criteria import criterion_of, losing_faults
from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.inputs import (
    PICTURES,
    UsageFault,
    json_faults,
    json_text,
    output_faults,
    print_json,
    put_json,
    read_scenario,
    source_of,
    whole_faults,
)
from swarmgrasp.cli.pictures import Picture
from swarmgrasp.cli.report import told_written
from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.ranges import MOST_PLACED

if TYPE_CHECKING:
    from swarmgrasp.placement import Placements
    from swarmgrasp.quality import Criterion
    from swarmgrasp.scenario import Scenario


def place(
    file: Dashed,
    /,
    *,
    robots: Annotated[str, Parameter(metavar="INT")] = "1",
    together: Annotated[bool, Parameter(negative="")] = False,
    effort: Annotated[str | None, Parameter(metavar="INT")] = None,
    losing: Annotated[str | None, Parameter(metavar="INT")] = None,
    worst_case: Annotated[bool, Parameter(negative="")] = False,
    gap: float | None = None,
    runners_up: float | None = None,
    plot: Path | None = None,
    json: Dashed | None = None,
) -> None:
    """Find where the next robot attaches and which way it pushes.

    Prints the contact, the direction, what the robot adds, how far the answer can be from
    the best, what limits the swarm then, and the next best places.

    Example: swarmgrasp place deck-barge --plot barge.png --json barge.json

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as deck-barge.
    robots
        How many robots like the newcomer to place, one after the other, 1 to 1000: each
        is best given those before it.
    together
        Place them all at once instead, which is often better; the bound is then for all of
        them. Takes --robots 2 or more.
    effort
        Steps of the search for robots placed together, 5000 unless given: about 2 ms each
        for a dozen robots. The same steps give the same answer on every machine.
    losing
        Make the quality after the worst loss of so many robots best, the newcomer perhaps
        among them.
    worst_case
        Make the quality best in the worst poses that the tolerances of the robots, and of the
        newcomer, allow.
    gap
        Stop when no place can be better by more than this share, relative to the answer;
        between 0 and 1, both excluded; 1e-6 unless given, or 1e-3 of robots placed together.
    runners_up
        Also list the best place on every other edge or zone that reaches this share of
        the best quality, from 0 (all that help) to 1 (only equals); 0.9 unless given.
    plot
        Write pictures of the plan (NAME.png), the wrenches (NAME-wrenches.png) and
        the landscape of all places (NAME-landscape.png); .png, .svg or .pdf.
    json
        Write the answer with its proof to this .json file, which `swarmgrasp verify`
        checks; "-" prints it and nothing else. SI units and radians. Robots placed
        together have no such proof.
    """
    gap = (1e-3 if together else 1e-6) if gap is None else gap
    share = 0.9 if runners_up is None else runners_up
    faults = _number_faults(robots, gap, share)
    faults += _together_faults(robots, together, effort, runners_up)
    faults += losing_faults(losing) + json_faults(json) + output_faults(plot, PICTURES)
    scenario = read_scenario(file, faults)
    criterion = criterion_of(scenario, file, losing, worst_case, int(robots))
    if together:
        _together(scenario, file, int(robots), gap, effort, criterion, plot, json)
        return
    answers = solve(scenario, file, int(robots), gap, share, criterion)
    # files first: whoever reads the report may leave before its end
    written: list[str | Path] = []
    if json not in (None, DASH):
        from swarmgrasp.answer_file import write_answer

        write_answer(str(json), answers, scenario.name)
        written.append(str(json))
    if plot is not None:
        from swarmgrasp.cli.pictures import pictures

        written += pictures(_beside(plot), scenario.swarm, answers, criterion)
    if json == DASH:
        from swarmgrasp.answer_file import document_of, document_text

        print_json(document_text(document_of(answers, scenario.name)))
    else:
        from swarmgrasp.cli.placed import show

        show(scenario.name, answers)
    told_written(written, aside=json == DASH)


def _together(
    scenario: "Scenario", file: str, robots: int, gap: float, effort: str | None,
    criterion: "Criterion", plot: Path | None, json: str | None,
) -> None:  # fmt: skip
    """Place the newcomers all at once."""
    from swarmgrasp.cli import jointly
    from swarmgrasp.placement.together.effort import EFFORT

    check_newcomer(scenario, file, robots)
    steps = EFFORT if effort is None else int(effort)
    found = jointly.solve(scenario, file, robots, gap, steps, criterion)
    data = jointly.data_of(scenario.name, found)
    if json == DASH:
        print_json(json_text(data))
    written: list[str | Path] = [*put_json(json, data)]
    if plot is not None:
        paths = _beside(plot)
        written += jointly.draw(found, paths["plan"], paths["wrenches"])
    if json != DASH:
        jointly.show(scenario.name, found)
    told_written(written, aside=json == DASH)


def solve(
    scenario: "Scenario",
    file: str,
    robots: int = 1,
    gap: float = 1e-6,
    runners_up: float = 0.9,
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
        If the scenario has no newcomer, leaves it no place, or has a robot of its name.
    """
    check_newcomer(scenario, file, robots)
    from swarmgrasp.cli.progress import shown_progress
    from swarmgrasp.placement import place_sequence

    try:
        problem = scenario.problem(criterion)
        with shown_progress(robots) as progress:
            return place_sequence(
                problem, robots, gap=gap, runners_up=runners_up, progress=progress
            )
    except SwarmGraspError as error:
        raise UsageFault(f"{source_of(file)}: {fault}" for fault in error.faults) from error


def check_newcomer(scenario: "Scenario", file: str, robots: int) -> None:
    """Raise `UsageFault` if there is no newcomer, or a robot has a name that one would get."""
    source = source_of(file)
    if scenario.newcomer is None:
        raise UsageFault(
            f"{source}:1:1: has no newcomer to place; add one, such as "
            "`newcomer: {limit: 100, attachment: push}`"
        )
    called = scenario.newcomer.name or "newcomer"
    names = {f"{called} {k}" for k in range(1, robots + 1)} if robots > 1 else set()
    taken = [repr(robot.name) for robot in scenario.swarm.robots if robot.name in names]
    if taken:
        raise UsageFault(
            f"{source}: {', '.join(taken)} is there already, and --robots {robots} gives that name "
            "to a newcomer; names should differ"
        )


def _number_faults(robots: str, gap: float, runners_up: float) -> list[str]:
    """Return what is wrong with the numbers given as options."""
    faults = whole_faults("--robots", robots, 1, MOST_PLACED)
    if not 0.0 < gap < 1.0:
        faults.append(f"--gap is {gap:g}; it should be between 0 and 1, both excluded")
    if not 0.0 <= runners_up <= 1.0:
        faults.append(f"--runners-up is {runners_up:g}; it should be from 0 to 1")
    return faults


def _together_faults(
    robots: str, together: bool, effort: str | None, runners_up: float | None
) -> list[str]:
    """Return what is wrong with options that go with --together, or not."""
    faults = whole_faults("--effort", effort)
    if not together and effort is not None:
        faults.append("--effort is for robots placed together: add --together")
    if not together:
        return faults
    if robots.lstrip("0") == "1":
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
