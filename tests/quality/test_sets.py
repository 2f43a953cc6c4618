"""The quality of robots that steer, reverse, or have friction: sets of forces (T20)."""

import itertools
import json
import math
from pathlib import Path

import numpy as np
import pytest

from reference import quality_of_sets
from swarmgrasp import (
    Criterion,
    Ellipsoid,
    Outline,
    Polytope,
    Robot,
    Swarm,
    Tolerance,
    losses,
    quality,
)
from swarmgrasp.errors import CriterionInvalid, RobotInvalid
from swarmgrasp.quality.aim import Aim
from swarmgrasp.quality.criterion import NOMINAL

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
FILE = Path(__file__).parent.parent / "data" / "steering.json"
CASES = json.loads(FILE.read_text(encoding="utf-8"))["qualities"]
MIDDLES = [((1, 0), math.pi), ((-1, 0), 0.0), ((0, 1), -math.pi / 2), ((0, -1), math.pi / 2)]
CORNERS = [(1, 1), (-1, 1), (-1, -1), (1, -1)]


def swarm_of(case):
    """Return the swarm of a reference case."""
    robots = []
    for row in case["robots"]:
        lo, hi = row["directions"]
        steers = min(math.pi, 0.5 * (hi - lo))
        robots.append(
            Robot(
                row["contact"], 0.5 * (lo + hi), row["limit"], steers=steers,
                reverse_limit=row["reverse_limit"],
            )
        )  # fmt: skip
    outline = Outline(case["outline"])
    return Swarm(outline, robots, characteristic_length=case["characteristic_length"])


def unit(robots):
    """Return robots on the square, in the unit metric."""
    return Swarm(SQUARE, robots, characteristic_length=1.0)


@pytest.mark.parametrize("number", range(len(CASES)))
def test_reference_values(number):
    """Another program found the same, after the worst losses too."""
    case, keys = CASES[number], ("quality", "quality_after_losing_1", "quality_after_losing_2")
    swarm = swarm_of(case)
    for losing, key in enumerate(keys):
        if key in case:
            found = quality(swarm, losing=losing)
            assert found.value == pytest.approx(case[key], rel=1e-7, abs=1e-8)
            assert found.value * (1.0 - 2e-7) <= found.bound <= found.value


def test_two_azimuths_close_a_grasp():
    """Their quality is 2 u r / sqrt(1 + r^2), and 0 without either."""
    pair = unit([Robot((x, 0), 0.0, 3.0, steers=math.pi) for x in (1.0, -1.0)])
    found = quality(pair)
    assert found.value == pytest.approx(6.0 / math.sqrt(2.0), rel=1e-9)
    assert found.is_force_closure
    assert quality(pair, losing=1).value == 0.0


def test_azimuths_at_the_corners():
    """They are weakest at a pole, where one of them adds nothing."""
    swarm = unit([Robot(corner, 0.0, steers=math.pi) for corner in CORNERS])
    values = [quality(swarm, losing=k).value for k in range(3)]
    root = math.sqrt(3.0)
    wanted = [(4.0 + 2.0 * math.sqrt(2.0)) / root, 4.0 / root, 2.0 / root]
    assert values == pytest.approx(wanted, rel=1e-8)


@pytest.mark.parametrize(
    ("steers", "wanted"),
    [
        (math.pi / 6, 2.0 * math.sqrt(6.0) / 3.0),
        (math.pi / 2, (3.0 + 3.0 * math.sqrt(2.0)) / math.sqrt(6.0)),
    ],
)
def test_sectors_at_the_middles(steers, wanted):
    """Four tugs that push in, each within a sector; of half a turn exactly, too."""
    swarm = unit([Robot(contact, way, steers=steers) for contact, way in MIDDLES])
    assert quality(swarm).value == pytest.approx(wanted, rel=1e-8)


@pytest.mark.parametrize("steers", [0.0, 0.3, 1.2, math.pi])
def test_halves_of_a_thruster_are_the_thruster(steers):
    """Of one that reverses, too; losing the group that they are loses both."""
    rng = np.random.default_rng(5)
    whole, halves = [], []
    for k, s in enumerate(rng.uniform(0.0, 8.0, 7)):
        point, way = SQUARE.at_arc_length(s).point, rng.uniform(-math.pi, math.pi)
        if steers == 0.0:
            whole.append(Robot(point, way, 1.0, reverse_limit=0.6))
            parts = [(way, 1.0), (way + math.pi, 0.6)]
        else:
            whole.append(Robot(point, way, 1.0, steers=steers))
            parts = [(way, 0.5), (way, 0.5)]
        halves += [Robot(point, a, u, steers=steers, group=f"bus {k}") for a, u in parts]
    for losing in range(3):
        found = quality(unit(halves), losing=losing)
        assert found.value == pytest.approx(quality(unit(whole), losing=losing).value, rel=1e-8)
        assert len(found.lost) == losing or (found.value == 0.0 and len(found.lost) < losing)
        assert all(name.startswith("bus ") for name in found.lost)
        assert len(found.worst_swarm) == len(halves) - 2 * len(found.lost)


