"""Whether the numbers of a section lie in the ranges that are computed with.

The schema knows what holds in any unit. What is known in SI units is checked here, each number at
its key and in the unit of the file.
"""

from collections.abc import Mapping

from pydantic import BaseModel

from swarmgrasp.environment.limits import Range
from swarmgrasp.scenario.faults import Path
from swarmgrasp.scenario.units import NAMED, Units
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.units import quantity

Known = tuple[Range, str]
"""The range of a number, and what it measures: "" if it has no unit."""
Keys = Mapping[str, Known | list[Known | None]]
"""What is known of the number at each key, or of each in a row; None of what has any size."""
_NEEDS = {"area": "length", "turn rate": "angle"}
"""Which of the file's units tells what some numbers are."""


def check_section(
    section: BaseModel,
    path: Path,
    keys: Keys,
    checked: Checked,
    units: Units,
) -> bool:
    """Note every number of a section that is outside its range; tell whether none is.

    Parameters
    ----------
    section : BaseModel
    path : tuple
        To the section.
    keys : mapping
    checked : Checked
    units : Units
    """
    before = len(checked.faults)
    for key, known in keys.items():
        if checked.is_sound(*path, key):
            _check(getattr(section, key), known, (*path, key), checked, units)
    return len(checked.faults) == before


def _check(
    value: object,
    known: Known | list[Known | None] | None,
    path: Path,
    checked: Checked,
    units: Units,
) -> None:
    """Note a number, or each of a list, that is outside its range."""
    if isinstance(value, list):
        is_row = not isinstance(value[0], list)
        for i, item in enumerate(value):
            own = known[i] if isinstance(known, list) and is_row else known
            _check(item, own, (*path, i), checked, units)
    elif isinstance(value, float) and isinstance(known, tuple):
        within, of = known
        needs = _NEEDS.get(of, of)
        if needs in NAMED and not checked.is_sound("units", needs):
            return
        size = quantity(1.0, of, units.of(of)) if of else 1.0
        if not within.low <= value * size <= within.high:
            ends = f"[{within.low / size:.4g}, {within.high / size:.4g}]"
            unit = units.of(of) or within.unit.removeprefix("1")
            checked.fault(path, f"should lie in {ends} {unit}".rstrip())
