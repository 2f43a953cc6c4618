"""Misuse: what is wrong is refused at the door, by an error of ours named after the fault."""

import math
import pickle
from contextlib import suppress
from functools import partial

import numpy as np
import pytest

import swarmgrasp as sg
from swarmgrasp import errors
from swarmgrasp.answer_file import document_of

SQUARE = sg.Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)], edge_names=["s", "e", "n", "w"])
CREW = [
    sg.Robot((1, 0.3), 3.0, name="Ajax"),
    sg.Robot((-1, 0.5), 0.4, tolerance=sg.Tolerance(0.1, 0.1)),
    sg.Robot((0.2, -1), 1.7),
    sg.Robot((0.3, 1), -1.0),
]
SWARM = sg.Swarm(SQUARE, CREW)
NEWCOMER = sg.Newcomer()
PROBLEM = sg.Problem(SWARM, NEWCOMER)
WIND = sg.Wind(1.0, 1.0, sg.BLENDERMANN["tender"], speed=1.0, bearing=0.0)
WEATHER = sg.Environment(WIND, sg.Current(1.0, 1.0, 0.1))
HUGE = 10**400

# -- each misuse by hand ------------------------------------------------------------------

MISUSED = [
    (lambda: sg.Newcomer(1.0, "push", "1"), "RobotInvalid", "half angle is '1'"),
    (lambda: sg.Zone(sg.Stretch(0, 1), "push", "1"), "ZoneInvalid", "half angle is '1'"),
    (lambda: sg.Stretch("0", "1"), "ZoneInvalid", "start is '0'(.|\n)*end is '1'"),
    (lambda: sg.Tolerance(least_limit="1"), "RobotInvalid", "limit is '1'"),
    (lambda: sg.Stretch(0, 1, None), "ZoneInvalid", "name is None"),
    (lambda: sg.Stretch(0, 1, 3), "ZoneInvalid", "name is 3"),
    (lambda: sg.Robot((0.1, 0), 0.0, mounted="no"), "RobotInvalid", "mounted is 'no'"),
    (lambda: sg.Robot(("1", 0), True), "RobotInvalid", "contact is (.|\n)*direction is True"),
    (lambda: sg.place(SWARM, NEWCOMER, spacing=1e300), "ZoneInvalid", "spacing is 1e.300"),
    (lambda: sg.place(SWARM, NEWCOMER, spacing=None), "ZoneInvalid", "spacing is None"),
    (lambda: sg.place(SWARM, NEWCOMER, spacing="1"), "ZoneInvalid", "spacing is '1'"),
    (lambda: sg.place(SWARM, NEWCOMER, 3), "ZoneInvalid", "zones are 3"),
    (lambda: sg.place(SWARM, NEWCOMER, no_go=[1]), "ZoneInvalid", "1 is no Stretch"),
    (lambda: sg.place("x", NEWCOMER), "SwarmInvalid", "'x' is no Swarm"),
    (lambda: sg.place(SWARM), "RobotInvalid", "None is no Newcomer"),
    (lambda: sg.place(PROBLEM, NEWCOMER), "ProblemInvalid", "give none beside it"),
    (lambda: sg.place_sequence(PROBLEM, 2**63), "ProblemInvalid", "from 1 to 1000"),
    (lambda: sg.best_move(None), "ProblemInvalid", "None is no Problem"),
    (lambda: sg.best_move(PROBLEM, robots=[3]), "RobotInvalid", "no robot called 3; there are Aj"),
    (lambda: sg.WrenchSet(None), "SwarmInvalid", "None is no Swarm"),
    (lambda: sg.write_answer("x.json", "x"), "AnswerInvalid", "'x' is no Answer"),
    (lambda: sg.wrench_words(None), "WrenchInvalid", "direction is None"),
    (lambda: sg.wrench_words([1.0]), "WrenchInvalid", "three finite numbers"),
    (lambda: SWARM["R1000000000"], "RobotInvalid", "there are Ajax, R1, R2, R3"),
    (lambda: SWARM.without(1), "RobotInvalid", "names are 1"),
    (lambda: SWARM.without(["Ajax", "Bob", 2]), "RobotInvalid", "'Bob'(.|\n)*called 2"),
    (lambda: SQUARE.inward_normal("bow"), "ContactInvalid", "no edge named 'bow'"),
    (lambda: sg.Outline([(0, 0), (HUGE, 0), (0, 1)]), "OutlineInvalid", "pairs of numbers"),
    (lambda: sg.Outline(["00", "10", "01"]), "OutlineInvalid", "pairs of numbers"),
    (lambda: sg.Polytope([[HUGE, 0, 0]]), "WrenchInvalid", r"vertices are \[\[1000"),
    (lambda: sg.capability(SWARM, WEATHER, [HUGE]), "EnvironmentInvalid", "bearings are"),
    (lambda: sg.how_many(PROBLEM, 1.0, effort=HUGE), "ProblemInvalid", "effort is 1000"),
]


