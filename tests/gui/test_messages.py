"""What page and server say to each other."""

from pathlib import Path

import msgspec
import pytest

from swarmgrasp.gui.messages import read_message
from swarmgrasp.gui.typescript import typescript


def test_the_page_has_the_types_of_the_server() -> None:
    """`client/src/messages.ts` is what the messages give: `make page` writes it anew."""
    written = Path(__file__).parents[2] / "src/swarmgrasp/gui/client/src/messages.ts"
    assert written.read_text(encoding="utf-8") == typescript()


@pytest.mark.parametrize(
    "raw",
    [
        b"",
        b"{",
        b"[]",
        b"null",
        b'{"kind":"ask"}',
        b'{"kind":"dance","n":1}',
        b'{"kind":"open","n":1,"name":"a","more":1}',
        b'{"kind":"open","n":-1,"name":"a"}',
        b'{"kind":"open","n":1.5,"name":"a"}',
        b'{"kind":"open","n":"1","name":"a"}',
        b'{"kind":"open","n":1,"name":7}',
        b'{"kind":"open","n":1,"name":"' + b"a" * 201 + b'"}',
        b'{"kind":"hello","key":"a","protocol":true}',
        b'{"kind":"cancel","n":1}{"kind":"cancel","n":2}',
        b'{"kind":"control","n":1,"robot":null,"what":"explode"}',
        b'\xff\xfe{"kind":"cancel","n":1}',
        b"[" * 100_000,
    ],
)
def test_a_malformed_message_is_refused(raw: bytes) -> None:
    """Wrong kinds, unknown keys, numbers outside their range, depth without end."""
    with pytest.raises((msgspec.DecodeError, RecursionError)):
        read_message(raw)
