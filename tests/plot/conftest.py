import math

import pytest

from swarmgrasp import Newcomer, Outline, Robot, Stretch, Swarm, Zone
from swarmgrasp.placement import place


@pytest.fixture(scope="session")
def barge():
    """Five tugs on a barge of 76 m x 22 m: four push, Bram pulls."""
    outline = Outline(
        [(-38, -11), (38, -11), (38, 11), (-38, 11)],
        edge_names=["starboard side", "bow", "port side", "stern"],
    )
    tugs = [
        Robot((-30, -11), math.radians(90), 120e3, "Alva"),
        Robot((25, 11), math.radians(80), 100e3, "Bram"),
        Robot((38, 4), math.radians(180), 80e3, "Cato"),
        Robot((10, 11), math.radians(-100), 100e3, "Dina"),
        Robot((-38, -3), math.radians(10), 120e3, "Ebbe"),
    ]
    return Swarm(outline, tugs)


@pytest.fixture(scope="session")
def zones(barge):
    bollard = barge.outline.at_point((38, -8)).arc_length
    return (
        Zone(barge.outline.stretch("port side", 5, 30)),
        Zone(Stretch(bollard, bollard, "B1"), "free"),
    )


@pytest.fixture(scope="session")
def no_go(barge):
    return (barge.outline.stretch("port side", 20, 25, "ramp"),)


@pytest.fixture(scope="session")
def placement(barge, zones, no_go):
    newcomer = Newcomer(100e3, "push", name="Fred")
    return place(barge, newcomer, zones=zones, no_go=no_go, runners_up=0.1)


@pytest.fixture(scope="session")
def square():
    """Four robots that balance: the quality is attained at n and at -n."""
    outline = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    places = [((1, -0.4), 0), ((-1, 0.4), 180), ((-0.4, 1), 90), ((0.4, -1), -90)]
    return Swarm(outline, [Robot(c, math.radians(a)) for c, a in places], 1.0)


@pytest.fixture(scope="session")
def crowd():
    """Fifteen robots in general position on a rectangle."""
    outline = Outline([(-1.8, -0.8), (1.8, -0.8), (1.8, 0.8), (-1.8, 0.8)])
    robots = []
    for i in range(15):
        contact = outline.at_arc_length(outline.perimeter * (0.618034 * i % 1.0))
        robots.append(Robot(contact.point, contact.inward + math.sin(3.7 * i)))
    return Swarm(outline, robots, 1.0)
