"""One robot that decides for itself: events in, effects out; no clock, no chance, no network.

The rules have numbers in the documentation; they are named where they stand.
"""

from collections.abc import Callable
from typing import Any

import msgspec

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
    Go,
    Halt,
    Join,
    Leave,
    Loosen,
    Loosened,
    MakePlan,
    Move,
    Planned,
    Received,
    Refused,
    Refuted,
    Report,
    Send,
    Start,
    Stranger,
    Tick,
    Up,
    Witness,
)
from swarmgrasp.agents.protocol.hearing import Hearing
from swarmgrasp.agents.protocol.memory import Memory, Merged
from swarmgrasp.agents.protocol.order import (
    Choice,
    View,
    choices,
    conflicts_of,
    in_order,
    is_surprised,
    plan_wanted,
    row_of,
    too_close,
    view_of,
)
from swarmgrasp.agents.protocol.planner import Planner
from swarmgrasp.agents.protocol.record import (
    LIVES,
    MOST_GONE,
    Kind,
    Phase,
    Place,
    Record,
    check_id,
)
from swarmgrasp.agents.protocol.settings import Settings
from swarmgrasp.agents.protocol.state import State
from swarmgrasp.agents.protocol.wire import Ack, Ask, Beat, Have, Message, Put, Records
from swarmgrasp.errors import AgentInvalid, SwarmGraspError

