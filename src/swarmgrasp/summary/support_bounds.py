"""Two-sided bounds on the support function of a swarm, from its summary (T13).

With every generator turned to b_i' = +-b_i, the same sign for all of a bin's cone,

    h(n) = sum max(0, n . b_i) = (n . s + sum |n . b_i'|) / 2,     s = sum b_i,

so bins of directions and their opposites together are enough once s is known. In one bin
n . b_i' = w_i y_i, where y = n . (1, u, v) is linear in the position and so has, weighted by w,
a known mean m, a known variance r and a known range [a, b]. Hence for the bin's weight W:

- if a >= 0 or b <= 0, sum |n . b_i'| = W |m| exactly;
- otherwise W |m| <= sum |n . b_i'| <= W e(m, r, a, b), with e the greatest mean of |y| over all
  distributions of that mean, variance and range (`greatest_mean`).

Robots that are no rays add a convex function s of which, at the directions v_k of a lattice, the
wrench w_k is known that is the farthest: s(v_k) = w_k . v_k. At n = sum l_k v_k, l_k >= 0, of the
three directions around it, max w_k . n <= s(n) <= sum l_k s(v_k): w_k is a wrench they can make,
and s of a sum is at most the sum of s.
"""

import numpy as np

from swarmgrasp.summary.cells import Array, middles_and_halves, vectors_of
from swarmgrasp.summary.content import Content
from swarmgrasp.summary.lattice import lattice, mixtures

SPREAD_ROUNDING = 1e-9
"""Relative rounding of a covariance: a chunk's sums have 2^20 terms."""
RANGE_ROUNDING = 1e-12
"""By how much rounding may put a vector beyond its cell."""
EVALUATION = 1e-12
"""Rounding of a bound, and of an exact quality, relative to the sum of |b_i|."""


