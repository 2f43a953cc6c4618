"""Each rule by which robots agree, on one, two or three of them."""

import math
from dataclasses import replace

import msgspec
import pytest

from agents_by_hand import BARGE, Crew, kinds, planner, told
from swarmgrasp import Problem, place
from swarmgrasp.agents.protocol import Agent, Kind, Phase, Place, Settings, read_state, state_bytes
from swarmgrasp.agents.protocol import events as ev
from swarmgrasp.agents.protocol.record import LIVES
from swarmgrasp.agents.protocol.wire import Ack, Beat, Put, Records
from swarmgrasp.errors import AgentInvalid, MessageInvalid, SwarmGraspError


def central(mission, count):
    """Return the places of robots placed one after the other."""
    problem, places = mission.problem, []
    for k in range(count):
        found = place(problem)
        robot = found.robot
        places.append(Place(*robot.contact, robot.direction, robot.steers))
        problem = problem.with_swarm(problem.swarm.with_robot(replace(robot, name=f"T{k}")))
    return places


def test_places_are_those_of_one_after_the_other():
    """Final places are the central ones in the order of tickets, bit for bit (guarantee E)."""
    crew = Crew("R1", "R2", "R3")
    crew.join("R2", "R1", "R3")
    order = sorted(crew.agents, key=lambda n: crew[n].order)
    assert order == ["R2", "R1", "R3"]
    assert [crew[n].place for n in order] == central(crew.planner, 3)


def test_a_robot_computes_the_places_of_those_before_it_and_does_not_wait():
    """It reckons with a robot whose claim it has never heard, only that it is coming (R1)."""
    crew = Crew("R1", "R2")
    crew.tell("R1", ev.Join())
    crew.wait(1.0)
    waiting = msgspec.structs.replace(
        crew["R1"], phase=Phase.WAITING, place=None, basis=b"", sequence=99, lower=0.0
    )
    crew.agents["R2"].memory.merge(waiting)
    crew.tell("R2", ev.Join())
    crew.wait(1.0, among=["R2"])
    assert crew["R2"].place == central(crew.planner, 2)[1]


def test_a_robot_keeps_clear_of_those_behind_it_that_are_at_their_place():
    """A later robot that has arrived first is not counted, and not run into."""
    crew = Crew("R1", "R2", mission=planner(zone=(0.0, 9.0)))  # room for two or three
    crew.join("R1", "R2")
    crew.attach("R2")
    assert crew["R2"].phase is Phase.ATTACHED
    one, two = crew["R1"].place, crew["R2"].place
    assert math.hypot(one.x - two.x, one.y - two.y) >= 4.0 - 1e-6


def test_nobody_fastens_before_all_that_are_heard_have_confirmed():
    """An arrival waits for the word of each robot that is heard, and says for whom (R6)."""
    crew = Crew("R1", "R2", "R3")
    crew.join("R1")
    crew.wait(5.0)
    crew.tell("R1", ev.AtPlace())
    crew.deliver(keep=lambda m: m[0] == "R3" and isinstance(m[2], Ack))
    crew.tell("R1", ev.Tick())
    assert crew["R1"].phase is Phase.ARRIVED
    assert crew.agents["R1"].waits_for == ("R3",)
    crew.deliver()
    assert crew["R1"].phase is Phase.FASTENING
    assert crew["R1"].sequence > 0


def test_a_confirmation_carries_the_confirmer_s_own_place():
    """Who confirms while it fastens at the same place is given way to (R4, R5)."""
    crew = Crew("R1", "R2", mission=planner(zone=(0.0, 3.0)))  # room for one
    crew.join("R1")
    crew.wait(4.0)
    crew.tell("R1", ev.AtPlace())
    [(_, asked)] = [m for m in crew.post if isinstance(m[1].message, Put)][:1]
    rival = crew.agents["R2"]
    fastening = msgspec.structs.replace(
        rival.record, phase=Phase.FASTENING, ticket=9, arrival=1, place=crew["R1"].place,
        sequence=rival.record.sequence + 1,
    )  # fmt: skip
    crew.post = []
    effects = crew.tell("R1", ev.Received("R2", Ack(crew["R1"].asks_for, fastening)))
    assert asked.message.record.phase is Phase.ARRIVED
    assert not any(isinstance(e, ev.Fasten) for e in effects)
    assert "gives way" in told(effects)
    assert crew["R1"].phase is Phase.WAITING


