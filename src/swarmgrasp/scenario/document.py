"""YAML 1.2 text as plain data that knows its lines and columns.

ruamel.yaml scans and parses; the tree is built here from its events, without recursion
and with every limit checked on the way, so that no text can exhaust memory or the
stack. Plain words are read by YAML 1.2's core schema: `no` is text, `1e-3` a number.
ruamel's own resolver is looser (dates, `0b11`, `1_000`, merge keys) and is not used.
"""

import re
from collections.abc import Iterator
from dataclasses import dataclass, field

from ruamel.yaml import YAML
from ruamel.yaml.error import MarkedYAMLError
from ruamel.yaml.events import (
    AliasEvent,
    CollectionEndEvent,
    CollectionStartEvent,
    DocumentStartEvent,
    Event,
    MappingStartEvent,
    NodeEvent,
    ScalarEvent,
)
from ruamel.yaml.reader import ReaderError

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.files import MOST_DEPTH
from swarmgrasp.scenario.faults import Faults, Mark, Path
from swarmgrasp.scenario.hints import yaml_hint

MOST_NODES = 100_000
"""Largest number of values in a file, every alias counted as what it stands for."""

Scalar = str | int | float | bool | None

_INT = re.compile(r"[-+]?[0-9]+|0o[0-7]+|0x[0-9a-fA-F]+")
_FLOAT = re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?")
_WORDS: dict[str, Scalar] = {
    **dict.fromkeys(("", "~", "null", "Null", "NULL")),
    **dict.fromkeys(("true", "True", "TRUE"), True),
    **dict.fromkeys(("false", "False", "FALSE"), False),
    **dict.fromkeys((".nan", ".NaN", ".NAN"), float("nan")),
    **{sign + w: float("inf") for sign in ("", "+") for w in (".inf", ".Inf", ".INF")},
    **{"-" + w: -float("inf") for w in (".inf", ".Inf", ".INF")},
}


@dataclass(slots=True, eq=False)
class Node:
    """A value and where it stands.

    Attributes
    ----------
    mark : tuple of int
        Line and column, from 1.
    value : scalar, list of Node, or dict of str to Node
    raw : str
        A scalar as it is written.
    key_marks : dict
        Line and column of each key of a mapping.
    size, height : int
        Number of values and levels, aliases expanded.
    """

    mark: Mark
    value: "Scalar | list[Node] | dict[str, Node]"
    raw: str = ""
    key_marks: dict[str, Mark] = field(default_factory=dict)
    size: int = 1
    height: int = 1

    def plain(self) -> object:
        """Return plain Python data, a fresh copy for every alias."""
        if isinstance(self.value, dict):
            return {key: child.plain() for key, child in self.value.items()}
        if isinstance(self.value, list):
            return [child.plain() for child in self.value]
        return self.value

    def shown(self, depth: int = 1) -> str:
        """Return the value as a message shows it, shortened."""
        if isinstance(self.value, dict):
            pairs = list(self.value.items())[:4]
            inside = ", ".join(f"{k[:40]}: {c.shown(depth - 1)}" for k, c in pairs)
            inside = inside if depth else "..."
            return f"{{{inside}{', ...' if depth and len(self.value) > 4 else ''}}}"
        if isinstance(self.value, list):
            inside = ", ".join(c.shown(depth - 1) for c in self.value[:4]) if depth else "..."
            return f"[{inside}{', ...' if depth and len(self.value) > 4 else ''}]"
        if self.value is None:
            return "nothing"
        text = self.value if isinstance(self.value, str) else self.raw
        text = text if len(text) <= 40 else f"{text[:37]}..."
        return repr(text) if isinstance(self.value, str) else text

    def find(self, path: Path) -> "Node":
        """Return the node a path leads to, or the last one met on the way."""
        node = self
        for part in path:
            if isinstance(node.value, dict) and part in node.value:
                node = node.value[str(part)]
            elif isinstance(node.value, list) and part in range(len(node.value)):
                node = node.value[int(part)]
            else:
                break
        return node

    def key_mark(self, path: Path) -> Mark:
        """Return where the last key of a path stands."""
        return self.find(path[:-1]).key_marks.get(str(path[-1]), self.find(path).mark)


