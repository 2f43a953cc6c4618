"""A robot whose software speaks ROS 2, as rmw_zenoh carries it: experimental.

Between the keys of a robot's body and topics of ROS 2. Messages are CDR, made without an installed
ROS 2; keys, attachments and tokens are those of rmw_zenoh as of 2025. It is tried against itself
and against rosbags, never against a running ROS 2.
"""

import json
import math
import re
import struct
import time
from collections.abc import Callable
from dataclasses import dataclass
from queue import SimpleQueue
from typing import Any

import zenoh
from rosbags.typesys import Stores, get_typestore

from swarmgrasp.agents.network.keys import Keys
from swarmgrasp.agents.network.session import open_session
from swarmgrasp.agents.network.settings import NetworkSettings
from swarmgrasp.errors import AgentInvalid
from swarmgrasp.ranges import is_whole, shown

TYPES = get_typestore(Stores.ROS2_JAZZY)
POSE, TEXT = "geometry_msgs/msg/PoseStamped", "std_msgs/msg/String"
FRAME = "object"
"""The frame of all poses: that of the outline's vertices."""
MOST_WAITING = 1000
"""Messages that wait to be carried; more are dropped, and counted."""
MOST_DOMAIN = 232
"""Largest domain of ROS 2."""
QOS = "::,10:,:,:,,"
"""Reliable, volatile, the last ten: what ROS 2 does unless told otherwise."""
_NO_SIGN = re.compile(r"[^A-Za-z0-9_]")


@dataclass(frozen=True)
class Topic:
    """A topic of one robot.

    Attributes
    ----------
    name : str
        With its first slash.
    kind : str
        The message's, as in `geometry_msgs/msg/PoseStamped`.
    domain : int
    """

    name: str
    kind: str
    domain: int

    @property
    def dds_kind(self) -> str:
        """The message's kind as it stands in keys."""
        package, _, message = self.kind.split("/")
        return f"{package}::msg::dds_::{message}_"

    @property
    def key(self) -> str:
        """The key of its messages."""
        return f"{self.domain}/{self.name[1:]}/{self.dds_kind}/{TYPES.hash_rihs01(self.kind)}"

    def token(self, session: str, number: int, node: str, writes: bool) -> str:
        """Return the token by which ROS 2 sees who writes or reads it."""
        what = "MP" if writes else "MS"
        where = f"@ros2_lv/{self.domain}/{session}/0/{number}/{what}/%/%/{node}"
        name = self.name.replace("/", "%")
        return f"{where}/{name}/{self.dds_kind}/{TYPES.hash_rihs01(self.kind)}/{QOS}"


def topics_of(name: str, domain: int) -> dict[str, Topic]:
    """Return a robot's topics.

    Raises
    ------
    AgentInvalid
        If the domain is none of ROS 2's.

    Examples
    --------
    >>> [topic.name for topic in topics_of("Ajax", 0).values()][:2]
    ['/swarmgrasp/Ajax/order', '/swarmgrasp/Ajax/target']
    """
    if not is_whole(domain) or not 0 <= domain <= MOST_DOMAIN:
        raise AgentInvalid(f"the domain is {shown(domain)}; it should be 0 to {MOST_DOMAIN}")
    plain = _NO_SIGN.sub("_", name)
    base = f"/swarmgrasp/{plain if not plain[0].isdigit() else f'_{plain}'}"
    kinds = {"order": TEXT, "target": POSE, "event": TEXT, "pose": POSE}
    return {word: Topic(f"{base}/{word}", kind, domain) for word, kind in kinds.items()}


def pose_message(x: float, y: float, direction: float, now: float) -> bytes:
    """Return a place as a PoseStamped: its x axis is the direction of the force.

    Parameters
    ----------
    x, y : float [m]
    direction : float [rad]
    now : float [s]
        Since 1970.
    """
    make = TYPES.types
    point = make["geometry_msgs/msg/Point"](x=x, y=y, z=0.0)
    half = 0.5 * direction
    turned = make["geometry_msgs/msg/Quaternion"](x=0.0, y=0.0, z=math.sin(half), w=math.cos(half))
    seconds = math.floor(now)
    stamp = make["builtin_interfaces/msg/Time"](sec=seconds, nanosec=int((now - seconds) * 1e9))
    header = make["std_msgs/msg/Header"](stamp=stamp, frame_id=FRAME)
    pose = make["geometry_msgs/msg/Pose"](position=point, orientation=turned)
    return bytes(TYPES.serialize_cdr(make[POSE](header=header, pose=pose), POSE))


def text_message(text: str) -> bytes:
    """Return text as a message of ROS 2."""
    return bytes(TYPES.serialize_cdr(TYPES.types[TEXT](data=text), TEXT))


def place_of(data: bytes) -> dict[str, float]:
    """Return where a PoseStamped is: x and y [m], and the direction of its x axis [rad].

    Raises
    ------
    AgentInvalid
        If the bytes are none, or its quaternion is not one of a turn in the plane.
    """
    pose = _read(data, POSE).pose
    turned, point = pose.orientation, pose.position
    size = math.hypot(turned.x, turned.y, turned.z, turned.w)
    numbers = (point.x, point.y, size)
    if not all(map(math.isfinite, numbers)) or not 0.5 < size < 2.0:
        raise AgentInvalid("a pose of ROS 2 is not finite, or its orientation is no rotation")
    if math.hypot(turned.x, turned.y) > 0.1 * size:
        raise AgentInvalid("a pose of ROS 2 leans out of the plane: its z axis should point up")
    direction = 2.0 * math.atan2(turned.z, turned.w)
    return {"x": point.x, "y": point.y, "direction": math.remainder(direction, math.tau)}


