"""What boxes of contacts and directions prove, and whether they cover what is allowed (T23).

The wrenches b of unit forces in a box lie in the hull of six: b = sum mu_i P_i. What a newcomer
adds along a normal n is phi(n . b), phi(x) = max(limit x, -reverse x), which is convex. If it
reaches the quality t at b, then for a "met" normal

    t D(n) <= H(n) + phi(n . b) <= sum mu_i (H(n) + phi(n . P_i)).

If t is above a level L and H(n) <= L D(n), a one-way newcomer pushes along n: phi is linear there
("demanded"). And for any g ("travelling") the normal n(b) = b x g is across b, and linear in it;
with N_i = P_i x g, h convex, and d a wrench of the task, so that D(n) >= d . n, t D(n) <= h(n)
gives

    (t - L) c <= (t - L) d . n <= sum mu_i (h(N_i) - L d . N_i),   c = min d . N_i > 0.

After failures and losses h is what robots exert without those that one failure takes, and some that
may be lost beside: H is no more, and h is convex.

Without a task two normals are "flat" if H is as good as nothing along m, -m and k: then t is too,
for any newcomer.

So any convex combination of the others bounds t: by its greatest right side over the six, if that
is above L.
"""

import math
from collections.abc import Callable, Iterable, Sequence
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.verify.allowed import Piece
from swarmgrasp.verify.judge import UNASKED, Judge
from swarmgrasp.verify.recompute import ANGLE, Array, units_of
from swarmgrasp.verify.team import Team

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import BoxClaim, RobotClaim

WIDEST = math.pi / 2 + ANGLE
"""Angle [rad] between the directions of a box, at most."""
CORNERS = 6
"""Wrenches whose hull holds those of a box."""


Rows = Callable[
    [NDArray[np.intp], NDArray[np.str_], Array, tuple[str, ...]],
    tuple[Array, Array, Array, Array],
]
"""What bounds boxes by vectors of kinds, without some robots."""


