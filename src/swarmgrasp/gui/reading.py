"""The question that a document of a page asks."""

from dataclasses import dataclass
from functools import lru_cache
from typing import Any

import msgspec

from swarmgrasp.environment import Environment
from swarmgrasp.errors import DataInvalid, SwarmGraspError
from swarmgrasp.gui.frames import Columns
from swarmgrasp.gui.messages import Doc, Speech
from swarmgrasp.gui.scenes import terms_of
from swarmgrasp.outline import Outline
from swarmgrasp.placement import Problem
from swarmgrasp.plain import Plain, read
from swarmgrasp.swarm import Newcomer, Robot, Swarm, Zone
from swarmgrasp.terms import Terms

SMALL = 4_000
"""Bytes of a small object in JSON."""
REMEMBERED, REMEMBERED_LARGE = 20_000, 8
"""Small and large objects kept, so that a gesture makes only the one anew that changes."""


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
    given = _remembered(doc.problem, faults)
    nowhere = given.get("zones") == []
    if nowhere:  # a Problem knows a place or none at all
        given["zones"] = None
    environment = None
    if doc.environment is not None:
        environment = read(
            _known(Environment, doc.environment), Environment, ("environment",), faults
        )
    if doc.in_weather:
        faults += _take_weather(given, environment)
    problem = read(given, Problem, ("problem",), faults)
    if faults:
        raise DataInvalid(faults)
    return Question(doc, problem, environment, terms_of(speech), doc.newcomer and not nowhere)


def _take_weather(given: dict[str, Any], environment: Environment | None) -> list[str]:
    """Put the load of the weather into a problem's plain form; return what is wrong with it."""
    if environment is None or not environment.is_steady:
        return ["in_weather: there is no steady wind; give it a speed and a bearing"]
    swarm, criterion = given.get("swarm"), given.get("criterion")
    outline = swarm.get("outline") if isinstance(swarm, dict) else None
    if isinstance(swarm, Swarm):
        outline = swarm.outline
    if isinstance(outline, Outline) and isinstance(criterion, dict):  # else it is told anyway
        given["criterion"] = {**criterion, "load": environment.load(outline).tolist()}
    return []


def _remembered(problem: dict[str, Any], faults: list[str]) -> dict[str, Any]:
    """Return a problem's plain form with the objects in place that were made before.

    In a gesture one robot is another, and the others are as they were.
    """
    swarm = problem.get("swarm")
    if isinstance(swarm, dict) and isinstance(swarm.get("robots"), Columns):
        return {**problem, "swarm": _crowd(swarm, faults)}
    if not isinstance(swarm, dict) or not isinstance(swarm.get("robots"), list):
        return dict(problem)
    robots = [_known(Robot, robot) for robot in swarm["robots"]]
    outline, zones = _known(Outline, swarm.get("outline")), problem.get("zones")
    if isinstance(zones, list):
        zones = [_known(Zone, zone) for zone in zones]
    return {
        **problem,
        "swarm": {**swarm, "robots": robots, "outline": outline},
        "newcomer": _known(Newcomer, problem.get("newcomer")),
        "zones": zones,
    }


def _crowd(swarm: dict[str, Any], faults: list[str]) -> object:
    """Return a swarm of which columns were sent; the data themselves if that is at fault."""
    columns, outline = swarm["robots"], _known(Outline, swarm.get("outline"))
    if not isinstance(outline, Outline):
        return {**swarm, "robots": []}
    try:
        return Swarm.from_arrays(
            outline, columns.contacts, columns.directions, columns.limits, names=columns.names,
            characteristic_length=swarm.get("characteristic_length"),
            force_weights=swarm.get("force_weights", (1.0, 1.0)),
        )  # fmt: skip
    except SwarmGraspError as error:
        faults += (f"problem.swarm: {fault}" for fault in error.faults)
        return {**swarm, "robots": []}


def _known(kind: Any, data: object) -> object:
    """Return the object that data make; the data themselves if they make none, to be told of."""
    raw = msgspec.json.encode(data)
    made = _made if len(raw) <= SMALL else _made_large
    try:
        return made(kind, raw)
    except SwarmGraspError:
        return data


def _make(kind: Any, raw: bytes) -> Plain:
    """Make an object of data in JSON."""
    made: Plain = kind.from_data(msgspec.json.decode(raw))
    return made


_made = lru_cache(maxsize=REMEMBERED)(_make)
_made_large = lru_cache(maxsize=REMEMBERED_LARGE)(_make)
