"""Max-Transfer quality: the largest ball, or task, of wrenches a swarm can make (T1, T2, T16)."""

from dataclasses import dataclass, field
from enum import StrEnum
from functools import cached_property
from typing import Any, Unpack

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Answer, picked, plain
from swarmgrasp.quality.aim import Aim
from swarmgrasp.quality.changing import changing_bounds
from swarmgrasp.quality.criterion import Criterion, Keywords, criterion_of
from swarmgrasp.quality.explain import explain_quality
from swarmgrasp.quality.heights import ON_FACET
from swarmgrasp.quality.margin import Margin, missed
from swarmgrasp.quality.mean_reach import mean_reach
from swarmgrasp.quality.opposed import is_opposed
from swarmgrasp.quality.robot_sets import RobotSets
from swarmgrasp.quality.task_margin import around_task
from swarmgrasp.quality.weakest import Weakest, bounded_weakest
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.choices import Asked, Choice, Choices, Taken
from swarmgrasp.swarm.swarm import check_swarm


class ForceClosure(StrEnum):
    """Whether the swarm can resist a disturbance in every direction."""

    YES = "yes"
    NO = "no"
    MARGINAL = "marginal"
    """Rounding in the outline's coordinates decides: see `Outline.precision`."""
    OPEN = "open"
    """No choice of one sector for each robot has it, and with the gaps filled they do (T28)."""


