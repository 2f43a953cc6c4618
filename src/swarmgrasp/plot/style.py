"""Colours, sizes and units that all pictures share."""

import math
import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any, Final

import matplotlib as mpl

from swarmgrasp.quality import Criterion
from swarmgrasp.quality.criterion import NOMINAL
from swarmgrasp.terms import SI, Terms
from swarmgrasp.words import Unit

BLUE: Final = "#0072B2"
SKY: Final = "#56B4E9"
GREEN: Final = "#009E73"
ORANGE: Final = "#E69F00"
VERMILION: Final = "#D55E00"
PURPLE: Final = "#CC79A7"
WINE: Final = "#8C3A66"
INK: Final = "#222222"
GREY: Final = "#6E6E6E"
PALE: Final = "#ECEEF0"
"""The palette of Okabe and Ito, told apart by every kind of colour vision, a purple
dark enough for text, and greys."""

RIM: Final[Any] = {"edgecolor": INK, "linewidth": 0.7}
"""Round the arrows that stand out by their colour: they do in grey too."""

DASHES: Final[tuple[Any, ...]] = ("-", (0, (4, 1)), (0, (1, 1)))
"""Of lines that are told apart in grey too."""

WIDTH: Final = 5.2
"""Width of a figure [in] unless told otherwise: 9 pt text is still 6 pt in a 3.5 in column."""

WIDTHS: Final = (3.0, 12.0)
"""Least and greatest width that may be asked for [in]."""

SMALLEST: Final = 0.8
"""Size of the text in narrow figures over that in others: 7 pt become 5.6 pt, not less."""

RC: Final[Any] = {  # matplotlib types the keys one by one
    "font.family": "sans-serif",
    "font.sans-serif": ["DejaVu Sans"],
    "font.size": 9.0,
    "axes.labelsize": 9.0,
    "axes.titlesize": 9.0,
    "axes.linewidth": 0.7,
    "axes.edgecolor": GREY,
    "axes.labelcolor": INK,
    "axes.unicode_minus": True,
    "text.color": INK,
    "text.parse_math": False,  # a name may hold a "$"
    "xtick.labelsize": 8.0,
    "ytick.labelsize": 8.0,
    "xtick.color": GREY,
    "ytick.color": GREY,
    "xtick.labelcolor": INK,
    "ytick.labelcolor": INK,
    "legend.fontsize": 8.0,
    "legend.frameon": False,
    "grid.color": "#DADADA",
    "grid.linewidth": 0.5,
    "hatch.linewidth": 0.5,
    "figure.dpi": 100.0,
    "figure.facecolor": "white",
    "savefig.facecolor": "white",
    "pdf.fonttype": 42,
    "svg.fonttype": "path",
}
"""The settings each picture is drawn under; the caller's own are left as they are."""


@contextmanager
def settings(width: float = WIDTH) -> Iterator[None]:
    """Draw figures of a width [in] under the settings of all pictures, and quietly."""
    share = _text_share(width)
    sizes = {key: share * value for key, value in RC.items() if key.endswith("size")}
    with mpl.rc_context(RC | sizes | {"figure.figsize": (width, width)}), quietly():
        yield


def width() -> float:
    """Return the width [in] of the figures that are drawn under the present settings."""
    return float(mpl.rcParams["figure.figsize"][0])


def text(size: float) -> float:
    """Return a size of text or of a gap [pt] as it is in figures of the present width."""
    return size * _text_share(width())


def _text_share(width: float) -> float:
    """Return the size of text in figures of a width [in] over that of the usual ones."""
    return min(1.0, max(SMALLEST, width / WIDTH))


@contextmanager
def quietly() -> Iterator[None]:
    """Drop matplotlib's warning of letters the font lacks, such as Chinese ones in a name.

    They are drawn as empty boxes.
    """
    with warnings.catch_warnings():
        warnings.filterwarnings("ignore", r"Glyph \d+ .* missing from", UserWarning)
        yield


def force_unit(value: float) -> tuple[float, str]:
    """Choose the unit a force of this size reads best in.

    Parameters
    ----------
    value : float [N]

    Returns
    -------
    factor : float
        Newtons times this are numbers in the unit.
    unit : str
        From "nN" to "MN".

    Examples
    --------
    >>> force_unit(12_000.0)
    (0.001, 'kN')
    >>> force_unit(0.39), force_unit(2e-3), force_unit(0.0)
    ((1.0, 'N'), (1000.0, 'mN'), (1.0, 'N'))
    """
    unit = Unit.for_size(value)
    return 1.0 / unit.newtons, unit.name


def number(value: float) -> str:
    """Write a number with three digits that matter, and never as -0 or 1e+02.

    Examples
    --------
    >>> [number(v) for v in (0.0, -1e-18, 0.39214, 7.0, 1234.5, 2.5e-7)]
    ['0', '0', '0.392', '7', '1234', '2.5e-07']
    """
    if abs(value) < 1e-12:
        return "0"
    return f"{value:.0f}" if abs(value) >= 100.0 else f"{value:.3g}"


