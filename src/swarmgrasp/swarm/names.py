"""The names of a swarm's robots: unique, and cheap for a million robots that were given none."""

import itertools
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import cached_property
from types import MappingProxyType

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import RobotInvalid
from swarmgrasp.frozen import Frozen
from swarmgrasp.ranges import items, name_faults, shown

_NUMBERED = re.compile(r"R([1-9][0-9]{0,8})")
"""What robots without a name are called."""
MOST_SHOWN = 10
"""Faults of names that are told, of many."""
Given = Mapping[int, str]
"""Names by index."""
NOBODY: Given = MappingProxyType({})


@dataclass(frozen=True, eq=False)
class Names(Frozen):
    """The names of n robots, in order.

    A robot without a name is R and the first number that nobody has. It keeps that name when others
    join or leave.

    Attributes
    ----------
    given : mapping of int to str
        By index, the names that are no R with a number above those before it.
    numbers : (n,) of int
        Of all others, that number; of those, the last one before it: so that they never fall.

    Examples
    --------
    >>> names = names_of(["", "Ajax", "R2", ""])
    >>> list(names), names.index("R3"), list(names.without([0]))
    (['R1', 'Ajax', 'R2', 'R3'], 3, ['Ajax', 'R2', 'R3'])
    """

    given: Given
    numbers: NDArray[np.int64]

    def __len__(self) -> int:
        """Return the number of robots."""
        return len(self.numbers)

    def __getitem__(self, index: int) -> str:
        """Return the name of a robot, 0 <= index < n."""
        return self.given.get(index) or f"R{self.numbers[index]}"

    def __iter__(self) -> Iterator[str]:
        """Go through the names."""
        return (self[i] for i in range(len(self)))

    @cached_property
    def _indices(self) -> Mapping[str, int]:
        """The robots by the names they were given."""
        return MappingProxyType({name: i for i, name in self.given.items()})

    def index(self, name: object) -> int | None:
        """Return the index of the robot of a name; None if there is none."""
        if not isinstance(name, str):
            return None
        found, number = self._indices.get(name), _number(name)
        if found is not None or not number:
            return found
        i = int(np.searchsorted(self.numbers, number))
        return i if i < len(self) and self.numbers[i] == number and i not in self.given else None

    def fresh(self, name: str, count: int = 1) -> list[str]:
        """Return names that nobody has, for so many newcomers of one name.

        Examples
        --------
        >>> names = names_of(["tug", "tug 2"])
        >>> names.fresh("barge"), names.fresh("tug"), names.fresh("tug", 2)
        (['barge'], ['tug 3'], ['tug 1', 'tug 3'])
        """
        numbered = (f"{name} {k}" for k in itertools.count(1 if count > 1 else 2))
        candidates = numbered if count > 1 else itertools.chain([name], numbered)
        return list(itertools.islice((n for n in candidates if self.index(n) is None), count))

    def joined(self, name: str) -> "Names":
        """Return the names with that of one robot more; "" for a nameless one.

        Raises
        ------
        RobotInvalid
            If a robot is called that already.
        """
        same = self.index(name)
        if same is not None:
            raise RobotInvalid(_clash(name, [same, len(self)]))
        last = int(self.numbers[-1]) if len(self) else 0
        number = _number(name) if name else self._first_free()
        if number > last:
            return Names(self.given, np.append(self.numbers, number))
        given = {**self.given, len(self): name or f"R{number}"}
        return Names(given, np.append(self.numbers, last))

    def renamed(self, index: int, name: str) -> "Names":
        """Return the names with another for one robot.

        Raises
        ------
        RobotInvalid
            If a robot is called that already.

        Examples
        --------
        >>> list(names_of(["", "Ajax", ""]).renamed(1, "Boreas"))
        ['R1', 'Boreas', 'R2']
        """
        same = self.index(name)
        if same is not None:
            raise RobotInvalid(_clash(name, sorted((same, index))))
        names = list(self)
        names[index] = name
        return names_of(names)

    def _first_free(self) -> int:
        """Return the first number that nobody has."""
        mine = np.delete(self.numbers, list(self.given))
        gaps = np.flatnonzero(mine != np.arange(1, len(mine) + 1))
        number = 1 + (int(gaps[0]) if len(gaps) else len(mine))
        while self.index(f"R{number}") is not None:
            number += 1
        return number

    def without(self, gone: Iterable[int]) -> "Names":
        """Return the names of those that stay when robots leave."""
        leaving = set(gone)
        kept = np.delete(np.arange(len(self)), list(leaving))
        if any(map(_number, self.given.values())):
            return names_of([self[i] for i in kept.tolist()])
        staying = sorted(set(self.given) - leaving)
        given = {int(np.searchsorted(kept, i)): self.given[i] for i in staying}
        numbers = self.numbers[kept]
        numbers[list(given)] = 0
        return Names(given, np.maximum.accumulate(numbers))


