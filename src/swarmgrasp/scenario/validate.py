"""Check a document against the schema, and save what can be saved.

One bad value must not hide the others: it is noted, then replaced by a stand-in, so that
the rest can still be checked against the outline. A document with faults never becomes a
scenario, so no stand-in is ever used for more than that.
"""

import copy
from collections.abc import Collection
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from pydantic import BaseModel, ValidationError

from swarmgrasp.scenario.document import Node
from swarmgrasp.scenario.faults import Faults, Path
from swarmgrasp.scenario.hints import key_hint, value_hint
from swarmgrasp.scenario.newcomer_schema import NewcomerSection
from swarmgrasp.scenario.quantities import in_numbers, measured
from swarmgrasp.scenario.schema import ScenarioFile
from swarmgrasp.units import is_quantity

_AREAS = {"frontal_area": 1.0, "lateral_area": 1.0}

STAND_INS: dict[str, object] = {
    **_AREAS,
    "ahead": 1.0,
    "astern": 1.0,
    "at": 0.0,
    "bow": 1.0,
    "limit": 1.0,
    "limits": [],
    "matrix": [[], [], []],
    "name": "",
    "outline": {"vertices": [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]},
    "robot": "robot",
    "robots": [],
    "rows": [[1.0, 0.0, 0.0, 0.0, 0.0]] * 2,
    "stern": 1.0,
    "transverse": 1.0,
    "vertices": [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
    "wind": _AREAS,
}
"""A legal value for every required key."""

_SIZES = frozenset(("length", "beam", "lever"))
"""Lengths that have nothing to do with where something is."""


@dataclass(frozen=True, eq=False)
class Checked:
    """A document that fits the schema, and which parts of it are stand-ins.

    Attributes
    ----------
    file : ScenarioFile
    bad : set of tuple
        Paths whose values are stand-ins or were dropped.
    root : Node
        The document as it was written.
    faults : Faults
        Receives what is found later.
    """

    file: ScenarioFile
    bad: frozenset[Path]
    root: Node
    faults: Faults

    def is_sound(self, *path: str | int) -> bool:
        """Tell whether nothing at, above or below a path is a stand-in."""
        return path not in self._above and not _within(self.bad, path)

    @cached_property
    def _above(self) -> frozenset[Path]:
        """The bad paths and all that contain one."""
        return frozenset(b[:depth] for b in self.bad for depth in range(len(b) + 1))

    def is_known(self, *path: str | int) -> bool:
        """Tell whether a mapping is there at all, whatever its keys."""
        return not _within(self.bad, path)

    @cached_property
    def measures(self) -> dict[Path, set[bool]]:
        """Whether lengths say their unit, some or all of a part such as ("robots", 0)."""
        found: dict[Path, set[bool]] = {}
        for path, node in measured(self.root, ScenarioFile, ("length",)):
            if path[-1] not in _SIZES:
                found.setdefault(path[:2], set()).add(is_quantity(node.value))
        return found

    def has(self, *path: str | int) -> bool:
        """Tell whether a key is written in the document, sound or not."""
        holder = self.root.find(path[:-1]).value
        return isinstance(holder, dict) and path[-1] in holder

    def newcomers(self) -> list[tuple[NewcomerSection, Path]]:
        """Return the newcomer and all others that are sent, each with its path, if it is known."""
        simulation = self.file.simulation
        events = [] if simulation is None else simulation.events
        found: list[tuple[NewcomerSection | str | None, Path]] = [
            (self.file.newcomer, ("newcomer",)),
            *((event.send, ("simulation", "events", i, "send")) for i, event in enumerate(events)),
        ]
        return [
            (section, path)
            for section, path in found
            if isinstance(section, NewcomerSection) and self.is_known(*path)
        ]

    def fault(self, path: Path, sentence: str, *, got: bool = True) -> None:
        """Note a fault at the value a path leads to, and show the value."""
        node = self.root.find(path)
        shown = f" (got {node.shown()})" if got else ""
        self.faults.add(node.mark, path, sentence + shown)


def check(root: Node, faults: Faults, stand_ins: Collection[Path] = ()) -> Checked:
    """Check a document against the schema; note every fault with its place.

    Parameters
    ----------
    root : Node
    faults : Faults
    stand_ins : collection of tuple
        Paths to what is a stand-in already, its fault noted.

    Returns
    -------
    Checked
    """
    data, unread = in_numbers(root, ScenarioFile, faults)
    bad = {*stand_ins, *(_mend(data, path, "") for path in unread)}
    _drop_empty(data, (), root, bad, faults)
    while True:
        try:
            file = ScenarioFile.model_validate(data)
        except ValidationError as error:
            found = error.errors(include_url=False, include_input=False)
            paths = [_path(data, fault["loc"], fault["type"]) for fault in found]
            for fault, path in zip(found, paths, strict=True):
                if not _within(bad, path):
                    _note(fault, path, root, faults)
            for fault, path in zip(found, paths, strict=True):
                bad.add(_mend(data, path, fault["type"]))
        else:
            return Checked(file, frozenset(bad), root, faults)


def _within(bad: Collection[Path], path: Path) -> bool:
    """Tell whether a path is a bad one or lies inside one."""
    return any(path[:depth] in bad for depth in range(1, len(path) + 1))


def _drop_empty(data: Any, path: Path, root: Node, bad: set[Path], faults: Faults) -> None:
    """Drop keys without a value: an empty `zones:` is a slip, not "no zones"."""
    for key, value in list(data.items() if isinstance(data, dict) else enumerate(data)):
        here = (*path, key)
        if isinstance(value, (dict, list)):
            _drop_empty(value, here, root, bad, faults)
        elif value is None and isinstance(data, dict):
            bad.add(here)
            said = "has no value; give one or leave the key out"
            if key not in _known_keys(here):
                said = "has no value; if it goes on a text with a comma, put the text in quotes"
            faults.add(root.key_mark(here), here, said)
            del data[key]


def _path(data: Any, loc: tuple[int | str, ...], kind: str) -> Path:
    """Return an error's path without the parts that name a branch of a union."""
    path: list[int | str] = []
    for depth, part in enumerate(loc):
        if isinstance(data, dict):
            is_missing = kind == "missing" and depth == len(loc) - 1
            if part not in data and not is_missing:
                continue  # a branch again, of a mapping
            path.append(part)
            data = data.get(part)
        elif isinstance(data, list) and isinstance(part, int):
            path.append(part)
            data = data[part] if part < len(data) else None
    return tuple(path)


def _mend(data: Any, path: Path, kind: str) -> Path:
    """Make a place legal: drop its key, or put a stand-in where a key is required.

    Returns the path to what was dropped or replaced.
    """
    holder, mended = data, path[:1]
    for depth, part in enumerate(path):
        if isinstance(data, dict):
            holder, mended = data, path[: depth + 1]
            data = data.get(part)
        elif isinstance(data, list) and isinstance(part, int) and part < len(data):
            if kind == "model_type" and depth == len(path) - 1:
                data[part] = {}  # an item that should be a mapping
                return path
            data = data[part]
    if kind == "missing":
        holder[mended[-1]] = copy.deepcopy(STAND_INS[str(mended[-1])])
    else:
        holder.pop(mended[-1], None)
    return mended


def _note(found: Any, path: Path, root: Node, faults: Faults) -> None:
    """Note one error of pydantic's in our words."""
    kind, node = found["type"], root.find(path)
    if kind == "extra_forbidden":
        said = key_hint(str(path[-1]), _known_keys(path), _known_keys(path[:1]))
        faults.add(root.key_mark(path), path, said)
    elif kind == "missing":
        faults.add(node.mark, path, f"is missing; {WANTED[str(path[-1])]}")
    else:
        said = _SENTENCES.get(kind, found["msg"]).format_map(found.get("ctx", {}))
        other = _OR.get((str(path[-1]), str(found["loc"][-1]), kind), "should be")
        said = said.replace("should be", other) + value_hint(str(path[-1]), node.value)
        faults.add(node.mark, path, f"{said} (got {node.shown()})")


WANTED = {
    "ahead": "give the largest force along the direction",
    "astern": "give the largest force against the direction",
    "at": "give the time since the start [s]",
    "bow": "give the drag coefficient in a head wind",
    "frontal_area": "give the area seen from ahead",
    "lateral_area": "give the area seen from the side",
    "limit": "give the largest force",
    "limits": "give the largest force of each column, both ways, or [lowest, highest]",
    "matrix": "give three rows, surge, sway and yaw, or a file",
    "name": "say which robot",
    "outline": "give the object's outline by its vertices",
    "robot": "say what one robot is called",
    "robots": "list the robots already in contact, or give [] for none",
    "rows": "give rows of speed, bearing, surge, sway and yaw, or a file",
    "stern": "give the drag coefficient in a stern wind",
    "transverse": "give the drag coefficient in a beam wind",
    "vertices": "list the corners [x, y] in order",
    "wind": "give what the object shows to the wind",
}
"""What to do about a missing key, for every required one."""

_OR = {
    ("contact", "spread", "float_type"): "should be two offsets, or",
    ("direction", "spread", "float_type"): "should be two offsets, or",
    ("direction", "word", "literal_error"): "should be an angle,",
    ("edge", "value", "int_type"): "should be a name, or",
    ("load", "value", "list_type"): "should be 'environment', or",
    ("load", "word", "literal_error"): "should be [fx, fy, tz] or",
    ("origin", "word", "literal_error"): "should be [x, y] or",
    ("words", "value", "model_type"): "should be a word, such as tug, or",
    ("send", "value", "model_type"): "should be a newcomer's name, or",
    ("steers", "value", "float_type"): "should be 'any', or",
    ("steers", "word", "literal_error"): "should be an angle or",
}
"""What else may stand where a value of one kind has a fault."""

_SENTENCES = {
    "bool_type": "should be true or false",
    "finite_number": "should be a finite number",
    "float_type": "should be a number",
    "greater_than": "should be greater than {gt:g}",
    "greater_than_equal": "should be at least {ge:g}",
    "int_type": "should be a whole number",
    "less_than_equal": "should be at most {le:g}",
    "list_type": "should be a list",
    "literal_error": "should be {expected}",
    "model_type": "should be a mapping of keys to values",
    "string_unicode": "holds a control character; leave it out",
    "string_too_short": "should not be empty",
    "string_too_long": "should be at most {max_length} characters long",
    "string_type": "should be text; put it in quotes if it is",
    "too_long": "should hold {max_length} values, not {actual_length}",
    "too_short": "should hold {min_length} or more values, not {actual_length}",
}


def _section(path: Path) -> type[BaseModel]:
    """Return the model of the mapping that holds a path's last key."""
    model: type[BaseModel] = ScenarioFile
    for part in path[:-1]:
        for name, info in model.model_fields.items():
            if part == (info.alias or name):
                model = next(iter(models_in(info.annotation)), model)
    return model


def models_in(annotation: Any) -> list[type[BaseModel]]:
    """Return the models an annotation mentions."""
    if isinstance(annotation, type) and issubclass(annotation, BaseModel):
        return [annotation]
    return [m for part in getattr(annotation, "__args__", ()) for m in models_in(part)]


def _known_keys(path: Path) -> list[str]:
    """Return the keys allowed beside a path's last one."""
    return [info.alias or name for name, info in _section(path).model_fields.items()]
