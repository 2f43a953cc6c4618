"""Whole random questions, with every kind of restriction: the answers pass a stranger's check."""

import math

import numpy as np
import pytest

from swarmgrasp import Newcomer, Outline, Problem, Robot, Stretch, Swarm, Zone, place_sequence
from swarmgrasp.answer_file import document_of
from swarmgrasp.errors import NowhereToAttach
from swarmgrasp.verify import verify_document


def outline_of(rng):
    """Draw a rectangle, an L, a star-shaped polygon or an oval of any size."""
    kind = rng.integers(4)
    if kind == 0:
        a, b = rng.uniform(0.4, 3.0, 2)
        return Outline([(-a, -b), (a, -b), (a, b), (-a, b)])
    if kind == 1:
        return Outline([(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)], origin=rng.normal(size=2))
    turns = np.arange(k := rng.integers(4, 20)) * math.tau / k
    radii = rng.uniform(0.8, 1.3, k) if kind == 2 else np.ones(k)
    return Outline(10.0 ** rng.integers(-2, 3) * np.c_[3 * radii * np.cos(turns), np.sin(turns)])


def zone_of(rng, arc):
    """Draw a zone between arc lengths, or a point, with or without rules of its own."""
    start = arc()
    stretch = Stretch(start, start if rng.random() < 0.4 else arc(), str(rng.choice(["", "a"])))
    own = None if rng.random() < 0.6 else str(rng.choice(["push", "pull", "free"]))
    half = float(rng.choice([0.0, 0.5, math.pi / 2])) if own in ("push", "pull") else None
    ends = None if rng.random() < 0.7 else tuple(map(float, rng.uniform(-4, 4, 2)))
    return Zone(stretch, own, half, ends)


def question_of(seed):
    """Draw a problem; ends often lie on corners, and often on each other."""
    rng = np.random.default_rng(seed)
    outline = outline_of(rng)
    marks = [*outline.corner_arc_lengths.tolist(), *rng.uniform(0.0, outline.perimeter, 3)]

    def arc():
        return float(rng.choice(marks) if rng.random() < 0.6 else rng.uniform(0, marks[-4]))

    crew = []
    for _ in range(rng.integers(0, 8)):
        contact = outline.at_arc_length(arc())
        turn = rng.choice([0.0, math.pi]) if rng.random() < 0.5 else rng.uniform(-3, 3)
        crew.append(Robot(contact.point, contact.inward + float(turn), 10.0 ** rng.uniform(-1, 1)))
    kind = str(rng.choice(["push", "pull", "free"]))
    half = None if kind == "free" else float(rng.choice([0.0, 0.3, math.pi / 2]))
    zones = tuple(zone_of(rng, arc) for _ in range(rng.integers(0, 4)))
    no_go = tuple(Stretch(arc(), arc()) for _ in range(rng.integers(0, 3)))
    return Problem(
        Swarm(outline, crew, force_weights=tuple(10.0 ** rng.uniform(-1, 1, 2))),
        Newcomer(10.0 ** rng.uniform(-2, 2), kind, half),
        zones or None,
        tuple(stretch for stretch in no_go if not stretch.is_point),
        0.0 if rng.random() < 0.5 else float(rng.uniform(0.0, 0.15) * outline.perimeter),
    )


def check(seeds):
    """Answer every question twice over and verify; return how many had an answer."""
    answered = 0
    for seed in seeds:
        problem = question_of(seed)
        try:
            answers = place_sequence(problem, 2, runners_up=0.5)
        except NowhereToAttach:
            continue
        verdict = verify_document(document_of(answers))
        assert verdict, (seed, verdict.faults)
        answered += 1
    return answered


def test_answers_to_questions_of_every_kind_verify():
    """Zones, bollards, no-go stretches, spacing, ranges, weights: most leave a place."""
    assert check(range(150)) > 75


@pytest.mark.long
def test_answers_to_thousands_of_questions_verify():
    """The same, further."""
    assert check(range(150, 6000)) > 3000
