"""A scenario made of what people have: an outline or a matrix, robots, and what was assumed."""

import math
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.outline.polygon import signed_area
from swarmgrasp.ranges import plain_name
from swarmgrasp.scenario.build import build
from swarmgrasp.scenario.document import Node
from swarmgrasp.scenario.faults import Faults
from swarmgrasp.scenario.imports.allocation import is_allocation_file, read_allocation
from swarmgrasp.scenario.imports.expand import OUTLINE_OPTIONS, expand, noded
from swarmgrasp.scenario.imports.outlines import DETECT
from swarmgrasp.scenario.imports.source import Source
from swarmgrasp.scenario.reading import load_scenario
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.validate import check
from swarmgrasp.scenario.writing import scenario_text
from swarmgrasp.swarm.matrix import reach_of

SCENARIOS = (".yaml", ".yml")
"""Of files that may be scenarios already, perhaps of several files."""
FILE_KEYS = ("units", "frame", "bow", "heading")
"""Keys of a scenario that say how a file is written."""


@dataclass(frozen=True)
class Converted:
    """A scenario, and what was assumed to make it.

    Attributes
    ----------
    scenario : Scenario
    said : tuple of str
        Sentences.
    """

    scenario: Scenario
    said: tuple[str, ...]

    def text(self, source: str) -> str:
        """Return the scenario as the text of a file, what was assumed as comments above it."""
        head = [f"# Made of {plain_name(source)} by swarmgrasp convert."]
        if self.said:
            head += ["# Assumed:", *(f"# - {plain_name(sentence)}" for sentence in self.said)]
        return "\n".join(head) + "\n\n" + scenario_text(self.scenario)


def convert(
    path: str | Path,
    *,
    outline: str | Path | None = None,
    robots: str | Path | None = None,
    **options: Any,
) -> Converted:
    """Make a scenario of an outline or of an allocation matrix in a file.

    Parameters
    ----------
    path : str or Path
        An outline, an allocation matrix, or a scenario in YAML that takes parts from other files.
    outline : str or Path, optional
        The outline of what a matrix is of; a square that holds all its lines of action when left
        out.
    robots : str or Path, optional
        A table of robots that hold the object; none when left out.
    **options
        `units`, `frame`, `bow` and `heading`, as in a scenario; `limits` of a matrix; and what
        `outline` takes beside `file` there: part, scale, tolerance, mirror and coordinates. Without
        `mirror`, what looks like one half of a hull is mirrored, its bow where it is pointed.

    Raises
    ------
    ScenarioInvalid
        If a file cannot be read or has faults; all of them are told.
    """
    file, faults = Path(path), Faults(str(path))
    is_matrix = is_allocation_file(file)
    given = {"outline": outline, "robots": robots, **options}
    _check_options(file, is_matrix, [key for key, value in given.items() if value is not None])
    if file.suffix.lower() in SCENARIOS and not is_matrix:
        return Converted(load_scenario(file), ())
    document = {key: options[key] for key in FILE_KEYS if options.get(key) is not None}
    document["robots"] = [] if robots is None else _file(robots)
    said: tuple[str, ...] = ()
    if is_matrix:
        document["allocation"] = _file(file)
        if options.get("limits") is not None:
            document["allocation"]["limits"] = options["limits"]
    if is_matrix and outline is None:
        said = _square(document, Source(file, faults))
    else:
        of_outline = {key: options[key] for key in OUTLINE_OPTIONS if options.get(key) is not None}
        document["outline"] = {
            **_file(outline or file),
            "mirror": DETECT,
            **of_outline,
        }
    if faults:
        raise faults.error()
    root = noded(document)
    taken = expand(root, faults, Path())
    if not taken.stand_ins:
        said += (*taken.said, *_ahead(root, taken.bow, options.get("bow")))
    return Converted(build(check(root, faults, taken.stand_ins), file.stem), said)


def _check_options(file: Path, is_matrix: bool, given: list[str]) -> None:
    """Refuse options that play no part for what a file is.

    Raises
    ------
    ScenarioInvalid
        All of them are told.
    """
    if is_matrix:
        return
    what, idle = "an outline", [key for key in given if key in ("outline", "limits")]
    if file.suffix.lower() in SCENARIOS:
        what, idle = "a scenario", [key for key in given if key != "units"]
    if idle:
        raise ScenarioInvalid(f"{file} is {what}: leave out {key}" for key in idle)


def _file(path: str | Path) -> dict[str, Any]:
    """Return what names a file in a scenario."""
    return {"file": str(Path(path).absolute())}


def _square(document: dict[str, Any], source: Source) -> tuple[str, ...]:
    """Put a square and a length into a document for a matrix; return what was assumed."""
    found = read_allocation(source)
    if found is None:
        return ()
    half = reach_of(np.array(found.rows).T) or 1.0
    corners = [[-half, -half], [half, -half], [half, half], [-half, half]]
    document["outline"] = {"vertices": corners, "origin": [0.0, 0.0]}
    document["metric"] = {"characteristic_length": half}
    length = (document.get("units") or {}).get("length", "m")
    return (
        f"The matrix has no outline: a square of {2.0 * half:.6g} {length} about its origin stands "
        "for the object.",
        f"Force and torque are compared by the largest arm of the columns, {half:.6g} {length}; "
        "metric.characteristic_length says otherwise.",
        "Each thruster is where its line of action is nearest to the origin, a pure torque there.",
        "Limits of one number are both ways.",
    )


def _ahead(root: Node, pointed: str, bow: Any) -> tuple[str, ...]:
    """Turn the outline of a document counter-clockwise, and its bow ahead; return what was assumed.

    Parameters
    ----------
    root : Node
    pointed : str
        The axis that a mirrored half is pointed along; "" if none.
    bow
        What was said of it; None for nothing.
    """
    corners = root.find(("outline", "vertices"))
    points = np.array(corners.plain(), dtype=float)
    if signed_area(points) < 0.0 and isinstance(corners.value, list):
        corners.value[1:] = corners.value[
            :0:-1
        ]  # so that edges need no names to keep their numbers
    if bow is not None or not isinstance(root.value, dict):
        return ()
    if pointed not in ("", "+x"):
        root.value["bow"] = noded(pointed)
        return (f"The bow is where the hull is pointed, along {pointed}; it is turned to +x.",)
    length, beam = np.ptp(points, axis=0).tolist()
    if beam > length * (1.0 + math.ulp(1.0) * 8):
        return ("The outline is longest along y, and x is taken for forward; bow says otherwise.",)
    return ()
