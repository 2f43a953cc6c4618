"""What is kept of runs: some instants, in single precision, in arrays made at the start."""

import math

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Kept = NDArray[np.float32]

MOST_NUMBERS = 10**9
"""That one answer keeps: 4 GB."""
OF_OBJECT = 3 + 3 + 1 + 1 + 4 + 3 + 3 + 3 + 1
OF_ROBOT = 3


def numbers_kept(runs: int, instants: int, robots: int) -> int:
    """Return how many numbers are kept of some runs."""
    return runs * instants * (OF_OBJECT + OF_ROBOT * robots)


class Keeper:
    """The arrays of a `Run`, filled instant by instant.

    Parameters
    ----------
    runs : int
    last : int
        Number of the last instant; the first is 0.
    robots : int
    every : int
        Of so many instants one is kept, beside the last.
    room : int, optional
        Instants after which it is full; all of them when left out.
    """

    def __init__(
        self, runs: int, last: int, robots: int, every: int, room: int | None = None
    ) -> None:
        instants = math.ceil(last / every) + 1
        instants = instants if room is None else min(instants, room)
        self._last, self._every, self._count = last, every, 0
        self._numbers: list[int] = []
        self._references: Kept = np.zeros((instants, 3), dtype=np.float32)
        widths = {
            "poses": 3, "velocities": 3, "streams": 4, "loads": 3, "wanted": 3, "given": 3,
            "forces": robots, "angles": robots, "shares": robots,
        }  # fmt: skip
        shapes = {name: (instants, runs, width) for name, width in widths.items()}
        single = dict.fromkeys(("distances", "turns", "shortfalls"), (instants, runs))
        self._kept: dict[str, Kept] = {
            name: np.full(shape, np.nan if name == "angles" else 0.0, dtype=np.float32)
            for name, shape in {**shapes, **single}.items()
        }
        self._distances, self._turns = np.zeros(runs), np.zeros(runs)

    def measure(self, poses: Array, reference: Array) -> None:
        """Note how far poses (runs, 3) are from the reference (3,)."""
        off = poses - reference
        np.maximum(self._distances, np.hypot(off[:, 0], off[:, 1]), out=self._distances)
        np.maximum(self._turns, np.abs(off[:, 2]), out=self._turns)

    def keeps(self, number: int) -> bool:
        """Tell whether an instant, by its number, is kept."""
        return number % self._every == 0 or number == self._last

    def keep(self, number: int, reference: Array, told: dict[str, Array]) -> None:
        """Keep an instant: arrays with a row for each run, by name, and errors since the last."""
        k = self._count
        told = {**told, "distances": self._distances, "turns": self._turns}
        for name, rows in told.items():
            self._kept[name][k] = rows
        self._references[k] = reference
        self._numbers.append(number)
        self._distances[:] = self._turns[:] = 0.0
        self._count += 1

    @property
    def is_full(self) -> bool:
        """Whether there is no room for another instant."""
        return self._count == len(self._references)

    @property
    def numbers(self) -> NDArray[np.intp]:
        """(m,): the numbers of the instants kept."""
        return np.array(self._numbers, dtype=np.intp)

    def arrays(self) -> dict[str, Kept]:
        """Return what is kept, by name, up to the last instant that is."""
        found = {name: rows[: self._count].swapaxes(0, 1) for name, rows in self._kept.items()}
        return {**found, "references": self._references[: self._count]}
