"""Binary frames: the length of a head in JSON, the head, and arrays, each at a multiple of 8."""

import struct
from collections.abc import Mapping

import msgspec
import numpy as np
from numpy.typing import NDArray

from swarmgrasp.studio.messages import Array, PartSaid, RunTold, write_message

ALIGNED = 8
"""Bytes; the arrays of a frame begin at multiples, so that a page needs no copy of them."""
_LENGTH = struct.Struct("<I")


def framed(head: PartSaid | RunTold, arrays: Mapping[str, NDArray[np.generic]]) -> bytes:
    """Return a part with its arrays as one binary frame, little-endian.

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
    written = write_message(msgspec.structs.replace(head, arrays=listed))
    written += b" " * (-(len(written) + _LENGTH.size) % ALIGNED)
    parts = [_LENGTH.pack(len(written)), written]
    for array in arrays.values():
        raw = np.ascontiguousarray(array, dtype=array.dtype.newbyteorder("<")).tobytes()
        parts += [raw, bytes(-len(raw) % ALIGNED)]
    return b"".join(parts)
