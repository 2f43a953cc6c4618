"""A run for Foxglove: read back by another reader."""

import json

import pytest
from mcap.reader import make_reader

from made_runs import made_run
from swarmgrasp.simulation.export.mcap import write_mcap


@pytest.fixture(scope="module")
def run():
    return made_run(instants=31)


@pytest.fixture(scope="module")
def written(run, tmp_path_factory):
    return write_mcap(run, tmp_path_factory.mktemp("mcap") / "run.mcap", index=1)


def test_topics_and_schemas_are_those_that_foxglove_draws(run, written):
    """Two frames, one scene and one state for each instant."""
    with written.open("rb") as file:
        summary = make_reader(file).get_summary()
    counts = {
        summary.channels[i].topic: count
        for i, count in summary.statistics.channel_message_counts.items()
    }
    instants = len(run.times)
    assert counts == {"/tf": 2 * instants, "/scene": instants, "/state": instants}
    schemas = {schema.name for schema in summary.schemas.values()}
    assert {"foxglove.SceneUpdate", "foxglove.FrameTransform"} <= schemas


def test_the_clock_starts_at_0_and_states_are_the_runs(run, written):
    """Nanoseconds since the start, and the numbers of the run that was chosen."""
    with written.open("rb") as file:
        messages = [
            (message.log_time, json.loads(message.data))
            for _, _, message in make_reader(file).iter_messages(topics=["/state"])
        ]
    assert [time for time, _ in messages] == [round(1e9 * t) for t in run.times]
    k = 20
    told = messages[k][1]
    assert told["shortfall"] == pytest.approx(float(run.shortfalls[1, k]))
    assert told["wind"] == pytest.approx(run.streams[1, k, :2].tolist())
    assert told["shares"]["Castor"] == 0.0