def text_of(data: bytes) -> str:
    """Return the text of a message of ROS 2.

    Raises
    ------
    AgentInvalid
        If the bytes are none.
    """
    return str(_read(data, TEXT).data)


def target_of(data: bytes) -> tuple[float, float, float] | None:
    """Return where an order sends a robot: x, y [m] and direction [rad]; None for nowhere.

    Raises
    ------
    AgentInvalid
        If the bytes are no order.
    """
    try:
        order = json.loads(data)
    except (ValueError, RecursionError):
        order = None
    match order:
        case {"order": str(), "x": float(x), "y": float(y), "direction": float(direction)}:
            if all(map(math.isfinite, (x, y, direction))):
                return x, y, direction
        case {"order": str()} if "x" not in order:
            return None
    raise AgentInvalid(f"{len(data)} bytes are no order")


def attachment(sequence: int, stamp: int, writer: bytes) -> bytes:
    """Return what rmw_zenoh sends beside each message.

    Parameters
    ----------
    sequence : int
        Of the writer's messages.
    stamp : int [ns]
        Since 1970.
    writer : bytes
        Sixteen of them, the writer's own.
    """
    return struct.pack("<qqB", sequence, stamp, len(writer)) + writer


class Ros2Bridge:
    """Carries one robot's orders to ROS 2, and poses and events back.

    Parameters
    ----------
    swarm, ros : NetworkSettings
        How the robots' network, and ROS 2's router, are reached.
    keys : Keys
        The robot's.
    domain : int
        Of ROS 2.
    tell : callable
        Takes sentences for a person.
    """

    def __init__(
        self, swarm: NetworkSettings, ros: NetworkSettings, keys: Keys, domain: int,
        tell: Callable[[str], None],
    ) -> None:  # fmt: skip
        self._keys, self._tell = keys, tell
        self._topics = topics_of(keys.name, domain)
        self._inbox: SimpleQueue[tuple[str, bytes]] = SimpleQueue()
        self._dropped = 0
        self._swarm, self._ros = open_session(swarm), open_session(ros)
        self._writer = bytes.fromhex(str(self._ros.info.zid()).zfill(32))
        self._sequence = 0
        self._kept: list[Any] = []

    def begin(self) -> None:
        """Listen on both sides, and be seen by ROS 2."""
        swarm, ros, topics = self._swarm, self._ros, self._topics
        self._kept.append(swarm.declare_subscriber(self._keys.order, self._take("order")))
        for word in ("event", "pose"):
            self._kept.append(ros.declare_subscriber(topics[word].key, self._take(word)))
        life, session = ros.liveliness(), str(ros.info.zid())
        node = f"swarmgrasp_{_NO_SIGN.sub('_', self._keys.name)}"
        domain = topics["order"].domain
        tokens = [f"@ros2_lv/{domain}/{session}/0/0/NN/%/%/{node}"]
        for number, (word, topic) in enumerate(topics.items(), start=1):
            writes = word in {"order", "target"}
            tokens.append(topic.token(session, number, node, writes))
        self._kept += [life.declare_token(token) for token in tokens]

    def run(self) -> None:
        """Carry until `stop`."""
        while (taken := self._inbox.get())[0] != "end":
            word, data = taken
            dropped, self._dropped = self._dropped, 0
            if dropped:
                self._tell(f"{self._keys.name}: {dropped} messages lost, which came too fast")
            try:
                self._carry(word, data)
            except AgentInvalid as error:
                self._tell(f"{self._keys.name}: {error.faults[0]}")
        self._swarm.close()
        self._ros.close()

    def stop(self) -> None:
        """End soon; may be called from a signal's handler."""
        self._inbox.put(("end", b""))

    def _carry(self, word: str, data: bytes) -> None:
        """Carry a message from one side to the other."""
        if word == "order":
            place = target_of(data)
            if place is not None:
                self._write("target", pose_message(*place, time.time()))
            self._write("order", text_message(data.decode()))
        elif word == "pose":
            self._say({"event": "pose", **place_of(data)})
        else:
            self._swarm.put(self._keys.event, text_of(data).encode())

    def _say(self, event: dict[str, Any]) -> None:
        """Tell the robot's agent of an event."""
        self._swarm.put(self._keys.event, json.dumps(event).encode())

    def _write(self, word: str, data: bytes) -> None:
        """Write a message of ROS 2."""
        self._sequence += 1
        beside = attachment(self._sequence, time.time_ns(), self._writer)
        cdr = zenoh.Encoding.APPLICATION_CDR
        self._ros.put(self._topics[word].key, data, attachment=beside, encoding=cdr)

    def _take(self, word: str) -> Callable[[zenoh.Sample], None]:
        """Return what takes samples of a kind."""

        def take(sample: zenoh.Sample) -> None:
            if self._inbox.qsize() >= MOST_WAITING:
                self._dropped += 1
            elif sample.kind == zenoh.SampleKind.PUT:
                self._inbox.put((word, sample.payload.to_bytes()))

        return take


def _read(data: bytes, kind: str) -> Any:
    """Return the message of a kind that bytes hold."""
    try:
        return TYPES.deserialize_cdr(data, kind)
    except Exception as error:  # rosbags raises what its generated code meets
        raise AgentInvalid(f"{len(data)} bytes are no {kind}: {error}") from None