@pytest.mark.parametrize("seed", range(6))
def test_a_sector_is_worth_what_it_holds(seed):
    """It contains its rays, widening it never hurts, and fans of rays bound it from both sides.

    Of a fan of n rays that share a sector, each of the limit times the sine or the tangent of half
    of what is between two, the first lies within it and the second around it.
    """
    rng = np.random.default_rng(seed)
    tugs = [(SQUARE.at_arc_length(s), rng.uniform(-0.5, 0.5)) for s in rng.uniform(0.0, 8.0, 8)]

    def of(steers, fan=0, limit=1.0):
        """Return the quality of the tugs, each steering or a fan of rays."""
        turns = [0.0] if not fan else steers * (2.0 * np.arange(fan) + 1.0 - fan) / fan
        limits = limit if not fan else limit * np.ones(fan)
        return quality(
            unit(
                [
                    Robot(at.point, at.inward + off + t, u, steers=0.0 if fan else steers)
                    for at, off in tugs
                    for t, u in zip(turns, np.broadcast_to(limits, len(turns)), strict=True)
                ]
            )
        ).value

    values = [of(steers) for steers in (0.0, 0.2, 0.5, 1.0, 2.0, math.pi)]
    assert all(b >= a * (1.0 - 2e-9) for a, b in itertools.pairwise(values))
    inside, disc, outside = (
        of(math.pi, 32, math.sin(math.pi / 32)),
        values[-1],
        of(math.pi, 32, math.tan(math.pi / 32)),
    )
    assert inside <= disc * (1.0 + 1e-9)
    assert disc <= outside * (1.0 + 1e-9)
    assert outside <= 1.01 * inside


def test_a_disc_is_a_disc_whichever_way_it_turns():
    """The direction of an azimuth thruster is without meaning."""
    values = [
        quality(unit([Robot(c, turn, steers=math.pi) for c in CORNERS])).value
        for turn in (0.0, 1.0, -2.5)
    ]
    assert values == pytest.approx(values[:1] * 3, rel=1e-9)


@pytest.mark.parametrize("number", [5, 12, 60])
@pytest.mark.parametrize("arm", [0.3, 0.5, 1.5])
def test_rings_of_azimuths(number, arm):
    """N r where they are near, N where they are far: whole curves of minima."""
    turns = math.tau * np.arange(number) / number
    hull = Outline(2.0 * np.array(CORNERS))
    points = arm * np.column_stack([np.cos(turns), np.sin(turns)])
    ring = [Robot(tuple(p), 0.0, steers=math.pi, mounted=True) for p in points.tolist()]
    found = quality(Swarm(hull, ring, characteristic_length=1.0))
    assert found.value == pytest.approx(number * min(arm, 1.0), rel=2e-7)
    assert found.bound >= found.value * (1.0 - 2e-7)


def test_azimuths_at_one_place_and_on_a_line():
    """At one place they are nothing; on a line through the origin at most the sum of arms."""
    place = [Robot((1, 0.3), 0.0, u, steers=math.pi) for u in (1.0, 2.0, 3.0)]
    assert quality(unit(place)).value == 0.0
    line = [Robot((x, 0.0), 0.0, steers=math.pi, mounted=True) for x in np.linspace(-1, 1, 7)]
    assert quality(unit(line)).value == pytest.approx(4.0, rel=1e-7)


def test_a_drillship_of_azimuths():
    """Six thrusters of 1.5 N, and the worst loss of one: 40 descents found the same."""
    vertices = [
        (-1.30, -0.14), (-1.18, -0.22), (0.80, -0.22), (1.05, -0.17), (1.22, -0.08), (1.30, 0.0),
        (1.22, 0.08), (1.05, 0.17), (0.80, 0.22), (-1.18, 0.22), (-1.30, 0.14),
    ]  # fmt: skip
    places = [
        (1.0678, 0.0), (0.9344, 0.11), (0.9344, -0.11), (-1.1644, 0.0), (-0.9911, -0.1644),
        (-0.9911, 0.1644),
    ]  # fmt: skip
    ship = Swarm(
        Outline(vertices, origin=(0.0, 0.0)),
        [Robot(c, 0.0, 1.5, steers=math.pi, mounted=True) for c in places],
        characteristic_length=1.0,
    )
    assert quality(ship).value == pytest.approx(6.75608, abs=1e-5)
    assert quality(ship, losing=1).value == pytest.approx(4.57225, abs=1e-5)


