"""What a scenario file comes down to, in SI units."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from swarmgrasp.environment import Environment
from swarmgrasp.errors import FileFault
from swarmgrasp.frozen import Frozen
from swarmgrasp.outline import Stretch
from swarmgrasp.placement import Problem
from swarmgrasp.quality.criterion import NOMINAL, Criterion
from swarmgrasp.swarm import Newcomer, Swarm, Zone
from swarmgrasp.terms import SI, Terms
from swarmgrasp.visible import Visible

if TYPE_CHECKING:
    from swarmgrasp.simulation.simulation import Simulation


@dataclass(frozen=True, eq=False)
class Scenario(Frozen, Visible):
    """What is asked: who holds the object, who comes next, and where it may attach.

    Attributes
    ----------
    name : str
        A title; the file's own name when the file gives none.
    description : str
        Free text, possibly empty.
    swarm : Swarm
        The object, the metric and the robots already in contact, perhaps none.
    newcomer : Newcomer or None
        The robot to place.
    zones : sequence of Zone or None
        Where a newcomer may attach; None means the whole boundary.
    no_go : sequence of Stretch
        Stretches of the boundary no newcomer may use.
    spacing : float [m]
        Least distance of a newcomer from the robots already there.
    environment : Environment or None
        Wind and current.
    criterion : Criterion
        What quality means; nominal when the file does not say.
    simulation : Simulation or None
        What becomes of all this in time.
    terms : Terms
        The units and the frame of its file, and its word for robots; all else is in SI and ours.
        Equal scenarios ask the same, whatever their terms.
    slips : tuple of FileFault
        What its file says that is probably a slip, each with line, column and key.
    answer : dict or None
        The answer file that asks all this, as plain data, if it was read from one.
    """

    name: str
    description: str
    swarm: Swarm
    newcomer: Newcomer | None
    zones: Sequence[Zone] | None
    no_go: Sequence[Stretch]
    spacing: float
    environment: Environment | None = None
    criterion: Criterion = NOMINAL
    simulation: "Simulation | None" = None
    terms: Terms = field(default=SI, compare=False)
    slips: tuple[FileFault, ...] = field(default=(), compare=False)
    answer: Mapping[str, Any] | None = field(default=None, repr=False, compare=False)

    @property
    def warnings(self) -> tuple[str, ...]:
        """The slips in words, each with its place."""
        return tuple(map(str, self.slips))

    @property
    def is_in_weather(self) -> bool:
        """Whether the load of the criterion is that of the environment, and not something else."""
        around, load = self.environment, self.criterion.load
        return (
            around is not None
            and self.criterion.has_load
            and around.exerts(self.swarm.outline, load)
        )

    def problem(self, criterion: Criterion | None = None) -> Problem:
        """Return the question where the newcomer goes; one that may go anywhere if there is none.

        Parameters
        ----------
        criterion : Criterion, optional
            Instead of the scenario's own.
        """
        return Problem(
            self.swarm,
            self.newcomer or Newcomer(),
            self.zones,
            self.no_go,
            self.spacing,
            criterion or self.criterion,
        )
