"""A stranger's check of answers by a criterion: losses, loads, tasks and uncertain poses."""

import copy
import math
from functools import cache

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import reference
from answers import CREW, NEWCOMER, OUTLINE, ZONES, first, judge
from strategies import seeds, swarm_of
from swarmgrasp import (
    Criterion,
    Ellipsoid,
    Newcomer,
    Outline,
    Polytope,
    Problem,
    Robot,
    Swarm,
    Tolerance,
    place,
    place_sequence,
)
from swarmgrasp.answer_file import document_of
from swarmgrasp.verify import judge as judge_of
from swarmgrasp.verify import verify_document
from swarmgrasp.verify.boundary import Boundary
from swarmgrasp.verify.claims import OutlineClaim, read_claims
from swarmgrasp.verify.judge import Judge

SPOTS = (0.7, 3.2, 5.1, 6.8, 7.9, 9.4, 11.2)
MORE = [Robot(OUTLINE.at_arc_length(s).point, 2.1 * k % math.tau, 0.9) for k, s in enumerate(SPOTS)]
SWARM = Swarm(OUTLINE, [*CREW, *MORE], 1.5)
ADRIFT = SWARM.with_tolerance(Tolerance(0.15, 0.1, least_limit=0.7))
UNSURE = Newcomer(1.0, "push", 0.4, "Fred", tolerance=Tolerance(0.1, 0.05))
THREE = Polytope([(1.0, 0.0, 0.2), (-0.4, 0.5, 0.0), (0.0, -0.6, -0.3)])
ROUND = Ellipsoid([(1.0, 0.0, 0.0), (0.0, 0.5, 0.1), (0.0, 0.0, 0.4)])
FROM_ABOVE = "the worst of the uncertain poses is bounded from above, not recomputed"
NO_PROOF = "the upper bound of a newcomer that cannot hit its place exactly"

TERMS = {
    "one lost": {"losing": 1},
    "two lost": {"losing": 2},
    "load": {"load": (0.3, -0.2, 0.1)},
    "polytope": {"task": THREE},
    "ellipsoid": {"task": ROUND},
    "flat task": {"task": Ellipsoid([(300.0, 0.0, 0.0), (0.0, 100.0, 0.0)])},
    "one way": {"task": Polytope([(0.0, 0.002, 0.001)]), "load": (0.1, 0.0, 0.0)},
    "all at once": {"task": ROUND, "load": (0.1, 0.0, 0.05), "losing": 1},
    "worst poses": {"worst_case": True},
    "worst poses, one lost": {"worst_case": True, "losing": 1, "load": (0.05, 0.0, 0.0)},
}


@cache
def honest(name, is_unsure=False):
    """Return an honest document; of uncertain poses too if the criterion asks for them."""
    swarm = ADRIFT if "worst_case" in TERMS[name] else SWARM
    newcomer = UNSURE if is_unsure else NEWCOMER
    return document_of(place(swarm, newcomer, runners_up=0.8, **TERMS[name]))


def recomputed(swarm, **terms):
    """Return the bounds of a swarm's quality by the check."""
    asked = read_claims(document_of(place(swarm, Newcomer(), **terms))).problem
    found = Judge(Boundary(asked.swarm.outline), asked.swarm, asked.criterion)
    return found.value(found.team(asked.swarm.robots), np.zeros((0, 3)))


# -- honest answers -------------------------------------------------------------------


@pytest.mark.parametrize("name", TERMS)
def test_an_honest_answer_passes(name):
    """With runners-up; only the worst of uncertain poses is taken on trust, from below."""
    verdict = verify_document(honest(name))
    assert verdict, verdict.faults
    claim = first(honest(name))
    assert claim["improves"]
    assert verdict.upper_bounds == (pytest.approx(claim["upper_bound"], rel=1e-8),)
    assert verdict.unchecked == ((FROM_ABOVE,) if "worst" in name else ())


def test_an_honest_answer_of_an_unsure_newcomer_passes():
    """The proofs are of a newcomer that hits its place; the bound stated may be below theirs."""
    verdict = verify_document(honest("worst poses", is_unsure=True))
    assert verdict, verdict.faults
    assert verdict.upper_bounds[0] >= first(honest("worst poses", is_unsure=True))["upper_bound"]
    assert verdict.unchecked == (FROM_ABOVE, NO_PROOF)


@pytest.mark.parametrize("name", ["two lost", "all at once", "worst poses, one lost"])
def test_an_honest_sequence_passes(name):
    """Each placement finds the robots before it, with their tolerances."""
    swarm = ADRIFT if "worst_case" in TERMS[name] else SWARM
    problem = Problem(swarm, UNSURE, ZONES, spacing=0.3, criterion=Criterion(**TERMS[name]))
    verdict = verify_document(document_of(place_sequence(problem, 3)))
    assert verdict, verdict.faults


