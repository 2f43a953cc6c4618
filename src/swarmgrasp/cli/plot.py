"""`swarmgrasp plot`: pictures of a scenario."""

from pathlib import Path

from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.drawing import USUAL, Drawing
from swarmgrasp.cli.inputs import blaming, read_scenario
from swarmgrasp.cli.pictures import Picture
from swarmgrasp.cli.question import check_newcomer, tell_omitted
from swarmgrasp.cli.weather import CALM, Weather
from swarmgrasp.cli.wording import AS_FILED, Phrasing


def plot(
    file: Dashed,
    picture: Path,
    /,
    *,
    what: Picture = "plan",
    drawing: Drawing = USUAL,
    weather: Weather = CALM,
    phrasing: Phrasing = AS_FILED,
) -> None:
    """Draw a scenario, its newcomer in the best place.

    Example: swarmgrasp plot deck-barge barge.svg --what landscape

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as deck-barge.
    picture
        File to write; its suffix .png, .svg or .pdf is the format.
    what
        plan shows the object from above with its robots and zones; wrenches shows all the
        forces and torques the swarm can exert; landscape shows the quality for every
        contact and direction of the newcomer.
    """
    faults = drawing.faults(picture) + weather.faults()
    scenario = weather.on(read_scenario(file, faults), file, phrasing)
    if what == "landscape":
        check_newcomer(scenario, file, "plot --what landscape")
    tell_omitted(
        scenario, file, "plot",
        newcomer=None, losing=None, failures=None, worst_case=None,
        load=weather.given, task=None,
    )  # fmt: skip
    from swarmgrasp.cli.pictures import pictures
    from swarmgrasp.cli.place import solve
    from swarmgrasp.cli.show.report import told_written

    look = drawing.look(scenario.name, phrasing.terms(scenario))
    answers = solve(scenario, file) if scenario.newcomer else ()
    with blaming(file):
        written = pictures({what: picture}, scenario, answers, scenario.criterion, look)
    told_written(written)
