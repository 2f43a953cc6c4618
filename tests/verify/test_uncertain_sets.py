"""A stranger's check of robots that steer, or are no rays, in their worst poses (T26)."""

import copy
import math
from functools import cache

import numpy as np
import pytest
from numpy.random import default_rng

import reference
from answers import first, judge
from swarmgrasp import Newcomer, Outline, Robot, Swarm, Tolerance, place
from swarmgrasp.answer_file import document_of
from swarmgrasp.errors import AnswerInvalid
from swarmgrasp.verify.boundary import Boundary
from swarmgrasp.verify.claims import read_claims
from swarmgrasp.verify.judge import Judge

HULL = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])
FROM_ABOVE = "the worst of the uncertain poses is bounded from above, not recomputed"
BOTH = Tolerance((-0.3, 0.7), (-0.1, 0.3))
ADRIFT = Tolerance(0.9)
CREW = [
    Robot((-2, 0.5), 0.3, 1.5, "sector", steers=0.6, tolerance=BOTH),
    Robot((1.5, 1), -1.5, 1.2, "hardly steers", steers=0.1, tolerance=BOTH),
    Robot((1.8, -1), 1.5, 1.0, "azimuth", steers=math.pi, tolerance=BOTH),
    Robot((2, 0.4), 3.0, 1.0, "finger", friction=0.5, tolerance=ADRIFT),
    Robot((-1.5, 1), -1.2, 1.3, "both ways", steers=0.5, reverse_limit=0.8, tolerance=ADRIFT),
    Robot((-1.9, -1), 1.9, 1.0, "reverses", reverse_limit=1.0, tolerance=BOTH),
    Robot((2, -0.9), 2.6, 1.0, "cable", least=0.1, tolerance=ADRIFT),
    Robot((0, -1), 1.6, 1.4, "weaker", steers=0.7, tolerance=Tolerance(least_limit=0.9)),
    Robot((0.3, 1), -1.7, 1.4, "absent", steers=0.7, tolerance=Tolerance(may_be_absent=True)),
]


def judged(swarm):
    """Return the check's own judge of a swarm in its worst poses, and the robots it reads."""
    question = read_claims(document_of(place(swarm, Newcomer(), gap=0.1, worst_case=True))).problem
    found = Judge(Boundary(question.swarm.outline), question.swarm, question.criterion)
    return found, question.swarm.robots


@pytest.mark.parametrize("robot", CREW, ids=lambda robot: robot.name)
def test_it_exerts_the_least_of_all_its_poses(robot):
    """Steering after its pose is drawn: no drawn pose gives less, and some as good as that."""
    rng, tolerance = default_rng(7), robot.tolerance
    own, robots = judged(Swarm(HULL, [robot], 1.5))
    normals = rng.normal(size=(40, 3))
    normals /= np.linalg.norm(normals, axis=1)[:, None]
    found = own.height(own.team(robots), normals)
    n, least = normals / [1.0, 1.0, 1.5], np.full(40, math.inf)
    at = _arc_of(robot.contact)
    limit = tolerance.least_limit or robot.limit
    for arc in np.linspace(*np.add(at, tolerance.offsets), 301):
        x, y = HULL.at_arc_length(float(arc) % HULL.perimeter).point
        pulled = n[:, :2] + n[:, 2:] * np.array([-y, x])
        for turn in np.linspace(*tolerance.turns, 1 if robot.friction or robot.least else 5):
            drawn = _drawn(robot, robot.direction + float(turn), limit)
            least = np.minimum(least, reference.force_support(drawn, pulled))
    least = np.zeros(40) if tolerance.may_be_absent else least
    assert (found <= least + 1e-12).all()
    assert found == pytest.approx(least, abs=1e-2)


def _arc_of(point):
    """Return the arc length [m] of a point on the hull."""
    arcs = np.linspace(0.0, HULL.perimeter, 121)[:-1]
    away = [np.hypot(*np.subtract(HULL.at_arc_length(float(arc)).point, point)) for arc in arcs]
    return float(arcs[int(np.argmin(away))])


def _drawn(robot, direction, limit):
    """Return a robot as its pose is drawn."""
    return Robot(
        robot.contact, direction, limit, steers=robot.steers, reverse_limit=robot.reverse_limit,
        friction=robot.friction, least=robot.least,
    )  # fmt: skip


# -- documents ------------------------------------------------------------------------

NEWCOMERS = {
    "ray": Newcomer(attachment="push"),
    "both ways": Newcomer(reverse_limit=1.0),
    "steers": Newcomer(attachment="push", half_angle=0.5, steers=True),
    "finger": Newcomer(attachment="push", friction=0.5),
}


@cache
def honest(name):
    """Return the document of a newcomer beside all of them."""
    terms = {"worst_case": True, "failures": [("finger",), ("sector",)]}
    return document_of(place(Swarm(HULL, CREW, 1.5), NEWCOMERS[name], gap=1e-2, **terms))


@pytest.mark.parametrize("name", NEWCOMERS)
def test_an_honest_answer_passes(name):
    """And says that the qualities are bounded from above only."""
    verdict = judge(copy.deepcopy(honest(name)))
    assert verdict, verdict.faults
    assert verdict.unchecked == (FROM_ABOVE,)
    assert first(honest(name))["quality"] > 0.1


@pytest.mark.parametrize("name", NEWCOMERS)
def test_a_quality_too_high_is_refused(name):
    """By a thousandth, of the swarm before and with the newcomer."""
    for key in ("quality_before", "quality"):
        document = copy.deepcopy(honest(name))
        first(document)[key] *= 1.001
        assert any(fault.startswith("the quality") for fault in judge(document).faults)


def _drift(document):
    document["problem"]["swarm"]["robots"][2]["tolerance"]["contact"] = [-0.9, 0.9]


def _turn(document):
    document["problem"]["swarm"]["robots"][1]["tolerance"]["direction"] = [-0.4, 0.6]


def _weaken(document):
    document["problem"]["swarm"]["robots"][2]["tolerance"]["least_limit"] = 0.5


@pytest.mark.parametrize("spoil", [_drift, _turn, _weaken])
def test_other_tolerances_give_another_quality(spoil):
    """Robots said to be surer than the answer took them for are found out."""
    document = copy.deepcopy(honest("steers"))
    spoil(document)
    assert any("the quality" in fault for fault in judge(document).faults)


@pytest.mark.parametrize(
    ("index", "tolerance", "says"),
    [
        (3, {"direction": [-0.1, 0.0]}, "its direction is uncertain: that is not known how"),
        (4, {"direction": [0.0, 0.1]}, "its direction is uncertain: that is not known how"),
        (6, {"least_limit": 0.05}, "a least limit beside an envelope, or below its least force"),
    ],
)
def test_what_has_no_certain_force_is_refused_in_words(index, tolerance, says):
    """Friction or steering both ways of uncertain direction, and what is less than its least."""
    document = copy.deepcopy(honest("ray"))
    robot = document["problem"]["swarm"]["robots"][index]
    robot["tolerance"].update(tolerance)
    with pytest.raises(AnswerInvalid, match=says) as refusal:
        judge(document)
    assert repr(robot["name"]) in str(refusal.value)
