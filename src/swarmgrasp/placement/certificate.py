"""The proof that no allowed robot does better (T10)."""

from dataclasses import dataclass
from typing import Literal

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Plain


@dataclass(frozen=True, eq=False)
class Proof(Frozen, Plain):
    """A convex combination of directions that bounds some pieces.

    For unit normals n_k and weights l_k that sum to 1, no robot on a piece K makes the
    quality exceed ``max(sigma_K(sum l_k n_k) + sum l_k h(n_k), max_k h(n_k))``.

    By a criterion, H stands for h, both are divided by the task's D, and nothing exceeds the
    least C(n_k) / D(n_k), where C is H before the last loss (T14, T15, T16):
    ``min(max((sigma_K(sum l_k n_k) + sum l_k H(n_k)) / sum l_k D(n_k), max_k H(n_k) / D(n_k)),
    min_k C(n_k) / D(n_k))``.

    Attributes
    ----------
    normals : (m, 3)
        Directions in the metric's coordinates, at most 4.
    weights : (m,)
        Positive; of any sum.
    """

    normals: NDArray[np.float64]
    weights: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class BoxProof(Frozen, Plain):
    """A convex combination of directions that bounds a box of contacts and directions (T23).

    The wrenches b of unit forces in the box lie in the hull of six: at both contacts, in both
    directions, and in the middle one so much longer that the arc between lies inside. With phi
    what a newcomer adds along a direction, phi(x) = max(limit x, -reverse_limit x), and D what is
    asked there, each vector says of a quality t at b

    - "met", a unit normal n: t D(n) <= H(n) + phi(n . b);
    - "demanded", if n has H(n) <= t D(n) and the newcomer is one-way: t D(n) <= H(n) + limit n . b;
    - "flat", twice, of unit normals m and k across it, without a task: H is nothing along m, -m and
      k, and so along a normal between them across whatever b: t is 0;
    - "travelling", g: t D(n) <= H(n) for the normal n = b x g across b, where H is no more than
      what robots exert without those lost. There is none for named failures and uncertain poses.

    Attributes
    ----------
    start, end : tuple of float [m, m]
        Contacts between which those of the box lie.
    lo, hi : float [rad]
        Directions, at most a right angle apart.
    kinds : tuple of str
    vectors : (m, 3)
        In the metric's coordinates, at most 6.
    weights : (m,)
        Positive; of any sum.
    lost : tuple of tuple of str
        Of each vector, the robots lost; none but for a travelling or flat one.
    """

    start: tuple[float, float]
    end: tuple[float, float]
    lo: float
    hi: float
    kinds: tuple[Literal["met", "demanded", "travelling", "flat"], ...]
    vectors: NDArray[np.float64]
    weights: NDArray[np.float64]
    lost: tuple[tuple[str, ...], ...]


@dataclass(frozen=True, eq=False)
class SpanProof(Frozen, Plain):
    """Directions that bound a span of contacts, for a newcomer that keeps its force set (T22).

    At a contact c no quality t exceeds v_n(c) = (H(n) + sigma(p_n(c))) / D(n), a convex function of
    c on a straight span. So, for unit normals n_k,

    - "chords": t is at most the greater of sum l_k v_k(start) and sum l_k v_k(end), with weights
      l_k that sum to 1;
    - "travelling", of two normals a and b with torque parts of one sign, without losses and
      uncertain poses: t is at most the greater of v_a(start) D(a) / d . a and
      v_b(end) D(b) / d . b, d the wrench of the task that is farthest along a + b. Of the unit
      ball both quotients are 1 over the cosine of half the angle between them.

    Nor does it exceed the least C(n_k) / D(n_k) that any of them shows, C as for `Proof`.

    Attributes
    ----------
    start, end : tuple of float [m, m]
        Contacts between which those of the span lie.
    lo, hi : float [rad]
        The sector that the newcomer keeps there; in the worst case sigma is of what it keeps of it
        in any direction that may be drawn, or of the middle of these.
    kind : str
    normals : (m, 3)
        In the metric's coordinates, one or two.
    weights : (m,)
        Positive; of any sum.
    """

    start: tuple[float, float]
    end: tuple[float, float]
    lo: float
    hi: float
    kind: Literal["chords", "travelling"]
    normals: NDArray[np.float64]
    weights: NDArray[np.float64]


@dataclass(frozen=True, eq=False)
class PatchProof(Frozen, Plain):
    """Directions that bound a patch of contacts inside, for a newcomer that keeps its force set.

    As for `SpanProof`, with v_n(c) at the corners c_j of a triangle, or of a line or a spot:

    - "chords": t is at most the greatest of sum l_k v_k(c_j), with weights l_k that sum to 1;
    - "travelling", of one normal n_j for each corner, with torque parts of one sign, without losses
      and uncertain poses: t is at most the greatest of v_j(c_j) D(n_j) / d . n_j, d the wrench of
      the task that is farthest along the sum of the normals.

    Attributes
    ----------
    corners : tuple of tuple of float [m, m]
        One to three contacts, whose hull the patch is.
    lo, hi : float [rad]
        The sector that the newcomer keeps there.
    kind : str
    normals : (m, 3)
        In the metric's coordinates, one to three.
    weights : (m,)
        Positive; of any sum.
    """

    corners: tuple[tuple[float, float], ...]
    lo: float
    hi: float
    kind: Literal["chords", "travelling"]
    normals: NDArray[np.float64]
    weights: NDArray[np.float64]


@dataclass(frozen=True)
class Certificate:
    """Proofs that together bound every piece.

    Attributes
    ----------
    proofs : tuple of Proof
        Each piece is bounded by at least one of them,
    boxes : tuple of BoxProof
        or else these cover it,
    spans : tuple of SpanProof
        or these, for a newcomer that keeps its force set,
    patches : tuple of PatchProof
        or these, for such a one inside.
    upper_bound : float [N]
        The greatest of the pieces' bounds; without a unit for a task.
    """

    proofs: tuple[Proof, ...]
    boxes: tuple[BoxProof, ...]
    spans: tuple[SpanProof, ...]
    patches: tuple[PatchProof, ...]
    upper_bound: float
