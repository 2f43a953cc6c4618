"""Runners-up are other places: not the next facet of the same smooth side."""

import math

import numpy as np
import pytest

from swarmgrasp import Newcomer, Outline, Robot, Stretch, Swarm, Zone, place
from swarmgrasp.placement.pieces import pieces_of
from swarmgrasp.placement.sides import RISE, hills, parts_of


def oval(count: int, names: dict[int, str] | None = None) -> Outline:
    """Return an ellipse of 200 m by 160 m drawn with many edges."""
    angles = 2.0 * np.pi * np.arange(count) / count
    corners = np.column_stack([100.0 * np.cos(angles), 80.0 * np.sin(angles)])
    return Outline(corners, edge_names=[(names or {}).get(i, "") for i in range(count)])


def held(outline: Outline) -> Swarm:
    """Return eight robots that push inward around an outline."""
    robots = []
    for angle in (0.1, 0.9, 1.7, 2.6, 3.5, 4.3, 5.2, 6.0):
        (contact,) = outline.ray_contacts(angle)
        robots.append(Robot(contact.point, outline.inward_normal(contact.edge)))
    return Swarm(outline, robots)


PUSH = Newcomer(1.0, "push", 0.5)


@pytest.mark.parametrize("count", [360, 1440, 20_000])
def test_a_smooth_side_has_few_runners_up_however_finely_it_is_drawn(count: int) -> None:
    """What is told depends on the shape; a second facet beside the best one is no news."""
    answer = place(held(oval(count)), PUSH, runners_up=0.5)
    bearings = [math.atan2(y, x) for x, y in (r.robot.contact for r in answer.runners_up)]
    assert 1 <= len(bearings) <= 6
    coarse = place(held(oval(180)), PUSH, runners_up=0.5)
    assert len(coarse.runners_up) == len(bearings)


def test_a_runner_up_is_the_best_of_its_part() -> None:
    """Asked for one by one, the parts give the same best robots."""
    swarm = held(oval(60))
    answer = place(swarm, PUSH, runners_up=0.0)
    outline = swarm.outline
    values = {}
    for edge in range(len(outline)):
        alone = place(swarm, PUSH, [Zone(outline.stretch(edge))])
        if alone.improves:
            values[edge] = alone.quality
    ring = [(edge, (edge + 1) % len(outline)) for edge in range(len(outline))]
    tops = [edge for edge in hills(values, ring) if f"edge {edge}" != answer.place]
    assert [r.quality for r in answer.runners_up] == pytest.approx(
        [values[edge] for edge in tops], rel=1e-5
    )


def test_names_zones_gaps_and_corners_part_a_side() -> None:
    """A named edge is a place of its own; around it the sides end."""
    outline = oval(36, {9: "gate", 27: "ladder"})
    parts = parts_of(pieces_of(outline, PUSH))
    assert len(parts.pieces) == 36
    assert len(parts.touching) == 36 - 4
    gap = outline.stretch(0)
    assert len(parts_of(pieces_of(outline, PUSH, no_go=[gap])).touching) == 36 - 6
    zones = [Zone(Stretch(0.0, 100.0, "pads")), Zone(Stretch(150.0, 250.0))]
    zoned = parts_of(pieces_of(outline, PUSH, zones))
    edges = [{pieces_of(outline, PUSH, zones).each[k].edge for k in part} for part in zoned.pieces]
    assert len(edges[0]) > 5
    assert all(len(part) == 1 for part in edges[1:])
    square = Outline([(0, 0), (1, 0), (1, 1), (0, 1)])
    assert parts_of(pieces_of(square, PUSH)).touching == []


def test_parts_are_as_many_as_a_plan_can_show() -> None:
    """Thousands of edges make some hundreds of parts, which hold every piece once."""
    pieces = pieces_of(oval(20_000), PUSH)
    parts = parts_of(pieces)
    assert 700 <= len(parts.pieces) <= 1500
    assert sorted(k for part in parts.pieces for k in part) == list(range(len(pieces.each)))
    assert len(parts.touching) == len(parts.pieces)


def test_hills_are_told_by_how_much_they_rise() -> None:
    """Ripples and plateaus are one hill, whichever way round the parts are counted."""
    rng = np.random.default_rng(5)
    wave = 10.0 + np.sin(np.arange(90) * (2.0 * np.pi / 30.0)) + 0.2 * RISE * rng.random(90)
    ring = [(k, (k + 1) % 90) for k in range(90)]
    assert len(hills(dict(enumerate(wave)), ring)) == 3
    flat = dict.fromkeys(range(90), 10.0)
    assert hills(flat, ring) == [0]
    assert hills({}, ring) == []
    assert hills(flat, []) == list(range(90))
