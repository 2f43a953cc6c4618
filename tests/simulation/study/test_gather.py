"""What there is of a study."""

from dataclasses import replace

import numpy as np
import pytest

from swarmgrasp.errors import StudyInvalid
from swarmgrasp.simulation.study import Losses, Sizes, gather, rows, run_plan
from swarmgrasp.simulation.study.shard import shard_bytes
from workers import Inline


def test_a_part_of_a_study_is_summed_up_too(plan_of, tmp_path):
    """By the numbers that NumPy finds; the digest changes as rows come."""
    plan, folder = plan_of(3_000, 1_000), tmp_path / "a"
    run_plan(folder, plan, executor=Inline())
    whole = gather(folder)
    assert (whole.runs, whole.failed, whole.is_whole) == (3_000, 0, True)
    plan.part(folder, 1).unlink()
    part = gather(folder)
    assert (part.runs, part.is_whole) == (2_000, False)
    assert part.digest != whole.digest
    with rows(folder) as ask:
        told = np.array(ask("SELECT robots, quality FROM runs"))
    for robots, count, closed, *quantiles in part.findings.rows:
        values = told[told[:, 0] == robots, 1]
        assert (count, closed) == (len(values), pytest.approx(np.mean(values > 0)))
        assert quantiles == pytest.approx(np.quantile(values, [0.1, 0.5, 0.9]).tolist())


def test_faults_are_counted_and_left_out(plan_of, tmp_path, monkeypatch):
    """The most frequent first."""
    plan, folder, measure = plan_of(20, 10), tmp_path / "a", Sizes.measure

    def thrown(study, seeds):
        bad = np.isin(plan.seeds(0)[:3], seeds)
        if bad.any():
            raise ValueError("bad luck" if bad[:2].any() else "worse luck")
        return measure(study, seeds)

    monkeypatch.setattr(Sizes, "measure", thrown)
    run_plan(folder, plan, executor=Inline())
    found = gather(folder)
    assert (found.runs, found.failed) == (20, 3)
    assert found.faults == ("2 x ValueError: bad luck", "1 x ValueError: worse luck")
    assert sum(row[1] for row in found.findings.rows) == 17


def test_what_is_not_there_or_damaged_is_told(plan_of, tmp_path):
    """With what to do."""
    with pytest.raises(StudyInvalid, match="holds no study; begin one with"):
        gather(tmp_path)
    plan, folder = plan_of(20, 10), tmp_path / "a"
    other = replace(plan, study=Losses(plan.study.problem, 5, 6))
    run_plan(folder, plan, executor=Inline())
    plan.part(folder, 1).write_bytes(plan.part(folder, 0).read_bytes())
    with pytest.raises(StudyInvalid, match=r"part-000001.parquet: has not the runs of its shard"):
        gather(folder)
    plan.part(folder, 0).write_bytes(b"PAR1")
    plan.part(folder, 1).write_bytes(shard_bytes(other.text, 1))
    with pytest.raises(StudyInvalid) as caught:
        gather(folder)
    remedy = "delete it and run the study again"
    assert caught.value.faults == (
        f"{folder}/part-000000.parquet: is damaged; {remedy}",
        f"{folder}/part-000001.parquet: has not the columns of this study; {remedy}",
    )
    plan.part(folder, 0).unlink()
    plan.part(folder, 1).unlink()
    with pytest.raises(StudyInvalid, match="nothing of this study is done yet"):
        gather(folder)
