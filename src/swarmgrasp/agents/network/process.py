"""One robot's process: one queue, one thread; what it promises is on the disk before it is said.

A clock that goes on while the machine sleeps is used, and no other: no time is ever compared with
another robot's.
"""

import json
import os
import time
from collections.abc import Callable, Iterable
from contextlib import suppress
from pathlib import Path
from queue import Empty
from threading import Thread
from typing import Any

from swarmgrasp.agents.network.asking import Answer, answer_bytes, read_wish
from swarmgrasp.agents.network.body import WISHES, Body, order_data
from swarmgrasp.agents.network.ears import Item
from swarmgrasp.agents.network.plain import record_data
from swarmgrasp.agents.network.transport import Transport
from swarmgrasp.agents.protocol.agent import Agent
from swarmgrasp.agents.protocol.events import (
    Cut,
    Down,
    Effect,
    Event,
    Fasten,
    Go,
    Halt,
    Join,
    Leave,
    Loosen,
    MakePlan,
    Planned,
    Received,
    Refuted,
    Report,
    Send,
    Start,
    Tick,
    Up,
)
from swarmgrasp.agents.protocol.record import LIVES, Phase, Place, Record
from swarmgrasp.agents.protocol.state import State, read_state, state_bytes
from swarmgrasp.agents.protocol.wire import Ack, Beat, Put, Records
from swarmgrasp.errors import AgentInvalid, NetworkFailed
from swarmgrasp.files import read_fault, write_whole

AT_ONCE = 64
"""Items of the queue that are taken before what they lead to is sent."""
MOST_TOLD = 4
"""Reports that an operator gets."""
MOST_STATE = 64 << 20
"""Bytes of a state."""

Tell = Callable[[dict[str, Any]], None]


def steady_clock() -> float:
    """Return a time [s] that never goes back, and goes on while the machine sleeps."""
    return time.clock_gettime(_CLOCK)


_CLOCK = getattr(time, "CLOCK_BOOTTIME", time.CLOCK_MONOTONIC)


class Store:
    """The file that outlives a process.

    Parameters
    ----------
    path : Path
    mission, name : str
        Whose it is.
    """

    def __init__(self, path: Path, mission: str, name: str) -> None:
        self.path, self._mission, self._name = path, mission, name
        self._kept = b""
        self.fault = ""
        """Why nothing is kept at present."""

    def read(self) -> State | None:
        """Return what the former life knew; None if there was none.

        Raises
        ------
        AgentInvalid
            If the file cannot be read, or is another robot's or another mission's.
        """
        try:
            with self.path.open("rb") as file:
                data = file.read(MOST_STATE)
        except FileNotFoundError:
            return None
        except OSError as error:
            raise AgentInvalid(read_fault(self.path, error)) from None
        try:
            return read_state(data, self._mission, self._name)
        except AgentInvalid as error:
            raise AgentInvalid(f"{self.path}: {fault}" for fault in error.faults) from None

    def write(self, state: State) -> str:
        """Keep a state whole or not at all; return what a person should know, or "".

        If it cannot be written, the old file goes, so that the next life knows that it knows
        nothing instead of believing what is no longer so; that is safe, and this one goes on.

        Raises
        ------
        AgentInvalid
            If the old file cannot be removed either: it is not safe to go on.
        """
        data = state_bytes(state, self._mission, self._name)
        if data == self._kept:
            return ""
        had_fault = self.fault
        try:
            write_whole(self.path, data, durable=True)
        except OSError as error:
            self._kept, self.fault = b"", error.strerror or str(error)
            self._remove()
            if had_fault:
                return ""
            return (
                f"{self._name} cannot keep its state in {self.path}: {self.fault}; it goes on, and "
                "if its process ends the next one begins without memory"
            )
        self._kept, self.fault = data, ""
        return f"{self._name} keeps its state in {self.path} again" if had_fault else ""

    def _remove(self) -> None:
        """Leave no old state behind."""
        try:
            self.path.unlink(missing_ok=True)
        except OSError as error:
            raise AgentInvalid(
                f"{self.path}: cannot be written ({self.fault}) nor removed "
                f"({error.strerror or error}): this process ends, since the next one would "
                "remember what is no longer so"
            ) from None


