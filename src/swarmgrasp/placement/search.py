"""The globally best place for one newcomer, or for several one after the other (T8, T9)."""

import math
from collections.abc import Iterable

import numpy as np

from swarmgrasp.errors import NowhereToAttach, SwarmGraspError
from swarmgrasp.outline import Stretch
from swarmgrasp.placement.answer import Placement, RunnerUp
from swarmgrasp.placement.optimum import OPPOSITE, Array, Optimum, Search
from swarmgrasp.placement.pieces import point_on
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.ties import break_tie, is_tied
from swarmgrasp.quality import wrench_words
from swarmgrasp.quality.facets import Facets, facets_of
from swarmgrasp.robot import Newcomer, Robot, Zone
from swarmgrasp.swarm import Swarm, wrenches

EQUAL = 1e-5
"""Relative difference up to which the robot that breaks ties is preferred to a runner-up."""
RISE = 1e-9
"""Relative gain below which a newcomer does not count as an improvement."""


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
    >>> [round(v, 3) for v in answer.robot.contact], round(answer.quality, 5)
    ([0.4, -1.0], 0.69631)
    >>> bool(answer.verify())
    True
    """
    problem = Problem(
        swarm, newcomer, None if zones is None else tuple(zones), tuple(no_go), spacing
    )
    _check_fractions(gap, runners_up)
    return _Placing(problem, gap).placement(runners_up)


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

    Raises
    ------
    NowhereToAttach
        If spacing leaves no point to one of them; the message says how many fit.
    SwarmGraspError
        If `count`, `gap` or `runners_up` is outside its range.

    Examples
    --------
    A fifth robot cannot raise a balanced square, the sixth does.

    >>> from math import pi
    >>> from swarmgrasp import Outline, Problem
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> pulls = [((1, -0.4), 0), ((-1, 0.4), pi), ((-0.4, 1), pi / 2), ((0.4, -1), -pi / 2)]
    >>> four = Swarm(square, [Robot(c, a) for c, a in pulls], characteristic_length=1.0)
    >>> pulling = Newcomer(limit=1.0, attachment="pull", half_angle=0.0)
    >>> fifth, sixth = place_sequence(Problem(four, pulling), 2)
    >>> fifth.improves, sixth.improves
    (False, True)
    """
    if count < 1:
        raise SwarmGraspError(f"the number of robots is {count}; it should be at least 1")
    _check_fractions(gap, runners_up)
    answers: list[Placement] = []
    for index in range(1, count + 1):
        try:
            placing = _Placing(problem, gap)
        except NowhereToAttach as fault:
            if count == 1:
                raise
            raise NowhereToAttach(
                f"only {index - 1} of {count} robots find a place: {fault}"
            ) from None
        answer = placing.placement(runners_up, index if count > 1 else None)
        answers.append(answer)
        problem = problem.with_swarm(answer.swarm_after)
    return tuple(answers)


