"""Frozen objects: nobody can change them, copies are equal, equal ones have equal hashes."""

import copy
import dataclasses
import math
import pickle
from collections.abc import MutableMapping, MutableSequence

import numpy as np
import pytest

import swarmgrasp as sg

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]


def swarm():
    """Return a new swarm, the same each time."""
    rough = sg.Tolerance(0.1, 0.1)
    return sg.Swarm(
        sg.Outline(SQUARE),
        [
            sg.Robot((1, 0.3), 3.0, name="Ajax"),
            sg.Robot((-1, 0.5), 0.4, tolerance=rough),
            sg.Robot((0.2, -1), 1.7),
            sg.Robot((0.3, 1), -1.0),
            sg.Robot((0.1, 0), 1.0, mounted=True),
        ],
    )


def problem(**terms):
    """Return a new problem, the same each time."""
    zones = [sg.Zone(sg.Stretch(0, 4, "quay"), "push", 0.5)]
    return sg.Problem(swarm(), sg.Newcomer(), zones, criterion=sg.Criterion(**terms))


def asked(found):
    """Return an answer after its explanation was read."""
    assert found.explanation
    return found


WIND = sg.Wind(1.0, 1.0, sg.BLENDERMANN["tender"])
MADE = {
    "outline": lambda: sg.Outline(SQUARE),
    "swarm": swarm,
    "swarm of arrays": lambda: sg.Swarm.from_arrays(sg.Outline(SQUARE), [(1, 0)], [0.0]),
    "problem": problem,
    "polytope": lambda: sg.Polytope([(1, 0, 0)]),
    "criterion": lambda: sg.Criterion(1, False, (1, 0, 0), sg.Ellipsoid([(1, 0, 0)])),
    "quality": lambda: asked(sg.quality(swarm(), losing=1)),
    "worst quality": lambda: asked(sg.quality(swarm(), worst_case=True)),
    "loss": lambda: sg.losses(swarm())[0],
    "sensitivities": lambda: sg.sensitivities(swarm()),
    "wrench set": lambda: sg.WrenchSet(swarm()),
    "mesh": lambda: sg.WrenchSet(swarm()).mesh(),
    "forces": lambda: sg.forces(swarm(), (0.1, 0, 0)),
    "forces along": lambda: sg.forces_along(swarm(), [(0.1, 0, 0), (0, 0, 0)]),
    "placement": lambda: asked(sg.place(problem(), runners_up=0.1)),
    "placement by a criterion": lambda: asked(sg.place(problem(worst_case=True, losing=1))),
    "together": lambda: sg.place_together(problem(), 2, effort=3),
    "how many": lambda: sg.how_many(problem(), 1e-3, effort=3),
    "move": lambda: sg.best_move(problem()),
    "capability": lambda: sg.capability(swarm(), sg.Environment(WIND), [0.0]),
    "summary": lambda: sg.Summary.of(swarm()),
    "bounds": lambda: sg.Summary.of(swarm()).quality(),
    "verdict": lambda: sg.place(problem()).verify(),
}


def held(thing):
    """Yield what an object holds, and what that holds."""
    yield thing
    if dataclasses.is_dataclass(thing):
        parts = list(vars(thing).values())
    elif isinstance(thing, tuple):
        parts = list(thing)
    else:
        parts = []
    for part in parts:
        yield from held(part)


@pytest.mark.parametrize("kind", MADE)
def test_a_frozen_object_is_frozen_all_through(kind):
    """No array can be written to, no list or dict is held; nor after a copy."""
    made = MADE[kind]()
    for twin in (made, copy.copy(made), copy.deepcopy(made), pickle.loads(pickle.dumps(made))):
        for part in held(twin):
            assert not isinstance(part, MutableMapping | MutableSequence)
            assert not (isinstance(part, np.ndarray) and part.flags.writeable)
        assert (twin, hash(twin)) == (made, hash(made))


@pytest.mark.parametrize("kind", MADE)
def test_objects_of_the_same_values_are_equal(kind):
    """Made twice from the same values, they are one member of a set."""
    made, again = MADE[kind](), MADE[kind]()
    assert made is not again
    assert len({made, again}) == 1


def test_objects_of_other_values_are_not_equal():
    """One number, one name, one tolerance, one vertex apart; or of another kind."""
    one = swarm()
    others = [
        one.with_pose("Ajax", (1, 0.4)),
        one.without("Ajax").with_robot(one["Ajax"]),
        one.with_tolerance(sg.Tolerance(0.2)),
        sg.Swarm(one.outline, one, 3.0),
        sg.Swarm(one.outline, [dataclasses.replace(one["Ajax"], name="Bob"), *one.robots[1:]]),
        sg.Outline(SQUARE),
        None,
    ]
    assert all(one != other for other in others)
    assert sg.Polytope([(1, 0, 0)]) != sg.Ellipsoid([(1, 0, 0)])
    assert sg.Outline(SQUARE) != sg.Outline(SQUARE, precision=1e-3)
    assert sg.Outline(SQUARE, (0.0, -0.0)) == sg.Outline(SQUARE)
    assert hash(sg.Outline(SQUARE, (0.0, -0.0))) == hash(sg.Outline(SQUARE))


def test_a_task_equals_its_twin_in_a_criterion():
    """So that nominal questions are told from others by value."""
    one, other = (sg.Criterion(task=sg.Polytope([(1, 0, 0)])) for _ in range(2))
    assert one == other
    assert one != sg.Criterion(task=sg.Polytope([(2, 0, 0)]))
    assert sg.Criterion(losing=np.int64(0)).is_nominal
    assert not math.isnan(hash(one))
