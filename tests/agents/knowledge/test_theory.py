"""What holds whatever a robot knows: T29 to T31 and T33, on random states."""

import math
from itertools import combinations

import numpy as np
import pytest

import swarmgrasp as sg
from swarmgrasp.agents.knowledge.beliefs import KNOWN, NOTHING
from swarmgrasp.agents.knowledge.cases import BARGE, FREE, HULL, PUSH, STEER, TANK, Case, outline_of
from swarmgrasp.agents.knowledge.growing import Task, grow
from swarmgrasp.agents.knowledge.unevenness import unevenness

KINDS = [(BARGE, PUSH), (TANK, FREE), (HULL, STEER)]


def groups(shape, kind, seed, count=7):
    """Draw two groups, and both together."""
    rng = np.random.default_rng(seed)
    first, second = (Case(shape, kind, count, 2 * count).start(rng) for _ in range(2))
    names = (f"{robot.name} of the second" for robot in second)
    renamed = [
        sg.Robot(r.contact, r.direction, r.limit, name, steers=r.steers)
        for r, name in zip(second, names, strict=True)
    ]
    return first, second, sg.Swarm(first.outline, [*first, *renamed])


@pytest.mark.parametrize(("shape", "kind"), KINDS)
@pytest.mark.parametrize("seed", range(8))
def test_additions_never_hurt_and_groups_add_up(shape, kind, seed):
    """Q(A) + Q(B) <= Q(A u B) <= Q(A) + R(B) (T29)."""
    first, second, both = groups(shape, kind, seed)
    a, b, together = (sg.quality(swarm).value for swarm in (first, second, both))
    nobody = first.without_rows(range(len(first)))
    reach = b + unevenness(second, nobody)  # R(B) is at most Q(B) + max h - min h
    assert a + b - 1e-9 <= together <= a + reach + 1e-9


@pytest.mark.parametrize(
    "case", [Case(TANK, PUSH, 5, 9), Case(BARGE, FREE, 4, 7), Case(HULL, STEER, 5, 7)]
)
def test_no_decision_falls_shorter_than_what_is_not_known_is_uneven(case):
    """Of every knowledge there is, over whole growths (T30); and some fall short at all."""
    short = []
    for draw in range(3):
        for growth in grow(Task(case, 5, draw)).values():
            short += growth.regrets
            assert all(r <= b for r, b in zip(growth.regrets, growth.bounds, strict=True))
    assert max(short) > 0.1


@pytest.mark.parametrize(("shape", "kind"), KINDS)
def test_departures_are_what_losing_asks_for(shape, kind):
    """The quality after the worst loss of two holds whoever is gone, and is reached (T31)."""
    swarm, _, _ = groups(shape, kind, 4)
    worst = sg.quality(swarm, losing=2).bound
    left = [sg.quality(swarm.without_rows(gone)).value for gone in combinations(range(7), 2)]
    assert min(left) == pytest.approx(worst, abs=1e-6)
    assert min(left) >= worst - 1e-9


@pytest.mark.parametrize("seed", range(6))
def test_a_balanced_belief_is_blind_and_nobody_is_not(seed):
    """Every place is as good to robots that come in opposite pairs (T33).

    The belief that nobody else is there gives a quality that is certain: 0, below any truth.
    """
    rng, outline = np.random.default_rng(seed), outline_of(BARGE)
    contacts = [outline.at_arc_length(s).point for s in rng.uniform(0.0, outline.perimeter, 4)]
    angles = rng.uniform(-math.pi, math.pi, 4)
    pairs = [
        sg.Robot(c, a + turn)
        for c, a in zip(contacts, angles, strict=True)
        for turn in (0.0, math.pi)
    ]
    even = sg.Swarm(outline, pairs)
    answer = sg.place(even, sg.Newcomer(1.0, "free"))
    assert answer.quality == pytest.approx(sg.quality(even).value, rel=1e-9)
    spots = [(outline.at_arc_length(s).point, a) for s in (3.0, 90.0, 111.0) for a in (0.3, 2.0)]
    values = sg.qualities_with(even, [p for p, _ in spots], [a for _, a in spots], 1.0)
    assert values == pytest.approx(answer.quality, rel=1e-9)
    case = Case(BARGE, PUSH, 6, 20)
    nobody = KNOWN[NOTHING](case, even, rng)
    assert sg.quality(nobody).value == 0.0 < answer.quality
