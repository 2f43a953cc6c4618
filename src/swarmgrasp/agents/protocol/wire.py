"""The six messages between robots, as bytes and back."""

import msgspec

from swarmgrasp.agents.protocol.record import (
    BASIS,
    MOST_INCARNATION,
    MOST_SEQUENCE,
    MOST_TICKET,
    Record,
    Row,
    id_fault,
    record_fault,
)
from swarmgrasp.errors import MessageInvalid

PROTOCOL = 1
"""Version of messages and rules; robots of different ones do not hear each other."""
MOST_BYTES = 4 << 20
"""Length of a message."""


class Put(msgspec.Struct, frozen=True, array_like=True, tag="p"):
    """The sender's record has changed; or it asks once more to be confirmed."""

    record: Record

    @property
    def sender(self) -> str:
        """Who says so."""
        return self.record.id


class Beat(msgspec.Struct, frozen=True, array_like=True, tag="b"):
    """The sender is there.

    Attributes
    ----------
    sender : str
    clock : int
        Its Lamport time.
    digest : bytes
        Of all records it has.
    """

    sender: str
    clock: int
    digest: bytes


class Ask(msgspec.Struct, frozen=True, array_like=True, tag="a"):
    """The sender has just come: send all records."""

    sender: str


class Have(msgspec.Struct, frozen=True, array_like=True, tag="h"):
    """The versions that the sender has: send what is newer, and perhaps say what you have."""

    sender: str
    versions: tuple[tuple[str, int, int], ...]
    answer: bool


class Records(msgspec.Struct, frozen=True, array_like=True, tag="r"):
    """Records that the receiver lacks."""

    sender: str
    clock: int
    records: tuple[Record, ...]


class Ack(msgspec.Struct, frozen=True, array_like=True, tag="k"):
    """The sender has reckoned with the receiver at its place; and what it says of itself now.

    Attributes
    ----------
    of : tuple of int
        Which arrival, or wish to let go, of the receiver it is of: its record's `asks_for`.
    record : Record
        The sender's own.
    """

    of: tuple[int, int, int, int]
    record: Record

    @property
    def sender(self) -> str:
        """Who says so."""
        return self.record.id


Message = Put | Beat | Ask | Have | Records | Ack

_ENCODER = msgspec.msgpack.Encoder()
_DECODER: msgspec.msgpack.Decoder[Message] = msgspec.msgpack.Decoder(Message)


def encode(message: Message | Record | Row) -> bytes:
    """Return a message, or a part of one, as bytes.

    Examples
    --------
    >>> decode(encode(Ask("Ajax")))
    Ask(sender='Ajax')
    """
    return _ENCODER.encode(message)


def decode(data: bytes) -> Message:
    """Return the message that bytes hold, whoever sent them.

    Raises
    ------
    MessageInvalid
        If they hold none, or one that no sound robot sends.
    """
    if len(data) > MOST_BYTES:
        raise MessageInvalid(f"a message has {len(data)} bytes; at most {MOST_BYTES} are read")
    try:
        message = _DECODER.decode(data)
    except (msgspec.MsgspecError, RecursionError, ValueError) as error:
        raise MessageInvalid(f"{len(data)} bytes are no message: {error}") from None
    fault = message_fault(message)
    if fault:
        raise MessageInvalid(f"a message {fault}")
    return message


def message_fault(message: Message) -> str:
    """Return what is wrong with a message, as the rest of a sentence; "" if nothing is."""
    match message:
        case Put(record):
            return record_fault(record)
        case Ack(_, record):
            return record_fault(record)
        case Records(sender, clock, records):
            faults = [id_fault(sender), _counts_fault(0, 0, clock), *map(record_fault, records)]
        case Beat(sender, clock, digest):
            faults = [id_fault(sender), _counts_fault(0, 0, clock)]
            faults += ["" if len(digest) == BASIS else "has a digest of impossible length"]
        case Have(sender, versions, _):
            faults = [id_fault(sender)]
            faults += [id_fault(name) or _counts_fault(i, s, 0) for name, i, s in versions]
        case Ask(sender):
            faults = [id_fault(sender)]
    return next(filter(None, faults), "")


def _counts_fault(incarnation: int, sequence: int, ticket: int) -> str:
    """Return whether a count is outside its range."""
    given = ((incarnation, MOST_INCARNATION), (sequence, MOST_SEQUENCE), (ticket, MOST_TICKET))
    return "" if all(0 <= value < most for value, most in given) else "counts beyond all ranges"
