"""Newcomers of any kind that may miss their place: best for the worst of where they end up."""

from dataclasses import replace

import numpy as np
import pytest

from swarmgrasp import (
    Criterion,
    Newcomer,
    Outline,
    Problem,
    Robot,
    Stretch,
    Swarm,
    Tolerance,
    Zone,
    place,
    place_together,
    quality,
)
from swarmgrasp.errors import ForceSetUnsupported, RobotInvalid
from swarmgrasp.placement import set_search, spans
from swarmgrasp.placement.cores import Cells, Cores
from swarmgrasp.placement.kept import kept_robot
from tolerant_by_hand import worst_quality

BARGE = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])
FIVE = [
    Robot((-2, 0), 0.1, steers=0.5), Robot((2, 0.3), 3.0), Robot((0, 1), -1.5, steers=1.0),
    Robot((0.5, -1), 1.4, reverse_limit=0.5), Robot((2, -0.7), 2.2, tolerance=Tolerance(0.2, 0.1)),
]  # fmt: skip
CREW = Swarm(BARGE, FIVE)
ADRIFT, BOTH = Tolerance((-0.3, 0.2)), Tolerance(0.2, (-0.2, 0.1), least_limit=0.8)
PULLING = {"steers": True, "reverse_limit": 0.6}
NEWCOMERS = {
    "sector": Newcomer(1.0, "push", 0.5, steers=True, tolerance=BOTH),
    "hardly steers": Newcomer(1.0, "push", 0.05, steers=True, tolerance=BOTH),
    "azimuth": Newcomer(1.0, steers=True, tolerance=BOTH),
    "reverses": Newcomer(1.0, "push", 0.9, reverse_limit=0.7, tolerance=BOTH),
    "steers both ways": Newcomer(1.0, "pull", 0.4, tolerance=ADRIFT, **PULLING),
    "finger": Newcomer(1.0, "push", friction=0.5, tolerance=ADRIFT),
    "ray": Newcomer(1.0, "push", tolerance=BOTH),
}  # fmt: skip


def anywhere(problem, rng, count):
    """Yield newcomers that aim at random places."""
    pieces, newcomer = problem.pieces(), problem.newcomer
    for piece in rng.integers(0, len(pieces.each), count).tolist():
        contact, (lo, hi) = pieces.point_at(piece, float(rng.random())), pieces.rows[piece, 4:6]
        robot = kept_robot(newcomer, contact, float(lo), float(hi))
        if not newcomer.keeps:
            way = float(rng.uniform(lo, hi))
            robot = replace(robot, direction=way, steers=0.0)
        yield robot


@pytest.mark.parametrize("kind", NEWCOMERS)
def test_no_place_is_better(kind):
    """The quality is that of the swarm with it, the bound holds and is near, and it is verified."""
    answer = place(CREW, NEWCOMERS[kind], worst_case=True, gap=1e-4)
    assert answer.quality == pytest.approx(
        quality(answer.swarm_after, worst_case=True).value, rel=1e-9
    )
    assert answer.improves
    assert not answer.stopped_early
    assert answer.gap <= 1e-4
    for robot in anywhere(answer.problem, np.random.default_rng(3), 25):
        value = quality(CREW.with_robot(robot), worst_case=True).value
        assert value <= answer.upper_bound * (1.0 + 2e-7)
    verdict = answer.verify()
    assert verdict, verdict.faults
    assert (
        verdict.unchecked[-1] == "the upper bound of a newcomer that cannot hit its place exactly"
    )


@pytest.mark.parametrize("kind", NEWCOMERS)
def test_pose_by_pose(kind):
    """Drawing all poses gives the same quality, and nowhere a better one."""
    answer = place(CREW, NEWCOMERS[kind], worst_case=True, gap=1e-4)
    near = answer.after.normal
    assert worst_quality(answer.swarm_after, near) == pytest.approx(answer.quality, rel=2e-3)
    for robot in anywhere(answer.problem, np.random.default_rng(4), 6):
        most = answer.upper_bound * (1.0 + 2e-3)
        assert worst_quality(CREW.with_robot(robot), near, most) <= most


@pytest.mark.parametrize("kind", NEWCOMERS)
def test_the_wider_the_worse(kind):
    """From none, where it is what a certain newcomer has, on."""
    newcomer = replace(NEWCOMERS[kind], tolerance=None)
    certain = place(CREW, newcomer, worst_case=True, gap=1e-5)
    before = certain.upper_bound
    turn = 0.0 if kind in ("finger", "steers both ways") else 0.2
    for share in (1e-7, 0.2, 1.0):
        spread = Tolerance((-0.3 * share, 0.2 * share), turn * share)
        answer = place(CREW, replace(newcomer, tolerance=spread), worst_case=True, gap=1e-4)
        assert answer.quality <= before * (1.0 + 1e-9)
        if share == 1e-7:
            assert answer.quality == pytest.approx(certain.quality, rel=2e-4)
        before = answer.upper_bound


