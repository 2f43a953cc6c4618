"""Fig. 4 and Fig. 5 in kind: the quality before and after the best newcomer, over many draws."""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.pages.runner import Runner
from swarmgrasp.pages.statements import Statement, median, newtons, percent
from swarmgrasp.paper.draws import FREE, NEWCOMERS, NORMAL, Task, pulling, tasks
from swarmgrasp.paper.published import Example
from swarmgrasp.paper.sizes import ROBOTS
from swarmgrasp.placement import place

Array = NDArray[np.float64]

GAP = 1e-6
"""Relative gap that every placement is proven to."""
SAME = 1e-9
"""Relative difference of two qualities that counts as none."""
NEAR = 0.1
"""How far the quality before of the draw shown may be from the paper's [N]."""
BESIDE = 10
"""Draws that the paper's gain is compared with: those nearest to it before."""


class Gain(NamedTuple):
    """One draw: the quality before, and with the best newcomer of each kind.

    Attributes
    ----------
    before : float [N]
    after : tuple of float [N]
        For each kind in `NEWCOMERS`.
    helps : tuple of bool
        Whether that newcomer raises the quality.
    opposite : float [N]
        h opposite to the weakest direction: with the quality itself there, nobody can help.
    proven : bool
        Whether both placements came with their proof.
    """

    before: float
    after: tuple[float, ...]
    helps: tuple[bool, ...]
    opposite: float
    proven: bool


@dataclass(frozen=True, eq=False)
class Gains:
    """All draws of one number of robots.

    Attributes
    ----------
    draws : list of Task
    before, opposite : (k,) [N]
    after : dict of str to (k,) [N]
        By kind of newcomer.
    helps : dict of str to (k,) of bool
    proven : bool
        Whether every placement came with its proof.
    """

    draws: list[Task]
    before: Array
    opposite: Array
    after: dict[str, Array]
    helps: dict[str, NDArray[np.bool_]]
    proven: bool

    @property
    def robots(self) -> int:
        """How many were there before."""
        return self.draws[0][1]

    def shown(self, example: Example) -> int:
        """Return the draw nearest to an example before, and of equals nearest after."""
        apart = np.abs(self.before - example.before)
        equal = np.flatnonzero(apart <= apart.min() + SAME)
        after = np.abs(self.after[NORMAL][equal] - example.after)
        return int(equal[after.argmin()])


def gain_of(task: Task) -> Gain:
    """Place a newcomer of each kind in a draw."""
    swarm = pulling(task)
    answers = [place(swarm, newcomer, gap=GAP) for newcomer in NEWCOMERS.values()]
    return Gain(
        answers[0].quality_before,
        tuple(answer.quality for answer in answers),
        tuple(answer.improves for answer in answers),
        answers[0].opposite,
        not any(answer.stopped_early for answer in answers),
    )


def measure(runner: Runner, seed: int, count: int) -> dict[int, Gains]:
    """Measure the gains of all numbers of robots."""
    return {n: _gains(runner, tasks(seed, n, count)) for n in ROBOTS}


def _gains(runner: Runner, draws: list[Task]) -> Gains:
    """Measure those of one number of robots."""
    found = runner.map(gain_of, draws)
    after = np.array([one.after for one in found])
    helps = np.array([one.helps for one in found])
    return Gains(
        draws,
        np.array([one.before for one in found]),
        np.array([one.opposite for one in found]),
        {kind: after[:, k] for k, kind in enumerate(NEWCOMERS)},
        {kind: helps[:, k] for k, kind in enumerate(NEWCOMERS)},
        all(one.proven for one in found),
    )


def statements(found: Gains, example: Example) -> list[Statement]:
    """State how the draws compare with one of the paper's examples."""
    before, after = found.before, found.after[NORMAL]
    own = _before_nothing if example.before == 0.0 else _before_something
    k = found.shown(example)
    gain, theirs = after[k] - before[k], example.after - example.before
    return [
        *own(found, example),
        Statement(
            f"The draw shown goes from {newtons(before[k])} to {newtons(after[k])}, a gain of "
            f"{newtons(gain)}; the paper's goes from {newtons(example.before)} to "
            f"{newtons(example.after)}, a gain of {newtons(theirs)}.",
            abs(before[k] - example.before) <= NEAR,
            rests_on=("T1", "T2"),
        ),
        Statement(
            f"A newcomer that may push in any direction does better than the best along the normal "
            f"on {percent(float(np.mean(found.after[FREE] > after * (1.0 + 1e-3))))} of the draws, "
            "and worse on none.",
            bool((found.after[FREE] >= after * (1.0 - 2.0 * GAP)).all()),
            rests_on=("T8",),
        ),
        Statement(
            f"All {2 * len(before)} placements behind this picture come with a proof that no "
            f"robot does better by more than {GAP:.0e} of the quality.",
            found.proven,
            rests_on=("T10",),
        ),
    ]


def _before_nothing(found: Gains, example: Example) -> list[Statement]:
    """State what a newcomer does for those that do not hold the object."""
    none = found.before == 0.0
    after = found.after[NORMAL][none]
    helped = after[after > 0.0]
    below = float(np.mean(helped < example.after)) if len(helped) else 0.0
    return [
        Statement(
            f"Most draws of {found.robots} robots do not hold the object, as in the paper: "
            f"{percent(float(np.mean(none)))} of {len(none)} have quality 0.",
            bool(np.mean(none) > 0.5),
            rests_on=("T2",),
        ),
        Statement(
            f"Of these, a newcomer along the normal brings {percent(len(helped) / len(after))} to "
            f"force closure, with a median quality of {newtons(median(helped))}. The paper's "
            f"{newtons(example.after)} is nothing unusual: {percent(below)} of them stay below.",
            0.05 < below < 0.95,
            rests_on=("T9",),
        ),
    ]


def _before_something(found: Gains, example: Example) -> list[Statement]:
    """State how unusual the example's quality before is, and its gain beside such draws."""
    before, after = found.before, found.after[NORMAL]
    reach = float(np.mean(before >= example.before))
    near = np.argsort(np.abs(before - example.before))[:BESIDE]
    gains = (after - before)[near]
    low, high = before[near].min(), before[near].max()
    return [
        Statement(
            f"Few draws hold this rectangle as well as the paper's {found.robots} robots hold "
            f"theirs: {percent(reach)} of {len(before)} reach {newtons(example.before)}. The "
            f"median is {newtons(median(before))}.",
            reach < 0.25,
            rests_on=("T2",),
        ),
        Statement(
            f"On the {len(gains)} draws nearest to that, which have {newtons(low)} to "
            f"{newtons(high)}, the best newcomer along the normal gains {newtons(gains.min())} to "
            f"{newtons(gains.max())}; the paper's gained "
            f"{newtons(example.after - example.before)}.",
            bool(gains.min() <= example.after - example.before <= gains.max()),
            rests_on=("T9",),
        ),
    ]
