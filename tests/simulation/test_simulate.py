"""Runs in closed loop: at rest when nothing happens, back after a loss, alone or in a batch."""

import pickle
from dataclasses import replace

import numpy as np
import pytest

from afloat import BARGE, ROBOTS, sea_of
from moored import moored
from swarmgrasp import Newcomer, Problem, Stretch, Swarm, Zone, quality
from swarmgrasp.environment import KNOT
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.simulation import Actuator, Hull, Simulation
from swarmgrasp.simulation.control import Control
from swarmgrasp.simulation.events import Change, Follow, Leave, Lose, Move, Send
from swarmgrasp.simulation.run import Run
from swarmgrasp.simulation.simulate import simulate
from swarmgrasp.simulation.weather import Series, Weather

QUIET = Control(position_noise=0.0, heading_noise=0.0)
GUSTS = Weather("npd")
ARRAYS = (
    "references", "poses", "velocities", "distances", "turns", "streams", "loads", "wanted",
    "given", "shortfalls", "forces", "angles", "shares", "gusts",
)  # fmt: skip


def assert_same(one: Run, of: int, other: Run, other_of: int) -> None:
    """Assert that two runs of two batches are the same to the last bit."""
    for name in ARRAYS:
        rows = [getattr(one, name), getattr(other, name)]
        if name != "references":
            rows = [rows[0][of], rows[1][other_of]]
        assert rows[0].tobytes() == rows[1].tobytes(), name


@pytest.mark.parametrize("name", ["deck-barge", "escort-ring"])
def test_an_object_at_rest_in_a_steady_wind_within_reach_stays_at_rest(name: str) -> None:
    """The robots give the opposite of the load, from the start on."""
    run = simulate(moored(name, 40.0, 60.0, control=QUIET, duration=60.0))
    assert run.distances.max() < 1e-6
    assert run.turns.max() < 1e-9
    np.testing.assert_allclose(run.given[0], -run.loads[0], rtol=1e-5, atol=1.0)
    assert run.shortfalls.max() == 0.0


def test_a_batch_has_the_same_bytes_as_each_run_alone() -> None:
    """In gusts, with noise, a loss that is noticed late and a newcomer that joins."""
    events = (Lose(5, "Boreas", noticed=3.0), Send(8, away=60.0, make_fast=4.0))
    gale = moored("deck-barge", 60.0, 60.0, weather=GUSTS, events=events, duration=45.0)
    batch = simulate(gale, range(7))
    assert [at.kind for at in batch.happenings] == ["start", "lost", "noticed", "sent", "joined"]
    for seed in (0, 4, 6):
        assert_same(simulate(gale, [seed]), 0, batch, seed)
    assert not np.array_equal(batch.poses[0], batch.poses[1])


def test_a_sink_gets_all_that_is_kept_and_the_answer_holds_some() -> None:
    """Piece after piece, each a run up to its end; the largest errors are in the answer, too."""
    gale = moored("deck-barge", 60.0, 60.0, weather=GUSTS, events=(Lose(20, "Ajax"),), duration=60)
    pieces: list[Run] = []
    seeds = range(16)
    held = simulate(gale, seeds, every=5, most=10, sink=pieces.append)
    whole = simulate(gale, seeds, every=5)
    assert len(pieces) > 3
    for name in ARRAYS[:-1]:
        axis = 0 if name == "references" else 1
        told = np.concatenate([getattr(piece, name) for piece in pieces], axis)
        assert told.tobytes() == getattr(whole, name).tobytes(), name
    assert [piece.is_whole for piece in pieces] == [False] * (len(pieces) - 1) + [True]
    assert [len(piece.happenings) for piece in pieces][:: len(pieces) - 1] == [1, 2]
    assert len(held.times) <= 10
    assert held.times[-1] == whole.times[-1]
    assert np.isin(held.times, whole.times).all()
    assert np.array_equal(held.distances.max(axis=1), whole.distances.max(axis=1))


def test_runs_without_events_are_those_of_one_whose_events_are_still_to_come() -> None:
    """What will happen changes nothing before."""
    calm = moored("deck-barge", 50.0, 200.0, weather=GUSTS, duration=30.0)
    later = replace(calm, events=(Lose(20, "Ajax"), Move(25, 1.0, 2.0)))
    one, other = simulate(calm), simulate(later)
    before = one.times < 20.0
    for name in ("poses", "wanted", "given", "forces"):
        np.testing.assert_array_equal(
            getattr(one, name)[0, before], getattr(other, name)[0, before]
        )
    assert not np.array_equal(one.poses, other.poses)


