"""A robot whose software speaks ROS 2: messages, keys, and the whole way there and back."""

import json
import math
import threading
from queue import Queue
from types import SimpleNamespace

import pytest
import zenoh

from on_the_wire import await_listener, send
from swarmgrasp.agents.network.fleet import free_ports
from swarmgrasp.agents.network.keys import own_keys
from swarmgrasp.agents.network.ros2 import (
    MOST_WAITING,
    POSE,
    TEXT,
    Ros2Bridge,
    attachment,
    place_of,
    pose_message,
    text_message,
    text_of,
    topics_of,
)
from swarmgrasp.agents.network.session import open_session
from swarmgrasp.agents.network.settings import NetworkSettings
from swarmgrasp.agents.protocol import ProblemPlanner
from swarmgrasp.errors import AgentInvalid
from swarmgrasp.scenario import load_example


@pytest.mark.parametrize("direction", [0.0, 1.0, -2.5, math.pi])
def test_places_survive_a_pose_of_ros(direction):
    """A direction becomes a turn about the z axis, and comes back."""
    place = place_of(pose_message(12.5, -3.25, direction, 1_700_000_000.25))
    assert place["x"] == 12.5
    assert place["y"] == -3.25
    assert math.cos(place["direction"] - direction) == pytest.approx(1.0)


def test_what_is_no_message_of_ros_is_refused():
    """Garbage, a pose that is not finite, and one that leans out of the plane."""
    with pytest.raises(AgentInvalid, match="are no"):
        place_of(b"\x00\x01")
    with pytest.raises(AgentInvalid, match="are no"):
        text_of(b"")
    with pytest.raises(AgentInvalid, match="not finite"):
        place_of(pose_message(math.nan, 0.0, 0.0, 0.0))
    lying = bytearray(pose_message(0.0, 0.0, math.pi, 0.0))
    half = len(lying) - 32  # the quaternion x y z w stands last: z becomes x
    lying[half : half + 8], lying[half + 16 : half + 24] = (
        lying[half + 16 : half + 24], lying[half : half + 8],
    )  # fmt: skip
    with pytest.raises(AgentInvalid, match="leans"):
        place_of(bytes(lying))


def test_keys_and_attachments_are_those_of_rmw_zenoh():
    """Domain, topic, mangled type and hash of the type; counter, time and writer beside it."""
    topics = topics_of("Ajax 2", 7)
    assert topics["order"].key == (
        "7/swarmgrasp/Ajax_2/order/std_msgs::msg::dds_::String_/"
        "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"
    )
    token = topics["pose"].token("ab12", 4, "node", writes=False)
    assert token.startswith("@ros2_lv/7/ab12/0/4/MS/%/%/node/%swarmgrasp%Ajax_2%pose/geometry_msgs")
    assert attachment(1, 2, b"x" * 16) == bytes([1, *[0] * 7, 2, *[0] * 7, 16]) + b"x" * 16
    with pytest.raises(AgentInvalid, match="domain"):
        topics_of("Ajax", 233)


def test_orders_go_out_and_events_come_in():
    """An order on the robots' network is a pose on ROS 2's, and a measured pose comes back."""
    ends = [f"tcp/127.0.0.1:{port}" for port in free_ports(2)]
    routers = [open_session(NetworkSettings(mode="router", listen=(end,))) for end in ends]
    here, there = (NetworkSettings(mode="client", connect=(end,)) for end in ends)
    keys = own_keys(ProblemPlanner(load_example("deck-barge").problem()).mission, "Fortuna")
    said: Queue = Queue()
    bridge = Ros2Bridge(here, there, keys, 0, said.put)
    bridge.begin()
    carrier = threading.Thread(target=bridge.run)
    carrier.start()
    swarm, near, ros, far = map(open_session, (here, here, there, there))
    topics = topics_of("Fortuna", 0)
    events: Queue = Queue()
    poses: Queue = Queue()
    kept = [
        swarm.declare_subscriber(keys.event, lambda s: events.put(s.payload.to_bytes())),
        ros.declare_subscriber(topics["target"].key, poses.put),
    ]
    try:
        order = {"order": "go", "number": 1, "x": 1.0, "y": 2.0, "direction": 0.5, "steers": 0.0}
        await_listener(far, topics["target"].key)
        send(swarm, keys.order, json.dumps(order).encode())
        sample = poses.get(timeout=20)
        assert place_of(sample.payload.to_bytes())["direction"] == pytest.approx(0.5)
        assert len(sample.attachment.to_bytes()) == 33
        await_listener(near, keys.event)
        send(ros, topics["pose"].key, pose_message(1.1, 2.0, 0.5, 0.0))
        assert json.loads(events.get(timeout=20))["x"] == pytest.approx(1.1)
        send(ros, topics["event"].key, text_message('{"event": "at place"}'))
        assert json.loads(events.get(timeout=20)) == {"event": "at place"}
        send(ros, topics["pose"].key, b"garbage")
        assert "are no" in said.get(timeout=20)
        tokens = [str(r.ok.key_expr) for r in ros.liveliness().get("@ros2_lv/0/**")]
        assert sum("/MP/" in token for token in tokens) == 2
        assert sum("/MS/" in token for token in tokens) == 2
        assert {TEXT, POSE} == {topic.kind for topic in topics.values()}
        assert isinstance(sample, zenoh.Sample)
        assert kept
    finally:
        bridge.stop()
        carrier.join(20)
        for session in (swarm, near, ros, far, *routers):
            session.close()


def test_what_comes_too_fast_is_dropped_and_counted():
    """The bridge keeps so many messages and no more, and goes on; an order that is none is told."""
    end = f"tcp/127.0.0.1:{free_ports(1)[0]}"
    router = open_session(NetworkSettings(mode="router", listen=(end,)))
    here, said = NetworkSettings(mode="client", connect=(end,)), []
    bridge = Ros2Bridge(here, here, own_keys("m", "Fortuna"), 0, said.append)
    pose = pose_message(1.0, 2.0, 0.0, 0.0)
    for word, data, count in (
        ("order", b"[", 1),
        ("order", b'{"x": 1}', 1),
        ("pose", pose, MOST_WAITING),
    ):
        sample = SimpleNamespace(kind=zenoh.SampleKind.PUT, payload=zenoh.ZBytes(data))
        take = bridge._take(word)
        for _ in range(count):
            take(sample)
    bridge.stop()
    bridge.run()
    router.close()
    assert said == [
        "Fortuna: 2 messages lost, which came too fast",
        "Fortuna: 1 bytes are no order",
        "Fortuna: 8 bytes are no order",
    ]
