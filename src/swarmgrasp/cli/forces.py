"""`swarmgrasp forces`: how hard each robot pushes to make a wrench."""

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.inputs import (
    PICTURES,
    UsageFault,
    json_faults,
    output_faults,
    print_json,
    read_scenario,
)
from swarmgrasp.cli.question import asked_before, tell_omitted
from swarmgrasp.cli.wording import FILE, Wording
from swarmgrasp.cli.wrenches import Triple, number_faults, read_wrenches
from swarmgrasp.errors import SwarmGraspError

if TYPE_CHECKING:
    from swarmgrasp.scenario import Scenario

ThreeNumbers = Annotated[Triple | None, Parameter(metavar="FX FY TZ", negative="")]


def forces(
    file: Dashed,
    /,
    *,
    wrench: ThreeNumbers = None,
    wrenches: Path | None = None,
    load: ThreeNumbers = None,
    csv: Dashed | None = None,
    plot: Path | None = None,
    json: Dashed | None = None,
    wording: Wording = FILE,
) -> None:
    """Tell how hard each robot pushes to make a wrench.

    First the largest share is made as small as it can be, a share being a robot's force as a
    part of its limit; then the sum of the shares' squares. If the wrench is out of reach,
    the nearest one is made, and the report says by how much it falls short.

    Example: swarmgrasp forces deck-barge --wrench 300e3 0 0

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as
        deck-barge. Its newcomer is left out. Or an answer of this command, whose wrenches hold
        unless given anew.
    wrench
        What the object is to receive: force along x and along y [N], and torque [N m] about
        the outline's origin.
    wrenches
        Instead of one wrench those of a .csv file, one per line. Its first line names the
        columns, among them fx, fy and tz.
    load
        The wrench that the environment exerts on the object, such as wind and current, in the
        same units; the robots exert the rest. By default the scenario's load.
    csv
        Write the forces for all wrenches to this .csv file; "-" prints them and nothing else.
    plot
        Draw the forces for the wrench from above; .png, .svg or .pdf.
    json
        Also write the numbers to this .json file; "-" prints them and nothing else.
        SI units.
    """
    faults = _option_faults(wrench, wrenches, load, plot, csv, json)
    faults += json_faults(json) + output_faults(csv, (".csv",)) + output_faults(plot, PICTURES)
    table: tuple[Sequence[int], Sequence[Triple]] | None = None
    if wrenches is not None:
        try:
            table = read_wrenches(wrenches)
        except SwarmGraspError as error:
            faults += error.faults
    scenario = read_scenario(file, faults)
    if wrench is None and table is None:
        wrench = asked_before(scenario, "forces").get("wanted")
        rows = asked_before(scenario, "forces along").get("wanted")
        table = None if rows is None else (range(2, 2 + len(rows)), rows)
    tell_omitted(scenario, file, "forces", load=load)
    load = scenario.criterion.load if load is None else load
    if table is not None:
        _tell_many(scenario, *table, load, csv, json, wording)
        return
    if wrench is None:
        raise UsageFault("--wrench is missing; give three numbers, such as --wrench 300e3 0 0")
    from swarmgrasp.answer_file import document_of
    from swarmgrasp.cli.show.forces import show
    from swarmgrasp.forces import forces as forces_of

    found = forces_of(scenario.swarm, wrench, load=load)

    def draw() -> list[Path]:
        """Draw the forces if that is wanted."""
        if plot is None:
            return []
        from swarmgrasp.plot import forces_plan, save

        return [save(forces_plan(found), plot)]

    document = document_of(found, scenario.name)
    deliver(json, document, lambda: show(scenario.name, found, wording.terms(scenario)), draw)


def _tell_many(
    scenario: "Scenario", lines: Sequence[int], rows: Sequence[Triple], load: Triple,
    csv: str | None, json: str | None, wording: Wording,
) -> None:  # fmt: skip
    """Find and tell the forces for the wrenches of a table, each with its line there."""
    from swarmgrasp.answer_file import document_of
    from swarmgrasp.cli.show.trajectory import show, table_text
    from swarmgrasp.files import write_whole
    from swarmgrasp.forces import forces_along

    found = forces_along(scenario.swarm, rows, load=load)

    def write() -> list[str]:
        """Write the table if it goes to a file."""
        if csv in (None, DASH):
            return []
        write_whole(str(csv), table_text(found).encode())
        return [str(csv)]

    def tell() -> None:
        """Print the table if it is to be printed, else the report."""
        if csv == DASH:
            print_json(table_text(found))
        else:
            show(scenario.name, found, lines, wording.terms(scenario))

    deliver(json, document_of(found, scenario.name), tell, write, aside=csv == DASH)


def _option_faults(
    wrench: Triple | None,
    wrenches: Path | None,
    load: Triple | None,
    plot: Path | None,
    csv: str | None,
    json: str | None,
) -> list[str]:
    """Return what is wrong with the numbers, and with options that do not go together."""
    faults = []
    if wrench is not None and wrenches is not None:
        faults.append("--wrench and --wrenches do not go together; give one of them")
    if wrench is not None and csv is not None:
        faults.append("--csv goes with --wrenches; one wrench is written by --json")
    if wrenches is not None and plot is not None:
        faults.append("--plot goes with --wrench; it draws the forces for one")
    if csv == DASH and json == DASH:
        faults.append("--csv and --json cannot both be printed; give one of them a file")
    return faults + [
        f"--{name} is {' '.join(map(str, given))}; {fault}"
        for name, given in (("wrench", wrench), ("load", load))
        if given is not None
        for fault in number_faults(given)
    ]
