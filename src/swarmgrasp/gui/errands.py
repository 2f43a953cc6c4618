"""What a page asks beside where the newcomer goes: push forces, several newcomers, the sheet."""

from collections.abc import Callable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING, Any

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.forces import forces
from swarmgrasp.gui.figures import Figures
from swarmgrasp.gui.messages import Doc, Forces, Open, Report, Run, Sequence, Text, Write
from swarmgrasp.gui.reading import Question, question_of
from swarmgrasp.gui.replies import (
    Error,
    Faults,
    ForcesTold,
    ForceTold,
    Placed,
    ReportTold,
    SequenceTold,
    Written,
)
from swarmgrasp.gui.scenes import Source, faults_of, scene_of, speech_of, terms_of
from swarmgrasp.gui.sending import write_message
from swarmgrasp.gui.telling import do_words
from swarmgrasp.placement import Placement, Problem, place_sequence, place_together
from swarmgrasp.scenario import Scenario, edited, parse_scenario
from swarmgrasp.terms import Terms
from swarmgrasp.words import percent

if TYPE_CHECKING:
    from swarmgrasp.gui.runs import Recorded

STEPS = 400
"""Of the search for newcomers placed together: about a second for a few."""
MOST_TOGETHER = 12
"""Newcomers that are placed together."""

NO_ZONE = "problem.zones: a file cannot say that there is no zone; leave out the newcomer instead"
Errand = Callable[[Any], bytes]
"""Answers a message that is no ask."""
Reporting = Callable[[Scenario, str, str], str]
"""Makes the sheet about a scenario, in HTML, given its file's name and text."""


def errands_of(
    scenes: Mapping[str, Source], opens: str, reporting: Reporting | None = None,
    run: "Recorded | None" = None,
) -> dict[type, Errand]:  # fmt: skip
    """Return what answers messages that are no asks, by their kinds.

    Parameters
    ----------
    scenes : mapping of str to Source
    opens : str
        The scene in whose terms a run is told.
    reporting : callable, optional
        Makes the sheet about a job.
    run : Recorded, optional
        A run to play.
    """
    files = {path: at for source in scenes.values() for path, at in source.files.items()}

    def opened(message: Open) -> bytes:
        """Return a scene that is known."""
        source = scenes.get(message.name)
        if source is None:
            return write_message(Error(message.n, f"There is no scene {message.name!r}."))
        return told_scene(message.n, message.name, source)

    errands: dict[type, Errand] = {
        Open: opened,
        Text: lambda message: told_scene(message.n, message.name, Source(message.text, files)),
        Forces: told_forces,
        Sequence: told_sequence,
        Write: lambda message: told_text(message, files),
    }
    if run is not None:
        errands[Run] = lambda message: run.told(message.n, _terms(opens, scenes[opens]))
    if reporting is not None:
        errands[Report] = lambda message: told_report(message, reporting)
    return errands


def told_scene(n: int, name: str, source: Source) -> bytes:
    """Tell a scene, or what is wrong with its text."""
    try:
        return write_message(scene_of(n, name, source))
    except ScenarioInvalid as error:
        return write_message(Faults(n, faults_of(error)))


def _terms(name: str, source: Source) -> Terms:
    """Return the terms of a scene."""
    return terms_of(scene_of(0, name, source).speech)


def told_forces(message: Forces) -> bytes:
    """Tell how hard each robot pushes for a wrench, beside the load if there is one."""
    question = question_of(message.doc, message.speech)
    swarm, figures = question.problem.swarm, Figures(question.terms)
    found = forces(swarm, message.wrench, load=question.problem.criterion.load)
    rows = zip(swarm.names, found.vectors.tolist(), found.shares.tolist(), strict=True)
    robots = tuple(
        ForceTold(name, (x, y), share, _share_words(question, name, share))
        for name, (x, y), share in rows
    )
    held = not found.is_degraded
    said = f"largest share {percent(found.largest_share)}"
    if not held:
        said = f"out of reach by {figures.forces(found.shortfall)}"
    return write_message(
        ForcesTold(message.n, robots, found.largest_share, found.shortfall, said, held)
    )


def _share_words(question: Question, name: str, share: float) -> str:
    """Say how much of what it has a robot gives."""
    limit = Figures(question.terms).forces(question.problem.swarm[name].limit)
    return f"{round(100.0 * share)}\u00a0% of {limit}"


def told_sequence(message: Sequence) -> bytes:
    """Tell where several newcomers go, one after the other or together."""
    question = question_of(message.doc, message.speech)
    if not question.places:
        return write_message(SequenceTold(message.n, (), "There is nobody to place, or nowhere."))
    find = _together if message.together else _one_by_one
    answers, said = find(question, message.robots)
    return write_message(SequenceTold(message.n, answers, said))


def _one_by_one(question: Question, count: int) -> tuple[tuple[Placed, ...], str]:
    """Place newcomers one after the other."""
    found = place_sequence(question.problem, count)
    answers = tuple(_placed(question, one) for one in found)
    return answers, "each the best given those before it"


def _placed(question: Question, one: Placement) -> Placed:
    """Tell one of them."""
    figures = Figures(question.terms)
    return Placed(
        one.robot.to_data(), one.place, do_words(one.robot, one.problem.swarm.outline, figures),
        one.quality_before, one.quality, _quality(question.problem, figures, one.quality),
    )  # fmt: skip


def _together(question: Question, count: int) -> tuple[tuple[Placed, ...], str]:
    """Place newcomers all at once."""
    if count > MOST_TOGETHER:
        return (), f"More than {MOST_TOGETHER} are placed one after the other."
    problem, figures = question.problem, Figures(question.terms)
    found = place_together(problem, count, effort=STEPS)
    told = _quality(problem, figures, found.quality)
    answers = tuple(
        Placed(
            robot.to_data(), place, do_words(robot, problem.swarm.outline, figures),
            found.quality_before, found.quality, told,
        )
        for robot, place in zip(found.robots, found.places, strict=True)
    )  # fmt: skip
    near = f"within {percent(max(found.gap, 1e-6))} of the best" if found.quality else "not held"
    return answers, f"{told} together, {near}"


def _quality(problem: Problem, figures: Figures, value: float) -> str:
    """Return a quality with its unit."""
    if problem.criterion.task is not None:
        return f"{value:.2f} times"
    return figures.forces(value)


def told_report(message: Report, reporting: Reporting) -> bytes:
    """Tell the sheet about the job."""
    question = question_of(message.doc, message.speech)
    scenario = _scenario(message.doc, question)
    return write_message(ReportTold(message.n, reporting(scenario, scenario.name, message.text)))


def told_text(message: Write, files: Mapping[str, Path]) -> bytes:
    """Tell the text of a scenario with what the document changes; it may take from some files."""
    before = parse_scenario(message.text, folder=files)
    question = question_of(message.doc, speech_of(before))
    if message.doc.newcomer and not question.places:
        raise ScenarioInvalid(NO_ZONE)
    scenario = replace(
        _scenario(message.doc, question), terms=before.terms, simulation=before.simulation
    )
    return write_message(Written(message.n, edited(message.text, scenario, folder=files)))


def _scenario(doc: Doc, question: Question) -> Scenario:
    """Return the scenario of a document."""
    problem = question.problem
    return Scenario(
        name=doc.name,
        description=doc.description,
        swarm=problem.swarm,
        newcomer=problem.newcomer if doc.newcomer else None,
        zones=problem.zones,
        no_go=problem.no_go,
        spacing=problem.spacing,
        environment=question.environment,
        criterion=problem.criterion,
        terms=question.terms,
    )
