"""What the loss of one robot leaves."""

import numpy as np
import pytest

import swarmgrasp as sg
from swarmgrasp.simulation.study import Losses, gather, run_plan
from swarmgrasp.simulation.study.crowds import Crowds
from swarmgrasp.simulation.study.losses import qualities_after_losses
from workers import Inline


def test_losses_by_arrays_are_those_of_swarms(problem):
    """The worst by the criterion of one loss, and each robot's by taking it away."""
    crowds = Crowds(problem)
    for count in (2, 6, 9):
        rows = crowds.generators(crowds.draw(np.random.default_rng(count), (1, count)))
        swarm = crowds.swarm(np.random.default_rng(count), count)
        (left,) = qualities_after_losses(rows)
        alone = [sg.quality(swarm.without(robot.name)).value for robot in swarm]
        assert left == pytest.approx(alone, rel=1e-9, abs=1e-9)
        worst = sg.quality(swarm, losing=1).value
        assert left.min() == pytest.approx(worst, rel=1e-9, abs=1e-9)


def test_what_is_summed_up_is_what_was_measured(problem, plan_of, tmp_path):
    """A swarm whose worst loss leaves nothing has a vital robot, and only such a one."""
    study = Losses(problem, 6, 8)
    told = study.measure(plan_of(400, 400, study).seeds(0))
    closed = told["quality"] > 0.0
    assert ((told["after"] == 0.0) == (told["vital"] > 0)).all()
    assert (told["vital"][~closed] == told["robots"][~closed]).all()
    assert (told["after"] <= told["quality"] * (1.0 + 1e-12)).all()
    run_plan(tmp_path / "a", plan_of(400, 400, study), executor=Inline())
    found = gather(tmp_path / "a").findings
    for robots, runs, share, kept, vital, left in found.rows:
        alike = told["robots"] == robots
        both = alike & closed
        assert (runs, share) == (alike.sum(), pytest.approx(np.mean(closed[alike])))
        assert kept == pytest.approx(np.mean(told["after"][alike] > 0.0))
        assert vital == pytest.approx(np.mean(told["vital"][both]))
        assert left == pytest.approx(np.median(told["after"][both] / told["quality"][both]))
    assert found.headline.startswith("Less than half of the random swarms of up to 8 robots bear")
