"""What groups tell of themselves, and planning beside it."""

import math

import numpy as np
import pytest
from msgspec.structs import replace

import swarmgrasp as sg
from swarmgrasp.agents.groups import GroupPlanner, Parts, Slots
from swarmgrasp.agents.groups import seeking as sk
from swarmgrasp.agents.groups import slot as sl
from swarmgrasp.agents.knowledge.unevenness import unevenness
from swarmgrasp.agents.protocol.planner import Who
from swarmgrasp.agents.protocol.record import Kind, Place, Row
from swarmgrasp.errors import AgentInvalid, MessageInvalid

BARGE = sg.Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
TANK = sg.Outline([(12 * math.cos(t), 12 * math.sin(t)) for t in np.arange(24) * math.tau / 24])
STEERS = Kind(1.0, "push", 0.5, steers=True)


def mission(outline=BARGE, groups=4, spacing=2.0, present=()):
    """Return a mission and its parts."""
    swarm = sg.Swarm(outline, present)
    problem = sg.Problem(swarm, sg.Newcomer(1.0, "push", 0.5), spacing=spacing)
    return problem, Parts.of(outline, groups, spacing)


def rows_of(parts, group, count, rng, kinds=(None,)):
    """Draw robots of a group."""
    part, found = parts.each[group], []
    for k, share in enumerate((0.5 + np.arange(count)) / count):
        c = parts.outline.at_arc_length(part.start + share * (part.end - part.start))
        kind = kinds[k % len(kinds)]
        steers = 0.5 if kind else 0.0
        turn = 0.0 if kind else rng.uniform(-0.5, 0.5)
        found.append(Row(f"G{group}N{k}", k + 1, Place(*c.point, c.inward + turn, steers), kind))
    return tuple(found)


def told(problem, parts, rng, counts, kinds=(None,)):
    """Return the rows of all groups, and their slots."""
    rows = [rows_of(parts, g, n, rng, kinds) for g, n in enumerate(counts)]
    empty = Slots(problem.swarm, parts)
    slots = [
        GroupPlanner(problem, empty, g).slot(each, f"G{g}N0", 0, 0) for g, each in enumerate(rows)
    ]
    return rows, slots


def robots(rows):
    """Return robots of a mission as robots."""
    return [
        sg.Robot((r.place.x, r.place.y), r.place.direction, name=r.id, steers=r.place.steers)
        for r in rows
    ]


@pytest.mark.parametrize("seed", range(6))
@pytest.mark.parametrize("kinds", [(None,), (None, STEERS)], ids=["rays", "some steer"])
def test_the_truth_lies_between_the_bounds(seed, kinds):
    """Of groups whose robots summaries describe, and of such that they leave out (T29)."""
    rng = np.random.default_rng(seed)
    first = sg.Robot((40.0, 0.0), math.pi, name="first")
    problem, parts = mission(present=[first])
    rows, slots = told(problem, parts, rng, (5, 3, 6, 4), kinds)
    everyone = sg.Swarm(BARGE, [first, *robots(sum(rows, ()))])
    known = Slots(problem.swarm, parts)
    assert all(map(known.merge, slots))
    lower, upper = known.bounds()
    truth = sg.quality(everyone).value
    assert lower - 1e-9 <= truth <= upper + 1e-9
    assert known.count == len(everyone) - 1
    planner = GroupPlanner(problem, known, 2)
    assert 0.0 < planner.lower((*planner.present, *rows[2])) <= truth + 1e-9
    if len(kinds) == 1:
        assert upper - lower < 0.05 * truth


def test_slots_come_in_any_order_and_often():
    """The newest of a group holds; of two with one version everyone takes the same."""
    problem, parts = mission()
    rng = np.random.default_rng(5)
    _, old = told(problem, parts, rng, (5, 3, 6, 4))
    _, new = told(problem, parts, rng, (4, 4, 4, 4))
    newer = [
        sl.Slot(s.group, 1, 0, s.writer, *(getattr(s, f) for f in s.__struct_fields__[4:]))
        for s in new
    ]
    twins = [
        sl.Slot(s.group, 1, 0, "A", *(getattr(s, f) for f in s.__struct_fields__[4:])) for s in old
    ]
    found = set()
    for _ in range(8):
        known, every = Slots(problem.swarm, parts), [*old, *newer, *twins, *old]
        for k in rng.permutation(len(every)):
            known.merge(every[k])
        assert not any(known.merge(slot) for slot in every)
        found.add((tuple(known), known.bounds()))
    assert found == {(tuple(newer), known.bounds())}


