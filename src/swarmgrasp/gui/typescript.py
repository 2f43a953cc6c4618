"""The types of the page: `client/src/messages.ts`, made of the messages and of the plain forms.

``python -m swarmgrasp.gui.typescript`` prints the file.
"""

import types
from collections.abc import Iterable
from enum import StrEnum
from typing import Annotated, Any, Literal, Union, get_args, get_origin, get_type_hints

import msgspec

from swarmgrasp.environment import Environment
from swarmgrasp.gui import messages
from swarmgrasp.gui.replies import ToPage
from swarmgrasp.gui.told_parts import PartSaid
from swarmgrasp.placement import Problem
from swarmgrasp.plain import Plain, parts_of
from swarmgrasp.swarm import Robot
from swarmgrasp.swarm.robot import Attachment

HEAD = """/* What page and server say to each other. Lengths in m, forces in N, angles in rad.

Made of the server's messages and the library's plain forms by `make page`: do not edit. */

export type Pair = [number, number];
export type Triple = [number, number, number];
"""
FORMS: dict[str, type[Plain]] = {
    "problem": Problem,
    "environment": Environment,
    "newcomer": Robot,
    "robots": Robot,
}
"""Classes whose plain forms stand in fields of messages."""
SHAPES = {
    ("Criterion", "load"): "Triple",
    ("Ellipsoid", "axes"): "Triple[]",
    ("Outline", "origin"): "Pair",
    ("Outline", "vertices"): "Pair[]",
    ("Polytope", "vertices"): "Triple[]",
    ("Tolerance", "contact"): "Pair",
    ("Tolerance", "direction"): "Pair",
    ("WindTable", "bearings"): "number[]",
    ("WindTable", "loads"): "Triple[][]",
    ("WindTable", "speeds"): "number[]",
}
"""What fields of plain forms hold whose kinds say less: arrays, and pairs that may be given so."""
ARRAYS: dict[str, dict[str, str]] = {
    "MeshPart": {"corners": "i2", "faces": "u2", "starts": "u2", "normals": "i1"},
    "CapabilityPart": {
        "bearings": "f4",
        "intact": "f4",
        "lost": "f4",
        "before_intact?": "f4",
        "before_lost?": "f4",
    },
    "LandscapePart": {"values": "u2", "strip": "u2"},
    "RunTold": {
        "times": "f4",
        "poses": "f4",
        "references": "f4",
        "wind": "f4",
        "water": "f4",
        "shortfalls": "f4",
        "forces": "f4",
        "angles": "f4",
    },
}
"""The arrays that follow parts, and their types; those with "?" may be missing."""
CALLED = {
    "Error": "ErrorTold",
    "ForcesTold": "Forces",
    "LiveTold": "Live",
    "Measure": "UnitData",
    "ReportTold": "Report",
    "SequenceTold": "Sequence",
    "RunTold": "Run",
    "Speech": "SpeechData",
}
"""What messages are called in the page, where it is another name."""
LISTED: dict[Any, str] = {Attachment: "Attachment", messages.PartName: "PartName"}
"""Lists of words that have a name of their own."""
VIEWS = {
    "f4": "Float32Array",
    "f8": "Float64Array",
    "i1": "Int8Array",
    "i2": "Int16Array",
    "u2": "Uint16Array",
    "u4": "Uint32Array",
}
"""What arrays of a binary frame are in the page."""
SIMPLE = {int: "number", float: "number", str: "string", bool: "boolean", type(None): "null"}