@dataclass(frozen=True, eq=False)
class Quality(Frozen, Answer):
    """The quality of a swarm by a criterion, and what limits it.

    If robots have sectors with gaps between, the value and what limits it are of the swarm that
    keeps the best choice of one sector for each. As robots may change between sectors from wrench
    to wrench, its quality is more: it lies between `bound` and `upper_bound` (T28).

    Attributes
    ----------
    value : float [N]
        Radius of the largest ball in the wrench set, in the metric; with a task the largest
        factor by which it may grow, without a unit.
    bound : float [N]
        What the quality is at least: the value itself, or next to it with uncertain poses; less if
        the search ran out of its budget of work. Of robots that change between sectors it is more.
    upper_bound : float [N]
        What it is at most: the value itself; with gaps between sectors, no more than the quality
        with these filled.
    direction : (3,)
        Unit normal of the weakest facet, in the metric's coordinates; of a load that is missed,
        the way in which it is missed most.
    criterion : Criterion
    choice : Choice, optional
        The sectors kept, if robots have sectors with gaps between.
    """

    value: float
    bound: float
    upper_bound: float
    direction: NDArray[np.float64]
    criterion: Criterion
    choice: Choice | None
    _swarm: Swarm = field(repr=False)
    _held: Swarm = field(repr=False)
    """The same swarm, or as it is with the sectors kept."""
    _missed: Margin | None = field(repr=False)
    """By how much it misses the load, if it does and there is no task."""

    kind = "quality"

    @property
    def weakest_wrench(self) -> NDArray[np.float64]:
        """(3,) [N, N, N m]: the smallest wrench on the boundary, where ball or task touches it."""
        scale, task = self._held.scale, self.criterion.task
        if task is None:
            return self.value * self.direction / scale
        return self.value * task.farthest(self.direction * scale)

    @property
    def margin(self) -> float:
        """How far the swarm reaches beyond the load, or falls short of it [N] (T34).

        Signed and continuous: the value where the load is held. Where it is missed, minus the
        distance in the metric from holding it, after the worst loss and failure and in the worst
        poses. Without a load it is at least 0, but for robots that always exert a least force.

        With a task it is of all of it, once: 0 or more where the value is at least 1, and then how
        far all wrenches of the task lie within reach; otherwise minus the distance of the wrench of
        it that is farthest out of reach.
        """
        return self._about.value

    @property
    def missing(self) -> NDArray[np.float64]:
        """(3,) [N, N, N m]: what would have to be exerted beyond what the robots can.

        Beside the load, and in the worst case; its size in the metric is minus the margin, and it
        is 0 where nothing is missed.
        """
        size = max(0.0, -self.margin)
        return size * np.array(self._about.normal) / self._held.scale + 0.0

    @property
    def weakest_words(self) -> str:
        """How the weakest wrench would move the object."""
        return self.criterion.weakest_words(self._held, self.direction)

    @cached_property
    def lost(self) -> tuple[str, ...]:
        """Names of the robots and groups whose loss hurts most, the worst first."""
        groups = self._held.rare.groups
        rows = self._aim.lost_at(self._normal) if self.criterion.losing else ()
        return tuple(dict.fromkeys(groups.get(i) or self._held.names[i] for i in rows))

    @property
    def swarm(self) -> Swarm:
        """The swarm it is of."""
        return self._swarm

    @cached_property
    def failure(self) -> tuple[str, ...]:
        """The worst of the criterion's failures: the names that it takes."""
        worst = self._aim.failure_at(self._normal)
        return () if worst is None else tuple(self.criterion.failures[worst])

    @cached_property
    def gone(self) -> tuple[str, ...]:
        """Names of the robots that are not there in the worst case: lost, failing, or absent."""
        return tuple(self._held.names[i] for i in sorted(self._aim.gone_at(self._normal)))

    @cached_property
    def worst_swarm(self) -> Swarm:
        """The swarm in the worst case: without the robots lost, and in the worst poses."""
        return self._aim.worst_swarm(self._normal)

    @cached_property
    def facet_robots(self) -> tuple[str, ...]:
        """Names of the robots whose generators span that facet, in their worst poses.

        Of force sets: those whose best force changes there.
        """
        if isinstance(self._aim.robots, RobotSets):
            setters = self._aim.robots.setters(self._normal)
            return tuple(self._held.names[i] for i in setters)
        generators = self._held.scaled_generators
        if self.criterion.worst_case:
            generators = self._aim.worst_wrenches(self._normal)
        sizes = _sizes(generators)
        facet = (sizes > 0.0) & (np.abs(generators @ self.direction) <= ON_FACET * sizes)
        return tuple(self._held.names[i] for i in np.flatnonzero(facet).tolist())

    @property
    def noise(self) -> float:
        """By how much rounding in the outline's coordinates may change the value [N] (T4)."""
        return self.criterion.noise(self._held, self.direction)

    @cached_property
    def force_closure(self) -> ForceClosure:
        """Whether the swarm, in the worst case, can resist a disturbance in every direction."""
        if self.criterion.task is not None or self.criterion.has_load:
            keywords = self.criterion.keywords | {"load": (0.0, 0.0, 0.0), "task": None}
            return quality(self._swarm, **keywords).force_closure
        most = max(self.value, self.bound)
        if most > 0.0:
            return ForceClosure.YES if most > self.noise else ForceClosure.MARGINAL
        if self.upper_bound > 0.0:
            return ForceClosure.OPEN
        if self.choice is not None:
            return ForceClosure.MARGINAL if self.noise else ForceClosure.NO
        swarm = self._held if self.criterion.is_nominal else self.worst_swarm
        return ForceClosure.NO if is_opposed(swarm) else ForceClosure.MARGINAL

    @property
    def is_force_closure(self) -> bool:
        """Whether force closure is certain."""
        return self.force_closure is ForceClosure.YES

    @cached_property
    def ceiling(self) -> float:
        """How far the robots push on average over all directions [N]; nan for a task.

        Weighted by the metric; of rays it is the sum of the limits / pi. No robots with these
        forces exceed it, wherever they are (T3).
        """
        return float("nan") if self.criterion.task is not None else mean_reach(self._swarm.filled)

    @property
    def efficiency(self) -> float:
        """Quality as a share of its ceiling, within [0, 1]; nan for a task."""
        return max(self.value, self.bound) / self.ceiling if self.ceiling != 0.0 else 0.0

    @property
    def explanation(self) -> str:
        """What the swarm can do, what limits it and who sets that, a sentence per line."""
        return explain_quality(self, self._held)

    @property
    def metric(self) -> str:
        """The metric in words."""
        return self._held.metric_sentence

    def to_data(self) -> dict[str, Any]:
        """Return the swarm, the criterion and what limits the quality as plain data."""
        swarm = self._swarm
        return {
            "swarm": swarm.to_data(),
            **picked(
                self, "criterion", "value", "bound", "upper_bound", "margin", "missing", "choice",
                "noise",
                "force_closure", "direction",
                "weakest_wrench", "ceiling", "efficiency", "explanation", "facet_robots", "lost",
                "failure",
            ),
            "worst_robots": plain(self.worst_swarm.robots),
        }  # fmt: skip

    @property
    def _normal(self) -> tuple[float, float, float]:
        """The direction as numbers."""
        x, y, z = self.direction.tolist()
        return x, y, z

    @cached_property
    def _about(self) -> Margin:
        """The margin, and the way in which it is least."""
        task = self.criterion.task
        if task is None:
            return self._missed or Margin(self.value, self._normal)
        scale, keywords = self._held.scale, self.criterion.keywords | {"task": None}
        load = np.array(self.criterion.load) * scale

        def at(wrench: NDArray[np.float64]) -> Margin:
            """Return the margin of one wrench (3,) [N] of the task."""
            x, y, turn = ((load - wrench) / scale).tolist()
            found = quality(self._held, **keywords | {"load": (x, y, turn)})
            return Margin(found.margin, found._normal)

        return around_task(task, scale, at)

    @cached_property
    def _aim(self) -> Aim:
        """The criterion in the kernels' terms."""
        return Aim(self._held, self.criterion)


