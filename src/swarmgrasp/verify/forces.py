"""An independent check of push forces, from plain data alone.

It uses nothing of the solver, nor of the package's swarms: wrenches are made anew, and what is
claimed is recomputed in plain NumPy. That no other forces are better follows from the normals and
the price by weak duality (T18, T27), which holds whatever they are: they need no trust.
"""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import pairwise

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.verify.pushes import ANGLE, THIN, Array, Pair, Robots, is_part, outside

Kept = tuple[tuple[int, Pair], ...]
"""Robots with gaps, by index, that keep to one sector each."""

ROUNDING = 1e-9
"""Relative difference that counts as rounding."""
OWN = 1e-14
"""Shortfall that counts as none, relative to the robots' total wrench."""
EPSILON = 1e-14
"""Relative error of a product of a price and a generator."""
FLAT = 1e-12
"""Cosine within which a generator may count as at right angles to a normal."""
SHARE = 1e-8
"""Difference of two shares that counts as none, beside what rounding of forces is of a thin set."""


SLACK = 1e-6
"""By so much of itself the least largest share may differ from what is proven, and the largest be
more, for the least sum of squares."""
LEFT = 3e-6
"""By so much of itself less may be proven of other sectors than of those taken."""
SUM = 2e-5
"""By so much of itself that sum may exceed the least."""


@dataclass(frozen=True, eq=False)
class Claim:
    """What is claimed of the forces for one wrench.

    Attributes
    ----------
    robots : Robots
    metric : tuple of float [1, 1, m]
        The force weights and the characteristic length.
    wanted, load, wrench : (3,) [N, N, N m]
    vectors : (n, 2) [N, N]
    shares : (n,)
    needed : float
    shortfall : float [N]
    is_least_squares : bool
    normals : (k, 3)
    price : (3,) [1/N]
        As in `Forces` and its `ForcesCertificate`.
    kept : tuple of (int, pair)
    others : tuple of (kept, (3,))
    is_best : bool
        As in its `SectorsProof`, of robots with gaps between their sectors.
    """

    robots: Robots
    metric: tuple[float, float, float]
    wanted: Array
    load: Array
    wrench: Array
    vectors: Array
    shares: Array
    needed: float
    shortfall: float
    is_least_squares: bool
    normals: Array
    price: Array
    kept: Kept = ()
    others: tuple[tuple[Kept, Array], ...] = ()
    is_best: bool = True

    @property
    def scale(self) -> Array:
        """(3,) [1, 1, 1/m]: what turns wrenches into the metric's coordinates."""
        a1, a2, length = self.metric
        return np.array([a1**0.5, a2**0.5, 1.0 / length])


def faults_of(claim: Claim) -> Iterator[str]:
    """Find everything that is claimed and does not hold."""
    robots = claim.robots
    if not robots.sectors:
        yield from _ray_faults(claim) if robots.are_rays else _set_faults(claim)
        return
    faults = [*_sector_faults(claim)]
    yield from faults
    if not faults:
        yield from _other_faults(claim)
        yield from _set_faults(replace(claim, robots=robots.keeping(claim.kept)))


def _sector_faults(claim: Claim) -> Iterator[str]:
    """Find forces in a gap, and sectors kept that are none (T28)."""
    robots = claim.robots
    for i, sectors in robots.sectors.items():
        x, y = claim.vectors[i].tolist()
        off = min(float(outside(np.arctan2(y, x), *sector)) for sector in sectors)
        if not math.hypot(x, y) * math.sin(min(off, 0.5 * math.pi)) <= THIN * robots.limits[i]:
            yield f"the force of robot {i} lies in a gap between its sectors"
    for kept in (claim.kept, *(kept for kept, _ in claim.others)):
        rows = [i for i, _ in kept]
        if len(set(rows)) < len(rows) or not set(rows) <= set(robots.sectors):
            yield f"robots {rows} are said to keep one sector each"
        elif not all(is_part(part, robots.sectors[i]) for i, part in kept):
            yield "a sector said to be kept is no part of a robot's, of half a turn or less"


