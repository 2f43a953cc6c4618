"""Which one robot should attach elsewhere, and what that is worth."""

import math
from collections.abc import Callable, Iterable
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any

from swarmgrasp.errors import NowhereToAttach, ProblemInvalid, RobotInvalid, refuse
from swarmgrasp.frozen import Frozen
from swarmgrasp.placement.answer import Placement, relative_gap
from swarmgrasp.placement.place import place, rise_of
from swarmgrasp.placement.problem import Problem, problem_faults
from swarmgrasp.plain import Answer, Told, picked
from swarmgrasp.quality.max_transfer import Quality, quality
from swarmgrasp.ranges import call_faults, gap_faults
from swarmgrasp.swarm import Newcomer, Robot, Swarm
from swarmgrasp.swarm.robot import RIGHT_ANGLE
from swarmgrasp.swarm.swarm import check_gaps
from swarmgrasp.terms import SI, Terms


@dataclass(frozen=True, eq=False)
class Relocation(Frozen, Told):
    """The best place for one robot that lets go.

    Attributes
    ----------
    old : Robot
        As it is now.
    placement : Placement
        Its best place beside all the others, with the proof.
    before : Quality
        Of the swarm as it is.
    """

    old: Robot
    placement: Placement
    before: Quality
    _swarm: Swarm = field(repr=False)

    @property
    def name(self) -> str:
        """The robot's name."""
        return self.old.name

    def to_data(self) -> dict[str, Any]:
        """Return the move as plain data."""
        names = ("old", "new", "place", "quality", "quality_without", "upper_bound")
        return {"robot": self.name, **picked(self, *names)}

    @property
    def new(self) -> Robot:
        """The robot in its new place."""
        return replace(self.placement.robot, group=self.old.group)

    @property
    def place(self) -> str:
        """The zone's name, or the edge's."""
        return self.placement.place

    @property
    def quality(self) -> float:
        """Quality of the swarm after the move [N]."""
        return self.placement.quality

    @property
    def quality_without(self) -> float:
        """Quality while the robot is under way [N]."""
        return self.placement.quality_before

    @property
    def upper_bound(self) -> float:
        """What no move of this robot exceeds [N]."""
        return self.placement.upper_bound

    @property
    def gap(self) -> float:
        """By how much the bound exceeds the quality, as `relative_gap` has it."""
        return self.placement.gap

    @property
    def gain(self) -> float:
        """By how much the move raises the quality [N]; negative if its present place is better."""
        return self.quality - self.before.value

    @cached_property
    def swarm_after(self) -> Swarm:
        """The swarm after the move, in the same order."""
        return self._swarm.with_pose(self.name, self.new.contact, self.new.direction)


