"""How much the report measures."""

from typing import NamedTuple


class Size(NamedTuple):
    """Numbers of random draws.

    Attributes
    ----------
    name : str
    gains : int
        For each number of robots, to place a newcomer in.
    relaxed : int
        For each number of robots, to run Algorithm 1 and its relaxation on.
    timed, beyond : tuple of int
        Numbers of robots within Fig. 6, and beyond it.
    configurations : int
        For each number of robots that is timed.
    plateaus : int
        For each number of robots, whose optimal sets are measured.
    misprints : int
        That each misprint is followed on.
    segments : int
        Along which quasi-concavity is checked.
    """

    name: str
    gains: int
    relaxed: int
    timed: tuple[int, ...]
    beyond: tuple[int, ...]
    configurations: int
    plateaus: int
    misprints: int
    segments: int

    @property
    def steps(self) -> int:
        """Draws of all studies, for a progress bar."""
        sizes = len(ROBOTS)
        many = self.gains + self.relaxed + self.plateaus
        timed = len(self.timed) + len(self.beyond)
        return sizes * many + timed * self.configurations + self.misprints


ROBOTS = (5, 15, 25)
"""Numbers of robots already there."""

FULL = Size("full", 2000, 500, tuple(range(5, 26)), (50, 100, 200), 10, 200, 100, 20_000)
QUICK = Size("quick", 1000, 24, (5, 10, 15, 20, 25), (50,), 3, 12, 10, 5_000)
