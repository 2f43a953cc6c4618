"""Several newcomers at once: the answers are real, and the bounds hold for all places."""

import math
import os
import re
import subprocess
import sys
from itertools import combinations, combinations_with_replacement
from pathlib import Path

import numpy as np
import pytest
from hypothesis import assume, given, settings
from hypothesis import strategies as st

import reference
from strategies import L_SHAPE, problem_of, seeds, swarm_of
from swarmgrasp import (
    Criterion,
    Ellipsoid,
    Newcomer,
    Outline,
    Polytope,
    Problem,
    Robot,
    Stretch,
    Swarm,
    Tolerance,
    Zone,
    place,
    place_together,
    quality,
)
from swarmgrasp.errors import NowhereToAttach, SwarmGraspError
from swarmgrasp.placement.together.effort import Budget
from swarmgrasp.placement.together.gauge import Gauge
from swarmgrasp.placement.together.regions import CONTACT, DIRECTION, whole
from swarmgrasp.placement.together.relaxation import Relaxation, Rows, Share
from swarmgrasp.placement.together.stands import Ground

SQUARE = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
PULLS = [
    ((1, -0.4), 0.0),
    ((-1, 0.4), math.pi),
    ((-0.4, 1), math.pi / 2),
    ((0.4, -1), -math.pi / 2),
]
FOUR = Swarm(SQUARE, [Robot(*row) for row in PULLS], 1.0)
PULLING = Newcomer(1.0, "pull", 0.0)
RECTANGLE = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)])
EMPTY = Swarm(RECTANGLE, [])
FAMILIES = (
    "free",
    "along normals",
    "integer grid",
    "balanced",
    "duplicated",
    "notched",
    "weighted",
)
CRITERIA = (
    {},
    {"losing": 1},
    {"losing": 2},
    {"load": (0.2, -0.1, 0.1)},
    {"task": Polytope([(1.0, 0.2, 0.0), (-0.3, 0.6, 0.2), (0.0, -0.5, -0.4)])},
    {"task": Ellipsoid([(1.0, 0.0, 0.0), (0.0, 0.4, 0.1)]), "losing": 1, "load": (0.1, 0.0, 0.0)},
    {"worst_case": True, "losing": 1},
)
KINDS = {
    "push along the normal": Newcomer(1.0, "push", 0.0),
    "push within 30 degrees of it": Newcomer(1.0, "push", math.pi / 6),
    "push in any direction": Newcomer(1.0, "push"),
    "push or pull in any direction": Newcomer(1.0, "free"),
}
PAGE = (Path(__file__).parents[2] / "docs" / "together.md").read_text("utf-8")
ROWS = [row for row in re.findall(r"\| +(\d+) \|" + 5 * r" +([^|]+?) +\|", PAGE) if row[1] in KINDS]
"""Of the table there: robots, what they may, the three qualities, and the gap."""
TABLE = {
    5: (0.6963, 0.6963), 6: (0.9526, 0.9526), 7: (0.9526, 1.0), 8: (1.0, 2.0),
    9: (1.0, 2.0), 10: (2.0, 2.0), 11: (2.0, 2.0), 12: (3.0, 3.0),
}  # fmt: skip
"""Of the square of theory section 7: robots in all, and the qualities one after the other and
together; docs/together.md shows it."""


def along_normals(swarm, each):
    """Return the scaled generators of unit pulls along the normals, `each` to an edge."""
    rows = []
    for k, (p, q) in enumerate(zip(SQUARE.vertices, np.roll(SQUARE.vertices, -1, 0), strict=True)):
        outward = SQUARE.inward_normals[k] + math.pi
        points = p + np.linspace(0.0, 1.0, each)[:, None] * (q - p)
        rows.append(reference.generators(
            points, np.full(each, outward), np.ones(each), SQUARE.origin, swarm.scale
        ))  # fmt: skip
    return np.vstack(rows)


# -- the answers ------------------------------------------------------------------------


@pytest.mark.parametrize("robots", TABLE)
def test_the_square_no_longer_stalls(robots):
    """The table of the page: each joint quality reaches its bound, so no places are better."""
    answer = place_together(Problem(FOUR, PULLING), robots - 4, effort=20_000)
    sequential, together = TABLE[robots]
    assert answer.sequential == pytest.approx(sequential, abs=1e-4)
    assert answer.quality == pytest.approx(together, abs=1e-4)
    assert answer.is_optimal()
    assert not answer.stopped_early
    assert reference.quality(answer.swarm_after.scaled_generators) == pytest.approx(answer.quality)


