"""Generators, the metric, and robots that hold nothing."""

import copy
import math
import pickle
import re
from dataclasses import replace

import numpy as np
import pytest

import reference
from swarmgrasp.errors import MetricInvalid, OutlineInvalid, RobotInvalid, RobotOffBoundary
from swarmgrasp.outline import Outline
from swarmgrasp.swarm import Robot, Swarm, Tolerance, wrenches

SQUARE = [(-1, -1), (1, -1), (1, 1), (-1, 1)]
ARRAYS = ("contacts", "directions", "limits", "mounted", "generators", "scaled_generators")


def crew_on(outline, count, seed=0):
    """Return random contacts on the boundary, directions and limits, as arrays."""
    rng = np.random.default_rng(seed)
    edges = rng.integers(len(outline), size=count)
    ends = np.roll(outline.vertices, -1, axis=0)
    steps = rng.uniform(size=(count, 1)) * (ends - outline.vertices)[edges]
    return outline.vertices[edges] + steps, rng.uniform(0, 7, count), rng.uniform(1, 2, count)


def same_arrays(one, other):
    """Assert that two swarms hold the same numbers, to the last bit."""
    for name in ARRAYS:
        np.testing.assert_array_equal(getattr(one, name), getattr(other, name))


def test_generators_by_hand():
    """(F_x, F_y, c x F) times the limit: pulling, pushing, and along the edge."""
    robots = [
        Robot((1, 0.5), 0.0, 2.0),
        Robot((0.25, 1), -math.pi / 2, 4.0),
        Robot((-1, 1), math.pi / 4, math.sqrt(2.0)),
    ]
    expected = [[2, 0, -1], [0, -4, -1], [1, 1, -2]]
    np.testing.assert_allclose(Swarm(Outline(SQUARE), robots).generators, expected, atol=1e-15)


def test_moments_are_about_the_origin_wherever_the_object_lies():
    """Moving the frame changes nothing; moving the origin changes the torque."""
    far = Outline(np.add(SQUARE, (100, 50)))
    tug = Robot((101, 50.5), 0.0)
    assert Swarm(far, [tug]).generators.tolist() == [[1.0, 0.0, -0.5]]
    off = Outline(np.add(SQUARE, (100, 50)), origin=(100, 49))
    assert Swarm(off, [tug]).generators.tolist() == [[1.0, 0.0, -1.5]]


def test_generators_agree_with_the_reference():
    """Random robots on a random stretch of boundary, in a weighted metric."""
    rng = np.random.default_rng(3)
    outline = Outline([(0, 0), (5, 1), (4, 3), (1, 2)])
    contacts = [outline.at_arc_length(s).point for s in rng.uniform(0, outline.perimeter, 9)]
    angles, limits = rng.uniform(0, 7, 9), rng.uniform(0.1, 5, 9)
    robots = [Robot(*row) for row in zip(contacts, angles, limits, strict=True)]
    swarm = Swarm(outline, robots, characteristic_length=2.5, force_weights=(4.0, 0.25))
    truth = reference.generators(contacts, angles, limits, outline.origin, (2.0, 0.5, 0.4))
    np.testing.assert_allclose(swarm.scaled_generators, truth, atol=1e-13)


def test_the_metric_defaults_to_the_largest_radius():
    """Unit force weights and the distance to the farthest corner, said in a sentence."""
    swarm = Swarm(Outline(SQUARE), [])
    assert swarm.characteristic_length == math.sqrt(2.0)
    assert swarm.force_weights == (1.0, 1.0)
    assert "characteristic length 1.41421 m" in swarm.metric_sentence


def test_nobody_is_a_swarm():
    """No robots give an empty (0, 3) array; one more gives one row in the same metric."""
    nobody = Swarm(Outline(SQUARE), [], characteristic_length=3.0, force_weights=(1.0, 2.0))
    assert nobody.generators.shape == (0, 3)
    one = nobody.with_robot(Robot((1, 0), 0.0, name="tug"))
    assert (len(one), one.names[0], one.metric_sentence) == (1, "tug", nobody.metric_sentence)


