"""The digest that tells an altered answer file from the one that was written."""

import hashlib
import json
from contextlib import suppress
from typing import Any


def digest_of(document: dict[str, Any]) -> str:
    """Return the digest of a document without its own "digest" entry.

    Numbers count by value: a tool that writes 2.0 as 2 alters nothing.

    Examples
    --------
    >>> digest_of({"a": 2.0, "digest": "none"}) == digest_of({"a": 2})
    True
    """
    content = _plain({key: value for key, value in document.items() if key != "digest"})
    text = json.dumps(content, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    return "sha256:" + hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()


def _plain(value: Any) -> Any:
    """Return data with every integer as a float."""
    if isinstance(value, dict):
        return {key: _plain(entry) for key, entry in value.items()}
    if isinstance(value, list):
        return [_plain(entry) for entry in value]
    if isinstance(value, int) and not isinstance(value, bool):
        with suppress(OverflowError):  # such a number is refused where it is read
            return float(value)
    return value
