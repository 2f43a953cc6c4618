"""`swarmgrasp convert`: a scenario made of the files that people have."""

import os
from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter

from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.inputs import UsageFault, output_faults


def convert(
    source: Path,
    out: Dashed,
    /,
    *,
    robots: Path | None = None,
    length: str = "m",
    part: str | None = None,
    scale: float | None = None,
    tolerance: str | None = None,
    mirror: bool | None = None,
    coordinates: Literal["degrees", "metres"] | None = None,
    force: Annotated[bool, Parameter(negative="")] = False,
) -> None:
    """Make a scenario of an outline from elsewhere, and say what was assumed.

    SOURCE is an outline in GeoJSON, CSV, SVG or DXF, or a scenario that takes parts from other
    files; OUT.yaml holds everything. The assumptions stand in it as comments, too.

    Example: swarmgrasp convert hull.geojson hull.yaml

    Parameters
    ----------
    source
        An outline in .geojson, .json, .csv, .tsv, .txt, .svg or .dxf, or a scenario in .yaml.
    out
        The scenario to write, or "-" to print it.
    robots
        A table of robots in CSV, its columns called as the keys of a robot.
    length
        Unit of length of a file that names none.
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
    from swarmgrasp.cli.show.report import clean, complain, told_written
    from swarmgrasp.files import write_whole
    from swarmgrasp.scenario import convert as converted

    faults = output_faults(out, (".yaml", ".yml"))
    if out != DASH and not faults and os.path.lexists(out) and not force:
        faults.append(f"{out}: exists already; --force overwrites it")
    if faults:
        raise UsageFault(faults)
    found = converted(
        source, robots=robots, units={"length": length}, part=part, scale=scale,
        tolerance=tolerance, mirror=mirror, coordinates=coordinates,
    )  # fmt: skip
    text = found.text(source.name)
    if out == DASH:
        print(text, end="")
        complain(found.said)
        return
    write_whole(out, text.encode())
    print("\n".join(map(clean, found.said)) or "Nothing had to be assumed.")
    told_written([out])