def force(value: float, reference: float | None = None) -> str:
    """Write a force with its unit, chosen by the size of `reference` or of the force itself.

    Parameters
    ----------
    value, reference : float [N]

    Examples
    --------
    >>> force(250.0), force(250.0, reference=4e4)
    ('250 N', '0.25 kN')
    """
    factor, unit = force_unit(value if reference is None else reference)
    return f"{number(value * factor)} {unit}"


def round_below(value: float) -> float:
    """Return the largest 1, 2 or 5 times a power of ten that is at most a positive value.

    Examples
    --------
    >>> round_below(37.0), round_below(0.6)
    (20.0, 0.5)
    """
    power = 10.0 ** math.floor(math.log10(value))
    return max(
        (m * power for m in (1.0, 2.0, 5.0) if m * power <= value * (1 + 1e-9)), default=power
    )


def quality_unit(value: float, criterion: Criterion = NOMINAL) -> tuple[float, str]:
    """Choose the unit a quality of this size reads best in; with a task it has none.

    Examples
    --------
    >>> from swarmgrasp.quality import Polytope
    >>> quality_unit(12_000.0), quality_unit(1.2, Criterion(task=Polytope([(1e3, 0, 0)])))
    ((0.001, 'kN'), (1.0, 'times the task'))
    """
    unit = criterion.unit(value)
    return 1.0 / unit.newtons, unit.name


def quality(value: float, criterion: Criterion = NOMINAL, reference: float | None = None) -> str:
    """Write a quality: a force, or with a task how many times that.

    Parameters
    ----------
    value : float [N]
    criterion : Criterion
    reference : float [N], optional
        Its size chooses the unit, instead of the quality's own.

    Examples
    --------
    >>> from swarmgrasp.quality import Polytope
    >>> quality(250.0, reference=4e4), quality(1.2, Criterion(task=Polytope([(1e3, 0, 0)])))
    ('0.25 kN', '1.2 times the task')
    """
    factor, unit = quality_unit(value if reference is None else reference, criterion)
    return f"{number(value * factor)} {unit}"


def gain(before: float, after: float, criterion: Criterion = NOMINAL) -> str:
    """Write how a quality changes, with the same decimals before and after.

    Parameters
    ----------
    before, after : float [N]
        With a task, without a unit.
    criterion : Criterion

    Examples
    --------
    >>> gain(0.0, 2100.0), gain(0.696, 0.696)
    ('quality 0 → 2.10 kN', 'quality stays 0.696 N')
    >>> gain(134_648.0, 311_200.0), gain(134_648.0, 135_268.0)
    ('quality 135 → 311 kN', 'quality 134.65 → 135.27 kN')
    >>> from swarmgrasp.quality import Polytope
    >>> gain(0.81, 1.24, Criterion(task=Polytope([(1e3, 0, 0)])))
    'quality 0.810 → 1.240 times the task'
    """
    factor, unit = quality_unit(max(before, after), criterion)
    if abs(after - before) <= 1e-9 * max(before, after):
        return f"quality stays {number(after * factor)} {unit}"
    old, new = before * factor, after * factor
    least = _decimals(max(old, new), 3)
    decimals = max(least, _decimals(abs(new - old), 2))  # two digits of the gain show
    if old > 0.0:
        decimals = max(decimals, min(_decimals(old, 3), least + 2))
    first = f"{old:.{decimals}f}" if old > 0.0 else "0"
    return f"quality {first} → {new:.{decimals}f} {unit}"


def load_sentence(load: tuple[float, float, float]) -> str:
    """Write a steady wrench on the object [N, N, N m].

    Examples
    --------
    >>> load_sentence((0.0, -20e3, 1.5e6))
    'Load on the object: surge 0, sway −20 kN, yaw 1.5 MN m.'
    """
    surge, sway, yaw = (force(part).replace("-", "\u2212") if part else "0" for part in load)
    return f"Load on the object: surge {surge}, sway {sway}, yaw {yaw}{' m' if load[2] else ''}."


def _decimals(value: float, digits: int) -> int:
    """Return the decimals that show so many significant digits of a positive value."""
    return max(0, digits - 1 - math.floor(math.log10(value)))


def frame_sentences(terms: Terms) -> list[str]:
    """Say what the picture's numbers are, where those of the file are others.

    Examples
    --------
    >>> frame_sentences(SI), frame_sentences(Terms(length="ft"))
    ([], ['SI units; x forward, y to port.'])
    """
    same = (terms.length, terms.frame.bow, terms.frame.mirrored) == (SI.length, 0.0, False)
    return [] if same else ["SI units; x forward, y to port."]


def count(robots: int) -> str:
    """Write a number of robots.

    Examples
    --------
    >>> [count(n) for n in (0, 1, 2)]
    ['no robots', '1 robot', '2 robots']
    """
    return "1 robot" if robots == 1 else f"{robots or 'no'} robots"
