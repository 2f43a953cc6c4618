"""Messages of protobuf, read by the descriptors that a file stores beside them: no code of others.

Of the language only what descriptors and Foxglove's messages need: no groups, maps or extensions.
"""

import struct
from typing import NamedTuple

DOUBLE, FLOAT, BOOL, TEXT, MESSAGE, BYTES, ENUM = 1, 2, 8, 9, 11, 12, 14
VARINT, EIGHT, LONG, FOUR = 0, 1, 2, 5
"""How a value is stored: as digits of 7 bits, in 8 bytes, with its length before it, in 4 bytes."""
FIXED = {DOUBLE: (EIGHT, "<d"), FLOAT: (FOUR, "<f"), 6: (EIGHT, "<Q"), 7: (FOUR, "<I")}
REPEATED = 3


class Field(NamedTuple):
    """What a descriptor says of a field."""

    name: str
    type: int
    is_repeated: bool
    of: str


def messages_of(schema):
    """Return the fields by number of all messages in a set of file descriptors, by full name."""
    found = {}
    for number, _, file in parts(schema):
        assert number == 1
        package = b"".join(v for n, _, v in parts(file) if n == 2).decode()
        for message in (v for n, _, v in parts(file) if n == 4):
            found |= described(message, f".{package}")
    return found


def described(message, scope):
    """Return the fields of a message and of those within it."""
    rows = list(parts(message))
    name = f"{scope}.{next(v for n, _, v in rows if n == 1).decode()}"
    found, fields = {}, {}
    for number, _, value in rows:
        if number == 2:
            told = {n: v for n, _, v in parts(value)}
            of, label = told.get(6, b"").decode(), told[4]
            fields[told[3]] = Field(told[1].decode(), told[5], label == REPEATED, of)
        elif number == 3:
            found |= described(value, name)
    return {**found, name: fields}


def decoded(data, name, messages):
    """Return a message as a dict; whatever its descriptor does not say is an error."""
    found = {}
    for number, stored, raw in parts(data):
        field = messages[name][number]
        values = list(values_of(field, stored, raw, messages))
        if field.is_repeated:
            found.setdefault(field.name, []).extend(values)
        else:
            assert field.name not in found
            (found[field.name],) = values
    return found


def values_of(field, stored, raw, messages):
    """Yield what is stored of a field: several values if numbers are packed."""
    if field.type in FIXED:
        how, form = FIXED[field.type]
        assert stored == how or (stored == LONG and field.is_repeated)
        yield from (value for (value,) in struct.iter_unpack(form, raw))
    elif field.type == MESSAGE:
        assert stored == LONG
        yield decoded(raw, field.of, messages)
    elif field.type in (TEXT, BYTES):
        assert stored == LONG
        yield raw.decode() if field.type == TEXT else raw
    else:
        assert stored == VARINT, "packed whole numbers are not read here"
        yield bool(raw) if field.type == BOOL else raw


def parts(data):
    """Yield number, way of storing and raw value of all that is stored."""
    at = 0
    while at < len(data):
        key, at = varint(data, at)
        number, stored = key >> 3, key & 7
        if stored == VARINT:
            value, at = varint(data, at)
            yield number, stored, value
            continue
        size = {EIGHT: 8, FOUR: 4}.get(stored)
        if size is None:
            assert stored == LONG
            size, at = varint(data, at)
        assert at + size <= len(data)
        yield number, stored, data[at : at + size]
        at += size


def varint(data, at):
    """Return a whole number and where it ends."""
    value, shift = 0, 0
    while True:
        byte = data[at]
        value |= (byte & 127) << shift
        at, shift = at + 1, shift + 7
        if byte < 128:
            return value, at
