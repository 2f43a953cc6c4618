"""The globally best place for one newcomer, or for several one after the other (T8, T9)."""

import math
from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Any, Protocol, Unpack, overload

from swarmgrasp.errors import NowhereToAttach, ProblemInvalid, SwarmGraspError, refuse
from swarmgrasp.outline import Stretch
from swarmgrasp.placement.answer import Placement, Placements, RunnerUp
from swarmgrasp.placement.areas import Decks
from swarmgrasp.placement.boxes import BoxSearch
from swarmgrasp.placement.gaps import beside_gaps
from swarmgrasp.placement.patches import Berth, PatchSearch, robot_in
from swarmgrasp.placement.problem import Problem, check_newcomer, problem_faults
from swarmgrasp.placement.search import Best, Optimum, Search, search_for
from swarmgrasp.placement.sides import hills, parts_of
from swarmgrasp.placement.spans import SpanSearch, Stand, robot_on
from swarmgrasp.placement.tolerant import Found as Aimed
from swarmgrasp.placement.tolerant import TolerantSearch
from swarmgrasp.quality.aim import Aim, Work
from swarmgrasp.quality.criterion import NOMINAL, Criterion, Keywords, criterion_of
from swarmgrasp.quality.robot_sets import UNSURE
from swarmgrasp.quality.weakest import Weakest
from swarmgrasp.ranges import call_faults, count_faults, gap_faults, items, number, shown
from swarmgrasp.swarm import Newcomer, Robot, Swarm, Zone
from swarmgrasp.swarm.rounding import largest_error

EQUAL = 1e-5
"""Relative difference up to which the robot that breaks ties is preferred to a runner-up."""
ROUGH = 1e-3
"""Relative gap to which the other places of a newcomer are found that cannot hit its place."""
BESIDE = (
    "a Problem has a newcomer, zones, no-go stretches, a spacing and a criterion of its own: give "
    "none beside it, or make another with dataclasses.replace"
)
RISE = 1e-9
"""Relative gain below which a newcomer does not count as an improvement."""


def rise_of(criterion: Criterion) -> float:
    """Return the relative gain below which nothing counts as an improvement by a criterion."""
    return UNSURE if criterion.worst_case else RISE  # certified no nearer in the worst case


@overload
def place(
    problem: Problem, /, *, gap: float = 1e-6, runners_up: float | None = None
) -> Placement: ...


@overload
def place(
    swarm: Swarm,
    /,
    newcomer: Newcomer,
    zones: Iterable[Zone] | None = None,
    *,
    no_go: Iterable[Stretch] = (),
    spacing: float = 0.0,
    gap: float = 1e-6,
    runners_up: float | None = None,
    **keywords: Unpack[Keywords],
) -> Placement: ...