def incarnation_of(state: State | None, name: str) -> int:
    """Return the number of this start: one more than the last, and twenty bits of chance.

    Parameters
    ----------
    state : State, optional
        What the former life has kept.
    name : str
        The robot's.
    """
    records = state.records if state else ()
    last = max((record.incarnation for record in records if record.id == name), default=0)
    return (last // LIVES + 1) * LIVES + int.from_bytes(os.urandom(4), "big") % LIVES


class Process:
    """The loop of one robot.

    Parameters
    ----------
    agent : Agent
    transport : Transport
    body : Body
    tell : callable
        Takes plain data for people and programs: reports, the robot's own record, orders, who is
        there and who has ended, and what is heard of others.
    store : Store, optional
    clock : callable, optional
        Any steady clock [s].
    """

    def __init__(
        self, agent: Agent, transport: Transport, body: Body, tell: Tell, *,
        store: Store | None = None, clock: Callable[[], float] = steady_clock,
    ) -> None:  # fmt: skip
        self.agent, self.transport, self.body = agent, transport, body
        self._tell, self._store, self._clock = tell, store, clock
        self._ends = False
        self._orders = 0
        self._order: bytes = b""
        self._wishes: list[int] = []
        self._told_record: Record | None = None

    def stop(self) -> None:
        """End soon; may be called from a signal's handler and from other threads."""
        self.transport.inbox.put(Item("end"))

    def run(self, attached: Place | None, joins: bool) -> None:
        """Be this robot until told to end.

        Parameters
        ----------
        attached : Place, optional
            Where it holds the object, if it does.
        joins : bool
            Whether it comes by itself.

        Raises
        ------
        NetworkFailed
            If another process speaks in its name.
        AgentInvalid
            If it can neither keep its state nor remove the old one.
        """
        self._tell({"begins": self.agent.record.incarnation})
        for record in self.agent.memory:
            self._trace_record(record)
        self._act([Start(attached), *([Join()] if joins else [])])
        while not self._ends:
            self._act(self._events(self._next()))
        self._tell({"traffic": vars(self.transport.traffic)})

    def _next(self) -> list[Item]:
        """Wait for something to happen; return what has come in meanwhile."""
        inbox = self.transport.inbox
        wake = min(self.agent.wake, self.body.wake, self.transport.wake)
        items: list[Item] = []
        with suppress(Empty):
            items.append(inbox.get(timeout=max(0.0, wake - self._clock())))
            while len(items) < AT_ONCE:
                items.append(inbox.get_nowait())
        return items

    def _events(self, items: Iterable[Item]) -> list[Event]:
        """Return what has happened."""
        clock, events = self._clock(), list[Event]()
        for item in items:
            match item.what:
                case "end":
                    self._ends = True
                    if self.agent.record.phase <= Phase.ARRIVED:
                        events.append(Leave())  # nobody is to keep a place for it
                case "asked":
                    memory = tuple(self.agent.memory)
                    records = Records(self.agent.name, self.agent.state.clock, memory)
                    self.transport.answer(item, records)
                case "planned":
                    events.append(Planned(item.content))
                case "body":
                    try:
                        events += self.body.told(item.content)
                    except AgentInvalid as error:
                        events.append(Refuted(f"{self.agent.name}'s software", error.faults[0]))
                case "wish":
                    try:
                        wish = read_wish(item.content)
                    except AgentInvalid as error:
                        events.append(Refuted("an operator", f"asks what is none: {error}"))
                    else:
                        self._wishes.append(wish.number)
                        events.append(WISHES[wish.what]())
                case _:
                    events += self.transport.events(clock, item)
        events += self.transport.due(clock)
        return events + self.body.due(clock)

    def _act(self, events: list[Event]) -> None:
        """Let the agent take events, keep what it promises, and do what it says."""
        effects: list[Effect] = []
        for event in events:
            effects += self.agent.handle(self._clock(), event)
            self._trace(event)
        if self.agent.wake <= self._clock():
            effects += self.agent.handle(self._clock(), Tick())
        if any(_is_promise(effect) for effect in effects):
            self._keep()
        for effect in effects:
            self._do(effect)
        self._answer(effects)
        if self.agent.record != self._told_record:
            self._told_record = self.agent.record
            self._tell({"record": record_data(self.agent.record)})
        for event in events:
            self._check_name(event)

    def _answer(self, effects: list[Effect]) -> None:
        """Tell operators what has come of their wishes."""
        told = [effect for effect in effects if isinstance(effect, Report)]
        words = tuple(report.words for report in told)[:MOST_TOLD]
        refuses = any(report.what == "cannot move" for report in told)
        phase = self.agent.record.phase.name.lower()
        for number in self._wishes:
            self.transport.say_to_operator(answer_bytes(Answer(number, phase, words, refuses)))
        self._wishes.clear()

    def _keep(self) -> None:
        """Keep the state; tell a person if that fails."""
        words = self._store.write(self.agent.state) if self._store else ""
        if words:
            self._tell({"report": "state", "words": words, "about": []})

    def _do(self, effect: Effect) -> None:
        """Do what the agent says."""
        match effect:
            case Send(to, message):
                self.transport.send(to, message)
                if self._order and self.body.repeats and isinstance(message, Beat):
                    self.transport.order(self._order)
            case Report(what, words, about):
                self._tell({"report": what, "words": words, "about": list(about)})
            case MakePlan():
                Thread(target=self._plan, args=(effect,), daemon=True).start()
            case Go() | Halt() | Fasten() | Loosen():
                self._orders += 1
                self.body.order(self._clock(), self._orders, effect)
                told = order_data(effect, self._orders)
                self._order = json.dumps(told).encode()
                self.transport.order(self._order)
                self._tell(told)

    def _plan(self, effect: MakePlan) -> None:
        """Make a joint plan, beside all else."""
        plan = None
        try:
            plan = self.agent.planner.plan(effect.beside, effect.names, effect.who)
        finally:
            self.transport.inbox.put(Item("planned", "", plan))

    def _trace(self, event: Event) -> None:
        """Tell programs who is there, who has ended, and what is new of others."""
        match event:
            case Up(name):
                self._tell({"up": name})
            case Down(name):
                self._tell({"down": name})
            case Cut():
                self._tell({"cut": True})
            case Received(_, Put(record) | Ack(_, record)):
                self._trace_record(record)
            case Received(_, Records(_, _, records)):
                for record in records:
                    self._trace_record(record)

    def _trace_record(self, record: Record) -> None:
        """Tell that a record was learnt, if it was."""
        if record.id != self.agent.name and self.agent.memory.get(record.id) is record:
            self._tell({"heard": record_data(record)})

    def _check_name(self, event: Event) -> None:
        """End if another process speaks in this robot's name, and it is the other's."""
        match event:
            case Received(sender, Put(record)) if sender == self.agent.name:
                mine = self.agent.record
                theirs = record.is_at_its_place, record.incarnation % LIVES
                if theirs > (mine.is_at_its_place, mine.incarnation % LIVES):
                    raise NetworkFailed(
                        f"another process speaks as {mine.id}, and {mine.id} is the other's; "
                        "this one ends: give it another name"
                    )


def _is_promise(effect: Effect) -> bool:
    """Tell whether an effect is one that a next life has to know of."""
    return isinstance(effect, Fasten | Loosen) or (
        isinstance(effect, Send) and isinstance(effect.message, Put | Ack)
    )
