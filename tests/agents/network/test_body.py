import json
import math

import pytest

from swarmgrasp import Outline
from swarmgrasp.agents.network import RealBody, StandIn
from swarmgrasp.agents.network.body import order_data
from swarmgrasp.agents.protocol import Place
from swarmgrasp.agents.protocol import events as ev
from swarmgrasp.errors import AgentInvalid

BARGE = Outline([(-20, -5), (20, -5), (20, 5), (-20, 5)])
HERE, THERE = Place(20.0, 0.0, math.pi), Place(-20.0, 0.0, 0.0)


def told(body, event, **more):
    """Tell a body something as its software does."""
    return body.told(json.dumps({"event": event, **more}).encode())


def test_a_stand_in_travels_fastens_and_lets_go():
    """It is where it should be after its way, and not before."""
    body = StandIn("Ajax", BARGE, 2.0, 1.5, HERE)
    body.order(10.0, 1, ev.Go(THERE))
    assert body.wake == 10.0 + 40.0 / 2.0
    assert body.due(29.9) == []
    assert body.due(30.0) == [ev.AtPlace()]
    body.order(30.0, 2, ev.Fasten(THERE))
    assert (body.wake, body.due(31.5)) == (31.5, [ev.Fastened(THERE)])
    body.order(40.0, 3, ev.Loosen())
    assert (body.due(41.5), body.wake) == ([ev.Loosened()], math.inf)


def test_a_stand_in_turns_on_its_way():
    """It goes on from where it is, not from where it started."""
    body = StandIn("Ajax", BARGE, 1.0, 0.0, HERE)
    body.order(0.0, 1, ev.Go(THERE))
    body.order(10.0, 2, ev.Go(HERE))
    assert body.wake == 20.0
    body.order(15.0, 3, ev.Halt())
    assert body.wake == math.inf
    body.order(99.0, 4, ev.Go(THERE))
    assert body.wake == 99.0 + 35.0


def test_orders_are_plain():
    """Numbered, in metres and radians."""
    assert order_data(ev.Go(HERE), 3) == {
        "order": "go", "number": 3, "x": 20.0, "y": 0.0, "direction": math.pi, "steers": 0.0,
    }  # fmt: skip
    assert order_data(ev.Loosen(), 4) == {"order": "let go", "number": 4}


def test_a_real_robot_is_believed_about_its_present_order_only():
    """What is told of an order that was replaced is not heeded."""
    body = RealBody()
    body.order(0.0, 1, ev.Go(HERE))
    body.order(0.0, 2, ev.Go(THERE))
    assert told(body, "at place", order=1) == []
    assert told(body, "at place", order=2) == told(body, "at place") == [ev.AtPlace()]
    body.order(0.0, 3, ev.Fasten(THERE))
    assert told(body, "at place") == []
    assert told(body, "fastened") == [ev.Fastened(THERE)]
    told(body, "pose", x=-20.1, y=0.3, direction=0.01)
    assert told(body, "fastened") == [ev.Fastened(Place(-20.1, 0.3, 0.01))]
    measured = told(body, "fastened", x=-20.2, y=0.4, direction=0.02)
    assert measured == [ev.Fastened(Place(-20.2, 0.4, 0.02))]
    assert told(body, "refused") == [ev.Refused()]
    assert told(body, "loosened") == [ev.Loosened()]
    assert told(body, "witness", robot="Boreas") == [ev.Witness("Boreas")]
    assert [type(e).__name__ for w in ("join", "leave", "move") for e in told(body, w)] == [
        "Join", "Leave", "Move",
    ]  # fmt: skip


@pytest.mark.parametrize(
    ("data", "fault"),
    [
        (b"at place", "'at place' is no event; the events are at place, fastened"),
        (b"[" * 3000, "is no event"),
        (b'{"event": "fastend"}', "did you mean 'fastened'"),
        (b'{"event": ["fastened"]}', "is no event"),
        (b'{"event": "fastened", "x": 1, "y": NaN, "direction": 0}', "should have the numbers"),
        (b'{"event": "fastened", "x": 1e300, "y": 0, "direction": 0}', "should have the numbers"),
        (b'{"event": "fastened"}', "says no x, y and direction, and none is known"),
        (b'{"event": "witness", "robot": "a/b"}', "it should name a robot"),
        (b'{"event": "pose"}' + b" " * 9999, "at most 4096 are read"),
    ],
)
def test_what_software_says_wrongly_is_told(data, fault):
    """Garbage, NaN, giants and slips: one sentence each."""
    with pytest.raises(AgentInvalid, match=r".") as error:
        RealBody().told(data)
    assert fault in error.value.faults[0]


def test_a_stand_in_finds_out_by_itself():
    """It may be asked to come, to leave and to move, and nothing else."""
    body = StandIn("Ajax", BARGE, 1.0, 0.0)
    assert told(body, "leave") == [ev.Leave()]
    with pytest.raises(AgentInvalid, match="finds out by itself"):
        told(body, "fastened")
    with pytest.raises(AgentInvalid, match="the speed is 0"):
        StandIn("Ajax", BARGE, 0.0, 1.0)