def test_tugs_that_steer_hold_a_barge():
    """Two a side that push within 30 degrees of square; frozen, they hold nothing."""
    barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    places = [((-30, -10), 0.5), ((30, -10), 0.5), ((30, 10), -0.5), ((-30, 10), -0.5)]

    def tugs(steers):
        return Swarm(barge, [Robot(c, a * math.pi, 300e3, steers=steers) for c, a in places])

    assert quality(tugs(math.pi / 6)).value == pytest.approx(404.145e3, rel=1e-6)
    assert quality(tugs(0.0)).value == 0.0
    said = quality(tugs(math.pi / 6)).explanation
    assert "limit" in said
    assert "span" not in said


def test_fingers_with_friction():
    """One normal force a finger, not two edges of a cone with a limit each."""
    block = Outline([(-1, -0.5), (1, -0.5), (1, 0.5), (-1, 0.5)])
    fingers = [
        Robot((1, 0.2), math.pi, friction=0.5), Robot((-1, 0), 0.0, friction=0.5),
        Robot((0, -0.5), 0.5 * math.pi, friction=0.5),
    ]  # fmt: skip
    assert quality(Swarm(block, fingers)).value == pytest.approx(0.470588, abs=1e-5)
    pair = [Robot((1, 0), math.pi, friction=0.5), fingers[1]]
    assert quality(Swarm(block, pair)).value == pytest.approx(0.554700, abs=1e-5)


def test_named_failures():
    """The worst of them happens; it takes groups and robots, by name, before any loss."""
    rng = np.random.default_rng(8)
    robots = [
        Robot(SQUARE.at_arc_length(s).point, a, steers=1.0, group="bus A" if k < 2 else "")
        for k, (s, a) in enumerate(zip(rng.uniform(0, 8, 7), rng.uniform(-3, 3, 7), strict=True))
    ]
    swarm = unit(robots)
    named = [("bus A",), ("R3", "R4")]
    after = [quality(swarm.without(gone)).value for gone in (("R1", "R2"), ("R3", "R4"))]
    found = quality(swarm, failures=named)
    assert found.value == pytest.approx(min(after), rel=1e-8)
    assert found.failure == named[int(np.argmin(after))]
    assert len(found.worst_swarm) == 5
    assert Criterion.from_data(found.criterion.to_data()) == found.criterion
    with pytest.raises(CriterionInvalid, match="'bus B', which is no robot and no group"):
        quality(swarm, failures=[("bus B",)])
    with pytest.raises(CriterionInvalid, match="each should be a list of names"):
        quality(swarm, failures=["bus A"])


def test_losses_name_machines():
    """Robots of a group are lost as one, and named by their group."""
    groups = ["bus A", "bus A", "", ""]
    rows = [Robot(c, a, steers=1.0, group=g) for (c, a), g in zip(MIDDLES, groups, strict=True)]
    found = losses(unit(rows))
    assert sorted(loss.name for loss in found) == ["R3", "R4", "bus A"]
    assert found[0].quality == pytest.approx(quality(unit(rows), losing=1).value, rel=1e-9)


def test_closure_within_the_noise_of_rounded_coordinates():
    """What opposes all robots for certain is none; what rounding decides is marginal."""
    turns = math.tau * np.arange(12) / 12
    tank = Outline((3.0 * np.column_stack([np.cos(turns), np.sin(turns)])).round(3))
    spots = [tank.on_edge(edge, 0.5 * tank.lengths[edge]) for edge in (0, 3, 6, 9)]

    def closure(steers, count=4):
        tugs = [Robot(at.point, at.inward, steers=steers) for at in spots[:count]]
        return str(quality(Swarm(tank, tugs)).force_closure)

    assert [closure(steers) for steers in (0.0, 1e-4, 0.3)] == ["marginal", "marginal", "yes"]
    assert closure(0.3, count=2) == "no"
    assert closure(math.pi, count=1) == "no"


@pytest.mark.parametrize("drift", [0.1, 0.4])
def test_the_worst_of_two_azimuths_that_may_drift(drift):
    """Along the line between them: the same with a shorter arm; they steer once they know."""
    bar = Outline([(-2, -0.001), (2, -0.001), (2, 0.001), (-2, 0.001)])
    pair = [
        Robot((x, 0.001), 0.0, steers=math.pi, tolerance=Tolerance(contact=drift))
        for x in (-1.0, 1.0)
    ]
    found = quality(Swarm(bar, pair, characteristic_length=1.0), worst_case=True)
    arm = 1.0 - drift
    assert found.value == pytest.approx(2.0 * arm / math.sqrt(1.0 + arm * arm), rel=1e-5)
    assert found.bound >= found.value * (1.0 - 2e-7)
    assert [abs(robot.contact[0]) for robot in found.worst_swarm] == pytest.approx([arm] * 2)


