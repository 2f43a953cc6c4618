"""Confirmations: who has reckoned with this robot at its place, and who has yet to (R5, R6)."""

from swarmgrasp.agents.protocol.knowledge import Knowledge
from swarmgrasp.agents.protocol.record import Record
from swarmgrasp.agents.protocol.settings import Settings


class Confirmations:
    """The confirmations of one arrival, or of one wish to let go.

    Parameters
    ----------
    me : str
    knowledge : Knowledge
    settings : Settings
    """

    def __init__(self, me: str, knowledge: Knowledge, settings: Settings) -> None:
        self._me, self._knowledge, self._settings = me, knowledge, settings
        self._by: dict[str, float] = {}

    def clear(self) -> None:
        """Let none hold any longer."""
        self._by.clear()

    def drop(self, name: str) -> None:
        """Let a robot's hold no longer: another life of it has confirmed nothing."""
        self._by.pop(name, None)

    def take(self, name: str) -> None:
        """Take a robot's confirmation."""
        self._by[name] = self._knowledge.hearing.now

    @property
    def needed(self) -> list[str]:
        """The robots that have to confirm."""
        if not self._settings.roster:
            return sorted(name for name in self._knowledge.hearing.heard if name != self._me)
        gone, get = self._knowledge.gone, self._knowledge.memory.get
        return [
            name
            for name in self._settings.roster
            if name != self._me and not _is_off(get(name), gone)
        ]

    @property
    def lacking(self) -> list[str]:
        """The robots that have to confirm and have not within `hold`."""
        now, hold = self._knowledge.hearing.now, self._settings.hold
        return [name for name in self.needed if not now - self._by.get(name, -hold) < hold]


def _is_off(record: Record | None, gone: set[tuple[str, int]]) -> bool:
    """Tell whether a robot of a roster is testified gone.

    One that has left may have come again, out of hearing, and know as little of this one.
    """
    return record is not None and (record.id, record.incarnation) in gone
