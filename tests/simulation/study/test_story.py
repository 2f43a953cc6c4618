"""A simulation with other gusts in each run."""

import pytest

from moored import moored
from swarmgrasp.errors import StudyInvalid
from swarmgrasp.simulation.simulate import simulate
from swarmgrasp.simulation.study import Story, gather, run_plan
from swarmgrasp.simulation.weather import Weather
from workers import Inline


def test_a_run_is_its_seed_s_simulation(plan_of, tmp_path):
    """Whatever batch it was in; runs are summed up by what parts of them stay within."""
    asked = moored("deck-barge", 60.0, 60.0, duration=60.0, weather=Weather("npd"), seed=7)
    study = Story(asked)
    assert study.simulation.seed == 0
    assert study == Story.from_data(study.to_data())
    plan = plan_of(4, 3, study)
    told = study.measure(plan.seeds(0))
    alone = simulate(asked, [int(told["seed"][2])])
    assert told["distance"][2] == pytest.approx(float(alone.distances.max()), rel=1e-6)
    assert told["gusts"][2] == alone.gusts[0]
    run_plan(tmp_path / "a", plan, executor=Inline())
    found = gather(tmp_path / "a").findings
    assert found.headline.endswith("of 4 runs")
    assert [row[0] for row in found.rows][-1] == 1.0
    assert found.rows[-1][1] >= max(told["distance"])
    assert sorted(row[1] for row in found.rows) == [row[1] for row in found.rows]


def test_what_is_no_simulation_is_refused(problem):
    """By name."""
    with pytest.raises(StudyInvalid, match="Problem is no Simulation"):
        Story(problem)