def test_the_worst_direction_of_what_steers():
    """A sector keeps what it has in every direction it may be drawn; or it is an uncertain ray."""
    tugs = [(c, a, 0.5) for c, a in MIDDLES]

    def worst(steers, tolerance):
        robots = [
            Robot(c, a, steers=s * steers, tolerance=Tolerance(direction=tolerance))
            for c, a, s in tugs
        ]
        return quality(unit(robots), worst_case=True).value

    def certain(steers):
        return quality(unit([Robot(c, a, steers=steers) for c, a in MIDDLES])).value

    assert worst(1.2, 0.25) == pytest.approx(certain(0.35), rel=1e-7)
    assert worst(0.4, 0.3) == pytest.approx(worst(0.0, 0.1), abs=1e-9)
    held = Robot((1, 0), math.pi, friction=0.5, tolerance=Tolerance(direction=0.1))
    with pytest.raises(RobotInvalid, match="leave out the tolerance of its direction"):
        quality(unit([held]), worst_case=True)


KINDS = [
    {}, {"steers": math.pi / 6}, {"steers": math.pi / 2}, {"steers": 2.5}, {"steers": math.pi},
    {"reverse_limit": 0.6}, {"reverse_limit": 0.6, "steers": 0.4}, {"friction": 0.5},
    {"least": 0.3}, {"least": 0.3, "steers": 0.4},
    {"envelope": [(1.0, 0.2), (0.5, 0.9), (-0.4, 0.1), (0.3, -0.7)]},
]  # fmt: skip


def mix(rng):
    """Return a swarm of some kinds, at random or degenerate places, and terms to ask it by."""
    chosen = [KINDS[k] for k in rng.integers(0, len(KINDS), rng.integers(1, 4))]
    n, robots = int(rng.integers(2, 16)), []
    is_grid = rng.random() < 0.3
    for _ in range(n):
        at = SQUARE.at_arc_length(float(rng.integers(0, 16)) / 2 if is_grid else rng.uniform(0, 8))
        way = at.inward + (0.0 if rng.random() < 0.5 else rng.uniform(-math.pi, math.pi))
        fields = dict(chosen[rng.integers(len(chosen))])
        group = f"bus {rng.integers(3)}" if rng.random() < 0.2 else ""
        limit = 1.0 if "envelope" in fields else float(rng.choice([1.0, rng.uniform(0.4, 2.0)]))
        robots += [Robot(at.point, way, limit, group=group, **fields)] * int(
            1 + (rng.random() < 0.1)
        )
    terms = {"losing": int(rng.choice([0, 0, 1, 2]))}
    if rng.random() < 0.2:
        terms["load"] = tuple((0.3 * rng.normal(size=3)).tolist())
    if rng.random() < 0.3:
        task = Polytope if rng.random() < 0.5 else Ellipsoid
        terms["task"] = task(rng.normal(size=(int(rng.integers(1, 5)), 3)))
    if rng.random() < 0.1:
        terms["failures"] = (("R1",), ("R1", "R2"))
    return unit(robots), terms


def check_mix(seed, descents):
    """Compare with the least that a search without a proof finds."""
    swarm, terms = mix(np.random.default_rng(seed))
    found = quality(swarm, **terms)
    truth = quality_of_sets(swarm, seed, found.direction, descents, **terms)
    slack = 1e-11 * len(swarm) / (1.0 if found.criterion.task is None else 1e-6)
    assert truth >= found.bound - slack, seed
    assert found.value <= truth * (1.0 + 1e-7) + slack, seed
    assert found.bound >= found.value * (1.0 - 2e-7) - slack, seed


@pytest.mark.parametrize("seed", [*range(25), 8239])
def test_every_mix_of_kinds_and_criteria(seed):
    """No direction has less than the bound, and none that was looked at less than the value.

    In the last a robot that always exerts something is lost with another of its group.
    """
    check_mix(seed, 2)


def test_an_azimuth_has_no_seam():
    """Rounding may leave its circle open where it starts: along that, too, it exerts its limit."""
    alone = unit([Robot((1, -1), 2.356194490192345, steers=math.pi)])
    normal = np.array([[-0.7071067811865474, 0.7071067811865476, 9.182338818237e-17]])
    found = Aim(alone, NOMINAL, as_sets=True).levels(normal)[0, 0]
    assert found == pytest.approx(1.0, rel=1e-12)


@pytest.mark.long
@pytest.mark.parametrize("block", range(20))
def test_many_mixes(block):
    """The same for 10 000 of them."""
    for seed in range(100 + 500 * block, 600 + 500 * block):
        check_mix(seed, int(seed % 20 == 0))