def _other_faults(claim: Claim) -> Iterator[str]:
    """Check that no other choice of sectors serves better (T28): weak duality for each of them.

    The normals of others prove it of all that agree with what these keep, the gaps of the other
    robots filled.
    """
    if not claim.is_best:
        return
    boxes = [dict(claim.kept), *(dict(kept) for kept, _ in claim.others)]
    if not _are_all(boxes, claim.robots.sectors):
        yield "the sectors kept, and the others, are not all choices that there are"
    rest = claim.robots.wrenches(claim.robots.rests).sum(axis=0)
    wanted = (claim.wanted - claim.load - rest) * claim.scale
    for kept, normal in claim.others:
        height = _reach(claim.robots.keeping(kept), normal * claim.scale)
        slack = ROUNDING * (height + _length(wanted))
        reach, size = float(normal @ wanted), _length(normal)
        if claim.shortfall == 0.0:
            is_worse = reach >= (1.0 - LEFT) * claim.needed * height - slack
        else:
            is_worse = reach - height >= (1.0 - LEFT) * claim.shortfall * size - slack
        if not (is_worse and abs(size - 1.0) <= ROUNDING):
            yield f"the normal does not prove that other sectors, {kept}, serve no better"


def _are_all(boxes: list[dict[int, Pair]], sectors: Mapping[int, Sequence[Pair]]) -> bool:
    """Tell whether any directions that robots may push in agree with one of some choices."""
    if not all(boxes):
        return True  # one that keeps nothing more
    if not boxes:
        return False
    i = next(iter(boxes[0]))
    ends = [end for box in boxes if i in box for end in box[i]]
    agreeing: list[frozenset[int]] = []
    for first, last in sectors[i]:
        cuts = sorted(c for end in ends if (c := (end - first) % math.tau) < last - first)
        for start, end in pairwise([0.0, *cuts, last - first]):
            middle = np.asarray(first + 0.5 * (start + end))
            if end - start > ANGLE or last == first:
                agreeing.append(frozenset(
                    k for k, box in enumerate(boxes)
                    if i not in box or outside(middle, *box[i]) <= ANGLE
                ))  # fmt: skip
    # where more agree than elsewhere, nothing is to be checked
    fewest = [some for some in set(agreeing) if not any(other < some for other in agreeing)]
    return all(
        _are_all([{j: s for j, s in boxes[k].items() if j != i} for k in sorted(some)], sectors)
        for some in fewest
    )


def _ray_faults(claim: Claim) -> Iterator[str]:
    """Find what does not hold of robots that push along one ray each."""
    shares, robots, scale = claim.shares, claim.robots, claim.scale
    most = robots.limits[:, None] * np.column_stack(
        [np.cos(robots.directions), np.sin(robots.directions)]
    )
    B = robots.wrenches(most) * scale
    sizes = np.linalg.norm(B, axis=1)
    made, wanted = shares @ B, (claim.wanted - claim.load) * scale
    slack = ROUNDING * (float(sizes @ np.abs(shares)) + _length(wanted)) + OWN * float(sizes.sum())
    yield from _outcome_faults(claim, made, wanted, slack)
    aside = np.abs(claim.vectors - shares[:, None] * most).max(axis=1, initial=0.0)
    yield from _at_fault(aside > ROUNDING * robots.limits, "force", "not its share of its limit")
    if not len(claim.normals):
        if shares.any():
            yield "there are shares, but no normal that proves them needed"
        return
    first, *others = claim.normals
    if claim.shortfall == 0.0:
        yield from _needed_faults(first, B, shares, wanted, slack)
    else:
        total = float(sizes.sum())
        yield from _nearest_faults(first, _height(B, first), total, wanted, made, slack)
        heights = B @ first
        if others and not (heights > FLAT * sizes).any():  # nobody has to give all
            flat = np.abs(heights) <= FLAT * sizes
            yield from _needed_faults(others[0], B[flat], shares[flat], made, slack)
    yield from _share_faults(claim, B, sizes)