def test_of_two_that_have_arrived_at_one_place_the_later_gives_way():
    """Two that did not hear each other come to one place: the earlier ticket stays."""
    crew = Crew("R1", "R2")
    for name in crew.agents:
        crew.tell(name, ev.Join())
    crew.wait(1.0, among=[])
    assert crew["R1"].place == crew["R2"].place
    for name in crew.agents:
        crew.tell(name, ev.AtPlace())
    crew.deliver()
    assert crew["R1"].phase is Phase.ARRIVED
    assert crew["R2"].phase is Phase.COMING
    assert crew["R2"].place != crew["R1"].place
    assert ("R2", "gives way") in [(n, e.what) for n, e in crew.log if isinstance(e, ev.Report)]


def test_a_newborn_listens_before_it_fastens():
    """Who has just begun to listen does not know who is there."""
    crew = Crew("R1")
    crew.tell("R1", ev.Join())
    crew.wait(1.0)
    crew.tell("R1", ev.AtPlace())
    crew.wait(1.0)
    assert crew["R1"].phase is Phase.ARRIVED
    crew.wait(2.0)
    assert crew["R1"].phase is Phase.FASTENING


def test_listening_begins_with_the_process_whatever_its_clock_shows():
    """A clock that begins at a million, or before 0: it listens first, and gives signs of life."""
    for begin in (1e6, -1e6):
        agent = Agent("R1", planner(), Settings(gather=0.0, ask=0.001))
        agent.handle(begin, ev.Start())
        agent.handle(begin, ev.Join())
        agent.handle(begin + 0.01, ev.Tick())
        effects = agent.handle(begin + 0.02, ev.AtPlace())
        assert agent.record.phase is Phase.ARRIVED
        for k in range(1, 5):
            assert not any(isinstance(e, ev.Fasten) for e in effects)
            effects = agent.handle(begin + 0.9 * k, ev.Tick())
        assert any(isinstance(e, ev.Fasten) for e in effects)


def test_what_was_remembered_counts_until_it_has_been_silent():
    """A new life does not forget at once who was on its way when the former ended."""
    crew = Crew("R1", "R2")
    crew.join("R1", "R2")
    again = Agent("R2", crew.planner, incarnation=2 * LIVES, state=crew.agents["R2"].state)
    again.handle(1e6, ev.Start())
    assert "R1" in [record.id for record in again.view.movers]


def test_a_process_that_was_stopped_takes_its_own_deafness_for_nobody_s_silence():
    """After a gap confirmations are void, listening starts anew, and the heard are still asked."""
    crew = Crew("R1", "R2")
    crew.join("R1")
    crew.wait(5.0)
    crew.tell("R1", ev.AtPlace())
    crew.post = []  # R2 has not heard of it
    crew.clock += 100.0
    effects = crew.tell("R1", ev.Tick())
    assert not any(isinstance(e, ev.Fasten) for e in effects)
    assert crew["R1"].phase is Phase.ARRIVED
    assert crew.agents["R1"].waits_for == ("R2",)
    crew.post = []
    for _ in range(12):  # R2 stays silent, for as long again
        crew.clock += 0.25
        effects = crew.tell("R1", ev.Tick())
        assert not any(isinstance(e, ev.Fasten) for e in effects)
    for _ in range(4):
        crew.clock += 0.25
        effects += crew.tell("R1", ev.Tick())
    assert any(isinstance(e, ev.Fasten) for e in effects)


