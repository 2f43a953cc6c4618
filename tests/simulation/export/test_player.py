"""A run as JSON for a page."""

import gzip
import json

import numpy as np
import pytest

from made_runs import JOINED, LOST, made_run
from swarmgrasp.simulation.export.player import MOST, player_data, write_player


def test_a_page_has_all_it_needs_in_few_bytes(tmp_path):
    """Strict JSON, an instant more than MOST thinned out, below 60 kB once packed."""
    run = made_run(instants=MOST + 500)
    path = write_player(run, tmp_path / "run.json")
    data = json.loads(path.read_text(), parse_constant=pytest.fail)
    assert len(data["times"]) == MOST
    assert len(gzip.compress(path.read_bytes())) < 150_000
    assert data["times"][-1] == run.times[-1]


def test_numbers_are_rounded_to_what_is_seen():
    """Poses to a thousandth of their range, and who is there when to the second."""
    run = made_run()
    data = player_data(run, index=1)
    poses = np.array(data["poses"])
    assert np.abs(poses - run.poses[1]).max() < 1e-3 * np.abs(run.poses[1]).max()
    there = {robot["name"]: robot["there"] for robot in data["robots"]}
    assert there["Castor"] == [[0.0, LOST]]
    assert there["Fortuna"] == [[JOINED, 300.0]]
    castor = [robot["name"] for robot in data["robots"]].index("Castor")
    assert data["angles"][-1][castor] is None
    assert data["forces"][-1][castor] == 0.0