def test_every_robot_off_the_boundary_is_named_at_once():
    """Each with its distance, the nearest boundary point and the remedy."""
    robots = [
        Robot((1, 0), 0.0),
        Robot((1.5, 0), 0.0, name="tug"),
        Robot((0, 0), 0.0),
        Robot((0, -3), 0.0, name="pod", mounted=True),
    ]
    with pytest.raises(RobotOffBoundary) as caught:
        Swarm(Outline(SQUARE), robots)
    tug, nameless, pod = caught.value.faults
    assert tug.startswith("tug at (1.5, 0) m is 0.5 m off the boundary")
    assert "(1, 0) m on edge 1" in tug
    assert nameless.startswith("R2 at (0, 0) m is 1 m off")
    assert nameless.endswith("declare it mounted if it sits inside the outline")
    assert pod.endswith("a mounted robot should be inside the outline")


def test_a_mounted_robot_may_sit_inside_or_on_the_boundary():
    """A thruster of the vessel itself."""
    robots = [Robot((0.5, 0.5), 0.0, mounted=True), Robot((1, 0), 0.0, mounted=True)]
    assert Swarm(Outline(SQUARE), robots).generators[:, 2].tolist() == [-0.5, 0.0]


@pytest.mark.parametrize("bad", [0.0, -1.0, math.inf, math.nan])
def test_the_metric_is_positive_and_finite(bad):
    """All three numbers are checked, and all faults shown."""
    with pytest.raises(MetricInvalid) as caught:
        Swarm(Outline(SQUARE), [], characteristic_length=bad, force_weights=(bad, bad))
    assert len(caught.value.faults) == 3
    assert "1e-100 <= value <= 1e+100 [m]" in caught.value.faults[0]


@pytest.mark.parametrize("weights", [2.0, None, (1.0,), (1, 1, 1)])
def test_the_force_weights_are_two(weights):
    """Said together with what is wrong with the length."""
    with pytest.raises(MetricInvalid, match="they should be two numbers") as caught:
        Swarm(Outline(SQUARE), [], characteristic_length=0.0, force_weights=weights)
    assert len(caught.value.faults) == 2


# -- arrays -------------------------------------------------------------------------------


def test_a_swarm_made_from_arrays_equals_the_one_made_from_its_robots():
    """Same numbers in both, and robots that are made only when they are asked for."""
    outline = Outline(SQUARE, origin=(0.3, 0.1))
    swarm = Swarm.from_arrays(outline, *crew_on(outline, 50), characteristic_length=3.0)
    assert (len(swarm), swarm.names[7], "robots" in vars(swarm)) == (50, "R8", False)
    same_arrays(swarm, Swarm(outline, swarm.robots, 3.0))
    assert swarm.robots is swarm.robots


def test_a_swarm_keeps_the_very_robots_it_is_made_from():
    """Also after one more has joined; labels are their names."""
    crew = [Robot((1, 0), 0.0, name="ajax"), Robot((0, 0), 1.0, name="boreas", mounted=True)]
    swarm = Swarm(Outline(SQUARE), crew[:1]).with_robot(crew[1])
    assert all(kept is given for kept, given in zip(swarm, crew, strict=True))
    assert list(swarm.names) == ["ajax", "boreas"]


def test_a_newcomer_to_arrays_is_remembered_with_its_name():
    """Robot by robot, the same swarm as at once, and still no object per robot."""
    outline = Outline(SQUARE)
    contacts, directions, limits = crew_on(outline, 9, seed=1)
    swarm = Swarm.from_arrays(outline, contacts[:4], directions[:4], limits[:4])
    for contact, direction, limit in zip(contacts[4:], directions[4:], limits[4:], strict=True):
        swarm = swarm.with_robot(Robot(tuple(contact), direction, limit, name=f"tug {limit:.3f}"))
    assert "robots" not in vars(swarm)
    same_arrays(swarm, Swarm.from_arrays(outline, contacts, directions, limits))
    assert swarm.robots[8].name == swarm.names[8] == f"tug {limits[8]:.3f}"


