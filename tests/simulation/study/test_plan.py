"""Plans, and the folders that hold them."""

import json
from dataclasses import replace

import numpy as np
import pytest

import swarmgrasp as sg
from swarmgrasp.errors import StudyInvalid
from swarmgrasp.simulation.study import Plan, Sizes, read_plan, run_plan
from swarmgrasp.simulation.study.plan import PLAN, folder_of
from swarmgrasp.simulation.study.plan import plan_of as parsed
from workers import Inline


def test_a_plan_comes_back(plan_of, problem):
    """Equal, and written the same; the robots of its problem are left out."""
    plan = plan_of(10, 3)
    assert parsed(plan.text) == plan
    assert parsed(plan.text).text == plan.text
    crew = sg.Swarm(problem.swarm.outline, [sg.Robot((40, 0), 3.0)])
    assert len(Sizes(problem.with_swarm(crew)).problem.swarm) == 0
    assert Plan.of("Barge", Sizes(problem), 10).size == Sizes.size


def test_the_seeds_of_a_shard_hang_on_the_plan_s_own_alone(plan_of):
    """On neither the number of runs nor the other shards; the last shard may be short."""
    plan, longer = plan_of(10, 4), plan_of(1000, 4)
    assert [plan.count(shard) for shard in range(plan.shards)] == [4, 4, 2]
    assert (plan.seeds(1) == longer.seeds(1)).all()
    assert (plan.seeds(1) != replace(plan, seed=2).seeds(1)).all()
    every = np.concatenate([longer.seeds(shard) for shard in range(longer.shards)])
    assert len(set(every.tolist())) == 1000
    assert every.min() >= 0


def test_what_cannot_be_planned_is_refused_at_once():
    """All faults, each with its value and range."""
    with pytest.raises(StudyInvalid) as caught:
        Plan("\0", "study", 0, -1, 1.5, "", "")
    assert caught.value.faults == (
        "the name '\\x00' holds U+0000, a control character; leave it out",
        "'study' is no Study",
        "the number of runs is 0; it should be a whole number from 1 to 1000000000",
        "the seed is -1; it should be a whole number from 0 to 9223372036854775807",
        "the number of runs in a shard is 1.5; it should be a whole number from 1 to 1000000000",
    )


@pytest.mark.parametrize(
    ("damage", "says"),
    [
        (lambda _: "{", "is no JSON"),
        (lambda _: json.dumps([]), "is no plan of a study: its format should be"),
        (lambda data: json.dumps({**data, "study": {"kind": "sums"}}), "known: sizes"),
        (lambda data: json.dumps({**data, "more": 1}), "should have the keys"),
        (lambda data: json.dumps({**data, "runs": 0}), "number of runs is 0"),
        (lambda data: json.dumps({**data, "study": {**data["study"], "most_robots": "9"}}),
         "most_robots: should be a whole number; it is '9'"),
        (lambda _: b"\xff", "no text in UTF-8"),
    ],
)  # fmt: skip
def test_a_damaged_plan_is_refused_with_its_file(plan_of, tmp_path, damage, says):
    """And with the key at fault."""
    said = damage(json.loads(plan_of(10, 3).text))
    (tmp_path / PLAN).write_bytes(said.encode() if isinstance(said, str) else said)
    with pytest.raises(StudyInvalid, match=says) as caught:
        read_plan(tmp_path)
    assert caught.value.faults[0].startswith(f"{tmp_path}/study.json: ")


def test_a_folder_of_another_study_is_refused(plan_of, problem, tmp_path):
    """With all that differs; so is one that holds other files, and nothing in it is changed."""
    plan = plan_of(10, 5)
    run_plan(tmp_path / "a", plan, executor=Inline())
    before = {path.name: path.read_bytes() for path in (tmp_path / "a").iterdir()}
    other = replace(plan, runs=11, seed=2, release="0.0.9", study=Sizes(problem, 4, 7))
    with pytest.raises(StudyInvalid) as caught:
        run_plan(tmp_path / "a", other, executor=Inline())
    assert [fault.split(": ", 2)[2] for fault in caught.value.faults] == [
        "its number of runs is 10, not 11; choose another folder",
        "its seed is 1, not 2; choose another folder",
        "its version of swarmgrasp is 0.1.0, not 0.0.9; choose another folder",
        "its most_robots is another one; choose another folder",
    ]
    assert {path.name: path.read_bytes() for path in (tmp_path / "a").iterdir()} == before
    (tmp_path / "b").mkdir()
    (tmp_path / "b" / "thesis.tex").write_text("")
    with pytest.raises(StudyInvalid, match=r"holds other files and no study\.json"):
        run_plan(tmp_path / "b", plan, executor=Inline())
    with pytest.raises(StudyInvalid, match="is no folder"):
        run_plan(tmp_path / "b" / "thesis.tex", plan, executor=Inline())


def test_two_cannot_work_in_one_folder_at_once(plan_of, tmp_path):
    """The second is told; when the first is through, it may."""
    plan = plan_of(10, 5)
    with (
        folder_of(tmp_path / "a", plan),
        pytest.raises(StudyInvalid, match="another process is at work in it"),
    ):
        run_plan(tmp_path / "a", plan, executor=Inline())
    run_plan(tmp_path / "a", plan, executor=Inline())


def test_what_a_killed_process_left_half_written_is_cleared_away(plan_of, tmp_path):
    """And nothing else."""
    (tmp_path / "a").mkdir()
    (tmp_path / "a" / ".part-000000-1a2b.parquet").write_text("half")
    (tmp_path / "a" / ".mine").write_text("kept")
    run_plan(tmp_path / "a", plan_of(10, 5), executor=Inline())
    names = sorted(path.name for path in (tmp_path / "a").iterdir())
    assert names == [".mine", "part-000000.parquet", "part-000001.parquet", PLAN]