def place(
    problem: Problem | Swarm,
    /,
    newcomer: Newcomer | None = None,
    zones: Iterable[Zone] | None = None,
    *,
    no_go: Iterable[Stretch] = (),
    spacing: float = 0.0,
    gap: float = 1e-6,
    runners_up: float | None = None,
    **keywords: Unpack[Keywords],
) -> Placement:
    """Find where the newcomer should attach and which way it should push.

    The global optimum over everything a robot can really do, with a proof (T8-T10).

    Beside robots whose sectors have gaps between, the answer is a good place beside one choice of a
    sector for each, `choice`; no place is better than `upper_bound`, whatever they choose (T28).

    Parameters
    ----------
    problem : Problem or Swarm
        The question; or a swarm, followed by what a `Problem` asks of it.
    newcomer : Newcomer
        With a swarm, as are the next ones.
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
    SwarmInvalid, RobotInvalid, ZoneInvalid
        As for `Problem`.
    CriterionInvalid
        If a term is outside its range.
    ProblemInvalid
        If `gap` or `runners_up` is outside its range, or parts of a problem are given beside one.
    NowhereToAttach
        If no allowed point is left.

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
    faults = _fraction_faults(gap, runners_up)
    if isinstance(problem, Problem):
        parts = (
            newcomer is not None,
            zones is not None,
            items(no_go) != (),
            number(spacing) != 0.0,
        )
        if any(parts) or keywords:
            faults.append(BESIDE)
        refuse((ProblemInvalid, faults))
        asked = problem
    else:
        asked = _posed((problem, newcomer, zones, no_go, spacing), keywords, faults)
    (answer,) = place_sequence(asked, 1, gap=gap, runners_up=runners_up)
    return answer


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
        Called with the number placed so far, after each. If what it returns is true, no more are
        placed.

    Returns
    -------
    Placements
        A tuple of them, each with the swarm it found as its problem's swarm.

    Raises
    ------
    NowhereToAttach
        If spacing leaves no point to one of them; the message says how many fit.
    ProblemInvalid
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
    faults = problem_faults(problem) + count_faults(count) + _fraction_faults(gap, runners_up)
    refuse((ProblemInvalid, faults + call_faults(progress)))
    check_newcomer(problem)
    names = problem.swarm.names.fresh(problem.newcomer.name or "newcomer", int(count))
    placing = _placing(problem, gap)
    answers: list[Placement] = []
    for index, name in enumerate(names, start=1):
        try:
            if answers:
                placing.join(answers[-1])
        except NowhereToAttach as fault:
            raise NowhereToAttach(
                f"only {index - 1} of {count} robots find a place: {fault}"
            ) from None
        answers.append(placing.placement(runners_up, name))
        if progress is not None and progress(index):
            break
    return Placements(answers)


class Seeking(Protocol):
    """A search for the place of a newcomer, of any kind."""

    base: Weakest
    opposite: float
    floor: float
    zero: float
    work: Work

    @property
    def aim(self) -> Aim | None:
        """What is asked other than the nominal quality of rays."""

    @property
    def left(self) -> float:
        """Units of work; below 0 when it was not enough."""

    def solve(self, gap: float, chosen: Sequence[int] | None = None) -> Optimum[Any]:
        """Find the best robot over all pieces, or over the chosen ones."""

    def break_tie(self, best: Any, target: float) -> Any:
        """Of the robots of at least the target quality, take the one that lifts the rest most."""


class _Placing:
    """One problem on its way to an answer."""

    def __init__(self, problem: Problem, gap: float) -> None:
        self.problem, self.gap = problem, float(gap)
        self.pieces = problem.places()
        self.search = self.begin()
        # half of the gap is the search's, the other half the tie-break's
        self.half = math.sqrt(1.0 + self.gap) - 1.0

    def begin(self) -> Seeking:
        """Return the search of the problem."""
        if isinstance(self.pieces, Decks):
            return PatchSearch(self.problem, self.pieces)
        if self.problem.newcomer.keeps:
            return SpanSearch(self.problem, self.problem.pieces())
        if self.problem.has_rays_only:
            return search_for(self.problem, self.pieces.rows)
        return BoxSearch(self.problem, self.pieces)

    def placement(self, fraction: float | None, name: str) -> Placement:
        """Answer the problem, with a name for the robot."""
        search, before = self.search, self.search.base
        if isinstance(search, Search) and search.aim is not None:
            before = search.work.quality(search.aim)
        found = search.solve(self.half)
        winner, after, upper_bound = self.winner(found, name)
        runners = []
        if fraction is not None:
            runners = self.others(found, winner, name, fraction)
            best = max(runners, key=lambda pair: pair[0].quality, default=(winner, after))
            if best[0].quality > winner.quality * (1.0 + EQUAL) + self.noise(winner, after):
                runners = [pair for pair in runners if pair is not best] + [(winner, after)]
                winner, after = best
        noise = self.noise(winner, after)
        rise = rise_of(self.problem.criterion)
        improves = winner.quality > before.quality * (1.0 + rise) + 10.0 * search.zero + noise
        asked_for = winner.quality * (1.0 + self.gap) + (0.0 if improves else noise)
        if found.solved:  # as near as rounding lets it come
            asked_for += 2.0 * search.floor
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
        self.pieces = self.problem.places()
        if isinstance(self.search, Search) and self.search.aim is None:
            assert not isinstance(self.pieces, Decks)  # which have another search
            self.search.join(*self.wrench(answer.robot), self.pieces.rows)
        else:
            self.search = self.begin()

    def wrench(self, robot: Robot) -> tuple[float, float, float]:
        """Return the unit wrench [1, 1, m] of a robot in contact."""
        x0, y0 = self.problem.swarm.outline.origin.tolist()
        (x, y), c, s = robot.contact, math.cos(robot.direction), math.sin(robot.direction)
        return c, s, (x - x0) * s - (y - y0) * c

    def winner(self, found: Optimum[Any], name: str) -> tuple[RunnerUp, Weakest, float]:
        """Return the best robot, its quality, and what no robot exceeds."""
        search, best = self.search, found.best.quality
        target = min(best / (1.0 + self.half), best - 0.5 * search.floor)
        robot, after = self.candidate(search.break_tie(found.best, target), name)
        if 0.0 < after.quality - search.base.quality <= self.noise(robot, after):
            anyone = found.best._replace(piece=-1)
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

    def candidate(self, best: Best | Stand | Berth, name: str) -> tuple[RunnerUp, Weakest]:
        """Turn what a search has found into a robot in contact, with its quality."""
        if isinstance(best, Stand):
            robot = robot_on(self.problem, self.problem.pieces(), best.piece, best.share, name)
        elif isinstance(best, Berth):
            robot = robot_in(self.problem, best, name)
        else:
            assert not isinstance(self.pieces, Decks)  # where all are berths
            contact, angle = self.pieces.robot_at(best.piece, best.c, best.s, best.torque)
            robot = self.robot(contact, angle, name)
        if isinstance(self.search, Search) and self.search.aim is None:
            after = self.search.quality_with(*self.wrench(robot))
        else:
            swarm = self.problem.swarm.with_robot(robot)
            after = self.search.work.quality(Aim(swarm, self.problem.criterion))
        return RunnerUp(robot, after.quality, self.pieces.each[best.piece].place), after

    def robot(self, contact: tuple[float, float], direction: float, name: str) -> Robot:
        """Return the newcomer in contact."""
        newcomer = self.problem.newcomer
        return Robot(
            contact, direction, newcomer.limit, name, newcomer.mounted, newcomer.tolerance,
            newcomer.reverse_limit, body=newcomer.body,
        )  # fmt: skip

    def others(
        self, found: Optimum[Any], winner: RunnerUp, name: str, fraction: float
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

    def winner(self, found: Optimum[Any], name: str) -> tuple[RunnerUp, Weakest, float]:
        """Return the best robot, its quality, and what no robot exceeds."""
        search = self.search
        search.work.left += search.left  # it is not asked again
        self.aiming = TolerantSearch(
            self.problem, self.problem.pieces(), found, search.zero, search.work
        )
        best = self.aiming.solve(self.gap)
        return (*self.aimed(best, name), best.upper_bound)

    def aimed(self, best: Aimed, name: str) -> tuple[RunnerUp, Weakest]:
        """Turn a place into a robot in contact, with its quality."""
        robot, place = replace(best.robot, name=name), self.pieces.each[best.piece].place
        return RunnerUp(robot, best.after.quality, place), best.after

    def best_on(self, chosen: list[int], name: str) -> tuple[RunnerUp, Weakest] | None:
        """Return a good robot on some pieces."""
        return self.aimed(self.aiming.solve(ROUGH, set(chosen)), name)


class _BesideGaps:
    """One problem whose robots have gaps between their sectors."""

    def __init__(self, problem: Problem, gap: float) -> None:
        self.problem, self.gap = problem, gap

    def placement(self, fraction: float | None, name: str) -> Placement:
        """Answer the problem, with a name for the robot."""
        return beside_gaps(
            self.problem, lambda asked: _placing(asked, self.gap).placement(fraction, name)
        )

    def join(self, answer: Placement) -> None:
        """Go on with the swarm that an answer leaves."""
        self.problem = self.problem.with_swarm(answer.swarm_after)


def _placing(problem: Problem, gap: float) -> _Placing | _BesideGaps:
    """Put a problem on its way."""
    if problem.swarm.rare.gaps:
        return _BesideGaps(problem, gap)
    return (_Aiming if problem.is_tolerant else _Placing)(problem, gap)


def _posed(parts: tuple[Any, ...], keywords: Keywords, faults: list[str]) -> Problem:
    """Return the problem of parts and keywords; tell all that is wrong, beside other faults."""
    kinds: list[tuple[type[SwarmGraspError], Sequence[str]]] = [(ProblemInvalid, faults)]
    criterion = NOMINAL
    try:
        criterion = criterion_of("place", keywords)
    except SwarmGraspError as error:
        kinds.insert(0, (type(error), error.faults))
    try:
        swarm, newcomer, zones, no_go, spacing = parts
        problem = Problem(swarm, newcomer, zones, no_go, spacing, criterion)
    except SwarmGraspError as error:
        refuse((type(error), error.faults), *kinds)
        raise
    refuse(*kinds)
    return problem


def _fraction_faults(gap: object, runners_up: object) -> list[str]:
    """Return what is wrong with them."""
    faults = gap_faults(gap)
    if runners_up is not None and not 0.0 <= number(runners_up) <= 1.0:
        faults.append(f"runners_up is {shown(runners_up)}; it should be a fraction in [0, 1]")
    return faults
