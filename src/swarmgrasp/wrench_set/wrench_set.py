"""The wrench set: every wrench a swarm can make, a zonotope, and its faces and corners."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import MetricInvalid, WrenchInvalid
from swarmgrasp.frozen import Frozen
from swarmgrasp.linear import minimise
from swarmgrasp.ranges import STRONGEST, WEAKEST, array_of, number, numbers, shown
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.swarm import check_rays, check_swarm
from swarmgrasp.wrench_set.mesh import (
    ANGLE_TOLERANCE,
    Mesh,
    across,
    fold,
    plane_tolerance,
    unit_directions,
    zonotope_mesh,
)


@dataclass(frozen=True, eq=False)
class WrenchSet(Frozen):
    """The wrenches a swarm can make: W = {sum u_i b_i, 0 <= u_i <= 1}, a zonotope.

    Parameters
    ----------
    swarm : Swarm

    Attributes
    ----------
    generators : (n, 3) [N, N, N m]
        The wrench b_i of each robot at its limit.
    scale : (3,) [1, 1, 1/m]
        Makes the metric Euclidean: scaled wrenches are ``generators * scale``.

    Examples
    --------
    >>> from swarmgrasp import Outline, Robot, Swarm
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> tugs = [Robot((1, 0), 0.0), Robot((0, 1), 1.5707963267948966), Robot((1, 1), 0.0)]
    >>> wrenches = WrenchSet(Swarm(square, tugs))
    >>> wrenches.rank, round(wrenches.volume, 12)
    (3, 1.0)
    >>> wrenches.contains([[1.0, 0.5, 0.0], [0.0, -0.1, 0.0]]).tolist()
    [True, False]

    No robots make no wrench:

    >>> nobody = WrenchSet(Swarm(square, []))
    >>> nobody.rank, nobody.contains([0.0, 0.0, 0.0]), nobody.contains([0.0, 0.0, 0.1])
    (0, True, False)
    """

    generators: NDArray[np.float64]
    scale: NDArray[np.float64]

    def __init__(self, swarm: Swarm) -> None:
        check_swarm(swarm)
        check_rays(swarm, "a wrench set")
        self._fill(swarm.generators, swarm.scale)

    @classmethod
    def from_generators(
        cls, generators: ArrayLike, scale: ArrayLike = (1.0, 1.0, 1.0)
    ) -> "WrenchSet":
        """Build a wrench set from generators that need not belong to robots.

        Parameters
        ----------
        generators : (n, 3) [N, N, N m]
        scale : (3,) [1, 1, 1/m], optional

        Raises
        ------
        WrenchInvalid
            If the generators are not finite triples.
        MetricInvalid
            If a scale is not positive and finite.

        Examples
        --------
        >>> cube = WrenchSet.from_generators([[1, 0, 0], [0, 1, 0], [0, 0, 1]])
        >>> cube.volume
        1.0
        """
        factors = numbers(scale)
        if len(factors) != 3 or not all(WEAKEST <= factor <= STRONGEST for factor in factors):
            raise MetricInvalid(
                f"the scale is {shown(scale)}; it should be 3 numbers, {WEAKEST:g} <= s <= "
                f"{STRONGEST:g}"
            )
        new = object.__new__(cls)
        new._fill(_triples(generators, "generators").reshape(-1, 3), np.array(factors))
        return new

    def _fill(self, generators: NDArray[np.float64], scale: NDArray[np.float64]) -> None:
        """Set the two fields of a frozen instance."""
        vars(self).update(generators=generators, scale=scale)
        self._freeze()

    # -- measures ---------------------------------------------------------------------

    @property
    def scaled_generators(self) -> NDArray[np.float64]:
        """(n, 3) [N, N, N]: the generators in the metric's coordinates."""
        return self.generators * self.scale

    @property
    def rank(self) -> int:
        """Dimension of the set, 0 to 3, up to `ANGLE_TOLERANCE`.

        Only directions count: a robot of any strength adds its dimension.

        Examples
        --------
        >>> WrenchSet.from_generators([[1, 0, 0], [0, 1e12, 0], [-2, 0, 0]]).rank
        2
        """
        directions = unit_directions(self.scaled_generators)
        if not len(directions):
            return 0
        crosses = np.cross(directions[0], directions)
        widths = np.linalg.norm(crosses, axis=1)
        widest = int(widths.argmax())
        if widths[widest] <= ANGLE_TOLERANCE:
            return 1
        heights = np.abs(directions @ (crosses[widest] / widths[widest]))
        return 3 if heights.max() > plane_tolerance(widths[widest]) else 2

    @property
    def volume(self) -> float:
        """Volume [N^3 m] of the set: sum of ``|det(b_i, b_j, b_k)|`` over triples, 0 if flat.

        For each b_j the sum over the other two is ``|b_j|`` times the area of the zonogon
        that they make across b_j; every triple is met three times.

        Examples
        --------
        >>> WrenchSet.from_generators([[1, 0, 0], [0, 2, 0], [0, 0, 3], [1, 1, 0]]).volume
        15.0
        >>> WrenchSet.from_generators([[1, 0, 0], [0, 2, 0], [1, 1, 0]]).volume
        0.0
        """
        if self.rank < 3:
            return 0.0
        G = self.scaled_generators
        lengths = np.linalg.norm(G, axis=1)
        total = 0.0
        for g, length in zip(G[lengths > 0.0], lengths[lengths > 0.0], strict=True):
            flat = G @ across(g / length).T
            parallel = np.linalg.norm(flat, axis=1) <= ANGLE_TOLERANCE * lengths
            total += length * _zonogon_area(flat[~parallel])
        return float(total / 3.0 / self.scale.prod())

    def bounds(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Return the least and greatest force_x, force_y and torque the swarm can make.

        Returns
        -------
        lower, upper : (3,) [N, N, N m]

        Examples
        --------
        >>> lower, upper = WrenchSet.from_generators([[1, 2, 3], [-4, 1, 0]]).bounds()
        >>> lower.tolist(), upper.tolist()
        ([-4.0, 0.0, 0.0], [1.0, 3.0, 3.0])
        """
        G = self.generators
        return np.minimum(G, 0.0).sum(axis=0), np.maximum(G, 0.0).sum(axis=0)

    def support(self, normals: ArrayLike) -> NDArray[np.float64] | float:
        """Compute the support function h(n) = sum_i max(0, n . b_i), the furthest W reaches.

        Parameters
        ----------
        normals : (m, 3) or (3,) [1, 1, 1/m]
            Directions in physical coordinates, of any length; a scaled unit normal `v`
            is ``v * scale`` here.

        Returns
        -------
        (m,) or float [N]

        Raises
        ------
        WrenchInvalid
            If the normals are not finite triples.

        Examples
        --------
        >>> WrenchSet.from_generators([[1, 0, 2], [-1, 0, 1]]).support([0, 0, 1])
        3.0
        >>> WrenchSet.from_generators([]).support([[0, 0, 1], [1, 0, 0]]).tolist()
        [0.0, 0.0]
        """
        directions = _triples(normals, "normals")
        reach = np.maximum(directions @ self.generators.T, 0.0).sum(axis=-1)
        return float(reach) if directions.ndim == 1 else reach

    def contains(self, wrenches: ArrayLike, tolerance: float = 1e-9) -> NDArray[np.bool_] | bool:
        """Tell which wrenches the swarm can make.

        Parameters
        ----------
        wrenches : (m, 3) or (3,) [N, N, N m]
        tolerance : float
            A wrench counts as made when the least largest miss of a scaled component is
            at most this share of ``sum |b_i|``. Below 1e-10 rounding decides.

        Returns
        -------
        (m,) of bool or bool

        Raises
        ------
        WrenchInvalid
            If the wrenches are not finite triples.

        Examples
        --------
        >>> flat = WrenchSet.from_generators([[1, 0, 0], [0, 1, 0]])
        >>> flat.contains([[0.5, 1, 0], [0.5, 1, 0.001]]).tolist()
        [True, False]
        """
        if not 0.0 <= number(tolerance) <= 1.0:
            raise WrenchInvalid(
                f"the tolerance is {shown(tolerance)}; it should be 0 <= tolerance <= 1"
            )
        wanted = _triples(wrenches, "wrenches")
        G = self.scaled_generators
        slack = tolerance * float(np.linalg.norm(G, axis=1).sum())
        lower, upper = (bound * self.scale for bound in self.bounds())
        inside = [
            bool((w >= lower - slack).all() and (w <= upper + slack).all())
            and _least_miss(G, w) <= slack
            for w in wanted.reshape(-1, 3) * self.scale
        ]
        return inside[0] if wanted.ndim == 1 else np.array(inside, dtype=bool)

    # -- faces and corners ------------------------------------------------------------

    def mesh(self) -> Mesh:
        """List the faces and corners.

        Every face is the zonogon of all generators in one plane. Corners are told apart
        by which generators they use, never by rounded coordinates.

        Raises
        ------
        WrenchSetTooLarge
            If the generators have more than `MESH_LINES` distinct directions.

        Examples
        --------
        >>> cube = WrenchSet.from_generators([[1, 0, 0], [0, 1, 0], [0, 0, 1]]).mesh()
        >>> len(cube.vertices), len(cube.edges), len(cube.faces)
        (8, 12, 6)
        >>> WrenchSet.from_generators([[1, 0, 0], [-2, 0, 0]]).mesh().vertices.tolist()
        [[-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]]
        """
        return zonotope_mesh(self.generators, self.scale)


def _triples(vectors: ArrayLike, what: str) -> NDArray[np.float64]:
    """Return (m, 3) or (3,) finite numbers, or raise `WrenchInvalid`; [] is (0, 3)."""
    array = array_of(vectors)
    if array is None:
        raise WrenchInvalid(f"the {what} are {shown(vectors)}; they should be triples of numbers")
    if array.shape == (0,):
        return array.reshape(0, 3)
    if array.ndim not in (1, 2) or array.shape[-1] != 3:
        raise WrenchInvalid(f"the {what} have shape {array.shape}; it should be (m, 3) or (3,)")
    rows = array.reshape(-1, 3)
    bad = np.flatnonzero(~(np.abs(rows) <= STRONGEST).all(axis=1))
    if len(bad):
        raise WrenchInvalid(
            f"{what}[{i}] is {rows[i].tolist()}; it should be finite numbers of size <= "
            f"{STRONGEST:g}"
            for i in bad
        )
    return array


def _zonogon_area(flat: NDArray[np.float64]) -> float:
    """Return the sum over pairs of |p x q| for plane vectors (n, 2), in O(n log n)."""
    upward, order = fold(flat)
    x, y = np.where(upward[:, None], flat, -flat)[order].T
    # sums of those before, not sums minus the last: a giant would swallow the others
    return float(np.sum(np.cumsum(x)[:-1] * y[1:] - np.cumsum(y)[:-1] * x[1:]))


def _least_miss(G: NDArray[np.float64], wrench: NDArray[np.float64]) -> float:
    """Return min over 0 <= u <= 1 of the largest component of |G' u - w|, scaled [N].

    With unit columns and v_i = u_i |b_i| as unknowns, a giant among dwarfs does not make
    the solver drop the dwarfs' coefficients. The miss is computed anew from the answer.
    """
    directions = unit_directions(G)
    lengths = np.linalg.norm(G, axis=1)
    lengths = lengths[lengths > 0.0]
    unit_force = lengths.max(initial=0.0) or 1.0
    w = wrench / unit_force
    slack = np.ones((3, 1))
    solution = minimise(
        np.append(np.zeros(len(directions)), 1.0),
        np.block([[directions.T, -slack], [-directions.T, -slack]]),
        rows=(-np.inf, np.concatenate([w, -w])),
        columns=(0.0, np.append(lengths / unit_force, np.inf)),
    )
    forces = np.clip(solution[:-1], 0.0, lengths / unit_force)
    return float(np.abs(forces @ directions - w).max() * unit_force)