@pytest.mark.parametrize("jump", [-1e6, 1e9])
def test_a_clock_that_jumps_is_a_gap_and_nothing_else(jump):
    """Whether back or ahead: confirmations are void, and life goes on."""
    crew = Crew("R1", "R2")
    crew.join("R1")
    crew.wait(5.0)
    crew.clock += jump
    crew.wait(6.0)
    crew.attach("R1")
    assert crew["R1"].phase is Phase.ATTACHED


def test_with_a_roster_the_silent_are_waited_for():
    """Everyone on it confirms or is testified gone, heard or not (R6); silence is told."""
    settings = Settings(gather=0.0, worth=0.0, roster=("R1", "R2", "R3"))
    crew = Crew("R1", "R2", settings=settings)
    crew.join("R1")
    crew.tell("R1", ev.AtPlace())
    crew.deliver()
    crew.wait(30.0)
    assert crew["R1"].phase is Phase.ARRIVED
    assert crew.agents["R1"].waits_for == ("R3",)
    crew.wait(10.0, among=["R1"])
    crew.tell("R1", ev.Cut())
    crew.wait(30.0, among=["R1"])
    waits = [e.words for n, e in crew.log if n == "R1" and getattr(e, "what", "") == "waits"]
    assert waits[-1] == "R1 waits for R2 (not heard), R3 (not heard)"


def test_with_a_roster_those_who_have_left_may_have_come_again():
    """Two that knew each other as not there both come while the line is cut: neither attaches."""
    settings = Settings(gather=0.0, worth=0.0, roster=("R1", "R2"))
    crew = Crew("R1", "R2", settings=settings)
    crew.wait(5.0)
    for name in ("R1", "R2"):
        crew.tell(name, ev.Join())
    crew.wait(5.0, among=[])
    assert crew["R1"].place == crew["R2"].place
    for name in ("R1", "R2"):
        crew.tell(name, ev.AtPlace())
    crew.wait(60.0, among=[])
    assert [crew[name].phase for name in ("R1", "R2")] == [Phase.ARRIVED, Phase.ARRIVED]
    crew.wait(5.0)
    assert sorted(crew[name].phase for name in ("R1", "R2")) == [Phase.COMING, Phase.FASTENING]


def test_who_was_not_reckoned_with_takes_a_new_ticket():
    """A later robot that holds the object and never asked did not know of this one (R2)."""
    crew = Crew("R1", "R2")
    crew.tell("R1", ev.Join())
    crew.wait(1.0)
    other = msgspec.structs.replace(
        crew["R2"], phase=Phase.ATTACHED, ticket=7, arrival=1, place=Place(5.0, -5.0, 1.5),
        sequence=50,
    )  # fmt: skip
    before = crew["R1"].ticket
    effects = crew.tell("R1", ev.Received("R2", Put(other)))
    assert "new ticket" in told(effects)
    assert crew["R1"].ticket > 7 > before


def test_a_turn_that_is_not_worth_it_is_not_taken():
    """Under way a robot keeps its place when another is better by less than `worth` (R3)."""
    turns = {}
    for worth in (0.0, 0.5):
        crew = Crew("R1", "R2", settings=Settings(gather=0.0, worth=worth))
        crew.join("R1", "R2")
        before = crew["R2"].place
        crew.tell("R1", ev.AtPlace())
        crew.wait(5.0)
        there = crew["R1"].place
        crew.tell("R1", ev.Fastened(Place(there.x, there.y, there.direction + 0.4)))
        crew.deliver()
        crew.wait(1.0)
        turns[worth] = crew["R2"].place != before
    assert turns == {0.0: True, 0.5: False}


def test_a_place_that_is_seen_to_be_taken_is_left():
    """The robot keeps clear of it, and everyone else takes its word (R8)."""
    crew = Crew("R1", "R2")
    crew.join("R1")
    first = crew["R1"].place
    effects = crew.tell("R1", ev.Refused())
    crew.deliver()
    assert "taken" in told(effects)
    second = crew["R1"].place
    assert math.hypot(first.x - second.x, first.y - second.y) >= 4.0 - 1e-6
    assert crew.agents["R2"].memory.get("R1").place == second