def _set_faults(claim: Claim) -> Iterator[str]:
    """Find what does not hold of robots of any force sets."""
    robots, scale, shares = claim.robots, claim.scale, claim.shares
    arms = np.hypot(*robots.arms.T)
    sizes = robots.reaches * np.sqrt(scale[0] ** 2 + scale[1] ** 2 + (scale[2] * arms) ** 2)
    total, beyond = float(sizes.sum()), claim.vectors - robots.rests
    rest = robots.wrenches(robots.rests).sum(axis=0) * scale
    made = robots.wrenches(beyond).sum(axis=0) * scale
    asked = (claim.wanted * scale, claim.load * scale, rest)
    wanted = asked[0] - asked[1] - asked[2]
    slack = ROUNDING * (float(sizes @ np.abs(shares)) + _length(wanted)) + OWN * (
        total + sum(map(_length, asked))
    )
    yield from _outcome_faults(claim, made + rest, wanted + rest, slack)
    least, most = robots.shares(beyond)
    rounded = robots.reaches + np.hypot(*claim.vectors.T)
    allowed = SHARE + EPSILON / THIN * rounded / np.maximum(robots.reaches, EPSILON * rounded)
    is_wrong = ~((shares >= least - allowed) & (shares <= most + allowed))
    yield from _at_fault(is_wrong, "share", "not what its force is of its set")
    top = float(shares.max(initial=0.0))
    if not len(claim.normals):
        if top > 0.0:
            yield "there are shares, but no normal that proves them needed"
        return
    first, *others = claim.normals
    height = _reach(robots, first * scale)
    if claim.shortfall == 0.0:
        proven = _proven(first, wanted, height)
        if not abs(claim.needed - min(proven, 1.0)) <= SLACK * proven + _part(slack, height):
            yield f"the share needed is {claim.needed:.9g}; the normal proves {proven:.9g}"
    else:
        proven = 1.0
        yield from _nearest_faults(first, height, total, wanted, made, slack)
        if others:
            height = _reach(robots, others[0] * scale)
            proven = _proven(others[0], made, height)
    if not top <= min(proven * (1.0 + 2.0 * SLACK), 1.0) + ROUNDING + _part(slack, height):
        yield f"the largest share is {top:.9g}; the normal proves no more than {proven:.9g} needed"
    if claim.is_least_squares:
        yield from _sum_faults(claim, beyond, top)


def _proven(normal: Array, wrench: Array, height: float) -> float:
    """Return the largest share that a wrench needs: n . w <= t h(n) for all t that make it."""
    return max(0.0, _part(float(normal @ wrench), height))


def _part(reach: float, height: float) -> float:
    """Return the quotient of two sizes [N], the second perhaps 0."""
    return reach / height if height > 0.0 else math.copysign(math.inf, reach)


def _outcome_faults(claim: Claim, made: Array, wanted: Array, slack: float) -> Iterator[str]:
    """Check the range of the shares, the wrench they make and how far it is from the wanted."""
    shares = claim.shares
    if not ((shares >= 0.0) & (shares <= 1.0)).all():
        yield f"the shares are from {shares.min()} to {shares.max()}; they should be within 0 and 1"
    off = _length((claim.wrench - claim.load) * claim.scale - made)
    if not off <= slack:
        yield f"the wrench is {off:g} N away from what the forces make, in the metric"
    distance = _length(wanted - made)
    if not abs(distance - claim.shortfall) <= slack:
        yield f"the shortfall is {claim.shortfall:g} N; recomputed it is {distance:g} N"


def _at_fault(is_wrong: NDArray[np.bool_], what: str, why: str) -> Iterator[str]:
    """Tell the first robot at fault, and how many are."""
    wrong = np.flatnonzero(is_wrong)
    if len(wrong):
        so = f"so it is for {len(wrong)} of {len(is_wrong)}"
        yield f"the {what} of robot {wrong[0]} is {why}; {so}"