class Boxes:
    """The boxes of an answer.

    Parameters
    ----------
    judge : Judge
    robots : sequence of RobotClaim
        Those already there.
    team : Team
        The same.
    claims : iterable of BoxClaim
    limits : tuple of float [N, N]
        The newcomer's, ahead and astern.
    origin : (2,) [m, m]
        Of moments.
    level : float
        A quality below which nothing needs a proof.
    rounding : float [N]
        By which H may be off.
    """

    def __init__(
        self, judge: Judge, robots: "Sequence[RobotClaim]", team: Team,
        claims: "Iterable[BoxClaim]", limits: tuple[float, float], origin: Array, level: float,
        rounding: float,
    ) -> None:  # fmt: skip
        self._judge, self._robots, self._team, self._limits = judge, robots, team, limits
        self._level, self._rounding = level * judge.unit, rounding
        claims = tuple(claims)
        self.ends = np.array([(box.start, box.end) for box in claims]).reshape(-1, 2, 2)
        self.sectors = np.array([(box.lo, box.hi) for box in claims]).reshape(-1, 2)
        self.corners = _corners(self.ends - origin, self.sectors) * judge.scale
        self.surely, self.bound = self._bounds(claims)

    def _bounds(self, claims: "tuple[BoxClaim, ...]") -> tuple[Array, Array]:
        """Return bounds of each box [N], less and more what rounding hides."""
        count = len(claims)
        flat = np.full(count, np.inf)
        sums, asked, hidden = np.zeros((count, CORNERS)), np.zeros(count), np.zeros(count)
        capped, is_proof = np.full(count, np.inf), np.zeros(count, dtype=bool)
        owner, kinds, vectors, weights = [], [], [], []
        lost: list[tuple[str, ...]] = []
        for k, claim in enumerate(claims):
            units, own = units_of(claim.vectors), np.array(claim.weights)
            width = claim.hi - claim.lo
            sizes = {len(claim.kinds), len(claim.vectors), len(claim.lost), len(own)}
            fits = len(sizes) == 1 and (own > 0.0).all()
            if units is None or not fits or not 0.0 <= width <= WIDEST:
                continue
            if "flat" in claim.kinds:
                flat[k] = self._flat(claim.kinds, units, claim.lost)
                continue
            is_proof[k] = True
            owner += [k] * len(own)
            kinds += claim.kinds
            lost += map(tuple, claim.lost)
            vectors.append(units)
            own = own / own.max()
            weights.append(own / own.sum())
        if not owner:
            return flat / self._judge.unit, flat / self._judge.unit
        box, kind = np.array(owner), np.array(kinds)
        vector, weight = np.concatenate(vectors), np.concatenate(weights)
        travels = kind == "travelling"
        ways: list[tuple[NDArray[np.bool_], Rows, tuple[str, ...]]] = [(~travels, self._met, ())]
        for gone in set(lost):
            which = travels & np.array([own == gone for own in lost])
            ways.append((which, self._travelling, gone))
        for chosen, rows, gone in ways:
            if not chosen.any():
                continue
            values, extent, off, cap = rows(box[chosen], kind[chosen], vector[chosen], gone)
            share = weight[chosen]
            np.add.at(sums, box[chosen], share[:, None] * values)
            np.add.at(asked, box[chosen], share * extent)
            np.add.at(hidden, box[chosen], share * off)
            np.minimum.at(capped, box[chosen], cap)
        most = sums.max(axis=1)
        with np.errstate(divide="ignore", invalid="ignore"):
            found, hidden = most / asked, hidden / asked
        unasked = asked <= UNASKED
        found[unasked] = np.where(most[unasked] < -self._rounding, 0.0, np.inf)
        hidden[unasked] = 0.0
        found = np.minimum(np.maximum(found, self._level), capped)
        found[~is_proof], hidden[~is_proof] = flat[~is_proof], 0.0
        return (found - hidden) / self._judge.unit, (found + hidden) / self._judge.unit

    def _flat(self, kinds: Sequence[str], units: Array, lost: Sequence[list[str]]) -> float:
        """Return what no newcomer of one line exceeds by two normals and the opposite of one [N].

        Between m, k and -m there is a normal across any wrench, and h, convex, is at most the sum
        of what it is at k and at m or -m, over the sine of the angle between m and k.
        """
        left = self._without(tuple(lost[0]))
        sine = float(np.linalg.norm(np.cross(units[0], units[-1])))
        is_pair = list(kinds) == ["flat", "flat"] and lost[0] == lost[1] and sine > 0.5
        if not is_pair or left is None or self._judge.has_task:
            return math.inf
        m, k = units
        ahead, back, across = self._judge.height(left, np.array([m, -m, k])).tolist()
        return float(max(max(ahead, back, 0.0) + max(across, 0.0), 0.0) / sine)

    def _met(
        self, box: NDArray[np.intp], kind: NDArray[np.str_], normals: Array, gone: tuple[str, ...]
    ) -> tuple[Array, Array, Array, Array]:
        """Return right sides at the corners, D relative to the task's size, rounding, and caps."""
        del gone
        different, which = np.unique(normals, axis=0, return_inverse=True)
        height, cap, extent = (
            part[which.reshape(-1)] for part in self._judge.held(self._team, different)
        )
        extent = extent / self._judge.unit
        ahead, astern = self._limits
        along = np.einsum("kic,kc->ki", self.corners[box], normals)
        gain = np.maximum(ahead * along, -astern * along)
        below = (height <= self._level * extent + self._rounding) & (extent > 0.0)
        if astern == 0.0:
            demanded = (kind == "demanded") & below
            gain[demanded] = ahead * along[demanded]
        with np.errstate(divide="ignore", invalid="ignore"):
            caps = np.where(extent > 0.0, np.maximum(cap, 0.0) / extent, np.inf)
        return height[:, None] + gain, extent, np.full(len(box), self._rounding), caps

    def _travelling(
        self, box: NDArray[np.intp], kind: NDArray[np.str_], vectors: Array, gone: tuple[str, ...]
    ) -> tuple[Array, Array, Array, Array]:
        """Return the same for normals that travel; without end where there is no such bound."""
        del kind
        normals = np.cross(self.corners[box], vectors[:, None, :])
        sizes = np.linalg.norm(normals, axis=2)
        ways = self._judge.farthest(normals.sum(axis=1))
        along = np.einsum("kic,kc->ki", normals, ways)
        least = along.min(axis=1)
        left = self._without(gone)
        known = (least > 0.0) & (left is not None)
        least = np.where(known, least, 1.0)
        units = normals / np.where(sizes > 0.0, sizes, 1.0)[:, :, None]
        height = np.zeros(sizes.shape)
        if left is not None:
            height = self._judge.height(left, units.reshape(-1, 3)).reshape(-1, CORNERS)
        rows = (height * sizes - self._level * along) / least[:, None] + self._level
        rows[~known] = np.inf
        off = self._rounding * sizes.max(axis=1) / least
        return rows, np.ones(len(box)), off, np.full(len(box), np.inf)

    def _without(self, gone: tuple[str, ...]) -> Team | None:
        """Return the robots without the machines of some; None if that bounds nothing.

        For some robot is not known, or they are more than may fail and be lost, or poses are not
        known.
        """
        machines = {r.name: r.group or (r.name,) for r in self._robots}
        if not self._team.is_sure or not machines.keys() >= set(gone):
            return None
        for failing in self._judge.failures or (frozenset[str](),):
            lost = {machines[name] for name in gone if name not in failing}
            away = failing.union(name for name, machine in machines.items() if machine in lost)
            if len(lost) <= self._judge.losing and away.issuperset(failing.union(gone)):
                return self._judge.team(r for r in self._robots if r.name not in away)
        return None

    def cover(self, piece: Piece, sliver: float) -> bool:
        """Tell whether the boxes cover a piece, but for what is no more than rounding.

        Parameters
        ----------
        piece : Piece
        sliver : float [m]
        """
        step = piece.q - piece.p
        length = float(np.linalg.norm(step))
        away = self.ends - piece.p
        if length > 0.0:
            across = np.abs(away[..., 0] * step[1] - away[..., 1] * step[0]) / length
            shares = np.sort((away @ step) / length**2, axis=1)
            near = sliver / length
        else:
            across, near = np.linalg.norm(away, axis=2), 0.0
            shares = np.tile([0.0, 1.0], (len(away), 1))
        beside = (across <= sliver).all(axis=1)
        shares, sectors = shares[beside], self.sectors[beside]
        turn = math.pi if self._limits[0] == self._limits[1] else math.tau
        sectors = sectors + turn * np.ceil((piece.lo - ANGLE - sectors[:, 1]) / turn)[:, None]
        # by another turn it may reach the other end
        boxes = np.vstack([np.hstack([shares, sectors + more]) for more in (0.0, turn)])
        return _is_covered(boxes, near, (piece.lo, piece.hi))


