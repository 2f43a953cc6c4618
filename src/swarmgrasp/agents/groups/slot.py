"""What one group tells all others of itself, as bytes and back."""

import math
from functools import lru_cache

import msgspec

from swarmgrasp.agents.protocol.record import BASIS, MOST_SEQUENCE, id_fault
from swarmgrasp.errors import MessageInvalid, SwarmGraspError
from swarmgrasp.ranges import shown
from swarmgrasp.summary import Summary

MOST_BYTES = 1 << 20
"""Length of a slot."""
MOST_TOLD = 1000
"""Slots in one message."""


class Slot(msgspec.Struct, frozen=True, array_like=True):
    """What the robots of a group that hold the object can do together.

    One robot writes it at a time. Slots of a group are never added up: the newest one holds.

    Attributes
    ----------
    group : int
    turn, sequence : int
        Its version: how often the writer has changed, and which word of this one it is.
    writer : str
    count : int
        Robots.
    basis : bytes
        Digest of them, where they are.
    has_room : bool
        Whether another one has a place in the group.
    least, most : float [N]
        The quality of those robots that the summary leaves out, and the largest of their support
        function. The quality of all together is at least the sum of qualities, and at most that of
        the others and this largest (T29).
    summary : bytes
        Of the robots that push along one ray each: 18 bytes for each, at most 11 kB.
    """

    group: int
    turn: int
    sequence: int
    writer: str
    count: int
    basis: bytes
    has_room: bool
    least: float
    most: float
    summary: bytes

    @property
    def version(self) -> tuple[int, int, str]:
        """The higher is the newer; of two writers with the same, everyone takes the same."""
        return self.turn, self.sequence, self.writer


_ENCODER = msgspec.msgpack.Encoder()
_DECODER = msgspec.msgpack.Decoder(tuple[Slot, ...])


def encode(slots: tuple[Slot, ...]) -> bytes:
    """Return slots as bytes."""
    return _ENCODER.encode(slots)


def decode(data: bytes) -> tuple[Slot, ...]:
    """Return the slots that bytes hold, whoever sent them.

    Raises
    ------
    MessageInvalid
        If they hold none, or one that no sound robot writes.
    """
    try:
        slots = _DECODER.decode(data)
    except (msgspec.MsgspecError, RecursionError, ValueError) as error:
        raise MessageInvalid(f"{len(data)} bytes are no slots: {error}") from None
    faults = [fault for slot in slots[: MOST_TOLD + 1] if (fault := slot_fault(slot))]
    if len(slots) > MOST_TOLD:
        faults.append(f"are {len(slots)}; at most {MOST_TOLD} are read")
    if faults:
        raise MessageInvalid(f"slots {faults[0]}")
    return slots


def slot_fault(slot: Slot) -> str:
    """Return what is wrong with a slot, as the rest of a sentence; "" if nothing is."""
    fault = id_fault(slot.writer)
    if fault:
        return f"have a writer that {fault}"
    counts = {"group": slot.group, "turn": slot.turn, "sequence": slot.sequence}
    for what, value in {**counts, "count": slot.count}.items():
        if not 0 <= value < MOST_SEQUENCE:
            return f"have the {what} {shown(value)}; it should be 0 <= {what} < {MOST_SEQUENCE}"
    if not 0.0 <= slot.least <= slot.most < math.inf:
        return f"have the qualities {shown(slot.least)} to {shown(slot.most)} N"
    if len(slot.basis) != BASIS or len(slot.summary) > MOST_BYTES:
        return "have a basis or a summary of impossible length"
    return ""


def summary_of(slot: Slot) -> Summary:
    """Return the summary that a slot holds.

    Raises
    ------
    MessageInvalid
        If it is damaged, or of more robots than there are.
    """
    try:
        summary = _summary(slot.summary)
    except SwarmGraspError as error:
        raise MessageInvalid(f"slots hold no summary: {error.faults[0]}") from None
    if summary.count > slot.count:
        raise MessageInvalid(f"slots of {slot.count} robots summarise {summary.count}")
    return summary


@lru_cache(maxsize=MOST_TOLD)
def _summary(data: bytes) -> Summary:
    """Return the summary that bytes hold; slots are told more often than they change."""
    return Summary.from_bytes(data)
