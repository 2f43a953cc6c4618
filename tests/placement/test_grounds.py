"""Where a newcomer may attach and where not: counted on a fine grid of the boundary."""

import math

import numpy as np
import pytest

from swarmgrasp import Newcomer, Outline, Problem, Robot, Stretch, Swarm, Zone, place
from swarmgrasp.placement.grounds import NO_WAY, OUTSIDE, grounds
from swarmgrasp.scenario import load_example


def found(problem):
    return {each.place: each for each in grounds(place(problem, runners_up=0.0))}


def test_lengths_are_those_of_points_counted_one_by_one():
    """Every point of a boundary with zones, a no-go stretch and spacing, a centimetre apart."""
    problem = load_example("deck-barge").problem()
    swarm, outline = problem.swarm, problem.swarm.outline
    told = found(problem)
    for zone, label in zip(problem.zones, problem.zone_labels, strict=True):
        if zone.stretch.is_point:
            continue
        arcs = np.arange(zone.stretch.start, zone.stretch.end, 0.01)
        points = [outline.at_arc_length(arc).point for arc in arcs.tolist()]
        far = np.linalg.norm(np.array(points)[:, None] - swarm.contacts, axis=2).min(axis=1)
        free = far >= problem.spacing
        for stretch in problem.no_go:
            free &= (arcs < stretch.start) | (arcs > stretch.end)
        assert told[label].allowed == pytest.approx(0.01 * free.sum(), abs=0.05)
    parts = sum(each.length for each in told.values())
    assert parts == pytest.approx(outline.perimeter)


def test_each_place_has_its_best_quality_or_none():
    """As a placement there alone has it."""
    problem = load_example("deck-barge").problem()
    told = found(problem)
    for zone, label in zip(problem.zones, problem.zone_labels, strict=True):
        if told[label].best is None:
            continue
        alone = Problem(problem.swarm, problem.newcomer, (zone,), problem.no_go, problem.spacing)
        assert told[label].best.quality == pytest.approx(place(alone).quality, rel=1e-5)


def test_facets_of_one_smooth_side_are_one_row():
    """A 120-gon has one side; what is outside zones is named, and so are lines that cross."""
    ring = [(math.cos(k), math.sin(k)) for k in np.linspace(0.0, math.tau, 121)[:-1]]
    pair = Swarm(Outline(ring), [Robot((1.0, 0.0), 3.0)])
    assert list(found(Problem(pair, Newcomer()))) == ["edges 0 to 119"]
    zone = Zone(Stretch(0.0, 1.0, "pad"))
    told = found(Problem(pair, Newcomer(), (zone,)))
    assert list(told) == ["pad", "rest of edges 0 to 119"]
    assert told["rest of edges 0 to 119"].excluded[0][0] == OUTSIDE
    corners = [(0, 0), (4, 0), (4, 1), (3, 1), (3, 3), (1, 3), (1, 1), (0, 1)]
    hat = Swarm(Outline(corners), [Robot((2.0, 3.0), 0.0)])
    pull = Newcomer(1.0, "pull", 0.0)
    wall = Zone(Stretch(4.0, 4.5, "end"), directions=(math.pi, math.pi))
    told = found(Problem(hat, pull, (wall, Zone(Stretch(0.0, 4.0, "side")))))
    assert not told["end"].is_allowed
    assert [what for what, _ in told["end"].excluded] == [NO_WAY]
