"""What the compiled kernels offer; the headers beside this file say how they work.

Arrays are C-contiguous float64 of the sizes given and finite; anything else raises `ValueError`.
What takes long lets other threads run, looks at the keyboard in between, and raises
`KeyboardInterrupt`. A search that is called while it runs, as by a signal's handler, raises
`RuntimeError`.
"""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Normal = tuple[float, float, float]
Best = tuple[float, float, float, float, int]
"""Quality [N] and (cos, sin, torque) [1, 1, m] of a robot, and its piece; -1 if there is none."""
Place = tuple[float, int, float, float]
"""Quality [N] of a robot, its piece, the share of the way along it, and its direction [rad]."""

MARGINAL: float
"""Quality relative to sum |b_i| at and below which it counts as zero."""
FLOOR: float
"""Gap between bound and best, relative to `Search.size`, that is not worth closing."""
UNASKED: float
"""Share of a task's size at and below which it asks for nothing: what rounding hides."""
ASKS: int
"""Exact qualities that `Boxes.solve` and `Spans.solve` may take unless told otherwise."""
BOX: int
"""Numbers of a box in what `Boxes.solve` returns,"""
TERM: int
"""and of each of its terms."""
SPAN: int
"""Numbers of a span in what `Spans.solve` returns."""
WORK: float
"""Units of work that a search may do unless told otherwise: a second or two. See `work.h`."""

def weakest(
    generators: Array, load: Normal = ..., work: float = ..., /
) -> tuple[float, Normal, float]:
    """Return the exact quality of generators (n, 3) [N], and the unit normal that attains it.

    A load (3,) [N] is a wrench that is always there. The last number is what the quality is at
    least: less than it if the work was cut short.
    """

def qualities(generators: Array, n: int, /) -> bytes:
    """Return the exact qualities (m,) [N] of m swarms of n generators each, (m, n, 3) [N]."""

class Criterion:
    """What a swarm is asked to withstand; see `criterion.h`.

    Parameters
    ----------
    points : (n, 3) [N]
        Generators of the robots whose wrench is known, in the metric's coordinates.
    scale : (3,) [1, 1, 1/m]
        Turns wrenches into the metric's coordinates.
    rows : (r, 12)
        Of the other robots, sorted by robot, 0 1 2 ...: the robot, its limit [N], and a piece.
    losing : int
    load : (3,) [N]
        In the metric's coordinates.
    task : (m, 3)
        Vertices of a polytope, or axes of an ellipsoid; none for the unit ball.
    is_polytope : bool
    """

    def __new__(
        cls,
        points: Array,
        scale: Normal,
        rows: Array,
        losing: int,
        load: Normal,
        task: Array,
        is_polytope: bool,
        /,
    ) -> Criterion: ...
    def least(
        self, gap: float, below: float, work: float = ..., /
    ) -> tuple[float, Normal, bool, float]:
        """Return the least H / D, a unit normal that attains it, if that is certain, and work left.

        If it is, no direction has less than 1 - gap times that, but for rounding. What is 0 but for
        rounding is 0, and so is what is left of a load that is not held. A value of `below` or
        more is not wanted: it is then `below`, and the normal is zero.
        """

    def heights(self, normals: Array, /) -> bytes:
        """Return H, the H before the last loss, and D, (m, 3), at normals (m, 3) [N]."""

