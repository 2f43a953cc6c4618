"""Everything the report rests on, and what it states."""

from dataclasses import dataclass
from functools import cached_property

from swarmgrasp.pages.runner import Runner
from swarmgrasp.pages.statements import Statement
from swarmgrasp.paper.published import EXAMPLES, Example
from swarmgrasp.paper.sizes import Size
from swarmgrasp.paper.studies import (
    construction,
    cross_section,
    gains,
    helpless,
    misprints,
    plateaus,
    relaxation,
    speed,
)
from swarmgrasp.swarm import Swarm


@dataclass(frozen=True, eq=False)
class Measured:
    """What was measured.

    Attributes
    ----------
    size : Size
    seed : int
    gains : dict of int to Gains
        By number of robots, as the others.
    relaxations : dict of int to dict of str to Kind
    plateaus : dict of int to Plateaus
    speeds, beyond : Speeds
        Within the paper's numbers of robots, and with larger ones.
    misprints : Misprints
    section : Section
    """

    size: Size
    seed: int
    gains: dict[int, gains.Gains]
    relaxations: relaxation.Relaxations
    plateaus: dict[int, plateaus.Plateaus]
    speeds: speed.Speeds
    beyond: speed.Speeds
    misprints: misprints.Misprints
    section: cross_section.Section

    @cached_property
    def steps(self) -> list[Swarm]:
        """The swarms that grow to the first example's draw and its newcomer."""
        found = self.gains[EXAMPLES[0].robots]
        return construction.steps_of(found.draws[found.shown(EXAMPLES[0])])

    def on(self, example: Example) -> list[Statement]:
        """Return the statements on one of the paper's examples."""
        return gains.statements(self.gains[example.robots], example)

    @cached_property
    def statements(self) -> dict[str, list[Statement]]:
        """All statements, by what they are on."""
        segments = self.size.segments
        return {
            "construction": construction.statements(self.steps),
            **{example.figure: self.on(example) for example in EXAMPLES},
            "speed": speed.statements(self.speeds)
            + speed.statements_beyond(self.speeds, self.beyond),
            "cross-section": cross_section.statements(self.section, self.seed, segments),
            "relaxation": relaxation.statements(self.relaxations),
            "plateaus": plateaus.statements(self.plateaus),
            "helpless": helpless.statements(self.gains, self.seed),
            "misprints": list(misprints.statements(self.misprints).values()),
        }

    @property
    def every(self) -> list[Statement]:
        """All statements, in order."""
        return [one for group in self.statements.values() for one in group]


def measure(runner: Runner, size: Size, seed: int) -> Measured:
    """Measure everything; the times first, while nothing else runs.

    Raises
    ------
    PackageMissing
        If SciPy is not installed.
    """
    timed, beyond = (
        speed.measure(runner, seed, robots, size.configurations)
        for robots in (size.timed, size.beyond)
    )
    return Measured(
        size,
        seed,
        gains.measure(runner, seed, size.gains),
        relaxation.measure(runner, seed, size.relaxed),
        plateaus.measure(runner, seed, size.plateaus),
        timed,
        beyond,
        misprints.measure(runner, seed, size.misprints),
        cross_section.section(seed),
    )
