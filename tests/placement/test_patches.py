"""Mounted newcomers that keep all they can exert: azimuth thrusters inside the outline."""

import copy
import math

import numpy as np
import pytest
from shapely import Point, Polygon

from swarmgrasp import (
    Ellipsoid,
    Newcomer,
    Outline,
    Polytope,
    Problem,
    Robot,
    Swarm,
    Tolerance,
    Zone,
    cell_qualities,
    place,
    place_sequence,
    place_together,
    quality,
)
from swarmgrasp.answer_file import document_of
from swarmgrasp.errors import ForceSetUnsupported
from swarmgrasp.linear import minimise
from swarmgrasp.placement.patches import mixture_against
from swarmgrasp.plot import plan
from swarmgrasp.verify import verify_document
from swarmgrasp.verify.digest import digest_of

HULL = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])
L_SHAPE = Outline([(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)])
ROUND = Outline(
    [(2 * math.cos(t), math.sin(t)) for t in np.linspace(0.0, math.tau, 181)[:-1].tolist()]
)
KINDS = ["random", "round", "notched", "doubles", "giant", "strong"]


def random_problem(rng, kind, **terms):
    """Return a question of one kind of degenerate or random swarm."""
    outline = {"round": ROUND, "notched": L_SHAPE}.get(kind, HULL)
    robots = []
    for k in range(int(rng.integers(0, 6))):
        at = outline.at_arc_length(float(rng.random() * outline.perimeter))
        limit = 1e4 if kind == "giant" and k == 0 else float(rng.choice([1.0, 0.7]))
        back = float(rng.choice([0.0, 0.5]))
        steers = float(rng.choice([0.0, 0.3, math.pi / 2, math.pi]))
        robots.append(
            Robot(at.point, float(rng.uniform(-3, 3)), limit, steers=steers, reverse_limit=back)
        )
        robots += [robots[-1]] * (kind == "doubles")
    limit = 1e3 if kind == "strong" else 1.0
    newcomer = Newcomer(
        limit, steers=True, mounted=True, reverse_limit=float(rng.choice([0.0, 0.6]))
    )
    zones = None
    if rng.random() < 0.6:
        x, y = outline.vertices.min(axis=0).tolist()
        corner = [(x + dx, y + dy) for dx, dy in [(0.1, 0.1), (0.9, 0.1), (0.9, 0.9), (0.5, 0.3)]]
        ways = None if rng.random() < 0.5 else (0.3, 0.3 + float(rng.choice([0.1, 1.0, 4.0])))
        zones = (Zone(area=corner if kind != "round" else [(-1, -0.5), (1, 0.5), (-1, 0.4)],
                      directions=ways, name="bay"),)  # fmt: skip
    return Problem(Swarm(outline, robots), newcomer, zones, **terms)


def best_on_a_grid(problem, side):
    """Return the best quality with the newcomer at the points of a grid, and at the corners."""
    (zone,) = problem.zones or (Zone(area=problem.swarm.outline.vertices.tolist()),)
    shape, (lo, hi) = Polygon(zone.area), zone.turns(0.0)
    x, y, to_x, to_y = shape.bounds
    grid = [
        (a, b)
        for a in np.linspace(x, to_x, side).tolist()
        for b in np.linspace(y, to_y, side).tolist()
        if shape.covers(Point(a, b))
    ]
    best, newcomer = 0.0, problem.newcomer
    for point in [*grid, *zone.area[:40]]:
        robot = Robot(
            point, 0.5 * (lo + hi), newcomer.limit, mounted=True, steers=0.5 * (hi - lo),
            reverse_limit=newcomer.reverse_limit,
        )  # fmt: skip
        swarm = problem.swarm.with_robot(robot)
        best = max(best, quality(swarm, **problem.criterion.keywords).value)
    return best


@pytest.mark.parametrize("kind", KINDS)
def test_no_place_of_a_grid_is_better(kind):
    """Random and degenerate swarms: the bound holds, is near, and passes its check."""
    for seed in range(4):
        problem = random_problem(np.random.default_rng([seed, 5]), kind)
        answer = place(problem)
        size = float(problem.swarm.limits.sum()) + problem.newcomer.limit
        assert best_on_a_grid(problem, 9) <= answer.upper_bound * (1.0 + 1e-9) + 1e-11 * size
        near = 1e-4 if answer.stopped_early else 1e-6
        far = 0.03 if answer.stopped_early and answer.quality == 0.0 else 1e-11
        assert answer.upper_bound <= answer.quality * (1.0 + near) + far * size
        verdict = answer.verify()
        assert verdict, (seed, verdict.faults)


