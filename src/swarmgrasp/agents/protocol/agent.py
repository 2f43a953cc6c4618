"""One robot that decides for itself: events in, effects out; no clock, no chance, no network.

The rules have numbers, R1 to R13, in the documentation; they are named where they stand.
"""

from collections.abc import Callable
from typing import Any

from swarmgrasp.agents.protocol.confirming import Confirmations
from swarmgrasp.agents.protocol.decisions import Decisions
from swarmgrasp.agents.protocol.events import (
    ANYONE,
    EVERYONE,
    AtPlace,
    Cut,
    Down,
    Effect,
    Event,
    Fasten,
    Fastened,
    Halt,
    Join,
    Leave,
    Loosen,
    Loosened,
    Move,
    Planned,
    Received,
    Refused,
    Refuted,
    Send,
    Start,
    Stranger,
    Tick,
    Up,
    Witness,
)
from swarmgrasp.agents.protocol.hearing import Hearing
from swarmgrasp.agents.protocol.knowledge import Knowledge
from swarmgrasp.agents.protocol.memory import Memory
from swarmgrasp.agents.protocol.order import View
from swarmgrasp.agents.protocol.planner import Planner
from swarmgrasp.agents.protocol.record import LIVES, MOST_GONE, Kind, Phase, Record, check_id
from swarmgrasp.agents.protocol.reports import Reports
from swarmgrasp.agents.protocol.settings import Settings
from swarmgrasp.agents.protocol.state import State
from swarmgrasp.agents.protocol.wire import Ack, Ask, Beat, Have, Message, Put, Records
from swarmgrasp.agents.protocol.word import Word
from swarmgrasp.errors import AgentInvalid

NEVER = float("inf")


