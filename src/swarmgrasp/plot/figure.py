"""A figure that notebooks show by itself, whatever they know of matplotlib."""

from matplotlib.figure import Figure


class Drawn(Figure):
    """A figure of matplotlib; a notebook shows it as SVG."""

    def _repr_svg_(self) -> str:
        """Return the figure as SVG."""
        from swarmgrasp.plot.save import svg, texts_of

        said = texts_of(self)
        return svg(self, title=said[0] if said else "")
