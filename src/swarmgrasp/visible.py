"""What can be seen: objects that notebooks show, and that can be drawn."""

from importlib import import_module
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from matplotlib.figure import Figure


class Visible:
    """What notebooks show as a picture and in sentences, and what can be drawn by itself.

    Who draws and tells stands above all that is drawn and told, so it is found by its name when it
    is asked: importing an object imports no plotting.
    """

    def plot(self, *, title: str = "", width: float | None = None) -> "Figure":
        """Draw it, as the command line does.

        Parameters
        ----------
        title : str
            Written above the picture.
        width : float [in], optional
            Of the picture; 5.2 when left out.

        Returns
        -------
        Figure
            Of matplotlib, which notebooks show.
        """
        figure: Figure = _inline().figure_of(self, title, width)
        return figure

    def _repr_html_(self) -> str:
        """Return the picture and the sentences, for a notebook."""
        return str(_inline().html_of(self))


def _inline() -> Any:
    """Return who draws and tells."""
    return import_module("swarmgrasp.inline")
