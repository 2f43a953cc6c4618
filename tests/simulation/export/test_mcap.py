"""A run for Foxglove: read back by another reader."""

import json
import math
from collections import Counter

import jsonschema
import numpy as np
import pytest
from mcap.reader import make_reader

from made_runs import made_run
from protobuf_by_hand import decoded, messages_of
from swarmgrasp.simulation.export.mcap import write_mcap


@pytest.fixture(scope="module")
def run():
    return made_run(instants=31)


@pytest.fixture(scope="module")
def written(run, tmp_path_factory):
    return write_mcap(run, tmp_path_factory.mktemp("mcap") / "run.mcap", index=1)


@pytest.fixture(scope="module")
def messages(written):
    """All messages as (topic, time, content), read by the schemas that the file stores."""
    found = []
    with written.open("rb") as file:
        for schema, channel, message in make_reader(file).iter_messages():
            if schema.encoding == "protobuf":
                known = messages_of(schema.data)
                content = decoded(message.data, f".{schema.name}", known)
            else:
                content = json.loads(message.data)
                jsonschema.validate(content, json.loads(schema.data))
            found.append((channel.topic, message.log_time, content))
    return found


def test_topics_and_schemas_are_those_that_foxglove_draws(run, written, messages):
    """Frames, forces and a state for each instant; outlines once; names when they change."""
    with written.open("rb") as file:
        summary = make_reader(file).get_summary()
    schemas = {c.topic: summary.schemas[c.schema_id].name for c in summary.channels.values()}
    assert schemas == {
        "/tf": "foxglove.FrameTransforms",
        "/state": "swarmgrasp.State",
        **dict.fromkeys(("/outlines", "/names", "/forces"), "foxglove.SceneUpdate"),
    }
    instants = len(run.times)
    assert Counter(topic for topic, _, _ in messages) == {
        "/tf": instants, "/forces": instants, "/state": instants, "/outlines": 1, "/names": 3,
    }  # fmt: skip


def test_every_message_is_whole_in_frames_that_are_there(run, messages):
    """One that was sought is drawn: its frames hang on the earth's, and it stays."""
    for topic, time, content in messages:
        if topic == "/tf":
            frames = {t["child_frame_id"]: t["parent_frame_id"] for t in content["transforms"]}
            assert frames == {"object": "earth", "target": "earth"}
            assert all(hypot(t["rotation"]) == pytest.approx(1.0) for t in content["transforms"])
        for entity in content.get("entities", ()):
            assert entity["frame_id"] in ("object", "target")
            assert "lifetime" not in entity  # for ever
            assert time == 10**9 * entity["timestamp"].get("seconds", 0)
    poses = [c["transforms"][0]["translation"] for t, _, c in messages if t == "/tf"]
    assert [pose.get("x", 0.0) for pose in poses] == run.poses[1, :, 0].tolist()


def test_arrows_are_the_forces(run, messages):
    """As long as they are strong, along them, from outside to the contact where robots push."""
    k, name = 15, "Ajax"
    content = next(c for t, at, c in messages if (t, at) == ("/forces", 10**9 * run.times[k]))
    (entity,) = content["entities"]
    swarm = run.stints[1].swarm
    assert len(entity["arrows"]) == len(swarm)
    assert len(entity["spheres"]) == 1  # Fortuna, on its way
    arrow, extent = entity["arrows"][swarm.names.index(name)], swarm.outline.extent
    share = float(run.forces[1, k, run.names.index(name)]) / strongest(run)
    length = arrow["shaft_length"] + arrow["head_length"]
    assert length == pytest.approx(0.25 * extent * share)
    pose = arrow["pose"]
    turn = 2.0 * math.atan2(pose["orientation"]["z"], pose["orientation"]["w"])
    tip = np.array([pose["position"]["x"], pose["position"]["y"]])
    tip = tip + length * np.array([math.cos(turn), math.sin(turn)])
    contact = np.array(swarm[name].contact) - swarm.outline.origin
    assert tip == pytest.approx(contact, abs=1e-6)


def strongest(run):
    return max(robot.limit for stint in run.stints for robot in stint.swarm)


def hypot(parts):
    return math.hypot(*parts.values())


def test_the_clock_starts_at_0_and_states_are_the_runs(run, messages):
    """Nanoseconds since the start, and the numbers of the run that was chosen."""
    states = [(time, content) for topic, time, content in messages if topic == "/state"]
    assert [time for time, _ in states] == [round(1e9 * t) for t in run.times]
    k = 20
    told = states[k][1]
    assert told["shortfall"] == pytest.approx(float(run.shortfalls[1, k]))
    assert told["wind"] == pytest.approx(run.streams[1, k, :2].tolist())
    assert told["shares"]["Castor"] == 0.0
