"""What the simulated network knows of one robot: its process, its clock and its body."""

import math
from dataclasses import dataclass, field

from swarmgrasp.agents.protocol import Agent, Place
from swarmgrasp.agents.protocol import events as ev


@dataclass
class Node:
    """A robot: its process, its clock and its body.

    Attributes
    ----------
    name : str
    index : int
    agent : Agent, optional
        None while no process runs.
    life : int
        Which life it is: a new one begins when a process starts without what was known.
    starts : int
        How often a process has started.
    kept : bytes
        What a process has kept, so that the next one can have it.
    hung_until : float [s]
    mailbox : list of events
        What has come in while it hung.
    ahead, rate : float
        Its clock is `ahead + rate * time`.
    tick_at : float [s]
        When it is to be woken.
    held : Place, optional
        Where it holds the object.
    claimed : Place, optional
        Where it has said that it would fasten, from then on until it lets go.
    job : int
        What its body is about; another job stops it.
    wants : bool
        Whether it has been told to come.
    sent : dict of int to int
        Messages so far to each other robot, by its index.
    """

    name: str
    index: int
    agent: Agent | None = None
    life: int = 0
    starts: int = 0
    kept: bytes = b""
    hung_until: float = 0.0
    mailbox: list[tuple[ev.Event, int]] | None = None
    ahead: float = 0.0
    rate: float = 1.0
    tick_at: float = math.inf
    held: Place | None = None
    claimed: Place | None = None
    job: int = 0
    wants: bool = False
    sent: dict[int, int] = field(default_factory=dict)

    def clock(self, time: float) -> float:
        """Return what its own clock shows."""
        return self.ahead + self.rate * time

    def time(self, clock: float) -> float:
        """Return when its own clock shows something."""
        return (clock - self.ahead) / self.rate