def test_a_place_that_was_seen_to_be_taken_is_tried_again_when_someone_goes():
    """Who waits because its only place was taken comes when the robot that took it leaves."""
    crew = Crew("R1", "R2", mission=planner(zone=(0.0, 3.0)))
    for name in ("R2", "R1"):
        crew.tell(name, ev.Join())
        crew.wait(5.0, among=[])
        if name == "R2":
            crew.tell(name, ev.AtPlace())
            crew.wait(5.0, among=[])
            crew.tell(name, ev.Fastened(crew[name].place))
    crew.tell("R1", ev.Refused())
    crew.wait(2.0)
    assert crew["R1"].phase is Phase.WAITING
    crew.tell("R2", ev.Leave())
    crew.tell("R2", ev.Loosened())
    crew.wait(2.0)
    assert crew["R1"].phase is Phase.COMING


def test_robots_at_their_place_are_never_forgotten_and_those_under_way_are():
    """Silence takes a claim that is on its way; who is at the object stays (R9)."""
    crew = Crew("R1", "R2", "R3")
    crew.join("R1", "R2", "R3")
    crew.attach("R1")
    crew.wait(90.0, among=["R3"])
    view = crew.agents["R3"].view
    assert [r.id for r in view.settled] == ["R1"]
    assert [r.id for r in view.movers] == ["R3"]


def test_a_testimony_removes_a_robot_and_its_own_word_brings_it_back():
    """Seen to be gone it does not count; alive, it says so under a new incarnation (R9, R11)."""
    crew = Crew("R1", "R2")
    crew.join("R1")
    crew.attach("R1")
    crew.tell("R2", ev.Witness("R1"))
    assert crew.agents["R2"].view.settled == ()
    crew.deliver()
    assert [r.id for r in crew.agents["R2"].view.settled] == ["R1"]


def test_a_robot_of_the_mission_without_a_process_can_be_testified_gone():
    """The first robots count from the start, and not after someone saw that they are gone."""
    crew = Crew("R1")
    assert [row.id for row in crew.agents["R1"].view.fixed] == ["A1", "A2", "A3", "A4"]
    crew.tell("R1", ev.Witness("A2"))
    assert [row.id for row in crew.agents["R1"].view.fixed] == ["A1", "A3", "A4"]


def test_one_moves_at_a_time():
    """Of two that ask to let go at once the earlier does, the other takes it back (R10)."""
    crew = Crew("R1", "R2")
    crew.join("R1", "R2")
    crew.attach("R1")
    crew.attach("R2")
    crew.wait(5.0)
    assert "asks" in told(crew.tell("R1", ev.Move()))
    assert "asks" in told(crew.tell("R2", ev.Move()))
    crew.deliver()
    crew.wait(1.0)
    assert crew["R2"].phase is Phase.ATTACHED
    assert crew["R1"].phase is Phase.ASKING
    before = crew["R1"].ticket
    crew.tell("R1", ev.Loosened())
    crew.deliver()
    assert crew["R1"].phase is Phase.COMING
    assert crew["R1"].ticket > before


def test_who_lets_go_confirms_no_other_s_move():
    """Not even that of one before it in the order: that one asks again, and sees it under way."""
    crew = Crew("R1", "R2")
    crew.join("R1", "R2")
    crew.attach("R1")
    crew.attach("R2")
    crew.wait(5.0)
    crew.tell("R2", ev.Move())
    crew.deliver()
    assert "Loosen" in kinds(crew.effects["R2"])
    assert "asks" in told(crew.tell("R1", ev.Move()))
    crew.deliver()
    crew.wait(2.0)
    assert crew["R1"].phase is Phase.ASKING
    crew.tell("R2", ev.Loosened())
    crew.deliver()
    crew.wait(1.0)
    assert crew["R1"].phase is Phase.ATTACHED