@dataclass(frozen=True, eq=False)
class Move(Frozen, Answer):
    """The best move of one robot, and what the others could do.

    Attributes
    ----------
    problem : Problem
        Where robots may attach, and the swarm as it is.
    before : Quality
        Of that swarm.
    ranked : tuple of Relocation
        The best move of each robot, the best robot first.
    stuck : tuple of str
        Names of robots that have nowhere to go.
    untried : tuple of str
        Names of robots whose moves nobody looked at, for the search was ended: nothing is known of
        them.
    """

    problem: Problem
    before: Quality
    ranked: tuple[Relocation, ...]
    stuck: tuple[str, ...]
    untried: tuple[str, ...] = ()

    kind = "move"

    def to_data(self) -> dict[str, Any]:
        """Return question and answer as plain data."""
        return picked(
            self, "problem", "quality_before", "quality", "upper_bound", "improves", "reason",
            "ranked", "stuck", "untried",
        )  # fmt: skip

    @property
    def best(self) -> Relocation:
        """The move that brings the highest quality."""
        return self.ranked[0]

    @property
    def quality_before(self) -> float:
        """Quality of the swarm as it is [N]."""
        return self.before.value

    @property
    def quality(self) -> float:
        """Quality after the best move [N]."""
        return self.best.quality

    @property
    def gain(self) -> float:
        """By how much the best move raises the quality [N]; at most 0 if robots had better stay."""
        return self.best.gain

    @property
    def upper_bound(self) -> float:
        """What no move of one robot exceeds [N], those untried aside."""
        bound = max(move.upper_bound for move in self.ranked)
        return 0.0 if self.quality == 0.0 and not self._is_open else bound

    @property
    def gap(self) -> float:
        """By how much the bound exceeds the quality, as `relative_gap` has it."""
        return relative_gap(self.upper_bound, self.quality)

    @property
    def _is_open(self) -> bool:
        """Whether a search has stopped before its bound came near."""
        return any(move.placement.stopped_early for move in self.ranked)

    @property
    def improves(self) -> bool:
        """Whether the best move raises the quality, by more than the outline's rounding may."""
        noise = max(self.before.noise, self.best.placement.noise)
        return self.is_worth_it(rise_of(self.problem.criterion) * self.quality_before + noise)

    def is_worth_it(self, least_gain: float) -> bool:
        """Tell whether the best move raises the quality by more than so much [N].

        What a move costs, in time and while the robot holds nothing, is the caller's to say.
        """
        return self.gain > least_gain

    @property
    def swarm_after(self) -> Swarm:
        """The swarm after the best move."""
        return self.best.swarm_after

    @property
    def reason(self) -> str:
        """What the best move does, in words."""
        return self.reason_in(SI)

    def reason_in(self, terms: Terms) -> str:
        """Return the same in other terms than ours."""
        best, swarm, weakest = self.best, self.problem.swarm, self.before.weakest_words
        if not self.improves:
            if self._is_open or self.untried:
                return f"no move was found that raises what is weakest, {weakest}"
            alone = f"no {terms.robot} alone can raise what is weakest"
            return f"{alone}, {weakest}, by moving: leave them"
        after = self.problem.criterion.weakest_words(swarm, best.placement.after.normal)
        away = (
            "nothing is held in some directions" if best.quality_without == 0.0 else "less is held"
        )
        if best.quality_without >= self.quality_before:
            away = "nothing is lost"
        return (
            f"{best.name} had better be on {best.place}: weakest was {weakest}, and is then "
            f"{after}; while it is under way {away}"
        )


def best_move(
    problem: Problem | Swarm,
    *,
    robots: str | Iterable[str] | None = None,
    gap: float = 1e-6,
    progress: Callable[[int], object] | None = None,
) -> Move:
    """Find the one robot that should attach elsewhere, and where.

    Each robot in turn lets go and is placed anew beside all the others, which is solved to the
    global optimum (T8, T9).

    Parameters
    ----------
    problem : Problem or Swarm
        Where robots may attach and how: the problem's zones, spacing and criterion, and its
        newcomer's attachment and half angle. Each robot keeps its own limit, tolerance and name,
        and what it can exert: one that steers keeps its sector, about the normal.
        Of a swarm alone: anywhere, in any direction.
    robots : str or iterable of str, optional
        Those that may move, by name; all that are not mounted when left out.
    gap : float
        As for `place`.
    progress : callable, optional
        Called with the number of robots tried, after each; if what it returns is true, the search
        ends with those tried, once one of them has anywhere to go.

    Returns
    -------
    Move

    Raises
    ------
    RobotInvalid
        If no robot may move, or a name is of none or of a mounted one; all faults at once.
    NowhereToAttach
        If none has anywhere to go.
    ForceSetUnsupported
        If robots have sectors with gaps between.
    ProblemInvalid
        If it is neither a `Problem` nor a `Swarm`, or `gap` is outside its range.

    Examples
    --------
    The fifth robot helps nobody where it is.

    >>> from math import pi
    >>> from swarmgrasp import Outline
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> pulls = [((1, -0.4), 0), ((-1, 0.4), pi), ((-0.4, 1), pi / 2), ((0.4, 1), pi / 2)]
    >>> crew = Swarm(square, [Robot(c, a) for c, a in pulls], characteristic_length=1.0)
    >>> move = best_move(Problem(crew, Newcomer(1.0, "pull", 0.0)))
    >>> move.best.name, move.best.place, round(move.gain, 4), move.is_worth_it(0.1)
    ('R4', 'edge 0', 0.6963, True)
    """
    if isinstance(problem, Swarm):
        problem = Problem(problem, Newcomer())
    refuse((ProblemInvalid, problem_faults(problem) + gap_faults(gap) + call_faults(progress)))
    swarm = problem.swarm
    check_gaps(swarm, "the best move")
    before = quality(swarm, **problem.criterion.keywords)
    found, stuck, free = [], [], _movable(problem, robots)
    tried = 0
    for tried, robot in enumerate(free, start=1):
        try:
            placement = place(_without(problem, robot), gap=gap)
            found.append(Relocation(robot, placement, before, swarm))
        except NowhereToAttach:
            stuck.append(robot.name)
        if progress is not None and progress(tried) and found:
            break
    if not found:
        raise NowhereToAttach("none of the robots that may move has anywhere to go")
    ranked = sorted(found, key=lambda move: -move.quality)
    untried = tuple(robot.name for robot in free[tried:])
    return Move(problem, before, tuple(ranked), tuple(stuck), untried)