class Agent:
    """One robot's decisions.

    Parameters
    ----------
    name : str
        The robot's, and the last part of its key.
    planner : Planner
        The mathematics of the mission.
    settings : Settings, optional
    kind : Kind, optional
        What it is, where it differs from the mission's newcomer.
    incarnation : int
        The number of this start of its process times `LIVES`, plus a number drawn at this start.
    state : State, optional
        What it knew in its former life.

    Raises
    ------
    MessageInvalid
        If the name cannot be one on the network.
    AgentInvalid
        If the mission knows no such robot, or the state is another robot's.
    """

    def __init__(
        self, name: str, planner: Planner, settings: Settings | None = None, *,
        kind: Kind | None = None, incarnation: int = LIVES, state: State | None = None,
    ) -> None:  # fmt: skip
        self.name, self.planner = check_id(name), planner
        self.settings = settings or Settings()
        self._old = old = _old_record(name, state)
        if old is not None and old.incarnation >= incarnation:
            incarnation = (old.incarnation // LIVES + 1) * LIVES + incarnation % LIVES
        first = Record(name, incarnation, 0, Phase.LEFT, kind=kind)
        fault = planner.fault(first)
        if fault:
            raise AgentInvalid(f"{name}: {fault}")
        kept = [record for record in state.records if record.id != name] if state else []
        self._word, self._reports = Word(first), Reports()
        self._knowledge = Knowledge(
            planner, self.settings, self._reports, kept, state.clock if state else 0
        )
        self.memory.merge(first)
        self._confirmations = Confirmations(name, self._knowledge, self.settings)
        self._decisions = Decisions(
            self._word, self._knowledge, self._confirmations, self._reports, planner,
            self.settings, set(state.reckoned) if state else set(),
        )  # fmt: skip
        self._out: list[Effect] = self._decisions.out
        self._wants = self._leaves = False
        self._caught_up_by = NEVER
        self._dirty_since: float | None = None
        self._next_beat = self._next_retry = self._next_have = 0.0
        self._acks: dict[str, tuple[int, int, int, int]] = {}
        self._absent: tuple[tuple[str, ...], tuple[str, ...]] = ((), ())

    # -- what it says of itself -----------------------------------------------------------

    @property
    def record(self) -> Record:
        """What it says of itself."""
        return self._word.said

    @property
    def memory(self) -> Memory:
        """What all robots have said of themselves."""
        return self._knowledge.memory

    @property
    def state(self) -> State:
        """What its next life should know; to be kept before what it sends is sent."""
        reckoned = tuple(sorted(self._decisions.reckoned))
        return State(self._knowledge.clock, tuple(self.memory), reckoned)

    @property
    def hearing(self) -> Hearing:
        """Whom it hears."""
        return self._knowledge.hearing

    @property
    def waits_for(self) -> tuple[str, ...]:
        """The robots whose confirmation it lacks."""
        return tuple(self._confirmations.lacking) if self.record.asks else ()

    @property
    def view(self) -> View:
        """The robots it reckons with."""
        return self._decisions.view

    def handle(self, clock: float, event: Event) -> list[Effect]:
        """Take an event, and return what is to be done about it.

        Parameters
        ----------
        clock : float [s]
            By any steady clock of this robot's own.
        event : Event
        """
        self._out.clear()
        if self._knowledge.hearing.advance(clock):
            self._confirmations.clear()  # R7: what was said meanwhile is not known
            self._mark_dirty()
        _HANDLERS[type(event)](self, event)
        self._take_ticket()
        self._decide()
        self._commit()
        self._publish()
        self._speak()
        return [*self._out, *self._reports.take()]

    @property
    def wake(self) -> float:
        """When to send a `Tick` at the latest, by the given clock [s]."""
        hearing, times = self._knowledge.hearing, [self._next_beat, self._caught_up_by]
        if self._dirty_since is not None:
            times.append(self._dirty_since + self.settings.gather)
        if self.record.asks:
            times.append(self._next_retry)
            if not hearing.has_listened:
                times.append(hearing.since + self.settings.silent)
            times += hearing.next_silences(self._confirmations.lacking)
        return hearing.clock_at(min(times))

    # -- events of its own process and body -----------------------------------------------

    def _start(self, event: Start) -> None:
        """Begin: say so, and ask what is known."""
        old = self._old
        if old is not None:
            self._wants = old.phase >= Phase.WAITING
            self._word.change(
                ticket=old.ticket, arrival=old.arrival, asked=old.asked, gone=old.gone
            )
        if event.attached is not None:
            self._wants = True
            self._decisions.attach(event.attached)
        elif old is not None and old.is_fixed:
            self._word.change(ticket=0)  # it has lost its hold: it asks to join anew
            self._reports.tell("loose", f"{self.name} holds the object no longer")
        elif old is not None and old.ticket and self._wants:
            self._word.change(phase=Phase.WAITING)
        self._word.repeat()
        self._catch_up()
        self._mark_dirty()

    def _join(self, _: Join) -> None:
        """Come and help."""
        self._wants, self._leaves = True, False
        if self.record.phase is Phase.LEFT and self._caught_up_by == NEVER:
            self._catch_up()

    def _catch_up(self) -> None:
        """Ask anyone what is known."""
        self._send(ANYONE, Ask(self.name))
        self._caught_up_by = self._knowledge.hearing.now + self.settings.ask

    def _leave(self, _: Leave) -> None:
        """Go."""
        self._wants, self._leaves = False, True
        phase = self.record.phase
        if phase >= Phase.ATTACHED:
            self._out.append(Loosen())
        elif phase is not Phase.FASTENING:
            self._go_away()

    def _go_away(self) -> None:
        """Be gone."""
        if self.record.phase is not Phase.LEFT:
            self._out.append(Halt())
            self._reports.tell("left", f"{self.name} leaves")
        self._leaves = False
        self._decisions.begin_anew()
        self._decisions.be_nowhere(Phase.LEFT)
        self._word.change(ticket=0, plan=None)

    def _move(self, _: Move) -> None:
        """Ask to let go and look for a better place (R10)."""
        if self.record.phase is not Phase.ATTACHED:
            self._reports.tell("cannot move", f"{self.name} is not attached: it cannot move")
            return
        fault = self._decisions.reason_to_stay()
        if fault:
            self._reports.tell("cannot move", f"{self.name} stays: {fault}")
        else:
            self._decisions.ask_to_move()
            self._mark_dirty()

    def _tick(self, _: Tick) -> None:
        """Let time pass."""

    def _at_place(self, _: AtPlace) -> None:
        """Announce that it has arrived (R4)."""
        if self.record.phase is Phase.COMING:
            self._decisions.arrive()

    def _fastened(self, event: Fastened) -> None:
        """Take the fact that it holds the object (R8)."""
        self._wants = not self._leaves
        self._decisions.attach(event.place)
        self._mark_dirty()
        if self._leaves:
            self._out.append(Loosen())

    def _refused_place(self, _: Refused) -> None:
        """Keep clear of a place that is seen to be taken (R8)."""
        record = self.record
        if Phase.COMING <= record.phase <= Phase.FASTENING and record.place is not None:
            self._decisions.avoid(record.place)

    def _loosened(self, _: Loosened) -> None:
        """Take the fact that it does not hold the object."""
        if self._leaves or not self._wants:
            self._go_away()
            return
        if not self._decisions.may_loosen:
            self._reports.tell("loose", f"{self.name} has lost its hold, and comes anew")
        self._decisions.begin_anew()
        self._decisions.choose()

    def _witness(self, event: Witness) -> None:
        """Testify that a robot is not where it should be (R9)."""
        known = self.memory.get(event.name)
        is_first = any(row.id == event.name for row in self.planner.present)
        if event.name == self.name or (known is None and not is_first):
            return
        testimony = (event.name, known.incarnation if known else 0)
        said = self._word.now.gone
        if testimony not in said:
            still = (each for each in said if self._still_matters(each))
            self._word.change(gone=(*still, testimony)[-MOST_GONE:])
            self._reports.tell("gone", f"{self.name} sees that {event.name} is gone", event.name)
            self._mark_dirty()

    def _still_matters(self, gone: tuple[str, int]) -> bool:
        """Tell whether a testimony is about a robot's present life."""
        known = self.memory.get(gone[0])
        return known is None or known.incarnation == gone[1]

    def _planned(self, event: Planned) -> None:
        """Publish a joint plan."""
        self._decisions.plan_is_made()
        if event.plan is not None:
            self._word.change(plan=event.plan)
            names = " ".join(name for name, _ in event.plan.places)
            self._reports.tell("plan", f"{self.name} plans for {names} together")
            self._mark_dirty()

    # -- events of the network ------------------------------------------------------------

    def _received(self, event: Received) -> None:
        """Take a message."""
        message = event.message
        if message.sender != event.sender:
            fault = f"speaks in the name of {message.sender}"
            self._reports.refuse(event.sender, fault)
            return
        if message.sender == self.name:
            if isinstance(message, Put | Ack):
                self._learn(message.record)
            return
        self._hear(event.sender)
        match message:
            case Put(record):
                self._put(record, event.is_direct)
            case Ack(of, record):
                self._learn(record)
                if of == self.record.asks_for and self.record.asks:
                    self._confirmations.take(record.id)
            case Beat(sender, clock, digest):
                self._beat(sender, clock, digest)
            case Ask(sender):
                self._send_records(sender, tuple(self.memory))
            case Have(sender, versions, answer):
                newer = self.memory.newer_than(versions)
                if newer:
                    self._send_records(sender, newer)
                if answer and self.memory.lacks(versions):
                    self._send(sender, Have(self.name, self.memory.versions(), False))
            case Records(sender, clock, records):
                self._knowledge.hear_clock(sender, clock)
                for record in records:
                    self._learn(record)
                if self._caught_up_by != NEVER:
                    self._caught_up_by = self._knowledge.hearing.now

    def _send_records(self, to: str, records: tuple[Record, ...]) -> None:
        """Send records, and the time by tickets with them."""
        self._send(to, Records(self.name, self._knowledge.clock, records))

    def _put(self, record: Record, is_direct: bool) -> None:
        """Take a robot's own word; it may ask for a confirmation (R5)."""
        self._learn(record)
        is_newest = self.memory.get(record.id) == record
        attached = self.record.phase is Phase.ATTACHED and len(self.memory) >= self.settings.many
        lets_go = record.phase is Phase.ASKING and self._decisions.may_loosen  # nobody else may
        if record.asks and is_newest and not lets_go and (is_direct or not attached):
            self._acks[record.id] = record.asks_for

    def _beat(self, sender: str, clock: int, digest: bytes) -> None:
        """Take a sign of life; if it knows other things, tell it what is known here."""
        now = self._knowledge.hearing.now
        self._knowledge.hear_clock(sender, clock)
        if digest == self.memory.digest:
            record = self.memory.get(sender)
            if self.record.asks and record is not None and record.phase is Phase.ATTACHED:
                self._confirmations.take(sender)  # it knows, and it stays where it is
        elif now >= self._next_have:
            self._next_have = now + 0.5 * self.settings.beat
            self._send(sender, Have(self.name, self.memory.versions(), True))

    def _refuted(self, event: Refuted) -> None:
        """Take what was no message (R13)."""
        self._reports.refuse(event.sender, event.fault)

    def _up(self, event: Up) -> None:
        """Take the network's word that a robot is there."""
        if event.name != self.name:
            self._hear(event.name)

    def _down(self, event: Down) -> None:
        """Take the network's word that a robot's process has ended."""
        self._knowledge.hearing.drop(event.name)
        self._mark_dirty()

    def _cut(self, _: Cut) -> None:
        """Listen anew: what was said meanwhile is not known (R7)."""
        self._knowledge.hearing.begin_anew()
        self._confirmations.clear()

    def _stranger(self, event: Stranger) -> None:
        """Tell of a robot that works on something else, once."""
        words = f"{event.name} works on another mission, {event.mission}: it is not reckoned with"
        self._reports.tell_once(f"stranger {event.name}", "stranger", words, event.name)

    def _hear(self, name: str) -> None:
        """Note a sign of life."""
        if self._knowledge.hearing.hear(name):
            self._mark_dirty()

    def _learn(self, record: Record) -> None:
        """Take a record, from whoever tells it."""
        if record.id == self.name:
            self._refute(record)
            return
        before = self._knowledge.learn(record)
        if before is None:
            return
        if before.incarnation != record.incarnation:
            self._confirmations.drop(record.id)
        mine = (self.name, self.record.incarnation)
        if mine in record.gone and self.record.phase is not Phase.LEFT:
            words = f"{record.id} says that {self.name} is gone; it is not"
            self._reports.tell("refuted", words, record.id)
            self._outdo(self.record.incarnation)
        self._mark_dirty()

    def _refute(self, record: Record) -> None:
        """Answer a word of one's own that one did not say (R11)."""
        said = self.record
        if record.version > said.version or (record.version == said.version and record != said):
            words = f"someone else speaks as {self.name}, or its former life is remembered"
            self._reports.tell("refuted", words)
            self._outdo(record.incarnation)

    def _outdo(self, incarnation: int) -> None:
        """Speak with a higher version; what was confirmed was another's arrival."""
        self._word.outdo(incarnation)
        self._confirmations.clear()

    # -- what comes of an event -----------------------------------------------------------

    def _take_ticket(self) -> None:
        """Ask to join, once it is known what is known."""
        if self._knowledge.hearing.now < self._caught_up_by:
            return
        self._caught_up_by = NEVER
        if self._wants and self._word.now.phase is Phase.LEFT:
            ticket = self._knowledge.next_ticket()
            self._word.change(phase=Phase.WAITING, ticket=ticket)
            self._reports.tell("joined", f"{self.name} joins with ticket {ticket}")
            self._mark_dirty()

    def _decide(self) -> None:
        """Act upon what has changed, when it is time to."""
        if self._dirty_since is None:
            return
        is_due = self._knowledge.hearing.now >= self._dirty_since + self.settings.gather
        if is_due or self._acks or self.record.asks:
            self._dirty_since = None
            self._decisions.decide()

    def _commit(self) -> None:
        """Fasten, or let go, once everybody has confirmed (R6)."""
        said, decisions = self.record, self._decisions
        if not said.asks or self._word.now.phase is not said.phase or decisions.may_loosen:
            return
        if self._confirmations.lacking or not self._knowledge.hearing.has_listened:
            return
        asked = " ".join(self._confirmations.needed) or "nobody"
        if said.phase is Phase.ASKING:
            decisions.may_loosen = True
            self._reports.tell("lets go", f"{self.name} lets go to move; confirmed by {asked}")
            self._out.append(Loosen())
        elif said.place is not None:
            self._word.change(phase=Phase.FASTENING)
            self._reports.tell("fastens", f"{self.name} fastens; confirmed by {asked}")
            self._out.append(Fasten(said.place))

    def _publish(self) -> None:
        """Tell everyone of the record, if it has changed or is to be told once more."""
        did_ask = self.record.asks
        record = self._word.take()
        if record is not None:
            self.memory.merge(record)
            self._send(EVERYONE, Put(record))
            if record.asks and not did_ask:
                self._next_retry = self._knowledge.hearing.now + self.settings.retry

    def _speak(self) -> None:
        """Confirm, ask once more, and give a sign of life, each when it is due."""
        now = self._knowledge.hearing.now
        for name, of in self._acks.items():
            self._send(name, Ack(of, self.record))
            record = self.memory.get(name)
            if record is not None and record.phase is Phase.ARRIVED:
                self._decisions.reckoned.add(record.arrived_as)
        self._acks = {}
        if self.record.asks and now >= self._next_retry:
            self._next_retry = now + self.settings.retry
            self._ask_once_more()
        if now >= self._next_beat:
            self._next_beat = now + self.settings.beat
            self._send(EVERYONE, Beat(self.name, self._knowledge.clock, self.memory.digest))
            self._look_up()

    def _ask_once_more(self) -> None:
        """Ask those who have not confirmed, and tell who they are when that changes."""
        lacking = self._confirmations.lacking
        for name in lacking:
            self._send(name, Put(self.record))
        if lacking:
            is_heard = self._knowledge.hearing.is_heard
            names = (f"{n} ({'heard' if is_heard(n) else 'not heard'})" for n in lacking)
            words = f"{self.name} waits for {', '.join(names)}"
            self._reports.tell_once("waits", "waits", words, *lacking)

    def _look_up(self) -> None:
        """See at a beat who has fallen silent, and whether a move is due."""
        absent = self._knowledge.absent(self.name)
        if absent != self._absent:
            self._absent = absent
            self._mark_dirty()
        self._decisions.improve()
        self._publish()

    def _mark_dirty(self) -> None:
        """Note that something has changed that decisions rest on."""
        if self._dirty_since is None:
            self._dirty_since = self._knowledge.hearing.now

    def _send(self, to: str, message: Message) -> None:
        """Send a message."""
        self._out.append(Send(to, message))


_HANDLERS: dict[type, Callable[[Agent, Any], None]] = {
    Start: Agent._start,
    Join: Agent._join,
    Leave: Agent._leave,
    Move: Agent._move,
    Tick: Agent._tick,
    AtPlace: Agent._at_place,
    Fastened: Agent._fastened,
    Refused: Agent._refused_place,
    Loosened: Agent._loosened,
    Witness: Agent._witness,
    Planned: Agent._planned,
    Received: Agent._received,
    Refuted: Agent._refuted,
    Up: Agent._up,
    Down: Agent._down,
    Cut: Agent._cut,
    Stranger: Agent._stranger,
}


def _old_record(name: str, state: State | None) -> Record | None:
    """Return what a robot said of itself last in its former life."""
    if state is None:
        return None
    for record in state.records:
        if record.id == name:
            return record
    raise AgentInvalid(f"the state is another robot's: it does not know {name}")
