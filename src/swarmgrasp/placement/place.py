"""The globally best place for one newcomer, or for several one after the other (T8, T9)."""

import math
from collections.abc import Callable, Iterable
from dataclasses import replace
from typing import TypeGuard, Unpack

import numpy as np

from swarmgrasp.errors import NowhereToAttach, SwarmGraspError
from swarmgrasp.outline import Stretch
from swarmgrasp.placement.answer import Placement, Placements, RunnerUp
from swarmgrasp.placement.optimum import Best, Optimum, search_for
from swarmgrasp.placement.problem import Problem
from swarmgrasp.placement.sides import hills, parts_of
from swarmgrasp.placement.tolerant import Found, TolerantSearch
from swarmgrasp.quality.aim import Aim
from swarmgrasp.quality.criterion import Criterion, Terms
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.ranges import count_faults, is_whole
from swarmgrasp.swarm import Newcomer, Robot, Swarm, Zone
from swarmgrasp.swarm.rounding import largest_error

EQUAL = 1e-5
"""Relative difference up to which the robot that breaks ties is preferred to a runner-up."""
ROUGH = 1e-3
"""Relative gap to which the other places of a newcomer are found that cannot hit its place."""
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
    **terms: Unpack[Terms],
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
        this fraction of the best, within [0, 1]. Nameless edges that follow each other smoothly
        are one side, of which the places are told that are better than all around them.
    losing, worst_case, load, task
        As for `Criterion`: what quality means. In the worst case a newcomer with a tolerance
        aims at the place that is best for the worst of those it may end up in.

    Returns
    -------
    Placement

    Raises
    ------
    ZoneInvalid, NowhereToAttach
        If a zone leaves the boundary, or no allowed point is left.
    CriterionInvalid
        If a term is outside its range.
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
    places = None if zones is None else tuple(zones)
    problem = Problem(swarm, newcomer, places, tuple(no_go), spacing, Criterion(**terms))
    faults = _fraction_faults(gap, runners_up)
    if faults:
        raise SwarmGraspError(faults)
    return _placing(problem, gap).placement(runners_up)


