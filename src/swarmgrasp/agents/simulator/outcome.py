"""What becomes of a schedule."""

from dataclasses import dataclass

from swarmgrasp.agents.protocol import Place
from swarmgrasp.agents.simulator.checks import Broken
from swarmgrasp.agents.simulator.faults import Schedule


@dataclass(frozen=True)
class Census:
    """What a swarm in groups has come to.

    Attributes
    ----------
    counted : int
        Robots that all slots count.
    lower, upper, true : float [N]
        The bounds of the quality that all know, and the quality.
    sent, most_sent, received : float [B/s]
        What a robot sends at the mean and at most, and receives at the mean; one word to many is
        sent once.
    """

    counted: int
    lower: float
    upper: float
    true: float
    sent: float
    most_sent: float
    received: float


@dataclass(frozen=True)
class Outcome:
    """What became of a schedule.

    Attributes
    ----------
    schedule : Schedule
    broken : Broken, optional
        The first invariant that does not hold.
    events, messages, sent : int
        Events that agents took, messages that came in, and bytes that were sent.
    time : float [s]
        When all was settled, in the simulated world.
    excused : int
        Pairs that fastened too close, neither having heard the other.
    turns : int
        Targets that were set.
    places : tuple of (str, Place)
        Of the robots that hold the object at the end, in the order of their tickets.
    reports : tuple of (float, str)
        What the robots said to people, and when.
    trace : str
        A digest of all that happened: the same for the same run.
    census : Census, optional
        Of a swarm in groups.
    """

    schedule: Schedule
    broken: Broken | None
    events: int
    messages: int
    sent: int
    time: float
    excused: int
    turns: int
    places: tuple[tuple[str, Place], ...]
    reports: tuple[tuple[float, str], ...]
    trace: str
    census: Census | None = None
