"""Write a scenario into the text of a file: what has changed, and nothing else."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import replace
from difflib import SequenceMatcher
from typing import Any

import numpy as np

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.scenario.file_keys import FileKeys
from swarmgrasp.scenario.imports.expand import Folder
from swarmgrasp.scenario.reading import parse_scenario
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.splice import Part, Splice
from swarmgrasp.scenario.spots import SPOT, Spots
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.writing import told
from swarmgrasp.scenario.yaml_lines import flow

EQUAL = 1e-12
"""Relative difference of two numbers of a scenario that is none."""
MOST_ROUNDS = 4
"""Times that a text is changed, until it says all: what one change moves, the next puts back."""
STRETCH = (*SPOT, "from", "to", "area")
FORCES = ("limit", "two_way", "friction", "envelope")
ROBOT = (
    ("name",), ("direction",), FORCES, ("steers",), ("sectors",), ("lever",), ("group",),
    ("mounted",), ("length", "beam"), ("tolerance",),
)  # fmt: skip
"""Keys of a robot that are said together, but those of where it is;"""
NEWCOMER = (
    ("name",), FORCES, ("attachment", "half_angle"), ("steers",), ("mounted",), ("length", "beam"),
    ("tolerance",),
)  # fmt: skip
"""of a newcomer;"""
ZONE = (("attachment", "half_angle"), ("directions",))
"""of a zone, but for where and its name."""


def edited(text: str, scenario: Scenario, source: str = "<text>", folder: Folder = None) -> str:
    r"""Return the text of a scenario file with what is different in a scenario put into it.

    All else stays as it is written: comments, order, units, frame, and how places are said where
    that still says them. What changed is in the units and the frame of the file.

    Parameters
    ----------
    text : str
        Of a scenario file without faults.
    scenario : Scenario
        What the text is to say; its terms and its simulation are those of the text.
    source, folder
        As for `parse_scenario`.

    Returns
    -------
    str
        Read again, it is equal to the scenario, each number to 1e-12 of itself.

    Raises
    ------
    ScenarioInvalid
        If the text has faults, or cannot say what has changed; all of that is told.

    Examples
    --------
    >>> text = '''
    ... units: {length: ft, force: tf, angle: deg}
    ... outline: {vertices: [[0, 0], [40, 0], [40, 20], [0, 20]], edges: [s, e, n, w]}
    ... robots:
    ...   - {name: Ajax, edge: e, along: 5, direction: inward, limit: 60}  # on the bow
    ... '''
    >>> asked = parse_scenario(text)
    >>> moved = asked.swarm.with_pose("Ajax", (40 * 0.3048, 6.5 * 0.3048))
    >>> print(edited(text, replace(asked, swarm=moved)).splitlines()[4])
      - {name: Ajax, edge: e, along: 6.5, direction: inward, limit: 60}  # on the bow
    """
    faults: list[str] = []
    for left in reversed(range(MOST_ROUNDS)):
        before = parse_scenario(text, source, folder)
        same = replace(scenario, simulation=before.simulation)
        faults = list(_differences(told(before), told(same), ()))
        if not faults or not left:
            break
        text = _Edit(text, before, scenario).result()
    if faults:
        raise ScenarioInvalid(faults)
    return text


def _differences(one: Any, other: Any, path: tuple[str, ...]) -> Iterator[str]:
    """Tell where plain data are not equal, numbers to `EQUAL` of the largest beside them."""
    if isinstance(one, dict) and isinstance(other, dict):
        for key in one:
            yield from _differences(one[key], other.get(key), (*path, key))
    elif isinstance(one, list) and isinstance(other, list) and len(one) == len(other):
        if one and all(isinstance(each, float | int) for each in [*one, *other]):
            if not _is_close(one, other):
                yield _said(one, other, path)
            return
        for i, pair in enumerate(zip(one, other, strict=True)):
            yield from _differences(*pair, (*path, str(i)))
    elif isinstance(one, float | int) and isinstance(other, float | int):
        if not _is_close([one], [other]):
            yield _said(one, other, path)
    elif one != other:
        yield _said(one, other, path)


def _said(one: Any, other: Any, path: tuple[str, ...]) -> str:
    """Return the sentence for what a file cannot say."""
    return f"{'.'.join(path)}: {other!r} cannot be put into the text, which says {one!r}"


def _is_close(one: Sequence[float], other: Sequence[float]) -> bool:
    """Tell whether numbers are equal, rounding aside."""
    most = max(map(abs, [*one, *other]))
    return all(abs(a - b) <= EQUAL * most for a, b in zip(one, other, strict=True))


class _Edit:
    """One change of a text.

    Parameters
    ----------
    text : str
    before : Scenario
        What it says.
    after : Scenario
        What it should say.
    """

    def __init__(self, text: str, before: Scenario, after: Scenario) -> None:
        terms = before.terms
        units = Units(terms.length, terms.force, terms.angle, terms.speed, terms.frame)
        self.before, self.after = before, after
        self.splice = Splice(text)
        self.root = self.splice.root
        speed = self.root.get("units") and self.root.get("units").get("speed")  # type: ignore[union-attr]
        if speed is not None and str(speed.value).lower().startswith(("b", "f")):
            units = replace(units, speed="Bft")
        self.keys = FileKeys(units)
        self.spots = Spots(self.keys, before.swarm.outline, after.swarm.outline)

    def result(self) -> str:
        """Return the text changed."""
        before, after = self.before, self.after
        for key in ("name", "description"):
            if getattr(before, key) != getattr(after, key):
                self._set(self.root, key, getattr(after, key) or None)
        if before.spacing != after.spacing:
            self._set(self.root, "spacing", self.keys.length(after.spacing) or None)
        if self.spots.is_moved:
            self._outline()
        self._metric()
        self._robots()
        self._newcomer()
        self._zones()
        self._no_go()
        self._criterion()
        self._environment()
        return self.splice.result()

    # -- keys -------------------------------------------------------------------------

    def _set(self, holder: Part, key: str, value: Any) -> None:
        """Say a value under a key; None removes it, and an equal one stays as it is written."""
        there = holder.get(key)
        if value is None:
            if there is not None:
                self.splice.remove(holder, holder.keys[key])
        elif there is None:
            self.splice.insert(holder, len(holder.items), f"{key}: {flow(value)}")
        else:
            self._put(there, value)

    def _put(self, there: Part, value: Any) -> None:
        """Say a value in the place of another."""
        if isinstance(value, list) and there.is_list and len(value) == len(there.items):
            for item, part in zip(there.items, value, strict=True):
                self._put(item, part)
        elif not _is_said(there, value):
            self.splice.put(there, flow(value))

    def _groups(
        self, holder: Part, groups: Sequence[tuple[str, ...]], old: dict[str, Any],
        new: dict[str, Any],
    ) -> None:  # fmt: skip
        """Say those groups of keys of which something is different."""
        for group in groups:
            if any(old.get(key) != new.get(key) for key in group):
                for key in group:
                    self._set(holder, key, new.get(key))

    # -- sections ---------------------------------------------------------------------

    def _outline(self) -> None:
        """Say corners that moved, came or went, and the origin and the precision."""
        section = self.root.get("outline")
        if section is None:
            return
        old, outline = self.before.swarm.outline, self.after.swarm.outline
        new, vertices = self.keys.outline(outline), section.get("vertices")
        if vertices is None:
            if section.get("file") is not None:  # the corners are no longer those of the file
                self._set(self.root, "outline", new)
            return
        corners, names = self.spots.as_written(vertices, new["vertices"], new.get("edges"))
        if len(corners) == len(vertices.items):
            self._put(vertices, corners)
        else:
            self._rows(vertices, corners)
        if old.edge_names != outline.edge_names:
            self._set(section, "edges", names)
        if tuple(old.origin) != tuple(outline.origin):
            self._set(section, "origin", new.get("origin"))
        if old.precision != outline.precision:
            self._set(section, "precision", self.keys.length(outline.precision))

    def _rows(self, holder: Part, rows: list[Any]) -> None:
        """Say the rows of a list, those that stay as they are written."""
        old = [_key(item.plain()) for item in holder.items]
        matcher = SequenceMatcher(None, old, [_key(row) for row in rows], autojunk=False)
        for kind, i1, i2, j1, j2 in matcher.get_opcodes():
            if kind == "equal":
                continue
            both = min(i2 - i1, j2 - j1)
            for k in range(both):
                self._put(holder.items[i1 + k], rows[j1 + k])
            for i in range(i1 + both, i2):
                self.splice.remove(holder, i)
            for j in range(j1 + both, j2):
                self.splice.insert(holder, i2, flow(rows[j]))

    def _metric(self) -> None:
        """Say the metric."""
        wanted = self.keys.metric(self.after.swarm)
        if wanted == self.keys.metric(self.before.swarm):
            return
        section = self.root.get("metric")
        if section is None:
            self._set(self.root, "metric", wanted or None)
            return
        for key in ("force_weights", "characteristic_length"):
            self._set(section, key, wanted.get(key))

    def _robots(self) -> None:
        """Say robots that changed, came or went."""
        section, old, new = self.root.get("robots"), self.before.swarm, self.after.swarm
        listed = section.items if section is not None and section.is_list else []
        others = list(old.robots[len(listed) :])
        count = max(len(new) - len(others), 0)
        is_whole = section is not None and section.is_list and list(new.robots[count:]) == others
        if not is_whole:
            if old != new:
                self._set(self.root, "allocation", None)
                self._whole("robots", list(map(self.keys.robot, new.robots)))
            return
        assert section is not None
        pairs = _pairs(list(old.names)[: len(listed)], list(new.names)[:count])
        for at, i, j in pairs:
            if i is None and j is not None:
                self.splice.insert(section, at, flow(self.keys.robot(new.robots[j])))
            elif i is not None and j is None:
                self.splice.remove(section, i)
            elif i is not None and j is not None:
                self._robot(section, i, j)

    def _robot(self, section: Part, i: int, j: int) -> None:
        """Say one robot."""
        entry, old, new = section.items[i], self.before.swarm.robots[i], self.after.swarm.robots[j]
        if old == new and not self.spots.is_moved:
            return
        was, will = self.keys.robot(old), self.keys.robot(new)
        if not entry.is_mapping:  # said elsewhere
            self.splice.put(entry, flow(will))
            return
        self._groups(entry, [group for group in ROBOT if group != ("direction",)], was, will)
        if old.tolerance != new.tolerance and new.tolerance is None and self.root.get("tolerance"):
            self._set(entry, "tolerance", {})
        spot, edge = self.spots.of_robot(entry, old, new)
        for key, value in spot.items():
            self._set(entry, key, value)
        way = entry.get("direction")
        is_word = way.value in ("inward", "outward") if way is not None else bool(new.friction)
        if is_word and "direction" in will:
            turn = math.pi if way is not None and way.value == "outward" else 0.0
            if edge is not None:
                normal = self.after.swarm.outline.inward_normal(edge) + turn
                if abs(math.remainder(normal, math.tau) - new.direction) <= EQUAL:
                    return
        elif was.get("direction") == will.get("direction"):
            return
        self._set(entry, "direction", will.get("direction"))

    def _whole(self, key: str, items: list[dict[str, Any]] | None) -> None:
        """Say a list anew, an item a line."""
        there = self.root.get(key)
        said = "".join(f"\n  - {flow(item)}" for item in items or []) or " []"
        if there is not None:
            self.splice.remove(self.root, self.root.keys[key])
        if items is not None:
            self.splice.insert(self.root, len(self.root.items), f"{key}:{said}")

    def _newcomer(self) -> None:
        """Say who is to be placed."""
        old, new = self.before.newcomer, self.after.newcomer
        section = self.root.get("newcomer")
        if old == new:
            return
        will = None if new is None else self.keys.newcomer(new)
        if old is None or will is None or section is None or not section.is_mapping:
            self._set(self.root, "newcomer", will)
            return
        self._groups(section, NEWCOMER, self.keys.newcomer(old), will)
        if old.tolerance and not (new and new.tolerance) and self.root.get("tolerance"):
            self._set(section, "tolerance", {})

    def _zones(self) -> None:
        """Say where a newcomer may attach."""
        old, new = self.before.zones, self.after.zones
        if old == new and not self.spots.is_moved:
            return
        section = self.root.get("zones")
        if old is None or new is None or section is None or not section.is_list:
            self._whole("zones", None if new is None else list(map(self._zone_keys, new)))
            return
        pairs = _pairs(
            [_key(zone.to_data()) for zone in old], [_key(zone.to_data()) for zone in new]
        )
        for at, i, j in pairs:
            if i is None and j is not None:
                self.splice.insert(section, at, flow(self._zone_keys(new[j])))
            elif i is not None and j is None:
                self.splice.remove(section, i)
            elif i is not None and j is not None:
                entry = section.items[i]
                if not entry.is_mapping:
                    self.splice.put(entry, flow(self._zone_keys(new[j])))
                    continue
                self._groups(entry, ZONE, self.keys.zone(old[i]), self.keys.zone(new[j]))
                self._where(entry, old[i].stretch, new[j].stretch, old[i].name, new[j].name)
                if new[j].area is not None:
                    self._set(entry, "area", self.keys.zone(new[j])["area"])

    def _zone_keys(self, zone: Any) -> dict[str, Any]:
        """Return a new zone by the keys of the file."""
        keys = self.keys.zone(zone)
        return keys if zone.stretch is None else {**keys, **self.spots.by_arc(zone.stretch)}

    def _no_go(self) -> None:
        """Say where no newcomer may attach."""
        old, new = self.before.no_go, self.after.no_go
        section = self.root.get("no_go")
        if old == new and not self.spots.is_moved:
            return
        if section is None or not section.is_list or not new:
            self._whole("no_go", [self._stretch_keys(one) for one in new] or None)
            return
        pairs = _pairs([_key(one.to_data()) for one in old], [_key(one.to_data()) for one in new])
        for at, i, j in pairs:
            if i is None and j is not None:
                self.splice.insert(section, at, flow(self._stretch_keys(new[j])))
            elif i is not None and j is None:
                self.splice.remove(section, i)
            elif i is not None and j is not None:
                entry = section.items[i]
                if entry.is_mapping:
                    self._where(entry, old[i], new[j], old[i].name, new[j].name)
                else:
                    self.splice.put(entry, flow(self._stretch_keys(new[j])))

    def _stretch_keys(self, stretch: Any) -> dict[str, Any]:
        """Return a new stretch by the keys of the file."""
        name = {"name": stretch.name} if stretch.name else {}
        return {**name, **self.spots.by_arc(stretch)}

    def _where(self, entry: Part, old: Any, new: Any, was: str, will: str) -> None:
        """Say where a stretch is, and its name: that of its edge where it has none."""
        if new is not None and old is not None:
            for key, value in self.spots.of_stretch(entry, old, new).items():
                self._set(entry, key, value)
                if key == "edge" and value is None and will and entry.get("name") is None:
                    self._set(entry, "name", will)
        if was != will:
            self._set(entry, "name", will or None)

    def _criterion(self) -> None:
        """Say what quality means."""
        before, after = self.before, self.after
        section = self.root.get("criterion")
        word = None if section is None else section.get("load")
        will = self.keys.criterion(after.criterion)
        is_weather = after.is_in_weather
        if is_weather:
            will["load"] = "environment"
        if before.criterion == after.criterion:
            return
        was = self.keys.criterion(before.criterion)
        if word is not None and word.value == "environment":
            was["load"] = "environment"
        if section is None or not section.is_mapping:
            self._set(self.root, "criterion", will or None)
        elif not will:
            self._set(self.root, "criterion", None)
        else:
            groups = [(key,) for key in ("losing", "failures", "worst_case", "load", "task")]
            self._groups(section, groups, was, will)

    def _environment(self) -> None:
        """Say wind, current and waves."""
        old, new = self.before.environment, self.after.environment
        if old == new:
            return
        section = self.root.get("environment")
        will = None if new is None else self.keys.environment(new)
        if old is None or will is None or section is None:
            self._set(self.root, "environment", will)
            return
        was = self.keys.environment(old)
        for key in ("wind", "current", "waves"):
            part, one, other = section.get(key), was.get(key), will.get(key)
            if one == other:
                continue
            if part is None or one is None or other is None or not part.is_mapping:
                self._set(section, key, other)
                continue
            self._groups(part, [(name,) for name in {**one, **other}], one, other)
        if was.get("dynamic_factor") != will.get("dynamic_factor"):
            self._set(section, "dynamic_factor", will.get("dynamic_factor"))


def _is_said(part: Part, value: Any) -> bool:
    """Tell whether a part says a value already."""
    said = part.plain()
    is_number = isinstance(said, float | int) and isinstance(value, float | int)
    if is_number and not isinstance(said, bool) and not isinstance(value, bool):
        return _is_close([float(said)], [float(value)])  # type: ignore[arg-type]
    return said == value and (not part.items or part.is_flow)


def _key(value: Any) -> str:
    """Return plain data as what can be looked up."""
    return repr(np.array(value).tolist() if isinstance(value, list) else value)


def _pairs(old: Sequence[str], new: Sequence[str]) -> Iterator[tuple[int, int | None, int | None]]:
    """Match what was with what will be: each place to insert at, and one or both indices."""
    matcher = SequenceMatcher(None, old, new, autojunk=False)
    for _, i1, i2, j1, j2 in matcher.get_opcodes():
        is_even = i2 - i1 == j2 - j1
        for k in range(i2 - i1 if is_even else 0):
            yield i1 + k, i1 + k, j1 + k
        if not is_even:
            yield from ((i, i, None) for i in range(i1, i2))
            yield from ((i2, None, j) for j in range(j1, j2))
