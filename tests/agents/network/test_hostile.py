"""What comes from outside and should not: told in words, and nothing attaches wrongly."""

import msgspec
import pytest

from on_the_wire import send
from swarmgrasp.agents.network import NetworkSettings
from swarmgrasp.agents.network.asking import read_answer, read_wish
from swarmgrasp.agents.network.fleet import free_ports
from swarmgrasp.agents.network.keys import Keys, own_keys
from swarmgrasp.agents.network.session import open_session
from swarmgrasp.agents.protocol import Phase, Place, ProblemPlanner, Record
from swarmgrasp.agents.protocol.record import LIVES, MOST_TICKET
from swarmgrasp.agents.protocol.wire import MOST_BYTES, Beat, Put, encode
from swarmgrasp.errors import AgentInvalid
from swarmgrasp.scenario import load_example

FILE = "deck-barge"
MISSION = ProblemPlanner(load_example(FILE).problem()).mission
HERE = Place(-12.192, 10.9728, -1.97)


@pytest.fixture
def victim(fleet):
    """Run a robot that waits to be asked, and give a way in without any certificate."""
    end = f"tcp/127.0.0.1:{free_ports(1)[0]}"
    router = fleet.start("router", "--listen", end)
    fleet.wait(lambda: bool(router.told), "a router")
    robot = fleet.start("Fortuna", "--mode", "client", "--connect", end, "--speed", "40 m/s",
                        "--worth", 0, "--waits", file=FILE)  # fmt: skip
    with open_session(NetworkSettings(mode="client", connect=(end,))) as session:
        token = session.liveliness().declare_token(own_keys(MISSION, "Mallory").alive)
        fleet.wait(lambda: "Mallory" in robot.sees, "that it sees Mallory")
        token.undeclare()
        robot.endpoint = end
        yield robot, session


def refused(robot, words):
    """Tell whether a robot has told that it refused something."""
    return any(words in each for each in robot.reports("refused"))


def test_garbage_is_dropped_counted_and_told(fleet, victim):
    """Noise, truncation, NaN, giants, forgeries, absurd tickets; then it attaches as ever."""
    robot, session = victim
    key = own_keys(MISSION, "Mallory").to_all
    sound = Record("Mallory", LIVES, 1, Phase.COMING, 1, place=HERE)
    change = msgspec.structs.replace
    nan = change(sound, place=Place(float("nan"), 0.0, 0.0))
    bad = [
        b"\xff" * 40, b"", encode(Put(sound))[:-3], encode(Put(nan)), b"\x00" * (MOST_BYTES + 1),
        encode(Put(change(sound, id="Ajax"))), encode(Put(change(sound, ticket=MOST_TICKET - 1))),
        encode(Put(change(sound, place=Place(0.0, 0.0, 0.0)))),
        encode(Beat("Mallory", 2**61, b"x" * 8)),
    ]  # fmt: skip
    for data in bad:
        send(session, key, data)
    fleet.wait(lambda: refused(robot, "(8 so far)"), "that eight are refused")
    assert refused(robot, "sends what is no message")
    assert "Mallory" not in robot.heard
    send(session, robot_key("event"), b'{"event": "join"}')
    fleet.wait(lambda: robot.phase == "attached", "that it attaches")
    assert robot.record["place"]["x"] == pytest.approx(-12.192)


@pytest.mark.parametrize(
    "data",
    [
        b"", b"\xff" * 9, b"[" * 1024, b"null", b'{"wish": "fly", "number": 1}',
        b'{"wish": "join"}', b'{"wish": "join", "number": NaN}', b'{"wish": ["join"], "number": 1}',
        b'{"wish": "join", "number": -1}', b'{"wish": "join", "number": 281474976710656}',
        b'{"wish": "join", "number": 1, "more": "' + b"x" * 1024 + b'"}',
    ],
)  # fmt: skip
def test_what_is_no_wish_is_refused(data):
    """Noise, another wish, a number that cannot be, a giant; an answer cannot be so either."""
    with pytest.raises(AgentInvalid):
        read_wish(data)
    with pytest.raises(AgentInvalid):
        read_answer(data)


def test_wishes_that_are_none_are_counted_and_an_operator_is_answered(fleet, victim, run):
    """Garbage does nothing; then the robot joins when asked, and leaves when asked."""
    robot, session = victim
    for data in (b"\xff" * 9, b'{"wish": "fly", "number": 1}'):
        send(session, robot_key("ask"), data)
    fleet.wait(lambda: refused(robot, "(2 so far)"), "that two are refused")
    assert refused(robot, "an operator asks what is none")
    end = robot.endpoint
    status, said, complaints = run("agents", "ask", "Fortuna", "join", "--connect", end)
    assert (status, complaints) == (0, "")
    assert said.splitlines()[0] == "Fortuna is asked to join: it is left"
    fleet.wait(lambda: robot.phase == "attached", "that it attaches")
    status, said, _ = run("agents", "ask", "Fortuna", "leave", "--connect", end)
    fleet.wait(lambda: robot.phase == "left", "that it leaves")
    status, said, _ = run("agents", "ask", "Fortuna", "move", "--connect", end)
    assert status == 1
    assert "Fortuna is not attached: it cannot move" in said
    status, _, complaints = run("agents", "ask", "Nobody", "leave", "--connect", end)
    assert (status, complaints) == (2, "no robot Nobody is on the network\n")


def test_a_robot_that_tells_two_stories_is_told_of(fleet, victim):
    """One version with two contents; it is asked whether the name is in use twice."""
    robot, session = victim
    one = Record("Mallory", LIVES, 1, Phase.WAITING, 1)
    for record in (one, msgspec.structs.replace(one, ticket=2)):
        send(session, own_keys(MISSION, "Mallory").to_all, encode(Put(record)))
    fleet.wait(lambda: bool(robot.reports("two stories")), "that two stories are noticed")
    assert robot.reports("two stories")[0].startswith("Mallory tells two stories")


def test_one_that_speaks_in_a_robot_s_name_is_refuted(fleet, victim):
    """What it never said is answered with a higher version; it goes on."""
    robot, session = victim
    said = Record("Fortuna", LIVES * 9, 7, Phase.LEFT)
    send(session, own_keys(MISSION, "Fortuna").to_all, encode(Put(said)))
    fleet.wait(lambda: robot.record["incarnation"] > LIVES * 9, "that it is refuted")
    assert "someone else speaks as Fortuna" in robot.reports("refuted")[0]


def test_other_protocols_are_told_of(fleet, victim):
    """Robots of another version do not hear each other, and know why."""
    robot, session = victim
    token = session.liveliness().declare_token(Keys("99", MISSION, "Zephyr").alive)
    fleet.wait(lambda: bool(robot.reports("stranger")), "that a stranger is noticed")
    assert "by protocol 99" in robot.reports("stranger")[0]
    token.undeclare()


def robot_key(what):
    """Return a key of the robot's body."""
    return getattr(own_keys(MISSION, "Fortuna"), what)
