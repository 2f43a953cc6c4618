"""The question of a placement: swarm, newcomer, and where it may attach."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import (
    CriterionInvalid,
    ForceSetUnsupported,
    RobotInvalid,
    SwarmInvalid,
    ZoneInvalid,
    refuse,
)
from swarmgrasp.frozen import Frozen
from swarmgrasp.outline import Stretch
from swarmgrasp.outline.polygon import is_within
from swarmgrasp.placement.areas import Areas, Decks, areas_of, decks_of
from swarmgrasp.placement.pieces import (
    Pieces,
    checked_pieces,
    halves_of,
    pieces_of,
    zone_labels,
)
from swarmgrasp.plain import Plain
from swarmgrasp.quality.criterion import NOMINAL, Criterion
from swarmgrasp.quality.robot_sets import turn_faults
from swarmgrasp.ranges import items, kind_faults, length_faults, shown
from swarmgrasp.swarm import Newcomer, Swarm, Zone
from swarmgrasp.swarm.swarm import check_gaps, check_rays, swarm_faults
from swarmgrasp.visible import Visible

Array = NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class Problem(Frozen, Plain, Visible):
    """One newcomer looking for a place.

    Attributes
    ----------
    swarm : Swarm
        The robots already there.
    newcomer : Newcomer
    zones : sequence of Zone, optional
        Where the newcomer may attach; None means the whole boundary.
    no_go : sequence of Stretch
        Where it may not; the ends of a stretch are allowed.
    spacing : float [m]
        Least straight-line distance to the contact of any robot that is not mounted.
    criterion : Criterion
        What quality means; the nominal quality when left out.

    Raises
    ------
    SwarmInvalid, RobotInvalid, CriterionInvalid
        If swarm, newcomer or criterion is none.
    ZoneInvalid
        If zones or stretches are none, a stretch leaves the boundary, a no-go stretch is a
        single point, or the spacing is not a finite length >= 0; all faults at once.

    Examples
    --------
    >>> from swarmgrasp import Outline
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> pads = (Zone(Stretch(0.0, 2.0, "pad")), Zone(Stretch(4.0, 6.0, "pad")))
    >>> Problem(Swarm(square, []), Newcomer(), pads, spacing=0.5).zone_labels
    ('pad (1)', 'pad (2)')
    """

    swarm: Swarm
    newcomer: Newcomer
    zones: Sequence[Zone] | None = None
    no_go: Sequence[Stretch] = ()
    spacing: float = 0.0
    criterion: Criterion = NOMINAL

    def __post_init__(self) -> None:
        """Check the values."""
        zones, no_go = items(self.zones), items(self.no_go)
        faults = length_faults(self.spacing, "spacing")
        if self.zones is not None:
            if zones is None:
                faults.append(f"the zones are {shown(self.zones)}; they should be a list of Zones")
            elif not zones:
                faults.append("the zones are empty; give None for the whole boundary")
            faults += [f for zone in zones or () for f in kind_faults(zone, Zone, "Zone(stretch)")]
        if no_go is None:
            faults.append(f"no_go is {shown(self.no_go)}; it should be a list of Stretches")
        faults += [f for s in no_go or () for f in kind_faults(s, Stretch, "Stretch(start, end)")]
        refuse(
            (SwarmInvalid, swarm_faults(self.swarm)),
            (RobotInvalid, kind_faults(self.newcomer, Newcomer, "Newcomer(limit)")),
            (CriterionInvalid, kind_faults(self.criterion, Criterion, "Criterion(...)")),
            (ZoneInvalid, faults),
        )
        vars(self).update(zones=zones, no_go=no_go, spacing=float(self.spacing))
        faults = self._stretch_faults() + self._area_faults()
        tolerance = self.newcomer.tolerance
        if self.criterion.worst_case and tolerance is not None and tolerance.may_be_absent:
            faults.append("a newcomer that may be absent is worth nothing in the worst case")
        if faults:
            raise ZoneInvalid(faults)

    def _stretch_faults(self) -> list[str]:
        """Return what is wrong with the zones and the no-go stretches on this outline."""
        if not self.zones and not self.no_go:
            return []
        perimeter = self.swarm.outline.perimeter
        reach = perimeter + self.swarm.outline.tolerance
        stretches = [zone.stretch for zone in self.zones or () if zone.stretch is not None]
        named = [("zone", stretch) for stretch in stretches]
        named += [("no-go stretch", stretch) for stretch in self.no_go]
        faults = [
            f"{kind} {s.name!r} runs from {s.start:.9g} to {s.end:.9g} m; both ends should lie "
            f"in [0, {perimeter:.9g}] m"
            for kind, s in named
            if max(s.start, s.end) > reach
        ]
        return faults + [
            f"no-go stretch {s.name!r} is the single point {s.start:.9g} m, which forbids nothing; "
            "give it a width"
            for s in self.no_go
            if s.is_point
        ]

    def _area_faults(self) -> list[str]:
        """Return what is wrong with areas, and with what a mounted newcomer is asked beside."""
        outline, mounted, zones = self.swarm.outline, self.newcomer.mounted, self.zones or ()
        wanted = "an area" if mounted else "a stretch of the boundary"
        faults = [
            f"zone {zone.name!r} has no {wanted.split(' ', 1)[1]}: a newcomer that is "
            f"{'' if mounted else 'not '}mounted needs {wanted}"
            for zone in zones
            if (zone.area is None) == mounted
        ]
        faults += [
            f"zone {zone.name!r} leaves the outline: all of its area should be inside"
            for zone in zones
            if zone.area and not is_within(zone.area, outline.vertices, outline.tolerance)
        ]
        if mounted and self.no_go:
            faults.append("no-go stretches are for newcomers on the boundary: leave them out")
        if mounted and self.spacing:
            faults.append("a mounted newcomer keeps no distance: leave out the spacing")
        return faults

    @property
    def zone_labels(self) -> tuple[str, ...]:
        """The zones' names; of several with one name, each with its number; "" without zones."""
        return zone_labels(self.zones)

    def pieces(self) -> Pieces:
        """List the pieces of the boundary that are left to the newcomer.

        Raises
        ------
        NowhereToAttach
            If there are none.
        """
        return self._pieces

    @cached_property
    def _pieces(self) -> Pieces:
        """The pieces, once they are asked for."""
        swarm, newcomer = self.swarm, self.newcomer
        crowd = swarm.contacts[~swarm.mounted] if self.spacing > 0.0 else None
        found = pieces_of(swarm.outline, newcomer, self.zones, self.no_go, crowd, self.spacing)
        if newcomer.body is None:
            return found
        from swarmgrasp.placement.room import Room

        left = list(Room(swarm).left(found.each, newcomer))
        return checked_pieces(swarm.outline, left, "; its body needs room beside those there")

    def places(self) -> Pieces | Areas | Decks:
        """List the pieces of the boundary, or of areas inside, that are left to the newcomer.

        Raises
        ------
        NowhereToAttach
            If there are none.
        """
        if not self.newcomer.mounted:
            return self.pieces()
        list_all = decks_of if self.newcomer.steers else areas_of
        return list_all(self.swarm.outline, self.zones)

    def with_swarm(self, swarm: Swarm) -> "Problem":
        """Return the same question for another swarm on the same outline."""
        return replace(self, swarm=swarm)

    @property
    def certain_limit(self) -> float:
        """What the newcomer can exert for certain by the criterion [N]."""
        tolerance = self.newcomer.tolerance
        if not self.criterion.worst_case or tolerance is None or tolerance.least_limit is None:
            return self.newcomer.limit
        return tolerance.least_limit

    @property
    def has_rays_only(self) -> bool:
        """Whether all robots push along one ray each, the newcomer too, and fail one by one."""
        newcomer, swarm, criterion = self.newcomer, self.swarm, self.criterion
        is_ray = not (newcomer.keeps or newcomer.reverse_limit)
        has_machines = bool(criterion.failures or (criterion.losing and swarm.rare.groups))
        return is_ray and swarm.has_rays_only and not has_machines

    @property
    def fewest(self) -> int:
        """Robots, those lost included, below which the quality is 0 wherever they are."""
        return self.criterion.fewest(self.has_rays_only)

    def certain_sectors(self, sectors: Array) -> Array:
        """Return what the newcomer keeps for certain of sectors (k, 2) [rad] that it keeps.

        What is left in each direction that may be drawn; if nothing is, the middle, than which a
        ray of uncertain direction has no more.
        """
        first, last = self._drawn
        middle, half = sectors.mean(axis=1), halves_of(sectors)
        left = np.maximum(half - 0.5 * (last - first), 0.0)
        middle = middle + 0.5 * (first + last)
        found = np.column_stack([middle - left, middle + left])
        return np.where((half < math.pi)[:, None], found, sectors)

    @property
    def _drawn(self) -> tuple[float, float]:
        """The offsets [rad] between which the newcomer's direction is drawn by the criterion."""
        tolerance = self.newcomer.tolerance
        is_asked = self.criterion.worst_case and tolerance is not None
        return tolerance.turns if is_asked and tolerance is not None else (0.0, 0.0)

    @property
    def is_tolerant(self) -> bool:
        """Whether the newcomer may be elsewhere than where it aims, by the criterion.

        If it keeps a part of its sector for certain, and its contact is certain, it is not.
        """
        newcomer, tolerance = self.newcomer, self.newcomer.tolerance
        if not self.criterion.worst_case or tolerance is None or not tolerance.is_spread:
            return False
        if tolerance.is_adrift or not newcomer.steers or newcomer.reverse_limit:
            return True
        half = halves_of(np.array([(piece.lo, piece.hi) for piece in self.places().each])).min()
        return bool(half < min(0.5 * (tolerance.turns[1] - tolerance.turns[0]), math.pi))


