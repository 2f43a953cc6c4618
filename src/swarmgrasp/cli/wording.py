"""In which terms a command tells its answer: options that all such commands share."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Annotated, Literal

from cyclopts import Parameter

from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.inputs import output_faults

if TYPE_CHECKING:
    from swarmgrasp.scenario import Scenario
    from swarmgrasp.terms import Terms


def csv_faults(csv: str | None, json: str | None) -> list[str]:
    """Return what is wrong with where to write tables, together with where JSON goes."""
    faults = output_faults(csv, (".csv",))
    if csv == DASH and json == DASH:
        faults.append("--csv and --json cannot both be printed; give one of them a file")
    return faults


@Parameter(name="*")
@dataclass(frozen=True)
class Phrasing:
    """The terms in which an answer is told."""

    units: Literal["file", "si"] = "file"
    """Units of the answer, and of numbers that options give without one: the file's, or si for
    metres, newtons and metres per second; angles are in degrees."""
    bearings: Annotated[bool, Parameter(negative="")] = False
    """Tell directions as bearings, degrees clockwise from the bow, or from north where the file
    gives the heading."""

    def terms(self, scenario: "Scenario") -> "Terms":
        """Return the terms in which to tell an answer to the question of a file."""
        return self.of(scenario.terms)

    def of(self, terms: "Terms") -> "Terms":
        """Return the terms in which to tell what a file says in its own."""
        from swarmgrasp.terms import SI

        terms = replace(terms, bearings=self.bearings or terms.bearings)
        if self.units == "file":
            return terms
        return replace(terms, length=SI.length, force=SI.force, speed=SI.speed, angle=SI.angle)


@Parameter(name="*")
@dataclass(frozen=True)
class Wording(Phrasing):
    """How an answer is told; JSON is in SI units and radians however that is."""

    csv: Dashed | None = None
    """Also write the tables to this .csv file, each further one beside it; "-" prints the first and
    nothing else. Units are those of the answer."""

    def faults(self, json: str | None = None) -> list[str]:
        """Return what is wrong with where to write, together with where JSON goes."""
        return csv_faults(self.csv, json)


AS_FILED = Phrasing()
"""As the file has it."""
FILE = Wording()
"""As the file has it."""
