"""Objects that nobody can change: frozen outside, frozen inside, equal when their values are."""

import math
from collections.abc import Hashable, Iterator, Mapping
from dataclasses import fields, is_dataclass
from types import MappingProxyType
from typing import Any, TypeVar

import numpy as np
from numpy.typing import NDArray

Array = TypeVar("Array", bound=NDArray[Any])
_SETTLED = (float, tuple, bool, str, int, type(None))
"""Most of what objects hold: nothing to freeze."""


_FEW = 4
"""Longer rows are told by their length."""


class Frozen:
    """A frozen dataclass (`eq=False`) that may hold arrays, mappings and lists.

    What it holds is made unchangeable: arrays read-only, mappings read-only views of copies, lists
    tuples. Copies and pickles are of its fields alone, not of what was worked out from them, and
    come back frozen. Two are equal if the fields to be compared are, arrays by what is in them and
    nan to nan; equal ones have equal hashes.

    Examples
    --------
    >>> from dataclasses import dataclass
    >>> @dataclass(frozen=True, eq=False)
    ... class Row(Frozen):
    ...     numbers: np.ndarray
    >>> row = Row(np.array([1.0, np.nan]))
    >>> row.numbers.flags.writeable, row == Row(np.array([1.0, np.nan])), len({row, row})
    (False, True, 1)
    >>> row, Row(np.zeros((6, 2)))
    (Row(numbers=[1.0, nan]), Row(numbers=<6 x 2 numbers>))
    """

    def __init_subclass__(cls) -> None:
        """Keep the short form below where a dataclass would write out all it holds."""
        super().__init_subclass__()
        if "__repr__" not in vars(cls):
            cls.__repr__ = Frozen.__repr__  # type: ignore[method-assign]

    def __post_init__(self) -> None:
        """Freeze the fields."""
        self._freeze()

    def _freeze(self) -> None:
        """Make what the fields hold unchangeable."""
        held = vars(self)
        for name, value in held.items():
            if type(value) in _SETTLED:
                continue
            if isinstance(value, np.ndarray):
                read_only(value)
            elif isinstance(value, dict):
                held[name] = MappingProxyType(dict(value))
            elif isinstance(value, list):
                held[name] = tuple(value)

    def __getstate__(self) -> dict[str, Any]:
        """Return the fields for a copy or a pickle."""
        held = vars(self)
        return {part.name: _thawed(held[part.name]) for part in fields(self)}  # type: ignore[arg-type]

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Come back from a copy or a pickle."""
        vars(self).update(state)
        self._freeze()

    def _compared(self) -> Iterator[object]:
        """Go through the values that make two of them equal."""
        return (getattr(self, f.name) for f in fields(self) if f.compare)  # type: ignore[arg-type]

    def __repr__(self) -> str:
        """Return what it holds in a line: long rows by length, objects by class."""
        shown = (
            f"{part.name}={_brief(getattr(self, part.name))}"
            for part in fields(self)  # type: ignore[arg-type]
            if part.repr
        )
        return f"{type(self).__name__}({', '.join(shown)})"

    def __eq__(self, other: object) -> bool:
        """Compare by value."""
        if self is other:
            return True
        if not isinstance(other, Frozen) or type(self) is not type(other):
            return NotImplemented
        return all(map(_same, self._compared(), other._compared()))

    def __hash__(self) -> int:
        """Return the same number for equal ones, worked out once."""
        found: int | None = vars(self).get("_hash")
        if found is None:
            found = vars(self)["_hash"] = hash(tuple(map(_hashable, self._compared())))
        return found


def read_only(array: Array) -> Array:
    """Return an array, now read-only."""
    array.setflags(write=False)
    return array


def _thawed(value: object) -> object:
    """Return a value that can be pickled."""
    return dict(value) if isinstance(value, MappingProxyType) else value


def _brief(value: object) -> str:
    """Return a value in few words."""
    if is_dataclass(value):
        return f"<{type(value).__name__}>"
    if isinstance(value, np.ndarray):
        if value.size > _FEW:
            return f"<{' x '.join(map(str, value.shape))} numbers>"
        return f"{value.tolist()}"
    if isinstance(value, tuple | Mapping) and len(value) > _FEW:
        return f"<{len(value)} of {type(next(iter(value))).__name__}>"
    if isinstance(value, tuple):
        return f"({', '.join(map(_brief, value))}{',' * (len(value) == 1)})"
    return repr(value)


def _same(one: object, other: object) -> bool:
    """Tell whether two values are the same."""
    if isinstance(one, np.ndarray) and isinstance(other, np.ndarray):
        return one.dtype == other.dtype and np.array_equal(one, other, equal_nan=True)
    if isinstance(one, tuple) and isinstance(other, tuple):
        return len(one) == len(other) and all(map(_same, one, other))
    if isinstance(one, float) and isinstance(other, float) and math.isnan(one):
        return math.isnan(other)
    return bool(one == other)


def _hashable(value: object) -> Hashable:
    """Return what stands for a value in a hash."""
    if isinstance(value, np.ndarray):
        return (value + 0 if value.dtype.kind == "f" else value).tobytes()  # -0.0 is 0.0
    if isinstance(value, tuple):
        return tuple(map(_hashable, value))
    if isinstance(value, Mapping):
        return frozenset((key, _hashable(held)) for key, held in value.items())
    if isinstance(value, float) and math.isnan(value):
        return "nan"
    return value
