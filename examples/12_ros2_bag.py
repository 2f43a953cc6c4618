"""Answer poses in a ROS 2 bag with the forces that tugs are to exert.

A bag holds the poses of five tugs, ten times a second, and a wanted wrench; another one is written
with the force that each of them is to exert. No ROS 2 is needed: rosbags reads and writes the
messages, and the same lines work on messages as they come. Poses are in the frame of the outline;
their x axis points along the force, as with `swarmgrasp agents ros2`.

Run it from anywhere, with `pip install 'swarmgrasp[ros2]'`; the bags go into a folder that is
removed again, and the picture into the folder it is run in.
"""

import math
from pathlib import Path
from tempfile import TemporaryDirectory

import matplotlib as mpl
import numpy as np
from rosbags.rosbag2 import Reader, Writer
from rosbags.typesys import Stores, get_typestore

import swarmgrasp as sg
from swarmgrasp.scenario import load_example

mpl.use("Agg")
import matplotlib.pyplot as plt

POSE, WRENCH = "geometry_msgs/msg/PoseStamped", "geometry_msgs/msg/WrenchStamped"
STORE = get_typestore(Stores.ROS2_JAZZY)
PERIOD, STEPS = 100_000_000, 50  # ns
barge = load_example("deck-barge").swarm


def message(kind, time, frame="object", **parts):
    """Return a stamped message: a pose of x, y and direction, or a wrench of fx, fy and tz."""
    types = STORE.types
    vector = types["geometry_msgs/msg/Vector3"]
    stamp = types["builtin_interfaces/msg/Time"](time // 10**9, time % 10**9)
    header = types["std_msgs/msg/Header"](stamp, frame)
    if kind == WRENCH:
        fx, fy, tz = parts["wrench"]
        wrench = types["geometry_msgs/msg/Wrench"](vector(fx, fy, 0.0), vector(0.0, 0.0, tz))
        return types[kind](header, wrench)
    x, y, direction = parts["pose"]
    turn = types["geometry_msgs/msg/Quaternion"](
        0.0, 0.0, math.sin(0.5 * direction), math.cos(0.5 * direction)
    )
    return types[kind](
        header, types["geometry_msgs/msg/Pose"](types["geometry_msgs/msg/Point"](x, y, 0.0), turn)
    )


def record(path):
    """Write a bag of poses, with what is wanted: ever more to port."""
    rng = np.random.default_rng(3)
    with Writer(path, version=9) as bag:
        poses = {
            r.name: bag.add_connection(f"/{r.name}/pose", POSE, typestore=STORE) for r in barge
        }
        wanted = bag.add_connection("/wanted", WRENCH, typestore=STORE)
        for time in range(0, STEPS * PERIOD, PERIOD):
            for robot in barge:
                x, y = np.array(robot.contact) + rng.normal(0.0, 0.05, 2)
                pose = message(POSE, time, pose=(float(x), float(y), robot.direction))
                bag.write(poses[robot.name], time, STORE.serialize_cdr(pose, POSE))
            wrench = message(WRENCH, time, wrench=(0.0, 6e3 * time / PERIOD, 0.0))
            bag.write(wanted, time, STORE.serialize_cdr(wrench, WRENCH))


def answer(path, out):
    """Read a bag of poses, write one of forces; return times [s], shares, and what is missed."""
    swarm, told, outline = barge, [], barge.outline
    with Reader(path) as poses, Writer(out, version=9) as bag:
        forces = [
            bag.add_connection(f"/{name}/force", WRENCH, typestore=STORE) for name in swarm.names
        ]
        for connection, time, raw in poses.messages():
            said = STORE.deserialize_cdr(raw, connection.msgtype)
            if connection.msgtype == POSE:  # the tug stands at the nearest point of the hull
                name, at, turn = (
                    connection.topic.split("/")[1],
                    said.pose.position,
                    said.pose.orientation,
                )
                _, (arc,) = outline.nearest([(at.x, at.y)])
                contact = outline.at_arc_length(float(arc)).point
                swarm = swarm.with_pose(name, contact, 2.0 * math.atan2(turn.z, turn.w))
                continue
            force, torque = said.wrench.force, said.wrench.torque
            found = sg.forces(swarm, (force.x, force.y, torque.z))
            for one, (fx, fy) in zip(forces, found.vectors[:, :2].tolist(), strict=True):
                push = message(WRENCH, time, "object", wrench=(fx, fy, 0.0))
                bag.write(one, time, STORE.serialize_cdr(push, WRENCH))
            told.append((time / 1e9, found.shares, found.is_degraded))
    times, shares, short = map(np.array, zip(*told, strict=True))
    return times, shares, short


with TemporaryDirectory() as made:
    record(Path(made) / "poses")
    times, shares, short = answer(Path(made) / "poses", Path(made) / "forces")
    with Reader(Path(made) / "forces") as bag:
        print(f"{bag.message_count} forces for {len(bag.topics)} tugs, {bag.duration / 1e9:.1f} s")
print(f"out of reach from {times[short][0]:.1f} s on" if short.any() else "always within reach")

figure, ax = plt.subplots(figsize=(6.0, 2.8), layout="constrained")
for name, row in zip(barge.names, shares.T, strict=True):
    ax.plot(times, 100.0 * row, label=name)
ax.set(xlabel="time [s]", ylabel="share of the limit [%]", ylim=(0.0, 105.0))
ax.legend(frameon=False, ncols=5)
figure.savefig("ros2-forces.png", dpi=150)
