"""All groups' slots that a robot has, added up only when they are read."""

from collections.abc import Iterator

from swarmgrasp.agents.groups.parts import Parts
from swarmgrasp.agents.groups.slot import Slot, summary_of
from swarmgrasp.errors import MessageInvalid, SummaryInvalid
from swarmgrasp.summary import Summary
from swarmgrasp.swarm import Swarm

BINS = 1024
"""Bins of the groups' summaries."""


class Slots:
    """A map of groups to their newest slots.

    Adding up summaries twice would count robots twice, so that sums are never sent: only slots,
    of which the newest of a group holds, in whatever order and however often they come.

    Parameters
    ----------
    base : Swarm
        The robots that the mission begins with and that have no process: they are in no group.
    parts : Parts
    """

    def __init__(self, base: Swarm, parts: Parts) -> None:
        self.parts = parts
        self._base = Summary.of(base, BINS)
        self._none = Summary.of(base.without_rows(range(len(base))), BINS)
        self._slots: dict[int, Slot] = {}
        self._summaries: dict[int, Summary] = {}
        self.changes = 0
        """How often a slot was taken in: what is concluded from the slots is kept until then."""

    def __iter__(self) -> Iterator[Slot]:
        """Go through the slots, by group."""
        return iter([self._slots[group] for group in sorted(self._slots)])

    def get(self, group: int) -> Slot | None:
        """Return a group's slot, if it is known."""
        return self._slots.get(group)

    def merge(self, slot: Slot) -> bool:
        """Keep a slot if it is newer than what is known; tell whether it was.

        Raises
        ------
        MessageInvalid
            If there is no such group, or its summary is damaged or of another mission.
        """
        if slot.group >= len(self.parts):
            raise MessageInvalid(
                f"slots of group {slot.group} are of another mission: there are {len(self.parts)}"
            )
        known = self._slots.get(slot.group)
        if known is not None and slot.version <= known.version:
            return False
        summary = summary_of(slot)
        try:
            Summary.merge((self._none, summary))
        except SummaryInvalid as error:
            raise MessageInvalid(f"slots are of another mission: {error.faults[0]}") from None
        self._slots[slot.group], self._summaries[slot.group] = slot, summary
        self.changes += 1
        return True

    def summary(self, besides: int | None = None) -> Summary:
        """Return the summary of all groups, but for one."""
        kept = [s for group, s in sorted(self._summaries.items()) if group != besides]
        return Summary.merge([self._none, *kept])

    @property
    def everyone(self) -> Summary:
        """The summary of all groups, and of the mission's own robots."""
        return self._base + self.summary()

    def unknown(self, besides: int | None = None) -> tuple[float, float]:
        """Return by how much those that summaries leave out raise the quality [N].

        At least, and at most (T29); but for those of one group.
        """
        slots = [slot for slot in self if slot.group != besides]
        return sum(slot.least for slot in slots), sum(slot.most for slot in slots)

    def bounds(self) -> tuple[float, float]:
        """Bound the quality [N] of all robots that the slots count, and the mission's own.

        From below it holds whoever else is there, from above if nobody else is.
        """
        known, (least, most) = self.everyone.quality(), self.unknown()
        return known.lower + least, known.upper + most

    @property
    def count(self) -> int:
        """Robots of all groups."""
        return sum(slot.count for slot in self)