def place_sequence(
    problem: Problem,
    count: int,
    *,
    gap: float = 1e-6,
    runners_up: float | None = None,
    progress: Callable[[int], object] | None = None,
) -> Placements:
    """Place several newcomers of one kind, one after the other.

    Each is optimal given those before it; together they need not be (T17).

    Parameters
    ----------
    problem : Problem
        The first newcomer's question.
    count : int
        How many to place, from 1 to 1000.
    gap, runners_up
        As for `place`.
    progress : callable, optional
        Called with the number placed so far, after each.

    Returns
    -------
    Placements
        A tuple of them, each with the swarm it found as its problem's swarm.

    Raises
    ------
    NowhereToAttach
        If spacing leaves no point to one of them; the message says how many fit.
    SwarmGraspError
        If `problem` is no `Problem`, or `count`, `gap` or `runners_up` outside its range; all
        faults at once.

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
    faults = _fraction_faults(gap, runners_up)
    faults[:0] = count_faults(count)
    if not isinstance(problem, Problem):
        kind = type(problem).__name__
        faults.insert(0, f"{kind} is no Problem: make one with Problem(swarm, newcomer)")
    if faults:
        raise SwarmGraspError(faults)
    placing = _placing(problem, gap)
    answers: list[Placement] = []
    for index in range(1, count + 1):
        try:
            if answers:
                placing.join(answers[-1])
        except NowhereToAttach as fault:
            raise NowhereToAttach(
                f"only {index - 1} of {count} robots find a place: {fault}"
            ) from None
        answers.append(placing.placement(runners_up, index if count > 1 else None))
        if progress is not None:
            progress(index)
    return Placements(answers)


class _Placing:
    """One problem on its way to an answer."""

    def __init__(self, problem: Problem, gap: float) -> None:
        self.problem, self.gap = problem, float(gap)
        self.pieces = problem.pieces()
        self.search = search_for(problem, self.pieces.rows)
        # half of the gap is the search's, the other half the tie-break's
        self.half = math.sqrt(1.0 + self.gap) - 1.0

    def placement(self, fraction: float | None, index: int | None = None) -> Placement:
        """Answer the problem."""
        search, before = self.search, self.search.base
        if search.aim is not None:
            before, _ = search.aim.weakest()
        found = search.solve(self.half)
        name = self.problem.newcomer.name or "newcomer"
        name = name if index is None else f"{name} {index}"
        winner, after, upper_bound = self.winner(found, name)
        runners = []
        if fraction is not None:
            runners = self.others(found, winner, name, fraction)
            best = max(runners, key=lambda pair: pair[0].quality, default=(winner, after))
            if best[0].quality > winner.quality * (1.0 + EQUAL) + self.noise(winner, after):
                runners = [pair for pair in runners if pair is not best] + [(winner, after)]
                winner, after = best
        noise = self.noise(winner, after)
        improves = winner.quality > before.quality * (1.0 + RISE) + 10.0 * search.zero + noise
        asked_for = winner.quality * (1.0 + self.gap) + 2.0 * search.floor
        asked_for += 0.0 if improves else noise
        if winner.quality == 0.0 and upper_bound <= 2.0 * search.zero:
            upper_bound = 0.0  # what counts as 0, and as much again that searches leave open
        return Placement(
            problem=self.problem,
            robot=winner.robot,
            place=winner.place,
            before=before,
            after=after,
            opposite=search.opposite,
            upper_bound=max(upper_bound, winner.quality),
            asked_gap=self.gap,
            asked_runners_up=fraction,
            stopped_early=upper_bound > asked_for,
            improves=improves,
            runners_up=tuple(sorted((r for r, _ in runners), key=lambda r: -r.quality)),
            _found=found,
        )

    def join(self, answer: Placement) -> None:
        """Go on with the swarm that an answer leaves.

        Raises
        ------
        NowhereToAttach
            If spacing leaves no place to another newcomer.
        """
        self.problem = self.problem.with_swarm(answer.swarm_after)
        self.pieces = self.problem.pieces()
        if self.search.aim is None:
            self.search.join(*self.wrench(answer.robot), self.pieces.rows)
        else:
            self.search = search_for(self.problem, self.pieces.rows)

    def wrench(self, robot: Robot) -> tuple[float, float, float]:
        """Return the unit wrench [1, 1, m] of a robot in contact."""
        x0, y0 = self.problem.swarm.outline.origin.tolist()
        (x, y), c, s = robot.contact, math.cos(robot.direction), math.sin(robot.direction)
        return c, s, (x - x0) * s - (y - y0) * c

    def winner(self, found: Optimum, name: str) -> tuple[RunnerUp, Weakest, float]:
        """Return the best robot, its quality, and what no robot exceeds."""
        search, best = self.search, found.best.quality
        target = min(best / (1.0 + self.half), best - 0.5 * search.floor)
        robot, after = self.candidate(search.break_tie(found, target), name)
        if 0.0 < after.quality - search.base.quality <= self.noise(robot, after):
            anyone = replace(found, best=found.best._replace(piece=-1))
            least = search.base.quality - 0.5 * search.floor
            tied = self.candidate(search.break_tie(anyone, least), name)
            if after.quality - tied[1].quality <= self.noise(*tied):
                robot, after = tied
        return robot, after, found.upper_bound

    def noise(self, found: RunnerUp, after: Weakest) -> float:
        """Bound what rounding in the outline's coordinates may make of a gain; 0 if it is clear."""
        problem, swarm = self.problem, self.problem.swarm
        if swarm.outline.precision == 0.0:
            return 0.0
        most = float(swarm.limits.sum()) + problem.newcomer.limit
        most *= largest_error(swarm.outline, swarm.scale)
        is_clear = after.quality - self.search.base.quality > most
        if is_clear and problem.criterion.task is None:
            return 0.0  # without a look at every robot
        return problem.criterion.noise(problem.swarm.with_robot(found.robot), after.normal)

    def candidate(self, best: Best, name: str) -> tuple[RunnerUp, Weakest]:
        """Turn a wrench on a piece into a robot in contact, with its quality."""
        contact, angle = self.pieces.robot_at(best.piece, best.c, best.s, best.torque)
        robot = self.robot(contact, angle, name)
        if self.search.aim is None:
            after = self.search.quality_with(*self.wrench(robot))
        else:
            swarm = self.problem.swarm.with_robot(robot)
            after, _ = Aim(swarm, self.problem.criterion).weakest()
        return RunnerUp(robot, after.quality, self.pieces.each[best.piece].place), after

    def robot(self, contact: tuple[float, float], direction: float, name: str) -> Robot:
        """Return the newcomer in contact."""
        newcomer = self.problem.newcomer
        return Robot(contact, direction, newcomer.limit, name, tolerance=newcomer.tolerance)

    def others(
        self, found: Optimum, winner: RunnerUp, name: str, fraction: float
    ) -> list[tuple[RunnerUp, Weakest]]:
        """Find the best robot in every other place that is nearly as good."""
        least, bounds, parts = fraction * winner.quality, found.bounds, parts_of(self.pieces)
        values, runners = {}, {}
        for part, chosen in enumerate(parts.pieces):
            if any(self.pieces.each[k].place == winner.place for k in chosen):
                values[part] = winner.quality
            elif bounds[chosen].max() >= least:
                best = self.best_on(chosen, name)
                if best is not None and best[0].quality >= least:
                    values[part], runners[part] = best[0].quality, best
        return [runners[part] for part in hills(values, parts.touching) if part in runners]

    def best_on(self, chosen: list[int], name: str) -> tuple[RunnerUp, Weakest] | None:
        """Return the best robot on some pieces; None if none there betters the swarm as it is."""
        best = self.search.solve(self.half, chosen).best
        return self.candidate(best, name) if best.piece >= 0 else None


