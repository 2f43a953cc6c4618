"""`swarmgrasp place --for capability`: where the next robot raises the least wind held most."""

from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from swarmgrasp.cli.deliver import deliver
from swarmgrasp.cli.drawing import Drawing
from swarmgrasp.cli.inputs import blaming
from swarmgrasp.cli.weather import Weather
from swarmgrasp.cli.wording import Wording

if TYPE_CHECKING:
    from swarmgrasp.cli.pictures import Picture
    from swarmgrasp.environment import Environment
    from swarmgrasp.quality import Criterion
    from swarmgrasp.scenario import Scenario


class ForCapability(NamedTuple):
    """What is asked."""

    scenario: "Scenario"
    file: str
    environment: "Environment"
    criterion: "Criterion"
    gap: float
    runners_up: float


def capability_faults(weather: Weather, *, alone: bool) -> list[str]:
    """Return what does not go with --for capability.

    Parameters
    ----------
    weather : Weather
    alone : bool
        Whether it is asked for one robot, and nothing but its place.
    """
    faults = [
        f"{option} is of one wind, and --for capability of all: leave it out"
        for option in ("--wind", "--from")
        if option in weather.given
    ]
    if not alone:
        faults.append(
            "--for capability places one robot: leave out --robots, --together and --where-not"
        )
    return faults


def tell_for_capability(
    asked: ForCapability,
    plot: "dict[Picture, Path] | None",
    drawing: Drawing,
    json: str | None,
    wording: Wording,
) -> int:
    """Find the place and hand it over; return the exit status."""
    from swarmgrasp.answer_file import document_of
    from swarmgrasp.capability import place_for_capability
    from swarmgrasp.cli.pictures import pictures
    from swarmgrasp.cli.show.place_for_capability import show
    from swarmgrasp.placement import Placements

    scenario = asked.scenario
    with blaming(asked.file):
        found = place_for_capability(
            scenario.problem(asked.criterion), asked.environment, gap=asked.gap,
            runners_up=asked.runners_up,
        )  # fmt: skip
    terms = wording.terms(scenario)
    look = drawing.look(scenario.name, terms)
    answers = Placements([found.placement])
    deliver(
        json,
        document_of(found, scenario.name, terms=scenario.terms),
        lambda: show(scenario.name, found, terms),
        lambda: (
            pictures(plot, scenario, answers, found.placement.problem.criterion, look)
            if plot
            else []
        ),
        csv=wording.csv,
    )
    return 0
