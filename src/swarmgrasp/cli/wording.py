"""In which terms a command tells its answer: options that all such commands share."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

if TYPE_CHECKING:
    from swarmgrasp.scenario import Scenario
    from swarmgrasp.terms import Terms


@Parameter(name="*")
@dataclass(frozen=True)
class Wording:
    """How an answer is told; JSON is in SI units and radians however that is."""

    units: Literal["file", "si"] = "file"
    """Units of the answer: the file's, or si for metres, newtons and metres per second."""
    bearings: Annotated[bool, Parameter(negative="")] = False
    """Tell directions as bearings, degrees clockwise from the bow, or from north where the file
    gives the heading."""

    def terms(self, scenario: "Scenario") -> "Terms":
        """Return the terms in which to tell an answer to the question of a file."""
        from swarmgrasp.terms import SI

        terms = replace(scenario.terms, bearings=self.bearings or scenario.terms.bearings)
        if self.units == "file":
            return terms
        return replace(terms, length=SI.length, force=SI.force, speed=SI.speed, angle=SI.angle)


FILE = Wording()
"""As the file has it."""
