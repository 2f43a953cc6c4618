"""A scenario made of what people have: an outline, perhaps robots, and what was assumed."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np

from swarmgrasp.outline.polygon import signed_area
from swarmgrasp.ranges import plain_name
from swarmgrasp.scenario.build import build
from swarmgrasp.scenario.document import Node
from swarmgrasp.scenario.faults import Faults
from swarmgrasp.scenario.imports.expand import OUTLINE_OPTIONS, expand
from swarmgrasp.scenario.imports.outlines import DETECT
from swarmgrasp.scenario.reading import load_scenario
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.validate import check
from swarmgrasp.scenario.writing import scenario_text

SCENARIOS = (".yaml", ".yml")
"""Of files that are scenarios already, perhaps of several files."""


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


def convert(path: str | Path, *, robots: str | Path | None = None, **options: Any) -> Converted:
    """Make a scenario of an outline in a file, or of a scenario that takes parts from others.

    Parameters
    ----------
    path : str or Path
        An outline, or a scenario in YAML.
    robots : str or Path, optional
        A table of robots that hold the object; none when left out.
    **options
        `units`, a mapping as in a scenario, and what `outline` takes beside `file` there: part,
        scale, tolerance, mirror and coordinates. Without `mirror`, what looks like one half of a
        hull is mirrored.

    Raises
    ------
    ScenarioInvalid
        If a file cannot be read or has faults; all of them are told.
    """
    file = Path(path)
    if file.suffix.lower() in SCENARIOS:
        return Converted(load_scenario(file), ())
    outline = {key: options[key] for key in OUTLINE_OPTIONS if options.get(key) is not None}
    document = {
        "units": options.get("units") or {},
        "outline": {"file": str(file.absolute()), "mirror": DETECT, **outline},
        "robots": [] if robots is None else {"file": str(Path(robots).absolute())},
    }
    root, faults = _node(document), Faults(str(path))
    taken = expand(root, faults, Path())
    corners = root.find(("outline", "vertices"))
    if isinstance(corners.value, list) and signed_area(np.array(corners.plain())) < 0.0:
        corners.value[1:] = corners.value[
            :0:-1
        ]  # so that edges need no names to keep their numbers
    scenario = build(check(root, faults, taken.stand_ins), file.stem)
    return Converted(scenario, taken.said)


def _node(value: Any) -> Node:
    """Return plain data as a document has it, without places."""
    if isinstance(value, dict):
        children = {key: _node(child) for key, child in value.items()}
        return Node((0, 0), children, key_marks=dict.fromkeys(children, (0, 0)))
    if isinstance(value, list):
        return Node((0, 0), [_node(child) for child in value])
    return Node((0, 0), value, str(value))
