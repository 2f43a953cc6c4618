"""Newcomers of one fixed direction, one-way or two-way, beside robots of any force set (T23)."""

import copy
import math
from dataclasses import replace

import numpy as np
import pytest

from swarmgrasp import (
    Ellipsoid,
    Newcomer,
    Outline,
    Polytope,
    Problem,
    Robot,
    Stretch,
    Swarm,
    Zone,
    place,
    place_sequence,
    quality,
)
from swarmgrasp.answer_file import document_of
from swarmgrasp.placement.boxes import BoxSearch
from swarmgrasp.verify import verify_document
from swarmgrasp.verify.digest import digest_of

RECTANGLE = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])
BOAT = Outline([(-0.5, -0.3), (0.5, -0.3), (0.5, 0.3), (-0.5, 0.3)], origin=(0, 0))
THREE = [((-0.4, -0.2), 0.0), ((-0.4, 0.2), 0.0), ((0.1, 0.0), math.pi / 2)]
VESSEL = Swarm(
    BOAT,
    [Robot(c, a, 40.0, mounted=True, reverse_limit=40.0) for c, a in THREE],
    characteristic_length=0.3,
)
TERMS = (
    {},
    {"losing": 1},
    {"load": (0.1, 0.05, -0.1)},
    {"task": Polytope([(1, 0, 0.2), (-0.5, 0.5, 0), (0, -1, -0.1)])},
    {"task": Ellipsoid([(1, 0, 0), (0, 2, 0), (0, 0, 0.5)]), "load": (0.05, 0.0, 0.02)},
)
KINDS = ("ray", "two-way", "sector", "azimuth", "finger", "taut", "envelope")


def robot_of(kind, rng, name=""):
    """Return a robot of a kind somewhere on the rectangle."""
    edge = int(rng.integers(4))
    contact = RECTANGLE.on_edge(edge, float(rng.uniform(0.0, RECTANGLE.lengths[edge]))).point
    inward, limit = RECTANGLE.inward_normal(edge), float(rng.uniform(0.5, 1.5))
    direction = inward + float(rng.uniform(-1.5, 1.5))
    more = {
        "ray": {},
        "two-way": {"reverse_limit": float(rng.choice([0.5, 1.0])) * limit},
        "sector": {"steers": float(rng.uniform(0.2, 1.5))},
        "azimuth": {"steers": math.pi},
        "finger": {"friction": 0.5},
        "taut": {"least": 0.2 * limit},
        "envelope": {"envelope": [(limit, 0.2), (limit, -0.3), (-0.3, 0.1), (0.0, -0.4)]},
    }[kind]
    if kind == "envelope":
        return Robot(contact, direction, name=name, **more)
    return Robot(contact, direction, limit, name, **more)


def draw(seed):
    """Return a question: a swarm, a newcomer and a criterion."""
    rng = np.random.default_rng(seed)
    kinds = rng.choice(KINDS, size=int(rng.integers(3, 9)))
    kinds = kinds[:1].repeat(len(kinds)) if rng.random() < 0.4 else kinds
    swarm = Swarm(RECTANGLE, [robot_of(kind, rng) for kind in kinds])
    back = float(rng.choice([0.0, 0.5, 1.0]))
    attachment = str(rng.choice(["free", "push", "pull"]))
    newcomer = Newcomer(1.0, attachment, reverse_limit=back)
    return swarm, newcomer, TERMS[seed % len(TERMS)]


def best_on_grid(answer, contacts=9, directions=13):
    """Return what the quality of the best of a grid of places is at least."""
    problem, best = answer.problem, 0.0
    outline, newcomer = problem.swarm.outline, problem.newcomer
    for piece in problem.pieces().each:
        for s in np.linspace(piece.start, piece.end, contacts):
            point = outline.on_edge(piece.edge, float(s)).point
            for angle in np.linspace(piece.lo, piece.hi, directions).tolist():
                robot = Robot(point, angle, newcomer.limit, reverse_limit=newcomer.reverse_limit)
                found = quality(problem.swarm.with_robot(robot), **problem.criterion.keywords)
                best = max(best, found.bound)
    return best


