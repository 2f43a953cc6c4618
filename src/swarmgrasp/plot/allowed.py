"""Where a newcomer may attach and which way it may push there, as rectangles."""

import math
from collections.abc import Iterable
from dataclasses import dataclass
from typing import TYPE_CHECKING, Final

from swarmgrasp.outline import Outline, Stretch
from swarmgrasp.robot import RIGHT_ANGLE, Newcomer, Zone

if TYPE_CHECKING:
    from swarmgrasp.placement import Problem

TURN: Final = 2.0 * math.pi

Interval = tuple[float, float]


@dataclass(frozen=True)
class Patch:
    """A part of one edge with a sector of force directions.

    Attributes
    ----------
    start, end : float [m]
        Arc lengths; equal for a bollard.
    low, high : float [rad]
        Directions, counter-clockwise from low to high, with -pi <= low < pi.
    """

    start: float
    end: float
    low: float
    high: float


def patches(problem: "Problem") -> list[Patch]:
    """Return everything a problem allows: zones without no-go stretches and spacing.

    Parameters
    ----------
    problem : Problem

    Returns
    -------
    list of Patch
        They may overlap.
    """
    outline, newcomer = problem.swarm.outline, problem.newcomer
    barred = [piece for stretch in problem.no_go for piece in _unrolled(outline, stretch)]
    barred += _too_close(problem)
    found = []
    for zone in problem.zones or (None,):
        whole = Stretch(0.0, outline.perimeter)
        free = _unrolled(outline, whole if zone is None else zone.stretch)
        for start, end in _without(free, barred):
            for edge, first, last in _by_edge(outline, start, end):
                for low, high in _sectors(outline.inward_normal(edge), zone, newcomer):
                    found.append(Patch(first, last, low, high))
    return found


def _unrolled(outline: Outline, stretch: Stretch) -> list[Interval]:
    """Return a stretch as intervals of arc length within [0, perimeter]."""
    if stretch.start <= stretch.end:
        return [(stretch.start, stretch.end)]
    return [(stretch.start, outline.perimeter), (0.0, stretch.end)]


def _too_close(problem: "Problem") -> list[Interval]:
    """Return the parts of the boundary nearer to a robot on it than the spacing [m]."""
    outline, found = problem.swarm.outline, []
    for robot in problem.swarm.robots if problem.spacing > 0.0 else ():
        if robot.mounted:
            continue
        for edge, base in enumerate(outline.corner_arc_lengths[:-1]):
            p, q = outline.edge_ends(edge)
            length = float(outline.lengths[edge])
            way = (q - p) / length
            along = float((robot.contact - p) @ way)
            across = float(way[0] * (robot.contact - p)[1] - way[1] * (robot.contact - p)[0])
            if abs(across) < problem.spacing:
                half = math.sqrt(problem.spacing**2 - across**2)
                start, end = max(along - half, 0.0), min(along + half, length)
                if start < end:
                    found.append((float(base) + start, float(base) + end))
    return found


def _without(free: Iterable[Interval], barred: Iterable[Interval]) -> list[Interval]:
    """Take the open insides of some intervals out of others."""
    left = list(free)
    for low, high in barred:
        kept = []
        for start, end in left:
            if high <= start or low >= end or low == high:
                kept.append((start, end))
                continue
            kept += [(start, low)] if start < low else []
            kept += [(high, end)] if high < end else []
        left = kept
    return left


def _by_edge(outline: Outline, start: float, end: float) -> list[tuple[int, float, float]]:
    """Split an interval of arc length at the corners, into (edge, start, end)."""
    if start == end:
        return [(outline.at_arc_length(min(start, outline.perimeter)).edge, start, end)]
    reach = outline.corner_arc_lengths
    parts = [
        (edge, max(start, float(reach[edge])), min(end, float(reach[edge + 1])))
        for edge in range(len(outline))
    ]
    return [part for part in parts if part[1] < part[2]]


def _sectors(inward: float, zone: Zone | None, newcomer: Newcomer) -> list[Interval]:
    """Return the sectors of directions [rad] a zone allows at an edge."""
    chosen = newcomer if zone is None or zone.attachment is None else zone
    half = RIGHT_ANGLE if chosen.half_angle is None else chosen.half_angle
    middle = inward if chosen.attachment == "push" else inward + math.pi
    half = math.pi if chosen.attachment == "free" else half
    low = _wrapped(middle - half)
    sector = (low, low + 2.0 * half)
    if zone is None or zone.directions is None:
        return [sector]
    first = _wrapped(zone.directions[0])
    span = (zone.directions[1] - zone.directions[0]) % TURN
    meetings = [
        (max(sector[0], first + turn), min(sector[1], first + span + turn))
        for turn in (-TURN, 0.0, TURN)
    ]
    return [(_wrapped(a), _wrapped(a) + b - a) for a, b in meetings if a <= b]


def _wrapped(angle: float) -> float:
    """Return an angle within [-pi, pi)."""
    return (angle + math.pi) % TURN - math.pi
