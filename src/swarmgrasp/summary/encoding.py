"""Summaries as bytes: a header, one record per occupied bin, wrenches, a checksum.

The layout is written out in docs/summary.md. What rounding to records moves of the bins' sums is
added to the rounding that the header states. What was read is written back to the same bytes.
"""

import hashlib
import math
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import MetricInvalid, SummaryInvalid
from swarmgrasp.summary.cells import MOST_SIDE, Array
from swarmgrasp.summary.content import MOST_ROBOTS, Content
from swarmgrasp.summary.lattice import OVERREACH, size_of
from swarmgrasp.summary.records import RECORD, Records, exponent_of, moments_from, records_of
from swarmgrasp.swarm.swarm import check_metric

MAGIC = b"SGsm"
VERSION = 2
HEADER = np.dtype(
    [
        ("magic", "S4"),
        ("version", "<u2"),
        ("side", "<u2"),
        ("exponent", "<i4"),
        ("records", "<u4"),
        ("directions", "<u4"),
        ("count", "<u8"),
        ("total", "<f8", 3),
        ("rounding", "<f8"),
        ("force_weights", "<f8", 2),
        ("length", "<f8"),
        ("origin", "<f8", 2),
    ]
)
WRENCH = np.dtype("<f4")
"""Of each component, relative to the power of two."""
CHECKSUM = 8
"""Bytes of BLAKE2b at the end."""
Rows = NDArray[np.float32]
LARGEST_EXPONENT = 500
"""Of that power of two: generators range from 1e-120 to 1e120 N."""


def encode(content: Content) -> bytes:
    """Write a summary as bytes."""
    largest = float(content.moments.weights.max(initial=0.0))
    exponent = exponent_of(max(largest, float(np.abs(content.wrenches).max(initial=0.0))))
    records, moved = records_of(content.moments, content.side, exponent)
    wrenches = np.ldexp(content.wrenches, -exponent).astype(WRENCH)
    drawn = np.linalg.norm(_wrenches_from(wrenches, exponent) - content.wrenches, axis=1)
    moved += OVERREACH * float(drawn.max(initial=0.0)) * (1.0 + 1e-9)
    header = np.zeros((), HEADER)
    header["magic"], header["version"], header["side"] = MAGIC, VERSION, content.side
    header["exponent"], header["count"] = exponent, content.count
    header["records"], header["directions"] = len(records), len(wrenches)
    header["total"], header["origin"] = content.total, content.origin
    header["rounding"] = content.rounding + moved
    header["force_weights"] = content.force_weights
    header["length"] = content.characteristic_length
    body = header.tobytes() + records.tobytes() + wrenches.tobytes()
    return body + _checksum(body)


def decode(data: bytes) -> Content:
    """Read a summary from bytes.

    Raises
    ------
    SummaryInvalid
        If they are not, to the last bit, what `encode` writes.
    """
    if not isinstance(data, bytes | bytearray | memoryview):
        raise SummaryInvalid(f"{type(data).__name__} is no kind of bytes; give what was written")
    data = bytes(data)
    header, records, rows = _framed(data)
    with np.errstate(invalid="ignore"):  # not a number? it is told below
        faults = list(_faults(header, records, rows))
    if faults:
        raise SummaryInvalid(faults)
    side, count, exponent = (int(header[key]) for key in ("side", "count", "exponent"))
    total, rounding = header["total"].copy(), float(header["rounding"])
    moments = moments_from(records, exponent, side)
    if not (np.abs(total) <= moments.size * (1.0 + 1e-9) + rounding).all():
        raise SummaryInvalid("the sum of all generators is longer than all bins together allow")
    content = Content(
        side=side,
        count=count,
        total=total,
        rounding=rounding,
        moments=moments,
        wrenches=_wrenches_from(rows, exponent),
        force_weights=tuple(header["force_weights"].tolist()),
        characteristic_length=float(header["length"]),
        origin=tuple(header["origin"].tolist()),
    )
    if encode(content) != data:
        raise SummaryInvalid("a number is out of its range, or not written as it should be")
    return content