def test_a_two_way_newcomer_helps_a_balanced_vessel():
    """Three two-way thrusters: a one-way newcomer cannot help, a two-way one gives 68.388 N."""
    one_way = place(VESSEL, Newcomer(40.0))
    assert (one_way.quality, one_way.improves) == (pytest.approx(40.0), False)
    assert one_way.reason.endswith(
        "one robot can push only one way: place two, or one that reverses"
    )
    answer = place(VESSEL, Newcomer(40.0, reverse_limit=40.0))
    assert answer.quality == pytest.approx(68.38803, abs=1e-4)
    assert answer.upper_bound == pytest.approx(68.38803, abs=1e-4)
    assert answer.improves
    assert not answer.stopped_early
    x, y = answer.robot.contact
    assert (x, abs(y)) == (pytest.approx(-0.26, abs=1e-3), pytest.approx(0.3))
    assert abs(math.sin(answer.robot.direction)) == pytest.approx(1.0, abs=1e-6)
    assert answer.robot.reverse_limit == 40.0
    for found in (one_way, answer):
        verdict = found.verify()
        assert verdict, verdict.faults


@pytest.mark.parametrize("seed", range(20))
def test_no_place_on_a_grid_beats_the_bound(seed):
    """Every kind of robot present, and criterion: a real, exact, proven place."""
    swarm, newcomer, terms = draw(seed)
    answer = place(swarm, newcomer, gap=1e-3, **terms)
    alone = quality(answer.swarm_after, **terms)
    assert answer.quality == pytest.approx(alone.value, rel=1e-7, abs=1e-11)
    assert best_on_grid(answer) <= answer.upper_bound * (1.0 + 1e-8) + 1e-10
    assert answer.stopped_early or answer.gap <= 1e-3 + 1e-9
    verdict = answer.verify()
    assert verdict, verdict.faults


@pytest.mark.parametrize("count", [3, 4, 5, 8])
def test_balanced_rings_are_solved(count):
    """Of equal robots evenly around a square many places are the best: one is proven."""
    square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    spots = [square.at_arc_length(8.0 * k / count).point for k in range(count)]
    turned = [math.atan2(y, x) + 1.0 for x, y in spots]
    robots = [Robot(c, a, reverse_limit=1.0) for c, a in zip(spots, turned, strict=True)]
    answer = place(Swarm(square, robots), Newcomer(1.0, reverse_limit=1.0), gap=1e-4)
    assert answer.gap <= 1e-3
    verdict = answer.verify()
    assert verdict, verdict.faults


def test_two_rays_that_are_opposite_are_one_two_way_robot():
    """A swarm says the same of its quality and of places, however it is told."""
    spots = [((1, -1), 0.3), ((-1.5, -1), 1.4), ((2, 0.5), 2.6), ((-2, 0.2), 0.9)]
    lines = Swarm(RECTANGLE, [Robot(c, a, 1.0, reverse_limit=0.6) for c, a in spots])
    halves = [Robot(c, a + turn, u) for c, a in spots for turn, u in ((0, 1.0), (math.pi, 0.6))]
    one, two = (place(s, Newcomer(attachment="push")) for s in (lines, Swarm(RECTANGLE, halves)))
    assert one.quality_before == pytest.approx(two.quality_before, rel=1e-9)
    assert one.quality == pytest.approx(two.quality, rel=3e-6)
    assert {bool(one.verify()), bool(two.verify())} == {True}


