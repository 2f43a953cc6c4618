"""Replies as they go over the wire: JSON, or a binary frame where there are arrays."""

from collections.abc import Mapping

import msgspec
import numpy as np
from numpy.typing import NDArray

from swarmgrasp.gui.frames import packed
from swarmgrasp.gui.replies import Array, RunTold, ToPage
from swarmgrasp.gui.told_parts import PartSaid

_writer = msgspec.json.Encoder()


def write_message(message: ToPage | PartSaid) -> bytes:
    """Write a message to a page, or the head of one that has arrays."""
    return _writer.encode(message)


def framed(head: PartSaid | RunTold, arrays: Mapping[str, NDArray[np.generic]]) -> bytes:
    """Return a message with its arrays as one binary frame.

    Parameters
    ----------
    head : PartSaid or RunTold
        One that has `arrays`, whose list is filled in here.
    arrays : mapping of str to array
    """
    listed = tuple(
        Array(name, array.dtype.str[1:], array.shape)  # type: ignore[arg-type]
        for name, array in arrays.items()
    )
    return packed(write_message(msgspec.structs.replace(head, arrays=listed)), arrays)
