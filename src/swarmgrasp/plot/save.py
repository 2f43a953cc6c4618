"""Writing a picture to a file, all of it or nothing; or as a part of a page."""

import io
import os
import re
from collections.abc import Mapping, Sequence
from hashlib import sha256
from pathlib import Path
from typing import Final
from xml.sax.saxutils import escape

import matplotlib as mpl
from matplotlib.axes import Axes
from matplotlib.figure import Figure
from matplotlib.text import Text

from swarmgrasp.errors import SwarmGraspError, refuse
from swarmgrasp.files import scratch_for, target_faults
from swarmgrasp.plot import style
from swarmgrasp.texts import clean

PIXELS_PER_INCH: Final = 240
"""Sharp in print at column width, and light."""

METADATA: Final[Mapping[str, dict[str, str | None]]] = {
    ".pdf": {"CreationDate": None, "ModDate": None, "Creator": "swarmgrasp", "Producer": None},
    ".png": {"Software": "swarmgrasp"},
    ".svg": {"Date": None, "Creator": "swarmgrasp"},
}
"""What a file says of itself, by suffix: no date, so that equal pictures are equal files."""

TITLES: Final = ("heading", "title", "criterion")
"""What the texts are called that name a picture, the first first."""

FONTS: Final = ("'DejaVu Sans'", "'DejaVu Sans', 'Bitstream Vera Sans', Verdana")
"""The font of the pictures, and with others of its widths after it, for machines without."""


class PictureNotSaved(SwarmGraspError):
    """A picture cannot be written: an unknown suffix, no such folder, or no permission."""


def save(figure: Figure, path: str | os.PathLike[str]) -> Path:
    """Write a picture as PNG, SVG or PDF, by the suffix of the path.

    The file appears whole or not at all: it is written beside its place and renamed.
    The same picture gives the same bytes. Text in SVG is text, with a title and a description of
    the picture for those who cannot see it, which PNG has too; fonts in PDF are of Type 42.

    Parameters
    ----------
    figure : Figure
    path : path-like

    Returns
    -------
    Path
        Where it was written.

    Raises
    ------
    PictureNotSaved
        If the suffix is none of the three, the folder does not exist, or the file cannot
        be written.
    """
    target = Path(path)
    suffix = target.suffix.lower()
    if suffix not in METADATA:
        raise PictureNotSaved(
            f"{target}: a picture cannot be written as {suffix or 'a file without suffix'!r}; "
            f"the suffix should be one of {', '.join(sorted(METADATA))}"
        )
    refuse((PictureNotSaved, target_faults(target)))
    if suffix == ".svg":
        _clean(figure)
    said = texts_of(figure)
    about = {**METADATA[suffix], "Title": said[0] if said else "swarmgrasp"}
    if suffix == ".png":
        about["Description"] = "; ".join(said[1:])
    style_of_file = mpl.rc_context(
        {"svg.hashsalt": "swarmgrasp", "svg.fonttype": "none", "pdf.fonttype": 42}
    )
    try:
        with scratch_for(target) as scratch, style_of_file, style.quietly():
            figure.savefig(scratch, format=suffix[1:], dpi=PIXELS_PER_INCH, metadata=about)
            if suffix == ".svg":
                text = Path(scratch).read_text(encoding="utf-8")
                Path(scratch).write_text(_described(text, said), encoding="utf-8")
    except OSError as fault:
        raise PictureNotSaved(f"{target}: cannot be written: {fault.strerror or fault}") from fault
    return target


def svg(figure: Figure, name: str = "", title: str = "") -> str:
    """Return a picture as SVG that can stand within a page, its text as text.

    The same picture gives the same text.

    Parameters
    ----------
    figure : Figure
    name : str
        A word of letters and digits, which tells its parts from those of other pictures on the
        page; made of the picture when left out.
    title : str
        What it shows, for those who do not see it.

    Returns
    -------
    str
        An element `svg` that refers to nothing outside it.
    """
    out = io.StringIO()
    nothing = dict.fromkeys(("Creator", "Date", "Format", "Type"))
    _clean(figure)
    look = mpl.rc_context({"svg.hashsalt": "swarmgrasp", "svg.fonttype": "none"})
    with look, style.quietly():
        figure.savefig(out, format="svg", metadata=nothing)
    drawn = out.getvalue()
    drawn = drawn[drawn.index("<svg") :].strip().replace(*FONTS)
    name = name or f"picture{sha256(drawn.encode()).hexdigest()[:8]}"
    drawn = re.sub(r'(\bid="|href="#|url\(#)', rf"\1{name}-", drawn)
    tag, rest = drawn.split(">", 1)
    return f'{tag} role="img">\n <title>{escape(title)}</title>{rest}'


def _clean(figure: Figure) -> None:
    """Take what no file of text may hold out of what is written in a picture."""
    for text in figure.findobj(Text):
        text.set_text(re.sub(r"[^\n\xa0]+", lambda part: clean(part[0]), text.get_text()))


def texts_of(figure: Figure) -> list[str]:
    """Return what is written in a picture, its title first, without the numbers of axes.

    Parameters
    ----------
    figure : Figure
    """
    axes = [axis for ax in figure.findobj(Axes) for axis in (ax.xaxis, ax.yaxis)]
    numbers = {label for axis in axes for label in axis.get_majorticklabels()}
    texts = [text for text in figure.findobj(Text) if text not in numbers and text.get_visible()]
    ranked = sorted(texts, key=lambda text: (*TITLES, text.get_gid()).index(text.get_gid()))
    said = [" ".join(text.get_text().split()) for text in ranked]
    return [text for text in said if text]


def _described(text: str, said: Sequence[str]) -> str:
    """Return an SVG with what is written in it as a description, and with fonts of its widths."""
    description = escape("; ".join(said[1:]))
    text = text.replace(*FONTS)
    return text.replace("</title>", f"</title>\n <desc>{description}</desc>", 1)
