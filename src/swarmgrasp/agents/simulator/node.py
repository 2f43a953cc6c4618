"""What the simulated network knows of one robot: its process, its clock and its body."""

import math
from dataclasses import dataclass

from swarmgrasp.agents.groups import Member
from swarmgrasp.agents.protocol import Agent, Place
from swarmgrasp.agents.protocol import events as ev

Process = Agent | Member
"""What runs on a robot; of one in groups, a member."""


@dataclass
class Node:
    """A robot: its process, its clock and its body.

    Attributes
    ----------
    name : str
    index : int
    process : Process, optional
        None while none runs.
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
    group : int
        Of which it was last, in a swarm of groups; -1 for none.
    sent, received : int
        Bytes, in a swarm of groups; one word to many is sent once.
    """

    name: str
    index: int
    process: Process | None = None
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
    group: int = -1
    sent: int = 0
    received: int = 0

    @property
    def agent(self) -> Agent | None:
        """What keeps the rules; None while no process runs, or while it has no group."""
        return self.process.agent if isinstance(self.process, Member) else self.process

    def clock(self, time: float) -> float:
        """Return what its own clock shows."""
        return self.ahead + self.rate * time

    def time(self, clock: float) -> float:
        """Return when its own clock shows something."""
        return (clock - self.ahead) / self.rate
