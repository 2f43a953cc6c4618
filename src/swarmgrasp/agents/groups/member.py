"""One robot of a swarm in groups: events in, effects out; no clock, no chance, no network.

Within its group it is an `Agent`. What is added: it learns which group to join from the slots of
all; and of those of a group that hold the object, the first by name that is heard writes the
group's slot.
"""

from dataclasses import dataclass

from swarmgrasp.agents.groups.parts import Parts
from swarmgrasp.agents.groups.planner import GroupPlanner, check_mission
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
)
from swarmgrasp.agents.protocol.hearing import Hearing
from swarmgrasp.agents.protocol.order import in_order
from swarmgrasp.agents.protocol.planner import basis_of
from swarmgrasp.agents.protocol.record import LIVES, Phase
from swarmgrasp.agents.protocol.settings import Settings
from swarmgrasp.errors import MessageInvalid, NowhereToAttach
from swarmgrasp.placement import Problem


@dataclass(frozen=True)
class Told:
    """Slots came in from a robot."""

    sender: str
    slots: tuple[Slot, ...]


@dataclass(frozen=True)
class Wondered:
    """A robot asks for all slots."""

    sender: str


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


MemberEvent = Event | Told | Wondered | Heard
MemberEffect = Effect | Within | Tell | Wonder


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

    Raises
    ------
    AgentInvalid
        If the mission asks for more than summaries tell.
    """

    def __init__(
        self, name: str, problem: Problem, parts: Parts, settings: Settings | None = None, *,
        incarnation: int = LIVES,
    ) -> None:  # fmt: skip
        check_mission(problem)
        self.name, self.settings = name, settings or Settings()
        self.slots = Slots(problem.swarm, parts)
        self.agent: Agent | None = None
        """Within its group; None while it has none."""
        self.group = -1
        self._problem, self._incarnation = problem, incarnation
        self._planner: GroupPlanner | None = None
        self._full: dict[int, int] = {}
        self._wants, self._ready_by = False, NEVER
        self._time = Hearing(self.settings.silent)
        self._next_look, self._next_tell = 0.0, 0.0

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
            case Told(sender, slots):
                out += self._take(sender, slots)
                self._ready_by = min(self._ready_by, now)
            case Wondered(sender):
                out.append(Tell(sender, tuple(self.slots)))
            case Heard(group, received):
                if group == self.group:
                    out += self._pass(clock, received)
            case Start(attached):
                out.append(Wonder())
                self._ready_by = now + self.settings.ask
                if attached is not None:
                    self._wants = True
                    self._enter(self.slots.parts.at((attached.x, attached.y)))
                    out += self._pass(clock, event)
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
            out += self._write()
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
        return out

    def _enter(self, group: int) -> None:
        """Become a robot of a group."""
        self.group = group
        self._planner = GroupPlanner(self._problem, self.slots, group)
        self._incarnation += 1
        self.agent = Agent(self.name, self._planner, self.settings, incarnation=self._incarnation)

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
        """Tell whether a group may have room: it says so, and was not found full since."""
        slot = self.slots.get(group)
        count = -1 if slot is None else slot.count
        return (slot is None or slot.has_room) and self._full.get(group) != count

    def _move_on(self, clock: float) -> list[MemberEffect]:
        """Leave a group that has no room, if another has."""
        if self.agent is None or self.agent.record.phase is not Phase.WAITING:
            return []
        slot = self.slots.get(self.group)
        if slot is None or slot.has_room:
            return []
        self._full[self.group] = slot.count
        if not any(self._has_room(group) for group in range(len(self.slots.parts))):
            return []
        out = self._pass(clock, Leave())
        self.agent, self.group, self._ready_by = None, -1, self._time.now
        return [*out, *self._join(clock)]

    def _write(self) -> list[MemberEffect]:
        """Write the group's slot, if that is this robot's task, and tell it again now and then."""
        agent, planner = self.agent, self._planner
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