DIAMOND = Outline([(2, 0), (0, 1.3), (-2.1, 0), (0.3, -1)])
SURE = Swarm(DIAMOND, [
    Robot(at.point, at.inward + 0.2, steers=0.5)
    for at in map(DIAMOND.at_arc_length, (0.7, 2.0, 4.0, 6.0, 8.0))
])  # fmt: skip


@pytest.mark.parametrize("mounted", [False, True])
@pytest.mark.parametrize("half", [0.5, None])
def test_what_a_drawn_direction_leaves_of_a_sector(mounted, half):
    """A narrower one, as if it were certain, or all of a whole turn; the check trusts nothing."""
    drawn, zones = Tolerance(direction=(-0.1, 0.3)), None
    attachment = "free" if mounted or half is None else "push"
    newcomer = Newcomer(1.0, attachment, None if mounted else half, steers=True, mounted=mounted)
    narrower = newcomer if newcomer.half_angle is None else replace(newcomer, half_angle=0.3)
    bay = [(-0.5, -0.4), (0.5, -0.4), (0.0, 0.5)]
    if mounted:
        widths = ((0.3, 1.3), (0.6, 1.2)) if half else (None, None)
        zones, left = ([Zone(area=bay, directions=width)] for width in widths)
    answer = place(SURE, replace(newcomer, tolerance=drawn), zones, worst_case=True)
    if mounted:
        certain = place(SURE, narrower, left)
        assert answer.quality == pytest.approx(certain.quality, rel=2e-6)
    elif half is None:
        assert answer.quality == pytest.approx(place(SURE, narrower).quality, rel=2e-6)
    else:  # the same turned by the mean of what is drawn
        turned = replace(answer.robot, direction=answer.robot.direction + 0.1, steers=0.3)
        sure = SURE.with_robot(replace(turned, tolerance=None))
        assert answer.quality == pytest.approx(quality(sure).value, rel=1e-8)
    assert answer.gap <= 1e-6
    verdict = answer.verify()
    assert (bool(verdict), verdict.faults, verdict.unchecked) == (True, (), ())


def test_what_hardly_steers_is_an_uncertain_ray():
    """Along the middle of its sector, and so much surer."""
    hardly = Newcomer(1.0, "push", 0.1, steers=True, tolerance=Tolerance(0.1, 0.3))
    ray = Newcomer(1.0, "push", 0.0, tolerance=Tolerance(0.1, 0.2))
    one, other = (place(CREW, each, worst_case=True, gap=1e-5).quality for each in (hardly, ray))
    assert one == pytest.approx(other, rel=2e-5)


def test_steering_and_reversing_never_hurt():
    """Beside the ray along the normal that has the same tolerance."""
    ray = Newcomer(1.0, "push", 0.0, tolerance=BOTH)
    least = place(CREW, ray, worst_case=True, gap=1e-4).quality
    for more in ({"half_angle": 0.4, "steers": True}, {"reverse_limit": 1.0}):
        answer = place(CREW, replace(ray, **more), worst_case=True, gap=1e-4)
        assert answer.upper_bound >= least * (1.0 - 1e-9)
        assert answer.quality >= least * (1.0 - 1e-4)


@pytest.mark.parametrize("kind", ["sector", "reverses", "finger"])
def test_mirror_twins(kind):
    """Seen from below, offsets swapped, the same quality."""

    def turned(tolerance):
        """Return a tolerance seen from below."""
        return tolerance and replace(
            tolerance, contact=tuple(-x for x in tolerance.offsets[::-1]),
            direction=tuple(-x for x in tolerance.turns[::-1]),
        )  # fmt: skip

    twins = [
        replace(
            r,
            contact=(r.contact[0], -r.contact[1]),
            direction=-r.direction,
            tolerance=turned(r.tolerance),
        )
        for r in FIVE
    ]
    newcomer = NEWCOMERS[kind]
    one = place(CREW, newcomer, worst_case=True, gap=1e-5)
    mirrored = replace(newcomer, tolerance=turned(newcomer.tolerance))
    other = place(Swarm(BARGE, twins), mirrored, worst_case=True, gap=1e-5)
    assert other.quality == pytest.approx(one.quality, rel=2e-5)


