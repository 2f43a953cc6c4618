"""What a robot knows of the others: their records, when they were heard, the time by tickets."""

from collections.abc import Iterable

from swarmgrasp.agents.protocol.hearing import Hearing
from swarmgrasp.agents.protocol.memory import Memory, Merged
from swarmgrasp.agents.protocol.order import View, view_of
from swarmgrasp.agents.protocol.planner import Planner
from swarmgrasp.agents.protocol.record import Record
from swarmgrasp.agents.protocol.reports import Reports
from swarmgrasp.agents.protocol.settings import Settings

AHEAD = 1 << 20
"""How far a ticket or a clock may be ahead of one's own."""


class Knowledge:
    """The records of all robots, this one's own among them.

    Parameters
    ----------
    planner : Planner
    settings : Settings
    reports : Reports
        Where what cannot be is told.
    records : iterable of Record
        Known from a former life.
    clock : int
        Lamport's, from a former life.
    """

    def __init__(
        self, planner: Planner, settings: Settings, reports: Reports, records: Iterable[Record],
        clock: int,
    ) -> None:  # fmt: skip
        self._planner, self._settings, self._reports = planner, settings, reports
        self.hearing = Hearing(settings.silent)
        self.memory = Memory(records)
        self.clock = clock
        for record in self.memory:
            self.hearing.hear(record.id)  # it may be there still

    def next_ticket(self) -> int:
        """Return a ticket behind all that are known."""
        self.clock += 1
        return self.clock

    def hear_clock(self, sender: str, clock: int) -> None:
        """Take another's Lamport time, if it is not absurd."""
        if clock > self.clock + AHEAD:
            self._reports.refuse(sender, f"has a clock of {clock}, far ahead of all others")
        else:
            self.clock = max(self.clock, clock)

    def learn(self, record: Record) -> Record | None:
        """Take another's record, from whoever tells it; return what was known, if this is news.

        Returns
        -------
        Record, optional
            The record that it takes the place of, or itself if there was none; None if nothing
            is new.
        """
        if record.ticket > self.clock + AHEAD:
            fault = f"has the ticket {record.ticket}, far ahead of all others"
            self._reports.refuse(record.id, fault)
            return None
        known = self.memory.get(record.id)
        if known is not None and (record.version < known.version or record == known):
            return None
        fault = self._planner.fault(record)
        if fault:
            self._reports.refuse(record.id, f"cannot be what it says: {fault}")
            return None
        merged = self.memory.merge(record)
        if merged is Merged.TWO_STORIES:
            words = f"{record.id} tells two stories with one version: is the name in use twice?"
            self._reports.tell_once(f"stories {record.id}", "two stories", words, record.id)
        if merged is Merged.FULL:
            self._reports.refuse(record.id, "is one robot more than can be remembered")
            return None
        self.clock = max(self.clock, record.ticket)
        if known is None:
            self.hearing.hear(record.id)  # it may be there: it counts as silent when it has been
            return record
        return known if self.memory.get(record.id) is not known else None

    def absent(self, me: str) -> tuple[tuple[str, ...], tuple[str, ...]]:
        """Return who is forgotten, and who is doubted (R9)."""
        others = [record for record in self.memory if record.id != me]
        silence, settings = self.hearing.silence, self._settings
        on_their_way = (r.id for r in others if r.is_on_its_way)
        forgotten = tuple(n for n in on_their_way if silence(n) >= settings.forget)
        if settings.counts_silent:
            return forgotten, ()
        return forgotten, tuple(r.id for r in others if silence(r.id) >= settings.silent)

    def view(self, me: Record) -> View:
        """Return the robots to reckon with, beside a robot as it is now."""
        records = (me if record.id == me.id else record for record in self.memory)
        return view_of(records, self._planner.present, *self.absent(me.id))

    @property
    def gone(self) -> set[tuple[str, int]]:
        """All that is testified gone: robots, each with its incarnation."""
        return {each for record in self.memory for each in record.gone}