def names_of(names: Sequence[str]) -> Names:
    """Return the names of robots, "" for nameless ones.

    Raises
    ------
    RobotInvalid
        If several are called the same.

    Examples
    --------
    >>> names_of(["Ajax", "", "Ajax"])
    Traceback (most recent call last):
    ...
    swarmgrasp.errors.RobotInvalid: robots 1 and 3 are both called 'Ajax'; names should be unique
    """
    clashes: list[str] = []
    if len(set(names)) < len(names):
        uses = Counter(name for name in names if name)
        clashes = [name for name, count in uses.items() if count > 1]
    if clashes:
        raise RobotInvalid(
            _clash(name, [i for i, other in enumerate(names) if other == name]) for name in clashes
        )
    given: dict[int, str] = {}
    numbers, last = np.zeros(len(names), dtype=np.int64), 0
    for i, name in enumerate(filled(names)):
        number = _number(name)
        if number > last:
            last = number
        else:
            given[i] = name
        numbers[i] = last
    return Names(given, numbers)


def checked_names(names: object, count: int) -> Names:
    """Return the names of so many robots, as they were given.

    Raises
    ------
    RobotInvalid
        If they are not so many names, or several are called the same.

    Examples
    --------
    >>> list(checked_names(["Ajax", ""], 2))
    ['Ajax', 'R1']
    >>> checked_names(["Ajax"], 2)
    Traceback (most recent call last):
    ...
    swarmgrasp.errors.RobotInvalid: there are 1 names for 2 robots; give one a robot
    """
    given = items(names)
    if given is None:
        raise RobotInvalid(f"the names are {shown(names)}; they should be a list of names")
    faults = [] if _are_plain(given) else [f for name in given for f in name_faults(name)]
    if len(given) != count:
        faults.append(f"there are {len(given)} names for {count} robots; give one a robot")
    if faults:
        raise RobotInvalid(faults[:MOST_SHOWN])
    return names_of(given)


def _are_plain(names: Sequence[object]) -> bool:
    """Tell of many names at once that none is at fault."""
    texts = [name for name in names if isinstance(name, str)]
    together = "".join(texts)
    is_shown = len(texts) == len(names) and together.isascii() and together.isprintable()
    return is_shown and not any(text.isspace() for text in texts)


def filled(names: Sequence[str]) -> list[str]:
    """Return names, those of nameless robots filled in: R and the first number that nobody has.

    Examples
    --------
    >>> filled(["", "Ajax", "R2", ""])
    ['R1', 'Ajax', 'R2', 'R3']
    """
    taken = set(names)
    free = (f"R{k}" for k in itertools.count(1) if f"R{k}" not in taken)
    return [name or next(free) for name in names]


def numbered(count: int) -> Names:
    """Return the names of so many nameless robots."""
    return Names(NOBODY, np.arange(1, count + 1))


def _number(name: str) -> int:
    """Return the number of a name that is R and a number, 0 for any other."""
    found = _NUMBERED.fullmatch(name) if name[:1] == "R" else None
    return int(found[1]) if found else 0


def _clash(name: str, indices: Sequence[int]) -> str:
    """Return the sentence for robots of one name."""
    first = ", ".join(str(i + 1) for i in indices[:-1])
    return (
        f"robots {first} and {indices[-1] + 1} are {'both' if len(indices) == 2 else 'all'} called "
        f"{shown(name)}; names should be unique"
    )
