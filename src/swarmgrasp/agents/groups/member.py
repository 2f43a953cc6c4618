"""One robot of a swarm in groups: events in, effects out; no clock, no chance, no network.

Within its group it is an `Agent`. What is added: it learns which group to join from the slots of
all; and of those of a group that hold the object, the first by name that is heard writes the
group's slot.
"""

from collections import Counter
from dataclasses import dataclass

from swarmgrasp.agents.groups.parts import Parts
from swarmgrasp.agents.groups.planner import GroupPlanner, check_mission
from swarmgrasp.agents.groups.seeking import MOST_SOUGHT, Elsewhere, Seek
from swarmgrasp.agents.groups.slot import Slot
from swarmgrasp.agents.groups.slots import Slots
from swarmgrasp.agents.protocol.agent import NEVER, Agent
from swarmgrasp.agents.protocol.events import (
    EVERYONE,
    Effect,
    Event,
    Join,
    Leave,
    Received,
    Report,
    Send,
    Start,
    Witness,
)
from swarmgrasp.agents.protocol.hearing import Hearing
from swarmgrasp.agents.protocol.order import in_order
from swarmgrasp.agents.protocol.planner import basis_of
from swarmgrasp.agents.protocol.record import LIVES, Phase, Record, check_id
from swarmgrasp.agents.protocol.settings import Settings
from swarmgrasp.agents.protocol.state import State
from swarmgrasp.errors import MessageInvalid, NowhereToAttach
from swarmgrasp.placement import Problem

LATE = 3
"""Old words of a group, one after the other, from which on robots of all groups correct them."""


@dataclass(frozen=True)
class SlotsTold:
    """Slots came in from a robot."""

    sender: str
    slots: tuple[Slot, ...]


@dataclass(frozen=True)
class Wondered:
    """A robot asks for all slots."""

    sender: str


@dataclass(frozen=True)
class Sought:
    """Another group looks for silent robots, or a robot answers that it is elsewhere."""

    sender: str
    message: Seek | Elsewhere


@dataclass(frozen=True)
class Heard:
    """A message came in within a group."""

    group: int
    received: Received


@dataclass(frozen=True)
class Within:
    """Send a message within a group, to whom it says there."""

    group: int
    send: Send


@dataclass(frozen=True)
class Tell:
    """Send slots to a robot, or to `EVERYONE` of all groups."""

    to: str
    slots: tuple[Slot, ...]


@dataclass(frozen=True)
class Wonder:
    """Ask anyone, of any group, for all slots."""


@dataclass(frozen=True)
class Look:
    """Look for silent robots, among `EVERYONE`; or answer one who does."""

    to: str
    message: Seek | Elsewhere


MemberEvent = Event | SlotsTold | Wondered | Sought | Heard
MemberEffect = Effect | Within | Tell | Wonder | Look


