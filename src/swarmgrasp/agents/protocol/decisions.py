"""Where a robot goes, whom it gives way to, and when it moves (R1 to R4, R10, R12)."""

import msgspec

from swarmgrasp.agents.protocol.confirming import Confirmations
from swarmgrasp.agents.protocol.events import Effect, Go, Halt, MakePlan
from swarmgrasp.agents.protocol.knowledge import Knowledge
from swarmgrasp.agents.protocol.order import (
    Choice,
    View,
    choices,
    conflicts_of,
    cut_off_by,
    in_order,
    is_surprised,
    plan_wanted,
    row_of,
    too_close,
)
from swarmgrasp.agents.protocol.planner import Planner, Rows
from swarmgrasp.agents.protocol.record import Phase, Place, Record
from swarmgrasp.agents.protocol.reports import Reports
from swarmgrasp.agents.protocol.settings import Settings
from swarmgrasp.agents.protocol.word import Word
from swarmgrasp.words import Unit


class Decisions:
    """A robot's decisions, from what it knows.

    Parameters
    ----------
    word : Word
        The robot's own record.
    knowledge : Knowledge
    confirmations : Confirmations
    reports : Reports
    planner : Planner
    settings : Settings
    reckoned : iterable of (str, int, int)
        The arrivals of others that it has confirmed, in a former life too.
    """

    def __init__(
        self, word: Word, knowledge: Knowledge, confirmations: Confirmations, reports: Reports,
        planner: Planner, settings: Settings, reckoned: set[tuple[str, int, int]],
    ) -> None:  # fmt: skip
        self._word, self._knowledge, self._reports = word, knowledge, reports
        self._confirmations, self._planner, self._settings = confirmations, planner, settings
        self.reckoned = reckoned
        self.out: list[Effect] = []
        self.may_loosen = False
        """Whether everyone has agreed that it lets go."""
        self._blocked: list[Place] = []
        self._settled: frozenset[str] = frozenset()
        self._is_planning = False
        self._planned_for: tuple[Rows, tuple[str, ...]] | None = None
        self._quiet_since = 0.0

    @property
    def name(self) -> str:
        """The robot's name."""
        return self._word.said.id

    @property
    def view(self) -> View:
        """The robots it reckons with, itself as it is now."""
        return self._knowledge.view(self._word.now)

    def decide(self) -> None:
        """Act upon what has changed."""
        self._quiet_since = self._knowledge.hearing.now
        view = self.view
        settled = frozenset(record.id for record in view.settled)
        if self._settled - settled:
            self._blocked.clear()  # who has gone may have been what was seen there
        self._settled = settled
        match self._word.now.phase:
            case Phase.WAITING | Phase.COMING:
                self.choose(view)
            case Phase.ARRIVED:
                self._give_way(view)
            case Phase.ASKING:
                self._take_back()
            case Phase.ATTACHED:
                self._drop_plan(view)
                self._look_around(view)

    def choose(self, view: View | None = None) -> None:
        """Take the best place beside all with an earlier ticket (R1 to R3).

        Parameters
        ----------
        view : View, optional
            The robots it reckons with, if that is known already.
        """
        view = view or self.view
        surprise = is_surprised(self._word.now, view, self.reckoned)
        if surprise is not None:
            view = self._gone_behind(surprise)
        has_dropped = self._drop_plan(view)
        self._ask_for_plan(view)
        view = self.view if has_dropped else view
        choice = self._choice(view)
        while other := cut_off_by(self._word.now, choice, view, self._planner, self._blocked):
            view = self._gone_behind(other)
            choice = self._choice(view)
        if choice.place is None:
            self.find_no_room()
        else:
            self._head_for(self._kept(choice) or choice.place, choice)

    def _choice(self, view: View) -> Choice:
        """Return the place that the rule gives it now (R1)."""
        return choices(view, self._planner, self.name, self._blocked)[self.name]

    def _gone_behind(self, other: Record) -> View:
        """Take a new ticket, behind a robot that did not reckon with this one (R2)."""
        self._word.change(ticket=self._knowledge.next_ticket())
        words = f"{other.id} did not reckon with {self.name}, which takes a new ticket"
        self._reports.tell("new ticket", words, other.id)
        return self.view

    def find_no_room(self) -> None:
        """Wait where it is."""
        if self._word.now.phase is not Phase.WAITING:
            self.out.append(Halt())
        self.be_nowhere(Phase.WAITING)
        self._reports.tell_once("no room", "no room", f"{self.name} finds no room")

    def be_nowhere(self, phase: Phase) -> None:
        """Have no place."""
        self._word.change(phase=phase, place=None, lower=0.0, basis=b"")

    def arrive(self) -> None:
        """Announce that it has arrived, if its place is still its own (R4)."""
        target = self._word.now.place
        self.choose()
        now = self._word.now
        if now.phase is Phase.COMING and now.place == target:
            self._confirmations.clear()
            self._word.change(phase=Phase.ARRIVED, arrival=now.arrival + 1)

    def attach(self, place: Place) -> None:
        """Be attached at a measured place (R8)."""
        there = self._planner.measured(place)
        self.may_loosen = False
        self._blocked.clear()
        self._word.change(phase=Phase.ATTACHED, place=there)
        lower = self._planner.lower(in_order(self.view.holding, self._planner))
        self._word.change(lower=lower)
        words = f"{self.name} is attached: quality {_told(lower)} certified"
        self._reports.tell("attached", words)

    def avoid(self, place: Place) -> None:
        """Keep clear of a place that is seen to be taken (R8)."""
        self._blocked.append(place)
        where = f"({place.x:.4g}, {place.y:.4g}) m"
        self._reports.tell("taken", f"{self.name} finds its place taken: {where}")
        self._turn_away()

    def begin_anew(self) -> None:
        """Come with a new ticket: it has let go of its place, or lost it."""
        self.may_loosen = False
        self._blocked.clear()
        self.be_nowhere(Phase.WAITING)
        self._word.change(ticket=self._knowledge.next_ticket())

    def plan_is_made(self) -> None:
        """Note that a joint plan was made, or that there is none."""
        self._is_planning = False

    def reason_to_stay(self) -> str:
        """Return why this robot may not let go now; "" if it may (R10)."""
        view = self.view
        under_way = [r for r in view.movers if r.phase is Phase.COMING]
        under_way += [r for r in view.settled if r.phase < Phase.ATTACHED]
        if under_way:
            return f"{under_way[0].id} is under way"
        for record in view.settled:
            if record.phase is Phase.ASKING and record.order < self._word.now.order:
                return f"{record.id} asked before it"
        rows = tuple(row for row in in_order(view.holding, self._planner) if row.id != self.name)
        left = self._planner.lower(rows)
        if left < self._settings.floor:
            return f"quality without it is {_told(left)}, below {_told(self._settings.floor)}"
        return ""

    def ask_to_move(self) -> None:
        """Ask everyone whether it may let go (R10)."""
        self._confirmations.clear()
        self._word.change(phase=Phase.ASKING, asked=self._word.now.asked + 1)
        self._reports.tell("asks", f"{self.name} asks to let go, for a better place")

    def improve(self) -> None:
        """Ask to move if nothing has happened for a while and this robot's move is the best."""
        improve, now = self._settings.improve, self._knowledge.hearing.now
        is_quiet = now >= self._quiet_since + 2.0 * self._settings.silent
        if improve is None or self._word.now.phase is not Phase.ATTACHED or not is_quiet:
            return
        self._quiet_since = now
        if self.reason_to_stay():
            return
        view = self.view
        names = [record.id for record in view.settled]
        rows = in_order(view.holding, self._planner)
        if self._planner.mover(rows, names, self._settings.floor, improve) == self.name:
            self.ask_to_move()

    def _head_for(self, place: Place, choice: Choice) -> None:
        """Go to a place, or keep going there."""
        now = self._word.now
        self._reports.forget("no room")
        rows = (*choice.rows, row_of(msgspec.structs.replace(now, place=place)))
        lower = self._planner.lower(rows)
        if place != now.place or now.phase is not Phase.COMING:
            self.out.append(Go(place))
            where = f"({place.x:.4g}, {place.y:.4g}) m"
            words = f"{self.name} goes to {where}: quality {_told(lower)}"
            self._reports.tell("going", words)
        self._word.change(phase=Phase.COMING, place=place, lower=lower, basis=choice.basis)

    def _kept(self, choice: Choice) -> Place | None:
        """Return the present target, if another is not worth the turn (R3)."""
        now, worth = self._word.now, self._settings.worth
        place, other = now.place, choice.place
        if place is None or other is None or place == other or not worth or choice.plan:
            return None
        taken = [*(row.place for row in choice.rows), *choice.obstacles]
        if not self._planner.is_clear(place, taken):
            return None
        at_old, at_new = (
            self._planner.lower((*choice.rows, row_of(msgspec.structs.replace(now, place=p))))
            for p in (place, other)
        )
        return place if at_new <= at_old * (1.0 + worth) else None

    def _give_way(self, view: View) -> None:
        """Give way to whom this robot has to (R4)."""
        conflicts = conflicts_of(self._word.now, view, self._planner)
        if conflicts:
            other = conflicts[0]
            self._reports.tell("gives way", f"{self.name} gives way to {other.id}", other.id)
            self._turn_away()

    def _turn_away(self) -> None:
        """Look for another place."""
        self._word.change(phase=Phase.COMING)
        self._confirmations.clear()
        self.choose()

    def _take_back(self) -> None:
        """Stay after all, if somebody is under way or asked earlier (R10)."""
        fault = "" if self.may_loosen else self.reason_to_stay()
        if fault:
            self._word.change(phase=Phase.ATTACHED)
            self._reports.tell("stays", f"{self.name} stays: {fault}")

    def _look_around(self, view: View) -> None:
        """Tell who holds the object too close, and move if that is due (R12)."""
        for first, second in too_close(view, self._planner, self.name):
            key = f"close {first.id} {second.id}"
            words = f"{first.id} and {second.id} are too close: {second.id} is the later one"
            self._reports.tell_once(key, "too close", words, first.id, second.id)
            is_later = second.id == self.name and self._settings.resolve
            if is_later and not self.reason_to_stay():
                self.ask_to_move()
                return

    def _ask_for_plan(self, view: View) -> None:
        """Have a joint plan made, if this robot is the one to make it."""
        if self._is_planning:
            return
        is_heard = self._knowledge.hearing.is_heard
        heard = tuple(r for r in view.movers if r.id == self.name or is_heard(r.id))
        there = View(view.fixed, view.settled, heard, view.doubted)
        wanted = plan_wanted(there, self._planner, self.name)
        if wanted is not None and wanted != self._planned_for:
            self._planned_for = wanted
            self._is_planning = True
            self.out.append(MakePlan(*wanted, self._planner.who(self._word.now)))

    def _drop_plan(self, view: View) -> bool:
        """Take back a plan whose robots are all at their place, or gone; tell whether it did."""
        plan = self._word.now.plan
        on_their_way = {record.id for record in view.movers}
        if plan is None or any(name in on_their_way for name, _ in plan.places):
            return False
        self._word.change(plan=None)
        return True


def _told(quality: float) -> str:
    """Say a quality [N] as reports of other commands do."""
    return Unit.for_size(quality).text(quality)
