"""The swarms of the study: an object, a kind of robot, and how many there are."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cache

import numpy as np

from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.outline.outline import Contact
from swarmgrasp.placement import Problem
from swarmgrasp.plain import Told
from swarmgrasp.swarm import Newcomer, Robot, Swarm

BARGE, HULL, TANK = "barge", "ship hull", "round tank"
PUSH, FREE, STEER = "push", "free", "steer"
NEWCOMERS = {
    PUSH: Newcomer(1.0, "push", 0.5),
    FREE: Newcomer(1.0, "free"),
    STEER: Newcomer(1.0, "push", 0.8, steers=True),
}
"""Of 1 N, by kind: within 0.5 rad of the normal, in any direction, or steering within 0.8 rad."""
ROOM = 3.0
"""The spacing is the perimeter over so many times the robots: all find room, around corners too."""

Generator = np.random.Generator


@dataclass(frozen=True)
class Case(Told):
    """Swarms that are alike.

    Attributes
    ----------
    shape : str
        Of the object: a barge of 80 m by 20 m, a ship hull of 120 m by 20 m, or a round tank of
        24 m across.
    kind : str
        What its robots are: "push", "free" or "steer".
    present : int
        Robots that are there at random places before any that decides.
    final : int
        Robots in the end.
    """

    shape: str
    kind: str
    present: int
    final: int

    @property
    def newcomer(self) -> Newcomer:
        """What a robot is before it has a place."""
        return NEWCOMERS[self.kind]

    @property
    def spacing(self) -> float:
        """Least distance of two robots [m]."""
        return outline_of(self.shape).perimeter / (ROOM * self.final)

    @property
    def words(self) -> str:
        """The case in a few words."""
        return f"{self.shape}, {self.kind}, {self.final} robots"

    def start(self, draws: Generator) -> Swarm:
        """Draw the robots that are there before any that decides."""
        outline = outline_of(self.shape)
        shares = draws.random(self.present)
        contacts = [outline.at_arc_length(float(share) * outline.perimeter) for share in shares]
        return Swarm(outline, [self.drawn(contact, draws) for contact in contacts])

    def drawn(self, contact: Contact, draws: Generator) -> Robot:
        """Return a robot at a contact, in a direction drawn from those it may take."""
        newcomer = self.newcomer
        half = math.pi if newcomer.half_angle is None else newcomer.half_angle
        turn, steers = (0.0, half) if newcomer.steers else (float(draws.uniform(-half, half)), 0.0)
        return Robot(contact.point, contact.inward + turn, newcomer.limit, steers=steers)

    def at_random(self, swarm: Swarm, taken: tuple[Stretch, ...], draws: Generator) -> Robot:
        """Return a newcomer anywhere that is free, in any direction it may take."""
        pieces = self.question(swarm, taken).pieces().each
        ends = np.cumsum([piece.end - piece.start for piece in pieces])
        along = float(draws.random()) * ends[-1]
        index = int(np.searchsorted(ends, along))
        piece = pieces[index]
        base = float(swarm.outline.corner_arc_lengths[piece.edge])
        contact = swarm.outline.at_arc_length(base + piece.end - (float(ends[index]) - along))
        return self.drawn(contact, draws)

    def question(self, believed: Swarm, taken: tuple[Stretch, ...]) -> Problem:
        """Return where a newcomer goes beside robots it believes in, clear of what is taken."""
        return Problem(believed, self.newcomer, no_go=taken)

    def taken(self, robots: Iterable[Robot]) -> tuple[Stretch, ...]:
        """Return what lies nearer than the spacing to robots that are there."""
        contacts = np.array([robot.contact for robot in robots]).reshape(-1, 2)
        return outline_of(self.shape).stretches_near(contacts, self.spacing)


@cache
def outline_of(shape: str) -> Outline:
    """Return an object of the study."""
    if shape == BARGE:
        return Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    if shape == TANK:
        turns = np.arange(24) * (math.tau / 24)
        return Outline(12.0 * np.column_stack([np.cos(turns), np.sin(turns)]))
    x = np.linspace(30.0, 60.0, 6)[:-1]
    y = 10.0 * (1.0 - ((x - 30.0) / 30.0) ** 2)
    port = np.column_stack([x, y])[::-1]
    return Outline(
        [(-60, 8), (-60, -8), (-50, -10), *zip(x, -y, strict=True), (60, 0), *port, (-50, 10)]
    )
