"""The pages show what the program prints today."""

import contextlib
import io
import re
from pathlib import Path

import pytest

from shown import assert_same

PAGES = sorted((Path(__file__).parent.parent / "docs").glob("*.md"))
SHOWN = re.compile(r"```python\n(.*?)```\n\nprints\n\n```text\n(.*?)```", re.DOTALL)


@pytest.mark.parametrize(
    "page", [p for p in PAGES if SHOWN.search(p.read_text("utf-8"))], ids=lambda page: page.stem
)
def test_the_code_of_a_page_prints_what_it_shows(page):
    """The blocks run one after the other, each with what those before it left."""
    names = {}
    for code, shown in SHOWN.findall(page.read_text("utf-8")):
        printed = io.StringIO()
        with contextlib.redirect_stdout(printed):
            exec(code, names)
        assert_same(shown, printed.getvalue())
