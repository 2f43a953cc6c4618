"""The globally best place for one newcomer, or for several one after the other (T8, T9)."""

import math
from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.outline import Stretch
from swarmgrasp.placement.answer import Placement, RunnerUp
from swarmgrasp.placement.certificate import certificate_of
from swarmgrasp.placement.pieces import piece_rows, pieces_of, point_on
from swarmgrasp.placement.problem import Problem
from swarmgrasp.quality import quality, wrench_words
from swarmgrasp.quality.max_transfer import MARGINAL
from swarmgrasp.robot import Newcomer, Robot, Zone
from swarmgrasp.swarm import Swarm

POOL_ROOM = 2000
"""Normals that a search may add to the known facets; some 10 are usual."""
SHARPNESS = 8.0
"""Of the soft minimum that breaks ties, relative to the mean of h over directions."""
DIRECTIONS = 200
"""Number of directions it is taken over."""
FLAT = 1e-6
"""Torque part of a proof's mean normal below which the contact does not matter to it."""


def place(
    swarm: Swarm,
    newcomer: Newcomer,
    zones: Iterable[Zone] | None = None,
    *,
    no_go: Iterable[Stretch] = (),
    spacing: float = 0.0,
    gap: float = 1e-6,
    runners_up: float | None = None,
) -> Placement:
    """Find where the newcomer should attach and which way it should push.

    The global optimum over everything a robot can really do, with a proof (T8-T10).

    Parameters
    ----------
    swarm : Swarm
    newcomer : Newcomer
    zones : iterable of Zone, optional
        Where it may attach; the whole boundary when left out.
    no_go : iterable of Stretch
        Where it may not.
    spacing : float [m]
        Least distance to the robots already there.
    gap : float
        Largest difference between bound and answer, relative to the answer.
    runners_up : float, optional
        Also report the best place on each other edge or zone whose quality is at least
        this fraction of the best, within [0, 1].

    Returns
    -------
    Placement

    Raises
    ------
    ZoneInvalid, NowhereToAttach
        If a zone leaves the boundary, or no allowed point is left.
    SwarmGraspError
        If `gap` or `runners_up` is outside its range.

    Examples
    --------
    >>> from math import pi
    >>> from swarmgrasp import Outline
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> pulls = [((1, -0.4), 0), ((-1, 0.4), pi), ((-0.4, 1), pi / 2)]
    >>> three = Swarm(square, [Robot(c, a) for c, a in pulls], characteristic_length=1.0)
    >>> answer = place(three, Newcomer(limit=1.0, attachment="pull", half_angle=0.0))
    >>> answer.robot.contact, round(answer.quality, 6), bool(answer.verify())
    ((1.0, -1.0), 0.8, True)
    """
    problem = Problem(
        swarm, newcomer, None if zones is None else tuple(zones), tuple(no_go), spacing
    )
    _check_fractions(gap, runners_up)
    return _Search(problem, gap).placement(runners_up)


def place_sequence(
    problem: Problem, count: int, *, gap: float = 1e-6, runners_up: float | None = None
) -> tuple[Placement, ...]:
    """Place several newcomers of one kind, one after the other.

    Each is optimal given those before it; together they need not be (T17).

    Parameters
    ----------
    problem : Problem
        The first newcomer's question.
    count : int
        How many to place, at least 1.
    gap, runners_up
        As for `place`.

    Returns
    -------
    tuple of Placement
        Each with the swarm it found as its problem's swarm.
    """
    if count < 1:
        raise SwarmGraspError(f"the number of robots is {count}; it should be at least 1")
    _check_fractions(gap, runners_up)
    answers: list[Placement] = []
    for index in range(1, count + 1):
        answer = _Search(problem, gap).placement(runners_up, index if count > 1 else None)
        answers.append(answer)
        problem = problem.with_swarm(answer.swarm_after)
    return tuple(answers)


@dataclass(frozen=True)
class _Found:
    """What one run of the kernel gives: see `kernels.place.solve`."""

    best: NDArray[np.float64]
    bounds: NDArray[np.float64]
    rows: NDArray[np.float64]
    shares: NDArray[np.float64]
    pool: NDArray[np.float64]

    def covector(self, piece: int) -> NDArray[np.float64]:
        """Return the combined covector (3,) of a piece's proof."""
        used = self.shares[piece] > 0.0
        rows = self.rows[piece, used].astype(int)
        return np.asarray(self.shares[piece, used] @ self.pool[rows, :3])


