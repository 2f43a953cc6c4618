"""Binary frames: the length of a head in JSON, the head, and arrays, each at a multiple of 8."""

import struct
from collections.abc import Mapping, Sequence
from typing import NamedTuple

import msgspec
import numpy as np
from numpy.typing import NDArray

ALIGNED = 8
"""Bytes; the arrays of a frame begin at multiples, so that a page needs no copy of them."""
_LENGTH = struct.Struct("<I")
WIDTH = 4
"""Numbers of a robot in columns: two of its contact, its direction and its limit."""


class Columns(NamedTuple):
    """Many robots that push along one ray each.

    Attributes
    ----------
    contacts : (n, 2) [m, m]
    directions : (n,) [rad]
    limits : (n,) [N]
    names : sequence of str, optional
        Left out of those that have none of their own.
    """

    contacts: NDArray[np.float64]
    directions: NDArray[np.float64]
    limits: NDArray[np.float64]
    names: Sequence[str] | None


def packed(head: bytes, arrays: Mapping[str, NDArray[np.generic]]) -> bytes:
    """Return a head in JSON and arrays as one binary frame, little-endian."""
    head += b" " * (-(len(head) + _LENGTH.size) % ALIGNED)
    parts = [_LENGTH.pack(len(head)), head]
    for array in arrays.values():
        raw = np.ascontiguousarray(array, dtype=array.dtype.newbyteorder("<")).tobytes()
        parts += [raw, bytes(-len(raw) % ALIGNED)]
    return b"".join(parts)


def unframed(raw: bytes) -> tuple[bytes, memoryview]:
    """Take a binary frame apart: its head, and what follows.

    Raises
    ------
    msgspec.DecodeError
        If it is shorter than it says.
    """
    length = _LENGTH.unpack_from(raw)[0] if len(raw) >= _LENGTH.size else len(raw)
    start = _LENGTH.size + length
    if start > len(raw) or start % ALIGNED:
        raise msgspec.DecodeError("the head of a binary frame should end within it, at 8 bytes")
    return raw[_LENGTH.size : start], memoryview(raw)[start:]


def columns_of(body: memoryview, names: Sequence[str] | None) -> Columns:
    """Return the robots of a frame's body.

    Raises
    ------
    msgspec.DecodeError
        If it holds no whole number of robots, or other names than robots.
    """
    count, rest = divmod(len(body), WIDTH * 8)
    if rest or (names is not None and len(names) != count):
        raise msgspec.DecodeError("the columns should have 4 numbers for each robot, and a name")
    numbers = np.frombuffer(body, "<f8").astype(np.float64)
    contacts = numbers[: 2 * count].reshape(count, 2)
    return Columns(contacts, numbers[2 * count : 3 * count], numbers[3 * count :], names)