@pytest.mark.parametrize("reach", [0.3, 1.0, 1.9])
def test_two_azimuths(reach):
    """Opposite each other, r from the middle, they hold 2 r / sqrt(1 + r^2), a closed form."""
    swarm = Swarm(
        HULL, [Robot((-reach, 0.0), 0.0, mounted=True, steers=math.pi)], characteristic_length=1.0
    )
    line = Zone(area=[(-0.1, 0.0), (reach, 0.0)], name="line")
    answer = place(swarm, Newcomer(steers=True, mounted=True), [line])
    assert answer.robot.contact == pytest.approx((reach, 0.0), abs=1e-9)
    assert answer.quality == pytest.approx(2.0 * reach / math.hypot(1.0, reach), rel=1e-9)
    assert answer.verify()


@pytest.mark.parametrize(
    "terms",
    [
        {"losing": 1}, {"losing": 2}, {"load": (0.3, 0.2, -0.1)}, {"worst_case": True},
        {"task": Ellipsoid([(1, 0, 0), (0, 2, 0), (0, 0, 0.5)])},
        {"task": Polytope([(1, 0, 0), (0, 1, 0), (-1, -1, 0), (0, 0, 1), (0, 0, -1)])},
        {"failures": [["bus"], ["R4"]]},
    ],
)  # fmt: skip
def test_criteria(terms):
    """By every criterion the bound holds; and but for named failures it passes its check."""
    crew = [
        Robot((-2, 0.5), 0.1, tolerance=Tolerance(0.1)), Robot((2, 0.2), 3.0, steers=0.5),
        Robot((-1, -1), 1.2, group="bus"), Robot((1, 1), -1.8, group="bus"), Robot((0, -1), 1.6),
        Robot((0.5, 0.1), 0.0, mounted=True, steers=math.pi),
    ]  # fmt: skip
    bay = Zone(area=[(-1.5, -0.5), (1.5, -0.5), (1.5, 0.5)], name="bay")
    answer = place(Swarm(HULL, crew), Newcomer(steers=True, mounted=True), [bay], **terms)
    assert best_on_a_grid(answer.problem, 9) <= answer.upper_bound * (1.0 + 1e-7)
    assert answer.gap <= 1e-6 or answer.stopped_early
    if "failures" not in terms:
        verdict = answer.verify()
        assert verdict, verdict.faults


@pytest.mark.parametrize(
    "area", [[(1.0, 0.5)], [(0.3, 0.3), (0.3, 1.7)], [(0.2, 0.2), (0.9, 0.2), (0.5, 0.2 + 1e-13)]]
)
def test_spots_lines_and_slivers(area):
    """One corner is a spot, and two are a line; the sector is that of the zone."""
    crew = [Robot((3, 0.5), 3.0), Robot((0, 0.5), 0.3), Robot((0.5, 2), -1.4, steers=0.4)]
    zone = Zone(area=area, name="here", directions=(0.2, 2.2))
    answer = place(Swarm(L_SHAPE, crew), Newcomer(steers=True, mounted=True), [zone])
    low, high = np.min(area, axis=0) - 1e-9, np.max(area, axis=0) + 1e-9
    assert ((low <= answer.robot.contact) & (answer.robot.contact <= high)).all()
    assert (answer.robot.direction, answer.robot.steers) == pytest.approx((1.2, 1.0))
    verdict = answer.verify()
    assert verdict, verdict.faults


def test_one_after_the_other_and_elsewhere():
    """The first of two alone holds nothing; the other areas are runners-up, by their labels."""
    bays = [
        Zone(area=[(x, -0.5), (x + 0.8, -0.5), (x + 0.8, 0.5), (x, 0.5)], name="bay")
        for x in (-1.9, -0.4, 1.1)
    ]
    answers = place_sequence(
        Problem(Swarm(HULL, []), Newcomer(2.0, "free", steers=True, mounted=True), bays), 3,
        runners_up=0.0,
    )  # fmt: skip
    assert [answer.quality > 0.0 for answer in answers] == [False, True, True]
    assert {answers[2].place, *(r.place for r in answers[2].runners_up)} == {
        "bay (1)", "bay (2)", "bay (3)",
    }  # fmt: skip
    assert all(answer.verify() for answer in answers)
    assert "proven" in answers[1].explanation
    assert plan(answers[1].swarm_after).axes


def test_a_budget_that_ends_leaves_a_bound(monkeypatch):
    """It is said, holds, and passes its check."""
    monkeypatch.setattr("swarmgrasp.placement.patches.WORK", 3e5)
    problem = random_problem(np.random.default_rng([2, 5]), "notched")
    answer = place(problem)
    assert answer.stopped_early
    assert best_on_a_grid(problem, 9) <= answer.upper_bound
    assert verify_document(document_of(answer))


