"""What a page asks beside where the newcomer goes: push forces, several newcomers, the sheet."""

from collections.abc import Callable

from swarmgrasp.forces import forces
from swarmgrasp.placement import Placement, Problem, place_sequence, place_together
from swarmgrasp.scenario import Scenario
from swarmgrasp.studio.figures import Figures
from swarmgrasp.studio.messages import (
    Forces,
    ForcesTold,
    ForceTold,
    Placed,
    Report,
    ReportTold,
    Sequence,
    SequenceTold,
    write_message,
)
from swarmgrasp.studio.reading import Question, question_of
from swarmgrasp.studio.telling import do_words
from swarmgrasp.words import percent

STEPS = 400
"""Of the search for newcomers placed together: about a second for a few."""
MOST_TOGETHER = 12
"""Newcomers that are placed together."""

Reporting = Callable[[Scenario, str, str], str]
"""Makes the sheet about a scenario, in HTML, given its file's name and text."""


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
    problem, doc = question.problem, message.doc
    scenario = Scenario(
        name=doc.name,
        description=doc.description,
        swarm=problem.swarm,
        newcomer=problem.newcomer if question.places else None,
        zones=problem.zones,
        no_go=problem.no_go,
        spacing=problem.spacing,
        environment=question.environment,
        criterion=problem.criterion,
        terms=question.terms,
    )
    return write_message(ReportTold(message.n, reporting(scenario, doc.name, message.text)))
