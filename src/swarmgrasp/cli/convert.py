"""`swarmgrasp convert`: a scenario made of the files that people have."""

import os
from pathlib import Path
from typing import Annotated, Any, Literal

from cyclopts import Parameter

from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.inputs import UsageFault, output_faults


def convert(
    source: Path,
    out: Dashed,
    /,
    *,
    outline: Path | None = None,
    robots: Path | None = None,
    length: str | None = None,
    frame: Literal["ENU", "NED"] | None = None,
    bow: str | None = None,
    heading: str | None = None,
    limits: str | None = None,
    part: str | None = None,
    scale: float | None = None,
    tolerance: str | None = None,
    mirror: bool | None = None,
    coordinates: Literal["degrees", "metres"] | None = None,
    force: Annotated[bool, Parameter(negative="")] = False,
) -> None:
    """Make a scenario of what you have, and say what was assumed.

    SOURCE is an outline in GeoJSON, CSV, SVG or DXF; an allocation matrix in CSV, JSON, YAML or
    NumPy's format; or a scenario that takes parts from other files. OUT.yaml holds everything. The
    assumptions stand in it as comments, too.

    Example: swarmgrasp convert hull.geojson hull.yaml

    Parameters
    ----------
    source
        An outline in .geojson, .json, .csv, .tsv, .txt, .svg or .dxf, a matrix in .csv, .json,
        .yaml or .npy, or a scenario in .yaml.
    out
        The scenario to write, or "-" to print it.
    outline
        Of what a matrix is of; a square that holds all its lines of action when left out.
    robots
        A table of robots in CSV, its columns called as the keys of a robot.
    length
        Unit of length of the scenario, and of a file that names none; m unless given.
    frame
        ENU: y to port, angles counter-clockwise; NED: y to starboard, all that turns clockwise.
    bow
        Direction of the bow in the file's coordinates: an axis such as +y, or an angle.
    heading
        True bearing of the bow, which the scenario keeps.
    limits
        Of the columns of a matrix, separated by commas: 200kN is both ways, 0:60kN one way.
    part
        Which of several shapes: the name of a feature, an id, a layer or a handle.
    scale
        What one unit of the file is, in the unit of length.
    tolerance
        How far chords are off curves at most, such as 5cm; a ten thousandth of the outline's
        extent when left out.
    mirror
        The file holds one half of a hull, or does not; when left out, what looks like a half
        is mirrored.
    coordinates
        Whether they are degrees of longitude and latitude; by their range when left out.
    force
        Overwrite an existing file.
    """
    from swarmgrasp.cli.show.report import complain, told_written
    from swarmgrasp.files import write_whole
    from swarmgrasp.scenario import convert as converted
    from swarmgrasp.texts import clean

    faults = output_faults(out, (".yaml", ".yml"))
    if out != DASH and not faults and os.path.lexists(out) and not force:
        faults.append(f"{out}: exists already; --force overwrites it")
    if faults:
        raise UsageFault(faults)
    units = None if length is None else {"length": length, "angle": "deg"}
    found = converted(
        source, outline=outline, robots=robots, units=units,
        frame=frame, bow=_number(bow), heading=_number(heading), limits=_limits(limits), part=part,
        scale=scale, tolerance=tolerance, mirror=mirror, coordinates=coordinates,
    )  # fmt: skip
    text = found.text(source.name)
    if out == DASH:
        print(text, end="")
        complain(found.said)
        return
    write_whole(out, text.encode())
    print("\n".join(map(clean, found.said)) or "Nothing had to be assumed.")
    told_written([out])


def _number(text: str | None) -> float | str | None:
    """Return text as a number where it is one: degrees, then."""
    from swarmgrasp.scenario.document import resolve

    value = None if text is None else resolve(text)
    return value if isinstance(value, int | float) and not isinstance(value, bool) else text


def _limits(text: str | None) -> list[Any] | None:
    """Return the limits of columns, as a scenario has them; None if none are given."""
    if text is None:
        return None
    given = [[_number(end.strip()) for end in each.split(":")] for each in text.split(",")]
    return [each[0] if len(each) == 1 else each for each in given]
