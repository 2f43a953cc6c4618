"""The page on summaries shows what the program prints today."""

import contextlib
import io
import re
from pathlib import Path

from swarmgrasp.summary.encoding import CHECKSUM, HEADER
from swarmgrasp.summary.records import RECORD

PAGE = (Path(__file__).parents[2] / "docs" / "summary.md").read_text(encoding="utf-8")


def test_the_example_prints_what_the_page_shows():
    """The code block runs as it stands."""
    (code,) = re.findall(r"```python\n(.*?)```", PAGE, re.DOTALL)
    (shown,) = re.findall(r"```text\n(.*?)```", PAGE, re.DOTALL)
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(code, {})
    assert printed.getvalue() == shown


def test_the_layout_is_as_told():
    """Every offset of the two tables."""
    offsets = [int(n) for n in re.findall(r"^\| (\d+) \|", PAGE, re.MULTILINE)]
    fields = [HEADER.fields[name][1] for name in HEADER.names]
    records = [RECORD.fields[name][1] for name in RECORD.names]
    assert offsets == [*fields, HEADER.itemsize, *records]
    assert f"{HEADER.itemsize + CHECKSUM} bytes and {RECORD.itemsize} for each" in PAGE