def test_a_newcomer_off_the_boundary_is_named_by_its_place_in_the_swarm():
    """Those before it were checked already; what is no robot is refused."""
    swarm = Swarm.from_arrays(Outline(SQUARE), [(1, 0), (0, 1)], [0.0, 0.0])
    with pytest.raises(RobotOffBoundary, match=r"R3 at \(3, 0\) m is 2 m off"):
        swarm.with_robot(Robot((3, 0), 0.0))
    with pytest.raises(RobotInvalid, match="'tug' is no Robot"):
        swarm.with_robot("tug")
    with pytest.raises(OutlineInvalid, match="is no Outline"):
        Swarm(SQUARE, [])


def test_arrays_are_copied_and_can_be_read_only():
    """Neither the caller nor a reader can change a swarm."""
    outline = Outline(SQUARE)
    given = crew_on(outline, 5)
    swarm = Swarm.from_arrays(outline, *given)
    for array in given:
        array[:] = 9.0
    same_arrays(swarm, Swarm.from_arrays(outline, *crew_on(outline, 5)))
    for array in (swarm.scale, *(getattr(swarm, name) for name in ARRAYS)):
        with pytest.raises(ValueError, match="read-only"):
            array[0] = 9.0


@pytest.mark.parametrize(
    "copied", [copy.copy, copy.deepcopy, lambda s: pickle.loads(pickle.dumps(s))]
)
def test_a_copy_is_the_same_swarm_and_read_only(copied):
    """With names, and with what was worked out before."""
    swarm = Swarm(Outline(SQUARE), [Robot((1, 0), 0.5, name="ajax"), Robot((0, 1), 2.0)], 3.0)
    swarm.scaled_generators  # noqa: B018 - kept from now on
    twin = copied(swarm)
    same_arrays(swarm, twin)
    assert (twin, hash(twin), twin.robots) == (swarm, hash(swarm), swarm.robots)
    assert twin.metric_sentence == swarm.metric_sentence
    for array in (twin.scale, *(getattr(twin, name) for name in ARRAYS)):
        assert not array.flags.writeable


@pytest.mark.parametrize("empty", [[], [[]], np.empty((0, 2)), np.empty((2, 0))])
def test_empty_arrays_are_nobody(empty):
    """Of any sensible shape; a single limit still fits."""
    for nobody in (
        Swarm.from_arrays(Outline(SQUARE), empty, []),
        Swarm.from_arrays(Outline(SQUARE), empty, empty, empty, mounted=empty),
    ):
        assert (len(nobody), nobody.robots, nobody.contacts.shape) == (0, (), (0, 2))


def test_limits_and_mounted_flags_fit_all_robots_or_each():
    """One value for all, or one per robot."""
    inside = [(0.5, 0.5), (1, 0)]
    swarm = Swarm.from_arrays(Outline(SQUARE), inside, [0, 1], 3, mounted=[True, False])
    assert (swarm.limits.tolist(), swarm.mounted.tolist()) == ([3.0, 3.0], [True, False])
    assert [robot.mounted for robot in swarm.robots] == [True, False]
    assert Swarm.from_arrays(Outline(SQUARE), inside, [0, 1], [3, 4], mounted=True).mounted.all()