def test_nobody_lets_go_below_the_floor():
    """A move that would leave less than the floor is not begun, and the reason is told."""
    crew = Crew("R1", settings=Settings(gather=0.0, floor=1e6))
    crew.join("R1")
    crew.attach("R1")
    [report] = [e for e in crew.tell("R1", ev.Move()) if isinstance(e, ev.Report)]
    assert report.what == "cannot move"
    assert "below" in report.words


def test_the_robot_whose_move_is_best_asks_by_itself():
    """With `improve` the swarm repairs itself, one robot at a time, and then rests."""
    crew = Crew("R1", "R2", settings=Settings(gather=0.0, worth=0.0, improve=0.05))
    crew.join("R1", "R2")
    crew.attach("R1")
    place = crew["R2"].place
    crew.tell("R2", ev.AtPlace())
    crew.wait(5.0)
    crew.tell("R2", ev.Fastened(Place(-20.0, -4.0, 0.3)))  # far from where it should be
    crew.deliver()
    low = crew["R2"].lower
    for _ in range(200):
        crew.wait(0.25)
        for name in crew.agents:
            if any(isinstance(e, ev.Loosen) for e in crew.effects[name]):
                crew.tell(name, ev.Loosened())
                crew.deliver()
                crew.wait(0.5)
                crew.attach(name)
    view = crew.agents["R1"].view
    assert crew.planner.lower(view.holding) > low
    assert place is not None


def test_leaving_is_heard_by_all():
    """A robot that goes lets go first, and then does not count."""
    crew = Crew("R1", "R2")
    crew.join("R1")
    crew.attach("R1")
    assert kinds(crew.tell("R1", ev.Leave())) == ["Loosen"]
    crew.tell("R1", ev.Loosened())
    crew.deliver()
    assert crew["R1"].phase is Phase.LEFT
    assert crew.agents["R2"].view.settled == ()


def test_a_word_of_mine_that_i_did_not_say_is_refuted():
    """A robot whose name is used by another takes a higher version (R11)."""
    crew = Crew("R1", "R2")
    false = msgspec.structs.replace(crew["R1"], sequence=77, lower=5.0)
    before = crew["R1"].incarnation
    effects = crew.tell("R1", ev.Received("R2", Records("R2", 0, (false,))))
    assert "refuted" in told(effects)
    assert crew["R1"].incarnation > before
    assert crew["R1"].version > false.version


def test_two_that_hold_the_object_too_close_are_told_of_and_one_can_be_made_to_go():
    """After a partition both report it; with `resolve` the later one lets go (R12)."""
    for resolve in (False, True):
        settings = Settings(gather=0.0, worth=0.0, resolve=resolve)
        crew = Crew("R1", "R2", settings=settings)
        for name in crew.agents:  # each alone
            crew.tell(name, ev.Join())
        reports = {name: [] for name in crew.agents}
        for name in crew.agents:
            crew.wait(5.0, among=[])
            crew.tell(name, ev.AtPlace())
            crew.wait(5.0, among=[])
            crew.tell(name, ev.Fastened(crew[name].place))
        crew.post = []
        loosened = set()
        for _ in range(60):
            crew.clock += 0.25
            for name in crew.agents:
                crew.tell(name, ev.Tick())
                effects = crew.effects[name]
                while crew.post:
                    to, event = crew.post.pop(0)
                    effects = effects + crew.tell(to, event)
                    reports[to] += told(crew.effects[to])
                loosened |= {name for e in effects if isinstance(e, ev.Loosen)}
        assert all("too close" in told_ for told_ in reports.values())
        assert bool(loosened) == resolve


