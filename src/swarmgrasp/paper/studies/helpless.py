"""When a single robot cannot help at all (T17)."""

import math

import numpy as np

from swarmgrasp.outline import Outline
from swarmgrasp.pages.statements import Statement, listed, newtons, percent
from swarmgrasp.paper.draws import FREE, NEWCOMERS, NORMAL, generator, pulling, rectangle
from swarmgrasp.paper.studies.gains import Gains
from swarmgrasp.placement import Problem, place, place_sequence
from swarmgrasp.swarm import Newcomer, Robot, Swarm

BALANCED = 40
"""Balanced swarms drawn."""
SAME = 1e-9
"""Difference of two heights that counts as none, relative to the number of robots [N]."""
REACH = 0.4
"""How far off the middle of its side each robot of the square pulls, in half sides."""


def statements(found: dict[int, Gains], seed: int) -> list[Statement]:
    """State how often one robot cannot help, and when."""
    return [
        _shares(found),
        _why(found),
        _balanced(seed),
        _square(),
    ]


def _shares(found: dict[int, Gains]) -> Statement:
    """State how often no newcomer raises the quality of random draws."""
    free, normal = (
        [float(np.mean(~one.helps[kind])) for one in found.values()] for kind in (FREE, NORMAL)
    )
    return Statement(
        f"No single newcomer raises the quality, whatever its place and direction, on "
        f"{listed([percent(v) for v in free])} of the draws of {listed(list(found))} robots; none "
        f"along the normal does on {listed([percent(v) for v in normal])}.",
        all(0.0 < one <= other for one, other in zip(free, normal, strict=True)),
        rests_on=("T17",),
    )


def _why(found: dict[int, Gains]) -> Statement:
    """State how often that is because the quality is attained at opposite directions."""
    stuck = [(one.before > 0.0) & ~one.helps[FREE] for one in found.values()]
    tied = [
        s & (np.abs(one.opposite - one.before) <= SAME * one.robots)
        for s, one in zip(stuck, found.values(), strict=True)
    ]
    count, explained = sum(int(s.sum()) for s in stuck), sum(int(t.sum()) for t in tied)
    return Statement(
        f"Of the {count} such draws that do hold the object, "
        f"{'all' if explained == count else explained} are equally weak in two opposite "
        "directions: what helps one way cannot help the other.",
        0 < explained <= count,
        rests_on=("T17",),
    )


def balanced(seed: int, number: int) -> Swarm:
    """Draw a balanced swarm: every robot has a partner at its contact that pushes the other way."""
    rng = generator((seed, 0, number))
    pairs = int(rng.integers(3, 9))
    half = pulling((seed, pairs, number)).robots
    turned = [
        Robot(robot.contact, robot.direction + turn)
        for robot, turn in zip(half, rng.uniform(-1.0, 1.0, pairs), strict=True)
    ]
    mates = [Robot(robot.contact, robot.direction + math.pi) for robot in turned]
    return Swarm(rectangle(), [*turned, *mates])


def _balanced(seed: int) -> Statement:
    """State that no single robot helps a balanced swarm."""
    answers = [place(balanced(seed, k), NEWCOMERS[FREE]) for k in range(BALANCED)]
    held = sum(answer.quality_before > 0.0 for answer in answers)
    return Statement(
        f"On none of {BALANCED} random balanced swarms, {held} of them holding the object, does "
        "any newcomer raise the quality.",
        held > 0 and not any(answer.improves for answer in answers),
        rests_on=("T17",),
    )


def square() -> Swarm:
    """Return four robots that pull a square like the sails of a windmill.

    Their quality is min(1, 2 t / sqrt(1 + 2 t^2)) for t = `REACH`, by hand.
    """
    outline = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    t, right = REACH, 0.5 * math.pi
    pulls = [((1, -t), 0.0), ((-1, t), math.pi), ((-t, 1), right), ((t, -1), -right)]
    return Swarm(outline, [Robot(contact, way) for contact, way in pulls], 1.0)


def _square() -> Statement:
    """State that two robots do for a balanced square what one cannot."""
    known = min(1.0, 2.0 * REACH / math.sqrt(1.0 + 2.0 * REACH**2))
    fifth, sixth = place_sequence(Problem(square(), Newcomer(1.0, "pull", 0.0)), 2)
    return Statement(
        f"Four robots that pull a square like the sails of a windmill have quality "
        f"{newtons(fifth.quality_before, 3)}, as worked out by hand. A fifth robot leaves it at "
        f"{newtons(fifth.quality, 3)} wherever it goes; placed so as to prepare for a sixth, the "
        f"two bring it to {newtons(sixth.quality, 3)}.",
        abs(fifth.quality_before - known) <= 1e-9
        and not fifth.improves
        and sixth.quality > known + 0.01,
        rests_on=("T17",),
    )
