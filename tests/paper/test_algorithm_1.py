import math
import sys
from dataclasses import replace

import numpy as np
import pytest

import reference
from swarmgrasp import Criterion, Newcomer, Outline, Problem, Robot, Swarm, place, quality
from swarmgrasp.errors import NotInThePaper, PackageMissing
from swarmgrasp.paper import Printed, algorithm_1, relaxed_optimum
from swarmgrasp.paper.algorithm_1 import PRECISION
from swarmgrasp.paper.draws import problem

DRAWS = [(3, n, k) for n in (5, 15) for k in range(4)]
WEIGHTS = (0.5, 2.0)


@pytest.mark.parametrize("task", DRAWS)
def test_it_promises_no_more_than_the_cylinder_allows(task):
    """With 15 robots it gets near that, with 5 it may be stuck at 0; its robot is a real one."""
    question = problem(task)
    answer, most = algorithm_1(question), relaxed_optimum(question)
    assert answer.ended
    assert answer.promised <= most.upper_bound + 1e-5
    if len(question.swarm) == 15:
        assert answer.promised >= most.quality - 10.0 * PRECISION
    attached = question.swarm.with_robot(answer.attach().robot)
    assert quality(attached).value <= place(question.swarm, question.newcomer).upper_bound + 1e-9


def test_what_it_promises_its_wrench_keeps():
    """The quality with the wrench in the cylinder, by the slow formula."""
    question = problem((3, 15, 1))
    answer = algorithm_1(question)
    wrench = answer.wrench * question.swarm.scale
    base = question.swarm.scaled_generators
    assert reference.quality(np.vstack([base, wrench])) >= answer.promised * (1.0 - 2e-6)


def test_strength_and_metric_only_scale_it():
    """A newcomer and robots of 7 N are promised 7 times as much; weights enter as they should."""
    swarm = problem((3, 15, 0)).swarm
    strong = Swarm(swarm.outline, [replace(robot, limit=7.0) for robot in swarm.robots])
    one = algorithm_1(Problem(swarm, Newcomer(1.0))).promised
    assert algorithm_1(Problem(strong, Newcomer(7.0))).promised == pytest.approx(7.0 * one)
    weighted = Problem(Swarm(swarm.outline, swarm.robots, 0.7, WEIGHTS), Newcomer(1.0))
    most = relaxed_optimum(weighted)
    assert place(weighted.swarm, weighted.newcomer).quality <= most.upper_bound
    assert algorithm_1(weighted).promised == pytest.approx(most.quality, abs=2.0 * PRECISION)


def test_misprints_followed_to_the_letter():
    """The loop is not entered, the bisection does not end, the torque has no lower end."""
    question = problem((3, 15, 0))
    loop = algorithm_1(question, printed=Printed.LOOP)
    assert (loop.queries, loop.ended) == (0, True)
    assert loop.promised == pytest.approx(quality(question.swarm).value)
    midpoint = algorithm_1(question, printed=Printed.MIDPOINT)
    assert not midpoint.ended
    assert midpoint.promised == pytest.approx(midpoint.refuted / 3.0)
    radius = question.swarm.outline.radius
    tasks = [(3, 15, k) for k in range(12)]
    wrenches = [algorithm_1(problem(t), printed=Printed.TORQUE).wrench for t in tasks]
    assert min(wrench[2] for wrench in wrenches) < -radius
    assert max(wrench[2] for wrench in wrenches) <= radius


def test_what_the_paper_does_not_know_is_refused():
    """A criterion, and swarms with no facet to start from."""
    swarm = problem((3, 15, 0)).swarm
    with pytest.raises(NotInThePaper, match="after the worst loss of 1 robot"):
        algorithm_1(Problem(swarm, Newcomer(), criterion=Criterion(losing=1)))
    square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    for robots in ([], [Robot((1, 0), 0.0)], [Robot((1, 0), 0.0), Robot((-1, 0), math.pi)]):
        with pytest.raises(NotInThePaper, match="no facet"):
            algorithm_1(Problem(Swarm(square, robots), Newcomer()))


def test_without_scipy_the_remedy_is_told(monkeypatch):
    """It is an extra, and nothing else here needs it."""
    monkeypatch.setitem(sys.modules, "scipy.optimize", None)
    question = problem((3, 5, 0))
    with pytest.raises(PackageMissing, match=r"pip install 'swarmgrasp\[paper\]'"):
        algorithm_1(question)
    assert relaxed_optimum(question).quality >= 0.0