def _wrenches_from(rows: Rows, exponent: int) -> Array:
    """Return the wrenches (k, 3) [N] that rows of the given exponent stand for."""
    return np.asarray(np.ldexp(rows.astype(float), exponent))


def _framed(data: bytes) -> tuple[np.void, Records, Rows]:
    """Check the frame of some bytes, and return the header, the records and the wrenches."""
    if len(data) < HEADER.itemsize + CHECKSUM:
        raise SummaryInvalid(
            f"{len(data)} bytes are no summary: the smallest has {HEADER.itemsize + CHECKSUM}"
        )
    (header,) = np.frombuffer(data, HEADER, 1)
    if bytes(header["magic"]) != MAGIC:
        raise SummaryInvalid(f"the bytes begin with {data[:4]!r}; a summary begins with {MAGIC!r}")
    if header["version"] != VERSION:
        raise SummaryInvalid(
            f"the summary is of version {header['version']}; this program reads {VERSION}"
        )
    records, directions = int(header["records"]), int(header["directions"])
    first = HEADER.itemsize + records * RECORD.itemsize
    wanted = first + 3 * directions * WRENCH.itemsize + CHECKSUM
    if len(data) != wanted:
        raise SummaryInvalid(
            f"a summary of {records} bins and {directions} directions has {wanted} bytes; these "
            f"are {len(data)}: "
            "it was cut short or something was added"
        )
    if _checksum(data[:-CHECKSUM]) != data[-CHECKSUM:]:
        raise SummaryInvalid("the checksum does not fit: the bytes were damaged; send them again")
    rows = np.frombuffer(data, WRENCH, 3 * directions, first).reshape(-1, 3)
    return header, np.frombuffer(data, RECORD, records, HEADER.itemsize), rows


def _faults(header: np.void, records: Records, rows: Rows) -> Iterator[str]:
    """Yield what is wrong with the numbers of an undamaged message."""
    side, count, exponent = (int(header[key]) for key in ("side", "count", "exponent"))
    total, rounding = header["total"], float(header["rounding"])
    if side % 2 or not 2 <= side <= MOST_SIDE:
        yield f"the cells along an edge are {side}; they should be even, 2 <= cells <= {MOST_SIDE}"
    if len(rows) not in (0, size_of(side)):
        yield f"the directions are {len(rows)}; they should be 0 or {size_of(side)}"
    if not np.isfinite(rows).all():
        yield "a wrench is not finite"
    if abs(exponent) > LARGEST_EXPONENT:
        yield f"the exponent is {exponent}; it should be within {LARGEST_EXPONENT} of 0"
    if not np.isfinite(total).all():
        yield "the sum of all generators is not finite"
    if not 0.0 <= rounding < math.inf:
        yield f"the rounding is {rounding}; it should be 0 <= rounding < inf [N]"
    if not np.isfinite(header["origin"]).all():
        yield "the origin is not finite"
    try:
        check_metric(float(header["length"]), tuple(header["force_weights"].tolist()))
    except MetricInvalid as fault:
        yield from fault.faults
    if count == 0 and (rounding != 0.0 or total.any() or len(rows)):
        yield "no robots at all have a sum of zero, no wrenches and no rounding"
    if count > MOST_ROBOTS:
        yield f"the number of robots is {count}; it should be below 2^63"
    if count < len(records):
        yield f"{count} robots cannot occupy {len(records)} bins"
    cells, weights = records["cell"].astype(np.int64), records["weight"]
    if not ((np.diff(cells, prepend=-1) > 0).all() and (cells < 3 * side**2).all()):
        yield f"the bins do not increase within 0 <= bin < {3 * side**2}"
    if not (np.isfinite(weights) & (weights > 0.0)).all():
        yield "a bin's weight is not a positive number"


def _checksum(body: bytes) -> bytes:
    """Return the bytes that tell damage."""
    return hashlib.blake2b(body, digest_size=CHECKSUM).digest()
