"""The question of an answer file, to be asked again."""

import re
from typing import Any

from swarmgrasp.answer_file import parse_answer
from swarmgrasp.environment import Environment
from swarmgrasp.errors import AnswerInvalid, FileFault, ScenarioInvalid
from swarmgrasp.placement import Problem
from swarmgrasp.plain import read
from swarmgrasp.quality import Criterion
from swarmgrasp.ranges import plain_name, shown
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.simulation.simulation import Simulation
from swarmgrasp.swarm import Swarm
from swarmgrasp.terms import SI, Terms

_OPTIONS = {
    "asked_effort": (int, "a whole number"),
    "bearings": (list, "a list"),
    "most": (int, "a whole number"),
    "placements": (list, "a list"),
    "required": (float, "a number"),
    "robots": (list, "a list"),
    "speed": (float, "a number"),
    "wanted": (list, "a list"),
}
"""What else answers were asked, and what it is: how many robots, which wrenches, which bearings."""

_FORMAT = re.compile(rb'"format"\s*:\s*"swarmgrasp ')
"""What an answer says of itself."""


def answer_in(text: str | bytes, source: str = "<text>") -> dict[str, Any] | None:
    """Return the answer that the text of a file holds, None if it is none but perhaps a scenario.

    Raises
    ------
    ScenarioInvalid
        If it calls itself an answer and cannot be read as one.

    Examples
    --------
    >>> answer_in('{"format": "swarmgrasp quality 3"}'), answer_in('{"robots": []}')
    ({'format': 'swarmgrasp quality 3'}, None)
    """
    raw = text.encode(errors="surrogatepass") if isinstance(text, str) else text
    if not raw.lstrip().startswith(b"{") or not _FORMAT.search(raw):
        return None
    try:
        document = parse_answer(raw, source)
    except AnswerInvalid as error:
        raise ScenarioInvalid(error.faults) from None
    return document if str(document.get("format")).startswith("swarmgrasp ") else None


def scenario_of(document: dict[str, Any], source: str) -> Scenario:
    """Return the scenario that an answer is of: swarm and criterion, and what else it was asked.

    The digest plays no part: what is asked is what stands in the file.

    Parameters
    ----------
    document : dict
        Of any kind of answer.
    source : str
        What messages call the file.

    Raises
    ------
    ScenarioInvalid
        If it holds no question, or one that has faults; all of them are told, each with its key.
    """
    faults: list[str] = []
    simulation = _read(Simulation, document, "simulation", faults)
    problem = simulation.problem if simulation else _read(Problem, document, "problem", faults)
    judged = document.get("quality")
    if isinstance(judged, dict):
        document = {**judged, **document}
    swarm = problem.swarm if problem else _read(Swarm, document, "swarm", faults)
    environment = _read(Environment, document, "environment", faults)
    environment = simulation.environment if simulation else environment
    criterion = problem.criterion if problem else _read(Criterion, document, "criterion", faults)
    if criterion is None:
        asked: dict[str, Any] = Criterion().to_data()
        asked |= {key: document[key] for key in asked if key in document}
        criterion = _read(Criterion, {"criterion": asked}, "criterion", faults)
    terms = _read(Terms, document, "terms", faults)
    faults += (
        f"{key}: should be {words}; it is {shown(document[key])}"
        for key, (kind, words) in _OPTIONS.items()
        if key in document and type(document[key]) is not kind
    )
    placed = document.get("placements")
    if isinstance(placed, list) and not all(isinstance(each, dict) for each in placed):
        faults.append("placements: should be a list of mappings")
    if swarm is None and not faults:
        faults.append(f"a {document['format']!r} holds no question")
    if faults or swarm is None or criterion is None:
        raise ScenarioInvalid(FileFault(source, None, None, "", fault) for fault in faults)
    return Scenario(
        name=plain_name(str(document.get("name", ""))),
        description="",
        swarm=swarm,
        newcomer=problem.newcomer if problem else None,
        zones=problem.zones if problem else None,
        no_go=problem.no_go if problem else (),
        spacing=problem.spacing if problem else 0.0,
        environment=environment,
        simulation=simulation,
        criterion=criterion,
        terms=terms or SI,
        answer=document,
    )


def _read(kind: Any, document: dict[str, Any], key: str, faults: list[str]) -> Any:
    """Make an object of what stands under a key; None if nothing does, or if it has faults."""
    return None if document.get(key) is None else read(document[key], kind, (key,), faults)
