"""Objects as plain data, and back: what crosses a border, and nothing else.

The plain form of an object is what its class takes, by name: `to_data` asks the object for each,
and `from_data` gives each to the class once it is of the kind that the class says. What a class
takes more is written and read without a word here.
"""

import math
import types
from collections.abc import Iterator, Mapping, Sequence
from enum import StrEnum
from functools import cache
from inspect import signature
from typing import (
    Any,
    ClassVar,
    Literal,
    NamedTuple,
    Self,
    Union,
    get_args,
    get_origin,
    get_type_hints,
)

import numpy as np

from swarmgrasp.errors import DataInvalid, SwarmGraspError
from swarmgrasp.ranges import shown, unknown_key
from swarmgrasp.visible import Visible

LARGEST = 1e300
"""Of any number that is read."""


class Told:
    """What can be told as plain data: mappings, lists, numbers, text, true, false and null."""

    def to_data(self) -> dict[str, Any]:
        """Return the object as plain data, in SI units and radians."""
        cls: Any = type(self)
        return picked(self, *parts_of(cls))


class Plain(Told):
    """What can be told as plain data and made of them again."""

    @classmethod
    def from_data(cls, data: object) -> Self:
        """Make the object that plain data stand for.

        Parameters
        ----------
        data : dict
            As `to_data` gives it, with all keys and no other.

        Raises
        ------
        DataInvalid
            If keys are missing or unknown, or values are of the wrong kind or outside their range;
            all faults at once, each with the path of its key.
        """
        faults: list[str] = []
        found: Self = read(data, cls, (), faults)
        if faults:
            raise DataInvalid(faults)
        return found


class Answer(Told, Visible):
    """What an answer file may hold: an answer, told together with its question."""

    kind: ClassVar[str]
    """What the answer is, in the file's `format`."""


def picked(holder: object, *names: str) -> dict[str, Any]:
    """Return attributes of an object as plain data, by name."""
    return {name: plain(getattr(holder, name)) for name in names}


def plain(value: Any) -> Any:
    """Return a value as plain data; numbers that JSON does not have, as null.

    Examples
    --------
    >>> plain((1, np.float64(0.5), np.array([math.nan, 2.0]), None))
    [1, 0.5, [None, 2.0], None]
    """
    if isinstance(value, Told):
        return value.to_data()
    if isinstance(value, np.ndarray | np.generic):
        is_plain = value.dtype.kind != "f" or np.isfinite(value).all()
        return value.tolist() if is_plain else plain(value.tolist())
    if isinstance(value, tuple | list):
        return [plain(item) for item in value]
    if isinstance(value, Mapping):
        return {key: plain(item) for key, item in value.items()}
    if isinstance(value, StrEnum):
        return value.value
    if isinstance(value, float):
        return value if math.isfinite(value) else None
    return value


# -- reading ------------------------------------------------------------------------------

_Path = tuple[str | int, ...]


class _Branch(NamedTuple):
    """One kind that a value may be of: how JSON writes it, and what it is called."""

    kind: Any
    written: tuple[type, ...]
    words: str


_SIMPLE = {
    float: ((float, int), "a number"),
    int: ((int,), "a whole number"),
    str: ((str,), "text"),
    bool: ((bool,), "true or false"),
    types.NoneType: ((types.NoneType,), "null"),
}


@cache
def parts_of(cls: Any) -> dict[str, Any]:
    """Return the kinds of what a class takes, by name: those of its fields of these names."""
    kinds = {**get_type_hints(cls.__init__), **get_type_hints(cls)}
    return {name: kinds[name] for name in signature(cls).parameters}


@cache
def _branches(kind: Any) -> tuple[_Branch, ...]:
    """Return the kinds that a value may be of."""
    if get_origin(kind) in (types.UnionType, Union):
        return tuple(branch for one in get_args(kind) for branch in _branches(one))
    if kind in _SIMPLE:
        return (_Branch(kind, *_SIMPLE[kind]),)
    if get_origin(kind) is Literal:
        return (_Branch(kind, (str,), " or ".join(map(repr, get_args(kind)))),)
    if _is_plain(kind):
        return (_Branch(kind, (dict, kind), f"a mapping of {', '.join(parts_of(kind))}"),)
    return (_Branch(kind, (list,), "a list"),)