def test_zones_bollards_no_go_and_spacing_hold():
    """As for any newcomer; runners-up are told, each in its zone."""
    zones = [
        Zone(Stretch(0.5, 2.0, "pad")),
        Zone(Stretch(5.0, 5.0, "bollard"), "pull", 0.6),
        Zone(Stretch(8.0, 9.5, "rail"), directions=(-2.5, -0.5)),
    ]
    answer = place(
        Swarm(RECTANGLE, [robot_of(k, np.random.default_rng(3)) for k in KINDS[:4]]),
        Newcomer(0.7, reverse_limit=0.4),
        zones,
        no_go=[Stretch(1.0, 1.2)],
        spacing=0.2,
        gap=1e-3,
        runners_up=0.0,
    )
    told = {answer.place, *(runner.place for runner in answer.runners_up)}
    assert told <= {"pad", "bollard", "rail"}
    assert len(told) > 1
    verdict = answer.verify()
    assert verdict, verdict.faults


def test_a_sequence_grows_the_vessel():
    """Each newcomer finds those before it; the file of all of them is checked as one."""
    answers = place_sequence(Problem(VESSEL, Newcomer(40.0, reverse_limit=40.0)), 2, gap=1e-3)
    assert answers[1].quality > answers[0].quality > 60.0
    assert verify_document(document_of(answers))


def test_a_search_cut_short_keeps_its_bound():
    """After few exact qualities the bound is wide, and holds."""
    problem = Problem(VESSEL, Newcomer(40.0, reverse_limit=40.0))
    search = BoxSearch(problem, problem.pieces())
    found = search.solve(1e-6, asks=5)
    assert not found.solved
    assert found.upper_bound > 68.388 > found.best.quality > 0.0


@pytest.mark.parametrize("losing", [1, 2])
def test_losses_are_certified(losing):
    """Bounds travel with what is left after the losses, of robots and of groups."""
    rng = np.random.default_rng(7)
    robots = [
        robot_of(k, rng) for k in ("two-way", "sector", "azimuth", "two-way", "finger", "ray")
    ]
    robots = [replace(robot, group="bus" if k < 2 else "") for k, robot in enumerate(robots)]
    answer = place(
        Swarm(RECTANGLE, robots), Newcomer(1.0, reverse_limit=1.0), gap=1e-4, losing=losing
    )
    assert answer.gap <= 1e-4
    assert best_on_grid(answer, 5, 7) <= answer.upper_bound * (1.0 + 1e-8)
    document = document_of(answer)
    verdict = verify_document(document)
    assert verdict, verdict.faults
    if losing == 1:
        boxes = document["placements"][0]["boxes"]
        assert any(any(box["lost"]) for box in boxes)
        for box in boxes:  # all of them at once may not be lost
            box["lost"] = [[r.name for r in answer.problem.swarm] for _ in box["lost"]]
        document["digest"] = digest_of(document)
        assert not verify_document(document)


def _spoil(document, how):
    """Alter a document."""
    placed = document["placements"][0]
    box = max(placed["boxes"], key=lambda box: len(box["weights"]))
    if how == "a box is missing":
        placed["boxes"].remove(box)
    elif how == "a box is narrower":
        box["lo"] += 0.1 * (box["hi"] - box["lo"])
    elif how == "a box is shorter":
        box["start"] = [0.9 * a + 0.1 * b for a, b in zip(box["start"], box["end"], strict=True)]
    elif how == "all normals are one":
        for box in placed["boxes"]:
            box["vectors"] = [[1.0, 0.0, 0.0]] * len(box["vectors"])
    elif how == "the bound is lower":
        placed["upper_bound"] *= 1.0 - 1e-6
    elif how == "the robot is stronger":
        placed["robot"]["reverse_limit"] *= 2.0
    elif how == "the quality is higher":
        placed["quality"] *= 1.0 + 1e-4
        placed["upper_bound"] *= 1.0 + 1e-4
    elif how == "no boxes":
        placed["boxes"] = []