@pytest.mark.parametrize("count", [2, 3, 5])
def test_an_integer_program_over_a_grid_agrees(count):
    """Its optimum is no more than the bound, and the answer no more than it and count * eps."""
    each = 5
    best = reference.best_together(FOUR.scaled_generators, along_normals(FOUR, each), count)
    answer = place_together(Problem(FOUR, PULLING), count, effort=20_000)
    eps = 1.0 / (each - 1)  # half the spacing of contacts, which is their difference in torque
    assert best <= answer.upper_bound * (1.0 + 1e-9)
    assert best <= answer.quality * (1.0 + 1e-3) + 1e-7
    assert answer.quality <= best + count * eps


@pytest.mark.parametrize(("count", "least"), [(4, 0.7559), (6, 1.0), (12, 2.846)])
def test_from_an_empty_object(count, least):
    """Robots along the normals of a rectangle: solved to the end."""
    answer = place_together(Problem(EMPTY, PULLING), count, effort=20_000)
    assert answer.quality >= least * (1.0 - 1e-6)
    assert answer.is_optimal()
    assert answer.quality > answer.sequential
    assert len(answer.robots) == len(answer.places) == count
    assert answer.improves


@pytest.mark.parametrize(("count", "known"), [(4, 1.0), (6, 1.7155), (12, 3.622)])
def test_in_any_direction(count, known):
    """Far better than one after the other, and as near to an honest bound as asked for."""
    pushing = Problem(EMPTY, Newcomer(1.0, "push"))
    answer = place_together(pushing, count, gap=0.3, effort=20_000)
    assert not answer.stopped_early
    assert answer.quality <= answer.upper_bound <= 1.3 * answer.quality
    assert answer.upper_bound >= known
    assert answer.quality <= count / math.pi * (1.0 + 1e-9)  # (T3)
    assert answer.quality > 1.5 * answer.sequential
    assert quality(answer.swarm_after).value == pytest.approx(answer.quality, rel=1e-9)


@pytest.mark.long
@pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row[0]} {row[1]}")
def test_the_table_of_an_empty_rectangle(row):
    """As docs/together.md has it, at the default effort."""
    count, may, *numbers = row
    answer = place_together(Problem(EMPTY, KINDS[may]), int(count))
    found = (answer.sequential, answer.quality, answer.upper_bound)
    assert found == pytest.approx([float(number) for number in numbers[:3]], rel=1e-4)


@pytest.mark.long
def test_the_picture_of_the_page(tmp_path):
    """The example that draws it finds the quality and the bound that the page states."""
    example = Path(__file__).parents[2] / "examples" / "04_place_together.py"
    command = [sys.executable, str(example)]
    said = subprocess.run(command, cwd=tmp_path, check=True, capture_output=True, text=True).stdout
    together, bound = re.findall(r"(\d+) kN together; no places exceed (\d+) kN", said)[0]
    caption = " ".join(PAGE.split())
    assert f": {together} kN, and no six such tugs exceed {bound} kN" in caption


def test_too_few_robots():
    """Three hold nothing, which needs no search."""
    answer = place_together(Problem(EMPTY, Newcomer()), 3)
    assert answer.quality == answer.upper_bound == 0.0
    assert answer.is_optimal()
    assert "at least 4" in answer.reason


def test_one_alone_is_placed_as_ever():
    """With the bound of `place`."""
    swarm = swarm_of("free", 3, 6)
    answer = place_together(Problem(swarm, Newcomer(1.0, "push")), 1)
    alone = place(swarm, Newcomer(1.0, "push"))
    assert answer.quality == pytest.approx(alone.quality, rel=1e-6)
    assert answer.is_optimal(1e-5)
    assert answer.robots[0].name == "newcomer"


@given(st.sampled_from(FAMILIES), seeds, st.integers(0, 6), st.integers(2, 3))
@settings(max_examples=10)
def test_every_answer_is_allowed_and_exact(family, seed, n, count):
    """In its zones and sectors, at its limit, with the quality it states, below its bound."""
    problem = problem_of(family, seed, n)
    try:
        answer = place_together(problem, count, effort=100)
    except NowhereToAttach:
        assume(False)
    truth = reference.quality(answer.swarm_after.scaled_generators)
    slack = 1e-11 * np.linalg.norm(answer.swarm_after.scaled_generators, axis=1).sum()
    assert answer.quality == pytest.approx(truth, rel=1e-9, abs=slack)
    assert answer.quality <= answer.upper_bound
    assert not answer.quality < answer.sequential * (1.0 - 1e-6) - slack
    if not answer.stopped_early:
        assert answer.upper_bound <= (1.0 + 1e-3) * answer.quality + 4.0 * slack
    ground = Ground(problem)
    for robot in answer.robots:
        assert robot.limit == problem.newcomer.limit
        stands = ground.stands_at([robot.contact], [robot.direction])
        (there,) = ground.robots(stands, [""])
        assert math.dist(there.contact, robot.contact) <= 1e-9 * ground.outline.extent
        assert math.cos(there.direction - robot.direction) >= 1.0 - 1e-12