AHEAD = 1 << 20
"""How far a ticket or a clock may be ahead of one's own."""
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
        self.hearing = Hearing(self.settings.silent)
        old = _old_record(name, state)
        if old is not None and old.incarnation >= incarnation:
            incarnation = (old.incarnation // LIVES + 1) * LIVES + incarnation % LIVES
        kept = [r for r in state.records if r.id != name] if state else []
        self.memory = Memory(kept)
        for record in kept:
            self.hearing.hear(record.id)  # it may be there still
        self._old = old
        self._me = Record(name, incarnation, 0, Phase.LEFT, kind=kind)
        fault = planner.fault(self._me)
        if fault:
            raise AgentInvalid(f"{name}: {fault}")
        self.memory.merge(self._me)
        self._clock = state.clock if state else 0
        self._reckoned = set(state.reckoned) if state else set()
        self._confirmed: dict[str, float] = {}
        self._blocked: list[Place] = []
        self._wants = self._leaving = self._planning = self._may_loosen = False
        self._caught_up_by = NEVER
        self._dirty_since: float | None = None
        self._next_beat = self._next_retry = self._next_have = 0.0
        self._acks: dict[str, tuple[int, int, int, int]] = {}
        self._told: dict[str, object] = {}
        self._refused = 0
        self._changes: dict[str, Any] = {}
        self._again = False
        self._out: list[Effect] = []
        self._waits: list[str] = []
        self._quiet_since = 0.0

    # -- what it says of itself -----------------------------------------------------------

    @property
    def record(self) -> Record:
        """What it says of itself."""
        return self._me

    @property
    def state(self) -> State:
        """What its next life should know; to be kept before what it sends is sent."""
        return State(self._clock, tuple(self.memory), tuple(sorted(self._reckoned)))

    @property
    def waits_for(self) -> tuple[str, ...]:
        """The robots whose confirmation it lacks."""
        return tuple(self._waits)

    @property
    def view(self) -> View:
        """The robots it reckons with."""
        me = self._me_now()
        records = (me if record.id == self.name else record for record in self.memory)
        return view_of(records, self.planner.present, *self._absent())

    def _absent(self) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Return who is forgotten, and who is doubted (R9)."""
        others = [r for r in self.memory if r.id != self.name]
        silence, settings = self.hearing.silence, self.settings
        on_their_way = (r.id for r in others if r.is_on_its_way)
        forgotten = tuple(n for n in on_their_way if silence(n) >= settings.forget)
        if settings.counts_silent:
            return forgotten, ()
        return forgotten, tuple(r.id for r in others if silence(r.id) >= settings.silent)

    def handle(self, clock: float, event: Event) -> list[Effect]:
        """Take an event, and return what is to be done about it.

        Parameters
        ----------
        clock : float [s]
            By any steady clock of this robot's own.
        event : Event
        """
        self._out = []
        if self.hearing.advance(clock):
            self._confirmed.clear()  # R7: what was said meanwhile is not known
            self._mark_dirty()
        _HANDLERS[type(event)](self, event)
        self._take_ticket()
        self._decide()
        self._commit()
        self._publish()
        self._speak()
        return self._out

    @property
    def wake(self) -> float:
        """When to send a `Tick` at the latest, by the given clock [s]."""
        hearing, times = self.hearing, [self._next_beat, self._caught_up_by]
        if self._dirty_since is not None:
            times.append(self._dirty_since + self.settings.gather)
        if self._me.asks:
            times.append(self._next_retry)
            if not hearing.has_listened:
                times.append(hearing.since + self.settings.silent)
            times += hearing.next_silences(self._waits)
        return hearing.clock_at(min(times))

    # -- events ---------------------------------------------------------------------------

    def _start(self, event: Start) -> None:
        """Begin: say so, and ask what is known."""
        old, attached = self._old, event.attached
        if old is not None:
            self._wants = old.phase >= Phase.WAITING
            self._change(
                ticket=old.ticket, arrival=old.arrival, asked=old.asked, gone=old.gone,
                kind=self._me.kind,
            )  # fmt: skip
        if attached is not None:
            self._wants = True
            self._attach(attached)
        elif old is not None and old.phase >= Phase.WAITING and old.ticket:
            self._change(phase=Phase.WAITING)
            if old.is_fixed:
                self._change(ticket=0, phase=Phase.LEFT)  # it has lost its hold: it asks anew
                self._report("loose", f"{self.name} holds the object no longer")
        self._again = True
        self._send(ANYONE, Ask(self.name))
        self._caught_up_by = self.hearing.now + self.settings.ask
        self._mark_dirty()

    def _join(self, _: Join) -> None:
        """Come and help."""
        self._wants, self._leaving = True, False
        if self._me.phase is Phase.LEFT and self._caught_up_by == NEVER:
            self._send(ANYONE, Ask(self.name))
            self._caught_up_by = self.hearing.now + self.settings.ask

    def _leave(self, _: Leave) -> None:
        """Go."""
        self._wants, self._leaving = False, True
        phase = self._me.phase
        if phase >= Phase.ATTACHED:
            self._out.append(Loosen())
        elif phase is not Phase.FASTENING:
            self._go_away()

    def _move(self, _: Move) -> None:
        """Ask to let go and look for a better place (R10)."""
        if self._me.phase is not Phase.ATTACHED:
            self._report("cannot move", f"{self.name} is not attached: it cannot move")
            return
        fault = self._reason_to_stay(self.view)
        if fault:
            self._report("cannot move", f"{self.name} stays: {fault}")
            return
        self._ask_to_move()

    def _tick(self, _: Tick) -> None:
        """Let time pass."""

    def _received(self, event: Received) -> None:
        """Take a message."""
        message = event.message
        if message.sender != event.sender:
            self._refuse(event.sender, f"speaks in the name of {message.sender}")
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
                if of == self._me.asks_for and self._me.asks:
                    self._confirmed[record.id] = self.hearing.now
            case Beat(sender, clock, digest):
                self._beat(sender, clock, digest)
            case Ask(sender):
                self._send(sender, Records(self.name, self._clock, tuple(self.memory)))
            case Have(sender, versions, answer):
                newer = self.memory.newer_than(versions)
                if newer:
                    self._send(sender, Records(self.name, self._clock, newer))
                if answer and self.memory.lacks(versions):
                    self._send(sender, Have(self.name, self.memory.versions(), False))
            case Records(sender, clock, records):
                self._hear_clock(sender, clock)
                for record in records:
                    self._learn(record)
                if self._caught_up_by != NEVER:
                    self._caught_up_by = self.hearing.now

    def _put(self, record: Record, is_direct: bool) -> None:
        """Take a robot's own word; it may ask for a confirmation (R5)."""
        self._learn(record)
        known = self.memory.get(record.id)
        attached = self._me.phase is Phase.ATTACHED and len(self.memory) >= self.settings.many
        if known is not None and known.asks and known == record and (is_direct or not attached):
            self._acks[record.id] = record.asks_for

    def _beat(self, sender: str, clock: int, digest: bytes) -> None:
        """Take a sign of life; if it knows other things, tell it what is known here."""
        self._hear_clock(sender, clock)
        if digest == self.memory.digest:
            record = self.memory.get(sender)
            if self._me.asks and record is not None and record.phase is Phase.ATTACHED:
                self._confirmed[sender] = self.hearing.now  # it knows, and it stays where it is
        elif self.hearing.now >= self._next_have:
            self._next_have = self.hearing.now + 0.5 * self.settings.beat
            self._send(sender, Have(self.name, self.memory.versions(), True))

    def _refuted(self, event: Refuted) -> None:
        """Take what was no message."""
        self._refuse(event.sender, event.fault)

    def _up(self, event: Up) -> None:
        """Take the network's word that a robot is there."""
        if event.name != self.name:
            self._hear(event.name)

    def _down(self, event: Down) -> None:
        """Take the network's word that a robot's process has ended."""
        self.hearing.drop(event.name)
        self._mark_dirty()

    def _cut(self, _: Cut) -> None:
        """Listen anew: what was said meanwhile is not known."""
        self.hearing.begin_anew()
        self._confirmed.clear()

    def _stranger(self, event: Stranger) -> None:
        """Tell of a robot that works on something else, once."""
        words = f"{event.name} works on another mission, {event.mission}: it is not reckoned with"
        self._report("stranger", words, event.name, key=f"stranger {event.name}")

    def _at_place(self, _: AtPlace) -> None:
        """Announce that it has arrived, if its place is still its own (R4)."""
        if self._me.phase is Phase.COMING:
            target = self._me.place
            self._choose(self.view)
            if self._me_now("phase") is Phase.COMING and self._me_now("place") == target:
                self._confirmed.clear()
                self._change(phase=Phase.ARRIVED, arrival=self._me.arrival + 1)
                self._next_retry = self.hearing.now + self.settings.retry

    def _fastened(self, event: Fastened) -> None:
        """Take the fact that it holds the object (R8)."""
        self._wants = not self._leaving
        self._attach(event.place)
        if self._leaving:
            self._out.append(Loosen())

    def _refused_place(self, _: Refused) -> None:
        """Keep clear of a place that is seen to be taken (R8)."""
        phase, place = self._me.phase, self._me.place
        if Phase.COMING <= phase <= Phase.FASTENING and place is not None:
            self._blocked.append(place)
            where = f"({place.x:.4g}, {place.y:.4g}) m"
            self._report("taken", f"{self.name} finds its place taken: {where}")
            self._change(phase=Phase.COMING)
            self._confirmed.clear()
            self._choose(self.view)

    def _loosened(self, _: Loosened) -> None:
        """Take the fact that it does not hold the object."""
        if self._leaving or not self._wants:
            self._go_away()
            return
        if not self._may_loosen:
            self._report("loose", f"{self.name} has lost its hold, and comes anew")
        self._may_loosen = False
        self._blocked.clear()
        self._change(phase=Phase.WAITING, place=None, lower=0.0, basis=b"")
        self._new_ticket()
        self._choose(self.view)

    def _witness(self, event: Witness) -> None:
        """Testify that a robot is not where it should be (R9)."""
        known = self.memory.get(event.name)
        is_first = any(row.id == event.name for row in self.planner.present)
        if event.name == self.name or (known is None and not is_first):
            return
        gone = (event.name, known.incarnation if known else 0)
        if gone not in self._me_now("gone"):
            kept = [each for each in self._me_now("gone") if self._still_matters(each)]
            self._change(gone=(*kept, gone)[-MOST_GONE:])
            self._report("gone", f"{self.name} sees that {event.name} is gone", event.name)
            self._mark_dirty()

    def _planned(self, event: Planned) -> None:
        """Publish a joint plan."""
        self._planning = False
        if event.plan is not None:
            self._change(plan=event.plan)
            names = " ".join(name for name, _ in event.plan.places)
            self._report("plan", f"{self.name} plans for {names} together")
            self._mark_dirty()

    # -- what it knows --------------------------------------------------------------------

    def _hear(self, name: str) -> None:
        """Note a sign of life."""
        if self.hearing.hear(name):
            self._mark_dirty()

    def _hear_clock(self, sender: str, clock: int) -> None:
        """Take another's Lamport time, if it is not absurd."""
        if clock > self._clock + AHEAD:
            self._refuse(sender, f"has a clock of {clock}, far ahead of all others")
        else:
            self._clock = max(self._clock, clock)

    def _learn(self, record: Record) -> None:
        """Take a record, from whoever tells it."""
        if record.id == self.name:
            self._refute(record)
            return
        if record.ticket > self._clock + AHEAD:
            self._refuse(record.id, f"has the ticket {record.ticket}, far ahead of all others")
            return
        known = self.memory.get(record.id)
        if known is not None and record.version < known.version:
            return
        if known != record:
            fault = self.planner.fault(record)
            if fault:
                self._refuse(record.id, f"cannot be what it says: {fault}")
                return
        merged = self.memory.merge(record)
        if merged is Merged.TWO_STORIES:
            words = f"{record.id} tells two stories with one version: is the name in use twice?"
            self._report("two stories", words, record.id, key=f"stories {record.id}")
        if merged is Merged.FULL:
            self._refuse(record.id, "is one robot more than can be remembered")
            return
        self._clock = max(self._clock, record.ticket)
        if self.memory.get(record.id) is known:
            return
        if known is None:
            self._hear(record.id)  # it may be there: it is to be silent before it counts as silent
        elif known.incarnation != record.incarnation:
            self._confirmed.pop(record.id, None)  # another life has confirmed nothing
        self._heed(record)
        self._mark_dirty()

    def _heed(self, record: Record) -> None:
        """Answer what a record says of this robot: that it is gone, which it is not."""
        mine = (self.name, self._me.incarnation)
        if mine in record.gone and self._me.phase is not Phase.LEFT:
            self._report("refuted", f"{record.id} says that {self.name} is gone; it is not")
            self._new_incarnation(self._me.incarnation)

    def _refute(self, record: Record) -> None:
        """Answer a word of one's own that one did not say (R11)."""
        if record.version > self._me.version or (
            record.version == self._me.version and record != self._me
        ):
            words = f"someone else speaks as {self.name}, or its former life is remembered"
            self._report("refuted", words)
            self._new_incarnation(record.incarnation)

    def _new_incarnation(self, incarnation: int) -> None:
        """Take a version above one that is not its own."""
        drawn = self._me.incarnation % LIVES
        number = max(incarnation, self._me.incarnation) // LIVES + 1
        self._me = msgspec.structs.replace(
            self._me, incarnation=number * LIVES + drawn, sequence=self._me.sequence
        )
        self._confirmed.clear()
        self._again = True

    def _still_matters(self, gone: tuple[str, int]) -> bool:
        """Tell whether a testimony is about a robot's present life."""
        known = self.memory.get(gone[0])
        return known is None or known.incarnation == gone[1]

    def _refuse(self, sender: str, fault: str) -> None:
        """Count what cannot be, and tell of it now and then."""
        self._refused += 1
        if self._refused & (self._refused - 1) == 0:
            count = f" ({self._refused} so far)" if self._refused > 1 else ""
            self._report("refused", f"{sender} {fault}{count}", sender)

    # -- decisions ------------------------------------------------------------------------

    def _take_ticket(self) -> None:
        """Ask to join, once it is known what is known (order)."""
        if self.hearing.now < self._caught_up_by:
            return
        self._caught_up_by = NEVER
        if self._wants and self._me_now("phase") is Phase.LEFT:
            self._change(phase=Phase.WAITING)
            self._new_ticket()
            self._report("joined", f"{self.name} joins with ticket {self._me_now('ticket')}")
            self._mark_dirty()

    def _decide(self) -> None:
        """Act upon what has changed, when it is time to."""
        now, settings = self.hearing.now, self.settings
        if self._dirty_since is None:
            return
        is_due = now >= self._dirty_since + settings.gather
        if not (is_due or self._acks or self._me.asks):
            return
        view = self.view
        self._dirty_since = None
        self._quiet_since = now
        match self._me_now("phase"):
            case Phase.WAITING | Phase.COMING:
                self._choose(view)
            case Phase.ARRIVED:
                self._give_way(view)
            case Phase.ASKING:
                self._take_back(view)
            case Phase.ATTACHED:
                self._drop_plan(view)
                self._look_around(view)

    def _choose(self, view: View) -> None:
        """Take the best place beside all with an earlier ticket (R1 to R3)."""
        me = self._me_now()
        surprise = is_surprised(me, view, self._reckoned)
        if surprise is not None:
            self._new_ticket()
            words = f"{surprise.id} did not reckon with {self.name}, which takes a new ticket"
            self._report("new ticket", words, surprise.id)
            view = self.view
        self._drop_plan(view)
        self._make_plan(view)
        choice = choices(view, self.planner, self.name, self._blocked)[self.name]
        if choice.place is None:
            if me.phase is not Phase.WAITING or me.place is not None:
                self._out.append(Halt())
            self._change(phase=Phase.WAITING, place=None, lower=0.0, basis=b"")
            self._report("no room", f"{self.name} finds no room", key="no room")
            return
        place = self._kept(me, choice) or choice.place
        self._told.pop("no room", None)
        rows = (*choice.rows, row_of(msgspec.structs.replace(me, place=place)))
        lower = self.planner.lower(rows)
        if place != me.place or me.phase is not Phase.COMING:
            self._out.append(Go(place))
            where = f"({place.x:.4g}, {place.y:.4g}) m"
            self._report("going", f"{self.name} goes to {where}: quality {lower:.4g} N")
        self._change(phase=Phase.COMING, place=place, lower=lower, basis=choice.basis)

    def _kept(self, me: Record, choice: Choice) -> Place | None:
        """Return the present target, if another is not worth the turn (R3)."""
        place, worth = me.place, self.settings.worth
        if place is None or choice.place is None or place == choice.place or not worth:
            return None
        if choice.plan is not None:
            return None
        taken = [*(row.place for row in choice.rows), *choice.obstacles]
        if not self.planner.is_clear(place, taken):
            return None
        at_old, at_new = (
            self.planner.lower((*choice.rows, row_of(msgspec.structs.replace(me, place=p))))
            for p in (place, choice.place)
        )
        return place if at_new <= at_old * (1.0 + worth) else None

    def _give_way(self, view: View) -> None:
        """Give way to whom this robot has to (R4)."""
        conflicts = conflicts_of(self._me_now(), view, self.planner)
        if conflicts:
            other = conflicts[0]
            self._report("gives way", f"{self.name} gives way to {other.id}", other.id)
            self._change(phase=Phase.COMING)
            self._confirmed.clear()
            self._choose(self.view)

    def _take_back(self, view: View) -> None:
        """Stay after all, if somebody is under way or asked earlier (R10)."""
        fault = "" if self._may_loosen else self._reason_to_stay(view)
        if fault:
            self._change(phase=Phase.ATTACHED)
            self._report("stays", f"{self.name} stays: {fault}")

    def _reason_to_stay(self, view: View) -> str:
        """Return why this robot may not let go now; "" if it may."""
        under_way = [*view.movers, *(r for r in view.settled if r.phase < Phase.ATTACHED)]
        if under_way:
            return f"{under_way[0].id} is under way"
        for record in view.settled:
            if record.phase is Phase.ASKING and record.order < self._me.order:
                return f"{record.id} asked before it"
        rows = tuple(row for row in in_order(view.rows, self.planner) if row.id != self.name)
        left = self.planner.lower(rows)
        if left < self.settings.floor:
            return f"quality without it is {left:.4g} N, below {self.settings.floor:.4g} N"
        return ""

    def _ask_to_move(self) -> None:
        """Ask everyone whether it may let go."""
        self._confirmed.clear()
        self._change(phase=Phase.ASKING, asked=self._me.asked + 1)
        self._next_retry = self.hearing.now + self.settings.retry
        self._report("asks", f"{self.name} asks to let go, for a better place")
        self._mark_dirty()

    def _look_around(self, view: View) -> None:
        """Tell who holds the object too close, and move if that is due (R12, R10)."""
        for first, second in too_close(view, self.planner):
            if self.name in {first.id, second.id}:
                key = f"close {first.id} {second.id}"
                words = f"{first.id} and {second.id} are too close: {second.id} is the later one"
                self._report("too close", words, first.id, second.id, key=key)
            is_later = second.id == self.name and self.settings.resolve
            if is_later and not self._reason_to_stay(view):
                self._ask_to_move()
                return

    def _improve(self) -> None:
        """Ask to move if nothing has happened for a while and a move of this robot is the best."""
        improve, now = self.settings.improve, self.hearing.now
        if improve is None or self._me_now("phase") is not Phase.ATTACHED:
            return
        if now < self._quiet_since + 2.0 * self.settings.silent:
            return
        self._quiet_since = now
        view = self.view
        if self._reason_to_stay(view):
            return
        names = [record.id for record in view.settled]
        rows = in_order(view.rows, self.planner)
        if self.planner.mover(rows, names, self.settings.floor, improve) == self.name:
            self._ask_to_move()

    def _make_plan(self, view: View) -> None:
        """Have a joint plan made, if this robot is the one to make it."""
        heard = [r for r in view.movers if r.id == self.name or self.hearing.is_heard(r.id)]
        first = heard[0].id if heard else ""
        if self._planning or first != self.name:
            return
        listening = View(view.fixed, view.settled, tuple(heard), view.doubted)
        wanted = plan_wanted(listening, self.planner, self.name)
        if wanted is not None and self._told.get("plan for") != wanted:
            self._told["plan for"] = wanted
            self._planning = True
            self._out.append(MakePlan(*wanted, self.planner.who(self._me)))

    def _drop_plan(self, view: View) -> None:
        """Take back a plan whose robots are all at their place, or gone."""
        plan = self._me_now("plan")
        if plan is not None:
            on_their_way = {r.id for r in view.movers}
            if not any(name in on_their_way for name, _ in plan.places):
                self._change(plan=None)

    def _commit(self) -> None:
        """Fasten, or let go, once everybody has confirmed (R6)."""
        if not self._me.asks or self._changes.get("phase", self._me.phase) is not self._me.phase:
            self._waits = []
            return
        now, hold = self.hearing.now, self.settings.hold
        self._confirmed = {n: t for n, t in self._confirmed.items() if now - t < hold}
        self._waits = [name for name in self._asked() if name not in self._confirmed]
        if self._waits or not self.hearing.has_listened or self._dirty_since is not None:
            return
        place = self._me.place
        assert place is not None
        asked = " ".join(self._asked()) or "nobody"
        if self._me.phase is Phase.ARRIVED:
            self._change(phase=Phase.FASTENING)
            self._report("fastens", f"{self.name} fastens; confirmed by {asked}")
            self._out.append(Fasten(place))
        elif not self._may_loosen:
            self._may_loosen = True
            self._report("lets go", f"{self.name} lets go to move; confirmed by {asked}")
            self._out.append(Loosen())

    def _asked(self) -> list[str]:
        """Return whose confirmation is needed (R6)."""
        if not self.settings.roster:
            return sorted(name for name in self.hearing.heard if name != self.name)
        gone = {each for record in self.memory for each in record.gone}
        needed = []
        for name in self.settings.roster:
            record = self.memory.get(name)
            is_gone = record is not None and (name, record.incarnation) in gone
            has_left = record is not None and record.phase is Phase.LEFT
            if name != self.name and not is_gone and not has_left:
                needed.append(name)
        return needed

    # -- changes of itself ----------------------------------------------------------------

    def _attach(self, place: Place) -> None:
        """Be attached at a measured place."""
        try:
            there = self.planner.measured(place)
        except SwarmGraspError as error:
            self._report("mismeasured", f"{self.name}: {error.faults[0]}")
            there = self._me.place or place
        self._may_loosen = False
        self._blocked.clear()
        self._change(phase=Phase.ATTACHED, place=there)
        view = self.view
        others = [row for row in view.rows if row.id != self.name]
        rows = in_order([*others, row_of(self._me_now())], self.planner)
        lower = self.planner.lower(rows)
        self._change(lower=lower)
        self._report("attached", f"{self.name} is attached: quality {lower:.4g} N certified")
        self._mark_dirty()

    def _go_away(self) -> None:
        """Leave."""
        if self._me.phase is not Phase.LEFT:
            self._out.append(Halt())
            self._report("left", f"{self.name} leaves")
        self._leaving = self._may_loosen = False
        self._blocked.clear()
        self._change(phase=Phase.LEFT, place=None, ticket=0, lower=0.0, basis=b"", plan=None)

    def _new_ticket(self) -> None:
        """Take a place in the order behind all that are known."""
        self._clock += 1
        self._change(ticket=self._clock)

    def _me_now(self, what: str | None = None) -> Any:
        """Return the record as changed so far, or a field of it."""
        if what is not None:
            return self._changes.get(what, getattr(self._me, what))
        return msgspec.structs.replace(self._me, **self._changes)

    def _change(self, **changes: Any) -> None:
        """Change the record; all changes of one event are told at once."""
        self._changes.update(changes)

    def _publish(self) -> None:
        """Tell everyone of the record, if it has changed or is to be told once more."""
        if self._changes:
            changed = self._me_now()
            self._changes = {}
            if changed != self._me:
                self._me = msgspec.structs.replace(changed, sequence=self._me.sequence + 1)
                self._again = True
        if self._again:
            self.memory.merge(self._me)
            self._send(EVERYONE, Put(self._me))
            self._again = False

    def _speak(self) -> None:
        """Confirm, ask once more, and give a sign of life, each when it is due."""
        now, settings = self.hearing.now, self.settings
        for name, of in self._acks.items():
            self._send(name, Ack(of, self._me))
            record = self.memory.get(name)
            if record is not None and record.phase is Phase.ARRIVED:
                self._reckoned.add(record.arrived_as)
        self._acks = {}
        if self._me.asks and now >= self._next_retry:
            self._next_retry = now + settings.retry
            for name in self._waits:
                self._send(name, Put(self._me))
            self._tell_waits()
        if now >= self._next_beat:
            self._next_beat = now + settings.beat
            self._send(EVERYONE, Beat(self.name, self._clock, self.memory.digest))
            absent = self._absent()
            if self._told.get("absent") != absent:
                self._told["absent"] = absent
                self._mark_dirty()
            self._improve()
            self._publish()

    def _tell_waits(self) -> None:
        """Tell for whom it waits, when that changes."""
        waits = tuple(self._waits)
        if waits and self._told.get("waits") != waits:
            self._told["waits"] = waits
            silent = ", ".join(
                f"{name} ({'heard' if self.hearing.is_heard(name) else 'not heard'})"
                for name in waits
            )
            self._report("waits", f"{self.name} waits for {silent}", *waits)

    def _mark_dirty(self) -> None:
        """Note that something has changed that decisions rest on."""
        if self._dirty_since is None:
            self._dirty_since = self.hearing.now

    def _send(self, to: str, message: Message) -> None:
        """Send a message."""
        self._out.append(Send(to, message))

    def _report(self, what: str, words: str, *about: str, key: str = "") -> None:
        """Tell a person; of things with a key once only."""
        if key and self._told.get(key) == words:
            return
        if key:
            self._told[key] = words
        self._out.append(Report(what, words, about))


_HANDLERS: dict[type, Callable[[Agent, Any], None]] = {
    Start: Agent._start,
    Join: Agent._join,
    Leave: Agent._leave,
    Move: Agent._move,
    Tick: Agent._tick,
    Received: Agent._received,
    Refuted: Agent._refuted,
    Up: Agent._up,
    Down: Agent._down,
    Cut: Agent._cut,
    Stranger: Agent._stranger,
    AtPlace: Agent._at_place,
    Fastened: Agent._fastened,
    Refused: Agent._refused_place,
    Loosened: Agent._loosened,
    Witness: Agent._witness,
    Planned: Agent._planned,
}


def _old_record(name: str, state: State | None) -> Record | None:
    """Return what a robot said of itself last in its former life."""
    if state is None:
        return None
    if not any(record.id == name for record in state.records):
        raise AgentInvalid(f"the state is another robot's: it does not know {name}")
    return next(record for record in state.records if record.id == name)
