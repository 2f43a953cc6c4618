"""What an operator wishes of a robot on the network: to join, to leave, to move; and its answer."""

import json
import secrets
from dataclasses import dataclass
from queue import Empty, SimpleQueue
from typing import Any

import zenoh

from swarmgrasp.agents.network.body import WISHES
from swarmgrasp.agents.network.keys import Keys
from swarmgrasp.agents.network.session import open_session
from swarmgrasp.agents.network.settings import NetworkSettings
from swarmgrasp.agents.protocol.record import check_id
from swarmgrasp.agents.protocol.wire import PROTOCOL
from swarmgrasp.errors import AgentInvalid, NetworkFailed
from swarmgrasp.ranges import nearest_name, shown

MOST_BYTES = 1024
"""Length of a wish, and of an answer."""
MOST_NUMBER = 1 << 48
GREETING = 2.0
"""How long it is asked where a robot is [s]."""
ANSWER = 10.0
"""How long a robot's answer is waited for [s]."""


@dataclass(frozen=True)
class Wish:
    """What an operator wishes.

    Attributes
    ----------
    what : str
        join, leave or move.
    number : int
        Drawn by who asks: the answer has the same.
    """

    what: str
    number: int


@dataclass(frozen=True)
class Answer:
    """What a robot makes of a wish.

    Attributes
    ----------
    number : int
    phase : str
        Where it is on its way then.
    words : tuple of str
        What it says to people of it.
    refuses : bool
        Whether it cannot do so now.
    """

    number: int
    phase: str
    words: tuple[str, ...]
    refuses: bool


def wish_bytes(wish: Wish) -> bytes:
    """Return a wish as bytes."""
    return json.dumps({"wish": wish.what, "number": wish.number}).encode()


def read_wish(data: bytes) -> Wish:
    """Return the wish that bytes hold, whoever sent them.

    Raises
    ------
    AgentInvalid
        If they hold none.

    Examples
    --------
    >>> read_wish(wish_bytes(Wish("leave", 7)))
    Wish(what='leave', number=7)
    """
    match _read(data):
        case {"wish": str(what), "number": int(number)} if what in WISHES:
            if 0 <= number < MOST_NUMBER:
                return Wish(what, number)
    raise AgentInvalid(f"{shown(data.decode('utf-8', 'replace'))} is no wish")


def answer_bytes(answer: Answer) -> bytes:
    """Return an answer as bytes."""
    return json.dumps(vars(answer)).encode()


def read_answer(data: bytes) -> Answer:
    """Return the answer that bytes hold, whoever sent them.

    Raises
    ------
    AgentInvalid
        If they hold none.
    """
    match _read(data):
        case {
            "number": int(number),
            "phase": str(phase),
            "words": [*words],
            "refuses": bool(refuses),
        } if all(isinstance(each, str) for each in words):
            return Answer(number, phase, tuple(words), refuses)
    raise AgentInvalid(f"{len(data)} bytes are no answer")


def _read(data: bytes) -> dict[str, Any]:
    """Return the object of JSON that bytes hold; empty if they hold none."""
    try:
        known = json.loads(data) if len(data) <= MOST_BYTES else None
    except (ValueError, RecursionError):
        known = None
    return known if isinstance(known, dict) else {}


def ask_robot(settings: NetworkSettings, name: str, what: str) -> Answer:
    """Tell a robot what an operator wishes; return what it makes of that.

    Parameters
    ----------
    settings : NetworkSettings
    name : str
        The robot's.
    what : str
        join, leave or move.

    Raises
    ------
    AgentInvalid
        If there is no such wish, or no robot can have that name.
    NetworkFailed
        If the robot is not there, is there in two missions, or does not answer.
    """
    check_id(name)
    if what not in WISHES:
        likely = nearest_name(what, tuple(WISHES))
        raise AgentInvalid(f"{shown(what)} is no wish{likely}; the wishes are {', '.join(WISHES)}")
    wish = Wish(what, secrets.randbelow(MOST_NUMBER))
    with open_session(settings) as session:
        keys, answers = _found(session, name), SimpleQueue[bytes]()
        listening = session.declare_subscriber(
            keys.answer, lambda sample: answers.put(sample.payload.to_bytes())
        )
        block = zenoh.CongestionControl.BLOCK
        session.put(keys.ask, wish_bytes(wish), congestion_control=block, express=True)
        answer = _awaited(answers, wish)
        listening.undeclare()
    if answer is None:
        refused = "; or this certificate may not ask" if settings.tls is not None else ""
        raise NetworkFailed(
            f"{name} does not answer within {ANSWER:g} s: its process hangs{refused}"
        )
    return answer


def _found(session: zenoh.Session, name: str) -> Keys:
    """Return the keys of a robot that is on the network."""
    found = set()
    for reply in session.liveliness().get(Keys("*", "*", name).alive, timeout=GREETING):
        if reply.ok is not None:
            _, protocol, mission, *_ = str(reply.ok.key_expr).split("/")
            found.add(Keys(protocol, mission, name))
    missions = ", ".join(sorted(keys.mission for keys in found))
    if not found:
        raise NetworkFailed(f"no robot {name} is on the network")
    if len(found) > 1:
        raise NetworkFailed(
            f"{name} is on the network in the missions {missions}; ask at one's own"
        )
    (keys,) = found
    if keys.protocol != str(PROTOCOL):
        raise NetworkFailed(f"{name} speaks protocol {keys.protocol}; this program {PROTOCOL}")
    return keys


def _awaited(answers: "SimpleQueue[bytes]", wish: Wish) -> Answer | None:
    """Return the answer to a wish; None if none comes. Others' answers are not heeded."""
    while True:
        try:
            answer = read_answer(answers.get(timeout=ANSWER))
        except Empty:
            return None
        except AgentInvalid:
            continue
        if answer.number == wish.number:
            return answer