def test_after_a_loss_and_a_join_the_barge_is_back_in_a_minute() -> None:
    """Within 1 m and 1 degree, at 60 knots."""
    events = (Lose(10, "Boreas"), Send(10))
    run = simulate(moored("deck-barge", 60.0, 60.0, events=events, duration=270.0))
    assert [at.kind for at in run.happenings] == ["start", "lost", "sent", "joined"]
    joined = run.happenings[-1].time
    assert run.turns[0, run.times < joined].max() > 0.3
    settled = run.times > joined + 60.0
    assert settled.sum() > 5
    assert run.distances[0, settled].max() < 1.0
    assert np.degrees(run.turns[0, settled].max()) < 1.0


def test_what_is_out_of_reach_for_a_minute_winds_nothing_up() -> None:
    """Back in reach, the object goes home without a turn and hardly beyond."""
    gale = moored("deck-barge", 60.0, 60.0, duration=230.0)
    back = Change(65, wind_speed=gale.environment.wind.speed)
    run = simulate(replace(gale, events=(Change(5, wind_speed=130.0 * KNOT), back)))
    out = (run.times > 5.0) & (run.times <= 65.0)
    assert (run.shortfalls[0, out] > 0.0).mean() > 0.9
    away = run.poses[0, run.times <= 75.0][-1, :2]
    home = away / np.hypot(*away)
    overshoot = -(run.poses[0, run.times > 65.0, :2] @ home).min()
    assert np.hypot(*away) > 5.0
    assert overshoot < 2.0
    assert run.turns.max() < np.pi
    assert run.distances[0, -1] < 0.5


def test_a_loss_that_is_noticed_late_costs_what_was_asked_of_the_lost() -> None:
    """Until it is noticed the lost robot is asked for a share and gives nothing."""
    gale = moored("deck-barge", 60.0, 60.0, control=QUIET, duration=40.0)
    run = simulate(replace(gale, events=(Lose(10, "Castor", noticed=10.0),)), every=1)
    castor = run.names.index("Castor")
    unknown = (run.times >= 10.0) & (run.times < 20.0)
    assert (run.shares[0, unknown, castor] > 0.0).all()
    assert not run.forces[0, unknown, castor].any()
    assert np.isnan(run.angles[0, unknown, castor]).all()
    assert not run.shares[0, run.times >= 20.0, castor].any()
    assert [len(stint.swarm) for stint in run.stints] == [6, 5]
    assert [stint.start for stint in run.stints] == pytest.approx([0.0, 10.0])


def test_a_path_is_followed_and_a_move_is_made() -> None:
    """With feed-forward the object is never far from a reference that moves."""
    events = (Follow(0, [(12, 0), (12, 6)], speed=0.5), Move(150, 0.0, 0.0, 0.1))
    run = simulate(moored("deck-barge", 10.0, 60.0, events=events, duration=300.0))
    np.testing.assert_allclose(run.references[-1], (0.0, 0.0, 0.1), atol=0.01)
    there = np.argmin(np.abs(run.times - 149.0))
    np.testing.assert_allclose(run.references[there], (12.0, 6.0, 0.0), atol=0.05)
    assert run.distances[0, run.times < 150.0].max() < 1.0
    assert run.distances[0, -1] < 0.5


def test_robots_leave_are_sent_and_are_lost_on_the_way() -> None:
    """Each is told, and only those who join ever hold the object."""
    tug = Newcomer(400e3, "push", 0.5, name="Gaia")
    events = (Leave(5, "Ajax"), Send(6, tug), Send(7), Lose(8, "Gaia"), Leave(9, "Fortuna 2"))
    run = simulate(moored("deck-barge", 10.0, 60.0, events=events, duration=12.0))
    assert [at.words.split(" at ")[0] for at in run.happenings][1] == "Ajax leaves"
    assert [at.robot for at in run.happenings[2:]] == ["Gaia", "Fortuna 2", "Gaia", "Fortuna 2"]
    assert run.happenings[-2].words == "Gaia is lost on its way"
    assert run.happenings[-1].words == "Fortuna 2 turns back on its way"
    assert run.names[-2:] == ("Gaia", "Fortuna 2")
    assert not run.forces[0, :, -2:].any()