def check_ray_problem(problem: Problem, what: str) -> None:
    """Raise `ForceSetUnsupported` unless all robots and the newcomer push along one ray each."""
    check_rays(problem.swarm, what)
    if not problem.newcomer.is_ray:
        raise ForceSetUnsupported(
            f"{what} is for a newcomer that pushes along one ray from a place on the boundary: "
            "leave out what it steers, its reverse limit, its friction and that it is mounted"
        )


def check_several(problem: Problem, what: str) -> None:
    """Raise `ForceSetUnsupported` for newcomers of which several are not known how to place."""
    check_gaps(problem.swarm, what)
    if problem.newcomer.mounted:
        raise ForceSetUnsupported(
            f"{what} is for newcomers on the boundary: leave out that they are mounted, or place "
            "them one after the other"
        )
    if problem.newcomer.body is not None:
        raise ForceSetUnsupported(
            f"{what} is for newcomers that take up no room: leave out the body, or place them one "
            "after the other"
        )
    check_newcomer(problem)


def check_newcomer(problem: Problem) -> None:
    """Raise `ForceSetUnsupported` for a newcomer whose place is not known how to find."""
    newcomer = problem.newcomer
    if problem.is_tolerant and newcomer.tolerance is not None:
        kinds = {
            "friction": bool(newcomer.friction),
            "steering both ways": newcomer.steers and newcomer.reverse_limit > 0.0,
            "a place inside": newcomer.mounted,
        }
        faults = turn_faults(newcomer.name or "newcomer", newcomer.tolerance, kinds)
        if faults:
            raise ForceSetUnsupported(faults)


def problem_faults(problem: object) -> list[str]:
    """Return what is wrong with something that should be a problem."""
    return kind_faults(problem, Problem, "Problem(swarm, newcomer)")