class Member:
    """One robot's decisions in a swarm of groups.

    Parameters
    ----------
    name : str
    problem : Problem
        The mission.
    parts : Parts
        Of the groups.
    settings : Settings, optional
    incarnation : int
        As for `Agent`.
    group : int
        That of its former life; -1 for none.
    state : State, optional
        What it knew in its former life, within that group.

    Raises
    ------
    AgentInvalid
        If the mission asks for more than summaries tell.
    """

    def __init__(
        self, name: str, problem: Problem, parts: Parts, settings: Settings | None = None, *,
        incarnation: int = LIVES, group: int = -1, state: State | None = None,
    ) -> None:  # fmt: skip
        check_mission(problem)
        self.name, self.settings = name, settings or Settings()
        self.slots = Slots(problem.swarm, parts)
        self.agent: Agent | None = None
        """Within its group; None while it has none."""
        self.planner: GroupPlanner | None = None
        """Its group's."""
        self.group = -1
        self._problem, self._incarnation = problem, incarnation
        self._away = Record(check_id(name), incarnation, 0, Phase.LEFT)
        self._old_group, self._old_state = group, state
        self._old_words = Counter[int]()
        self._wants, self._ready_by = False, NEVER
        self._time = Hearing(self.settings.silent)
        self._next_look = self._next_tell = self._next_correction = self._next_seek = 0.0

    @property
    def record(self) -> Record:
        """What it says of itself within its group; that it is at none while it has none."""
        return self._away if self.agent is None else self.agent.record

    @property
    def wake(self) -> float:
        """When to send a `Tick` at the latest, by the given clock [s]."""
        if self.agent is not None:
            return min(self._time.clock_at(self._next_look), self.agent.wake)
        times = [self._next_look, self._ready_by] if self._wants else [self._next_look]
        return self._time.clock_at(min(times))

    def handle(self, clock: float, event: MemberEvent) -> list[MemberEffect]:
        """Take an event, and return what is to be done about it.

        Parameters
        ----------
        clock : float [s]
            By any steady clock of this robot's own.
        event : MemberEvent
        """
        self._time.advance(clock)
        now, out = self._time.now, list[MemberEffect]()
        match event:
            case SlotsTold(sender, slots):
                out += self._take(sender, slots)
                self._ready_by = min(self._ready_by, now)
            case Wondered(sender):
                out.append(Tell(sender, tuple(self.slots)))
            case Sought(sender, message):
                out += self._answer(clock, sender, message)
            case Heard(group, received):
                if group == self.group:
                    out += self._pass(clock, received)
            case Start(attached):
                out.append(Wonder())
                self._ready_by = now + self.settings.ask
                group = self._old_group
                if attached is not None:
                    self._wants, group = True, self.slots.parts.at((attached.x, attached.y))
                if group >= 0:
                    self._enter(group, self._old_state if group == self._old_group else None)
                    out += self._pass(clock, event)
                    self._wants = self.record.phase is not Phase.LEFT
            case Join():
                self._wants = True
                out += self._pass(clock, event)
            case Leave():
                self._wants = False
                out += self._pass(clock, event)
            case _:
                out += self._pass(clock, event)
        if self._wants and self.agent is None and now >= self._ready_by:
            out += self._join(clock)
        if now >= self._next_look:
            self._next_look = now + self.settings.beat
            out += self._move_on(clock)
            out += self._write() + self._seek()
        return out

    def _take(self, sender: str, slots: tuple[Slot, ...]) -> list[MemberEffect]:
        """Take in slots; tell of those that cannot be."""
        out: list[MemberEffect] = []
        for slot in slots:
            try:
                self.slots.merge(slot)
            except MessageInvalid as error:
                words = f"{sender} is refused: its {error.faults[0]}"
                out.append(Report("refused", words, (sender,)))
            else:
                out += self._correct(sender, slot)
        return out

    def _correct(self, sender: str, slot: Slot) -> list[MemberEffect]:
        """Tell a writer that its slot is old: its own group at once, all others if that lasts."""
        known, now = self.slots.get(slot.group), self._time.now
        if known is None or slot.version >= known.version:
            self._old_words[slot.group] = 0
            return []
        self._old_words[slot.group] += 1
        is_late = self._old_words[slot.group] >= LATE
        if now < self._next_correction or not (is_late or slot.group == self.group):
            return []
        self._next_correction = now + self.settings.silent
        return [Tell(sender, (known,))]

    def _enter(self, group: int, state: State | None = None) -> None:
        """Become a robot of a group, with what it knew of it."""
        self.group = group
        self.planner = GroupPlanner(self._problem, self.slots, group)
        self._incarnation += 1
        self.agent = Agent(
            self.name, self.planner, self.settings, incarnation=self._incarnation, state=state
        )

    def _pass(self, clock: float, event: Event) -> list[MemberEffect]:
        """Hand an event to the agent within the group."""
        if self.agent is None:
            return []
        effects = self.agent.handle(clock, event)
        return [Within(self.group, e) if isinstance(e, Send) else e for e in effects]

    def _join(self, clock: float) -> list[MemberEffect]:
        """Join the group in whose part the best place is."""
        group = self._best_group()
        if group is None:
            self._ready_by = self._time.now + self.settings.beat
            return []
        self._enter(group)
        return [*self._pass(clock, Start()), *self._pass(clock, Join())]

    def _best_group(self) -> int | None:
        """Return the group in whose part the best place is, by all slots; None without room."""
        problem, parts = self._problem, self.slots.parts
        roomy = {group for group in range(len(parts)) if self._has_room(group)}
        near = parts.outline.stretches_near(problem.swarm.contacts, problem.spacing)
        try:
            found = self.slots.everyone.place(
                parts.outline, problem.newcomer, problem.zones,
                (*problem.no_go, *parts.others(roomy), *near),
            )  # fmt: skip
        except NowhereToAttach:
            return None
        return parts.at(found.robot.contact)

    def _has_room(self, group: int) -> bool:
        """Tell whether a group may have room: nobody says that it has none."""
        slot = self.slots.get(group)
        return slot is None or slot.has_room

    def _move_on(self, clock: float) -> list[MemberEffect]:
        """Leave a group that has no room, if another has."""
        if self.agent is None or self.agent.record.phase is not Phase.WAITING:
            return []
        slot = self.slots.get(self.group)
        if slot is None or slot.has_room:
            return []
        if not any(self._has_room(group) for group in range(len(self.slots.parts))):
            return []
        out = self._pass(clock, Leave())
        self.agent, self.group, self._ready_by = None, -1, self._time.now
        return [*out, *self._join(clock)]

    def _seek(self) -> list[MemberEffect]:
        """Look for silent robots of the group elsewhere, as the first by name that is heard."""
        agent, now = self.agent, self._time.now
        if agent is None or not agent.hearing.has_listened or now < self._next_seek:
            return []
        if self.name > min(agent.hearing.heard, default=self.name):
            return []
        silent = [r for r in agent.view.settled if not agent.hearing.is_heard(r.id)]
        robots = tuple((r.id, r.incarnation) for r in silent if r.id != self.name)
        self._next_seek = now + self.settings.forget
        return [Look(EVERYONE, Seek(self.group, robots[:MOST_SOUGHT]))] if robots else []

    def _answer(self, clock: float, sender: str, message: Seek | Elsewhere) -> list[MemberEffect]:
        """Say that this robot is elsewhere; or testify that another one is."""
        match message:
            case Seek(group, robots):
                number = dict(robots).get(self.name)
                if group == self.group or number is None:
                    return []
                return [Look(sender, Elsewhere(group, number))]
            case Elsewhere(group, number):
                known = self.agent.memory.get(sender) if self.agent else None
                if group != self.group or known is None or known.incarnation != number:
                    return []
                return self._pass(clock, Witness(sender))

    def _write(self) -> list[MemberEffect]:
        """Write the group's slot, if that is this robot's task, and tell it again now and then."""
        agent, planner = self.agent, self.planner
        if agent is None or planner is None or not agent.hearing.has_listened:
            return []
        holding = in_order(agent.view.holding, planner)
        heard = [row.id for row in holding if agent.hearing.is_heard(row.id)]
        known = self.slots.get(self.group)
        is_holding = agent.record.phase >= Phase.ATTACHED
        is_last = not heard and known is not None and known.writer == self.name and known.count > 0
        if not (is_holding and self.name <= min(heard, default=self.name)) and not is_last:
            return []
        present = {row.id for row in planner.present}
        basis = basis_of(row for row in holding if row.id not in present)
        if known is None or known.basis != basis or known.writer != self.name:
            turn = 0 if known is None else known.turn + (known.writer != self.name)
            sequence = 0 if known is None else known.sequence + 1
            known = planner.slot(holding, self.name, turn, sequence)
            self.slots.merge(known)
        elif self._time.now < self._next_tell:
            return []
        self._next_tell = self._time.now + self.settings.silent
        return [Tell(EVERYONE, (known,))]