@pytest.mark.parametrize(("misuse", "kind", "says"), MISUSED)
def test_misuse_is_refused_by_name(misuse, kind, says):
    """By an error named after the fault, whose message shows the value."""
    with pytest.raises(getattr(errors, kind), match=says) as caught:
        misuse()
    assert type(caught.value) is getattr(errors, kind)


def test_all_faults_of_several_kinds_are_told_at_once():
    """By an error of the first one's kind."""
    with pytest.raises(errors.SwarmInvalid) as caught:
        sg.place(None, None, 3, gap=2, losing=-1)
    assert len(caught.value.faults) == 5


def test_a_number_of_many_digits_is_not_shown_in_full():
    """Neither as a value nor inside a list."""
    for value in (10**200_000, [10**4000], "9" * 200_000):
        with pytest.raises(errors.RobotInvalid) as caught:
            sg.Robot((0, 0), value)
        assert len(str(caught.value)) < 200


def test_values_are_kept_as_they_were_checked():
    """Numbers as floats, counts as whole numbers, flags as bools, names as text."""
    robot = sg.Robot((np.float32(1), 0), np.int64(0), 2, np.str_("Ajax"), np.bool_(False))
    assert repr(robot) == repr(sg.Robot((1.0, 0.0), 0.0, 2.0, "Ajax", False))
    zone = sg.Zone(sg.Stretch(0, np.float64(1)), "push", np.float32(1), [0, 1])
    assert repr(zone) == repr(sg.Zone(sg.Stretch(0.0, 1.0), "push", 1.0, (0.0, 1.0)))
    criterion = sg.Criterion(np.int64(1), np.bool_(True), np.zeros(3))
    assert repr(criterion) == repr(sg.Criterion(1, True, (0.0, 0.0, 0.0)))
    problem = sg.Problem(SWARM, NEWCOMER, [zone], [zone.stretch], np.int64(0))
    assert (problem.zones, problem.no_go, problem.spacing) == ((zone,), (zone.stretch,), 0.0)
    assert repr(problem.spacing) == "0.0"


# -- anything, anywhere -------------------------------------------------------------------

