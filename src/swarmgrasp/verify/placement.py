"""An independent check of an answer, from its plain data alone.

This and the modules it calls use nothing of the search, nor of the package's outlines, pieces and
kernels. They find the allowed places by cutting every edge where anything changes, recompute
each quality by listing where it can be least, and bound every allowed place by the given normals
and weights, by weak duality (T10). If a robot b reaches the quality t, then
t D(n) <= H(n) + max(0, n . b) for every n, and t D(n) <= C(n), where C is H before the last loss
(T14 to T16). So t is at most the greater of max H(n_k) / D(n_k) and
(sum l_k H(n_k) + v . b) / sum l_k D(n_k) with v = sum l_k n_k, and at most min C(n_k) / D(n_k).
A claim is trusted only after it was recomputed; the normals and weights need no trust at all.
"""

import math
from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

import numpy as np

from swarmgrasp.errors import AnswerInvalid
from swarmgrasp.verify.allowed import Allowed, Piece
from swarmgrasp.verify.boundary import Boundary
from swarmgrasp.verify.boxes import Boxes
from swarmgrasp.verify.digest import digest_of
from swarmgrasp.verify.judge import MOST_LISTED, MOST_SWEPT, ROUNDED, UNASKED, Judge, over
from swarmgrasp.verify.patches import Patches
from swarmgrasp.verify.recompute import (
    ABSOLUTE,
    ANGLE,
    crest,
    turns_into,
    units_of,
)
from swarmgrasp.verify.room import Room
from swarmgrasp.verify.rounding import noise_of
from swarmgrasp.verify.spans import Kept, Spans
from swarmgrasp.verify.team import Team, keeping
from swarmgrasp.verify.verdict import Verdict

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import (
        PlacementClaim,
        ProblemClaim,
        RobotClaim,
        RunnerUpClaim,
        ToleranceClaim,
    )

