"""How a group finds out that a silent robot has gone to another group, as bytes and back.

A robot that has started anew without memory may join another group. Within its own group a robot's
former life is refuted by its present one; nobody in the former group hears that.
"""

import msgspec

from swarmgrasp.agents.protocol.record import MOST_INCARNATION, id_fault
from swarmgrasp.errors import MessageInvalid

MOST_SOUGHT = 1000
"""Robots that are looked for at once."""
MOST_GROUP = 1 << 32


class Seek(msgspec.Struct, frozen=True, array_like=True, tag="s"):
    """These robots are silent and should be in a group: who of them is elsewhere is to say so.

    Attributes
    ----------
    group : int
    robots : tuple of (str, int)
        Names and incarnations.
    """

    group: int
    robots: tuple[tuple[str, int], ...]


class Elsewhere(msgspec.Struct, frozen=True, array_like=True, tag="e"):
    """The sender is not in this group, where its former life was, of this incarnation."""

    group: int
    incarnation: int


_ENCODER = msgspec.msgpack.Encoder()
_DECODER: msgspec.msgpack.Decoder[Seek | Elsewhere] = msgspec.msgpack.Decoder(Seek | Elsewhere)


def encode_seeking(message: Seek | Elsewhere) -> bytes:
    """Return a question or an answer as bytes."""
    return _ENCODER.encode(message)


def decode_seeking(data: bytes) -> Seek | Elsewhere:
    """Return the question or the answer that bytes hold, whoever sent them.

    Raises
    ------
    MessageInvalid
        If they hold none, or one that no sound robot sends.

    Examples
    --------
    >>> decode_seeking(encode_seeking(Elsewhere(3, 1 << 20)))
    Elsewhere(group=3, incarnation=1048576)
    """
    try:
        message = _DECODER.decode(data)
    except (msgspec.MsgspecError, RecursionError, ValueError) as error:
        raise MessageInvalid(f"{len(data)} bytes look for nobody: {error}") from None
    match message:
        case Seek(group, robots):
            faults = [fault for name, _ in robots if (fault := id_fault(name))]
            numbers = [number for _, number in robots]
        case Elsewhere(group, number):
            faults, numbers = [], [number]
    if faults:
        raise MessageInvalid(f"a robot that is looked for {faults[0]}")
    counts = all(0 <= number < MOST_INCARNATION for number in numbers) and 0 <= group < MOST_GROUP
    if not counts or len(numbers) > MOST_SOUGHT:
        raise MessageInvalid("who is looked for counts beyond all ranges")
    return message