# -- the bound --------------------------------------------------------------------------


def narrowed(region, stands, rng, halvings):
    """Halve a region again and again; return the counts of those halves that contain stands."""
    ground = region.ground
    arcs = ground.outline.corner_arc_lengths[ground.edges[stands.piece]] + stands.at[:, 0]
    angles = np.remainder(stands.at[:, 1] + math.pi, math.tau) - math.pi
    parts = [(region, np.arange(len(arcs)))]
    for _ in range(halvings):
        index = int(rng.integers(len(parts)))
        part, inside = parts[index]
        axis = int(rng.choice([CONTACT, DIRECTION]))
        cut = part.halves(axis)
        if cut is None:
            continue
        low = np.array([holds(cut.low, stands.piece[k], arcs[k], angles[k]) for k in inside])
        halves = [(cut.low, inside[low]), (cut.high, inside[~low])]
        parts[index : index + 1] = [(half, rows) for half, rows in halves if len(rows)]
    return tuple(part for part, _ in parts), np.array([float(len(rows)) for _, rows in parts])


def holds(region, piece, arc, angle):
    """Tell whether a region has a contact and a direction on a piece."""
    boxes = region.boxes[region.boxes[:, 0] == piece]
    low, high = boxes[:, [1, 3]] - 1e-9, boxes[:, [2, 4]] + 1e-9
    return any(
        ((low <= (arc, angle + turn)) & ((arc, angle + turn) <= high)).all(axis=1).any()
        for turn in (-math.tau, 0.0, math.tau)
    )


@given(
    st.sampled_from(FAMILIES), seeds, st.integers(0, 8), st.integers(1, 5),
    st.sampled_from(CRITERIA), st.integers(0, 12),
)  # fmt: skip
@settings(max_examples=120)
def test_no_newcomers_in_given_regions_exceed_their_bound(family, seed, n, count, terms, halvings):
    """Random newcomers, in the regions they happen to be in: a program bounds their quality."""
    rng = np.random.default_rng([seed, 5])
    swarm = swarm_of(family, seed, n)
    if "worst_case" in terms:
        swarm = swarm.with_tolerance(Tolerance(contact=0.02, direction=0.1))
    kind = str(rng.choice(["push", "pull"]))
    newcomer = Newcomer(10.0 ** rng.uniform(-1, 1), kind, rng.choice([0.0, 0.4, 1.5]))
    ground = Ground(Problem(swarm, newcomer, criterion=Criterion(**terms)))
    gauge = Gauge(ground)
    stands = ground.random(rng, count)
    regions, counts = narrowed(whole(ground), stands, rng, halvings)
    relaxation = Relaxation(gauge, count, Budget(1000))
    first = relaxation.first(whole(ground)).rows
    kept = np.ones((len(first.normal), len(regions)))
    # any loss of newcomers may be supposed
    losing = gauge.losing
    if losing and count >= losing:
        kept *= 1.0 - losing / count
        first = Rows(first.normal, np.zeros_like(first.lost), kept)
    share = Share(regions, counts, Rows(first.normal, first.lost, kept), math.inf)
    relaxation.solve(share, -math.inf)
    after = quality(gauge.swarm_with(stands), **terms).value
    assert gauge.exact(stands).quality == pytest.approx(after, rel=1e-7, abs=1e-9)
    slack = 1e-9 * (1.0 + np.linalg.norm(swarm.scaled_generators, axis=1).sum())
    assert after <= max(share.bound, 0.0) * (1.0 + 1e-8) + slack


@given(seeds, st.sampled_from(CRITERIA[:6]))
@settings(max_examples=8)
def test_no_random_newcomers_beat_the_bound(seed, terms):
    """Whatever is asked."""
    rng = np.random.default_rng(seed)
    swarm = swarm_of("free", seed, 5)
    problem = Problem(swarm, Newcomer(1.0, "push", 0.5), criterion=Criterion(**terms))
    answer = place_together(problem, 3, effort=150)
    assert quality(answer.swarm_after, **terms).value == pytest.approx(answer.quality, abs=1e-9)
    gauge = Gauge(Ground(problem))
    for _ in range(40):
        found = gauge.exact(gauge.ground.random(rng, 3)).quality
        assert found <= answer.upper_bound * (1.0 + 1e-9) + 1e-9