RELATIVE = 1e-9
"""Difference between two qualities, relative to them, that counts as rounding."""
CERTIFIED = 1e-7
"""The same for the worst of uncertain poses, and for robots that are no rays, which the search
finds no nearer."""
SETTLED = 2e-13
"""Share of sum |b_i| that the search leaves open of the quality of robots that are no rays."""
RISE = 1e-9
"""Relative gain below which a newcomer does not count as an improvement."""
CLOSED = 0.3
"""Of the quality that counts as 0: a gap between bound and quality that is closed."""
TOLD = 1e-6
"""Slack relative to what is claimed, above which the claim is not checked, and the verdict says so:
robots much stronger than what is claimed, by whose rounding anything near it may be claimed."""


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
    >>> from swarmgrasp.answer_file import document_of
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> crew = [Robot((1, 0.3), 3.0), Robot((-1, 0.5), 0.4), Robot((0.2, -1), 1.7)]
    >>> document = document_of(place(Swarm(square, crew), Newcomer(attachment="push")))
    >>> bool(verify_document(document))
    True
    >>> document["placements"][0]["quality"] += 0.1
    >>> verify_document(document).faults[0]
    'the digest does not fit the content: the file was altered'
    """
    from swarmgrasp.verify.claims import read_claims

    claims = read_claims(document)
    faults = []
    if claims.digest != digest_of(document):
        faults.append("the digest does not fit the content: the file was altered")
    present = list(claims.problem.swarm.robots)
    bounds: list[float] = []
    unchecked: list[str] = []
    boundary = Boundary(claims.problem.swarm.outline)
    for index, claim in enumerate(claims.placements):
        where = f"placement {index + 1}: " if len(claims.placements) > 1 else ""
        check = _Check(claims.problem, claim, present, boundary)
        faults += [where + fault for fault in check.faults()]
        bounds.append(check.bound)
        unchecked += check.unchecked()
        present.append(claim.robot)
    return Verdict(tuple(faults), tuple(bounds), tuple(dict.fromkeys(unchecked)))


class _Check:
    """One placement, recomputed."""

    def __init__(
        self,
        asked: "ProblemClaim",
        claim: "PlacementClaim",
        present: "list[RobotClaim]",
        boundary: Boundary,
    ) -> None:
        self.asked, self.claim = asked, claim
        self.is_open = False  # whether a quality of robots that are no rays is not proven
        self.boundary, self.present = boundary, tuple(present)
        self.judge = judge = Judge(boundary, asked.swarm, asked.criterion)
        self.base = judge.team(present)  # with the gaps between sectors filled
        self.held = [keeping(present, choice) for choice in (claim.choice_before, claim.choice)]
        self.unit = "" if asked.criterion.task else " N"
        tolerance = asked.newcomer.tolerance if asked.criterion.worst_case else None
        self.keeps = bool(asked.newcomer.steers or asked.newcomer.friction)
        self.certain_limit, self.drawn = asked.newcomer.limit, (0.0, 0.0)
        if tolerance is not None:
            self.certain_limit = tolerance.certain(self.certain_limit)
            self.drawn = tolerance.direction
        force, turn = judge.scale[:2].max(), judge.scale[2]
        reach = asked.newcomer.limit * (force + turn * boundary.radius)
        with np.errstate(over="ignore"):
            size = float(judge.size(self.base) + reach) / judge.unit
        if not size * size < math.inf:
            raise AnswerInvalid(
                f"forces, load and lengths make wrenches of {size:.3g}{self.unit} in this metric, "
                "too large to be squared; their size should be below 1e150"
            )
        self.size, self.zero = size, ABSOLUTE * size
        self.rounding = ROUNDED * size * max(1.0, len(present) / 100.0)
        self.pieces = list(Allowed(asked, boundary, present).pieces())
        self.room = Room(boundary, present) if asked.newcomer.body else None
        self.is_tolerant = self.misses(tolerance)
        units = [units_of(proof.normals) for proof in claim.proofs]
        for box in claim.boxes:
            met = [
                v for v, kind in zip(box.vectors, box.kinds, strict=False) if kind != "travelling"
            ]
            units.append(units_of(met) if met else None)
        units += [units_of(span.normals) for span in claim.spans]
        units += [units_of(patch.normals) for patch in claim.patches]
        rows = np.concatenate([np.empty((0, 3)), *(u for u in units if u is not None)])
        self.normals = np.unique(rows, axis=0)
        self.surely, self.bound = self.upper_bounds()
        self.noise = self.least_noise([*present, claim.robot])

    def misses(self, tolerance: "ToleranceClaim | None") -> bool:
        """Tell whether the newcomer may be elsewhere; not if it keeps a sector for certain."""
        if tolerance is None or not tolerance.is_spread:
            return False
        newcomer, (first, last) = self.asked.newcomer, self.drawn
        if tolerance.contact != (0.0, 0.0) or not newcomer.steers or newcomer.reverse_limit:
            return True
        least = min((piece.hi - piece.lo for piece in self.pieces), default=0.0)
        return least < min(last - first, math.tau) + ANGLE

    def faults(self) -> Iterator[str]:
        """Yield every claim that does not hold."""
        claim = self.claim
        for index, robot in enumerate(self.present):
            point = np.array(robot.contact)
            if not (self.boundary.has(point) or (robot.mounted and self.boundary.surrounds(point))):
                yield f"robot {index} {robot.name!r} is off the boundary"
        if None in self.held:
            yield "the sectors said to be kept are not one of each robot with gaps between its own"
            return
        before = self.judge.team(self.held[0] or ())
        yield from self.differs("the quality before", claim.quality_before, before)
        yield from self.robot_faults("the robot", claim)
        for runner in claim.runners_up:
            yield from self.robot_faults(f"the runner-up at {runner.place}", runner)
            if runner.quality > claim.upper_bound + self.slack(claim.upper_bound):
                yield f"the runner-up at {runner.place} is better than the upper bound"
        yield from self.bound_faults()
        places = Counter([claim.place, *(runner.place for runner in claim.runners_up)])
        for place in sorted(place for place, uses in places.items() if uses > 1):
            yield f"{place!r} is answered more than once"
        gain = claim.quality - claim.quality_before
        if claim.improves and gain <= self.rounding + 0.5 * self.noise:
            yield "the newcomer is said to improve the swarm, and does not"
        rise = CERTIFIED if self.asked.criterion.worst_case else RISE
        counts = rise * claim.quality_before + 10.0 * self.zero + self.noise
        if not claim.improves and gain > 2.0 * counts:
            yield "the newcomer is said not to improve the swarm, and does"

    def bound_faults(self) -> Iterator[str]:
        """Yield what is wrong with the upper bound.

        That of a newcomer that cannot hit its place is below what the proofs show: they are of
        one that can.
        """
        claim, unit = self.claim, self.unit
        most = math.inf if self.is_tolerant else self.most
        if not (self.bound < math.inf and self.surely <= most):
            yield (
                f"the proofs show an upper bound of {self.bound:.12g}{unit} only, not "
                f"{claim.upper_bound:.12g}{unit}"
            )
        if not claim.quality <= self.bound + self.slack(claim.quality):
            yield f"the proofs bound the quality by {self.bound:.12g}{unit}, below what is claimed"
        if claim.quality > claim.upper_bound + self.slack(claim.quality):
            yield f"the upper bound {claim.upper_bound:.12g}{unit} is below the quality"
        most = claim.quality * (1.0 + claim.asked_gap)
        bound = claim.upper_bound if self.is_tolerant else self.surely
        # a search ends where rounding hides what is left; of none, as good as none
        near = max(most + max(self.slack(most), CLOSED * self.zero), 10.0 * self.zero)
        near += 0.0 if claim.improves else 2.0 * self.noise
        if not claim.stopped_early and not bound <= near:
            yield (
                f"the upper bound {bound:.12g}{unit} exceeds the quality "
                f"{claim.quality:.12g}{unit} by more than the gap asked for, "
                f"{claim.asked_gap:g}"
            )

    @property
    def most(self) -> float:
        """What the proofs may show at most."""
        if self.claim.upper_bound == 0.0:  # so it is of what counts as 0
            return 2.0 * self.zero
        return self.claim.upper_bound + self.slack(self.claim.upper_bound)

    def unchecked(self) -> Iterator[str]:
        """Yield what is taken on trust."""
        claimed = self.claim.quality
        if claimed > 0.0 and self.slack(claimed) > TOLD * claimed:
            yield (
                f"a quality of {claimed:.6g}{self.unit} is checked to {self.slack(claimed):.2g}"
                f"{self.unit} only, by the rounding of robots that are so much stronger"
            )
        plain = self.judge.is_plain
        most, count = (MOST_SWEPT if plain else MOST_LISTED), len(self.base) + 1
        if self.is_open:
            yield "the qualities of robots that are no rays are bounded from above only"
        elif not self.base.is_sure or self.is_tolerant:
            yield "the worst of the uncertain poses is bounded from above, not recomputed"
        elif count > most:
            how = "" if plain else ", by this criterion,"
            yield f"the qualities of more than {most} robots{how} are bounded from above only"
        if self.is_tolerant:
            yield "the upper bound of a newcomer that cannot hit its place exactly"

    def slack(self, value: float) -> float:
        """Return the difference that counts as rounding at a value."""
        is_round = bool(self.base.round) or self.keeps
        if not self.base.is_sure or self.is_tolerant or is_round:
            return CERTIFIED * value + self.rounding + (SETTLED * self.size if is_round else 0.0)
        return RELATIVE * value + self.rounding

    def differs(self, what: str, claimed: float, team: Team) -> Iterator[str]:
        """Yield a fault if a claimed quality is not the one found."""
        least, most = self.judge.value(team, self.normals)
        self.is_open |= (
            bool(team.round) and team.is_sure and least == 0.0 and most > 2.0 * self.zero
        )
        if claimed == 0.0 and least <= 2.0 * self.zero:
            return
        if not least - self.slack(least) <= claimed <= most + self.slack(most):
            is_known = "at most" if least < 0.5 * most else "is"
            yield (
                f"{what} is said to be {claimed:.12g}{self.unit} and {is_known} "
                f"{most:.12g}{self.unit}"
            )

    def robot_faults(self, what: str, claim: "PlacementClaim | RunnerUpClaim") -> Iterator[str]:
        """Yield what is wrong with a robot said to be allowed and to reach a quality."""
        robot, newcomer = claim.robot, self.asked.newcomer
        if any(robot.name == other.name for other in self.present):
            yield f"{what} is called {robot.name!r}, as another is"
        if robot.limit != newcomer.limit:
            yield f"{what} has the limit {robot.limit:.12g} N, not the newcomer's"
        if robot.reverse_limit != newcomer.reverse_limit:
            yield f"{what} has the reverse limit {robot.reverse_limit:.12g} N, not the newcomer's"
        if robot.sectors is not None:
            yield f"{what} has sectors with gaps between, which no newcomer has"
        if robot.tolerance != newcomer.tolerance:
            yield f"{what} has another tolerance than the newcomer"
        if robot.friction != newcomer.friction or robot.least or robot.envelope or robot.group:
            yield f"{what} exerts other forces than the newcomer"
        if robot.body != newcomer.body:
            yield f"{what} has another body than the newcomer"
        is_on = self.boundary.has(np.array(robot.contact))
        if self.room is not None and is_on and not self.room.holds(robot):
            yield f"{what} has no room for its body there"
        if robot.mounted != newcomer.mounted:
            yield f"{what} is {'' if robot.mounted else 'not '}mounted, and the newcomer otherwise"
        contact = np.array(robot.contact)
        if robot.mounted and not (self.boundary.has(contact) or self.boundary.surrounds(contact)):
            yield f"{what} is outside the outline"
        places = {
            piece.place
            for piece in self.pieces
            if piece.has(contact, self.boundary.near) and self.fits(robot, piece)
        }
        if not places:
            yield (
                f"{what} at ({contact[0]:.9g}, {contact[1]:.9g}) m pushing at "
                f"{robot.direction:.9g} rad is not an allowed one"
            )
        elif claim.place not in places:
            yield f"{what} is said to be at {claim.place!r} and is at {' or '.join(sorted(places))}"
        together = self.judge.team(self.held[1] or ()) + self.judge.team([robot])
        yield from self.differs(f"the quality with {what}", claim.quality, together)

    def fits(self, robot: "RobotClaim", piece: Piece) -> bool:
        """Tell whether a robot pushes as it may on a piece, or keeps the whole sector of it."""
        if not self.keeps:
            return robot.steers == 0.0 and turns_into(
                robot.direction, piece.lo - ANGLE, piece.hi + ANGLE
            )
        middle, half = 0.5 * (piece.lo + piece.hi), 0.5 * (piece.hi - piece.lo)
        steers = 0.0 if self.asked.newcomer.friction else min(half, math.pi)
        off = math.remainder(robot.direction - middle, math.tau)
        return abs(robot.steers - steers) <= ANGLE and abs(off) <= ANGLE

    def least_noise(self, robots: "list[RobotClaim]") -> float:
        """Bound what the outline's rounding may change of the quality, where that is least."""
        noise = noise_of(robots, self.boundary, self.judge.scale)
        if noise == 0.0 or self.asked.criterion.task is None or not len(self.normals):
            return noise
        height, _, extent = self.judge.held(self.judge.team(robots), self.normals)
        asked = float(extent[np.argmin(over(height, extent, 0.0))])
        return noise / asked if asked > 0.0 else 0.0

    def upper_bounds(self) -> tuple[float, float]:
        """Bound every allowed robot's quality by the best of the proofs for each piece.

        From below and from above: rounding may hide as much as lies between.
        """
        pieces = [piece for piece in self.pieces if not piece.is_sliver] or self.pieces
        if self.room is not None:
            newcomer = self.asked.newcomer
            pieces = [
                part for each in pieces for part in self.room.left(each, newcomer, self.keeps)
            ]
        if not pieces:
            return math.inf, math.inf
        if self.keeps:
            return self.span_bounds(pieces)
        if self.claim.boxes:
            return self.box_bounds(pieces)
        if self.asked.newcomer.reverse_limit > 0.0:  # the proofs know newcomers that push one way
            return math.inf, math.inf
        origin = self.boundary.origin
        p, q = (
            np.array([end - origin for end in ends])
            for ends in zip(*((c.p, c.q) for c in pieces), strict=True)
        )
        lo, hi = np.array([c.lo for c in pieces]), np.array([c.hi for c in pieces])
        surely = bounds = np.full(len(pieces), math.inf)
        rounding = self.rounding * self.judge.unit
        for proof in self.claim.proofs:
            normals, weights = units_of(proof.normals), np.array(proof.weights)
            if normals is None or len(weights) != len(normals) or not (weights > 0.0).all():
                continue
            weights = weights / weights.max()
            weights /= weights.sum()
            height, cap, extent = self.judge.held(self.base, normals)
            covector = (weights @ normals) * self.judge.scale * self.certain_limit
            reach = weights @ height + np.maximum(*(crest(covector, end, lo, hi) for end in (p, q)))
            asked = weights @ extent
            asked = asked if asked > UNASKED * self.judge.unit else 0.0
            found = over(reach, np.full(len(pieces), asked), rounding)
            found = np.maximum(found, over(height, extent, rounding).max())
            found = np.minimum(found, over(cap, extent, rounding).min())
            hidden = rounding / extent[extent > 0.0].min(initial=np.inf)
            surely, bounds = np.minimum(surely, found - hidden), np.minimum(bounds, found + hidden)
        return max(float(surely.max()), 0.0), max(float(bounds.max()), 0.0)

    def span_bounds(self, pieces: list[Piece]) -> tuple[float, float]:
        """Do the same by the spans, or the patches, which should cover the pieces."""
        newcomer, origin = self.asked.newcomer, self.boundary.origin
        rounding = self.rounding * self.judge.unit
        kept = Kept(self.judge, self.base, newcomer, self.certain_limit, self.drawn, rounding)
        proofs = (
            Patches(kept, self.claim.patches, origin)
            if newcomer.mounted
            else Spans(kept, self.claim.spans, origin)
        )
        return proofs.bounds(pieces, self.boundary.sliver)

    def box_bounds(self, pieces: list[Piece]) -> tuple[float, float]:
        """Do the same by the boxes, which should cover the pieces."""
        limits = self.certain_limit, self.asked.newcomer.reverse_limit
        boxes = Boxes(
            self.judge, self.present, self.base, self.claim.boxes, limits,
            self.boundary.origin, self.most, self.rounding * self.judge.unit,
        )  # fmt: skip
        if not all(boxes.cover(piece, self.boundary.sliver) for piece in pieces):
            return math.inf, math.inf
        return max(float(boxes.surely.max()), 0.0), max(float(boxes.bound.max()), 0.0)
