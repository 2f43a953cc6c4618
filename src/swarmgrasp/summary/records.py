"""The moments of bins as records of 18 bytes, rounded so that bounds stay certain.

A weight is a float32 times a power of two that all records share. A mean is kept in steps of
1/32767 of half its cell's width; a standard deviation in steps of 1/65000 of it, rounded up; a
correlation in steps of 1/32767. Records come back as the same records.
"""

import math

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.summary.cells import Array, middles_and_halves
from swarmgrasp.summary.moments import DIAGONAL, Moments

RECORD = np.dtype(
    [
        ("cell", "<u4"),
        ("weight", "<f4"),
        ("mean", "<i2", 2),
        ("spread", "<u2", 2),
        ("correlation", "<i2"),
    ]
)
ALONG = 32767
"""A mean at the cell's edge."""
SPREAD, MOST = 65000, 65535
"""A standard deviation of half the cell's width, the largest there is; and room above it."""
WHOLE = 32767
"""A correlation of 1."""
RAISED = 1.0 + 2.0**-14
"""What makes up for a rounded correlation."""
LIGHTEST = 2.0**-126
"""Least weight of a record, relative to the power of two."""

Records = NDArray[np.void]


def records_of(moments: Moments, side: int, exponent: int) -> tuple[Records, float]:
    """Round moments to records, whose weights are relative to a power of two [N].

    Returns
    -------
    records : (r,)
        Of all bins but those that are too light to matter.
    moved : float [N]
        What to allow for rounding, in all bins together.
    """
    shares = (moments.weights / math.ldexp(1.0, exponent)).astype("<f4")
    kept = shares >= LIGHTEST
    moved = DIAGONAL * float(moments.weights[~kept].sum())
    records = np.zeros(int(kept.sum()), RECORD)
    records["cell"], records["weight"] = moments.cells[kept], shares[kept]
    weights, means = moments.weights[kept], moments.means[:, kept]
    middles, halves = middles_and_halves(moments.cells[kept], side)
    along = np.rint((means - middles) / halves * ALONG)
    records["mean"] = np.clip(along, -ALONG, ALONG).T
    rounded = np.ldexp(records["weight"].astype(float), exponent)
    drawn = np.abs(_means(records, middles, halves) - means).sum(axis=0)
    # means count twice: with the spread between bins that are merged later they move once more
    moved += float((DIAGONAL * np.abs(rounded - weights) + 2.0 * rounded * drawn).sum())
    # weight times the standard deviation must not shrink
    wanted = moments.covariances[:, kept] * (weights / rounded) ** 2
    _round_spreads(records, wanted, halves)
    return records, moved * (1.0 + 1e-9)


def exponent_of(largest: float) -> int:
    """Return the exponent of the power of two above all sizes, also once they are float32."""
    share, exponent = math.frexp(largest)
    return exponent + int(np.float32(share) == 1.0)


def _round_spreads(records: Records, wanted: Array, halves: Array) -> None:
    """Write spreads whose covariance matrix exceeds the wanted one (3, g) by a semidefinite one.

    Rounding the standard deviations up usually is enough. Where it is not, because the rounded
    correlation takes more than they give, they are raised: the variances then grow by 2^-13 of
    themselves, the covariance changes by at most 2^-16 of the standard deviations' product.
    """
    exact = np.sqrt(wanted[[0, 2]]) / halves * SPREAD
    spreads = np.rint(exact)
    spreads += (halves * (spreads / SPREAD)) ** 2 < wanted[[0, 2]]
    _write_spreads(records, spreads, wanted, halves)
    uu, uv, vv = _covariances(records, halves) - wanted
    short = (uu < 0.0) | (vv < 0.0) | (uu * vv < uv * uv)
    if short.any():
        spreads = np.where(short, np.ceil(exact * RAISED) + 1.0, spreads)
        _write_spreads(records, spreads, wanted, halves)


def _write_spreads(records: Records, spreads: Array, wanted: Array, halves: Array) -> None:
    """Write standard deviations (2, g), and the correlation that goes with them."""
    records["spread"] = np.clip(spreads, 0, MOST).T
    product = (halves * (spreads / SPREAD)).prod(axis=0)
    ratio = np.divide(wanted[1], product, out=np.zeros_like(product), where=product > 0.0)
    records["correlation"] = np.clip(np.rint(ratio * WHOLE), -WHOLE, WHOLE)


def _means(records: Records, middles: Array, halves: Array) -> Array:
    """Return the mean positions (2, g) of records."""
    return np.asarray(middles + halves * (records["mean"].T.astype(float) / ALONG))


def _covariances(records: Records, halves: Array) -> Array:
    """Return the covariances (3, g) of records."""
    u, v = halves * (records["spread"].T.astype(float) / SPREAD)
    return np.array([u * u, u * v * (records["correlation"].astype(float) / WHOLE), v * v])


def moments_from(records: Records, exponent: int, side: int) -> Moments:
    """Return the moments that records stand for, of the given exponent."""
    cells = records["cell"].astype(np.int64)
    middles, halves = middles_and_halves(cells, side)
    return Moments(
        cells,
        np.ldexp(records["weight"].astype(float), exponent),
        _means(records, middles, halves),
        _covariances(records, halves),
    )
