"""A recorded run comes to the page from either of its files, number by number."""

import json
from dataclasses import replace

import numpy as np
import pytest

from made_runs import made_run
from paged import unframed
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.gui.runs import read_run
from swarmgrasp.simulation.export.player import player_data, write_player
from swarmgrasp.simulation.record import read_log, write_log
from swarmgrasp.terms import SI, Terms


@pytest.fixture(scope="module")
def run():
    return made_run()


def test_both_files_tell_the_same_run(run, tmp_path):
    """The player's JSON, and the log in Parquet."""
    played = read_run(write_player(run, tmp_path / "run.json"))
    logged = read_run(write_log(run, tmp_path / "run.parquet"))
    assert played.played == logged.played
    told = unframed(played.told(3, SI))
    data = player_data(run)
    assert (told["n"], told["name"], told["seed"]) == (3, "run.json", data["seed"])
    assert [robot["there"] for robot in told["robots"]] == [r["there"] for r in data["robots"]]
    assert [r["name"] for r in told["robots"] if r["newcomer"]] == [
        route["robot"] for route in data["routes"]
    ]
    off = np.array(data["poses"]) - np.array(data["references"])
    far = np.hypot(off[:, 0], off[:, 1]).max()
    assert told["first"]["good"] is bool(far <= told["within"] and abs(off[:, 2]).max() < 0.08)
    for one, other in zip(told["happenings"], data["happenings"], strict=True):
        assert one == {key: other[key] for key in ("time", "kind", "robot", "words")}
    for name in ("times", "poses", "references", "wind", "water", "shortfalls", "forces"):
        assert np.array_equal(told[name], np.array(data[name], np.float32))
    angles = np.array(data["angles"], float).astype(np.float32)
    assert np.array_equal(told["angles"], angles, equal_nan=True)


def test_what_happens_is_told_in_the_terms_of_the_scene(run, tmp_path):
    """From numbers, where there are some; a run that lacks one of them is none."""
    first, *others = run.happenings
    aim = {"x": 3.048, "y": 0.0, "heading": 0.0}
    path = tmp_path / "run.json"
    moved = replace(run, happenings=(replace(first, kind="aim", numbers=aim), *others))
    told = unframed(read_run(write_player(moved, path)).told(1, Terms("ft")))
    words = [happening["words"] for happening in told["happenings"]]
    assert words[0] == "the object is to move to (10, 0) ft, heading 0 deg"
    assert words[1:] == [happening.words for happening in others]
    path.write_text(path.read_text().replace('"x":3.048,', ""))
    with pytest.raises(SimulationInvalid, match="is no run"):
        read_run(path)


def test_a_log_gives_the_run_back(run, tmp_path):
    """What was simulated, who was there when, and every number that was kept."""
    again = read_log(write_log(run, tmp_path / "run.parquet"))
    assert again.simulation == run.simulation
    assert [stint.swarm for stint in again.stints] == [stint.swarm for stint in run.stints]
    assert player_data(again, index=1) == player_data(run, index=1)
    assert np.array_equal(again.shares, run.shares)


@pytest.mark.parametrize("raw", [b"", b"{}", b"[1]", b'{"format": "x"}', b"PAR1"])
def test_what_is_no_run_is_told(raw, tmp_path):
    """Of either kind, with its name."""
    for name in ("run.json", "run.parquet"):
        path = tmp_path / name
        path.write_bytes(raw)
        with pytest.raises(SimulationInvalid, match=name):
            read_run(path)
        with pytest.raises(SimulationInvalid, match="missing"):
            read_run(tmp_path / f"missing-{name}")


def test_columns_that_do_not_go_together_are_told(run, tmp_path):
    """A run cut short in one column."""
    data = player_data(run)
    data["poses"].pop()
    (tmp_path / "run.json").write_text(json.dumps(data))
    with pytest.raises(SimulationInvalid, match="instants"):
        read_run(tmp_path / "run.json")