def test_what_is_hostile_is_dropped_and_counted():
    """Another's name, an absurd ticket, a place off the object, a kind that cannot be (R13)."""
    crew = Crew("R1", "R2")
    agent, known = crew.agents["R1"], dict.fromkeys(["R2"], crew["R2"])
    sound = msgspec.structs.replace(
        crew["R2"], sequence=9, phase=Phase.COMING, ticket=3, place=Place(0.0, -5.0, 1.5)
    )
    bad = [
        msgspec.structs.replace(sound, ticket=1 << 40),
        msgspec.structs.replace(sound, place=Place(0.0, 0.0, 1.5)),
        msgspec.structs.replace(sound, kind=Kind(1.0, "free", 0.3)),
    ]
    for record in bad:
        crew.tell("R1", ev.Received("R2", Put(record)))
        assert agent.memory.get("R2") == known["R2"]
    crew.tell("R1", ev.Received("R3", Put(sound)))  # in the name of another
    assert agent.memory.get("R2") == known["R2"]
    crew.tell("R1", ev.Received("R2", Beat("R2", 1 << 50, b"12345678")))
    assert agent.state.clock < 1 << 20
    crew.tell("R1", ev.Received("R2", Put(sound)))
    assert agent.memory.get("R2") == sound


def test_a_former_life_is_remembered_and_goes_on():
    """With its state a process keeps its place in the order, what it knew and what it promised."""
    crew = Crew("R1", "R2")
    crew.join("R1", "R2")
    mission = crew.planner.mission
    kept = state_bytes(crew.agents["R2"].state, mission, "R2")
    again = Agent(
        "R2", crew.planner, Settings(gather=0.0), incarnation=LIVES + 5,
        state=read_state(kept, mission, "R2"),
    )  # fmt: skip
    old = crew["R2"]
    again.handle(0.0, ev.Start())
    for clock in (0.6, 0.7, 0.8):
        again.handle(clock, ev.Tick())
    assert again.record.ticket == old.ticket
    assert again.record.place == old.place
    assert again.record.version > old.version
    assert again.memory.get("R1") == crew["R1"]


@pytest.mark.parametrize(
    ("mission", "name", "data", "fault"),
    [
        ("m", "R1", b"\x00\x01", "damaged"),
        ("m", "R9", None, "that of R1"),
        ("other", "R1", None, "of the mission"),
    ],
)
def test_a_state_of_another_robot_or_mission_is_refused(mission, name, data, fault):
    """A damaged file, another robot's, another mission's: each in its words."""
    agent = Agent("R1", planner())
    kept = data or state_bytes(agent.state, "m", "R1")
    with pytest.raises(AgentInvalid, match=fault):
        read_state(kept, mission, name)


def test_robots_that_cannot_be_are_refused_at_the_door():
    """Names that are no part of a key, kinds that no newcomer has, periods that cannot work."""
    with pytest.raises(MessageInvalid, match="none of"):
        Agent("a/b", planner())
    with pytest.raises(AgentInvalid, match="half angle"):
        Agent("R1", planner(), kind=Kind(1.0, "free", 0.3))
    with pytest.raises(AgentInvalid, match=r"(?s)silent is.*hold is"):
        Settings(beat=2.0, silent=3.5, hold=90.0)
    with pytest.raises(AgentInvalid, match="roster"):
        Settings(roster=("a/b",))


def test_different_newcomers_are_placed_as_what_they_are():
    """A robot of its own kind is counted with its own limit, by everyone."""
    crew = Crew("R1", "R2")
    strong = Agent(
        "R3", crew.planner, Settings(gather=0.0, worth=0.0), kind=Kind(5.0, "push", 0.2, True),
        incarnation=LIVES + 9,
    )  # fmt: skip
    crew.agents["R3"] = strong
    crew.tell("R3", ev.Start())
    crew.deliver()
    crew.join("R3", "R1")
    assert crew["R3"].place.steers == pytest.approx(0.2)
    rows = crew.agents["R1"].view.holding
    assert [row.id for row in rows] == ["A1", "A2", "A3", "A4"]
    choice = crew["R1"]
    assert choice.lower > 0.0
    assert crew.agents["R1"].planner.lower((*rows,)) < choice.lower