def test_what_is_not_known_is_refused():
    """Several at once inside, and a landscape."""
    inside = Problem(Swarm(HULL, []), Newcomer(steers=True, mounted=True))
    with pytest.raises(ForceSetUnsupported, match="mounted"):
        place_together(inside, 2)
    with pytest.raises(ForceSetUnsupported, match="inside"):
        cell_qualities(inside, (4, 4))


def test_games_are_worth_what_a_linear_program_says():
    """Rows and columns mixed against each other, of few to many rows and one to three columns."""
    rng = np.random.default_rng(3)
    for case in range(60):
        rows, columns = int(rng.integers(1, 30)), 1 + case % 3
        values = rng.normal(size=(rows, columns)) * float(10.0 ** rng.integers(-6, 7))
        values[rng.random((rows, columns)) < 0.2] = float(np.abs(values).max())
        value, chosen, weights, shares = mixture_against(values)
        matrix = np.column_stack([values.T, -np.ones(columns)])
        matrix = np.vstack([matrix, np.append(np.ones(rows), 0.0)])
        bounds = (np.append(np.full(columns, -np.inf), 1.0), np.append(np.zeros(columns), 1.0))
        free = (np.append(np.zeros(rows), -np.inf), np.full(rows + 1, np.inf))
        least = float(minimise(np.append(np.zeros(rows), 1.0), matrix, bounds, free)[-1])
        size = float(np.abs(values).max())
        assert value == pytest.approx(least, rel=1e-9, abs=1e-9 * size)
        assert (weights @ values[chosen]).max() == value
        assert (values @ shares).min() == pytest.approx(value, rel=1e-8, abs=1e-8 * size)


def _spoil(placed, how):
    """Change a placement's claims so that they do not hold."""
    robot, patches = placed["robot"], placed["patches"]
    if how == "a patch is missing":
        patches.remove(max(patches, key=lambda p: Polygon(p["corners"]).area))
    elif how == "a patch is smaller":
        patch = max(patches, key=lambda p: Polygon(p["corners"]).area)
        patch["corners"][0] = np.mean(patch["corners"], axis=0).tolist()
    elif how == "a sector is narrower":
        for patch in patches:
            patch["hi"] -= 0.1
    elif how == "all normals are one":
        for patch in patches:
            patch["normals"] = [[1.0, 0.0, 0.0]] * len(patch["normals"])
    elif how == "a weight is negative":
        patches[0]["weights"][0] *= -1.0
    elif how == "all travel":
        for patch in patches:
            patch["kind"] = "travelling"
    elif how == "no patches":
        patches.clear()
    elif how == "the bound is lower":
        placed["upper_bound"] *= 0.999
    elif how == "the quality is higher":
        placed["quality"] = placed["upper_bound"] = placed["quality"] * 1.001
    elif how == "the robot is elsewhere":
        robot["contact"] = [1.9, 0.9]
    elif how == "the robot steers more":
        robot["steers"] += 0.1
    elif how == "the robot is not mounted":
        robot["mounted"] = False


@pytest.mark.parametrize(
    "how",
    [
        "a patch is missing", "a patch is smaller", "a sector is narrower", "all normals are one",
        "a weight is negative", "all travel", "no patches", "the bound is lower",
        "the quality is higher", "the robot is elsewhere", "the robot steers more",
        "the robot is not mounted",
    ],
)  # fmt: skip
def test_forged_proofs_are_refused(how):
    """Patches must cover the areas, for their sector, and show the bound."""
    crew = [Robot((-2, 0.3), 0.1, steers=0.5), Robot((2, 0.2), 3.0), Robot((0.3, -1), 1.2),
            Robot((-0.5, 1), -1.4, steers=0.4)]  # fmt: skip
    bay = Zone(area=[(-1.5, -0.5), (1.5, -0.5), (1.5, 0.5), (0.1, 0.1)], directions=(0.5, 2.5))
    document = document_of(place(Swarm(HULL, crew), Newcomer(steers=True, mounted=True), [bay]))
    assert verify_document(document)
    forged = copy.deepcopy(document)
    _spoil(forged["placements"][0], how)
    forged["digest"] = digest_of(forged)
    assert not verify_document(forged)


@pytest.mark.long
def test_thousands():
    """Random and degenerate swarms: none is refused by its check, none beaten by a grid."""
    for seed in range(3000):
        problem = random_problem(np.random.default_rng([seed, 6]), KINDS[seed % len(KINDS)])
        answer = place(problem)
        assert answer.verify(), (seed, answer.verify().faults)
        if seed % 10 == 0:
            size = float(problem.swarm.limits.sum()) + problem.newcomer.limit
            assert best_on_a_grid(problem, 9) <= answer.upper_bound * (1.0 + 1e-9) + 1e-11 * size