def _reach(robots: Robots, covector: Array) -> float:
    """h(n) [N]: the most that robots exert along a covector beyond their rests."""
    return float(np.maximum(robots.supports(robots.levers(covector)), 0.0).sum())


def _sum_faults(claim: Claim, forces: Array, top: float) -> Iterator[str]:
    """Check the least sum of squares, by how far each force is from nearest to what the price asks.

    With q = reach^2 p(y), a force x of a set is the nearest to q if no force y of it has
    (q - x) . (y - x) > 0; what is left of that is the gap between the sum and its dual.
    """
    robots = claim.robots
    has_choice = robots.reaches > 0.0
    reach = np.where(has_choice, robots.reaches, 1.0)
    asked = reach[:, None] * robots.levers(claim.price * claim.scale)
    part = np.where(has_choice[:, None], forces / reach[:, None], 0.0)
    left = asked - part
    gaps = top * robots.supports(left) / reach - (left * part).sum(axis=1)
    gap, whole = float(gaps[has_choice].sum()), float((part**2).sum())
    noise = FLAT * float((np.hypot(*asked.T) + np.hypot(*part.T))[has_choice].sum())
    if not gap <= SUM * whole + noise:
        yield (
            f"the sum of squares of what forces are of the largest is {whole:.9g}; the price "
            f"proves no more than {whole - gap:.9g} needed"
        )


def _length(vector: Array) -> float:
    """Return a vector's length."""
    return float(np.linalg.norm(vector))


def _height(B: Array, normal: Array) -> float:
    """h(n) = sum max(0, n . b_i) [N]."""
    return float(np.maximum(B @ normal, 0.0).sum())


def _needed_faults(
    normal: Array, B: Array, shares: Array, wanted: Array, slack: float
) -> Iterator[str]:
    """Check that no smaller largest share t makes the wrench: n . w <= t h(n) for all that do."""
    top, height = float(shares.max(initial=0.0)), _height(B, normal)
    reach = float(normal @ wanted)
    if not top * height <= reach + slack:
        proven = max(0.0, reach / height)
        yield f"the largest share is {top:.9g}; the normal proves no more than {proven:.9g} needed"


def _nearest_faults(
    normal: Array, height: float, total: float, wanted: Array, made: Array, slack: float
) -> Iterator[str]:
    """Check that no wrench is nearer: all are behind the plane through the one made."""
    slack += ROUNDING * total
    miss = wanted - made
    beyond = height - float(normal @ made)
    if not beyond <= slack:
        yield f"a wrench that is {beyond:g} N farther along the normal can be made"
    if not _length(miss - (normal @ miss) * normal) <= slack:
        yield "the normal does not point from the wrench made to the one wanted"


def _share_faults(claim: Claim, B: Array, sizes: Array) -> Iterator[str]:
    """Check who gives the largest share, who nothing, and that the others share by the price.

    The first normal that a generator is not at right angles to decides.
    """
    shares = claim.shares
    top = float(shares.max(initial=0.0))
    good = np.zeros(len(B), dtype=bool)
    undecided = ~good
    for normal in claim.normals:
        heights = B @ normal
        bound = np.where(heights > 0.0, top, 0.0)
        good |= undecided & (heights != 0.0) & (np.abs(shares - bound) <= ROUNDING)
        undecided &= np.abs(heights) <= FLAT * sizes
    with np.errstate(divide="ignore"):  # a share of next to nothing may be any
        own = OWN * float(sizes.sum()) / sizes
    allowed = ROUNDING + EPSILON * sizes * _length(claim.price) + own
    good |= undecided & (np.abs(shares - np.clip(B @ claim.price, 0.0, top)) <= allowed)
    wrong = np.flatnonzero(~good)
    if len(wrong):
        i = int(wrong[0])
        yield (
            f"the share of robot {i} is {shares[i]:.9g}, which the proof does not show to be "
            f"least; so it is for {len(wrong)} of {len(shares)} robots"
        )
