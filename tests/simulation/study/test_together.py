"""Robots placed together against one after the other."""

import numpy as np
import pytest

import swarmgrasp as sg
from swarmgrasp.errors import StudyInvalid
from swarmgrasp.simulation.study import PlacedTogether, gather, run_plan, together
from swarmgrasp.simulation.study.crowds import Crowds
from workers import Inline


def test_a_run_is_a_question_that_can_be_asked_again(problem, plan_of, tmp_path, monkeypatch):
    """Of the swarm that its seed draws; the better way is not worse, and no more than the bound."""
    monkeypatch.setattr(together, "EFFORT", 20)
    study = PlacedTogether(problem, 4, 5)
    plan = plan_of(3, 2, study)
    run_plan(tmp_path / "a", plan, executor=Inline())
    told = study.measure(plan.seeds(1)[:1])
    draws = np.random.default_rng(plan.seeds(1)[:1])
    swarm = Crowds(problem).swarm(draws, int(draws.integers(4, 5, endpoint=True)))
    placed = sg.place_sequence(sg.Problem(swarm, problem.newcomer), 2)
    assert told["before"] == [sg.quality(swarm).value]
    assert told["sequential"] == [placed[-1].quality]
    assert told["sequential"][0] <= told["together"][0] * (1.0 + 1e-9)
    assert told["together"][0] <= told["bound"][0] * (1.0 + 1e-9)
    found = gather(tmp_path / "a").findings
    assert sum(row[1] for row in found.rows) == 3
    assert found.headline.endswith("of 3 random swarms")


def test_where_there_is_no_room_is_a_fault_of_the_run(problem, plan_of, tmp_path):
    """Told in the report."""
    tight = sg.Problem(problem.swarm, problem.newcomer, spacing=500.0)
    run_plan(tmp_path / "a", plan_of(2, 2, PlacedTogether(tight)), executor=Inline())
    found = gather(tmp_path / "a")
    assert (found.runs, found.failed) == (2, 2)
    assert "NowhereToAttach: " in found.faults[0]
    assert found.findings.rows == ()


def test_what_cannot_be_is_refused_at_once(problem):
    """Newcomers and robots."""
    with pytest.raises(StudyInvalid) as caught:
        PlacedTogether(problem, 0, 5, newcomers=1)
    assert [fault.split(";")[0] for fault in caught.value.faults] == [
        "the robots are from 0 to 5", "the newcomers are 1"
    ]  # fmt: skip