def _movable(problem: Problem, names: str | Iterable[str] | None) -> list[Robot]:
    """Return the robots that may move."""
    swarm = problem.swarm
    if names is None:
        free = [
            robot
            for robot in swarm
            if not (robot.mounted or _fails_with_others(problem, robot)) and _can_be_placed(robot)
        ]
        if not free:
            raise RobotInvalid(
                "there is no robot that could move: each is mounted, fails with others as one of a "
                "group, or is of a kind that a newcomer cannot be"
            )
        return [robot for robot in free if not _is_worthless(problem, robot)] or free
    wanted, faults = [swarm[name] for name in swarm.known(names)], []
    for robot in wanted:
        if robot.mounted:
            faults.append(f"{robot.name} is mounted and stays where it is")
        elif _fails_with_others(problem, robot):
            faults.append(
                f"{robot.name}: where a robot should go that fails with others, as one of a group "
                "or by name, is not known how to find; ask without losses and failures"
            )
        elif not _can_be_placed(robot):
            faults.append(
                f"{robot.name}: where a robot with a least force, with an envelope, or that "
                "steers both ways or beyond a right angle should go is not known how to find"
            )
        elif _is_worthless(problem, robot):
            faults.append(f"{robot.name} may be absent, and is worth nothing anywhere")
    if not wanted:
        faults.append("no robot may move; give at least one name")
    if faults:
        raise RobotInvalid(faults)
    return wanted


def _is_worthless(problem: Problem, robot: Robot) -> bool:
    """Tell whether a robot counts for nothing in the worst case."""
    tolerance = robot.tolerance
    return problem.criterion.worst_case and tolerance is not None and tolerance.may_be_absent


def _fails_with_others(problem: Problem, robot: Robot) -> bool:
    """Tell whether the criterion loses a robot with its group, or by name."""
    criterion = problem.criterion
    named = {name for failure in criterion.failures for name in failure}
    return bool(robot.group and criterion.losing) or bool({robot.name, robot.group} & named)


def _can_be_placed(robot: Robot) -> bool:
    """Tell whether a newcomer may be like a robot."""
    if robot.envelope or robot.least or (robot.steers and robot.reverse_limit):
        return False
    return robot.steers <= RIGHT_ANGLE or robot.steers >= math.pi


def newcomer_like(problem: Problem, robot: Robot) -> Newcomer:
    """Return a robot that is in contact as a newcomer, attached as the problem's newcomer is."""
    outline, asked = problem.swarm.outline, problem.newcomer
    attachment, half_angle = asked.attachment, asked.half_angle
    if robot.friction:
        attachment, half_angle = "push", None
    elif robot.steers >= math.pi:
        attachment, half_angle = "free", None
    elif robot.steers:
        if attachment == "free":
            inward = outline.inward_normal(outline.at_point(robot.contact).edge)
            attachment = "push" if math.cos(robot.direction - inward) > 0.0 else "pull"
        half_angle = robot.steers
    return Newcomer(
        robot.limit, attachment, half_angle, robot.name, robot.tolerance,
        robot.steers > 0.0, robot.reverse_limit, robot.friction, body=robot.body,
    )  # fmt: skip


def _without(problem: Problem, robot: Robot) -> Problem:
    """Return the question where a robot goes that has let go."""
    swarm = problem.swarm.without(robot.name)
    return replace(problem, swarm=swarm, newcomer=newcomer_like(problem, robot))
