"""The shares of their limits that robots exert when a swarm makes its weakest wrench (T19)."""

from dataclasses import dataclass

import numpy as np

from swarmgrasp.quality.heights import ON_FACET, Array, Heights, Mask, largest
from swarmgrasp.quality.weakest_facets import TIED

NONE = 1e-12
"""Share that is rounding."""


def shares_at(heights: Heights, normal: Array, value: float) -> Array:
    """Find the least and the greatest share of each robot at a weakest facet.

    The swarm makes the wrench where the ball, or the task, touches the facet: with all of the
    robots above the facet, none of those below, and some of those on it. When robot i's
    generator moves by db, the quality there changes by (n . db) times its greatest share
    where n . db > 0, and its least where n . db < 0, divided by D(n).

    Where several robots may be the ones that are lost, or the task has several vertices there,
    these two numbers are the slopes of the least quality, and only that.

    Parameters
    ----------
    heights : Heights
    normal : (3,)
        Of a weakest facet.
    value : float
        The criterion's value.

    Returns
    -------
    (n, 2)
        Least and greatest.
    """
    products = heights.products(normal[None])[0]
    lost = _lost_at(heights, products)
    shares = np.zeros((len(products), 2))
    shares[lost.kept] = 1.0
    if lost.tied_losses < lost.tied.sum():
        shares[lost.tied, 0] = 1.0  # whoever adds more is lost instead of another
    plane = _Plane.of(heights, normal, value, lost, products == 0.0)
    for row, index in enumerate(np.flatnonzero(products == 0.0)):
        # of nearly parallel generators rounding may say more ("nearly parallel", seed 38)
        shares[index] = np.clip([-plane.least(row, -1.0), plane.least(row, 1.0)], 0.0, 1.0)
    shares[np.abs(shares) <= NONE] = 0.0
    return shares


@dataclass(frozen=True, eq=False)
class _Lost:
    """Who is lost along a normal: certainly some, and so many of those that add equally much."""

    kept: Mask
    tied: Mask
    tied_losses: int
    facet_losses: int
    """Losses left for robots on the facet, which add nothing as it is."""


def _lost_at(heights: Heights, products: Array) -> _Lost:
    """Tell who is lost when the terms max(0, n . b_i) are `products` (n,)."""
    above, count = products > 0.0, heights.losing
    nobody = np.zeros(len(products), dtype=bool)
    if count == 0:
        return _Lost(above, nobody, 0, 0)
    if above.sum() < count:
        return _Lost(nobody, nobody, 0, count - int(above.sum()))
    least = np.sort(products)[-count]
    rounding = TIED * float(heights.sizes[above].sum())
    more = products > least + rounding
    tied = above & ~more & (products >= least - rounding)
    return _Lost(above & ~more & ~tied, tied, count - int(more.sum()), 0)


@dataclass(frozen=True, eq=False)
class _Plane:
    """The criterion next to a facet, to first order in a step of the normal across it.

    A step y (2,) changes H - value D by s . y + sum max(0, p_l . y) over the robots on the
    facet, and more terms for what may be lost and for the task.
    """

    heights: Heights
    normal: Array
    value: float
    axes: Array
    """(2, 3): of the plane across the normal."""
    fixed: Array
    """(2,) [N]: s."""
    on: Array
    """(z, 2) [N]: the generators p_l on the facet."""
    tied: Array
    """(t, 2) [N]: of robots that add equally much, `tied_losses` of them lost."""
    lost: _Lost

    @classmethod
    def of(
        cls, heights: Heights, normal: Array, value: float, lost: _Lost, on_facet: Mask
    ) -> "_Plane":
        """Look at the criterion next to a normal."""
        axes = np.linalg.qr(np.column_stack([normal, np.eye(3)]))[0][:, 1:3].T
        flat = heights.generators @ axes.T
        fixed = flat[lost.kept].sum(axis=0) + axes @ heights.load
        return cls(heights, normal, value, axes, fixed, flat[on_facet], flat[lost.tied], lost)

    def least(self, row: int, rise: float) -> float:
        """Find the least change when robot `row` of those on the facet rises above it.

        The change is linear between the lines p_l . y = 0 and p_row . y = -rise, and grows far
        away: it is least at 0 or where the last line crosses one of the others.
        """
        p = self.on[row]
        size = float(np.linalg.norm(p))
        along = np.array([-p[1], p[0]]) / size
        foot = -rise * p / size**2
        others = np.delete(self.on, row, axis=0)
        slopes = others @ along
        crossing = np.abs(slopes) > ON_FACET * np.linalg.norm(others, axis=1)
        slopes, offsets = slopes[crossing], (others @ foot)[crossing]
        at = np.unique(-offsets / slopes)
        steps = foot + at[:, None] * along
        change = steps @ self.fixed + np.maximum(others[~crossing] @ foot, 0.0).sum()
        change += _added(slopes, -offsets / slopes, at)
        if self.lost.facet_losses:
            terms = np.maximum(steps @ others.T, 0.0)
            change -= largest(terms, self.lost.facet_losses)
        if len(self.tied):
            terms = steps @ self.tied.T
            change += terms.sum(axis=1) - largest(terms, self.lost.tied_losses)
        change -= self.value * self.heights.asked_slopes(self.normal, steps @ self.axes)
        staying = 0.0 if self.lost.facet_losses else max(0.0, rise)
        return float(min(staying, change.min(initial=np.inf)))


def _added(slopes: Array, zeros: Array, at: Array) -> Array:
    """Add up max(0, slope (t - zero)) over terms (k,) at ascending points t (m,): (m,)."""
    total = np.zeros(len(at))
    for up, sign in ((slopes > 0.0, 1.0), (slopes < 0.0, -1.0)):
        order = np.argsort(sign * zeros[up])
        weights = np.abs(slopes[up][order])
        places = sign * zeros[up][order]
        counts = np.searchsorted(places, sign * at, side="right")
        sums = np.concatenate([[0.0], np.cumsum(weights)])
        moments = np.concatenate([[0.0], np.cumsum(weights * places)])
        total += sums[counts] * sign * at - moments[counts]
    return total
