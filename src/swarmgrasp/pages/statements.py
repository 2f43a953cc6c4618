"""What the report states: each a sentence with numbers measured, and whether it is so."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray


@dataclass(frozen=True)
class Statement:
    """A sentence of the report, and its check.

    Attributes
    ----------
    text : str
        Every number in it is measured in this run, or printed in the paper.
    holds : bool
        Whether what it says besides the numbers is so in this run.
    is_timing : bool
        Whether that hangs on how busy the machine is.
    rests_on : tuple of str
        Labels of what of the theory it is about, which stand on the same page.
    """

    text: str
    holds: bool
    is_timing: bool = False
    rests_on: tuple[str, ...] = ()


def percent(share: float) -> str:
    """Write a share in percent, never 0 % or 100 % for what is not, and nan as a dash.

    Examples
    --------
    >>> [percent(s) for s in (0.0, 0.0004, 0.004, 0.1234, 0.9999, 1.0)]
    ['0 %', 'under 0.1 %', '0.4 %', '12 %', 'over 99.9 %', '100 %']
    """
    value = 100.0 * share
    if math.isnan(value):
        return "-"
    if value in (0.0, 100.0) or 0.95 <= value < 99.5:
        return f"{value:.0f} %"
    if value < 0.05 or value >= 99.95:
        return "under 0.1 %" if value < 50.0 else "over 99.9 %"
    return f"{value:.1f} %"


def newtons(value: float, decimals: int = 2) -> str:
    """Write a force, never as -0.

    Examples
    --------
    >>> newtons(0.3949), newtons(-1e-9)
    ('0.39 N', '0.00 N')
    """
    return f"{round(value, decimals) + 0.0:.{decimals}f} N"


def seconds(value: float) -> str:
    """Write a time with three digits at most.

    Examples
    --------
    >>> [seconds(s) for s in (4.2e-5, 0.0123, 1.5)]
    ['42 µs', '12.3 ms', '1.5 s']
    """
    for factor, unit in ((1e6, "µs"), (1e3, "ms")):
        if value * factor < 999.5:
            return f"{value * factor:.3g} {unit}"
    return f"{value:.3g} s"


def spaced(count: int) -> str:
    """Write a whole number with its thousands apart.

    Examples
    --------
    >>> spaced(122500)
    '122 500'
    """
    return f"{count:,}".replace(",", " ")


def listed(parts: Sequence[object]) -> str:
    """Write some things in a row.

    Examples
    --------
    >>> listed((5, 15, 25)), listed(["12 %"])
    ('5, 15 and 25', '12 %')
    """
    *first, last = map(str, parts)
    return f"{', '.join(first)} and {last}" if first else last


def median(values: NDArray[np.float64]) -> float:
    """Return the median, nan of none."""
    return float(np.median(values)) if len(values) else float("nan")


def largest(values: NDArray[np.float64]) -> float:
    """Return the largest, nan of none."""
    return float(values.max()) if len(values) else float("nan")
