"""An independent check of an answer, from its plain data alone.

This and `recompute` use nothing of the search, nor of the package's outlines, pieces and
kernels. They find the allowed places by cutting every edge where anything changes, recompute
each quality by sorting the plane across each generator, and bound every allowed place by the
given normals and weights, by weak duality (T10): if a robot b reaches the quality t, then
t <= h(n) + max(0, n . b) for every n, so that t <= max(sum l_k h(n_k) + v . b, max h(n_k)) with
v = sum l_k n_k.
A claim is trusted only after it was recomputed; the normals and weights need no trust at all.
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import TYPE_CHECKING, Any

import numpy as np

from swarmgrasp.placement.digest import digest_of
from swarmgrasp.placement.recompute import (
    ABSOLUTE,
    ANGLE,
    MOST_SWEPT,
    Array,
    covers,
    crest,
    distance_to,
    labels_of,
    quality_within,
    sides_of,
    turns_into,
    units_of,
)

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.placement.claims import (
        Claims,
        PlacementClaim,
        RobotClaim,
        RunnerUpClaim,
        ZoneClaim,
    )

RELATIVE = 1e-9
"""Difference between two qualities, relative to them, that counts as rounding."""
RISE = 1e-9
"""Relative gain below which a newcomer does not count as an improvement."""
NEAR = 1e-6
"""Distance of a contact from the boundary that counts as none, relative to the extent."""
SLIVER = 1e-9
"""Width of contacts, allowed or not, that counts as rounding, relative to the extent."""


@dataclass(frozen=True)
class Verdict:
    """The outcome of a check; true in a condition when everything holds.

    Attributes
    ----------
    faults : tuple of str
        Every claim that does not hold.
    upper_bounds : tuple of float [N]
        The recomputed bound of each placement.
    unchecked : tuple of str
        What was taken on trust. Of more than 2 000 robots, that the qualities are no less than
        stated: they are bounded from above, not recomputed.
    """

    faults: tuple[str, ...]
    upper_bounds: tuple[float, ...]
    unchecked: tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return not self.faults


@dataclass(frozen=True)
class Cell:
    """Contacts between two points of an edge [m], and a sector of directions [rad]."""

    place: str
    p: Array
    q: Array
    lo: float
    hi: float
    is_sliver: bool
    """Whether the contacts are no more than rounding: no bound is asked for there."""


def verify_document(document: dict[str, Any]) -> Verdict:
    """Check an answer's document.

    Parameters
    ----------
    document : dict
        As read from an answer file.

    Returns
    -------
    Verdict
        It names every claim that fails: a digest that does not fit, a robot off the
        boundary or outside its zone or sector, a quality that is not so, a place that the
        proofs do not bound.

    Raises
    ------
    AnswerInvalid
        If entries are missing or malformed; all of them are named.

    Examples
    --------
    >>> from swarmgrasp import Newcomer, Outline, Robot, Swarm, place
    >>> from swarmgrasp.placement.document import document_of
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> crew = [Robot((1, 0.3), 3.0), Robot((-1, 0.5), 0.4), Robot((0.2, -1), 1.7)]
    >>> document = document_of(place(Swarm(square, crew), Newcomer(attachment="push")))
    >>> bool(verify_document(document))
    True
    >>> document["placements"][0]["quality"] += 0.1
    >>> verify_document(document).faults[0]
    'the digest does not fit the content: the file was altered'
    """
    from swarmgrasp.placement.claims import read_claims

    claims = read_claims(document)
    faults = []
    if claims.digest != digest_of(document):
        faults.append("the digest does not fit the content: the file was altered")
    present = list(claims.robots)
    bounds = []
    for index, claim in enumerate(claims.placements):
        where = f"placement {index + 1}: " if len(claims.placements) > 1 else ""
        check = _Check(claims, claim, present)
        faults += [where + fault for fault in check.faults()]
        bounds.append(check.bound)
        present.append(claim.robot)
    unchecked: tuple[str, ...] = ()
    if len(present) > MOST_SWEPT:
        unchecked = (f"the qualities of more than {MOST_SWEPT} robots are bounded from above only",)
    return Verdict(tuple(faults), tuple(bounds), unchecked)


class _Check:
    """One placement, recomputed."""

    def __init__(
        self, claims: "Claims", claim: "PlacementClaim", present: "list[RobotClaim]"
    ) -> None:
        self.claim = claim
        self.corners = np.array(claims.outline.vertices)
        self.origin = np.array(claims.outline.origin)
        self.edge_names = claims.outline.edge_names
        a1, a2 = claims.metric.force_weights
        length = claims.metric.characteristic_length
        self.scale = np.array([math.sqrt(a1), math.sqrt(a2), 1.0 / length])
        extent = float(np.linalg.norm(np.ptp(self.corners, axis=0)))
        self.near, self.sliver = NEAR * extent, SLIVER * extent
        self.present = present
        self.base = np.array([self.generator(robot) for robot in present]).reshape(-1, 3)
        arms = np.linalg.norm(self.corners - self.origin, axis=1).max()
        size = np.linalg.norm(self.base, axis=1).sum()
        size += claim.newcomer.limit * (self.scale[:2].max() + self.scale[2] * arms)
        self.rounding = ABSOLUTE * float(size)
        self.cells = list(self.allowed_cells())
        self.bound = self.upper_bound()

    def generator(self, robot: "RobotClaim") -> Array:
        """Return the scaled wrench (3,) [N] of a robot at its limit."""
        x, y = np.array(robot.contact) - self.origin
        fx, fy = math.cos(robot.direction), math.sin(robot.direction)
        return np.asarray(robot.limit * np.array([fx, fy, x * fy - y * fx]) * self.scale)

    def faults(self) -> Iterator[str]:
        """Yield every claim that does not hold."""
        claim = self.claim
        for index, robot in enumerate(self.present):
            if not (self.is_on_boundary(robot) or (robot.mounted and self.is_inside(robot))):
                yield f"robot {index} {robot.name!r} is off the boundary"
        yield from self.differs("the quality before", claim.quality_before, self.base)
        yield from self.robot_faults("the robot", claim)
        for runner in claim.runners_up:
            yield from self.robot_faults(f"the runner-up at {runner.place}", runner)
            if runner.quality > claim.upper_bound + self.slack(claim.upper_bound):
                yield f"the runner-up at {runner.place} is better than the upper bound"
        if not self.bound <= claim.upper_bound + self.slack(claim.upper_bound):
            yield (
                f"the proofs show an upper bound of {self.bound:.12g} N only, not "
                f"{claim.upper_bound:.12g} N"
            )
        if claim.quality > self.bound + self.slack(claim.quality):
            yield f"the proofs bound the quality by {self.bound:.12g} N, below what is claimed"
        if claim.quality > claim.upper_bound + self.slack(claim.quality):
            yield f"the upper bound {claim.upper_bound:.12g} N is below the quality"
        most = claim.quality * (1.0 + claim.tolerance)
        if not claim.stopped_early and not self.bound <= most + self.slack(most):
            yield (
                f"the upper bound {self.bound:.12g} N exceeds the quality {claim.quality:.12g} N "
                f"by more than the stated tolerance of {claim.tolerance:g}"
            )
        places = [claim.place, *(runner.place for runner in claim.runners_up)]
        for place in sorted({place for place in places if places.count(place) > 1}):
            yield f"{place!r} is answered more than once"
        gain = claim.quality - claim.quality_before
        if claim.improves and gain <= self.rounding:
            yield "the newcomer is said to improve the swarm, and does not"
        if not claim.improves and gain > 2.0 * RISE * claim.quality_before + 20.0 * self.rounding:
            yield "the newcomer is said not to improve the swarm, and does"

    def slack(self, value: float) -> float:
        """Return the difference [N] that counts as rounding at a value."""
        return RELATIVE * value + self.rounding

    def differs(self, what: str, claimed: float, generators: Array) -> Iterator[str]:
        """Yield a fault if a claimed quality is not the one found."""
        units = [units_of(proof.normals) for proof in self.claim.proofs]
        normals = np.concatenate([np.empty((0, 3)), *(u for u in units if u is not None)])
        least, most = quality_within(generators, normals)
        if claimed > most + self.slack(most) or claimed < least - self.slack(least):
            is_known = "is" if least == most else "at most"
            yield f"{what} is said to be {claimed:.12g} N and {is_known} {most:.12g} N"

    def is_on_boundary(self, robot: "RobotClaim") -> bool:
        """Tell whether a robot's contact lies on an edge."""
        ends = np.roll(self.corners, -1, axis=0)
        point = np.array(robot.contact)
        return any(
            distance_to(point, p, q) <= self.near for p, q in zip(self.corners, ends, strict=True)
        )

    def is_inside(self, robot: "RobotClaim") -> bool:
        """Tell whether a contact is inside the outline: a ray from it crosses an odd number."""
        x, y = robot.contact
        a, b = self.corners, np.roll(self.corners, -1, axis=0)
        spans = (a[:, 1] > y) != (b[:, 1] > y)
        a, b = a[spans], b[spans]
        meets = a[:, 0] + (y - a[:, 1]) * (b[:, 0] - a[:, 0]) / (b[:, 1] - a[:, 1])
        return bool(np.count_nonzero(meets > x) % 2)

    def robot_faults(self, what: str, claim: "PlacementClaim | RunnerUpClaim") -> Iterator[str]:
        """Yield what is wrong with a robot said to be allowed and to reach a quality."""
        robot = claim.robot
        if robot.limit != self.claim.newcomer.limit:
            yield f"{what} has the limit {robot.limit:.12g} N, not the newcomer's"
        if robot.mounted:
            yield f"{what} is mounted; a newcomer is on the boundary"
        contact = np.array(robot.contact)
        places = {
            cell.place
            for cell in self.cells
            if distance_to(contact, cell.p, cell.q) <= self.near
            and turns_into(robot.direction, cell.lo - ANGLE, cell.hi + ANGLE)
        }
        if not places:
            yield (
                f"{what} at ({contact[0]:.9g}, {contact[1]:.9g}) m pushing at "
                f"{robot.direction:.9g} rad is not an allowed one"
            )
        elif claim.place not in places:
            yield f"{what} is said to be at {claim.place!r} and is at {' or '.join(sorted(places))}"
        together = np.vstack([self.base, self.generator(robot)])
        yield from self.differs(f"the quality with {what}", claim.quality, together)

    def upper_bound(self) -> float:
        """Bound every allowed robot's quality by the best of the proofs for each cell."""
        cells = [cell for cell in self.cells if not cell.is_sliver] or self.cells
        if not cells:
            return math.inf
        p, q = np.array([c.p for c in cells]), np.array([c.q for c in cells])
        lo, hi = np.array([c.lo for c in cells]), np.array([c.hi for c in cells])
        bounds = np.full(len(cells), math.inf)
        for proof in self.claim.proofs:
            normals, weights = units_of(proof.normals), np.array(proof.weights)
            if normals is None or len(weights) != len(normals) or not (weights > 0.0).all():
                continue
            weights = weights / weights.max()
            weights /= weights.sum()
            heights = np.maximum(self.base @ normals.T, 0.0).sum(axis=0)
            covector = (weights @ normals) * self.scale * self.claim.newcomer.limit
            reach = np.maximum(*(crest(covector, end - self.origin, lo, hi) for end in (p, q)))
            bounds = np.minimum(bounds, np.maximum(weights @ heights + reach, heights.max()))
        return float(bounds.max())

    def allowed_cells(self) -> Iterator[Cell]:
        """Yield the allowed contacts and directions, edge by edge and side by side."""
        lengths, names = self.lengths(), self.edge_names
        arcs = np.concatenate([[0.0], np.cumsum(lengths)])
        zones = [None] if self.claim.zones is None else self.claim.zones
        labels = labels_of(zones)
        for edge, length in enumerate(lengths):
            p, q = self.corners[edge], self.corners[(edge + 1) % len(self.corners)]
            inward = math.atan2(q[0] - p[0], p[1] - q[1])
            for zone, label in zip(zones, labels, strict=True):
                for a, b in self.spans(zone, arcs[edge], arcs[-1], p, q):
                    start, end = (p + (q - p) * (s / length) for s in (a, b))
                    middle = arcs[edge] + 0.5 * (a + b)
                    if not self.is_allowed(zone, middle, arcs[-1], 0.5 * (start + end)):
                        continue
                    place = label or names[edge] or f"edge {edge}"
                    for lo, hi in sides_of(self.claim, zone, inward):
                        yield Cell(place, start, end, lo, hi, 0.0 < b - a <= 2.0 * self.sliver)

    def spans(
        self, zone: "ZoneClaim | None", base: float, perimeter: float, p: Array, q: Array
    ) -> list[tuple[float, float]]:
        """Return the parts of an edge [m from its start] that are allowed or not as a whole.

        They run from each place where anything changes to the next; of a single point, such
        as a bollard, they are its places on the edge.
        """
        length = float(np.linalg.norm(q - p))
        stretches = [*self.claim.no_go, *([] if zone is None else [zone])]
        is_point = zone is not None and zone.start == zone.end
        cuts = set() if is_point else {0.0, length, *self.spacing_cuts(p, q)}
        for stretch in [zone] if is_point and zone else stretches:
            for arc in (stretch.start, stretch.end):
                for turn in (-perimeter, 0.0, perimeter):
                    at = arc + turn - base
                    if -self.near <= at <= length + self.near:
                        cuts.add(min(max(at, 0.0), length))
        marks = sorted(cuts)
        return [(s, s) for s in marks] if is_point else list(pairwise(marks))

    def lengths(self) -> Array:
        """Return the lengths (k,) [m] of the edges."""
        return np.asarray(np.linalg.norm(np.roll(self.corners, -1, axis=0) - self.corners, axis=1))

    def spacing_cuts(self, p: Array, q: Array) -> Iterator[float]:
        """Yield where the circles around the robots cross an edge [m from its start]."""
        length = float(np.linalg.norm(q - p))
        for robot in self.present if self.claim.spacing > 0.0 else []:
            if not robot.mounted:
                d, from_p = (q - p) / length, np.array(robot.contact) - p
                height = abs(float(d[0] * from_p[1] - d[1] * from_p[0]))
                if height < self.claim.spacing - self.sliver:
                    half = math.sqrt(self.claim.spacing**2 - height**2)
                    foot = float(d @ from_p)
                    yield from (s for s in (foot - half, foot + half) if 0.0 < s < length)

    def is_allowed(
        self, zone: "ZoneClaim | None", arc: float, perimeter: float, point: Array
    ) -> bool:
        """Tell whether a contact is in the zone, in no no-go stretch, and not too near."""
        is_point = zone is not None and zone.start == zone.end  # then the contact is its own
        if zone and not is_point and not covers(zone, arc, perimeter, self.sliver):
            return False
        if any(covers(stretch, arc, perimeter, -self.sliver) for stretch in self.claim.no_go):
            return False
        spacing = self.claim.spacing - self.sliver
        return all(
            robot.mounted or float(np.linalg.norm(point - np.array(robot.contact))) >= spacing
            for robot in self.present
        )
