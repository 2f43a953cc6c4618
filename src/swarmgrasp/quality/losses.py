"""What becomes of a swarm that loses a robot, for each of them (T15)."""

from dataclasses import dataclass
from typing import Any, Unpack

from swarmgrasp.frozen import Frozen
from swarmgrasp.plain import Told, picked
from swarmgrasp.quality.criterion import Keywords, criterion_of
from swarmgrasp.quality.max_transfer import ForceClosure, Quality, quality
from swarmgrasp.swarm import Swarm
from swarmgrasp.swarm.swarm import check_swarm


@dataclass(frozen=True, eq=False)
class Loss(Frozen, Told):
    """What the loss of one robot, or of one group, leaves.

    Attributes
    ----------
    name : str
        Of the robot or the group.
    quality_before : float [N]
        With it; with a task, without a unit.
    after : Quality
        Of the swarm without it.
    """

    name: str
    quality_before: float
    after: Quality

    def to_data(self) -> dict[str, Any]:
        """Return what the loss leaves as plain data."""
        return picked(self, "name", "quality", "is_vital", "direction_words")

    @property
    def quality(self) -> float:
        """Quality without it [N]."""
        return self.after.value

    @property
    def is_vital(self) -> bool:
        """Whether force closure goes with it."""
        return self.after.force_closure is not ForceClosure.YES

    @property
    def direction_words(self) -> str:
        """The weakest direction without it, in words."""
        return self.after.weakest_words

    @property
    def words(self) -> str:
        """What the loss means, in words."""
        lost = self.direction_words
        if self.quality > 0.0:
            return f"leaves {self.quality / self.quality_before:.0%}; weakest is then {lost}"
        return f"leaves nothing to exert in some directions, such as {lost}"


def losses(swarm: Swarm, **keywords: Unpack[Keywords]) -> tuple[Loss, ...]:
    """Tell for each robot what its loss would leave, the worst first; a group is lost as one.

    Parameters
    ----------
    swarm : Swarm
    losing, worst_case, load, task, failures
        As for `Criterion`; `losing` robots are lost beside each.

    Raises
    ------
    SwarmInvalid
        If it is no `Swarm`.
    CriterionInvalid
        If a term is outside its range.

    Examples
    --------
    >>> from math import pi
    >>> from swarmgrasp import Outline, Robot, Swarm
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> pulls = [((1, -0.4), 0), ((-1, 0.4), pi), ((-0.4, 1), pi / 2), ((0.4, -1), -pi / 2)]
    >>> crew = [Robot(c, a) for c, a in pulls] + [Robot((1, 0.4), 0)]
    >>> worst, *_, least = losses(Swarm(square, crew, characteristic_length=1.0))
    >>> worst.quality, least.name, round(least.quality, 4)
    (0.0, 'R5', 0.6963)
    """
    check_swarm(swarm)
    criterion_of("losses", keywords)
    before = quality(swarm, **keywords).value
    machines: dict[str | int, list[int]] = {}
    for i in range(len(swarm)):
        machines.setdefault(swarm.rare.groups.get(i) or i, []).append(i)
    found = [
        Loss(name if isinstance(name, str) else swarm.names[name], before, after)
        for name, rows in machines.items()
        for after in [_after(swarm, rows, keywords)]
    ]
    return tuple(sorted(found, key=lambda loss: loss.quality))


def _after(swarm: Swarm, rows: list[int], keywords: Keywords) -> Quality:
    """Compute the quality without the robots in some rows; failures take those of them left."""
    left = swarm.without_rows(rows)
    known = {*left.names, *left.groups}
    named = [
        [name for name in failure if name in known] for failure in keywords.get("failures", ())
    ]
    failures = tuple(tuple(names) for names in named if names)
    beside = keywords.copy()
    beside["failures"] = failures
    return quality(left, **beside)
