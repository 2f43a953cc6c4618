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


def assert_within(shown, printed):
    """Compare so what is shown of an output; a line "..." stands for lines left out."""
    lines, at, may_skip = printed.strip().split("\n"), 0, False
    for line in shown.strip().split("\n"):
        if line == "...":
            may_skip = True
            continue
        wanted = NUMBER.sub("#", line)
        while may_skip and at < len(lines) and NUMBER.sub("#", lines[at]) != wanted:
            at += 1
        assert at < len(lines), f"not printed: {line}"
        assert_same(line, lines[at])
        at, may_skip = at + 1, False
    assert may_skip or at == len(lines)
