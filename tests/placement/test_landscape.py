"""What a newcomer would bring on every piece, and along it in the best direction."""

import math
from dataclasses import replace

import numpy as np
import pytest

from swarmgrasp import Criterion, Newcomer, Outline, Robot, Swarm, Zone, place, quality
from swarmgrasp.errors import ForceSetUnsupported, ProblemInvalid
from swarmgrasp.placement import Problem, cell_qualities, landscape, strips

HULL = Outline([(-3, -1), (2, -1), (3, 0), (2, 1), (-3, 1)], edge_names=["s", "sb", "pb", "n", ""])
ASKED = Criterion(losing=1, load=(0.1, -0.2, 0.1))


def problem_of(seed, criterion=ASKED, newcomer=None, **kinds):
    """Return a swarm, a newcomer, and zones: around a corner, with pulls too, and a bollard."""
    rng = np.random.default_rng(seed)
    robots = []
    for arc in rng.uniform(0.0, HULL.perimeter, 9):
        at = HULL.at_arc_length(float(arc))
        robots.append(Robot(at.point, at.inward + rng.uniform(-0.7, 0.7), **kinds))
    zones = (
        Zone(replace(HULL.stretch("s", 3.0, 5.0), end=6.0, name="around")),
        Zone(HULL.stretch("n"), "free"),
        Zone(
            replace(HULL.stretch("pb", 0.7, 0.8), end=float(6.2 + 0.5), start=6.7, name="lead"),
            "pull",
            0.0,
        ),
    )
    return Problem(
        Swarm(HULL, robots), newcomer or Newcomer(1.0, "push", 0.5), zones, (), 0.1, criterion
    )


@pytest.mark.parametrize(
    ("newcomer", "kinds"),
    [
        (None, {}),
        (None, {"steers": 0.3}),
        (Newcomer(1.0, "push", 0.5, steers=True), {}),
        (Newcomer(1.0, "push", 0.5, reverse_limit=0.5), {}),
    ],
)
def test_every_value_is_a_quality(newcomer, kinds):
    """That of the swarm with the newcomer there; the ends are those of what is allowed."""
    problem = problem_of(1, newcomer=newcomer, **kinds)
    found = landscape(problem, 12, 4)
    assert {patch.place for patch in found} == {"around", "n", "lead"}
    keeps = newcomer is not None and newcomer.steers
    assert len({patch.inward for patch in found if patch.place == "n"}) == (1 if keeps else 2)
    for patch in found:
        normal = HULL.inward_normal(patch.edge) + (0.0 if patch.inward else math.pi)
        base = float(HULL.corner_arc_lengths[patch.edge])
        assert base - 1e-9 <= patch.arc_lengths[0] <= patch.arc_lengths[-1]
        assert patch.arc_lengths[-1] <= base + float(HULL.lengths[patch.edge]) + 1e-9
        assert np.abs(patch.angles).max() <= 0.5 * math.pi + 1e-9
        for c, r in ((0, 0), (-1, -1), (len(patch.values) // 2, len(patch.angles) // 2)):
            point = HULL.on_edge(patch.edge, float(patch.arc_lengths[c] - base)).point
            robot = Robot(point, normal + patch.angles[r])
            if keeps:
                steers = {"around": 0.5, "n": math.pi, "lead": 0.0}[patch.place]
                robot = replace(robot, steers=steers)
            elif newcomer is not None:
                robot = replace(robot, reverse_limit=0.5)
            truth = quality(problem.swarm.with_robot(robot), **ASKED.keywords).value
            assert patch.values[c, r] == pytest.approx(truth, rel=1e-7, abs=1e-9)


@pytest.mark.parametrize("seed", range(3))
@pytest.mark.parametrize("criterion", [Criterion(), ASKED, Criterion(losing=2)])
def test_a_strip_is_the_best_of_each_contact(seed, criterion):
    """With the direction that has it, and no place is better than the best that is proven."""
    problem = problem_of(seed, criterion)
    patches, found = landscape(problem, 15, 9), strips(problem, 15, 9)
    best = place(problem.swarm, problem.newcomer, problem.zones, spacing=0.1, **criterion.keywords)
    for patch, strip in zip(patches, found, strict=True):
        assert (strip.place, strip.edge, strip.inward) == (patch.place, patch.edge, patch.inward)
        assert strip.arc_lengths.tolist() == patch.arc_lengths.tolist()
        assert strip.values == pytest.approx(patch.values.max(axis=1), rel=1e-9, abs=1e-12)
        which = [patch.angles.tolist().index(angle) for angle in strip.angles]
        at = patch.values[np.arange(len(which)), which]
        assert at == pytest.approx(strip.values, rel=1e-9, abs=1e-12)
        assert patch.values.max() <= best.upper_bound * (1.0 + 1e-9)


def test_cells_have_the_same_values():
    """A bollard with one direction is one value, in a landscape and in the cells around it."""
    problem = replace(problem_of(4), zones=problem_of(4).zones[2:])
    (patch,) = landscape(problem, 50, 50)
    cells = cell_qualities(problem, (60, 60))
    assert patch.values.shape == (1, 1)
    assert np.unique(cells[~np.isnan(cells)]).tolist() == [patch.values[0, 0]]


def test_it_can_be_stopped():
    """What is there by then stays, and the rest is nan."""
    problem, asked = problem_of(2), iter(range(100))
    found = landscape(problem, 400, 20, stop=lambda: next(asked) > 2)
    known = [~np.isnan(patch.values) for patch in found]
    assert known[0].any()
    assert not known[-1].any()
    asked = iter(range(1000))
    known = [
        ~np.isnan(strip.values) for strip in strips(problem, 40, 9, stop=lambda: next(asked) > 2)
    ]
    assert [int(each.sum()) for each in known] == [3, *[0] * (len(known) - 1)]


def test_what_is_refused():
    """Numbers of cells that are none, all at once, and a newcomer inside."""
    with pytest.raises(ProblemInvalid, match=r"columns is 0(.|\n)*rows is 1\.5"):
        landscape(problem_of(1), 0, 1.5)
    with pytest.raises(ProblemInvalid, match="Problem"):
        strips(None, 3, 3)
    inside = Problem(problem_of(1).swarm, Newcomer(1.0, mounted=True))
    with pytest.raises(ForceSetUnsupported, match="mounted"):
        landscape(inside, 3, 3)