def quality(swarm: Swarm, **keywords: Unpack[Keywords]) -> Quality:
    """Compute the Max-Transfer quality of a swarm, exactly.

    The least support function over all facet normals +-(b_j x b_k) (T2): by sweeping all
    planes across a robot for up to 48 robots (T11), then by branch and bound on the sphere of
    directions, at about the cost of sorting the robots by direction (T12). The same branch and
    bound serves the criteria: the worst loss of some robots (T15), a load and a task (T16) are as
    exact, and the worst of uncertain poses (T14) is certified to 1e-7 of the value.

    Robots that steer, reverse or have other sets of forces take a search of their own (T21). It is
    exact where sets have corners only, and certified to 1e-9 of the value, or to 1e-7 where the
    weakest directions are a whole curve; groups and named failures are as exact (T25).

    Of robots whose sectors have gaps between it is known to lie between two bounds (T28): what the
    swarm has that keeps the best choice of one sector for each, and what it has with the gaps
    filled. Up to 4096 choices, whole and in part, are asked for; those that cannot be best are not.
    As things stand, and for up to 256 choices, the bounds are those of robots that change between
    sectors, within 1 % of each other where the work suffices.

    Parameters
    ----------
    swarm : Swarm
        Of any size, degenerate or not; below 4 robots that push along one ray each it is 0.
    losing, worst_case, load, task, failures
        As for `Criterion`: what is asked beyond the nominal quality.

    Returns
    -------
    Quality

    Raises
    ------
    SwarmInvalid
        If it is no `Swarm`.
    CriterionInvalid
        If a term is outside its range.

    Examples
    --------
    Four unit robots pull a square with lever arm 0.4: 2 t / sqrt(1 + 2 t^2).

    >>> from math import pi
    >>> from swarmgrasp import Outline, Robot, Swarm
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> pulls = [((1, -0.4), 0), ((-1, 0.4), pi), ((-0.4, 1), pi / 2), ((0.4, -1), -pi / 2)]
    >>> grasp = Swarm(square, [Robot(c, a) for c, a in pulls], characteristic_length=1.0)
    >>> answer = quality(grasp)
    >>> round(answer.value, 6), str(answer.force_closure), round(answer.efficiency, 3)
    (0.696311, 'yes', 0.547)

    It needs all four of them:

    >>> answer = quality(grasp, losing=1)
    >>> answer.value, str(answer.force_closure), len(answer.worst_swarm)
    (0.0, 'no', 3)
    """
    check_swarm(swarm)
    criterion = criterion_of("quality", keywords)
    held, choice, most = swarm, None, None
    if swarm.rare.gaps:
        held, choice, most = best_choice(swarm, criterion)
    found, bound = _weakest(held, criterion)
    beyond = _beyond(held, criterion, found)
    if beyond is not None and beyond.value < 0.0:
        found = found._replace(normal=beyond.normal)
    upper_bound = found.quality
    if most is not None:
        least, most = changing_bounds(swarm, most) if criterion.is_nominal else (0.0, most)
        bound, upper_bound = max(bound, least), max(most, found.quality)
    return Quality(
        found.quality, bound, upper_bound, np.array(found.normal), criterion, choice, swarm, held,
        beyond,
    )  # fmt: skip


def best_choice(swarm: Swarm, criterion: Criterion) -> tuple[Swarm, Choice, float]:
    """Find the choice of one sector for each robot with gaps that has the best quality (T28).

    Returns
    -------
    swarm : Swarm
        With the sectors of that choice.
    choice : Choice
    upper_bound : float [N]
        The quality with all gaps filled.
    """
    choices = Choices(swarm)

    def ask(taken: Taken) -> Asked:
        """Return the quality that no choice exceeds that agrees with one."""
        left = choices.swarm(taken)
        found, _ = _weakest(left, criterion)
        beyond = _beyond(left, criterion, found)
        margin = found.quality if beyond is None else beyond.value
        return Asked((-margin,), choices.first_open(taken), found.quality)

    found = choices.least(ask)
    most = float(ask(choices.none).what)
    return choices.swarm(found.taken), choices.told(found.taken, found.is_best), most


def _weakest(swarm: Swarm, criterion: Criterion) -> tuple[Weakest, float]:
    """Find the weakest normal, and what the quality is at least."""
    if criterion.is_nominal and swarm.has_rays_only:
        return bounded_weakest(swarm.scaled_generators)
    return Aim(swarm, criterion).weakest()


def _beyond(swarm: Swarm, criterion: Criterion, found: Weakest) -> Margin | None:
    """Return by how much a load is missed, if there is no quality; None where it is held."""
    may_rest = swarm.has_rays_only and not criterion.has_load
    if found.quality > 0.0 or criterion.task is not None or may_rest:
        return None
    return missed(swarm, criterion)


def _sizes(generators: NDArray[np.float64]) -> NDArray[np.float64]:
    """(n,) [N]: |b_i|."""
    return np.asarray(np.sqrt(np.einsum("ij,ij->i", generators, generators)))
