"""What is asked of a swarm: more than its quality as it stands."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypedDict, get_args

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import CriterionInvalid
from swarmgrasp.plain import Plain
from swarmgrasp.quality.task import Task
from swarmgrasp.ranges import STRONGEST, flag_faults, is_whole, items, nearest_name, numbers, shown
from swarmgrasp.swarm import Swarm
from swarmgrasp.words import TIMES, Unit, list_words, machine_words, wrench_words

MOST_LOST = 10**9
"""Robots that may be lost; all there are, if that is more."""


Load = Sequence[float] | NDArray[np.float64]
"""A wrench [N, N, N m], kept as three floats."""


class Keywords(TypedDict, total=False):
    """The parts of a criterion, as keywords."""

    losing: int
    worst_case: bool
    load: Load
    task: Task | None
    failures: Sequence[Sequence[str]]


@dataclass(frozen=True)
class Criterion(Plain):
    """What quality means: how much of a task is left in the worst of cases.

    Quality is min over n of H(n) / D(n), where H adds up what each robot certainly contributes
    along n, without the `losing` largest contributions, and the load's part n . w0; D is the
    support function of the task (T14, T15, T16).

    Attributes
    ----------
    losing : int
        After the worst loss of so many robots; those of one group are lost as one.
    worst_case : bool
        In the worst poses that the robots' tolerances allow.
    load : (3,) [N, N, N m]
        A steady wrench that the surroundings exert on the object, such as wind and current,
        about the outline's origin: the margin left around it.
    task : Polytope or Ellipsoid, optional
        Quality is the largest factor by which the task may grow, without a unit. When left out,
        the task is the metric's unit ball, and quality is in newtons.
    failures : sequence of sequence of str
        After the worst of these failures: each takes robots and groups, by name, before any loss.

    Raises
    ------
    CriterionInvalid
        If a value is outside its range; all faults at once.
    """

    losing: int = 0
    worst_case: bool = False
    load: Load = (0.0, 0.0, 0.0)
    task: Task | None = None
    failures: Sequence[Sequence[str]] = ()

    def __post_init__(self) -> None:
        """Check the values."""
        faults = []
        if not is_whole(self.losing) or not 0 <= self.losing <= MOST_LOST:
            faults.append(
                f"the number of robots to lose is {shown(self.losing)}; it should be a "
                f"whole number, 0 <= number <= {MOST_LOST}"
            )
        faults += flag_faults(self.worst_case, "worst_case")
        load = numbers(self.load)
        if len(load) != 3 or max(map(abs, load)) > STRONGEST:
            faults.append(
                f"the load is {shown(self.load)}; it should be three numbers of size <= "
                f"{STRONGEST:g} [N, N, N m]"
            )
        if self.task is not None and not isinstance(self.task, get_args(Task)):
            faults.append(
                f"the task is {shown(self.task)}; it should be a Polytope or an Ellipsoid"
            )
        named = items(self.failures)
        failures = tuple(items(failure) or () for failure in named or ())
        if named is None or not all(
            failure and all(isinstance(name, str) and name for name in failure)
            for failure in failures
        ):
            faults.append(
                f"the failures are {shown(self.failures)}; each should be a list of names of "
                'robots and groups, such as [["bus A"], ["R1", "R2"]]'
            )
        if faults:
            raise CriterionInvalid(faults)
        vars(self).update(
            losing=int(self.losing), worst_case=bool(self.worst_case), load=load, failures=failures
        )

    @property
    def keywords(self) -> Keywords:
        """The criterion as the keywords of `quality` and `place`."""
        return Keywords(
            losing=self.losing, worst_case=self.worst_case, load=self.load, task=self.task,
            failures=self.failures,
        )  # fmt: skip

    @property
    def is_nominal(self) -> bool:
        """Whether this is the quality of the swarm as it stands."""
        return self is NOMINAL or self == NOMINAL

    @property
    def is_of_worst(self) -> bool:
        """Whether robots are lost or fail, or their poses are the worst."""
        return bool(self.losing or self.failures or self.worst_case)

    @property
    def has_load(self) -> bool:
        """Whether there is a load."""
        return self.load != (0.0, 0.0, 0.0)

    def noise(self, swarm: Swarm, normal: ArrayLike) -> float:
        """Bound what rounding in the outline's coordinates may change of a quality (T4).

        Parameters
        ----------
        swarm : Swarm
        normal : (3,)
            The unit normal where the quality is attained, in the metric's coordinates.

        Returns
        -------
        float [N]
            Relative to the task, if there is one.
        """
        if self.task is None:
            return swarm.noise
        (asked,) = self.task.support([np.asarray(normal) * swarm.scale])
        return float(swarm.noise / asked) if asked > 0.0 else 0.0

    def fewest(self, rays_only: bool) -> int:
        """Return the robots, those lost included, below which the quality is 0 wherever they are.

        Force closure takes 4 rays; beside a load the wrenches of 3 can surround no wrench; a task
        may ask for one way only. Robots that steer or reverse have flat sets of wrenches: 2 of them
        may close a grasp.

        Parameters
        ----------
        rays_only : bool
            Whether all robots push along one ray each.
        """
        if self.task is not None:
            return self.losing + 1
        return self.losing + (2 if not rays_only else 3 if self.has_load else 4)

    def unit(self, *sizes: float, figures: int = 5) -> Unit:
        """Return the unit to tell qualities of some sizes [N] in; times the task, if there is one.

        Examples
        --------
        >>> NOMINAL.unit(2e3).text(2e3)
        '2.0000 kN'
        """
        if self.task is None:
            return Unit.for_size(*sizes, figures=figures)
        return Unit(1.0, TIMES, figures)

    def weakest_words(self, swarm: Swarm, normal: ArrayLike) -> str:
        """Say which wrench a swarm reaches least, where a facet with this normal limits it.

        That along the normal; of a task the wrench of it that lies farthest along the normal.

        Parameters
        ----------
        swarm : Swarm
        normal : (3,)
            In the metric's coordinates.
        """
        way = np.asarray(normal, dtype=float)
        if self.task is not None and self.task.support(way * swarm.scale) > 0.0:
            way = self.task.farthest(way * swarm.scale) * swarm.scale
        return wrench_words(way)

    def words(self, swarm: Swarm, robot: str = "robot") -> str:
        """Say beside what and after what, as part of a sentence; nothing as things stand.

        A task goes unmentioned: it is in the unit of the quality.

        Parameters
        ----------
        swarm : Swarm
            Whose robots are lost, or groups, if it has any.
        robot : str
            What one is called.

        Examples
        --------
        >>> from swarmgrasp import Outline, Robot, Swarm
        >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        >>> asked = Criterion(losing=1, load=(0.0, -20e3, 0.0))
        >>> asked.words(Swarm(square, [Robot((1, 0), 3.0)]))
        'after the worst loss of 1 robot, beside the load'
        >>> asked.words(Swarm(square, [Robot((1, 0), 3.0, group="bus A")]))
        'after the worst loss of 1 robot or group, beside the load'
        """
        parts = []
        if self.worst_case:
            parts.append("in the worst poses")
        if self.failures:
            parts.append(
                f"after the failure of {list_words(self.failures[0])}"
                if len(self.failures) == 1
                else f"after the worst of {len(self.failures)} failures"
            )
        if self.losing:
            lost = machine_words(self.losing, bool(swarm.rare.groups), robot)
            parts.append(f"after the worst loss of {self.losing} {lost}")
        if self.has_load:
            parts.append("beside the load")
        return ", ".join(parts)


NOMINAL = Criterion()


def criterion_of(asker: str, keywords: Keywords) -> Criterion:
    """Return the criterion of the keywords that a function was given.

    Raises
    ------
    TypeError
        If a keyword is no part of a criterion; it names the function.

    Examples
    --------
    >>> criterion_of("quality", {"loosing": 1})
    Traceback (most recent call last):
    ...
    TypeError: quality() got an unexpected keyword argument 'loosing'; did you mean 'losing'?
    """
    for name in keywords:
        if name not in Keywords.__annotations__:
            near = nearest_name(name, list(Keywords.__annotations__))
            raise TypeError(f"{asker}() got an unexpected keyword argument {name!r}{near}")
    return Criterion(**keywords) if keywords else NOMINAL


"""The quality of a swarm as it stands, alone, in newtons."""
