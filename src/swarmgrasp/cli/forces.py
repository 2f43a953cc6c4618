"""`swarmgrasp forces`: how hard each robot pushes to make a wrench."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, NamedTuple

from cyclopts import Parameter

from swarmgrasp.cli.criteria import failures_of
from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.drawing import USUAL, Drawing
from swarmgrasp.cli.inputs import (
    UsageFault,
    json_faults,
    noting,
    print_json,
    read_scenario,
)
from swarmgrasp.cli.question import asked_before, tell_omitted
from swarmgrasp.cli.weather import CALM, Weather
from swarmgrasp.cli.wording import FILE, Wording
from swarmgrasp.cli.wrenches import COLUMNS, Triple, Wrench, Wrenches, read_wrenches

if TYPE_CHECKING:
    from swarmgrasp.scenario import Scenario

STRAIGHT = 1e-9
"""Difference of a component from 1 that counts as none."""
Three = Annotated[
    tuple[str, str, str] | None,
    Parameter(metavar="FX FY TZ", negative="", allow_leading_hyphen=True),
]


def forces(
    file: Dashed,
    /,
    *,
    wrench: Three = None,
    wrenches: Path | None = None,
    load: Three = None,
    keep_direction: Annotated[bool, Parameter(negative="")] = False,
    losing: Annotated[list[str] | None, Parameter(metavar="NAMES", negative="")] = None,
    plot: Path | None = None,
    drawing: Drawing = USUAL,
    json: Dashed | None = None,
    weather: Weather = CALM,
    wording: Wording = FILE,
) -> None:
    """Tell how hard each robot pushes to make a wrench.

    First the largest share is made as small as it can be, a share being a robot's force as a
    part of its limit; then the sum of the shares' squares. If the wrench is out of reach,
    the nearest one is made, and the report says by how much it falls short.

    Example: swarmgrasp forces deck-barge --wrench 300kN 0 0

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as
        deck-barge. Its newcomer is left out. Or an answer of this command, whose wrenches hold
        unless given anew.
    wrench
        What the object is to receive: force along x and along y, and torque about the outline's
        origin, in the file's frame, such as 300kN 0 "50 kN m". A part that does not matter is
        "any": --wrench 0 any 3.6. Left out where there is a load: to hold it.
    wrenches
        Instead of one wrench those of a .csv file, one per line, in the file's frame. Its first
        line names the columns, among them fx, fy and tz, perhaps with units: fx [kN].
    load
        The wrench that the environment exerts on the object, such as wind and current, in the
        same frame; the robots exert the rest. By default the scenario's load.
    keep_direction
        If the wrench is out of reach, make the largest multiple of it that is not, instead of the
        nearest one.
    losing
        Without these robots or groups, by name, several with commas.
    plot
        Draw the forces for the wrench from above; .png, .svg or .pdf.
    json
        Also write the numbers to this .json file; "-" prints them and nothing else.
        SI units.
    """
    faults = _option_faults(wrench, wrenches, keep_direction, plot)
    faults += json_faults(json) + wording.faults(json) + drawing.faults(plot)
    if load is not None and weather.given:
        faults.append(f"--load and {next(iter(weather.given))} each say the load; keep one")
    wanted = Wrench("--wrench", wrench or ("0", "0", "0"))
    held = Wrench("--load", load or ("0", "0", "0"))
    faults += wanted.faults() + held.faults()
    faults += ["--load has a part that is any; a load is what it is"] * bool(held.free)
    table: Wrenches | None = None
    if wrenches is not None:
        with noting(faults):
            table = read_wrenches(wrenches)
    scenario = weather.on(read_scenario(file, faults + weather.faults()), file, wording)
    terms = wording.terms(scenario)
    if losing:
        scenario = _without(scenario, losing)
    told = wrench is not None
    asked = _ours(scenario, wanted.value(terms))
    lines: Sequence[int] = ()
    rows: Sequence[Triple] = ()
    if table is not None:
        lines, rows = table.lines, [_ours(scenario, each) for each in table.values(terms)]
    elif not told:
        before = asked_before(scenario, "forces").get("wanted")
        told, asked = before is not None, asked if before is None else before
        rows = asked_before(scenario, "forces along").get("wanted", ())
        lines = range(2, 2 + len(rows))
    tell_omitted(scenario, file, "forces", load=load or weather.given)
    x, y, turn = scenario.criterion.load if load is None else _ours(scenario, held.value(terms))
    beside = (x, y, turn)
    if len(rows):
        _tell_many(scenario, lines, rows, beside, json, wording)
        return
    if not told and not any(beside):
        raise UsageFault("--wrench is missing; give three numbers, such as --wrench 300kN 0 0")
    _tell_one(scenario, _Asked(asked, beside, _free(scenario, wanted.free), keep_direction),
              plot, drawing, json, wording)  # fmt: skip


class _Asked(NamedTuple):
    """What is asked: a wrench, a load beside it, the wrench's parts that do not matter, and how."""

    wrench: Triple
    load: Triple
    free: list[str]
    keeps_direction: bool


