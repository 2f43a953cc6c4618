"""A stranger's check of answers after the worst of named failures (T25)."""

import copy
import math
from functools import cache

import numpy as np
import pytest

import reference
from answers import asked, first, judge
from swarmgrasp import Criterion, Newcomer, Outline, Polytope, Problem, Robot, Swarm, place_sequence
from swarmgrasp.answer_file import document_of
from swarmgrasp.errors import AnswerInvalid
from swarmgrasp.verify.boundary import Boundary
from swarmgrasp.verify.claims import read_claims
from swarmgrasp.verify.judge import Judge

HULL = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])
RAYS = [
    Robot((2 * math.cos(t), math.copysign(1, math.sin(t))), t + math.pi + 0.6, name=f"R{k}")
    for k, t in enumerate(np.linspace(0.2, 6.1, 11))
]
RAYS[:2] = [Robot(r.contact, r.direction, name=r.name, group="bus A") for r in RAYS[:2]]
MIXED = [
    Robot((-2, 0), 0.3, 1.5, "Ajax", steers=0.6, group="bus A"),
    Robot((1.5, 1), -1.5, 1.2, "Boreas", reverse_limit=0.7, group="bus A"),
    Robot((1.0, -1), 1.5, 1.0, "Castor", steers=math.pi),
    Robot((2, 0.4), 3.0, 1.0, "Dione", friction=0.5),
    Robot((-1.5, 1), -1.2, 1.3, "Erato", steers=0.8),
    Robot((-1.0, -1), 1.9, 1.0, "bus A", reverse_limit=1.0),
    Robot((2, -0.6), 2.6, 1.4, "Faunus", steers=0.7),
]
"""One of them is called as a group is: the name means the group."""
OF_RAYS = {"failures": (("bus A",), ("R2", "R5"), ("R7",))}
OF_MIXED = {"failures": (("bus A",), ("Castor", "Dione"), ("Erato",))}
WORST, WEAKER = "bus A", "Erato"
ASKED = {
    "rays": (RAYS, Newcomer(), OF_RAYS),
    "rays, one lost too": (RAYS, Newcomer(attachment="push"), {**OF_RAYS, "losing": 1}),
    "a ray": (MIXED, Newcomer(attachment="push"), OF_MIXED),
    "both ways": (MIXED, Newcomer(reverse_limit=1.0), {**OF_MIXED, "load": (0.1, 0.1, 0.0)}),
    "inside": (MIXED, Newcomer(reverse_limit=0.5, mounted=True), OF_MIXED),
    "steering": (MIXED, Newcomer(attachment="push", half_angle=0.6, steers=True), OF_MIXED),
    "azimuth, one lost too": (
        MIXED[:5],
        Newcomer(steers=True),
        {"failures": (("bus A",), ("Erato",)), "losing": 1},
    ),
    "finger": (
        MIXED,
        Newcomer(attachment="push", friction=0.5),
        {**OF_MIXED, "task": Polytope([(1, 0, 0.2), (-0.5, 0.5, 0), (0, -1, -0.1)])},
    ),
}


@cache
def honest(name):
    """Return the document of two newcomers, one after the other."""
    crew, newcomer, terms = ASKED[name]
    problem = Problem(Swarm(HULL, crew, 1.5), newcomer, criterion=Criterion(**terms))
    return document_of(place_sequence(problem, 2, gap=1e-3, runners_up=0.9))


@pytest.mark.parametrize("name", ASKED)
def test_an_honest_answer_passes(name):
    """Newcomers of every kind, the second beside the first; nothing is taken on trust."""
    verdict = judge(copy.deepcopy(honest(name)))
    assert verdict, verdict.faults
    assert not verdict.unchecked
    claims = honest(name)["placements"]
    assert claims[1]["improves"]
    bounds = [claim["upper_bound"] for claim in claims]
    assert verdict.upper_bounds == pytest.approx(bounds, rel=1e-6)


@pytest.mark.parametrize("losing", [0, 1, 2])
@pytest.mark.parametrize("crew", [RAYS, MIXED[:5]])
def test_what_is_left_is_the_least_after_any_failure(crew, losing):
    """Along 200 normals, by every robot's own support function."""
    terms = {**(OF_RAYS if crew is RAYS else OF_MIXED), "losing": losing, "load": (0.1, -0.2, 0.3)}
    swarm = Swarm(HULL, crew, 1.5)
    problem = read_claims(
        document_of(place_sequence(Problem(swarm, Newcomer(), criterion=Criterion(**terms)), 1))
    ).problem
    own = Judge(Boundary(problem.swarm.outline), problem.swarm, problem.criterion)
    normals = np.random.default_rng(1).normal(size=(200, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    found = own.held(own.team(problem.swarm.robots), normals).height
    assert found == pytest.approx(reference.height_of_sets(swarm, normals, **terms), abs=1e-12)


# -- forgeries ------------------------------------------------------------------------


@pytest.mark.parametrize("name", ["a ray", "steering", "both ways"])
@pytest.mark.parametrize("failures", [[], [[WEAKER]], [["Castor", "Dione"], [WEAKER]]])
def test_a_failure_that_is_left_out_is_missed(name, failures):
    """And the worst of them is not another one: without it the quality is not what is said."""
    document = copy.deepcopy(honest(name))
    asked(document)["criterion"]["failures"] = failures
    assert judge(document).faults[0].startswith("placement 1: the quality before is said to be")


@pytest.mark.parametrize("name", ["rays", "a ray", "azimuth, one lost too"])
@pytest.mark.parametrize("key", ["quality_before", "quality"])
def test_a_quality_too_high_is_refused(name, key):
    """By a millionth."""
    document = copy.deepcopy(honest(name))
    document["placements"][1][key] *= 1.0 + 1e-6
    faults = judge(document).faults
    assert any(fault.startswith("placement 2: the quality") for fault in faults)


@pytest.mark.parametrize(
    ("failures", "says"),
    [
        ([[]], "problem.criterion.failures.0: List should have at least 1 item"),
        ([["bus B"]], "criterion.failures.0 takes 'bus B', which is no robot and no group"),
        ([["Ajax"], ["Castor", ""]], "criterion.failures.1 takes '', which is no robot"),
        (["bus A"], "problem.criterion.failures.0: Input should be a valid"),
    ],
)
def test_a_failure_of_nobody_is_refused(failures, says):
    """Before anything is computed."""
    document = copy.deepcopy(honest("a ray"))
    asked(document)["criterion"]["failures"] = failures
    with pytest.raises(AnswerInvalid) as refusal:
        judge(document)
    assert says in str(refusal.value)


def test_no_two_robots_have_one_name():
    """Failures and losses are told by names: those of one name would be taken as one."""
    document = copy.deepcopy(honest("a ray"))
    first(document)["robot"]["name"] = "Castor"
    assert "placement 1: the robot is called 'Castor', as another is" in judge(document).faults
    asked(document)["swarm"]["robots"][4]["name"] = "Castor"
    with pytest.raises(AnswerInvalid, match="2 robots are called 'Castor'"):
        judge(document)


def test_a_group_is_no_other_machine_by_its_name():
    """A group that is called as a number is not the robot at that place in the list."""
    crew = [*RAYS[:10], Robot(RAYS[10].contact, RAYS[10].direction, name="R10", group=" 2")]
    problem = Problem(Swarm(HULL, crew, 1.5), Newcomer(), criterion=Criterion(losing=1))
    verdict = judge(document_of(place_sequence(problem, 1)))
    assert verdict, verdict.faults
