"""`swarmgrasp agents ros2`: a robot's software on ROS 2."""

from typing import Annotated

from cyclopts import Parameter

from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.inputs import UsageFault, blaming, read_scenario, whole_faults
from swarmgrasp.cli.lasting import end_on_signals, say


def ros2(
    file: Dashed,
    /,
    *,
    name: str,
    connect: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    ros: Annotated[tuple[str, ...], Parameter(negative="")] = ("tcp/127.0.0.1:7447",),
    domain: Annotated[str, Parameter(metavar="INT")] = "0",
) -> None:
    """Carry a robot's orders to ROS 2, and poses and events back: experimental.

    For a robot whose agent runs with `--body zenoh`. Topics, by rmw_zenoh: out
    /swarmgrasp/NAME/target (geometry_msgs/PoseStamped, its x axis along the force) and
    /swarmgrasp/NAME/order (std_msgs/String, JSON); in /swarmgrasp/NAME/pose (PoseStamped, as
    measured) and /swarmgrasp/NAME/event (String, JSON, such as {"event": "fastened"}). It has not
    been tried with a running ROS 2.

    Example: swarmgrasp agents ros2 deck-barge --name Fortuna --connect tcp/127.0.0.1:7448

    Parameters
    ----------
    file
        The scenario of all robots.
    name
        The robot's.
    connect
        Endpoints of the robots' router; the one on this machine unless given.
    ros
        Endpoints of ROS 2's router.
    domain
        Of ROS 2, as in ROS_DOMAIN_ID.
    """
    from swarmgrasp.packages import check_installed

    check_installed("msgspec", "zenoh", "rosbags", extra="ros2", purpose="The bridge to ROS 2")
    faults = whole_faults("--domain", domain)
    if faults:
        raise UsageFault(faults)
    scenario = read_scenario(file)
    from swarmgrasp.agents.network import NetworkSettings
    from swarmgrasp.agents.network.keys import own_keys
    from swarmgrasp.agents.network.ros2 import Ros2Bridge
    from swarmgrasp.agents.protocol import ProblemPlanner
    from swarmgrasp.agents.protocol.record import check_id

    with blaming(file):
        keys = own_keys(ProblemPlanner(scenario.problem()).mission, check_id(name))
    here, there = (NetworkSettings(mode="client", connect=ends) for ends in (connect, ros))
    bridge = Ros2Bridge(here, there, keys, int(domain), say)
    end_on_signals(bridge.stop)
    bridge.begin()
    say(f"{name} is carried to ROS 2 under /swarmgrasp")
    bridge.run()