def origin_of(kind: Any) -> Any:
    """Return the class of a generic kind, also where a name stands for it, as NumPy's `NDArray`.

    Examples
    --------
    >>> origin_of(tuple[float, float])
    <class 'tuple'>
    >>> from numpy.typing import NDArray  # a name of its own from Python 3.12 on
    >>> origin_of(NDArray[np.float64])
    <class 'numpy.ndarray'>
    """
    origin = get_origin(kind)
    while hasattr(origin, "__value__"):
        origin = get_origin(origin.__value__)
    return origin


def _is_plain(kind: Any) -> bool:
    """Tell whether a kind is a class of objects that have a plain form."""
    return isinstance(kind, type) and issubclass(kind, Plain)


def read(data: Any, kind: Any, path: _Path, faults: list[str]) -> Any:
    """Return the value that plain data stand for; note what is wrong with them.

    Parameters
    ----------
    data : object
        As JSON has it; an object that has been made of a mapping already may stand for it.
    kind : type
        As annotations have it.
    path : tuple of str and int
        Keys that lead to the data, for messages.
    faults : list of str
        Faults are added to it; if there are any, what is returned is of no use.
    """
    branches = _branches(kind)
    fitting = [branch for branch in branches if type(data) in branch.written]
    if not fitting:
        return _note(" or ".join(dict.fromkeys(b.words for b in branches)), data, path, faults)
    one = fitting[0].kind
    if isinstance(data, dict):  # of several mappings, the one with these keys
        kinds = (branch.kind for branch in fitting)
        one = max(kinds, key=lambda cls: len(parts_of(cls).keys() & data.keys()))
        return _object(data, one, path, faults)
    if isinstance(data, list):
        return _list(data, one, path, faults)
    if one is float:
        return float(data) if _is_number(data) else _note("a number", data, path, faults)
    if get_origin(one) is Literal and data not in get_args(one):
        return _note(fitting[0].words, data, path, faults)
    return data


def _object(data: dict[str, Any], cls: type, path: _Path, faults: list[str]) -> Any:
    """Make an object of a mapping; note what is wrong with it."""
    parts, before = parts_of(cls), len(faults)
    faults += (
        _told(unknown_key(key, list(parts)), (*path, shown(key).strip("'")))
        for key in data
        if key not in parts
    )
    faults += (_told("is missing", (*path, key)) for key in parts if key not in data)
    given = {
        key: read(data[key], kind, (*path, key), faults)
        for key, kind in parts.items()
        if key in data
    }
    if len(faults) == before:
        try:
            return cls(**given)
        except SwarmGraspError as error:
            faults += (_told(fault, path) for fault in error.faults)
    return None


def _list(data: list[Any], kind: Any, path: _Path, faults: list[str]) -> Any:
    """Return a row of values; note what is wrong with it."""
    if origin_of(kind) is np.ndarray:
        strangers = [leaf for leaf in _leaves(data) if not _is_number(leaf)]
        return _note("numbers only", strangers[0], path, faults) if strangers else data
    kinds: Sequence[Any] = get_args(kind)
    if get_origin(kind) is not tuple or kinds[-1] is ...:
        kinds = [kinds[0]] * len(data)
    if len(data) != len(kinds):
        return _note(f"a list of {len(kinds)}", data, path, faults)
    rows = zip(data, kinds, strict=True)
    return tuple(read(item, one, (*path, i), faults) for i, (item, one) in enumerate(rows))


def _is_number(value: object) -> bool:
    """Tell whether JSON holds a number that is finite as a float."""
    return type(value) in (float, int) and abs(value) <= LARGEST  # type: ignore[arg-type]


def _leaves(data: list[Any]) -> Iterator[Any]:
    """Go through what nested lists hold."""
    for item in data:
        if isinstance(item, list):
            yield from _leaves(item)
        else:
            yield item


def _note(wanted: str, data: object, path: _Path, faults: list[str]) -> None:
    """Note a fault of a value."""
    faults.append(_told(f"should be {wanted}; it is {shown(data)}", path))


def _told(said: str, path: _Path) -> str:
    """Return a fault with the path of its key."""
    return f"{'.'.join(map(str, path))}: {said}" if path else said
