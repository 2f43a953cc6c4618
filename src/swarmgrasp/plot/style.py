"""Colours, sizes and terms that all pictures share."""

import warnings
from collections.abc import Iterator
from contextlib import contextmanager
from contextvars import ContextVar
from typing import Any, Final

import matplotlib as mpl

from swarmgrasp.terms import SI, Terms

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


_terms: ContextVar[Terms] = ContextVar("terms", default=SI)
"""In which the present picture is drawn."""


@contextmanager
def settings(width: float = WIDTH, terms: Terms = SI) -> Iterator[None]:
    """Draw figures of a width [in] in some terms, under the settings of all pictures, and quietly.

    Parameters
    ----------
    width : float [in]
    terms : Terms
        The units, the frame and the words of what is written.
    """
    share = _text_share(width)
    sizes = {key: share * value for key, value in RC.items() if key.endswith("size")}
    token = _terms.set(terms)
    try:
        with mpl.rc_context(RC | sizes | {"figure.figsize": (width, width)}), quietly():
            yield
    finally:
        _terms.reset(token)


def terms() -> Terms:
    """Return the terms in which the present picture is drawn."""
    return _terms.get()


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
