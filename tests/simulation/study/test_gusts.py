"""Success in gusts against margin."""

import math
from dataclasses import replace

import numpy as np
import pytest

from moored import moored
from swarmgrasp.errors import StudyInvalid
from swarmgrasp.simulation.simulate import simulate
from swarmgrasp.simulation.study import Gusts, gather, run_plan
from swarmgrasp.simulation.study.gusts import _area
from swarmgrasp.simulation.verdict import verdict_of
from workers import Inline


@pytest.fixture(scope="module")
def study():
    """Five to seven random tugs of 60 kN on the deck barge in 35 kn, for a minute."""
    given = moored("deck-barge", 35.0, 60.0, duration=60.0)
    tug = replace(given.problem.newcomer, limit=60e3)
    return Gusts(replace(given, problem=replace(given.problem, newcomer=tug)), 5, 7)


@pytest.fixture(scope="module")
def told(study):
    """Return a batch of six runs."""
    return study.measure(np.arange(6))


def test_a_run_of_a_batch_is_a_simulation_of_its_own(study, told):
    """With the same swarm, bearing and seed: the same margin, spread and largest error."""
    asked, bearings = study.drawn(np.arange(6))
    wind = replace(asked.environment.wind, bearing=float(bearings[4]))
    alone = simulate(replace(asked, environment=replace(asked.environment, wind=wind)), [4])
    start, said = alone.happenings[0], verdict_of(alone)
    assert told["robots"][4] == len(asked.problem.swarm)
    assert told["quality"][4] == pytest.approx(start.quality, rel=1e-9)
    assert told["margin"][4] == pytest.approx(start.margin - start.shortfall, rel=1e-6, abs=1e-3)
    assert told["spread"][4] == pytest.approx(said.spreads[0], rel=1e-6)
    assert told["distance"][4] == pytest.approx(float(alone.distances.max()), rel=1e-6)
    assert told["held"][4] == said.held[0]


def test_what_is_not_for_it_is_left_out(study):
    """Robots, events, named actuators; the gusts are those of NPD's spectrum."""
    kept = study.simulation
    assert (len(kept.problem.swarm), kept.events, kept.weather.gusts) == (0, (), "npd")
    assert kept.environment.current.bearing is None
    assert study == Gusts.from_data(study.to_data())


def test_the_area_is_that_of_all_pairs(study, plan_of, tmp_path):
    """How often a run that held has the larger margin than one that did not; ties count half."""
    run_plan(tmp_path / "a", plan_of(6, 6, study), executor=Inline())
    rows = [(True, 3.0), (True, 1.0), (True, 1.0), (False, 1.0), (False, 0.0), (False, 2.0)]
    values = ", ".join(f"({held}, {value}, 1.0)" for held, value in rows)
    pairs = [(a, b) for kept, a in rows if kept for lost, b in rows if not lost]
    wanted = np.mean([(a > b) + 0.5 * (a == b) for a, b in pairs])
    import duckdb

    with duckdb.connect() as base:
        base.execute(f"CREATE TABLE runs AS FROM (VALUES {values}) t(held, value, spread)")
        assert _area(lambda q: base.execute(q).fetchall(), "value") == pytest.approx(wanted)
        base.execute("DELETE FROM runs WHERE NOT held")
        assert math.isnan(_area(lambda q: base.execute(q).fetchall(), "value"))
    found = gather(tmp_path / "a").findings
    assert sum(row[2] for row in found.rows) == 6
    assert all(row[0] < row[1] for row in found.rows)


def test_what_cannot_be_is_refused(problem, study):
    """What is no simulation, and numbers of robots."""
    with pytest.raises(StudyInvalid, match="Problem is no Simulation"):
        Gusts(problem, 5, 7)
    with pytest.raises(StudyInvalid, match="from 7 to 5"):
        Gusts(study.simulation, 7, 5)
