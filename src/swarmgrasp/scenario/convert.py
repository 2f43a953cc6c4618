"""A scenario made of what people have: an outline or a matrix, robots, and what was assumed."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

import numpy as np

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.outline.polygon import signed_area
from swarmgrasp.ranges import plain_name
from swarmgrasp.scenario.build import build
from swarmgrasp.scenario.document import Node
from swarmgrasp.scenario.faults import Faults
from swarmgrasp.scenario.imports.allocation import is_allocation_file, read_allocation
from swarmgrasp.scenario.imports.expand import OUTLINE_OPTIONS, expand, length_unit, noded
from swarmgrasp.scenario.imports.outlines import DETECT
from swarmgrasp.scenario.imports.source import Source
from swarmgrasp.scenario.reading import load_scenario
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.validate import check
from swarmgrasp.scenario.writing import scenario_text
from swarmgrasp.swarm.matrix import reach_of

SCENARIOS = (".yaml", ".yml")
"""Of files that may be scenarios already, perhaps of several files."""
ROUNDED = 1e-15
"""By how much a beam may exceed the length it is equal to, relative to it."""


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
    units: Mapping[str, str] | None = None,
    frame: Literal["ENU", "NED"] | None = None,
    bow: float | str | None = None,
    heading: float | str | None = None,
    limits: Sequence[Any] | None = None,
    part: str | None = None,
    scale: float | None = None,
    tolerance: float | str | None = None,
    mirror: bool | None = None,
    coordinates: Literal["degrees", "metres"] | None = None,
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
    units : mapping of str to str, optional
        As in a scenario; degrees and SI units when left out.
    frame, bow, heading
        As in a scenario.
    limits : sequence, optional
        Of the columns of a matrix, as in a scenario.
    part, scale, tolerance, mirror, coordinates
        What `outline` takes beside `file` in a scenario. Without `mirror`, what looks like one half
        of a hull is mirrored, its bow where it is pointed.

    Returns
    -------
    Converted

    Raises
    ------
    ScenarioInvalid
        If a file cannot be read or has faults; all of them are told.
    """
    file, faults = Path(path), Faults(str(path))
    is_matrix = is_allocation_file(file)
    of_outline = {
        "part": part, "scale": scale, "tolerance": tolerance, "mirror": mirror,
        "coordinates": coordinates,
    }  # fmt: skip
    of_file = {"units": units and dict(units), "frame": frame, "bow": bow, "heading": heading}
    of_outline, of_file = _given(of_outline), _given(of_file)
    beside = _given({"outline": outline, "robots": robots, "limits": limits})
    _check_options(file, is_matrix, {**beside, **of_file, **of_outline})
    if file.suffix.lower() in SCENARIOS and not is_matrix:
        return Converted(load_scenario(file), ())
    document: dict[str, Any] = {"units": {"angle": "deg"}}
    document |= {**of_file, "robots": [] if robots is None else _file(robots)}
    said: tuple[str, ...] = ()
    if is_matrix:
        document["allocation"] = _file(file)
        if limits is not None:
            document["allocation"]["limits"] = list(limits)
    if is_matrix and outline is None:
        said = _square(document, Source(file, faults))
    else:
        document["outline"] = {**_file(outline or file), "mirror": DETECT, **of_outline}
    if faults:
        raise faults.error()
    root = noded(document)
    taken = expand(root, faults, Path())
    if not taken.stand_ins:
        said += (*taken.said, *_ahead(root, taken.bow, bow))
    return Converted(build(check(root, faults, taken.stand_ins), file.stem), said)


def _given(options: dict[str, Any]) -> dict[str, Any]:
    """Return the options that are given."""
    return {key: value for key, value in options.items() if value is not None}


def _check_options(file: Path, is_matrix: bool, given: dict[str, Any]) -> None:
    """Refuse options that play no part for what a file is.

    Raises
    ------
    ScenarioInvalid
        All of them are told.
    """
    what, idle = "an outline", {"outline", "limits"}
    if is_matrix:
        what = "a matrix, and no outline is given"
        idle = set() if "outline" in given else set(OUTLINE_OPTIONS)
    elif file.suffix.lower() in SCENARIOS:
        what, idle = "a scenario", set(given)
    if idle & set(given):
        raise ScenarioInvalid(f"{file} is {what}: leave out {k}" for k in given if k in idle)


def _file(path: str | Path) -> dict[str, Any]:
    """Return what names a file in a scenario."""
    return {"file": str(Path(path).absolute())}


def _square(document: dict[str, Any], source: Source) -> tuple[str, ...]:
    """Put a square and a length into a document for a matrix; return what was assumed."""
    length = length_unit(noded(document))
    found = read_allocation(source, length)
    if found is None:
        return ()
    half = reach_of(np.array(found.rows).T) or 1.0
    corners = [[-half, -half], [half, -half], [half, half], [-half, half]]
    document["outline"] = {"vertices": corners, "origin": [0.0, 0.0]}
    document["metric"] = {"characteristic_length": half}
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
        # so that edges need no names to keep their numbers
        corners.value[1:] = corners.value[:0:-1]
    if bow is not None or not isinstance(root.value, dict):
        return ()
    if pointed not in ("", "+x"):
        root.value["bow"] = noded(pointed)
        return (f"The bow is where the hull is pointed, along {pointed}; it is turned to +x.",)
    length, beam = np.ptp(points, axis=0).tolist()
    if beam > length * (1.0 + ROUNDED):
        return ("The outline is longest along y, and x is taken for forward; bow says otherwise.",)
    return ()
