import pytest

from agents_by_hand import Crew, planner
from swarmgrasp.agents.network import Watch
from swarmgrasp.agents.protocol import Phase, Place, Record
from swarmgrasp.agents.protocol import events as ev
from swarmgrasp.agents.protocol.record import LIVES
from swarmgrasp.agents.protocol.wire import Ack, Beat, Put, Records


def seen(data):
    """Return robots by name."""
    return {robot["name"]: robot for robot in data["robots"]}


def test_a_watcher_sees_who_is_where_and_who_has_confirmed_it():
    """From what robots tell each other alone; all of the form is plain."""
    crew = Crew("R1", "R2", "R3")
    watch = Watch(crew.planner)
    for name in crew.agents:
        watch.take(0.0, ev.Up(name))
    crew.join("R1")
    crew.wait(4.0)
    crew.tell("R1", ev.AtPlace())
    arrived = crew["R1"]
    watch.take(5.0, ev.Received("R1", Put(arrived)))
    acks = [m for n, m in crew.post if n in {"R2", "R3"}]
    assert acks
    for name in ("R2", "R3"):
        watch.take(5.0, ev.Received(name, Ack(arrived.asks_for, crew[name])))
    robot = seen(watch.data(7.0))["R1"]
    assert (robot["phase"], robot["confirmed_by"], robot["silent"]) == ("arrived", ["R2", "R3"], 2)
    assert robot["place"] == {
        "x": arrived.place.x, "y": arrived.place.y, "direction": arrived.place.direction,
        "steers": 0.0,
    }  # fmt: skip
    crew.deliver()
    crew.tell("R1", ev.Fastened(arrived.place))
    watch.take(8.0, ev.Received("R1", Put(crew["R1"])))
    data = watch.data(8.0)
    assert data["alone"] == ["A1", "A2", "A3", "A4"]
    assert data["quality"] == data["certified"] == crew["R1"].lower > 0.0
    assert data["conflicts"] == []
    watch.take(9.0, ev.Down("R1"))
    assert seen(watch.data(9.0))["R1"]["running"] is False


def test_a_watcher_that_came_late_asks_for_what_it_lacks():
    """A sign of life with another digest makes it ask, not more often than is good."""
    crew = Crew("R1")
    watch = Watch(crew.planner)
    memory = crew.agents["R1"].memory
    beat = ev.Received("R1", Beat("R1", 1, memory.digest))
    assert watch.take(1.0, beat) == "R1"
    assert watch.take(1.1, beat) == ""
    watch.take(1.2, ev.Received("R1", Records("R1", 1, tuple(memory))))
    assert watch.take(9.0, beat) == ""
    assert list(seen(watch.data(9.0))) == ["R1"]


@pytest.mark.parametrize(
    ("event", "words"),
    [
        (ev.Stranger("R9", "f00"), "R9 works on another mission, f00"),
        (ev.Refuted("R9", "sends what is no message: b"), "R9 sends what is no message: b"),
        (ev.Received("R9", Put(Record("R1", LIVES, 0, Phase.LEFT))),
         "R9 speaks in the name of 'R1'"),
        (ev.Received("R9", Put(Record("R9", LIVES, 0, Phase.ATTACHED, 1, place=Place(9, 9, 0)))),
         "R9 cannot be what it says"),
    ],
)  # fmt: skip
def test_conflicts_are_told_in_words(event, words):
    """Strangers, garbage, forgeries, impossible places."""
    watch = Watch(planner())
    watch.take(0.0, event)
    [told] = watch.data(0.0)["conflicts"]
    assert told.startswith(words)


def test_two_too_close_and_two_stories_are_told():
    """Both facts stay; a person is told which is the later."""
    watch, mission = Watch(planner()), planner()
    place = mission.place((), (), mission.who(Record("R1", 1, 0, Phase.LEFT)))
    one = Record("R1", LIVES, 5, Phase.ATTACHED, 1, place=place)
    two = Record("R2", LIVES, 5, Phase.ATTACHED, 2, place=place)
    watch.take(0.0, ev.Received("R1", Put(one)))
    watch.take(0.0, ev.Received("R2", Put(two)))
    watch.take(0.0, ev.Received("R2", Put(Record("R2", LIVES, 5, Phase.LEFT))))
    close, stories = watch.data(0.0)["conflicts"]
    assert close == "R1 and R2 are too close; R2 is the later one"
    assert stories == "R2 tells two stories with one version"