@pytest.mark.parametrize("kind", NEWCOMERS)
def test_a_cell_is_bounded_by_no_less_than_its_places(kind):
    """Along any normal; where directions graze the edge, what is worst of them is concave on it."""
    rng = np.random.default_rng(5)
    for tolerance in (Tolerance(direction=(-0.1, 0.3)), Tolerance(0.3), BOTH):
        if tolerance.turns[1] and kind in ("finger", "steers both ways"):
            continue
        newcomer = replace(NEWCOMERS[kind], tolerance=tolerance)
        problem = Problem(CREW, newcomer, criterion=Criterion(worst_case=True))
        cores, pieces = Cores(problem, problem.pieces()), problem.pieces().each
        rows = []
        for k in rng.integers(0, len(pieces), 200).tolist():
            piece, (start, end) = pieces[k], np.sort(rng.random(2))
            lo, hi = np.sort(rng.uniform(piece.lo, piece.hi) + rng.uniform(0.0, 0.3, 2))
            hi = lo = 0.5 * (piece.lo + piece.hi) if newcomer.keeps else lo
            base, length = cores.corner_arcs[piece.edge] + piece.start, piece.end - piece.start
            rows.append((k, base + start * length, base + end * length, lo, hi))
        cells = Cells(*np.array(rows).T)
        normals = rng.normal(size=(60, 3))
        bounds = cores.gains(cells, normals)
        for share in rng.random((6, 2)):
            at = cells.start + share[0] * (cells.end - cells.start)
            way = cells.lo + share[1] * (cells.hi - cells.lo)
            inside = cores.gains(Cells(cells.piece, at, at, way, way), normals)
            assert (inside <= bounds + 1e-9).all()


def test_bollards_and_runners_up():
    """Single points are places too, each looked at, the contact around it."""
    marks = [Zone(Stretch(s, s, f"at {s}")) for s in (0.5, 2.0, 5.0, 7.5, 10.0)]
    newcomer = NEWCOMERS["azimuth"]
    answer = place(CREW, newcomer, marks, worst_case=True, runners_up=0.0)
    values = {}
    for mark in marks:
        (robot,) = anywhere(Problem(CREW, newcomer, (mark,)), np.random.default_rng(1), 1)
        values[mark.name] = quality(CREW.with_robot(robot), worst_case=True).value
    best = max(values, key=values.get)
    assert (answer.place, answer.quality) == (best, pytest.approx(values[best], rel=1e-9))
    for runner in answer.runners_up:
        assert runner.quality == pytest.approx(values[runner.place], rel=1e-9)
    assert len(answer.runners_up) == 4
    assert answer.verify(), answer.verify().faults


def test_the_work_ends(monkeypatch):
    """The answer says so, and its bound holds."""
    monkeypatch.setattr(spans, "WORK", 1e5)
    monkeypatch.setattr(set_search, "WORK", 1e5)
    answer = place(CREW, NEWCOMERS["sector"], worst_case=True)
    assert answer.stopped_early
    for robot in anywhere(answer.problem, np.random.default_rng(6), 20):
        assert quality(CREW.with_robot(robot), worst_case=True).value <= answer.upper_bound
    assert answer.verify(), answer.verify().faults


def test_several_that_miss_their_places():
    """Together, with a bound of newcomers that hit their places."""
    problem = Problem(CREW, NEWCOMERS["sector"], criterion=Criterion(worst_case=True))
    answer = place_together(problem, 2, effort=20)
    assert answer.quality == pytest.approx(
        quality(answer.swarm_after, worst_case=True).value, rel=1e-9
    )
    assert answer.quality >= answer.sequential * (1.0 - 1e-9)


@pytest.mark.parametrize(
    ("newcomer", "kind"),
    [
        (Newcomer(1.0, "push", friction=0.5), "friction"),
        (Newcomer(1.0, "push", 0.4, steers=True, reverse_limit=0.5), "steering both ways"),
        (Newcomer(mounted=True), "a place inside"),
    ],
)
def test_a_direction_that_is_not_known_how_to_bound(newcomer, kind):
    """The same kinds as of robots already there, in the same words; only in the worst case."""
    newcomer = replace(newcomer, tolerance=Tolerance(direction=0.1))
    with pytest.raises(ForceSetUnsupported, match=f"the worst direction of what has {kind} is not"):
        place(CREW, newcomer, worst_case=True)
    assert place(Swarm(BARGE, FIVE[:4]), newcomer, gap=1e-2).quality > 0.0


def test_what_is_mounted_stays_where_it_is():
    """A newcomer as well as a robot."""
    with pytest.raises(RobotInvalid, match="its tolerance can have no contact"):
        Newcomer(mounted=True, tolerance=Tolerance(0.1))