class _Placing:
    """One problem on its way to an answer."""

    def __init__(self, problem: Problem, gap: float) -> None:
        self.problem, self.gap = problem, gap
        # half of the gap is the search's, the other half the tie-break's
        self.search = Search(problem, math.sqrt(1.0 + gap) - 1.0)
        self.pieces, self.facets = self.search.pieces, self.search.facets
        self.before = self.facets.quality

    def placement(self, fraction: float | None, index: int | None = None) -> Placement:
        """Answer the problem."""
        floor = self.search.floor
        found = self.search.solve()
        target = min(found.best[0] / (1.0 + self.search.gap), found.best[0] - 0.5 * floor)
        best = break_tie(self.search, found, target) if is_tied(found, target) else found.best
        name = self.problem.newcomer.name or "newcomer"
        name = name if index is None else f"{name} {index}"
        candidates = [self.runner_up(best, name)]
        if fraction is not None:
            candidates += self.others(found, candidates[0], name, fraction)
        winner = max(candidates, key=lambda c: c.quality)
        if winner.quality <= candidates[0].quality * (1.0 + EQUAL):
            winner = candidates[0]
        certificate = found.certificate()
        asked_for = winner.quality * (1.0 + self.gap) + 2.0 * floor
        improves = winner.quality > self.before * (1.0 + RISE) + 10.0 * self.search.zero
        return Placement(
            problem=self.problem,
            robot=winner.robot,
            place=winner.place,
            quality_before=self.before,
            quality=winner.quality,
            upper_bound=max(certificate.upper_bound, winner.quality),
            tolerance=self.gap,
            stopped_early=certificate.upper_bound > asked_for,
            improves=improves,
            reason=self.what_limits(winner.robot) if improves else self.why_not(),
            certificate=certificate,
            runners_up=tuple(
                sorted((c for c in candidates if c is not winner), key=lambda c: -c.quality)
            ),
        )

    def robot(self, best: Array, name: str) -> Robot:
        """Turn a wrench on a piece into a robot in contact."""
        piece, row = self.pieces[int(best[4])], self.search.rows[int(best[4])]
        _, c, s, torque = best[:4]
        from_p, from_q = (x * s - y * c for x, y in (row[0:2], row[2:4]))
        spread = from_q - from_p
        share = 0.5 if spread == 0.0 else min(max((torque - from_p) / spread, 0.0), 1.0)
        x, y = point_on(self.problem.swarm.outline, piece, share if piece.inward else 1.0 - share)
        angle = math.atan2(s, c)
        return Robot((float(x), float(y)), angle, self.problem.newcomer.limit, name)

    def runner_up(self, best: Array, name: str) -> RunnerUp:
        """Turn the best robot of some pieces into one in contact, with its exact quality."""
        robot = self.robot(best, name)
        return RunnerUp(robot, self.with_robot(robot).quality, self.pieces[int(best[4])].place)

    def with_robot(self, robot: Robot) -> Facets:
        """Evaluate the swarm with a robot, exactly."""
        swarm = self.problem.swarm
        arm = np.array([robot.contact]) - swarm.outline.origin
        generator = wrenches(arm, np.array([robot.direction]), np.array([robot.limit]))
        together = np.vstack([self.search.generators, generator * swarm.scale])
        return facets_of(together, margin=0.0)

    def others(
        self, found: Optimum, winner: RunnerUp, name: str, fraction: float
    ) -> list[RunnerUp]:
        """Find the best robot in every other place that is nearly as good."""
        runners = []
        least = fraction * winner.quality
        for place in dict.fromkeys(piece.place for piece in self.pieces):
            chosen = [k for k, piece in enumerate(self.pieces) if piece.place == place]
            if place == winner.place or found.bounds[chosen].max() < least:
                continue
            best = self.search.solve(chosen).best
            if best[4] >= 0.0:  # otherwise nothing there betters the swarm as it is
                best[4] = chosen[int(best[4])]
                runners.append(self.runner_up(best, name))
        return [runner for runner in runners if runner.quality >= least]

    def what_limits(self, robot: Robot) -> str:
        """Say what limits the swarm with its new robot."""
        return f"what remains weakest is {wrench_words(self.with_robot(robot).weakest)}"

    def why_not(self) -> str:
        """Say why no newcomer improves the swarm."""
        present = len(self.problem.swarm)
        weakest = wrench_words(self.facets.weakest)
        if present < 3:
            return (
                "force closure takes at least 4 robots, wherever they are; with this one there "
                f"{'are' if present else 'is'} {present + 1}"
            )
        opposite = self.facets.normals @ self.facets.weakest < OPPOSITE
        heights = self.facets.heights[opposite]
        equal = self.before * (1.0 + self.gap) + 2.0 * self.search.floor
        if self.before > 0.0 and len(heights) and heights.min() <= equal:
            return (
                f"the swarm is equally weak in {weakest} and in the opposite direction, and one "
                "robot can push only one way: place two"
            )
        return (
            f"no allowed robot raises what is weakest, {weakest}, without another direction "
            "staying as weak: allow more places or directions, or place several"
        )


def _check_fractions(gap: float, runners_up: float | None) -> None:
    """Raise unless both are in their ranges."""
    faults = []
    if not 0.0 < gap < 1.0:
        faults.append(f"the gap is {gap!r}; it should be 0 < gap < 1")
    if runners_up is not None and not 0.0 <= runners_up <= 1.0:
        faults.append(f"runners_up is {runners_up!r}; it should be a fraction in [0, 1]")
    if faults:
        raise SwarmGraspError(faults)