@pytest.mark.parametrize("seed", range(4))
def test_a_place_beside_summaries_is_clear_and_loses_next_to_nothing(seed):
    """It lies in the group's part, keeps the spacing, and is nearly as good as any there (T30)."""
    rng = np.random.default_rng(seed)
    problem, parts = mission()
    rows, slots = told(problem, parts, rng, (5, 4, 6, 3))
    known = Slots(problem.swarm, parts)
    for slot in slots:
        known.merge(slot)
    planner = GroupPlanner(problem, known, 1)
    place = planner.place(rows[1], (), Who())
    assert parts.at((place.x, place.y)) == 1
    everyone = sg.Swarm(BARGE, robots(sum(rows, ())))
    assert planner.is_clear(place, [row.place for row in sum(rows, ())])
    best = sg.place(everyone, problem.newcomer, no_go=parts.others({1}), spacing=problem.spacing)
    reached = sg.quality(
        everyone.with_robot(sg.Robot((place.x, place.y), place.direction, name="new"))
    )
    loss = unevenness(everyone, known.everyone) + 2e-4 * best.quality
    assert best.quality - loss <= reached.value <= best.quality * (1.0 + 1e-6)
    full = [Place(*BARGE.at_arc_length(a).point, 0.0) for a in np.arange(50.0, 101.0, 2.0)]
    assert planner.place(rows[1], tuple(full), Who()) is None
    assert planner.place(rows[1], (), Who("", STEERS)) is None
    assert planner.plan(rows[1], ("a", "b"), Who()) is None
    assert planner.mover(rows[1], ("G1N0",), 0.0, 0.0) == ""


def test_alone_a_group_plans_as_all_robots_do():
    """Exactly, while no other group has said anything."""
    problem, parts = mission(groups=2)
    rows = rows_of(parts, 0, 7, np.random.default_rng(2))
    planner = GroupPlanner(problem, Slots(problem.swarm, parts), 0)
    swarm = sg.Swarm(BARGE, robots(rows))
    best = sg.place(swarm, problem.newcomer, no_go=parts.others({0}), spacing=problem.spacing)
    place = planner.place(rows, (), Who())
    assert (place.x, place.y, place.direction) == (*best.robot.contact, best.robot.direction)
    assert planner.lower(rows) == sg.quality(swarm).bound


@pytest.mark.parametrize("outline", [BARGE, TANK], ids=["barge", "tank"])
@pytest.mark.parametrize("groups", [2, 3, 7])
def test_parts_are_never_nearer_than_the_spacing(outline, groups):
    """Of robots anywhere on two parts; every point of the boundary has one group."""
    spacing = 3.0
    parts = Parts.of(outline, groups, spacing)
    points = [
        np.array([outline.at_arc_length(a).point for a in np.linspace(part.start, part.end, 200)])
        for part in parts.each
    ]
    for g, p in enumerate(points):
        assert {parts.at(tuple(point)) for point in p.tolist()} == {g}
        for q in points[:g]:
            assert np.linalg.norm(p[:, None] - q, axis=2).min() >= spacing - 1e-4


def test_what_no_groups_can_be_made_of():
    """A number of groups, a spacing, a mission: each is told."""
    with pytest.raises(AgentInvalid, match="there are 1 groups; there should be 2 to 1000"):
        Parts.of(BARGE, 1, 1.0)
    with pytest.raises(AgentInvalid, match=r"7 groups do not keep 30 m from each other"):
        Parts.of(BARGE, 7, 30.0)
    problem, parts = mission()
    slots = Slots(problem.swarm, parts)
    steering = sg.Problem(problem.swarm, sg.Newcomer(1.0, "push", 0.5, steers=True))
    cautious = sg.Problem(problem.swarm, problem.newcomer, criterion=sg.Criterion(losing=1))
    with pytest.raises(AgentInvalid, match="groups are for robots that push along one ray"):
        GroupPlanner(steering, slots, 0)
    with pytest.raises(AgentInvalid, match="groups know the nominal quality only"):
        GroupPlanner(cautious, slots, 0)


def test_what_no_sound_robot_writes_is_refused():
    """Damaged bytes, counts and qualities that cannot be, a summary of something else."""
    problem, parts = mission()
    _, (slot, *_) = told(problem, parts, np.random.default_rng(1), (5, 3, 6, 4))
    data = sl.encode((slot,))
    assert sl.decode(data) == (slot,)

    for bad in (data[:-1], b"", b"\x91\xc0", data + b"x"):
        with pytest.raises(MessageInvalid, match="are no slots"):
            sl.decode(bad)
    for values in (
        {"count": -1}, {"turn": 1 << 40}, {"writer": "a/b"}, {"least": math.nan}, {"least": 2.0},
        {"most": math.inf}, {"basis": b"1"},
    ):  # fmt: skip
        with pytest.raises(MessageInvalid, match="slots have"):
            sl.decode(sl.encode((replace(slot, **values),)))
    slots = Slots(problem.swarm, parts)
    elsewhere = sg.Summary.empty(TANK).to_bytes()
    for values in (
        {"group": 4},
        {"count": 4},
        {"summary": slot.summary[:-1]},
        {"summary": elsewhere},
    ):
        with pytest.raises(MessageInvalid, match="slots"):
            slots.merge(replace(slot, **values))
    assert list(slots) == []
    assert slots.merge(slot)


@pytest.mark.parametrize(
    "data",
    [
        b"",
        b"\xc0",
        sk.encode_seeking(sk.Elsewhere(1, 2))[:-1],
        sk.encode_seeking(sk.Elsewhere(-1, 2)),
        sk.encode_seeking(sk.Elsewhere(1, 1 << 60)),
        sk.encode_seeking(sk.Seek(1, (("a/b", 1),))),
        sk.encode_seeking(sk.Seek(1, (("A", 1),) * 1001)),
    ],
)
def test_what_no_sound_robot_asks_is_refused(data):
    """Damaged bytes, names and counts that cannot be."""
    with pytest.raises(MessageInvalid):
        sk.decode_seeking(data)