ANYTHING = [
    None, "1", 3, [1], math.nan, math.inf, HUGE, -1, 1e300, {}, object(), True, [[1, 2], [3]],
    ["a", "b"], np.array([1.0, math.nan]), -1e300, 1e-300, "\x1b", b"1", [None, None, None], {1, 2},
]  # fmt: skip
ROWS = [(1, 0.3), (0.2, -1)]
STRETCH = sg.Stretch(0, 1)
CALLS = [
    (sg.Robot, ((1, 0.3), 3.0, 1.0, "a", False, None)),
    (sg.Newcomer, (1.0, "push", 0.1, "a", None)),
    (sg.Tolerance, (0.1, 0.1, 0.5, False)),
    (sg.Stretch, (0.0, 1.0, "a")),
    (sg.Zone, (STRETCH, "push", 0.1, (0.0, 1.0))),
    (sg.Outline, (SQUARE.vertices, (0, 0), ["a", "b", "c", "d"], 0.0)),
    (sg.Swarm, (SQUARE, CREW, 1.0, (1.0, 1.0))),
    (sg.Swarm.from_arrays, (SQUARE, ROWS, [0.0, 1.0], 1.0)),
    (sg.Polytope, ([(1, 0, 0)],)),
    (sg.Ellipsoid, ([(1, 0, 0)],)),
    (sg.Criterion, (1, False, (0, 0, 0), None)),
    (sg.Problem, (SWARM, NEWCOMER, [sg.Zone(STRETCH)], [], 0.0, sg.Criterion())),
    (sg.WindCoefficients, (1.0, 1.0, 1.0, 0.5)),
    (sg.CurrentCoefficients, (0.1, 0.5)),
    (sg.Wind, (1.0, 1.0, sg.BLENDERMANN["tender"], 0.0, 1.0, 0.0, 1.2)),
    (sg.Current, (1.0, 1.0, 1.0, 0.0, sg.CurrentCoefficients(), 0.0, 1e3)),
    (sg.Environment, (WIND, None, 1.0)),
    (sg.WrenchSet, (SWARM,)),
    (sg.WrenchSet.from_generators, ([[1, 0, 0]], (1, 1, 1))),
    (sg.Summary.of, (SWARM, 12)),
    (sg.Summary.from_generators, ([[1, 0, 0]], 12)),
    (sg.Summary.empty, (SQUARE, 12)),
    (sg.Summary.merge, ([sg.Summary.of(SWARM, 12)],)),
    (sg.Summary.from_bytes, (sg.Summary.of(SWARM, 12).to_bytes(),)),
    (sg.Summary.of(SWARM, 12).place, (SQUARE, NEWCOMER, None, ())),
    (sg.wrench_words, ((1, 0, 0),)),
    (sg.quality, (SWARM,)),
    (sg.qualities, ([[(1, 0, 0)]],)),
    (sg.qualities_with, (SWARM, ROWS, [0.0, 1.0], 1.0)),
    (sg.cell_qualities, (PROBLEM, (2, 2))),
    (sg.losses, (SWARM,)),
    (sg.sensitivities, (SWARM,)),
    (sg.forces, (SWARM, (0, 0, 0))),
    (sg.forces_along, (SWARM, [(0, 0, 0)])),
    (sg.capability, (SWARM, WEATHER, [0.0], 0, False)),
    (sg.place, (SWARM, NEWCOMER, None)),
    (sg.place_sequence, (PROBLEM, 1)),
    (partial(sg.place_together, effort=0), (PROBLEM, 1)),
    (partial(sg.how_many, effort=0), (PROBLEM, 1e-3)),
    (sg.best_move, (PROBLEM,)),
    (sg.verify_document, ({},)),
    (sg.read_answer, ("answer.json",)),
    (sg.Placements, ([sg.place(PROBLEM)],)),
    (document_of, (sg.place(PROBLEM), "name", None)),
    (sg.Swarm.from_data, (SWARM.to_data(),)),
    (sg.Problem.from_data, (PROBLEM.to_data(),)),
    (WEATHER.load, (SQUARE,)),
    (WEATHER.wind_load, (SQUARE, [0.0], [1.0])),
    (WEATHER.current_load, (SQUARE, [0.0])),
    (SQUARE.nearest, ([(0, 0)],)),
    (SQUARE.contains, ((0, 0),)),
    (SQUARE.at_point, ((1, 0),)),
    (SQUARE.at_arc_length, (1.0,)),
    (SQUARE.at_angle, (0.1,)),
    (SQUARE.on_edge, ("e", 0.5)),
    (SQUARE.stretch, ("e", 0.5, 1.0, "a")),
    (SQUARE.edge_label, (0,)),
    (SQUARE.edge_ends, (0,)),
    (SWARM.with_robot, (sg.Robot((1, 0), 0.0),)),
    (SWARM.with_pose, ("Ajax", (1, 0), 0.0)),
    (SWARM.with_tolerance, (sg.Tolerance(),)),
    (SWARM.without, ("Ajax",)),
    (sg.WrenchSet(SWARM).contains, ([0, 0, 0], 1e-9)),
    (sg.WrenchSet(SWARM).support, ([0, 0, 1],)),
]
METRIC = ["characteristic_length", "force_weights"]
TERMS = ["losing", "worst_case", "load", "task"]
KEYWORDS = [
    (sg.Swarm.from_arrays, (SQUARE, ROWS, [0.0, 1.0]), [*METRIC, "mounted"]),
    (sg.Summary.from_generators, ([[1, 0, 0]], 12), [*METRIC, "origin"]),
    (sg.quality, (SWARM,), TERMS),
    (sg.qualities_with, (SWARM, ROWS, [0.0, 1.0]), TERMS),
    (sg.losses, (SWARM,), TERMS),
    (sg.sensitivities, (SWARM,), TERMS),
    (sg.forces, (SWARM, (0, 0, 0)), ["load"]),
    (sg.forces_along, (SWARM, [(0, 0, 0)]), ["load"]),
    (sg.place, (SWARM, NEWCOMER), ["no_go", "spacing", "gap", "runners_up", *TERMS]),
    (sg.place, (PROBLEM,), ["newcomer", "zones", "no_go", "spacing", "gap", "runners_up", "task"]),
    (sg.place_sequence, (PROBLEM, 1), ["gap", "runners_up", "progress"]),
    (sg.place_together, (PROBLEM, 1), ["gap", "effort", "progress"]),
    (sg.how_many, (PROBLEM, 1e-3), ["most", "effort"]),
    (sg.best_move, (PROBLEM,), ["robots", "gap"]),
]


