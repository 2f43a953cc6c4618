"""Plain data as the lines of a YAML file, as people would lay them out."""

import json
import re
from collections.abc import Iterator
from typing import Any

_BARE = re.compile(r"[A-Za-z]([\w.()/+-]| (?=[\w.()/+-]))*", re.ASCII)
"""Text that needs no quotes."""
_WORDS = frozenset(("null", "true", "false", "yes", "no", "on", "off"))
"""Text that needs them all the same, for readers of other YAML versions."""
_UNSEEN = re.compile("[\x7f-\x9f\u2028\u2029\ufeff\ufffe\uffff]")


def lines(document: dict[str, Any]) -> Iterator[str]:
    """Yield the lines of a file: short mappings and the items of lists in a line each."""
    order = ("name", "description", "units", "heading", "words", "outline", "metric", "robots")
    for key in (*(k for k in order if k in document), *(k for k in document if k not in order)):
        value = document[key]
        if key in ("outline", "simulation"):
            yield f"{key}:"
            for part, told in value.items():
                yield from _entry(part, told, "  ")
        else:
            yield from _entry(key, value, "")


def _entry(key: str, value: Any, indent: str) -> Iterator[str]:
    """Yield the lines of one key: an item a line for lists of more than numbers."""
    if isinstance(value, list) and value and not isinstance(value[0], float):
        yield f"{indent}{key}:"
        yield from (f"{indent}  - {flow(item)}" for item in value)
    else:
        yield f"{indent}{key}: {flow(value)}"


def flow(value: Any) -> str:
    """Return a value on one line."""
    if isinstance(value, dict):
        return f"{{{', '.join(f'{key}: {flow(item)}' for key, item in value.items())}}}"
    if isinstance(value, list):
        return f"[{', '.join(map(flow, value))}]"
    if isinstance(value, str):
        return _text(value)
    return str(value).lower() if isinstance(value, bool) else repr(value).removesuffix(".0")


def _text(text: str) -> str:
    """Return text, in quotes where they are needed.

    Examples
    --------
    >>> [_text(each) for each in ("port pads", "edge 2", "tanker, loaded", "no", "")]
    ['port pads', 'edge 2', '"tanker, loaded"', '"no"', '""']
    """
    if _BARE.fullmatch(text) and text.lower() not in _WORDS:
        return text
    quoted = json.dumps(text, ensure_ascii=False)
    return _UNSEEN.sub(lambda found: f"\\u{ord(found[0]):04x}", quoted)