@pytest.mark.parametrize(
    "how",
    [
        "a box is missing", "a box is narrower", "a box is shorter", "all normals are one",
        "the bound is lower", "the robot is stronger", "the quality is higher", "no boxes",
    ],
)  # fmt: skip
def test_forged_proofs_are_refused(how):
    """Boxes must cover all that is allowed, and show the bound."""
    document = copy.deepcopy(
        document_of(place(VESSEL, Newcomer(40.0, reverse_limit=40.0), gap=1e-4))
    )
    assert verify_document(document)
    _spoil(document, how)
    document["digest"] = digest_of(document)
    assert not verify_document(document)


@pytest.mark.long
@pytest.mark.parametrize("first", range(0, 2000, 100))
def test_many_questions_are_proven(first):
    """A hundred each: exact, verified, and not beaten by a coarse grid."""
    for seed in range(first + 100, first + 200):
        swarm, newcomer, terms = draw(seed)
        answer = place(swarm, newcomer, gap=1e-4, **terms)
        verdict = answer.verify()
        assert verdict, (seed, verdict.faults)
        beaten = best_on_grid(answer, 5, 7)
        assert beaten <= answer.upper_bound * (1.0 + 1e-8) + 1e-10, seed


ONE, OTHER = Robot((2, 0.3), 2.9), Robot((-2, -0.4), 0.3)
BOTH_WAYS = Robot((1, 1), -1.4, reverse_limit=0.7)
FLAT = {
    "nobody": ([], {}),
    "nobody, a load": ([], {"load": (0.0, 0.2, 0.1)}),
    "a ray": ([ONE], {}),
    "a ray, a load": ([ONE], {"load": (0.1, 0.2, 0.1)}),
    "one both ways": ([BOTH_WAYS], {}),
    "two rays": ([ONE, OTHER], {}),
    "a ray and one both ways": ([ONE, BOTH_WAYS], {}),
    "two both ways, one lost": ([BOTH_WAYS, replace(BOTH_WAYS, contact=(-1, 1))], {"losing": 1}),
    "three rays, one lost": ([ONE, OTHER, Robot((0.5, -1), 1.3)], {"losing": 1}),
}


def flat_document(name):
    """Return the document of a newcomer that reverses, beside few."""
    crew, terms = FLAT[name]
    return document_of(place(Swarm(RECTANGLE, crew), Newcomer(reverse_limit=1.0), **terms))


@pytest.mark.parametrize("name", FLAT)
def test_beside_few_a_two_way_newcomer_proves_to_give_nothing(name):
    """Their wrenches fill no more than half a plane: a box for each piece and quarter turn."""
    document = flat_document(name)
    (claim,) = document["placements"]
    assert (claim["quality"], claim["upper_bound"], claim["stopped_early"]) == (0.0, 0.0, False)
    assert len(claim["boxes"]) == 8
    verdict = verify_document(document)
    assert verdict, verdict.faults
    assert verdict.upper_bounds == (pytest.approx(0.0, abs=1e-14),)


def test_two_that_reverse_are_not_flat():
    """They fill a plane: a third closes the grasp."""
    crew = [BOTH_WAYS, Robot((-1.5, -1), 1.1, reverse_limit=1.0)]
    answer = place(Swarm(RECTANGLE, crew), Newcomer(reverse_limit=1.0), gap=1e-2)
    assert answer.quality > 0.3
    assert answer.verify()


@pytest.mark.parametrize("spoil", ["no opposite", "parallel", "lost", "alone"])
def test_a_flat_proof_of_another_kind_is_refused(spoil):
    """A normal that is not across everything, two that are one, too many lost, one alone."""
    document = flat_document("two rays")
    for box in document["placements"][0]["boxes"]:
        if spoil == "no opposite":
            box["vectors"].reverse()
        elif spoil == "parallel":
            box["vectors"][1] = box["vectors"][0]
        elif spoil == "lost":
            box["lost"] = [["R1"], ["R1"]]
        else:
            box.update({key: box[key][:1] for key in ("kinds", "vectors", "weights", "lost")})
    document["digest"] = digest_of(document)
    assert verify_document(document).faults[0].startswith("the proofs show an upper bound of")
