"""A robot's own record, and its changes on the way to everyone."""

from typing import Any

import msgspec

from swarmgrasp.agents.protocol.record import LIVES, Record


class Word:
    """What a robot says of itself; all changes of one event are told at once.

    Parameters
    ----------
    record : Record
        As it was told last.
    """

    def __init__(self, record: Record) -> None:
        self.said = record
        self._changes: dict[str, Any] = {}
        self._is_due = False

    @property
    def now(self) -> Record:
        """The record as it will be told next."""
        if not self._changes:
            return self.said
        return msgspec.structs.replace(self.said, **self._changes)

    def change(self, **changes: Any) -> None:
        """Change fields of the record."""
        self._changes.update(changes)

    def repeat(self) -> None:
        """Tell it once more, changed or not."""
        self._is_due = True

    def outdo(self, incarnation: int) -> None:
        """Take a version above one that is not one's own (R11)."""
        drawn = self.said.incarnation % LIVES
        number = max(incarnation, self.said.incarnation) // LIVES + 1
        self.said = msgspec.structs.replace(self.said, incarnation=number * LIVES + drawn)
        self._is_due = True

    def take(self) -> Record | None:
        """Return the record to tell everyone now, if there is news or it is to be repeated."""
        if self._changes:
            changed, self._changes = self.now, {}
            if changed != self.said:
                self.said = msgspec.structs.replace(changed, sequence=self.said.sequence + 1)
                self._is_due = True
        is_due, self._is_due = self._is_due, False
        return self.said if is_due else None
