"""The question that a document of a page asks."""

from dataclasses import dataclass, replace
from typing import Any

from swarmgrasp.environment import Environment
from swarmgrasp.errors import DataInvalid
from swarmgrasp.placement import Problem
from swarmgrasp.plain import read
from swarmgrasp.studio.messages import Doc, Fault, Speech
from swarmgrasp.studio.scenes import records, terms_of
from swarmgrasp.terms import Terms


@dataclass(frozen=True)
class Question:
    """What a page asks.

    Attributes
    ----------
    doc : Doc
    problem : Problem
        With the load of the weather, if that is asked.
    environment : Environment or None
    terms : Terms
    places : bool
        Whether there is a newcomer, and somewhere to go.
    """

    doc: Doc
    problem: Problem
    environment: Environment | None
    terms: Terms
    places: bool

    @property
    def in_weather(self) -> bool:
        """Whether the load is that of the wind, the current and the waves."""
        return self.doc.in_weather


def question_of(doc: Doc, speech: Speech) -> Question:
    """Read a document.

    Raises
    ------
    SwarmGraspError
        If it makes no question; all faults at once, each with the path of its key.
    """
    faults: list[str] = []
    given: dict[str, Any] = dict(doc.problem)
    nowhere = given.get("zones") == []
    if nowhere:  # a Problem knows a place or none at all
        given["zones"] = None
    problem = read(given, Problem, ("problem",), faults)
    environment = None
    if doc.environment is not None:
        environment = read(doc.environment, Environment, ("environment",), faults)
    if doc.in_weather and (doc.environment is None or (environment and not environment.is_steady)):
        faults.append("in_weather: there is no steady wind; give it a speed and a bearing")
    if faults:
        raise DataInvalid(faults)
    terms = terms_of(speech)
    if doc.in_weather and environment is not None:
        x, y, turn = environment.load(problem.swarm.outline).tolist()
        criterion = replace(problem.criterion, load=(x, y, turn))
        problem = replace(problem, criterion=criterion)
    return Question(doc, problem, environment, terms, doc.newcomer and not nowhere)


def faults_in(faults: tuple[str, ...]) -> tuple[Fault, ...]:
    """Return the faults of a document, each with the path of its key."""
    return tuple(records("", faults))