def _tell_one(
    scenario: "Scenario", asked: _Asked, plot: Path | None, drawing: Drawing, json: str | None,
    wording: Wording,
) -> None:  # fmt: skip
    """Find and tell the forces for one wrench."""
    import numpy as np

    from swarmgrasp.answer_file import document_of
    from swarmgrasp.cli.show.forces import show
    from swarmgrasp.forces import forces as forces_of
    from swarmgrasp.forces import largest_multiple, with_free_parts

    swarm, wrench, load = scenario.swarm, asked.wrench, asked.load
    if asked.free:
        x, y, turn = with_free_parts(swarm, wrench, asked.free, load=load).tolist()
        wrench = (x, y, turn)
    found, nearest = forces_of(swarm, wrench, load=load), None
    times = 1.0
    if asked.keeps_direction and found.is_degraded:
        nearest, times = found, largest_multiple(swarm, wrench, load=load)
        found = forces_of(swarm, times * np.array(wrench), load=load)
    terms = wording.terms(scenario)

    def draw() -> list[Path]:
        """Draw the forces if that is wanted."""
        if plot is None:
            return []
        from swarmgrasp.plot import forces_plan, save

        look = drawing.look(scenario.name, terms)
        figure = forces_plan(found, environment=scenario.environment, **look)
        return [save(figure, plot)]

    def tell() -> None:
        """Tell the forces."""
        show(scenario, found, terms, free=asked.free, times=times, nearest=nearest)

    deliver(
        json, document_of(found, scenario.name, terms=scenario.terms), tell, draw, csv=wording.csv
    )


def _ours(scenario: "Scenario", wrench: Triple) -> Triple:
    """Return a wrench of the file's frame in ours."""
    x, y, turn = scenario.terms.frame.wrench_from_file(wrench).tolist()
    return x, y, turn


def _free(scenario: "Scenario", free: list[str]) -> list[str]:
    """Return the parts of a wrench in our frame that are free in the file's.

    Raises
    ------
    UsageFault
        If the file's axes lie askew to ours, so that no part of ours is free.
    """
    found = []
    for part in free:
        axis = scenario.terms.frame.wrench_from_file([float(part == each) for each in COLUMNS])
        at = int(abs(axis).argmax())
        if abs(abs(axis[at]) - 1.0) > STRAIGHT:
            raise UsageFault(
                f"--wrench has any for {part}, and x of the file lies askew to the bow; give "
                "numbers, or turn the file's coordinates"
            )
        found.append(COLUMNS[at])
    return found


def _without(scenario: "Scenario", losing: Sequence[str]) -> "Scenario":
    """Return a scenario without robots and groups that an option names."""
    from dataclasses import replace

    swarm = scenario.swarm
    names = {name for failure in failures_of(scenario, losing, "--losing") for name in failure}
    gone = [i for i, robot in enumerate(swarm) if {robot.name, robot.group} & names]
    return replace(scenario, swarm=swarm.without_rows(gone))


def _tell_many(
    scenario: "Scenario", lines: Sequence[int], rows: Sequence[Triple], load: Triple,
    json: str | None, wording: Wording,
) -> None:  # fmt: skip
    """Find and tell the forces for the wrenches of a table, each with its line there."""
    from swarmgrasp.answer_file import document_of
    from swarmgrasp.cli.show.trajectory import show, table_text
    from swarmgrasp.files import write_whole
    from swarmgrasp.forces import forces_along

    found, csv = forces_along(scenario.swarm, rows, load=load), wording.csv
    terms = wording.terms(scenario)

    def write() -> list[str]:
        """Write the table if it goes to a file."""
        if csv in (None, DASH):
            return []
        write_whole(str(csv), table_text(found, terms).encode())
        return [str(csv)]

    def tell() -> None:
        """Tell the forces, or print all of them."""
        if csv == DASH:
            print_json(table_text(found, terms))
        else:
            show(scenario.name, found, lines, terms)

    deliver(json, document_of(found, scenario.name, terms=scenario.terms), tell, write)


def _option_faults(
    wrench: Sequence[str] | None,
    wrenches: Path | None,
    keep_direction: bool,
    plot: Path | None,
) -> list[str]:
    """Return what is wrong with options that do not go together."""
    faults = []
    if wrench is not None and wrenches is not None:
        faults.append("--wrench and --wrenches do not go together; give one of them")
    if wrenches is not None and keep_direction:
        faults.append("--keep-direction goes with --wrench; it is of one wrench")
    if wrenches is not None and plot is not None:
        faults.append("--plot goes with --wrench; it draws the forces for one")
    return faults