class SupportBounds:
    """Bounds on the support function, at any direction.

    Attributes
    ----------
    sums : (g, 3) [N]
        The sum of each bin's turned generators.
    load : tuple of float [N]
        (s - the sum of those) / 2: with it, as robots they have the lower bound as support
        function.
    size : float [N]
        What rounding is relative to.
    margin : float [N]
        What certified bounds allow for rounding.
    side : int
        Of the grid of bins, and of the lattice.
    has_sets : bool
        Whether some robots are no rays.
    """

    def __init__(self, content: Content) -> None:
        moments, side, total = content.moments, content.side, content.total
        cells, weights = moments.cells, moments.weights
        ones, none = np.ones(len(cells)), np.zeros(len(cells))
        middles, halves = middles_and_halves(cells, side)
        self.total, self.weights = total, weights
        self.sums = weights[:, None] * vectors_of(cells, side, ones, moments.means)
        self._middles = vectors_of(cells, side, ones, middles)
        self._halves = vectors_of(cells, side, none, halves * (1.0 + RANGE_ROUNDING))
        uu, uv, vv = moments.covariances
        self._variances = vectors_of(cells, side, none, np.array([uu, vv]))
        self._covariances = np.zeros((len(cells), 3))  # of the two components but the k-th
        axes = cells // side**2
        self._covariances[np.arange(len(cells)), axes] = uv
        self.side, self._wrenches = side, content.wrenches
        self.size, self.has_sets = content.size, content.has_sets
        if self.has_sets:
            self._tops = np.einsum("ij,ij->i", self._wrenches, lattice(side))
        self.margin = content.rounding + EVALUATION * self.size
        x, y, turn = (0.5 * (total - self.sums.sum(axis=0))).tolist()
        self.load = (x, y, turn)

    def farthest(self, normals: Array) -> Array:
        """Return a wrench of the robots that are no rays, far along each of unit normals (m, 3).

        Of three known ones it is the farthest: (m, 3) [N].
        """
        if not self.has_sets:
            return np.zeros_like(normals)
        known = self._wrenches[mixtures(normals, self.side)[0]]
        best = np.einsum("ikj,ij->ik", known, normals).argmax(axis=1)
        return np.asarray(known[np.arange(len(normals)), best])

    def lower(self, normals: Array) -> Array:
        """Bound h from below at unit normals (k, 3): returns (k,) [N]."""
        widths = np.abs(self.sums @ normals.T).sum(axis=0)
        sets = np.einsum("ij,ij->i", self.farthest(normals), normals)
        return np.asarray(0.5 * (normals @ self.total + widths) + sets - self.margin)

    def upper(self, normals: Array) -> Array:
        """Bound h from above at unit normals (k, 3): returns (k,) [N]."""
        values = np.abs(self.sums @ normals.T)
        reach = self._halves @ np.abs(normals.T)
        middle = self._middles @ normals.T
        bins, rows = np.nonzero(np.abs(middle) < reach)  # the bins that the normal's plane cuts
        n, c, r = normals[rows], middle[bins, rows], reach[bins, rows]
        pairs = np.column_stack([n[:, 1] * n[:, 2], n[:, 2] * n[:, 0], n[:, 0] * n[:, 1]])
        apart = np.einsum("ij,ij->i", self._variances[bins], n * n)
        together = 2.0 * np.einsum("ij,ij->i", self._covariances[bins], pairs)
        variance = np.maximum(apart + together, 0.0) + SPREAD_ROUNDING * apart
        mean = values[bins, rows] / self.weights[bins]
        # |y| is even: turn y so that its mean is positive
        turn = np.where(np.einsum("ij,ij->i", self.sums[bins], n) < 0.0, -c, c)
        means = greatest_mean(mean, variance, turn - r, turn + r)
        values[bins, rows] = self.weights[bins] * np.maximum(means, mean)
        rays = 0.5 * (normals @ self.total + values.sum(axis=0))
        return np.asarray(rays + self._sets_at_most(normals) + self.margin)

    def _sets_at_most(self, normals: Array) -> Array | float:
        """Bound what robots that are no rays add at unit normals (k, 3): returns (k,) [N]."""
        if not self.has_sets:
            return 0.0
        numbers, weights = mixtures(normals, self.side)
        return np.asarray((weights * self._tops[numbers]).sum(axis=1))


def greatest_mean(mean: Array, variance: Array, low: Array, high: Array) -> Array:
    """Return the greatest mean of |y| over distributions of y with given mean and variance.

    With r = sqrt(mean^2 + variance): if low <= -r and r <= high it is r, reached by the values
    +-r. If -r < low it is reached by the values low and z = mean + variance / (mean - low): for
    z >= -low the parabola y + g (y - z)^2 through (low, -low) is nowhere below |y| on the range.
    If r > high, the same mirrored. Whatever the variance, the chord of |y| over the range bounds
    it too, which serves where rounding has made the variance too large.

    Parameters
    ----------
    mean, variance, low, high : (k,)
        low < 0 < high and low <= mean <= high, up to rounding.

    Examples
    --------
    Values -1 and 3, each half of the time, have mean 1, variance 4 and mean size 2.

    >>> range_of = np.array([-1.0]), np.array([3.0])
    >>> greatest_mean(np.array([1.0]), np.array([4.0]), *range_of).tolist()
    [2.0]
    """
    root = np.sqrt(mean * mean + variance)
    chord = -low + (high + low) * ((mean - low) / (high - low))
    bound = np.minimum(root, chord)
    for m, end in ((mean, -low), (-mean, high)):  # mirrored: y from -high to -low
        past = np.maximum(m + end, 0.0)
        is_short = (root > end) & (past > 0.0)
        gap = np.where(is_short, past, 1.0)
        share = variance / (variance + gap * gap)
        two = share * end + (1.0 - share) * np.abs(m + variance / gap)
        bound = np.where(is_short, np.minimum(bound, two), bound)
    return bound