class _Writer:
    """Writes interfaces, each once, what stands in one before it."""

    def __init__(self) -> None:
        self.told: dict[str, str] = {}

    # -- interfaces ------------------------------------------------------------------------

    def struct(self, kind: type[msgspec.Struct]) -> str:
        """Write a message, and what stands in it; return its name."""
        name = CALLED.get(kind.__name__, kind.__name__)
        if name not in self.told:
            self._keep(name, kind, self.fields(kind))
        return name

    def plain(self, kind: Any) -> str:
        """Write a plain form, and what stands in it; return its name."""
        name = f"{kind.__name__}Data"
        if name not in self.told:
            told = {
                field: SHAPES.get((kind.__name__, field)) or self.type(one, field)
                for field, one in parts_of(kind).items()
            }
            self._keep(name, kind, [f"{field}: {written};" for field, written in told.items()])
        return name

    def _keep(self, name: str, kind: Any, rows: Iterable[str]) -> None:
        """Keep an interface, with the first line of what its class says."""
        said = (kind.__doc__ or "").split("\n", 1)[0]
        body = "\n".join(f"  {row}" for row in rows)
        self.told[name] = f"/** {said} */\nexport interface {name} {{\n{body}\n}}\n"

    def fields(self, kind: type[msgspec.Struct]) -> list[str]:
        """Return the fields of a message."""
        config = kind.__struct_config__
        rows = [f'{config.tag_field}: "{config.tag}";'] if config.tag_field else []
        hints = get_type_hints(kind, include_extras=True)
        for field in msgspec.structs.fields(kind):
            name, one = field.name, hints[field.name]
            if name == "arrays":
                rows += self._arrays(kind)
                continue
            is_open = not field.required and get_origin(one) is not Literal
            rows.append(f"{name}{'?' * is_open}: {self.type(one, name)};")
        return rows

    def _arrays(self, kind: type) -> list[str]:
        """Return the arrays of a binary frame, as the page has them."""
        listed = ARRAYS[kind.__name__].items()
        return [
            f"{name.strip('?')}{'?' * (name[-1] == '?')}: {VIEWS[one]};" for name, one in listed
        ]

    # -- types -----------------------------------------------------------------------------

    def type(self, kind: Any, field: str) -> str:
        """Return a type; of a field that holds a plain form, that."""
        origin, given = get_origin(kind), get_args(kind)
        if origin is Annotated:
            return self.type(given[0], field)
        if origin in (types.UnionType, Union):
            return " | ".join(dict.fromkeys(self.type(one, field) for one in given))
        if origin is Literal:
            return LISTED.get(kind) or " | ".join(f'"{value}"' for value in given)
        if origin is dict:
            return self.plain(FORMS[field])
        if origin is tuple and given[-1] is not ...:
            return _named([self.type(one, field) for one in given])
        if origin is not None:  # a list, however it is given
            return f"{_bracketed(self.type(given[0], field))}[]"
        return self._class(kind)

    def _class(self, kind: Any) -> str:
        """Return the type of a class."""
        if kind in SIMPLE:
            return SIMPLE[kind]
        if issubclass(kind, msgspec.Struct):
            return self.struct(kind)
        if issubclass(kind, StrEnum):
            return " | ".join(f'"{member.value}"' for member in kind)
        return self.plain(kind)


def typescript() -> str:
    """Return the whole file."""
    writer = _Writer()
    outgoing = [
        "{ " + " ".join(writer.fields(one)).rstrip(";") + " }"
        for one in get_args(messages.FromPage)
    ]
    parts = [writer.struct(one) for one in get_args(PartSaid)]
    others = [writer.struct(one) for one in get_args(ToPage)]
    return "\n".join([
        HEAD,
        f"export const PROTOCOL = {messages.PROTOCOL};\n",
        *writer.told.values(),
        *(
            _union(name, [f'"{word}"' for word in get_args(kind)])
            for kind, name in LISTED.items()
        ),
        _union("AnyPart", parts),
        _union("Outgoing", outgoing),
        _union("Incoming", ["AnyPart", *others]),
    ])  # fmt: skip


def _union(name: str, members: Iterable[str]) -> str:
    """Return the union of types."""
    return f"export type {name} =" + "".join(f"\n  | {member}" for member in members) + ";\n"


def _named(items: list[str]) -> str:
    """Return a tuple, those of numbers by their names."""
    short = {("number",) * 2: "Pair", ("number",) * 3: "Triple"}
    return short.get(tuple(items), f"[{', '.join(items)}]")


def _bracketed(written: str) -> str:
    """Return a type that may stand before brackets."""
    return f"({written})" if " | " in written else written


if __name__ == "__main__":
    import sys

    sys.stdout.write(typescript())