class Sets:
    """Robots as sets of forces, and what they are asked to withstand; see `sets.h`.

    Parameters
    ----------
    arms : (n, 2) [m]
        Moment arms of the contacts.
    elements : (k, 5)
        Of each robot's set, robot by robot: see `force_set.h`.
    counts : (n,)
        Elements that each robot has. One that has none and no poses exerts nothing.
    machines : (n,)
        The machine that each robot is part of, 0 1 2 ...
    scale : (3,) [1, 1, 1/m]
        Turns wrenches into the metric's coordinates.
    losing : int
        Machines.
    load : (3,) [N]
        In the metric's coordinates.
    task : (m, 3)
        Vertices of a polytope, or axes of an ellipsoid; none for the unit ball.
    is_polytope : bool
    parts : (p, 5)
        Of robots whose contact is uncertain, sorted by robot: the robot, and the moment arms [m]
        of the ends of a straight part.
    poses : (q, 12)
        Of rays whose direction is uncertain, sorted by robot: the robot, its limit [N], and a
        piece.
    failures : (f, n)
        1 for the robots that each of some failures takes, 0 for the others; the worst happens.
    """

    weight: float
    """The sum of the largest |wrench| of each robot, and the load's size [N]."""

    def __new__(
        cls,
        arms: Array,
        elements: Array,
        counts: Array,
        machines: Array,
        scale: Normal,
        losing: int,
        load: Normal,
        task: Array,
        is_polytope: bool,
        parts: Array,
        poses: Array,
        failures: Array,
        /,
    ) -> Sets: ...
    def least(
        self, gap: float, below: float, work: float = ..., enough: float = ..., /
    ) -> tuple[float, Normal, float, float]:
        """Return the least H / D, a unit normal that attains it, and what no normal falls below.

        The last number is the work left. What is 0 but for rounding is 0, and so is what is left of
        a load that is not held. A value of `below` or more is not wanted: it is then `below`, and
        the normal is zero. Less than `enough` will do, if it is not the least: the bound is 0 then.
        """

    def heights(self, normals: Array, /) -> bytes:
        """Return H, the H before the last loss, and D, (m, 3), at normals (m, 3) [N]."""

    def wrenches(self, normals: Array, /) -> bytes:
        """Return the wrench of all robots and the load that is farthest along normals (m, 3).

        Before any loss: (m, 3) [N].
        """

    def forces(self, normal: Normal, /) -> bytes:
        """Return (n, 5) what each robot's best force along a normal is worth [N], and which it is.

        In its worst pose: the force (2,) [N], and the moment arm of the contact (2,) [m].
        """

class Boxes:
    """A swarm and what a newcomer of one fixed direction can do, by boxes; see `boxes.h`.

    Parameters
    ----------
    sets : Sets
        The base swarm, and what is asked of it.
    pieces : (k, 10)
        See `sector.h`.
    limit, reverse : float [N]
        Of the newcomer.
    work : float, optional
        Units of work for all that is asked.
    """

    base: tuple[float, Normal]
    """The base swarm's quality [N], and its weakest unit normal."""
    size: float
    """The largest wrenches of all [N]: what rounding is relative to."""
    left: float
    """Units of work; below 0 when it was not enough."""

    def __new__(
        cls, sets: Sets, pieces: Array, limit: float, reverse: float, work: float = ..., /
    ) -> Boxes: ...
    def solve(
        self, gap: float, chosen: bytes | None, asks: int = ..., /
    ) -> tuple[bool, Place, bytes]:
        """Find the best robot over all pieces, or over those whose byte in `chosen` is not 0.

        Stops at a relative gap, after so many exact qualities, or when the work is spent.

        Returns whether the gap is closed, the best robot, and boxes (m, BOX) that together cover
        the pieces: piece, shares of the first and the last contact, directions [rad], what none
        exceeds [N], and six terms of kind, vector (3,), weight, 0 where there is none, and the
        machines that a travelling one goes without, or -1.
        """

    def qualities_at(self, robots: Array, /) -> bytes:
        """Return the quality [N] and its unit normal, (m, 4), with each of many robots (m, 3).

        These are moment arms [m] and directions [rad]. What takes more work than is left is 0.
        """

    def normals(self) -> bytes:
        """Return the unit normals met so far, (m, 3)."""