def test_the_robots_of_a_group_are_lost_as_one() -> None:
    """Nobody knows until it is noticed; one that left before is not lost again."""
    barge = moored("deck-barge", 10.0, 60.0)
    problem = barge.problem
    swarm, pulling = problem.swarm, {"Dione", "Electra"}
    robots = [replace(r, group="line" if r.name in pulling else "") for r in swarm.robots]
    problem = problem.with_swarm(Swarm(swarm.outline, robots))
    events = (Leave(5, "Dione"), Lose(10, "line", noticed=10))
    run = simulate(replace(barge, problem=problem, events=events, duration=30.0))
    told = [(h.time, h.words) for h in run.happenings[1:]]
    assert told == [
        (5.0, "Dione leaves"),
        (10.0, "Electra of line is lost, which nobody knows yet"),
        (20.0, "it is noticed that Electra of line is lost"),
    ]
    whole = replace(barge, problem=problem, events=(Lose(10, "line"),), duration=30.0)
    found = simulate(whole).happenings[-1]
    assert (found.robot, found.words) == ("line", "Dione and Electra of line are lost")
    assert found.quality == quality(problem.swarm.without("Dione").without("Electra")).value


def test_a_series_says_the_mean_wind() -> None:
    """Straight between its times, and constant after the last."""
    series = Series([0.0, 10.0, 20.0], [0.0, 10.0, 10.0], [0.0, 0.0, np.pi / 2])
    sea = moored("deck-barge", 10.0, 60.0, weather=Weather(series=series), duration=30.0)
    run = simulate(sea, every=50)
    np.testing.assert_allclose(run.times, [0, 5, 10, 15, 20, 25, 30])
    half = np.sqrt(50.0)
    air = [(0, 0), (-5, 0), (-10, 0), (-half, half), (0, 10), (0, 10), (0, 10)]
    np.testing.assert_allclose(run.streams[0, :, :2], air, atol=1e-5)


def test_what_a_simulation_cannot_be_is_told_at_once() -> None:
    """Contradictions of events, strangers, and weather that is missing or said twice."""
    fine = moored("deck-barge", 10.0, 60.0)
    series = Weather(series=Series([0.0], [1.0], [0.0]))
    with pytest.raises(SimulationInvalid, match=r"'Bob'(.|\n)*a series says(.|\n)*lose at 3 s"):
        replace(
            fine, actuators=(("Bob", fine.actuator),), weather=series,
            events=(Lose(3, "Nobody"), Change(1, wind_speed=2.0)),
        )  # fmt: skip
    with pytest.raises(SimulationInvalid, match=r"no Hull(.|\n)*duration is 0(.|\n)*seed is -1"):
        replace(fine, hull=3, duration=0, seed=-1)
    still = replace(
        fine.environment,
        current=None,
        wind=replace(fine.environment.wind, speed=None, bearing=None),
    )
    with pytest.raises(SimulationInvalid, match=r"no current(.|\n)*no speed and bearing"):
        replace(fine, environment=still)
    with pytest.raises(SimulationInvalid, match="no period and no frequency"):
        replace(fine, actuator=replace(fine.actuator, lag=0.0))
    with pytest.raises(SimulationInvalid, match=r"seeds are (.|\n)*every is 0(.|\n)*progress is 3"):
        simulate(fine, [], every=0, progress=3)
    with pytest.raises(SimulationInvalid, match=r"seed is 1.5"):
        simulate(fine, [1.5])
    with pytest.raises(SimulationInvalid, match="keep one of"):
        simulate(fine, range(99_999), every=1)


def test_what_was_run_is_kept_when_it_is_stopped_from_the_keyboard() -> None:
    """The run says that it is not whole."""

    def stop(part: float) -> None:
        if part > 0.3:
            raise KeyboardInterrupt

    run = simulate(moored("deck-barge", 10.0, 60.0, duration=100.0), progress=stop)
    assert not run.is_whole
    assert 30.0 < run.times[-1] < 45.0
    assert run.poses.shape[1] == len(run.times) == len(run.references)
    assert run.stints[-1].end == run.times[-1]


