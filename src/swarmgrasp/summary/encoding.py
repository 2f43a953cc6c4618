"""Summaries as bytes: a header, one record per occupied bin, a checksum.

The layout is written out in docs/summary.md. What rounding to records moves of the bins' sums is
added to the rounding that the header states. What was read is written back to the same bytes.
"""

import hashlib
import math
from collections.abc import Iterator

import numpy as np

from swarmgrasp.errors import MetricInvalid, SummaryInvalid
from swarmgrasp.summary.cells import MOST_SIDE
from swarmgrasp.summary.content import MOST_ROBOTS, Content
from swarmgrasp.summary.records import RECORD, Records, moments_from, records_of
from swarmgrasp.swarm.swarm import check_metric

MAGIC = b"SGsm"
VERSION = 1
HEADER = np.dtype(
    [
        ("magic", "S4"),
        ("version", "<u2"),
        ("side", "<u2"),
        ("exponent", "<i4"),
        ("records", "<u4"),
        ("count", "<u8"),
        ("total", "<f8", 3),
        ("rounding", "<f8"),
        ("force_weights", "<f8", 2),
        ("length", "<f8"),
        ("origin", "<f8", 2),
    ]
)
CHECKSUM = 8
"""Bytes of BLAKE2b at the end."""
LARGEST_EXPONENT = 500
"""Of that power of two: generators range from 1e-120 to 1e120 N."""


def encode(content: Content) -> bytes:
    """Write a summary as bytes."""
    records, exponent, moved = records_of(content.moments, content.side)
    header = np.zeros((), HEADER)
    header["magic"], header["version"], header["side"] = MAGIC, VERSION, content.side
    header["exponent"], header["records"], header["count"] = exponent, len(records), content.count
    header["total"], header["origin"] = content.total, content.origin
    header["rounding"] = content.rounding + moved
    header["force_weights"] = content.force_weights
    header["length"] = content.characteristic_length
    body = header.tobytes() + records.tobytes()
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
    header, records = _framed(data)
    with np.errstate(invalid="ignore"):  # not a number? it is told below
        faults = list(_faults(header, records))
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
        force_weights=tuple(header["force_weights"].tolist()),
        characteristic_length=float(header["length"]),
        origin=tuple(header["origin"].tolist()),
    )
    if encode(content) != data:
        raise SummaryInvalid("a number is out of its range, or not written as it should be")
    return content


def _framed(data: bytes) -> tuple[np.void, Records]:
    """Check the frame of some bytes, and return the header and the records."""
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
    records = int(header["records"])
    wanted = HEADER.itemsize + records * RECORD.itemsize + CHECKSUM
    if len(data) != wanted:
        raise SummaryInvalid(
            f"a summary of {records} bins has {wanted} bytes; these are {len(data)}: "
            "it was cut short or something was added"
        )
    if _checksum(data[:-CHECKSUM]) != data[-CHECKSUM:]:
        raise SummaryInvalid("the checksum does not fit: the bytes were damaged; send them again")
    return header, np.frombuffer(data, RECORD, records, HEADER.itemsize)


def _faults(header: np.void, records: Records) -> Iterator[str]:
    """Yield what is wrong with the numbers of an undamaged message."""
    side, count, exponent = (int(header[key]) for key in ("side", "count", "exponent"))
    total, rounding = header["total"], float(header["rounding"])
    if side % 2 or not 2 <= side <= MOST_SIDE:
        yield f"the cells along an edge are {side}; they should be even, 2 <= cells <= {MOST_SIDE}"
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
    if count == 0 and (rounding != 0.0 or total.any()):
        yield "no robots at all have a sum of zero, and no rounding"
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