class Spans:
    """A swarm and where a newcomer that keeps its force set can go, by spans; see `spans.h`.

    Parameters
    ----------
    sets : Sets
        The base swarm, and what is asked of it.
    ends : (k, 4) [m]
        Moment arms of the pieces' ends.
    elements : (e, 5)
        Of the newcomer's set on each piece, piece by piece: see `force_set.h`.
    counts : (k,)
        Elements of each.
    work : float, optional
        Units of work for all that is asked.
    """

    base: tuple[float, Normal]
    """The base swarm's quality [N], and its weakest unit normal."""
    size: float
    """The largest wrenches of all [N]: what rounding is relative to."""
    left: float
    """Units of work; below 0 when it was not enough."""

    def __new__(
        cls, sets: Sets, ends: Array, elements: Array, counts: Array, work: float = ..., /
    ) -> Spans: ...
    def solve(
        self, gap: float, chosen: bytes | None, asks: int = ..., /
    ) -> tuple[bool, tuple[float, int, float], bytes]:
        """Find the best robot over all pieces, or over those whose byte in `chosen` is not 0.

        Stops at a relative gap, after so many exact qualities, or when the work is spent.

        Returns whether the gap is closed; the best quality [N], its piece, -1 if none betters the
        base swarm, and the share of the way along it; and spans (m, 13) that together cover the
        pieces: piece, shares of the first and the last contact, what none exceeds [N], the kind
        of bound, and two terms of normal (3,) and weight, 0 where there is none.
        """

    def quality_at(self, piece: int, share: float, enough: float = ..., /) -> tuple[float, Normal]:
        """Return the quality with the newcomer there, and the unit normal that attains it.

        Below `enough` any upper bound will do.
        """

    def gains(self, stands: Array, normals: Array, /) -> bytes:
        """Return what newcomers add along normals (m, 3): (c, m) [N].

        They stand at (c, 2): pieces, and shares of the way along them.
        """

class Search:
    """A swarm and what a newcomer can do: where it should attach (T9).

    Parameters
    ----------
    generators : (n, 3) [N]
        Of the base swarm, in the metric's coordinates.
    weights : (3,) [N, N, N/m]
        Turn a unit wrench [1, 1, m] of the newcomer into the metric's coordinates.
    pieces : (k, 10)
        See `sector.h`.
    load : (3,) [N], optional
        A wrench that is always there.
    criterion : Criterion, optional
        Asked instead of the nominal quality: it has the robots and the load itself, and no robot
        can join.
    work : float, optional
        Units of work for all that is asked, and as many again after each robot that joins. With
        a criterion the base swarm's quality takes of it too, and is 0 if it takes all.
    """

    quality: float
    """Of the base swarm [N]."""
    weakest: Normal
    """Its weakest unit normal."""
    size: float
    """The sum of |b_i| and the newcomer's largest wrench [N]: what rounding is relative to."""
    left: float
    """Units of work; below 0 when it was not enough."""

    def __new__(
        cls,
        generators: Array,
        weights: Normal,
        pieces: Array,
        load: Normal = ...,
        criterion: Criterion | None = None,
        work: float = ...,
        /,
    ) -> Search: ...
    def solve(
        self, gap: float, chosen: bytes | None, /
    ) -> tuple[bool, Best, float, bytes, bytes, bytes]:
        """Find the best robot over all pieces, or over those whose byte in `chosen` is not 0.

        Stops at a relative gap, or when the work is spent.

        Returns whether the gap is closed, the best robot, what no robot exceeds [N], and for
        each piece its bound (k,) [N] and the proof of that: rows (k, 4) of `normals`, as C
        int, and weights (k, 4).
        """

    def break_tie(self, best: Best, target: float, /) -> Best:
        """Of the robots with at least the target quality, take the one that lifts the rest most.

        After `solve`; returns the same robot if no other can be as good.
        """

    def join(self, c: float, s: float, torque: float, pieces: Array, /) -> None:
        """Let a robot join the base swarm, and go on with these pieces; what is known is kept."""

    def quality_with(self, c: float, s: float, torque: float, /) -> tuple[float, Normal]:
        """Return the exact quality with one robot more, and the unit normal that attains it."""

    def qualities_with(self, robots: Array, /) -> bytes:
        """Return the exact quality with each of many robots (m, 3), one at a time, (m,) [N]."""

    def height(self, x: float, y: float, z: float, /) -> float:
        """Return the base swarm's support function at a unit normal [N]."""

    def normals(self) -> bytes:
        """Return the unit normals met so far, (m, 3)."""