def test_an_object_goes_on_over_the_ground_when_the_current_changes() -> None:
    """It is not carried along at once, and held in the new one by and by."""
    calm = moored("deck-barge", 10.0, 60.0, control=QUIET, duration=70.0)
    run = simulate(replace(calm, events=(Change(5, current_speed=1.0),)), every=1)
    moved = np.abs(np.diff(run.poses[0, :, :2], axis=0)).max(axis=1)
    assert moved[run.times[1:] < 6.0].max() < 0.01
    assert 0.05 < run.distances.max() < 2.0
    assert run.distances[0, -1] < 0.4 * run.distances.max()
    np.testing.assert_allclose(np.hypot(*run.streams[0, -1, 2:]), 1.0, rtol=1e-6)


def test_robots_of_any_kind_go_in_step_as_they_go_alone() -> None:
    """Those that steer, reverse, have friction or an envelope, beside one on a line."""
    robots = [robot for robot in ROBOTS if robot.sectors is None]
    swarm = Swarm(BARGE, robots)
    sea = sea_of(0.4, speed=8.0, bearing=1.0)
    aft = Zone(Stretch(0.0, 30.0, "aft"))
    mixed = Simulation(
        Problem(swarm, Newcomer(100e3), (aft,)), sea, Hull.afloat(BARGE, sea),
        actuators=(("ray", Actuator(follows="earth")), ("tug", Actuator(mass=5e5))),
        weather=GUSTS, events=(Lose(3, "tug"), Send(3, away=45.0, make_fast=0.0, speed=20.0)),
        duration=12.0,
    )  # fmt: skip
    batch = simulate(mixed, range(5), every=1)
    assert [at.kind for at in batch.happenings] == ["start", "lost", "sent", "joined"]
    assert batch.distances.max() < 1.0
    for seed in (0, 3):
        assert_same(simulate(mixed, [seed], every=1), 0, batch, seed)


def test_a_simulation_is_read_back_from_its_plain_form_and_from_a_pickle() -> None:
    """Events, actuators and weather included."""
    series = Weather("npd", Series([0.0, 9.0], [1.0, 2.0], [0.0, 0.1]))
    tug = Newcomer(400e3, "push", 0.5, name="Gaia")
    whole = moored(
        "deck-barge", 10.0, 60.0, weather=series, seed=7, step=0.05,
        actuators=(("Ajax", Actuator(lag=2.0)), ("Gaia", Actuator(mass=1e5))),
        events=(Send(2, tug), Leave(1, "Ajax"), Follow(3, [(1, 2)], 1.0), Lose(5, "Gaia")),
    )  # fmt: skip
    assert Simulation.from_data(whole.to_data()) == whole
    assert pickle.loads(pickle.dumps(whole)) == whole


def test_a_newcomer_that_can_have_no_place_is_refused_before_it_is_sent() -> None:
    """By what its zones say."""
    afloat = Newcomer(100e3, mounted=True)
    with pytest.raises(SimulationInvalid, match=r"send at 3 s: (.|\n)*has no area"):
        moored("deck-barge", 10.0, 60.0, events=(Send(3, afloat),))


def test_an_object_that_all_have_let_go_drifts_until_another_joins() -> None:
    """No robot is a swarm, too."""
    calm = moored("deck-barge", 10.0, 60.0, control=QUIET, duration=30.0)
    gone = tuple(Lose(1, name, noticed=1.0) for name in calm.problem.swarm.names)
    helped = (*gone, Send(3, away=45.0, make_fast=0.0, speed=10.0))
    run, adrift = simulate(replace(calm, events=helped)), simulate(replace(calm, events=gone))
    assert [len(stint.swarm) for stint in run.stints] == [6, 5, 4, 3, 2, 1, 0, 1]
    assert not adrift.given[0, adrift.times > 1.0].any()
    assert adrift.distances[0, -1] > 0.3
    assert list(run.stints[-1].swarm.names) == ["Fortuna 2"]


def test_a_newcomer_without_a_place_can_be_lost_or_leave() -> None:
    """Whether there is one shows only in the run; and nobody is missed."""
    port = moored("deck-barge", 10.0, 60.0, control=QUIET, duration=4.0)
    one = replace(port.problem, zones=port.problem.zones[-1:])
    events = (Send(1), Send(1), Send(1), Lose(2, "Fortuna 3", noticed=1.0), Leave(3, "Fortuna 4"))
    run = simulate(replace(port, problem=one, events=events))
    assert [at.words for at in run.happenings[2:]] == [
        "there is no place left for Fortuna 3",
        "there is no place left for Fortuna 4",
        "Fortuna 3, which had no place, is lost",
        "Fortuna 4, which had no place, turns back",
    ]
    assert len(run.stints) == 1