@pytest.mark.parametrize(
    ("arrays", "says"),
    [
        ((np.zeros((2, 5)), np.zeros(5)), [r"contacts have shape \(2, 5\); .* \(n, 2\)"]),
        (
            ([(1, 0)] * 3, [0.0, 0.0], [1.0] * 4),
            [r"directions have shape \(2,\).* \(3,\)", r"limits have .* \(\) or \(3,\)"],
        ),
        (
            ([(1,), (2, 3)], ["north"], None),
            ["contacts have rows of", "directions are of type <U5", "limits are of type object"],
        ),
        (
            ([(1, math.nan), (1, 0)], [0.0, -2e6], [0.0, math.inf]),
            [
                r"R1: the contact is \(1.0, nan\)",
                "R1: the limit is 0.0; it should be 1e-100 <=",
                "R2: the direction is -2000000.0; it should be -1e6 <=",
                "R2: the limit is inf",
            ],
        ),
    ],
)
def test_arrays_at_fault_are_explained_all_at_once(arrays, says):
    """Their types, their shapes, or their values in the words of a single robot."""
    with pytest.raises(RobotInvalid) as caught:
        Swarm.from_arrays(Outline(SQUARE), *arrays)
    for fault, pattern in zip(caught.value.faults, says, strict=True):
        assert re.search(pattern, fault)


def test_flags_are_not_guessed_from_numbers_or_words():
    """A mounted flag is True or False."""
    with pytest.raises(RobotInvalid, match=r"mounted flags are of type <U2; .* True or False"):
        Swarm.from_arrays(Outline(SQUARE), [(1, 0)], [0.0], mounted="no")


def test_a_million_faults_make_a_readable_message():
    """Ten robots are described, the others counted, by kind of fault."""
    outline, million = Outline(SQUARE), 1_000_000
    contacts, directions = np.full((million, 2), 3.0), np.zeros(million)
    with pytest.raises(RobotOffBoundary) as caught:
        Swarm.from_arrays(outline, contacts, directions, mounted=directions > 0.0)
    assert (len(caught.value.faults), caught.value.faults[-1]) == (11, "... and 999 990 more")
    contacts[:], directions[-3:] = math.nan, math.inf
    with pytest.raises(RobotInvalid) as caught:
        Swarm.from_arrays(outline, contacts, directions)
    assert caught.value.faults[9].startswith("R10: the contact is (nan, nan)")
    assert caught.value.faults[10:] == (
        "... and 999 990 more; in all, out of range: 1 000 000 contacts, 3 directions",
    )


def test_exactly_as_many_faults_as_are_listed_leave_nobody_to_count():
    """Ten robots off the boundary are ten lines."""
    with pytest.raises(RobotOffBoundary) as caught:
        Swarm.from_arrays(Outline(SQUARE), [(3, 0)] * 10, np.zeros(10))
    assert len(caught.value.faults) == 10


def test_a_million_robots_are_practical():
    """Made and joined from arrays, without an object per robot."""
    outline = Outline(SQUARE)
    arrays = crew_on(outline, 1_000_000)
    swarm = Swarm.from_arrays(outline, *arrays).with_robot(Robot((1, 0), 0.0))
    assert (len(swarm), swarm.names[999_999]) == (1_000_001, "R1000000")
    assert len(repr(swarm)) < 300
    assert sum(getattr(swarm, name).nbytes for name in ARRAYS) < 100e6
    assert "robots" not in vars(swarm)


def test_wrenches_take_leading_axes():
    """Two contacts against three directions, one force."""
    arms, directions = np.array([[1.0, 0.5], [0.0, -1.0]]), np.array([0.0, 1.0, 2.0])
    table = wrenches(arms[:, None], directions, np.array(2.0))
    assert table.shape == (2, 3, 3)
    for i, j in np.ndindex(2, 3):
        one = wrenches(arms[i], directions[j], np.array(2.0))
        np.testing.assert_array_equal(table[i, j], one)