def resolve(word: str) -> Scalar:
    """Read a plain word by the core schema of YAML 1.2.

    Examples
    --------
    >>> [resolve(word) for word in ("no", "1e-3", "0o17", "017", "1_000", "~", "2001-01-01")]
    ['no', 0.001, 15, 17, '1_000', None, '2001-01-01']
    """
    if word in _WORDS:
        return _WORDS[word]
    if _INT.fullmatch(word) and len(word) <= 18:  # longer ones are read as floats
        return int(word, 0) if word[:2] in ("0o", "0x") else int(word)
    if _FLOAT.fullmatch(word):
        return float(word)
    return word


def read_document(text: str, faults: Faults) -> Node:
    """Read YAML text.

    Parameters
    ----------
    text : str
    faults : Faults
        Receives what does not stop the reading: duplicate keys, tags, keys not text.

    Returns
    -------
    Node
        The root: always a mapping.

    Raises
    ------
    ScenarioInvalid
        If the text is not YAML, is empty, is no mapping, nests too deep, or is too large
        once its aliases are expanded.
    """
    builder = _Builder(faults)
    _check_version(text, builder)
    for event in _events(text, builder):
        builder.take(event)
    if builder.root is None:
        raise builder.fatal((1, 1), "the file is empty; it should hold a scenario")
    if not isinstance(builder.root.value, dict):
        said = f"should be a mapping of keys to values (got {builder.root.shown()})"
        raise builder.fatal(builder.root.mark, said)
    return builder.root


def _check_version(text: str, builder: "_Builder") -> None:
    """Refuse a document that says it is YAML of another version than 1.2."""
    for number, line in enumerate(text.splitlines(), start=1):
        if line.startswith("%YAML") and line.split("#")[0].split()[1:] != ["1.2"]:
            said = f"a scenario is YAML 1.2; leave out the line {line.strip()[:40]!r}"
            raise builder.fatal((number, 1), said)
        if line.strip() and line[0] not in "%#\ufeff":
            return


def _events(text: str, builder: "_Builder") -> Iterator[Event]:
    """Yield the parsing events of a text; whatever the parser raises is a fault of the text."""
    try:
        yield from YAML(typ="safe", pure=True).parse(text)
    except ReaderError as error:
        before = text[: error.position]
        mark = before.count("\n") + 1, error.position - before.rfind("\n")
        raise builder.fatal(mark, f"not valid YAML: {error.reason}") from None
    except MarkedYAMLError as error:
        at = error.problem_mark or error.context_mark
        mark = (at.line + 1, at.column + 1) if at else (1, 1)
        said = yaml_hint(" ".join(f"{error.context or ''} {error.problem or ''}".split()))
        raise builder.fatal(mark, f"not valid YAML: {said}") from None
    except Exception as error:  # ruamel.yaml asserts, and stumbles over "\UFFFFFFFF"
        said = " ".join(str(error).split())[:100] or type(error).__name__
        raise builder.fatal(builder.last, f"not valid YAML: {said}") from None


@dataclass(slots=True, eq=False)
class _Open:
    """A collection whose end has not been met: `key` waits for its value."""

    node: Node
    anchor: str | None
    key: Node | None = None


