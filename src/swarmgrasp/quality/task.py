"""Tasks: sets of wrenches that a swarm should be able to make (T16)."""

import math
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import WrenchInvalid
from swarmgrasp.frozen import Frozen, read_only
from swarmgrasp.plain import Plain
from swarmgrasp.products import weighted
from swarmgrasp.ranges import STRONGEST, WEAKEST, array_of, shown


@dataclass(frozen=True, eq=False)
class Polytope(Frozen, Plain):
    """The convex hull of some wrenches and of no wrench at all.

    One wrench asks how far the swarm can go in that direction; several, what it can do in all
    of them.

    Parameters
    ----------
    vertices : (m, 3) [N, N, N m]
        Wrenches about the outline's origin.

    Raises
    ------
    WrenchInvalid
        If they are no such array of finite numbers, or all zero.

    Examples
    --------
    100 kN ahead, and half of it astern:

    >>> Polytope([(100e3, 0, 0), (-50e3, 0, 0)]).support([[1, 0, 0], [-1, 0, 0]]).tolist()
    [100000.0, 50000.0]
    """

    vertices: NDArray[np.float64] = field()

    def __init__(self, vertices: ArrayLike) -> None:
        object.__setattr__(self, "vertices", _rows(vertices, "vertices"))

    def support(self, normals: ArrayLike) -> NDArray[np.float64]:
        """Return the support function at normals (..., 3)."""
        along = _along(normals, self.vertices).max(axis=-1)
        return np.asarray(np.maximum(along, 0.0))

    def farthest(self, normal: ArrayLike) -> NDArray[np.float64]:
        """Return the wrench (3,) of the set that lies farthest along a normal."""
        best = int(np.argmax(_along(normal, self.vertices)))
        return np.array(self.vertices[best])

    @property
    def generators(self) -> NDArray[np.float64]:
        """The vertices."""
        return self.vertices


@dataclass(frozen=True, eq=False)
class Ellipsoid(Frozen, Plain):
    """An ellipsoid of wrenches around no wrench: all sum x_k a_k with sum x_k^2 <= 1.

    Parameters
    ----------
    axes : (m, 3) [N, N, N m]
        The wrenches a_k; for three at right angles its half axes.

    Raises
    ------
    WrenchInvalid
        If they are no such array of finite numbers, or all zero.

    Examples
    --------
    >>> Ellipsoid([(3, 0, 0), (0, 2, 0), (0, 0, 1)]).support([[1, 0, 0], [0, 0, -1]]).tolist()
    [3.0, 1.0]
    """

    axes: NDArray[np.float64] = field()

    def __init__(self, axes: ArrayLike) -> None:
        object.__setattr__(self, "axes", _rows(axes, "axes"))

    def support(self, normals: ArrayLike) -> NDArray[np.float64]:
        """Return the support function at normals (..., 3)."""
        along = _along(normals, self.axes)
        return np.asarray(np.sqrt((along * along).sum(axis=-1)))

    def farthest(self, normal: ArrayLike) -> NDArray[np.float64]:
        """Return the wrench (3,) of the set that lies farthest along a normal."""
        along = _along(normal, self.axes)
        size = math.sqrt(float((along * along).sum()))
        return weighted(along / size, self.axes) if size > 0.0 else np.zeros(3)

    @property
    def generators(self) -> NDArray[np.float64]:
        """The axes."""
        return self.axes


Task = Polytope | Ellipsoid


def _along(normals: ArrayLike, wrenches: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return how far wrenches (m, 3) lie along normals (..., 3): (..., m)."""
    rows = np.asarray(normals, dtype=float)
    return np.asarray((rows[..., None, :] * wrenches).sum(axis=-1))


def _rows(given: ArrayLike, name: str) -> NDArray[np.float64]:
    """Return wrenches (m, 3) as an array of their own, read-only."""
    rows = array_of(given)
    if rows is None:
        raise WrenchInvalid(
            f"the {name} are {shown(given)}; they should be wrenches (m, 3) [N, N, N m]"
        )
    if rows.ndim != 2 or rows.shape[1] != 3 or not len(rows):
        raise WrenchInvalid(f"the {name} have shape {rows.shape}; it should be (m, 3), m >= 1")
    largest = np.abs(rows).max() if np.isfinite(rows).all() else np.inf
    if not WEAKEST <= largest <= STRONGEST:
        raise WrenchInvalid(
            f"the {name} should be finite numbers, the largest of them {WEAKEST:g} <= size <= "
            f"{STRONGEST:g}; they are {shown(rows)}"
        )
    return read_only(np.ascontiguousarray(rows))
