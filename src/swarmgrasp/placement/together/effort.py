"""How long a search for several newcomers goes on: counted in steps, not by a clock.

The same steps are taken on every machine, so that the same question has the same answer.
"""

from dataclasses import dataclass, field

from swarmgrasp.ranges import is_whole, shown

EFFORT = 5000
"""Steps of a search unless told otherwise: some seconds for a dozen newcomers."""
MOST = 10**9
"""Steps of any search."""


def effort_faults(effort: object) -> list[str]:
    """Return what is wrong with a number of steps."""
    if is_whole(effort) and 0 <= effort <= MOST:
        return []
    return [f"the effort is {shown(effort)}; it should be a whole number of steps from 0 to {MOST}"]


@dataclass(eq=False)
class Budget:
    """Steps that a search may still take.

    Each linear program is a step, and so is each newcomer placed exactly beside the others.

    Attributes
    ----------
    left : int
        Below 0 if it was overdrawn by what must be done in any case.
    asked : int
        How many there were at first.
    """

    left: int
    asked: int = field(init=False)

    def __post_init__(self) -> None:
        """Keep how many there are."""
        self.asked = self.left

    @property
    def is_spent(self) -> bool:
        """Whether no step is left."""
        return self.left <= 0

    def stop(self) -> None:
        """Leave no step."""
        self.left = min(self.left, 0)

    def spend(self, steps: int = 1) -> None:
        """Take a step, or several."""
        self.left -= steps