class _Builder:
    """Turn parsing events into one tree of nodes."""

    def __init__(self, faults: Faults) -> None:
        self.root: Node | None = None
        self.last: Mark = (1, 1)
        self._faults = faults
        self._open: list[_Open] = []
        self._anchors: dict[str, Node | None] = {}
        self._documents = 0
        self._count = 0

    def fatal(self, mark: Mark, sentence: str) -> ScenarioInvalid:
        """Note a fault that stops the reading; return the error to raise."""
        self._faults.add(mark, (), sentence)
        return self._faults.error()

    def take(self, event: object) -> None:
        """Take the next event."""
        if isinstance(event, DocumentStartEvent):
            self._documents += 1
            if self._documents > 1:
                at = (event.start_mark.line + 1, event.start_mark.column + 1)
                raise self.fatal(at, "a second document starts; a file holds one scenario")
        elif isinstance(event, CollectionEndEvent):
            closed = self._open.pop()
            self._attach(closed.node, closed.anchor)
        elif isinstance(event, NodeEvent):
            self.last = (event.start_mark.line + 1, event.start_mark.column + 1)
            self._start(event)

    def _start(self, event: NodeEvent) -> None:
        """Start a value: a scalar, an alias or a collection."""
        self._count += 1
        if isinstance(event, AliasEvent):
            self._attach(self._aliased(event.anchor), None)
        elif isinstance(event, ScalarEvent):
            self._refuse_tag(event.tag)
            value = resolve(event.value) if event.style is None else event.value
            self._attach(Node(self.last, value, event.value), event.anchor)
        elif isinstance(event, CollectionStartEvent):
            self._refuse_tag(event.tag)
            if event.anchor is not None:
                self._anchors[event.anchor] = None  # not to be used before it ends
            node = Node(self.last, {} if isinstance(event, MappingStartEvent) else [])
            self._open.append(_Open(node, event.anchor))
            self._check_limits(node)

    def _refuse_tag(self, tag: object) -> None:
        """Note a fault for a value with a tag; it is read as if it had none."""
        if tag is not None:
            shown = str(tag).replace("tag:yaml.org,2002:", "!!")[:60]
            said = f"the tag {shown!r} is not allowed; write plain values"
            self._faults.add(self.last, self._path(), said)

    def _aliased(self, anchor: str) -> Node:
        """Return what an alias stands for."""
        if anchor not in self._anchors:
            raise self.fatal(self.last, f"the alias *{anchor[:60]} stands for nothing")
        node = self._anchors[anchor]
        if node is None:
            raise self.fatal(self.last, f"the alias *{anchor[:60]} contains itself")
        return node

    def _attach(self, node: Node, anchor: str | None) -> None:
        """Put a finished value where it belongs."""
        if anchor is not None:
            self._anchors[anchor] = node
        self._check_limits(node)
        if not self._open:
            self.root = node
            return
        parent = self._open[-1]
        parent.node.size += node.size
        parent.node.height = max(parent.node.height, node.height + 1)
        if isinstance(parent.node.value, list):
            parent.node.value.append(node)
        elif parent.key is None:
            parent.key = node
        else:
            self._put(parent.node, parent.key, node)
            parent.key = None
        self._check_limits(parent.node)

    def _put(self, mapping: Node, key: Node, node: Node) -> None:
        """Add a key and its value to a mapping."""
        name, children = key.value, mapping.value
        if not isinstance(name, str) or not isinstance(children, dict):
            said = f"a key should be text (got {key.shown()})"
            if isinstance(name, int) and node.value is None:  # as of {limit: 60,5}
                said += "; decimals go after a point"
            self._faults.add(key.mark, self._path()[:-1], said)
        elif name in children:
            said = f"duplicate key; it is already given on line {mapping.key_marks[name][0]}"
            self._faults.add(key.mark, self._path(), said)
        else:
            children[name], mapping.key_marks[name] = node, key.mark

    def _check_limits(self, node: Node) -> None:
        """Refuse what is too deep or too large."""
        if len(self._open) + node.height - 1 > MOST_DEPTH:
            raise self.fatal(self.last, f"nested too deep; at most {MOST_DEPTH} levels are read")
        if max(node.size, self._count) > MOST_NODES:
            said = f"too many values, aliases expanded; at most {MOST_NODES} are read"
            raise self.fatal(self.last, said)

    def _path(self) -> Path:
        """Return the path to the value being read."""
        return tuple(
            len(frame.node.value)
            if isinstance(frame.node.value, list)
            else (frame.key.raw[:60] if frame.key else "?")
            for frame in self._open
        )
