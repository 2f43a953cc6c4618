"""An independent check of shares, from plain data alone.

It uses nothing of the solver, nor of the package's swarms: generators are made anew, and what is
claimed is recomputed in plain NumPy. That no other shares are better follows from the normals and
the price by weak duality (T18), which holds whatever they are: they need no trust.
"""

from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]

ROUNDING = 1e-9
"""Relative difference that counts as rounding."""
OWN = 1e-14
"""Shortfall that counts as none, relative to the robots' total wrench."""
EPSILON = 1e-14
"""Relative error of a product of a price and a generator."""
FLAT = 1e-12
"""Cosine within which a generator may count as at right angles to a normal."""


@dataclass(frozen=True, eq=False)
class Claim:
    """What is claimed of the shares of one wrench.

    Attributes
    ----------
    arms : (n, 2) [m, m]
        Contacts relative to the origin of moments.
    directions : (n,) [rad]
    limits : (n,) [N]
    metric : tuple of float [1, 1, m]
        The force weights and the characteristic length.
    wanted, load, wrench : (3,) [N, N, N m]
    shares : (n,)
    shortfall : float [N]
    normals : (k, 3)
    price : (3,) [1/N]
        As in `Forces` and its `ForcesCertificate`.
    """

    arms: Array
    directions: Array
    limits: Array
    metric: tuple[float, float, float]
    wanted: Array
    load: Array
    wrench: Array
    shares: Array
    shortfall: float
    normals: Array
    price: Array


def faults_of(claim: Claim) -> Iterator[str]:
    """Find everything that is claimed and does not hold."""
    shares, (a1, a2, length) = claim.shares, claim.metric
    scale = np.array([a1**0.5, a2**0.5, 1.0 / length])
    B = _generators(claim) * scale
    sizes = np.linalg.norm(B, axis=1)
    made, wanted = shares @ B, (claim.wanted - claim.load) * scale
    slack = ROUNDING * (float(sizes @ np.abs(shares)) + _length(wanted)) + OWN * float(sizes.sum())
    if not ((shares >= 0.0) & (shares <= 1.0)).all():
        yield f"the shares are from {shares.min()} to {shares.max()}; they should be within 0 and 1"
    off = _length((claim.wrench - claim.load) * scale - made)
    if not off <= slack:
        yield f"the wrench is {off:g} N away from what the forces make, in the metric"
    distance = _length(wanted - made)
    if not abs(distance - claim.shortfall) <= slack:
        yield f"the shortfall is {claim.shortfall:g} N; recomputed it is {distance:g} N"
    if not len(claim.normals):
        if shares.any():
            yield "there are shares, but no normal that proves them needed"
        return
    first, *others = claim.normals
    if claim.shortfall == 0.0:
        yield from _needed_faults(first, B, shares, wanted, slack)
    else:
        yield from _nearest_faults(first, B, wanted, made, slack)
        heights = B @ first
        if others and not (heights > FLAT * sizes).any():  # nobody has to give all
            flat = np.abs(heights) <= FLAT * sizes
            yield from _needed_faults(others[0], B[flat], shares[flat], made, slack)
    yield from _share_faults(claim, B, sizes)


def _generators(claim: Claim) -> Array:
    """(n, 3) [N, N, N m]: the wrenches of the robots at their limits."""
    x, y = claim.arms.T
    fx, fy = claim.limits * (np.cos(claim.directions), np.sin(claim.directions))
    return np.column_stack([fx, fy, x * fy - y * fx])


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
    normal: Array, B: Array, wanted: Array, made: Array, slack: float
) -> Iterator[str]:
    """Check that no wrench is nearer: all are behind the plane through the one made."""
    slack += ROUNDING * float(np.linalg.norm(B, axis=1).sum())
    miss = wanted - made
    beyond = _height(B, normal) - float(normal @ made)
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