def test_a_load_that_none_can_hold_leaves_nothing():
    """The bound is 0 as well, by a normal at which every robot fails."""
    few = Swarm(OUTLINE, CREW[:4], 1.5)
    answer = place(few, NEWCOMER, load=(-50.0, 0.0, 0.0), task=Polytope([(1.0, 0.0, 0.0)]))
    assert (answer.quality, answer.upper_bound) == (0.0, 0.0)
    verdict = answer.verify()
    assert verdict, verdict.faults
    assert verdict.upper_bounds == (0.0,)


@settings(max_examples=60, deadline=None)
@given(
    st.sampled_from(("free", "along normals", "integer grid", "duplicated", "notched")),
    seeds,
    st.integers(4, 12),
    st.sampled_from(list(TERMS)),
    st.sampled_from((NEWCOMER, UNSURE, Newcomer(2.0, "free"), Newcomer(1.0, "pull", 0.0))),
)
def test_every_answer_of_the_search_passes(family, seed, n, name, newcomer):
    """Whatever the swarm, the criterion and the newcomer."""
    swarm = swarm_of(family, seed, n)
    if "worst_case" in TERMS[name]:
        swarm = swarm.with_tolerance(Tolerance(0.1, (-0.2, 0.1)))
        newcomer = newcomer if newcomer.tolerance is None or seed % 4 == 0 else NEWCOMER
    verdict = place(swarm, newcomer, runners_up=0.9, **TERMS[name]).verify()
    assert verdict, verdict.faults


# -- tampering ------------------------------------------------------------------------


def test_a_newcomer_that_misses_its_place_needs_proofs_too():
    """Its bound is taken on trust, but not without any proof."""
    worst = next(name for name, terms in TERMS.items() if "worst_case" in terms)
    document = copy.deepcopy(honest(worst, is_unsure=True))
    assert judge(document)
    first(document)["proofs"] = []
    assert "the proofs show an upper bound of inf" in judge(document).faults[0]


def _change(key, value):
    def spoil(document):
        document["problem"]["criterion"][key] = value

    return spoil


def _scale(key, factor):
    def spoil(document):
        first(document)[key] *= factor

    return spoil


def _task_scaled(document):
    task = document["problem"]["criterion"]["task"]
    (kind,) = task
    task[kind] = [[0.99 * number for number in row] for row in task[kind]]


def _task_renamed(document):
    criterion = document["problem"]["criterion"]
    criterion["task"] = {"axes": criterion["task"]["vertices"]}


def _narrower(document):
    for robot in document["problem"]["swarm"]["robots"]:
        robot["tolerance"]["contact"] = [0.99 * end for end in robot["tolerance"]["contact"]]


def _wider(document):
    for robot in document["problem"]["swarm"]["robots"]:
        robot["tolerance"]["direction"] = [1.01 * end for end in robot["tolerance"]["direction"]]


def _stronger(document):
    for robot in document["problem"]["swarm"]["robots"]:
        robot["tolerance"]["least_limit"] = 0.71


def _absent(document):
    document["problem"]["swarm"]["robots"][0]["tolerance"]["may_be_absent"] = True


def _surer(document):
    first(document)["robot"]["tolerance"] = None


def _runner(document):
    first(document)["runners_up"][0]["quality"] *= 1.0 + 1e-5


def _bent(document):
    for proof in first(document)["proofs"]:
        proof["normals"][0][0] += 1e-2


HIGHER, LOWER, BELOW = _scale("quality", 1.0 + 1e-6), _scale("quality", 1.0 - 1e-6), 1.0 - 1e-5
TAMPERINGS = [
    ("one lost", HIGHER, "the quality with the robot is said to be"),
    ("one lost", LOWER, "the quality with the robot is said to be"),
    ("one lost", _scale("quality_before", 1.0 + 1e-6), "the quality before is said to be"),
    ("one lost", _scale("upper_bound", BELOW), "the proofs show an upper bound"),
    ("one lost", _bent, "the proofs show an upper bound"),
    ("one lost", _change("losing", 0), "the quality before is said to be"),
    ("one lost", _change("losing", 2), "the quality before is said to be"),
    ("one lost", _change("losing", 10**9), "the quality before is said to be"),
    ("two lost", _runner, "the quality with the runner-up at"),
    ("load", _change("load", [0.3, -0.2, 0.11]), "the quality before is said to be"),
    ("load", _change("load", [0.0, 0.0, 0.0]), "the quality before is said to be"),
    ("polytope", HIGHER, "the quality with the robot is said to be"),
    ("polytope", LOWER, "the quality with the robot is said to be"),
    ("polytope", _task_scaled, "the proofs show an upper bound"),
    ("polytope", _task_renamed, "the quality before is said to be"),
    ("ellipsoid", _task_scaled, "the quality with the robot is said to be"),
    ("ellipsoid", _change("task", None), "N and is"),
    ("one way", _scale("upper_bound", BELOW), "the proofs show an upper bound"),
    ("all at once", HIGHER, "the quality with the robot is said to be"),
    ("worst poses", HIGHER, "the quality with the robot is said to be"),
    ("worst poses", _runner, "the quality with the runner-up at"),
    ("worst poses", _scale("upper_bound", BELOW), "the proofs show an upper bound"),
    ("worst poses", _change("worst_case", False), "the quality before is said to be"),
    ("worst poses", _narrower, "the proofs show an upper bound"),
    ("worst poses", _wider, "the quality before is said to be"),
    ("worst poses", _stronger, "the proofs show an upper bound"),
    ("worst poses", _absent, "the quality before is said to be"),
]