def used(found):
    """Use what was taken: nothing may come to light later."""
    pickle.loads(pickle.dumps(found))
    str(found)
    if isinstance(found, sg.Robot):
        found = sg.Swarm(SQUARE, [found])
    if isinstance(found, sg.Stretch):
        found = sg.Zone(found)
    if isinstance(found, sg.Zone):
        found = sg.Problem(SWARM, NEWCOMER, [found])
    if isinstance(found, sg.Newcomer):
        found = sg.Problem(SWARM, found)
    if isinstance(found, sg.Tolerance):
        found = SWARM.with_tolerance(found)
    if isinstance(found, sg.Polytope | sg.Ellipsoid):
        found = sg.Criterion(task=found)
    if isinstance(found, sg.Criterion):
        found = sg.Problem(SWARM, NEWCOMER, criterion=found)
    if isinstance(found, sg.Outline):
        found = sg.Swarm(found, [])
    if isinstance(found, sg.Swarm):
        found = sg.Problem(found, NEWCOMER)
    if isinstance(found, sg.Problem):
        found = sg.place(found)
    if isinstance(found, sg.Placement):
        assert found.explanation
        found.verify()


CASES = [(call, args, i, None) for call, args in CALLS for i in range(len(args))]
CASES += [(call, args, None, word) for call, args, words in KEYWORDS for word in words]


@pytest.mark.parametrize(("call", "args", "place", "word"), CASES)
def test_anything_anywhere_is_taken_whole_or_refused(call, args, place, word):
    """One wrong argument at a time: an error of ours, or something that is right to the end."""
    for value in ANYTHING:
        given, words = list(args), {}
        if word is None:
            given[place] = value
        else:
            words[word] = value
        with suppress(sg.SwarmGraspError):
            used(call(*given, **words))