def test_measured_contacts_are_moved_to_the_nearest_boundary_point_or_refused():
    """Within `snap`; mounted robots stay; how far the others are off is told, of all of them."""
    outline, measured = Outline(SQUARE), [(1.3, 0.4), (-0.2, 0.8), (1.2, -1.4), (0.1, 0.2)]
    mounted = [False, False, False, True]
    swarm = Swarm.from_arrays(outline, measured, [0.0] * 4, mounted=mounted, snap=0.5)
    right = [(1.0, 0.4), (-0.2, 1.0), (1.0, -1.0), (0.1, 0.2)]
    assert np.allclose(swarm.contacts, right, rtol=0, atol=1e-15)
    with pytest.raises(RobotOffBoundary) as refused:
        Swarm.from_arrays(outline, measured, [0.0] * 4, mounted=mounted, snap=0.25)
    assert [fault.partition(" m off")[0] for fault in refused.value.faults] == [
        "R1 at (1.3, 0.4) m is 0.3", "R3 at (1.2, -1.4) m is 0.447",
    ]  # fmt: skip
    assert all("snap moves it by 0.25 m at most" in fault for fault in refused.value.faults)
    for wrong in (-0.1, math.nan, "0.5", [0.5]):
        with pytest.raises(RobotInvalid, match="the snap is"):
            Swarm.from_arrays(outline, measured, [0.0] * 4, snap=wrong)


def test_arrays_with_names_and_tolerances_are_robots_with_them():
    """The swarm of these robots, made of arrays; what is wrong with either is told."""
    square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    rough = Tolerance(contact=0.1, least_limit=0.5)
    robots = [
        Robot((1, 0.5), 0.5, name="Ajax", tolerance=rough),
        Robot((0, 1), 1.0, 2.0),
        Robot((0, 0), 1.0, name="R1", mounted=True),
    ]
    columns = [[r.contact for r in robots], [r.direction for r in robots], [1.0, 2.0, 1.0]]
    mounted, names = [False, False, True], ["Ajax", "", "R1"]
    made = Swarm.from_arrays(
        square, *columns, mounted=mounted, names=names, tolerances=[rough, None, None]
    )
    assert made == Swarm(square, robots)
    assert list(made) == list(Swarm(square, robots))
    everyone = Swarm.from_arrays(square, *(c[:2] for c in columns), tolerances=rough)
    assert set(everyone.tolerances) == {0, 1}
    for wrong, said in [
        ({"names": ["Ajax"]}, "1 names for 3 robots"),
        ({"names": ["A", "B", "A"]}, "both called 'A'"),
        ({"names": ["A", "B", 3]}, "the name is 3"),
        ({"names": 3}, "should be a list of names"),
        ({"tolerances": rough, "mounted": mounted}, "R3: a mounted robot stays"),
        ({"tolerances": [rough]}, "the tolerances are 1"),
        ({"tolerances": [None, 0.5, None]}, "R2: 0.5 is no Tolerance"),
        ({"tolerances": Tolerance(least_limit=1.5)}, "R1: the least limit is 1.5"),
    ]:
        with pytest.raises(RobotInvalid, match=said):
            Swarm.from_arrays(square, *columns, **wrong)


def test_a_robot_in_the_place_of_another():
    """The swarm is the same as one of the new robots, and refuses what that would."""
    square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    robots = [Robot((1, 0), 0.0, name="Ajax"), Robot((0, 1), 0.5), Robot((0, -1), 1.5, name="R7")]
    new = Robot((1, 0.5), 0.5, 2.0, steers=0.5, group="bus", tolerance=Tolerance(contact=0.1))
    swarm = Swarm(square, robots)
    found = swarm.replaced("R1", new)
    assert found == Swarm(square, [robots[0], replace(new, name="R1"), robots[2]])
    renamed = swarm.replaced("Ajax", replace(new, name="Boreas"))
    assert renamed == Swarm(square, [replace(new, name="Boreas"), *robots[1:]])
    assert next(iter(renamed)).name == "Boreas"
    for name, robot, said in [
        ("Ajax", replace(new, name="R7"), "both called 'R7'"),
        ("Nobody", new, "Nobody"),
        ("Ajax", None, "Robot"),
    ]:
        with pytest.raises(RobotInvalid, match=said):
            swarm.replaced(name, robot)
    with pytest.raises(RobotOffBoundary):
        swarm.replaced("Ajax", replace(new, contact=(3.0, 0.0)))