class _Aiming(_Placing):
    """One problem whose newcomer cannot hit its place exactly."""

    def winner(self, found: Optimum, name: str) -> tuple[RunnerUp, Weakest, float]:
        """Return the best robot, its quality, and what no robot exceeds."""
        self.aiming = TolerantSearch(self.problem, self.pieces, found, self.search.zero)
        best = self.aiming.solve(self.gap)
        return (*self.aimed(best, name), best.upper_bound)

    def aimed(self, best: Found, name: str) -> tuple[RunnerUp, Weakest]:
        """Turn a place into a robot in contact, with its quality."""
        robot = self.robot(best.contact, best.direction, name)
        place = self.pieces.each[best.piece].place
        return RunnerUp(robot, best.after.quality, place), best.after

    def best_on(self, chosen: list[int], name: str) -> tuple[RunnerUp, Weakest] | None:
        """Return a good robot on some pieces."""
        return self.aimed(self.aiming.solve(ROUGH, set(chosen)), name)


def _placing(problem: Problem, gap: float) -> _Placing:
    """Put a problem on its way."""
    return (_Aiming if problem.is_tolerant else _Placing)(problem, gap)


def _fraction_faults(gap: object, runners_up: object) -> list[str]:
    """Return what is wrong with them."""
    faults = []
    if not (_is_real(gap) and 0.0 < gap < 1.0):
        faults.append(f"the gap is {gap!r}; it should be 0 < gap < 1")
    if runners_up is not None and not (_is_real(runners_up) and 0.0 <= runners_up <= 1.0):
        faults.append(f"runners_up is {runners_up!r}; it should be a fraction in [0, 1]")
    return faults


def _is_real(value: object) -> TypeGuard[float]:
    """Tell whether a value is a number."""
    return isinstance(value, float | np.floating) or is_whole(value)