def _corners(arms: Array, sectors: Array) -> Array:
    """Return the wrenches (k, 6, 3) [1, 1, m] whose hull holds all unit forces of boxes."""
    half = 0.5 * (sectors[:, 1] - sectors[:, 0])
    angles = np.column_stack([sectors[:, 0], sectors[:, 0] + half, sectors[:, 1]])
    sizes = np.ones_like(angles)
    sizes[:, 1] = 1.0 / np.cos(np.clip(half, 0.0, WIDEST / 2))
    fx, fy = (sizes * np.cos(angles))[:, None, :], (sizes * np.sin(angles))[:, None, :]
    torque = arms[:, :, 0, None] * fy - arms[:, :, 1, None] * fx
    found = np.stack(np.broadcast_arrays(fx, fy, torque), axis=-1)
    return found.reshape(-1, CORNERS, 3)


def _is_covered(boxes: Array, near: float, sector: tuple[float, float]) -> bool:
    """Tell whether rectangles (k, 4) of shares and directions cover [0, 1] and a sector."""
    cuts = np.unique(np.clip(boxes[:, :2], 0.0, 1.0))
    if not len(cuts) or cuts[0] > near or cuts[-1] < 1.0 - near:
        return False
    for left, right in pairwise(cuts):
        if right - left <= near:
            continue
        over = boxes[(boxes[:, 0] <= left + near) & (boxes[:, 1] >= right - near)]
        reached = sector[0]
        for lo, hi in over[np.argsort(over[:, 2]), 2:]:
            if lo > reached + ANGLE:
                break
            reached = max(reached, hi)
        if reached < sector[1] - ANGLE:
            return False
    return True
