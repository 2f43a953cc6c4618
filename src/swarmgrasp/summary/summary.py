"""A swarm of any size in a message of fixed size (T13)."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike

from swarmgrasp.errors import SummaryInvalid
from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.quality.generators import checked_generators
from swarmgrasp.ranges import items, kind_faults, numbers, shown
from swarmgrasp.summary.bounds import Bounds, quality_bounds
from swarmgrasp.summary.cells import Array, side_of
from swarmgrasp.summary.content import MOST_ROBOTS, Content
from swarmgrasp.summary.encoding import decode, encode
from swarmgrasp.summary.moments import merged, moments_of, rounding_of
from swarmgrasp.summary.placing import PlacementBounds, place_from
from swarmgrasp.summary.support_bounds import SupportBounds
from swarmgrasp.summary.wrenches import NO_WRENCHES, farthest_wrenches
from swarmgrasp.swarm import Newcomer, Swarm, Zone
from swarmgrasp.swarm.swarm import check_gaps, check_metric, check_swarm

BINS = 1024
"""Bins asked for unless told otherwise."""


@dataclass(frozen=True, eq=False)
class Summary(Content):
    """What a swarm can do, in bins of directions.

    Made by `of`, `from_generators`, `empty` or `from_bytes`; added up by ``+`` or `merge`.

    Its data are those of `Content`: `count`, `side`, `force_weights`, `characteristic_length`,
    `origin`, `total`, `rounding`, `moments` and `wrenches`.

    Examples
    --------
    Two groups each tell what they can do, and anyone can add that up.

    >>> rng = np.random.default_rng(1)
    >>> north, south = (Summary.from_generators(rng.normal(size=(5000, 3))) for _ in range(2))
    >>> both = north + south
    >>> both.count, both.bins, len(both.to_bytes())
    (10000, 972, 17604)
    >>> bounds = both.quality()
    >>> bounds.is_force_closure, bool(bounds.width < 0.01 * bounds.lower)
    (True, True)
    """

    # -- making one -------------------------------------------------------------------

    @classmethod
    def of(cls, swarm: Swarm, bins: int = BINS) -> "Summary":
        """Summarise a swarm.

        Parameters
        ----------
        swarm : Swarm
        bins : int
            At most so many: the summary has 12 k^2 of them, 12 <= bins <= 3 145 728.

        Raises
        ------
        SummaryInvalid
            If the number of bins is out of range.
        SwarmInvalid
            If it is no `Swarm`.
        ForceSetUnsupported
            If robots have sectors with gaps between.
        """
        check_swarm(swarm)
        check_gaps(swarm, "a summary")
        rays = cls.from_generators(
            swarm.scaled_generators[swarm.is_ray],
            bins,
            force_weights=swarm.force_weights,
            characteristic_length=swarm.characteristic_length,
            origin=tuple(swarm.outline.origin.tolist()),
        )
        if swarm.has_rays_only:
            return rays
        wrenches, rounding = farthest_wrenches(swarm, rays.side)
        return replace(rays, count=len(swarm), wrenches=wrenches, rounding=rays.rounding + rounding)

    @classmethod
    def empty(cls, outline: Outline, bins: int = BINS) -> "Summary":
        """Summarise no robots on an outline, in its default metric.

        Examples
        --------
        >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        >>> Summary.empty(square).quality().upper
        0.0
        """
        return cls.of(Swarm(outline, ()), bins)

    @classmethod
    def from_generators(
        cls,
        generators: ArrayLike,
        bins: int = BINS,
        *,
        force_weights: tuple[float, float] = (1.0, 1.0),
        characteristic_length: float = 1.0,
        origin: tuple[float, float] = (0.0, 0.0),
    ) -> "Summary":
        """Summarise robots given by their generators.

        Parameters
        ----------
        generators : (n, 3) [N, N, N]
            In the coordinates of the metric: (a1^(1/2) f_x, a2^(1/2) f_y, torque / L) at the
            robot's limit.
        bins : int
            As for `of`.
        force_weights, characteristic_length, origin
            The metric those coordinates are in, and the point the torque is taken about.

        Raises
        ------
        WrenchInvalid
            If they are not rows of three numbers, of which the largest in size is zero or
            within 1e-120 to 1e120 N.
        MetricInvalid
            If a weight or the length is not positive.
        SummaryInvalid
            If the number of bins is out of range, or the origin not two finite numbers.
        """
        side = side_of(bins)
        check_metric(characteristic_length, force_weights)
        point = numbers(origin)
        if len(point) != 2:
            raise SummaryInvalid(
                f"the origin is {shown(origin)}; it should be two finite numbers [m]"
            )
        rows = checked_generators(generators, "(n, 3)").reshape(-1, 3)
        moments, total, rounding = moments_of(rows, side)
        return cls(
            count=len(rows),
            side=side,
            force_weights=(float(force_weights[0]), float(force_weights[1])),
            characteristic_length=float(characteristic_length),
            origin=(point[0], point[1]),
            total=total,
            rounding=rounding,
            moments=moments,
            wrenches=NO_WRENCHES,
        )

    # -- adding up --------------------------------------------------------------------

    def __add__(self, other: "Summary") -> "Summary":
        """Return the summary of both swarms together; the order does not matter."""
        return Summary.merge((self, other)) if isinstance(other, Summary) else NotImplemented

    @classmethod
    def merge(cls, summaries: "Iterable[Summary]") -> "Summary":
        """Return the summary of several swarms together.

        Of two, in either order, it is the same to the last bit; of more, up to rounding, which
        the bounds allow for. Empty ones change nothing.

        Raises
        ------
        SummaryInvalid
            If there are none, or something else is among them, or they differ in metric,
            origin or bins, or have 2^63 robots together.
        """
        given: tuple[Summary, ...] | None = items(summaries)
        if not given:
            raise SummaryInvalid(
                f"the summaries to merge are {shown(summaries)}; give a list of at least one"
            )
        faults = [f for value in given for f in kind_faults(value, Summary, "Summary.of(swarm)")]
        if faults:
            raise SummaryInvalid(faults)
        first = given[0]
        for other in given[1:]:
            first._check_like(other)
        crowds = [summary for summary in given if summary.count]
        if len(crowds) < 2:
            return crowds[0] if crowds else first
        count = sum(summary.count for summary in crowds)
        if count > MOST_ROBOTS:
            raise SummaryInvalid(f"they have {count} robots together; it should be below 2^63")
        moments = merged([summary.moments for summary in crowds], first.side)
        moved = rounding_of(len(crowds), sum(s.size for s in crowds))
        sets = [summary.wrenches for summary in crowds if summary.has_sets]
        return cls(
            count=count,
            side=first.side,
            force_weights=first.force_weights,
            characteristic_length=first.characteristic_length,
            origin=first.origin,
            total=np.asarray(sum(summary.total for summary in crowds)),
            rounding=sum(summary.rounding for summary in crowds) + moved,
            moments=moments,
            wrenches=np.asarray(sum(sets)) if sets else NO_WRENCHES,
        )

    def _check_like(self, other: "Summary") -> None:
        """Raise unless another summary speaks of the same things."""
        named = (
            ("bins", self.bins, other.bins),
            ("force weights", self.force_weights, other.force_weights),
            ("characteristic lengths [m]", self.characteristic_length, other.characteristic_length),
            ("origins of moments [m]", self.origin, other.origin),
        )
        faults = [
            f"the {what} of two summaries differ: {mine!r} and {theirs!r}; "
            "summarise both swarms with the same"
            for what, mine, theirs in named
            if mine != theirs
        ]
        if faults:
            raise SummaryInvalid(faults)

    # -- as bytes ---------------------------------------------------------------------

    def to_bytes(self) -> bytes:
        """Write the summary as 108 bytes and 18 for each occupied bin.

        If some robots are no rays, and 12 for each direction of the lattice.

        What is read back bounds the same swarm, with the rounding of the numbers allowed for.
        """
        return encode(self)

    @classmethod
    def from_bytes(cls, data: bytes) -> "Summary":
        """Read a summary.

        Raises
        ------
        SummaryInvalid
            If the bytes are damaged, cut short or too many, of another version, or say what
            no summary says.
        """
        return cls(**vars(decode(data)))

    # -- what is certain --------------------------------------------------------------

    def __len__(self) -> int:
        """Return the number of robots."""
        return self.count

    @property
    def bins(self) -> int:
        """Number of bins, occupied or not."""
        return 3 * self.side**2

    @property
    def metric_sentence(self) -> str:
        """The metric in words."""
        a1, a2 = self.force_weights
        length = self.characteristic_length
        return f"force weights {a1:g} and {a2:g}, characteristic length {length:.6g} m"

    @property
    def scale(self) -> Array:
        """(3,) [1, 1, 1/m]: A^(1/2), which makes the metric Euclidean."""
        a1, a2 = self.force_weights
        return np.array([math.sqrt(a1), math.sqrt(a2), 1.0 / self.characteristic_length])

    @cached_property
    def support(self) -> SupportBounds:
        """Bounds on the support function at any direction."""
        return SupportBounds(self)

    @cached_property
    def _bounds(self) -> Bounds:
        """What `quality` returns."""
        lower, upper, direction = quality_bounds(self.support)
        return Bounds(lower, upper, direction, self.metric_sentence)

    def quality(self) -> Bounds:
        """Bound the Max-Transfer quality (T1) of every swarm with this summary.

        From below it is the quality of a wrench set inside the swarm's: exactly that of the bins'
        sums, as robots beside a steady wrench, or of those and the wrenches known of robots that
        are no rays, within 1e-4 of itself. From above it is the least upper bound on
        the support function that a walk downhill from there finds.
        """
        return self._bounds

    def place(
        self,
        outline: Outline,
        newcomer: Newcomer,
        zones: Iterable[Zone] | None = None,
        no_go: Iterable[Stretch] = (),
    ) -> PlacementBounds:
        """Find where a newcomer should attach, and bound what that and the best place give.

        A summary does not say where its robots are: to keep a distance from them, make no-go
        stretches.

        Parameters
        ----------
        outline : Outline
            Of the object, with the summary's origin.
        newcomer : Newcomer
        zones : iterable of Zone, optional
            Where it may attach; the whole boundary when left out.
        no_go : iterable of Stretch
            Where it may not.

        Raises
        ------
        SummaryInvalid
            If the outline's origin is not the summary's.
        ForceSetUnsupported
            If the newcomer is no ray: where one that steers, reverses or rubs should attach is
            known how to find beside known robots only.
        OutlineInvalid
            If it is no `Outline`.
        ZoneInvalid, NowhereToAttach
            If a zone leaves the boundary, or no allowed point is left.
        """
        # on this outline, without the robots: only their wrenches are known
        bare = Swarm(outline, (), self.characteristic_length, self.force_weights)
        origin = tuple(outline.origin.tolist())
        if origin != self.origin:
            raise SummaryInvalid(
                f"the outline's origin is {origin!r}, the summary's {self.origin!r} [m]; moments "
                "should be taken about the same point"
            )
        return place_from(self.support, bare, newcomer, zones, no_go)
