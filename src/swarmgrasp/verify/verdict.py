"""The outcome of a check."""

import math
from dataclasses import dataclass
from html import escape
from typing import Any


@dataclass(frozen=True)
class Verdict:
    """The outcome of a check; true in a condition when everything holds.

    Attributes
    ----------
    faults : tuple of str
        Every claim that does not hold.
    upper_bounds : tuple of float [N]
        Of placements, the recomputed bound of each; with a task, without a unit.
    unchecked : tuple of str
        What was taken on trust: of very many robots or uncertain poses, that the qualities
        are no less than stated; of a newcomer that cannot hit its place, the upper bound.
    """

    faults: tuple[str, ...]
    upper_bounds: tuple[float, ...] = ()
    unchecked: tuple[str, ...] = ()

    def __bool__(self) -> bool:
        return not self.faults

    def _repr_html_(self) -> str:
        """Return the outcome in sentences, for a notebook."""
        head = "Verified" if self else "Refused"
        told = self.faults or tuple(f"Taken on trust: {each}." for each in self.unchecked)
        rows = "".join(f"<li>{escape(each)}</li>" for each in told)
        return f"<strong>{head}</strong>" + (f"<ul>{rows}</ul>" if rows else "")

    def to_data(self) -> dict[str, Any]:
        """Return the outcome as plain data; a bound that is infinite, as null."""
        return {
            "verified": bool(self),
            "faults": list(self.faults),
            "upper_bounds": [b if math.isfinite(b) else None for b in self.upper_bounds],
            "unchecked": list(self.unchecked),
        }