@pytest.mark.parametrize("terms", [CRITERIA[1], CRITERIA[3], CRITERIA[4]])
def test_criteria_are_solved_to_the_end(terms):
    """Beside the square: after a loss, beside a load, for a task."""
    problem = Problem(FOUR, PULLING, criterion=Criterion(**terms))
    answer = place_together(problem, 4, effort=20_000)
    assert answer.is_optimal()
    assert quality(answer.swarm_after, **terms).value == pytest.approx(answer.quality, rel=1e-9)
    assert answer.quality > quality(FOUR, **terms).value


def test_after_a_loss_no_choice_of_corners_is_better():
    """All multisets of four pulls at the corners, all losses of one robot: listed."""
    problem = Problem(FOUR, PULLING, criterion=Criterion(losing=1))
    answer = place_together(problem, 4, effort=20_000)
    corners = along_normals(FOUR, 2)
    best = max(
        reference.quality_by_criterion(np.vstack([FOUR.scaled_generators, corners[list(k)]]), 1)
        for k in combinations_with_replacement(range(len(corners)), 4)
        if {0, 1, 2, 3} == {i // 2 for i in k}  # otherwise one edge is left with a single robot
    )
    assert best <= answer.quality * (1.0 + 1e-3)
    assert answer.quality <= answer.upper_bound <= answer.quality * (1.0 + 1e-3)


# -- rules and faults ---------------------------------------------------------------------


@pytest.mark.parametrize("spacing", [0.4, 1.0, 1.5])
def test_newcomers_keep_their_distance(spacing):
    """From each other, and from those already there."""
    swarm = Swarm(RECTANGLE, [Robot((0.0, -1.0), 1.5)])
    answer = place_together(Problem(swarm, Newcomer(1.0, "push"), spacing=spacing), 5, effort=500)
    robots = (*swarm.robots, *answer.robots)
    apart = min(math.dist(a.contact, b.contact) for a, b in combinations(robots, 2))
    assert apart >= spacing * (1.0 - 1e-6)


def test_no_room_for_so_many():
    """The spacing leaves room to four, as the corners are 2 and 4 m apart."""
    problem = Problem(EMPTY, Newcomer(), spacing=1.99)
    assert len(place_together(problem, 4, effort=500).robots) == 4
    with pytest.raises(NowhereToAttach, match=r"no room was found for 12 robots at .* 1\.99 m"):
        place_together(problem, 12, effort=100)


def test_zones_and_a_notched_outline():
    """Everything that limits one newcomer limits several."""
    outline = Outline(L_SHAPE)
    zones = (Zone(Stretch(0.2, 2.0, "pads")), Zone(Stretch(6.5, 6.5, "bollard"), "pull", 1.0))
    no_go = (Stretch(1.0, 1.5),)
    problem = Problem(Swarm(outline, []), Newcomer(1.0, "push", 0.6), zones, no_go)
    answer = place_together(problem, 5, effort=250)
    assert set(answer.places) <= {"pads", "bollard"}
    for robot in answer.robots:
        at = outline.at_point(robot.contact).arc_length
        assert at == pytest.approx(6.5) or 0.2 <= at <= 1.0 or 1.5 <= at <= 2.0


def test_no_effort_is_a_result():
    """With the robots placed one after the other, a bound, and the mark of an early end."""
    seen = []
    answer = place_together(
        Problem(EMPTY, Newcomer()), 5, effort=0, progress=lambda *now: seen.append(now)
    )
    assert answer.stopped_early
    assert answer.sequential * (1.0 - 1e-9) <= answer.quality <= answer.upper_bound < math.inf
    assert answer.upper_bound >= place_together(answer.problem, 5, effort=100).upper_bound


def test_all_faults_at_once():
    """In one message."""
    with pytest.raises(SwarmGraspError) as error:
        place_together(EMPTY, 2**63, gap=1.0, effort=-1)
    assert len(error.value.faults) == 4


def test_the_same_answer_on_every_machine():
    """The processor's own order of sums, and its number of threads, change no digit."""
    question = (
        "import math; from swarmgrasp import *; "
        "hull = Outline([(-2, -1), (2, -1), (2, 1), (-2, 1)]); "
        "answer = place_together(Problem(Swarm(hull, []), Newcomer(1.0, 'push')), 5, effort=300); "
        "print(repr((answer.quality, answer.upper_bound, answer.robots)))"
    )
    kinds = ({"OPENBLAS_CORETYPE": "Nehalem"}, {"OPENBLAS_CORETYPE": "Haswell"}, {})
    told = {
        subprocess.run(
            [sys.executable, "-c", question], env={**os.environ, **kind},
            check=True, capture_output=True, text=True,
        ).stdout
        for kind in kinds
    }  # fmt: skip
    assert len(told) == 1
