"""All records a robot has: of each robot the newest word, and a digest of them all."""

import hashlib
from collections.abc import Iterable, Iterator
from enum import Enum

from swarmgrasp.agents.protocol.record import BASIS, Record, Version
from swarmgrasp.agents.protocol.wire import encode

MOST_ROBOTS = 20_000
"""Robots whose records are kept; more are refused."""


class Merged(Enum):
    """What became of a record that came in."""

    OLD = "older than what is known, or the same"
    NEW = "new"
    TWO_STORIES = "one version, two contents"
    FULL = "one robot too many"


class Memory:
    """A map of robots to their records; the higher version wins, and nothing is ever resolved.

    Examples
    --------
    >>> from swarmgrasp.agents.protocol.record import Phase
    >>> memory = Memory()
    >>> memory.merge(Record("Ajax", 1, 2, Phase.LEFT)).name
    'NEW'
    >>> memory.merge(Record("Ajax", 1, 1, Phase.LEFT)).name, len(memory)
    ('OLD', 1)
    """

    def __init__(self, records: Iterable[Record] = ()) -> None:
        self._records: dict[str, Record] = {}
        self._digest = 0
        for record in records:
            self.merge(record)

    def __len__(self) -> int:
        return len(self._records)

    def __iter__(self) -> Iterator[Record]:
        return iter(self._records.values())

    def __contains__(self, name: str) -> bool:
        return name in self._records

    def get(self, name: str) -> Record | None:
        """Return a robot's record, if it is known."""
        return self._records.get(name)

    @property
    def digest(self) -> bytes:
        """The same for the same records, in whatever order they came."""
        return self._digest.to_bytes(BASIS, "big")

    def merge(self, record: Record) -> Merged:
        """Keep a record if it is newer than what is known."""
        known = self._records.get(record.id)
        if known is None:
            if len(self._records) >= MOST_ROBOTS:
                return Merged.FULL
            self._keep(record)
            return Merged.NEW
        if record.version < known.version:
            return Merged.OLD
        if record.version > known.version:
            self._keep(record)
            return Merged.NEW
        mine, theirs = encode(known), encode(record)
        if mine == theirs:
            return Merged.OLD
        if theirs > mine:  # the same of the two wins everywhere
            self._keep(record)
        return Merged.TWO_STORIES

    def versions(self) -> tuple[tuple[str, int, int], ...]:
        """Return every robot's name, incarnation and sequence."""
        return tuple((r.id, r.incarnation, r.sequence) for r in self)

    def newer_than(self, versions: Iterable[tuple[str, int, int]]) -> tuple[Record, ...]:
        """Return the records that someone with these versions lacks."""
        theirs: dict[str, Version] = {name: (i, s) for name, i, s in versions}
        return tuple(r for r in self if r.version > theirs.get(r.id, (-1, -1)))

    def lacks(self, versions: Iterable[tuple[str, int, int]]) -> bool:
        """Tell whether someone with these versions has newer ones."""
        for name, *version in versions:
            known = self._records.get(name)
            if known is None or tuple(version) > known.version:
                return True
        return False

    def _keep(self, record: Record) -> None:
        """Take a record instead of what is known of its robot."""
        old = self._records.get(record.id)
        if old is not None:
            self._digest ^= _mark(old)
        self._records[record.id] = record
        self._digest ^= _mark(record)


def _mark(record: Record) -> int:
    """Return a record's part of the digest."""
    return int.from_bytes(hashlib.blake2b(encode(record), digest_size=BASIS).digest(), "big")
