"""The wrench set: every wrench a swarm can make, and its faces and corners."""

from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import LinearProgramFailed, MetricInvalid, WrenchInvalid
from swarmgrasp.frozen import Frozen
from swarmgrasp.linear import Program
from swarmgrasp.ranges import STRONGEST, WEAKEST, array_of, number, numbers, shown
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.swarm import check_swarm
from swarmgrasp.wrench_set.mesh import (
    ANGLE_TOLERANCE,
    Mesh,
    across,
    fold,
    plane_tolerance,
    unit_directions,
    zonotope_mesh,
)
from swarmgrasp.wrench_set.planar import NO_PLANES, Planar, planar_of
from swarmgrasp.wrench_set.rounded import Farthest, rounded_mesh

ROWS = 1 << 20
"""Products computed at a time."""


@dataclass(frozen=True, eq=False)
class WrenchSet(Frozen):
    """The wrenches a swarm can make: the sum of what each robot can exert (T20).

    Of robots that push along lines it is a zonotope, moved by what these exert at least. Robots
    that steer give it round faces.

    Parameters
    ----------
    swarm : Swarm

    Attributes
    ----------
    generators : (n, 3) [N, N, N m]
        Of the robots that push along a line, from the one end of what each can exert to the other:
        of a robot of one way its wrench b_i at its limit.
    start : (3,) [N, N, N m]
        What these exert together at the first ends.
    scale : (3,) [1, 1, 1/m]
        Makes the metric Euclidean: scaled wrenches are ``generators * scale``.
    planar : Planar
        What each of the others can exert.

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

    A thruster that turns any way, and one that goes astern with half its force:

    >>> around = Robot((0.5, 0), 0.0, steers=3.141592653589793, mounted=True)
    >>> wrenches = WrenchSet(Swarm(square, [around, Robot((0, 1), 0.0, reverse_limit=0.5)]))
    >>> [bound.tolist() for bound in wrenches.bounds()]
    [[-1.5, -1.0, -1.5], [2.0, 1.0, 1.0]]

    No robots make no wrench:

    >>> nobody = WrenchSet(Swarm(square, []))
    >>> nobody.rank, nobody.contains([0.0, 0.0, 0.0]), nobody.contains([0.0, 0.0, 0.1])
    (0, True, False)
    """

    generators: NDArray[np.float64]
    start: NDArray[np.float64]
    scale: NDArray[np.float64]
    planar: Planar

    def __init__(self, swarm: Swarm) -> None:
        check_swarm(swarm)
        if swarm.has_rays_only:
            self._fill(swarm.generators, np.zeros(3), swarm.scale, NO_PLANES)
            return
        planar, lines, starts = planar_of(swarm)
        self._fill(lines, starts.sum(axis=0), swarm.scale, planar)

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
        lines = _triples(generators, "generators").reshape(-1, 3)
        new._fill(lines, np.zeros(3), np.array(factors), NO_PLANES)
        return new

    def _fill(
        self,
        generators: NDArray[np.float64],
        start: NDArray[np.float64],
        scale: NDArray[np.float64],
        planar: Planar,
    ) -> None:
        """Set the fields of a frozen instance."""
        vars(self).update(generators=generators, start=start, scale=scale, planar=planar)
        self._freeze()

    # -- measures ---------------------------------------------------------------------

    @cached_property
    def _directions(self) -> NDArray[np.float64]:
        """(k, 3): unit vectors, scaled, that span all differences of the set's wrenches."""
        planes = self.planar.planes.reshape(-1, 3)
        return unit_directions(np.concatenate([self.generators, planes]) * self.scale)

    @property
    def rank(self) -> int:
        """Dimension of the set, 0 to 3, up to `ANGLE_TOLERANCE`.

        Only directions count: a robot of any strength adds its dimension.

        Examples
        --------
        >>> WrenchSet.from_generators([[1, 0, 0], [0, 1e12, 0], [-2, 0, 0]]).rank
        2
        """
        directions = self._directions
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
        """Volume [N^3 m] of the set, 0 if flat.

        Of a zonotope the sum of ``|det(b_i, b_j, b_k)|`` over triples: for each b_j the sum over
        the other two is ``|b_j|`` times the area of the zonogon that they make across b_j; every
        triple is met three times. With other robots that of ``mesh(1e-3)``: round faces lie a
        little beyond it.

        Examples
        --------
        >>> WrenchSet.from_generators([[1, 0, 0], [0, 2, 0], [0, 0, 3], [1, 1, 0]]).volume
        15.0
        >>> WrenchSet.from_generators([[1, 0, 0], [0, 2, 0], [1, 1, 0]]).volume
        0.0
        """
        if self.rank < 3:
            return 0.0
        if len(self.planar):
            return self.mesh(1e-3).volume
        G = self.generators * self.scale
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
        ways = np.eye(3)
        ends = [np.diagonal(self._farthest(sign * ways)).copy() for sign in (-1.0, 1.0)]
        return ends[0], ends[1]

    def support(self, normals: ArrayLike) -> NDArray[np.float64] | float:
        """Compute the support function h(n) = max n . w over the set, the furthest it reaches.

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
        rows = directions.reshape(-1, 3)
        reach = (rows * self._farthest(rows)).sum(axis=1)
        return float(reach[0]) if directions.ndim == 1 else reach

    def farthest(self, normals: ArrayLike) -> NDArray[np.float64]:
        """Return the wrenches of the set that are farthest along some directions.

        Enough of them tell what the set looks like, round or not, of any number of robots.

        Parameters
        ----------
        normals : (m, 3) or (3,) [1, 1, 1/m]
            As for `support`.

        Returns
        -------
        (m, 3) or (3,) [N, N, N m]

        Raises
        ------
        WrenchInvalid
            If the normals are not finite triples.

        Examples
        --------
        >>> wedge = WrenchSet.from_generators([[1, 0, 2], [-1, 0, 1]])
        >>> wedge.farthest([[0, 0, 1], [1, 0, 0]]).tolist()
        [[0.0, 0.0, 3.0], [1.0, 0.0, 2.0]]
        """
        directions = _triples(normals, "normals")
        return self._farthest(directions.reshape(-1, 3)).reshape(directions.shape)

    def _farthest(self, normals: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the wrenches (m, 3) of the set farthest along normals (m, 3), both physical."""
        step = max(1, ROWS // max(1, len(self.generators), 10 * len(self.planar)))
        parts = [
            self.start
            + (part @ self.generators.T > 0.0) @ self.generators
            + self.planar.farthest(part)
            for part in (normals[i : i + step] for i in range(0, len(normals), step))
        ]
        return np.concatenate([np.zeros((0, 3)), *parts])

    def _farthest_scaled(self, normals: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the same in the metric's coordinates."""
        return self._farthest(normals * self.scale) * self.scale

    def contains(self, wrenches: ArrayLike, tolerance: float = 1e-9) -> NDArray[np.bool_] | bool:
        """Tell which wrenches the swarm can make.

        Parameters
        ----------
        wrenches : (m, 3) or (3,) [N, N, N m]
        tolerance : float
            A wrench counts as made when the least largest miss of a scaled component is at most
            this share of the sum of the largest wrenches of all. Below 1e-10 rounding decides.

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
        slack = tolerance * self._weight
        rows = wanted.reshape(-1, 3) * self.scale
        found = np.array([_holds(self._farthest_scaled, row, slack) for row in rows], dtype=bool)
        return bool(found[0]) if wanted.ndim == 1 else found

    @property
    def _weight(self) -> float:
        """Sum of the largest wrenches of all robots, scaled [N]."""
        planes = np.linalg.norm(self.planar.planes * self.scale, axis=2).max(axis=1, initial=0.0)
        lines = np.linalg.norm(self.generators * self.scale, axis=1)
        return float(
            lines.sum() + np.linalg.norm(self.start * self.scale) + self.planar.sizes @ planes
        )

    # -- faces and corners ------------------------------------------------------------

    def mesh(self, tolerance: float = 2e-3) -> Mesh:
        """List the faces and corners.

        Of robots that push along lines every face is the zonogon of all generators in one plane,
        and corners are told apart by which generators they use, never by rounded coordinates.

        Parameters
        ----------
        tolerance : float
            How far round faces may reach beyond the mesh at most, relative to the set's size;
            1e-6 <= tolerance <= 0.1. Sets without round faces are exact.

        Raises
        ------
        WrenchSetTooLarge
            If the generators have more than `MESH_LINES` distinct directions, or the mesh more than
            `MOST_VERTICES` vertices.
        WrenchInvalid
            If the tolerance is outside its range.

        Examples
        --------
        >>> cube = WrenchSet.from_generators([[1, 0, 0], [0, 1, 0], [0, 0, 1]]).mesh()
        >>> len(cube.vertices), len(cube.edges), len(cube.faces)
        (8, 12, 6)
        >>> WrenchSet.from_generators([[1, 0, 0], [-2, 0, 0]]).mesh().vertices.tolist()
        [[-2.0, 0.0, 0.0], [1.0, 0.0, 0.0]]
        """
        if not 1e-6 <= number(tolerance) <= 0.1:
            raise WrenchInvalid(
                f"the tolerance is {shown(tolerance)}; it should be 1e-6 <= tolerance <= 0.1"
            )
        if not len(self.planar):
            return zonotope_mesh(self.generators, self.scale, self.start)
        spans = np.linalg.svd(self._directions)[2]
        mesh = rounded_mesh(
            self._farthest_scaled,
            spans[: self.rank],
            tolerance if self.planar.is_round else 0.0,
        )
        return replace(mesh, vertices=mesh.vertices / self.scale)


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


def _holds(farthest: Farthest, point: NDArray[np.float64], slack: float) -> bool:
    """Tell whether no component of a point (3,) misses a set by more than a slack.

    The miss is the most that n . point exceeds h(n) by, over normals n whose components' sizes sum
    to 1 at most. With the points found so far instead of h that is a linear program, whose best
    normal finds the next point.
    """
    found = farthest(np.concatenate([np.eye(3), -np.eye(3)]))
    size = float(max(np.abs(found).max(), np.abs(point).max())) or 1.0
    program = Program(
        np.concatenate([-point, point, [size]]) / size,
        np.array([[1.0] * 6 + [0.0]]),
        rows=(-np.inf, 1.0),
        columns=([0.0] * 6 + [-np.inf], [1.0] * 6 + [np.inf]),
    )
    new = found
    while True:
        corners = new / size
        program.add_rows(np.hstack([-corners, corners, np.ones((len(new), 1))]), (0.0, np.inf))
        solution = program.solve()
        if solution is None:
            raise LinearProgramFailed(
                "HiGHS found no plane between a wrench and the wrench set; scale the input, whose "
                "numbers may be too far apart"
            )
        normal = solution.values[:3] - solution.values[3:6]
        new = farthest(normal[None])
        if normal @ (point - new[0]) > slack:
            return False
        if normal @ point - size * solution.values[6] <= slack or (new == found).all(axis=1).any():
            return True
        found = np.concatenate([found, new])
