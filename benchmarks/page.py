"""The page of results: tables, numbers with few digits, and what the machine was."""

import os
import platform
import textwrap
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from datetime import date
from importlib.metadata import version
from pathlib import Path

from matplotlib.figure import Figure

from swarmgrasp.files import write_whole
from swarmgrasp.plot import save

ROOT = Path(__file__).parent.parent
PAGE = ROOT / "docs" / "benchmarks.md"
IMAGES = ROOT / "docs" / "images"
PACKAGES = ("swarmgrasp", "numpy", "scipy", "pycapacity", "clarabel")
TITLE = """# Benchmarks

Written by `make bench`. Every comparison is a ratio of medians measured in one run: the two sides
take turns on the same inputs, each on one core, and their values are compared. The machine is
shared: the ratios say more than the times.
"""


@dataclass(frozen=True)
class Part:
    """A section of the page.

    Attributes
    ----------
    text : str
        Markdown.
    pictures : dict
        From a file's name to its title and figure; they stand below the text.
    """

    text: str
    pictures: dict[str, tuple[str, Figure]] = field(default_factory=dict)


def duration(seconds: float) -> str:
    """Write a time with three digits at most.

    Examples
    --------
    >>> [duration(s) for s in (4.2e-5, 0.0123, 1.5, 210.0)]
    ['42 us', '12.3 ms', '1.5 s', '210 s']
    """
    for factor, unit in ((1e6, "us"), (1e3, "ms")):
        if seconds * factor < 999.5:
            return f"{digits(seconds * factor)} {unit}"
    return f"{digits(seconds)} s"


def digits(value: float) -> str:
    """Write a number with three digits that matter, and without an exponent up to a million.

    Examples
    --------
    >>> [digits(v) for v in (0.123456, 4.0, 56.78, 12345.0)]
    ['0.123', '4', '56.8', '12 300']
    """
    if abs(value) < 999.5:
        return f"{value:.3g}"
    power = 10 ** (len(f"{abs(value):.0f}") - 3)
    return f"{round(value / power) * power:,}".replace(",", " ")


def difference(value: float) -> str:
    """Write how far two values are apart; below rounding, say so."""
    return f"{value:.0e}" if value > 1e-15 else "< 1e-15"


def power_of_ten(count: int) -> str:
    """Write a number of robots with its thousands apart."""
    return f"{count:,}".replace(",", " ")


def table(heads: Sequence[str], rows: Iterable[Sequence[str]]) -> str:
    """Return a Markdown table, its first column to the left and the others to the right."""
    marks = ["---"] + ["---:"] * (len(heads) - 1)
    lines = [" | ".join(cells) for cells in (heads, marks, *rows)]
    return "\n".join(f"| {line} |" for line in lines) + "\n"


def paragraph(text: str) -> str:
    """Break a paragraph into lines."""
    return textwrap.fill(text, 100, break_long_words=False) + "\n"


def machine() -> str:
    """Describe the processor, the date and the versions; nothing that names the host."""
    model, info = platform.machine(), Path("/proc/cpuinfo")
    if info.exists():
        named = [s for s in info.read_text().splitlines() if s.startswith("model name")]
        model = named[0].partition(":")[2].strip() if named else model
    versions = ", ".join(f"{name} {version(name)}" for name in PACKAGES)
    return "## Machine\n\n" + paragraph(
        f"{date.today()}; {model}, {os.cpu_count()} cores, {platform.system()}; "
        f"Python {platform.python_version()}, {versions}. Over the last quarter of an hour the "
        f"load was {os.getloadavg()[2]:.1f}: above the number of cores times by the clock are too "
        "long, and what is measured side by side still compares."
    )


def write(parts: Sequence[Part]) -> None:
    """Write the pictures and then the page, each whole or not at all."""
    texts = []
    for part in parts:
        texts.append(part.text)
        for name, (title, figure) in part.pictures.items():
            save(figure, IMAGES / name)
            texts.append(f"![{title}](images/{name})\n")
    write_whole(PAGE, "\n".join((TITLE, *texts, machine())).encode())