class _Search:
    """One problem in the kernels' terms."""

    def __init__(self, problem: Problem, gap: float) -> None:
        from swarmgrasp.kernels.facets import list_facets

        self.problem = problem
        self.gap = 0.5 * gap  # the other half is the tie-break's
        swarm = problem.swarm
        self.before = quality(swarm)
        self.pieces = pieces_of(problem)
        self.rows = piece_rows(swarm.outline, self.pieces)
        self.weights = swarm.scale * problem.newcomer.limit
        self.generators = swarm.scaled_generators
        self.normals, self.heights, _, self.start = list_facets(self.generators, np.inf)
        size = np.linalg.norm(self.generators, axis=1).sum()
        reach = np.linalg.norm(self.weights[:2]) + self.weights[2] * swarm.outline.radius
        self.floor = MARGINAL * float(size + reach)

    def solve(self, rows: NDArray[np.float64]) -> _Found:
        """Run the kernel over some rows of pieces."""
        from swarmgrasp.kernels.place import solve

        _, *found = solve(
            self.generators, self.normals, self.heights, self.start, self.weights, rows,
            self.gap, self.floor, POOL_ROOM,
        )  # fmt: skip
        return _Found(*found)

    def placement(self, fraction: float | None, index: int | None = None) -> Placement:
        """Answer the problem."""
        found = self.solve(self.rows)
        best = self.without_tie(found)
        piece = self.pieces[int(best[4])]
        name = self.problem.newcomer.name or "newcomer"
        robot = self.robot(best, name if index is None else f"{name} {index}")
        after = quality(self.problem.swarm.with_robot(robot)).value
        gain = after - self.before.value
        improves = gain > max(2.0 * self.gap * self.before.value, self.floor)
        certificate = certificate_of(
            found.bounds, found.rows, found.shares, found.pool, self.weights
        )
        return Placement(
            problem=self.problem,
            robot=robot,
            place=piece.place,
            quality_before=self.before.value,
            quality=after,
            upper_bound=max(certificate.upper_bound, after),
            improves=improves,
            reason=self.reason(robot) if improves else self.why_not(),
            certificate=certificate,
            runners_up=()
            if fraction is None
            else self.others(found, piece.place, after * fraction),
        )

    def without_tie(self, found: _Found) -> NDArray[np.float64]:
        """Return the best robot; among equals the one that lifts the rest of h most."""
        best = found.best
        target = best[0] - max(self.gap * best[0], self.floor)
        rivals = np.flatnonzero(found.bounds >= target)
        covectors = np.array([found.covector(int(k)) for k in rivals]) / self.weights
        if best[4] >= 0.0 and (np.abs(covectors[:, 2]) > FLAT).all():
            return best
        from swarmgrasp.kernels.ties import break_tie

        directions = even_directions(DIRECTIONS)
        mean = 0.5 * np.abs(self.generators @ directions.T).sum() / DIRECTIONS
        mean = max(mean, float(np.linalg.norm(self.weights[:2])) / 4.0)
        return np.asarray(
            break_tie(
                self.generators, found.pool, self.weights, self.rows, found.bounds, best,
                target, directions, SHARPNESS / mean,
            )
        )  # fmt: skip

    def robot(self, best: NDArray[np.float64], name: str) -> Robot:
        """Turn a wrench on a piece into a robot in contact."""
        piece, row = self.pieces[int(best[4])], self.rows[int(best[4])]
        _, c, s, torque = best[:4]
        from_p, from_q = (x * s - y * c for x, y in (row[0:2], row[2:4]))
        spread = from_q - from_p
        share = 0.5 if spread == 0.0 else min(max((torque - from_p) / spread, 0.0), 1.0)
        x, y = point_on(self.problem.swarm.outline, piece, share if piece.inward else 1.0 - share)
        angle = math.atan2(s, c)
        return Robot((float(x), float(y)), angle, self.problem.newcomer.limit, name)

    def others(self, found: _Found, taken: str, least: float) -> tuple[RunnerUp, ...]:
        """Find the best robot in every other place that can reach a quality."""
        runners = []
        places = list(dict.fromkeys(piece.place for piece in self.pieces))
        for label in places:
            chosen = [k for k, piece in enumerate(self.pieces) if piece.place == label]
            if label == taken or found.bounds[chosen].max() < least:
                continue
            best = self.solve(self.rows[chosen]).best
            if best[4] < 0.0:
                continue  # nothing here betters the swarm as it is
            best[4] = chosen[int(best[4])]
            robot = self.robot(best, self.problem.newcomer.name or "newcomer")
            value = quality(self.problem.swarm.with_robot(robot)).value
            if value >= least:
                runners.append(RunnerUp(robot, value, label))
        return tuple(sorted(runners, key=lambda runner: -runner.quality))

    def reason(self, robot: Robot) -> str:
        """Say what limits the swarm with its new robot."""
        after = quality(self.problem.swarm.with_robot(robot))
        return f"what remains weakest is {wrench_words(after.direction)}"

    def why_not(self) -> str:
        """Say why no newcomer improves the swarm."""
        present = len(self.problem.swarm)
        weakest = wrench_words(self.before.direction)
        if present < 3:
            return (
                f"with {present + 1} robots the quality is 0 wherever they are: force closure "
                "takes at least 4"
            )
        opposite = self.normals @ self.before.direction < -1.0 + 1e-9
        tolerance = max(2.0 * self.gap * self.before.value, self.floor)
        if opposite.any() and self.heights[opposite].min() <= self.before.value + tolerance:
            return (
                f"the swarm is equally weak in {weakest} and in the opposite direction, and one "
                "robot can push only one way: place two"
            )
        return (
            f"no allowed robot raises what is weakest, {weakest}, without another direction "
            "staying as weak: allow more places or directions, or place two"
        )


def even_directions(count: int) -> NDArray[np.float64]:
    """Spread directions evenly over the sphere on a Fibonacci spiral, (count, 3)."""
    k = np.arange(count)
    z = 1.0 - (2.0 * k + 1.0) / count
    radius, turn = np.sqrt(1.0 - z * z), k * math.pi * (3.0 - math.sqrt(5.0))
    return np.column_stack([radius * np.cos(turn), radius * np.sin(turn), z])


def _check_fractions(gap: float, runners_up: float | None) -> None:
    """Raise unless both are in their ranges."""
    faults = []
    if not 0.0 < gap < 1.0:
        faults.append(f"the gap is {gap!r}; it should be 0 < gap < 1")
    if runners_up is not None and not 0.0 <= runners_up <= 1.0:
        faults.append(f"runners_up is {runners_up!r}; it should be a fraction in [0, 1]")
    if faults:
        raise SwarmGraspError(faults)