@pytest.mark.parametrize(("name", "spoil", "says"), TAMPERINGS)
def test_tampering_is_refused_by_mathematics(name, spoil, says):
    """With a digest that fits again."""
    document = copy.deepcopy(honest(name))
    spoil(document)
    faults = judge(document).faults
    assert any(says in fault for fault in faults), faults


@pytest.mark.parametrize(
    ("spoil", "says"),
    [
        (HIGHER, "the quality with the robot is said to be"),
        (_surer, "the robot has another tolerance than the newcomer"),
        (_scale("upper_bound", BELOW), "is below the quality"),
        (_scale("upper_bound", 1.0 + 1e-5), "by more than the gap asked for"),
        (_scale("quality", 2.0), "the proofs bound the quality by"),
    ],
)
def test_tampering_with_an_unsure_newcomer_is_refused(spoil, says):
    """What there is to check is checked."""
    document = copy.deepcopy(honest("worst poses", is_unsure=True))
    spoil(document)
    faults = judge(document).faults
    assert any(says in fault for fault in faults), faults


def test_messages_have_units_but_for_a_task():
    """Relative to a task, quality has none."""
    for name, unit in (("one lost", " N"), ("polytope", "")):
        document = copy.deepcopy(honest(name))
        HIGHER(document)
        found = f"{first(document)['quality']:.12g}{unit} and is"
        assert found in judge(document).faults[0]


