"""Summaries as bytes: small, exact in return, and never misread."""

import hashlib

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from summary.crowds import KINDS, summary_of
from swarmgrasp import Outline, Robot, Swarm
from swarmgrasp.errors import SummaryInvalid
from swarmgrasp.summary import Summary
from swarmgrasp.summary.encoding import HEADER, WRENCH
from swarmgrasp.summary.records import RECORD

FIVE = summary_of("round", 7, 5).to_bytes()
TUG = Robot((1, 0), 3.0, steers=0.5)
STEERING = Summary.of(Swarm(Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)]), [TUG]), 12).to_bytes()


def signed(body):
    """Put the right checksum to a body."""
    return bytes(body) + hashlib.blake2b(body, digest_size=8).digest()


def altered(field, value, record=None):
    """Return the five robots' bytes with one number changed and the checksum right."""
    body = bytearray(FIVE[:-8])
    if record is None:
        view = np.frombuffer(body, HEADER, 1)
    else:
        view = np.frombuffer(body, RECORD, 5, HEADER.itemsize)[record : record + 1]
    view[field] = value
    return signed(body)


@given(st.sampled_from(KINDS), st.integers(0, 2**32 - 1), st.integers(0, 40), st.integers(12, 9999))
def test_what_is_read_is_written_back(kind, seed, n, bins):
    """The same bytes, no more of them than promised, and nothing lost but rounding."""
    summary = summary_of(kind, seed, n, bins)
    data = summary.to_bytes()
    known = Summary.from_bytes(data)
    assert known.to_bytes() == data
    assert len(data) <= 108 + 18 * len(summary.moments.cells)
    assert (known.count, known.bins) == (summary.count, summary.bins)
    assert (known.total == summary.total).all()
    assert known.rounding <= summary.rounding + 1e-4 * summary.moments.size


def test_every_flipped_bit_is_noticed():
    """One by one, in a message of five robots."""
    for bit in range(8 * len(FIVE)):
        data = bytearray(FIVE)
        data[bit // 8] ^= 1 << bit % 8
        with pytest.raises(SummaryInvalid):
            Summary.from_bytes(bytes(data))


def test_every_cut_and_every_addition_is_noticed():
    """Also where the checksum was made to fit."""
    for length in range(len(FIVE)):
        with pytest.raises(SummaryInvalid):
            Summary.from_bytes(FIVE[:length])
    for length in range(len(FIVE) - 8):
        with pytest.raises(SummaryInvalid):
            Summary.from_bytes(signed(FIVE[:length]))
    for more in (b"\0", FIVE):
        with pytest.raises(SummaryInvalid, match="something was added"):
            Summary.from_bytes(FIVE + more)
    with pytest.raises(SummaryInvalid, match="str is no kind of bytes"):
        Summary.from_bytes("SGsm")


@pytest.mark.parametrize(
    ("data", "says"),
    [
        (altered("magic", b"PNG!"), "the bytes begin with b'PNG!'"),
        (altered("version", 1), "of version 1; this program reads 2"),
        (altered("side", 0), "the cells along an edge are 0"),
        (altered("side", 7), "should be even"),
        (altered("side", 2), "0 <= bin < 12"),
        (altered("exponent", 501), "the exponent is 501"),
        (altered("records", 4), "has 180 bytes; these are 198"),
        (altered("count", 4), "4 robots cannot occupy 5 bins"),
        (altered("count", 0), "no robots at all"),
        (altered("count", 2**63), "is 9223372036854775808; it should be below"),
        (altered("count", 2**64 - 1), "should be below"),
        (altered("total", [0, np.nan, 0]), "the sum of all generators is not finite"),
        (altered("total", [0, 0, 1e9]), "longer than all bins together"),
        (altered("rounding", -1e-9), "the rounding is -1e-09"),
        (altered("rounding", np.inf), "the rounding is inf"),
        (altered("force_weights", [1, 0]), "the force weight a2 is 0.0"),
        (altered("length", np.nan), "the characteristic length is nan"),
        (altered("origin", [np.inf, 0]), "the origin is not finite"),
        (altered("cell", 108, 4), "0 <= bin < 108"),
        (altered("cell", 0, 4), "the bins do not increase"),
        (altered("cell", np.frombuffer(FIVE, RECORD, 5, 100)["cell"][0], 1), "do not increase"),
        (altered("weight", -1.0, 2), "not a positive number"),
        (altered("weight", 0.0, 2), "not a positive number"),
        (altered("weight", np.nan, 2), "not a positive number"),
        (altered("weight", np.inf, 2), "not a positive number"),
        (altered("weight", 1e-39, 2), "not written as it should be"),
        (altered("weight", 3.0, 2), "not written as it should be"),
        (altered("mean", -32768, 2), "not written as it should be"),
        (altered("correlation", -32768, 2), "not written as it should be"),
    ],
)
def test_nonsense_with_a_right_checksum_is_refused(data, says):
    """Each number out of its range is named."""
    with pytest.raises(SummaryInvalid, match=says):
        Summary.from_bytes(data)


@pytest.mark.parametrize(
    ("field", "value", "says"),
    [
        ("side", 4, "the directions are 18; they should be 0 or 66"),
        ("directions", 17, "of 0 bins and 17 directions has 312 bytes; these are 324"),
        ("count", 0, "no robots at all"),
        ("wrench", np.nan, "a wrench is not finite"),
        ("wrench", 3.0, "not written as it should be"),
    ],
)
def test_nonsense_about_wrenches_is_refused(field, value, says):
    """Of robots that are no rays, at 18 directions."""
    body = bytearray(STEERING[:-8])
    if field == "wrench":
        np.frombuffer(body, WRENCH, 54, HEADER.itemsize)[7] = value
    else:
        np.frombuffer(body, HEADER, 1)[field] = value
    with pytest.raises(SummaryInvalid, match=says):
        Summary.from_bytes(signed(body))


def test_more_robots_than_python_can_count():
    """The most there may be has a length; it and one more are too many."""
    most = Summary.from_bytes(altered("count", 2**63 - 1))
    assert len(most) == 2**63 - 1
    with pytest.raises(SummaryInvalid, match=r"they have 9223372036854775812 robots together"):
        most + Summary.from_bytes(FIVE)


@given(st.integers(0, 2**32 - 1))
def test_random_records_crash_nothing(seed):
    """They are refused, or stand for some swarm; its bounds are numbers in order."""
    rng = np.random.default_rng(seed)
    body = bytearray(FIVE[:-8])
    for _ in range(int(rng.integers(1, 4))):
        body[int(rng.integers(len(body)))] = int(rng.integers(256))
    try:
        known = Summary.from_bytes(signed(body))
    except SummaryInvalid:
        return
    assert known.to_bytes() == signed(body)
    bounds = known.quality()
    assert 0.0 <= bounds.lower <= bounds.upper < np.inf


@pytest.mark.parametrize("scale", [1e-100, 1e100])
def test_tiny_and_huge_forces(scale):
    """No float32 runs out of its range."""
    B = np.random.default_rng(3).normal(size=(50, 3))
    small = Summary.from_generators(B, 108)
    known = Summary.from_bytes(Summary.from_generators(scale * B, 108).to_bytes())
    assert known.quality().lower == pytest.approx(scale * small.quality().lower, rel=1e-3)
    assert known.quality().upper == pytest.approx(scale * small.quality().upper, rel=1e-3)
