"""Change parts of YAML text and leave every other character as it is.

A text is taken apart into parts that know where they begin and end. What is changed, added and
removed is noted, and put into the text at the end: comments, order and spelling of all else stay.
"""

from collections.abc import Iterator
from dataclasses import dataclass, field

from ruamel.yaml import YAML
from ruamel.yaml.events import (
    AliasEvent,
    CollectionEndEvent,
    MappingStartEvent,
    NodeEvent,
    ScalarEvent,
    SequenceStartEvent,
)

from swarmgrasp.scenario.document import Scalar, resolve


@dataclass(slots=True, eq=False)
class Part:
    """A value in a text.

    Attributes
    ----------
    start, end : int
        Of its characters; what is in block style ends with the line of its last value.
    value : scalar
        What a scalar is; None for all else.
    is_flow : bool
        Whether it is a mapping in braces or a list in brackets.
    keys : dict of str to int
        Of a mapping, the place of each key's value in `items`.
    starts : list of int
        Where the keys of a mapping begin, or the items of a list.
    items : list of Part
    is_list, is_mapping : bool
    """

    start: int
    end: int
    value: Scalar = None
    is_flow: bool = False
    is_list: bool = False
    is_mapping: bool = False
    keys: dict[str, int] = field(default_factory=dict)
    starts: list[int] = field(default_factory=list)
    items: "list[Part]" = field(default_factory=list)

    def get(self, key: str) -> "Part | None":
        """Return what stands under a key; None if nothing does."""
        return self.items[self.keys[key]] if key in self.keys else None

    def plain(self) -> object:
        """Return plain data; None for what is said elsewhere."""
        if self.is_mapping:
            return {key: self.items[k].plain() for key, k in self.keys.items()}
        return [item.plain() for item in self.items] if self.is_list else self.value


def parts_of(text: str) -> Part:
    """Take a text apart that is known to be a scenario."""
    events = (e for e in YAML(typ="safe", pure=True).parse(text) if _is_of_value(e))
    return _part(text, next(events), events)


def _is_of_value(event: object) -> bool:
    """Tell whether an event begins or ends a value."""
    return isinstance(event, NodeEvent | CollectionEndEvent)


def _part(text: str, event: object, events: Iterator[object]) -> Part:
    """Return the part that an event begins, and use up the events within it."""
    start, end = event.start_mark.index, event.end_mark.index  # type: ignore[attr-defined]
    if isinstance(event, AliasEvent):
        return Part(start, end)
    if isinstance(event, ScalarEvent):
        return Part(start, end, resolve(event.value) if event.style is None else event.value)
    part = Part(start, end, is_flow=bool(event.flow_style))  # type: ignore[attr-defined]
    part.is_list = isinstance(event, SequenceStartEvent)
    part.is_mapping = isinstance(event, MappingStartEvent)
    for inner in events:
        if isinstance(inner, CollectionEndEvent):
            part.end = inner.end_mark.index if part.is_flow else part.end
            break
        if part.is_mapping:
            part.keys[str(inner.value)] = len(part.items)  # type: ignore[attr-defined]
        part.starts.append(inner.start_mark.index)  # type: ignore[attr-defined]
        part.items.append(_part(text, next(events) if part.is_mapping else inner, events))
    if part.items and not part.is_flow:
        last = part.items[-1].end
        line_end = text.find("\n", last)
        part.end = last if text[last - 1] == "\n" else len(text) if line_end < 0 else line_end
    return part


class Splice:
    """A text, and what is to become of its parts.

    Parameters
    ----------
    text : str
    """

    def __init__(self, text: str) -> None:
        self.text = text
        self.root = parts_of(text)
        self._put: dict[Part, str] = {}
        self._gone: dict[Part, set[int]] = {}
        self._more: dict[Part, list[tuple[int, str]]] = {}

    def put(self, part: Part, text: str) -> None:
        """Put a text in the place of a part."""
        self._put[part] = text

    def remove(self, holder: Part, index: int) -> None:
        """Remove an item of a list, or a key with its value, by its place."""
        self._gone.setdefault(holder, set()).add(index)

    def insert(self, holder: Part, index: int, text: str) -> None:
        """Put an item, or "key: value", before the one at a place; after all at the last one."""
        self._more.setdefault(holder, []).append((index, text))

    def result(self) -> str:
        """Return the text with all that is changed."""
        return self.text[: self.root.start] + self._of(self.root) + self.text[self.root.end :]

    def _of(self, part: Part) -> str:
        """Return the text of a part with all that is changed."""
        if part in self._put:
            return self._put[part]
        gone, more = self._gone.get(part, set()), self._more.get(part, [])
        if not part.items or len(gone) == len(part.items):
            return self._anew(part, [text for _, text in more]) if gone or more else self._own(part)
        if not gone and not more:
            return self._joined(part)
        return self._flow(part, gone, more) if part.is_flow else self._block(part, gone, more)

    def _own(self, part: Part) -> str:
        """Return the text of a part as it was."""
        return self.text[part.start : part.end]

    def _entry(self, part: Part, k: int) -> str:
        """Return an item, or a key with its value."""
        item = part.items[k]
        return self.text[part.starts[k] : item.start] + self._of(item)

    def _joined(self, part: Part) -> str:
        """Return a part of whose own items none is added or removed."""
        said, at = "", part.start
        for item in part.items:
            said += self.text[at : item.start] + self._of(item)
            at = item.end
        return said + self.text[at : part.end]

    def _anew(self, part: Part, texts: list[str]) -> str:
        """Return a list or a mapping of which nothing is left, of other items."""
        first, last = "[]" if part.is_list else "{}"
        return f"{first}{', '.join(texts)}{last}"

    def _flow(self, part: Part, gone: set[int], more: list[tuple[int, str]]) -> str:
        """Return a part in brackets: what stood between two items stays after the first."""
        between = [
            self.text[item.end : start]
            for item, start in zip(part.items, part.starts[1:], strict=False)
        ]
        entries: list[tuple[str, str]] = []
        for k in range(len(part.items) + 1):
            entries += [(text, ", ") for index, text in more if index == k]
            if k < len(part.items) and k not in gone:
                after = between[k] if k < len(between) else ", "
                entries.append((self._entry(part, k), after))
        said = "".join(entry + after for entry, after in entries[:-1]) + entries[-1][0]
        head = self.text[part.start : part.starts[0]]
        return head + said + self.text[part.items[-1].end : part.end]

    def _block(self, part: Part, gone: set[int], more: list[tuple[int, str]]) -> str:
        """Return a part of a line or more an item: of those gone, the lines go."""
        mark = "- " if part.is_list else ""
        column = part.starts[0] - 1 - self.text.rfind("\n", 0, part.starts[0])
        indent, said = " " * (column - len(mark)) + mark, ""
        for k in range(len(part.items) + 1):
            for text in (text for index, text in more if index == k):
                said += (f"\n{indent}" if said else mark) + text
            if k == len(part.items):
                break
            end = part.items[k].end
            entry, after = self._entry(part, k), self.text[end : [*part.starts, part.end][k + 1]]
            if self.text[end - 1] == "\n":  # of a text in lines of its own
                entry, after = entry.removesuffix("\n"), f"\n{after}"
            line, _, below = after.partition("\n")
            kept = "\n" + below[: below.rfind("\n")] if "\n" in below else ""
            if k in gone:
                said += kept if said else kept.lstrip()
            else:
                said += (f"\n{indent}" if said else mark) + entry + line + kept
        return said + "\n" * (self.text[part.end - 1] == "\n")
