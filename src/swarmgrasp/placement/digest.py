"""The digest that tells an altered answer file from the one that was written."""

import hashlib
import json
from typing import Any


def digest_of(document: dict[str, Any]) -> str:
    """Return the digest of a document without its own "digest" entry."""
    content = {key: value for key, value in document.items() if key != "digest"}
    text = json.dumps(content, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    return "sha256:" + hashlib.sha256(text.encode("utf-8", "surrogatepass")).hexdigest()
