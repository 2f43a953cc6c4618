"""The question of a placement: swarm, newcomer, and where it may attach."""

import math
from dataclasses import dataclass, replace

from swarmgrasp.errors import ZoneInvalid
from swarmgrasp.outline import Stretch
from swarmgrasp.placement.pieces import Pieces, pieces_of, zone_labels
from swarmgrasp.plain import Plain
from swarmgrasp.quality.criterion import NOMINAL, Criterion
from swarmgrasp.swarm import Newcomer, Swarm, Zone


@dataclass(frozen=True, eq=False)
class Problem(Plain):
    """One newcomer looking for a place.

    Attributes
    ----------
    swarm : Swarm
        The robots already there.
    newcomer : Newcomer
    zones : tuple of Zone, optional
        Where the newcomer may attach; None means the whole boundary.
    no_go : tuple of Stretch
        Where it may not; the ends of a stretch are allowed.
    spacing : float [m]
        Least straight-line distance to the contact of any robot that is not mounted.
    criterion : Criterion
        What quality means; the nominal quality when left out.

    Raises
    ------
    ZoneInvalid
        If a stretch leaves the boundary, a no-go stretch is a single point, or the spacing
        is not a finite length >= 0; all faults at once.

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
    zones: tuple[Zone, ...] | None = None
    no_go: tuple[Stretch, ...] = ()
    spacing: float = 0.0
    criterion: Criterion = NOMINAL

    def __post_init__(self) -> None:
        """Check the values."""
        wanted = (
            (self.swarm, Swarm), (self.newcomer, Newcomer), (self.criterion, Criterion),
        )  # fmt: skip
        for value, kind in wanted:
            if not isinstance(value, kind):
                raise ZoneInvalid(f"{value!r} is no {kind.__name__}")
        strangers: list[object] = [zone for zone in self.zones or () if not isinstance(zone, Zone)]
        strangers += [stretch for stretch in self.no_go if not isinstance(stretch, Stretch)]
        if strangers:
            raise ZoneInvalid(
                f"{value!r} is neither a Zone nor a no-go Stretch" for value in strangers
            )
        perimeter = self.swarm.outline.perimeter
        reach = perimeter + self.swarm.outline.tolerance
        named = [("zone", zone.stretch) for zone in self.zones or ()]
        named += [("no-go stretch", stretch) for stretch in self.no_go]
        faults = [
            f"{kind} {s.name!r} runs from {s.start:.9g} to {s.end:.9g} m; both ends should lie "
            f"in [0, {perimeter:.9g}] m"
            for kind, s in named
            if not (0.0 <= s.start <= reach and 0.0 <= s.end <= reach)
        ]
        faults += [
            f"no-go stretch {s.name!r} is the single point {s.start:.9g} m, which forbids nothing; "
            "give it a width"
            for s in self.no_go
            if s.is_point
        ]
        if self.zones is not None and not self.zones:
            faults.append("the zones are empty; give None for the whole boundary")
        if not (math.isfinite(self.spacing) and self.spacing >= 0.0):
            faults.append(f"the spacing is {self.spacing!r}; it should be 0 <= spacing < inf [m]")
        tolerance = self.newcomer.tolerance
        if self.criterion.worst_case and tolerance is not None and tolerance.may_be_absent:
            faults.append("a newcomer that may be absent is worth nothing in the worst case")
        if faults:
            raise ZoneInvalid(faults)

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
        swarm = self.swarm
        crowd = swarm.contacts[~swarm.mounted] if self.spacing > 0.0 else None
        return pieces_of(swarm.outline, self.newcomer, self.zones, self.no_go, crowd, self.spacing)

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
    def is_tolerant(self) -> bool:
        """Whether the newcomer's own pose is uncertain by the criterion."""
        tolerance = self.newcomer.tolerance
        return self.criterion.worst_case and tolerance is not None and tolerance.is_spread
