"""What documents show, compared with what the program prints."""

import re

import pytest

NUMBER = re.compile(r"-?\d+\.?\d*(?:e-?\d+)?")


def assert_same(shown, printed):
    """Compare word for word, numbers to a thousandth."""
    shown, printed = shown.strip(), printed.strip()
    assert NUMBER.sub("#", shown) == NUMBER.sub("#", printed)
    numbers = (list(map(float, NUMBER.findall(text))) for text in (shown, printed))
    for left, right in zip(*numbers, strict=True):
        assert left == pytest.approx(right, rel=1e-3)