@pytest.mark.parametrize(
    "proof",
    [
        {"normals": [[-1.0, 0.0, 0.0]], "weights": [1.0]},  # asked nothing, holds much
        {"normals": [[-1e-12, 1.0, 0.0]], "weights": [1.0]},
        {"normals": [[-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], "weights": [1.0, 1.0]},
        {"normals": [[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0]], "weights": [1e-15, 1.0]},
    ],
)
@pytest.mark.parametrize("losing", [0, 1])
def test_where_a_task_asks_nothing_nothing_is_proved(proof, losing):
    """A normal with D = 0 bounds no quality unless the load is not held there."""
    document = document_of(place(SWARM, NEWCOMER, task=Polytope([(1.0, 0.0, 0.0)]), losing=losing))
    claim = first(document)
    claim["proofs"] = [proof]
    claim["quality"] = claim["upper_bound"] = 0.9 * claim["quality"]
    assert any("the proofs show" in fault for fault in judge(document).faults)


# -- the truths it stands on -------------------------------------------------------------


@settings(max_examples=40, deadline=None)
@given(
    st.sampled_from(("free", "along normals", "integer grid", "duplicated", "ring")),
    seeds,
    st.integers(0, 9),
    st.sampled_from([name for name in TERMS if "worst" not in name]),
)
def test_recomputed_qualities_are_those_of_the_formulas(family, seed, n, name):
    """Of every subset that a loss leaves, by the facets of each."""
    swarm, terms = swarm_of(family, seed, n), TERMS[name]
    task = terms.get("task")
    low, most = recomputed(swarm, **terms)
    expected = reference.quality_by_criterion(
        swarm.scaled_generators,
        terms.get("losing", 0),
        terms.get("load", np.zeros(3)) * swarm.scale,
        None if task is None else task.generators * swarm.scale,
        None if task is None else type(task).__name__.lower(),
    )
    size = 1e-9 * n / (1.0 if task is None else np.abs(task.generators).max())
    assert low - size <= expected <= most + size
    assert most - low <= size


def test_a_tow_along_one_line_has_a_quality():
    """Robots that span a line hold what lies on it: 2 ahead, 1 astern, and so beside a load."""
    crew = [Robot((-2, 0), 0.0), Robot((-2, 0), 0.0), Robot((2, 0), math.pi)]
    line = Swarm(OUTLINE, crew)
    ahead, both = Polytope([(1, 0, 0)]), Polytope([(1, 0, 0), (-1, 0, 0)])
    for task, load, exact in (
        (ahead, 0.0, 2.0), (both, 0.0, 1.0), (ahead, -0.5, 1.5), (ahead, 0.5, 2.5), (both, 2.0, 0.0)
    ):  # fmt: skip
        assert recomputed(line, task=task, load=(load, 0, 0)) == pytest.approx((exact,) * 2)
    assert recomputed(line, task=ahead, losing=1) == pytest.approx((1.0, 1.0))
    assert recomputed(line) == (0.0, 0.0)


def test_uncertain_robots_contribute_their_least():
    """Across corners, over more than half a turn, weakened, or not at all: as sampling finds."""
    notched = Outline([(0, 0), (3, 0), (3, 1), (1, 1), (1, 2), (0, 2)])
    tolerances = (
        Tolerance((-0.7, 2.5), 0.2), Tolerance(0.0, (-2.5, 0.1)), Tolerance(5.0, 0.0),
        Tolerance((-1.2, 0.0), math.pi), Tolerance(0.3, 0.1, least_limit=0.5),
        Tolerance(least_limit=0.4), Tolerance(0.1, may_be_absent=True),
    )  # fmt: skip
    crew = [
        Robot(
            notched.at_arc_length(1.3 * k + 0.1).point, 2.0 * k % math.tau, 1.5, tolerance=tolerance
        )
        for k, tolerance in enumerate(tolerances)
    ]
    swarm = Swarm(notched, crew)
    asked = read_claims(document_of(place(swarm, Newcomer(), worst_case=True))).problem
    found = Judge(Boundary(asked.swarm.outline), asked.swarm, asked.criterion)
    team = found.team(asked.swarm.robots)
    rng = np.random.default_rng(1)
    normals = rng.normal(size=(20, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    sampled = np.full((len(normals), len(crew)), np.inf)
    for k, (robot, tolerance) in enumerate(zip(crew, tolerances, strict=True)):
        at = notched.at_point(robot.contact).arc_length
        shifts, turns = (
            np.linspace(*ends, 400 if ends[0] < ends[1] else 1)
            for ends in (tolerance.offsets, tolerance.turns)
        )
        limit = 0.0 if tolerance.may_be_absent else tolerance.least_limit or robot.limit
        for shift in shifts:
            spot = notched.at_arc_length((at + shift) % notched.perimeter).point
            rows = reference.generators(
                [spot] * len(turns), robot.direction + turns, [limit] * len(turns),
                notched.origin, swarm.scale,
            )  # fmt: skip
            sampled[:, k] = np.minimum(sampled[:, k], (normals @ rows.T).min(axis=1))
    held = np.maximum(sampled, 0.0).sum(axis=1)
    assert found.held(team, normals).height == pytest.approx(held, abs=0.03)
    assert (found.held(team, normals).height <= held + 1e-12).all()
    for normal in normals:
        worst = np.maximum(team.worst(normal).known @ normal, 0.0).sum()
        assert worst == pytest.approx(found.held(team, normal[None]).height[0], abs=1e-12)


def test_the_boundary_around_a_contact_goes_across_corners():
    """Its ends and the corners between, also across the first one; all of them on a whole lap."""
    claim = OutlineClaim(
        vertices=[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)],
        origin=(0.0, 0.0),
        edge_names=["", "", "", ""],
        precision=0.0,
    )
    square, point = Boundary(claim), np.array([-0.75, -1.0])
    for first_, last, expected in (
        (-0.1, 0.2, {(-0.85, -1.0), (-0.55, -1.0)}),
        (-0.5, 0.0, {(-1.0, -0.75), (-1.0, -1.0), (-0.75, -1.0)}),
        (-2.5, 2.0, {(-1.0, 1.0), (-0.75, 1.0), (-1.0, -1.0), (1.0, -1.0), (1.0, -0.75)}),
        (-1e9, 0.0, {(-0.75, -1.0), (-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)}),
    ):
        assert set(map(tuple, square.around(point, first_, last).round(9).tolist())) == expected


def test_of_many_robots_other_criteria_are_bounded_from_above(monkeypatch):
    """Said as taken on trust; one that is too high is still found out."""
    document = document_of(place(SWARM, NEWCOMER, losing=1))
    monkeypatch.setattr(judge_of, "MOST_LISTED", 4)
    monkeypatch.setattr("swarmgrasp.verify.placement.MOST_LISTED", 4)
    verdict = verify_document(document)
    assert verdict, verdict.faults
    assert verdict.unchecked == (
        "the qualities of more than 4 robots, by this criterion, are bounded from above only",
    )
    first(document)["quality"] *= 1.3
    assert not judge(document)
