"""Many robots that hold the object from the start, spread over the parts of all groups."""

import math
from collections.abc import Iterator
from dataclasses import replace

from swarmgrasp.agents.groups import Parts
from swarmgrasp.agents.protocol import Place
from swarmgrasp.agents.simulator.chance import between
from swarmgrasp.errors import NowhereToAttach, ScheduleInvalid
from swarmgrasp.placement import Problem
from swarmgrasp.placement.pieces import Piece

CLOSER = 0.95
"""By what factor distances shrink until all robots of a group have room."""
STEPS = 20
"""Steps in which the next place is looked for, within the distance of two."""

_CROWD = 10  # what chance is drawn for; all else is in world.py


def crowd(problem: Problem, parts: Parts, count: int, seed: int) -> dict[str, Place]:
    """Return places of robots B1, B2 and so on, in directions drawn at random.

    Parameters
    ----------
    problem : Problem
    parts : Parts
    count : int
        Robots; each part has as many as any other, or one more.
    seed : int

    Raises
    ------
    ScheduleInvalid
        If they have no room.
    """
    places: list[Place] = []
    for group in range(len(parts)):
        share = count // len(parts) + (group < count % len(parts))
        try:
            pieces = replace(problem, no_go=(*problem.no_go, *parts.others({group}))).pieces().each
        except NowhereToAttach:
            pieces = ()
        found = _spread(problem, pieces, share)
        if len(found) < share:
            raise ScheduleInvalid(
                f"group {group} has no room for {share} robots at the start, {problem.spacing:g} m "
                "from each other: take fewer robots, or a smaller spacing"
            )
        for (x, y), piece in found:
            direction = between(piece.lo, piece.hi, seed, len(places), _CROWD)
            places.append(Place(x, y, direction))
    return {f"B{k}": place for k, place in enumerate(places, 1)}


def _spread(
    problem: Problem, pieces: tuple[Piece, ...], count: int
) -> list[tuple[tuple[float, float], Piece]]:
    """Return contacts on pieces as far apart along them as they go, and the pieces."""
    length = sum(piece.end - piece.start for piece in pieces)
    apart = length / max(count, 1)
    while True:
        found: list[tuple[tuple[float, float], Piece]] = []
        for contact, piece in _along(problem, pieces, apart / STEPS):
            if len(found) < count and all(
                math.dist(contact, other) >= max(apart * CLOSER, problem.spacing)
                for other, _ in found
            ):
                found.append((contact, piece))
        if len(found) == count or apart < max(problem.spacing, length / (2.0 * count)):
            return found
        apart *= CLOSER


def _along(
    problem: Problem, pieces: tuple[Piece, ...], step: float
) -> Iterator[tuple[tuple[float, float], Piece]]:
    """Yield contacts along pieces, and the piece of each."""
    corners = problem.swarm.outline.corner_arc_lengths
    for piece in pieces:
        for k in range(math.floor((piece.end - piece.start) / step) + 1 if step else 1):
            arc = float(corners[piece.edge]) + piece.start + k * step
            yield problem.swarm.outline.at_arc_length(arc).point, piece
