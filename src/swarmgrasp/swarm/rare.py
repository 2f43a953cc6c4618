"""What few robots have: tolerances, envelopes, groups, sectors and bodies, by index."""

from collections.abc import Callable, Collection, Iterable, Mapping
from dataclasses import dataclass, field, fields, replace
from typing import Any

from swarmgrasp.frozen import Frozen
from swarmgrasp.swarm.body import Body
from swarmgrasp.swarm.columns import FAR, Couple, couple_of
from swarmgrasp.swarm.robot import Envelope, Robot
from swarmgrasp.swarm.sectors import Sectors
from swarmgrasp.swarm.tolerance import Tolerance

_SAID = {
    "tolerances": "tolerance", "envelopes": "envelope", "groups": "group", "gaps": "sectors",
    "hulls": "sectors", "bodies": "body", "couples": "couple",
}  # fmt: skip
"""The fields of a robot that tell what is kept."""


@dataclass(frozen=True, eq=False)
class Rare(Frozen):
    """What few robots of a swarm have.

    Attributes
    ----------
    tolerances : mapping of int to Tolerance
    envelopes : mapping of int to Envelope
    groups : mapping of int to str
    bodies : mapping of int to Body
    gaps : mapping of int to Sectors
        Each of those robots that have one, by index: of sectors, those with gaps between.
    couples : mapping of int to Couple
    hulls : mapping of int to Sectors
        Of robots that stand for others with gaps, and exert the hull of what these can.
    """

    tolerances: Mapping[int, Tolerance] = field(default_factory=dict)
    envelopes: Mapping[int, Envelope] = field(default_factory=dict)
    groups: Mapping[int, str] = field(default_factory=dict)
    bodies: Mapping[int, Body] = field(default_factory=dict)
    gaps: Mapping[int, Sectors] = field(default_factory=dict)
    couples: Mapping[int, Couple] = field(default_factory=dict)
    hulls: Mapping[int, Sectors] = field(default_factory=dict)

    @classmethod
    def of(cls, robots: Iterable[Robot], first: int = 0) -> "Rare":
        """Return what robots have, the first of them at an index."""
        found: dict[str, dict[int, Any]] = {name: {} for name in _SAID if name != "hulls"}
        for i, robot in enumerate(robots, start=first):
            for name, kept in found.items():
                value = _value(robot, name)
                if value:
                    kept[i] = value
        return cls(**found)

    def of_robot(self, i: int) -> dict[str, Any]:
        """Return what one robot has, by the names of a `Robot`'s fields, and its couple."""
        found = {_SAID[name]: kept[i] for name, kept in self._every() if i in kept}
        if "couple" in found and "tolerance" in found:
            found["tolerance"] = _times(found["tolerance"], FAR)
        return found

    @property
    def shapes(self) -> list[int]:
        """Robots whose forces no other number tells: those with envelopes and sectors."""
        return [*self.envelopes, *self.gaps, *self.hulls]

    def choosing(self, taken: Collection[int]) -> "Rare":
        """Return the same with one sector chosen for some robots, and the hulls of all others."""
        left = {i: kept for i, kept in {**self.gaps, **self.hulls}.items() if i not in taken}
        return replace(self, gaps={}, hulls=left)

    def with_robot(self, i: int, robot: Robot) -> "Rare":
        """Return the same with a robot at an index, instead of any there."""
        one = Rare.of((robot,), first=i)
        if all(not kept and not new for (_, kept), (_, new) in self._both(one)):
            return self
        return Rare(
            **{
                name: {k: v for k, v in kept.items() if k != i} | dict(new)
                for (name, kept), (_, new) in self._both(one)
            }
        )

    def without(self, gone: Collection[int], new_index: Callable[[int], int]) -> "Rare":
        """Return what the robots left have, each at its new index."""
        return Rare(
            **{
                name: {new_index(i): v for i, v in kept.items() if i not in gone}
                for name, kept in self._every()
            }
        )

    def _every(self) -> list[tuple[str, Mapping[int, Any]]]:
        """Return the mappings by name."""
        return [(part.name, getattr(self, part.name)) for part in fields(self)]

    def _both(self, other: "Rare") -> Any:
        """Go through the mappings of two."""
        return zip(self._every(), other._every(), strict=True)


def _value(robot: Robot, name: str) -> Any:
    """Return what a robot has of a field of `Rare`: nothing, if nothing."""
    if name == "couples":
        return couple_of(robot)
    if name == "tolerances" and robot.lever and robot.tolerance:
        return _times(robot.tolerance, 1.0 / FAR)
    return getattr(robot, _SAID[name])


def _times(tolerance: Tolerance, factor: float) -> Tolerance:
    """Return a tolerance with so many times the least limit."""
    least = tolerance.least_limit
    return tolerance if least is None else replace(tolerance, least_limit=factor * least)
