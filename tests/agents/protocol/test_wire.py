"""Messages between robots: what is sent comes back, and nothing else comes in."""

import contextlib
import math

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from swarmgrasp.agents.protocol.memory import Memory, Merged
from swarmgrasp.agents.protocol.record import Kind, Phase, Place, Plan, Record, record_fault
from swarmgrasp.agents.protocol.wire import (
    MOST_BYTES,
    Ack,
    Ask,
    Beat,
    Have,
    Put,
    Records,
    decode,
    encode,
    message_fault,
)
from swarmgrasp.errors import MessageInvalid

NAMES = st.text("abcXYZ 0189-ü", min_size=1, max_size=12).filter(str.strip)
NUMBERS = st.floats(-1e6, 1e6)
PLACES = st.builds(Place, NUMBERS, NUMBERS, st.floats(-7, 7), st.floats(0, 3.1))
KINDS = st.builds(
    Kind, st.floats(1e-3, 1e9), st.sampled_from(["push", "pull", "free"]), st.none(), st.booleans()
)
COUNTS = st.integers(0, 1 << 31)


@st.composite
def records(draw, names=NAMES):
    """Any record that a sound robot may have."""
    phase = draw(st.sampled_from(list(Phase)))
    has_place = phase >= Phase.COMING
    return Record(
        draw(names), draw(COUNTS), draw(COUNTS), phase,
        ticket=draw(st.integers(1, 1 << 40)), arrival=draw(COUNTS), asked=draw(COUNTS),
        kind=draw(st.none() | KINDS), place=draw(PLACES) if has_place else None,
        lower=draw(st.floats(0, 1e9)), basis=draw(st.sampled_from([b"", b"12345678"])),
        gone=tuple(draw(st.lists(st.tuples(NAMES, COUNTS), max_size=3))),
        plan=draw(st.none() | st.builds(Plan, st.just(b"abcdefgh"), st.floats(0, 1e6), st.tuples(
            st.tuples(NAMES, PLACES)))),
    )  # fmt: skip


MESSAGES = st.one_of(
    st.builds(Put, records()),
    st.builds(Beat, NAMES, COUNTS, st.binary(min_size=8, max_size=8)),
    st.builds(Ask, NAMES),
    st.builds(
        Have,
        NAMES,
        st.lists(st.tuples(NAMES, COUNTS, COUNTS), max_size=4).map(tuple),
        st.booleans(),
    ),
    st.builds(Records, NAMES, COUNTS, st.lists(records(), max_size=3).map(tuple)),
    st.builds(Ack, st.tuples(COUNTS, COUNTS, COUNTS, COUNTS), records()),
)


@given(MESSAGES)
def test_messages_come_back_as_they_were_sent(message):
    """Every message of a sound robot survives the wire, to the last digit."""
    assert decode(encode(message)) == message


@given(st.binary(max_size=200))
def test_arbitrary_bytes_are_refused_in_one_way(data):
    """Whatever bytes come in, they are a message or a MessageInvalid, and never anything else."""
    try:
        message = decode(data)
    except MessageInvalid:
        return
    assert decode(encode(message)) == message


@given(MESSAGES, st.data())
def test_messages_that_were_cut_or_changed_are_refused_or_sound(message, data):
    """A message with one byte changed, or cut short, is refused or is another sound message."""
    raw = bytearray(encode(message))
    spot = data.draw(st.integers(0, len(raw) - 1))
    raw[spot] = data.draw(st.integers(0, 255))
    for damaged in (bytes(raw), bytes(raw[:spot])):
        with contextlib.suppress(MessageInvalid):
            assert message_fault(decode(damaged)) == ""


SOUND = Record("Ajax", 1 << 20, 3, Phase.COMING, ticket=4, place=Place(1.0, 2.0, 0.5))


@pytest.mark.parametrize(
    ("changes", "fault"),
    [
        ({"id": ""}, "1 to 64 bytes"),
        ({"id": "a/b"}, "none of"),
        ({"id": "x" * 65}, "1 to 64 bytes"),
        ({"id": "\u200b"}, "U+200B"),
        ({"ticket": 1 << 62}, "ticket"),
        ({"ticket": 0}, "without a ticket"),
        ({"incarnation": 1 << 52}, "incarnation"),
        ({"sequence": -1}, "sequence"),
        ({"place": None}, "no place"),
        ({"place": Place(math.nan, 0.0, 0.0)}, "contact"),
        ({"place": Place(0.0, math.inf, 0.0)}, "contact"),
        ({"place": Place(0.0, 0.0, math.nan)}, "direction"),
        ({"place": Place(0.0, 0.0, 0.0, -1.0)}, "steers"),
        ({"lower": math.nan}, "quality"),
        ({"lower": -1.0}, "quality"),
        ({"basis": b"123"}, "basis"),
        ({"kind": Kind(math.nan, "push")}, "limit"),
        ({"phase": Phase.WAITING}, "waits"),
        ({"gone": (("", 1),)}, "1 to 64 bytes"),
        ({"plan": Plan(b"", 1.0, ())}, "plan"),
        ({"plan": Plan(b"12345678", math.nan, ())}, "plan"),
    ],
)
def test_records_that_no_sound_robot_sends_are_refused(changes, fault):
    """What is out of range in a record is told, and the record does not come in."""
    assert record_fault(SOUND) == ""
    record = msgspec.structs.replace(SOUND, **changes)
    assert fault in record_fault(record)
    with pytest.raises(MessageInvalid, match="a message"):
        decode(encode(Put(record)))


def test_giants_are_refused_before_they_are_read():
    """A message of many megabytes is refused by its length."""
    with pytest.raises(MessageInvalid, match="at most"):
        decode(b"\x00" * (MOST_BYTES + 1))


@given(st.lists(records(st.sampled_from(["Ajax", "Boreas", "Castor"])), max_size=8), st.data())
def test_memories_agree_whatever_the_order(given_records, data):
    """The same records in any order, doubled, give the same map and the same digest."""
    shuffled = data.draw(st.permutations(given_records + given_records[:3]))
    one, two = Memory(given_records), Memory(shuffled)
    assert {r.id: r for r in one} == {r.id: r for r in two}
    assert one.digest == two.digest
    assert not one.newer_than(two.versions())
    assert not one.lacks(two.versions())


def test_two_stories_are_told_and_one_of_them_wins_everywhere():
    """Of two contents with one version the same is kept, whichever came first."""
    other = msgspec.structs.replace(SOUND, lower=5.0)
    kept = []
    for first, second in ((SOUND, other), (other, SOUND)):
        memory = Memory([first])
        assert memory.merge(second) is Merged.TWO_STORIES
        kept.append(memory.get("Ajax"))
    assert kept[0] == kept[1]


def test_a_record_is_as_small_as_was_promised():
    """A robot's word fits into a small packet: 100 bytes with a name of 7 letters."""
    record = Record(
        "Fortuna", (1 << 20) + 99, 12, Phase.ATTACHED, 5, 1, 0, None,
        Place(12.25, -36.5, 1.57), 1e6, b"12345678",
    )  # fmt: skip
    assert len(encode(Put(record))) <= 100
    assert len(encode(Beat("Fortuna", 12, b"12345678"))) <= 24
