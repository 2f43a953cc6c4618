"""How a command draws: options that all commands with pictures share."""

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Final

from cyclopts import Parameter

from swarmgrasp.cli.inputs import PICTURES, noting, output_faults

if TYPE_CHECKING:
    from swarmgrasp.terms import Terms

WIDTHS: Final = (0.0762, 0.3048)
"""Least and greatest width of a picture [m]."""
INCH: Final = 0.0254
"""In metres."""


@Parameter(name="*", group="Pictures")
@dataclass(frozen=True)
class Drawing:
    """How pictures look."""

    title: str | None = None
    """Written above a picture; the name of the scenario unless given."""
    width: Annotated[str | None, Parameter(metavar="LENGTH")] = None
    """Width of a picture, such as 88mm or 3.5in; 132 mm unless given."""

    def faults(self, plot: Path | None) -> list[str]:
        """Return what is wrong with the options, and with where the picture goes."""
        from swarmgrasp.units import quantity

        faults = output_faults(plot, PICTURES)
        if plot is None:
            given = [f"--{name}" for name, value in vars(self).items() if value is not None]
            faults += [f"{option} is of a picture: add --plot" for option in given]
        if self.width is None:
            return faults
        said: list[str] = []
        least, most = WIDTHS
        with noting(said):
            if not least <= quantity(self.width, "length") <= most:
                wanted = f"it should be from {1e3 * least:g}mm to {1e3 * most:g}mm"
                faults.append(f"--width is {self.width}; {wanted}")
        return faults + [f"--width is {self.width}: {fault}" for fault in said]

    def look(self, name: str, terms: "Terms") -> dict[str, Any]:
        """Return how pictures of a scenario look: with what title, in what terms, how wide [in]."""
        look = {"title": name if self.title is None else self.title, "terms": terms}
        if self.width is None:
            return look
        from swarmgrasp.units import quantity

        return look | {"width": quantity(self.width, "length") / INCH}


USUAL = Drawing()
"""As all pictures are."""