def test_a_mission_robot_s_process_starts_where_the_mission_says():
    """It is attached with ticket 0, and may move with its own limit."""
    crew = Crew("R1")
    agent = Agent("A2", crew.planner, Settings(gather=0.0), incarnation=LIVES)
    crew.agents["A2"] = agent
    (row,) = [row for row in crew.planner.present if row.id == "A2"]
    crew.tell("A2", ev.Start(row.place))
    crew.deliver()
    assert crew["A2"].phase is Phase.ATTACHED
    assert crew["A2"].ticket == 0
    view = crew.agents["R1"].view
    assert [r.id for r in view.fixed] == ["A1", "A3", "A4"]
    assert [r.id for r in view.settled] == ["A2"]


def test_too_few_to_close_the_grasp_are_planned_together():
    """On an empty object the first publishes a joint plan, and everyone takes its place in it."""
    crew = Crew("R1", "R2", "R3", "R4", mission=planner(0))
    for name in crew.agents:
        crew.tell(name, ev.Join())
        crew.deliver()
    crew.wait(2.0)
    ((first, asked),) = [(n, e) for n, e in crew.log if isinstance(e, ev.MakePlan)]
    assert len(asked.names) == 4
    plan = crew.planner.plan(asked.beside, asked.names, asked.who)
    crew.tell(first, ev.Planned(plan))
    crew.deliver()
    crew.wait(1.0)
    places = {name: crew[name].place for name in crew.agents}
    assert places == dict(plan.places)
    for name in asked.names:
        crew.attach(name)
    crew.wait(2.0)
    rows = crew.agents["R1"].view.holding
    assert crew.planner.lower(rows) == pytest.approx(plan.quality, rel=1e-9)
    assert all(crew[name].plan is None for name in crew.agents)


def test_a_plan_that_promises_more_than_it_keeps_is_not_followed():
    """Everyone checks a plan's quality before following it."""
    crew = Crew("R1", "R2", "R3", "R4", mission=planner(0))
    for name in crew.agents:
        crew.tell(name, ev.Join())
        crew.deliver()
    crew.wait(1.0)
    names = sorted(crew.agents, key=lambda n: crew[n].order)
    plan = crew.planner.plan((), names, crew.planner.who(crew[names[0]]))
    boast = msgspec.structs.replace(plan, quality=2.0 * plan.quality)
    before = {name: crew[name].place for name in names[1:]}
    crew.tell(names[0], ev.Planned(boast))
    crew.deliver()
    crew.wait(1.0)
    assert {name: crew[name].place for name in names[1:]} == before


def test_no_room_is_told_and_room_that_comes_is_taken():
    """A robot without a place waits, says so, and goes when another leaves."""
    crew = Crew("R1", "R2", mission=planner(zone=(0.0, 3.0)))
    crew.join("R1", "R2")
    assert crew["R2"].phase is Phase.WAITING
    crew.tell("R1", ev.Leave())
    crew.deliver()
    crew.wait(1.0)
    assert crew["R2"].phase is Phase.COMING


def test_stretches_near_a_point_are_those_of_the_spacing():
    """What is nearer than a distance, in one piece across corners and the first vertex."""
    whole = BARGE.stretches_near((0.0, 0.0), 100.0)
    assert [(s.start, s.end) for s in whole] == [(0.0, BARGE.perimeter)]
    assert BARGE.stretches_near((0.0, 0.0), 4.0) == ()
    (corner,) = BARGE.stretches_near((-20.0, -5.0), 3.0)
    assert (corner.start, corner.end) == pytest.approx((BARGE.perimeter - 3.0, 3.0))
    one, two = BARGE.stretches_near((0.0, 0.0), math.hypot(5.0, 3.0))
    assert (one.start, one.end) == pytest.approx((17.0, 23.0))
    assert (two.start, two.end) == pytest.approx((67.0, 73.0))
    with pytest.raises(SwarmGraspError, match="distance"):
        BARGE.stretches_near((0.0, 0.0), -1.0)
    with pytest.raises(SwarmGraspError, match="finite"):
        BARGE.stretches_near((math.nan, 0.0), 1.0)
    assert isinstance(planner().problem, Problem)
