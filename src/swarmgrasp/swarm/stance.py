"""How a robot stands on the hull, in words."""

import math
from dataclasses import dataclass

from swarmgrasp.outline import Outline
from swarmgrasp.swarm.force_words import width
from swarmgrasp.swarm.robot import Robot
from swarmgrasp.words import turned

SQUARE = 0.05
"""Angle [deg] below which a force counts as square to the edge."""


@dataclass(frozen=True)
class Stance:
    """How a robot stands on the outline.

    Attributes
    ----------
    arc_length : float or None [m]
        None for a mounted one.
    where : str
        "on" its edge, "at" a corner, or "on board".
    way : str
        "pushing" or "pulling", how far off the normal, and how far it steers; nothing on board.
    short : str
        The same for a table.
    """

    arc_length: float | None
    where: str
    way: str
    short: str


def stance(outline: Outline, robot: Robot) -> Stance:
    """Describe how a robot stands.

    At a corner, the normal meant is the one nearer to the force.

    Parameters
    ----------
    outline : Outline
    robot : Robot
    """
    if robot.mounted:
        return Stance(None, "on board", "", "")
    contact = outline.at_point(robot.contact)
    edges = [contact.edge]
    where = f"on {outline.edge_label(contact.edge)}"
    if contact.is_corner:
        edges.append((contact.edge - 1) % len(outline))
        first, second = (outline.edge_label(edge) for edge in reversed(edges))
        where = f"at the corner of {first} and {second}"
    if robot.steers >= math.pi:
        return Stance(contact.arc_length, where, "pushing any way", "any way")
    sides = [
        (turned(robot.direction - outline.inward_normal(edge) - turn), way, edge)
        for edge in edges
        for way, turn in (("pushing", 0.0), ("pulling", math.pi))
    ]
    off, way, edge = min(sides, key=lambda side: abs(side[0]))
    of_edge = f" of {outline.edge_label(edge)}" if contact.is_corner else ""
    return Stance(contact.arc_length, where, *_ways(robot, way, off, of_edge))


def _ways(robot: Robot, way: str, off: float, of_edge: str) -> tuple[str, str]:
    """Say at length and shortly how far a force is off the normal [deg], and what it may do."""
    normal = f"{'inward' if way == 'pushing' else 'outward'} normal{of_edge}"
    more, short = "", ""
    if robot.steers:
        side = width(robot.steers)
        more, short = f", steering {side} deg either side", f", {side} either side"
    if robot.reverse_limit:
        more, short = f"{more}, and back", f"{short}, and back"
    if abs(off) < SQUARE:
        return f"{way} along the {normal}{more}", f"{way[:4]} along it{short}"
    sense = "counter-clockwise" if off > 0.0 else "clockwise"
    return (
        f"{way}, {abs(off):.1f} deg {sense} off the {normal}{more}",
        f"{way[:4]} {abs(off):.1f} {sense}{short}",
    )
