"""Runs of a simulation, all in step: look, decide, share out, move."""

import math
from collections.abc import Callable, Sequence

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.ranges import call_faults, is_whole, items, kind_faults, shown
from swarmgrasp.simulation.allotting import Allotment
from swarmgrasp.simulation.crew import Crew, plant_of, state_of, vectors_of
from swarmgrasp.simulation.frames import Headings
from swarmgrasp.simulation.keeping import MOST_NUMBERS, Keeper, numbers_kept
from swarmgrasp.simulation.motion import BODY
from swarmgrasp.simulation.reference import Reference
from swarmgrasp.simulation.run import Run
from swarmgrasp.simulation.schedule import Schedule, resting
from swarmgrasp.simulation.simulation import Simulation, seed_faults
from swarmgrasp.simulation.station import Controller, Known, Look, StationKeeping
from swarmgrasp.simulation.weather import SENSORS, Mean, Streams, generator_of, mean_of

Array = NDArray[np.float64]
RunProgress = Callable[[float], object] | None
Sink = Callable[[Run], object] | None

BLOCK = 64
"""Instants for which weather and noise are drawn at once."""
MOST_AT_ONCE = 100_000
MOST_INSTANTS = 100_001
"""In one answer: a day of tugs, one each second; a sink gets more."""
PIECE, LEAST_PIECE = 256, 16
"""Instants of a piece that a sink gets, over the number of runs, and its least."""
MOST_TOLD = 10
"""Seeds at fault that a message tells."""
SAME = 1e-9
"""Of a period: what a time may be late for an instant, for rounding."""


def simulate(
    simulation: Simulation,
    seeds: Sequence[int] | None = None,
    controller: Controller | None = None,
    *,
    every: int = 10,
    most: int = MOST_INSTANTS,
    sink: Sink = None,
    progress: RunProgress = None,
) -> Run:
    """Run a simulation, once for each of some seeds.

    All runs go in step. What becomes of one depends on its own seed alone, to the last bit.

    At the start the object is at rest where it is to be, the robots hold the mean load as well as
    they can, and the controller knows what acts. Events happen at the first instant of control that
    is not before their time. From the keyboard it can be stopped: what was run until then is kept.

    Parameters
    ----------
    simulation : Simulation
    seeds : sequence of int, optional
        The simulation's own when left out.
    controller : Controller, optional
        `StationKeeping` when left out.
    every : int
        Of so many periods of control one is kept, beside the last.
    most : int
        Instants that the answer holds: if more are kept, every second of them, or third, and so on.
    sink : callable, optional
        Called as the run goes on with all that is kept, piece after piece, each a `Run` of its
        own; `record.Log` writes them to a file.
    progress : callable, optional
        Called with the part that is done, within [0, 1], now and then.

    Returns
    -------
    Run

    Raises
    ------
    SimulationInvalid
        If something is not what it should be; all faults at once.
    """
    faults = kind_faults(simulation, Simulation, "Simulation(problem, environment, hull)")
    given = () if seeds is None else items(seeds)
    if given is None or (seeds is not None and not 1 <= len(given) <= MOST_AT_ONCE):
        faults.append(f"the seeds are {shown(seeds)}; they should be 1 to {MOST_AT_ONCE} numbers")
    faults += [fault for seed in given or () for fault in seed_faults(seed)][:MOST_TOLD]
    if not is_whole(every) or every < 1:
        faults.append(f"every is {shown(every)}; it should be a whole number >= 1")
    if not is_whole(most) or most < 2:
        faults.append(f"most is {shown(most)}; it should be a whole number >= 2")
    faults += call_faults(progress) + call_faults(sink)
    if faults:
        raise SimulationInvalid(faults)
    chosen = tuple(map(int, given or (simulation.seed,)))
    kept = simulation.duration / simulation.tuning.period / every
    course = Course(
        simulation, chosen, mean_of(simulation.environment), controller or StationKeeping(),
        every * max(1, math.ceil(kept / (most - 1) - SAME)),
    )  # fmt: skip
    if sink is not None:
        course.pour(sink, every)
    return course.run(progress)


class Course:
    """Runs that go on.

    Parameters
    ----------
    simulation : Simulation
    seeds : tuple of int
        One for each run.
    mean : Mean
        The mean weather, of all runs or of each.
    controller : Controller
    every : int
        Of so many periods of control one is kept.

    Raises
    ------
    SimulationInvalid
        If more would be kept than memory should hold.
    """

    def __init__(
        self, simulation: Simulation, seeds: tuple[int, ...], mean: Mean, controller: Controller,
        every: int,
    ) -> None:  # fmt: skip
        self._simulation, self._seeds, self._controller = simulation, seeds, controller
        self._tuning = tuning = simulation.tuning
        self._steps = simulation.steps
        self._last = max(1, self._number(simulation.duration))
        self._columns = {name: i for i, name in enumerate(simulation.names)}
        _check_memory(len(seeds), self._last, len(self._columns), every)
        self._streams = Streams(simulation.weather, mean, seeds, tuning.period)
        self._gusts = self._streams.spread(0.0)
        self._noise = Noise(seeds, tuning.position_noise, tuning.heading_noise)
        self._reference = Reference(tuning.frequency)
        self._crew = Crew(simulation)
        nobody = simulation.problem.swarm.without_rows(range(len(simulation.problem.swarm)))
        self._bare = plant_of(simulation, nobody)
        self._schedule = Schedule(simulation, self._crew, self._reference, self._streams)
        self._keeper = Keeper(len(seeds), self._last, len(self._columns), every)
        self._pieces: Keeper | None = None
        self._sink: Sink = None
        self._begin()

    def pour(self, sink: Callable[[Run], object], every: int) -> None:
        """Give away one of so many instants as the runs go on, piece after piece."""
        runs = len(self._seeds)
        room = max(LEAST_PIECE, PIECE // runs)
        self._pieces = Keeper(runs, self._last, len(self._columns), every, room)
        self._sink, self._every = sink, every

    def _number(self, time: float) -> int:
        """Return the number of the first instant that is not before a time [s]."""
        return math.ceil(time / self._tuning.period - SAME)

    def _begin(self) -> None:
        """Begin at rest, with the mean load held as well as it can be."""
        plant, runs = self._crew.there, len(self._seeds)
        steady = np.broadcast_to(self._streams.steady(0.0), (runs, 4))
        state = resting(plant, steady, 0.0)
        loads = plant.load(state, steady)
        self._settle()
        idle = Allotment(plant, np.zeros((runs, len(plant), 2)), self._tuning.period)
        vectors = idle.share_out(-loads).vectors
        self._allotment = Allotment(plant, vectors, self._tuning.period)
        orders = plant.orders(vectors)
        state[:, BODY : BODY + len(plant)] = orders[..., 0]
        state[:, BODY + len(plant) :] = orders[..., 1]
        self._state, self._water = state, steady[:, 2:]
        rests = loads - plant.wind(state, steady)
        self._controller.begin(self._known(), self._tuning, state[:, :3].copy(), rests)

    def _settle(self) -> None:
        """Take note of who is there now, and who is believed to be."""
        self._there, self._believed = self._crew.there, self._crew.believed
        believed = {name: i for i, name in enumerate(self._believed.swarm.names)}
        there = list(self._there.swarm.names)
        self._asked = np.array([believed[name] for name in there], dtype=np.intp)
        self._of_there = np.array([self._columns[name] for name in there], dtype=np.intp)
        self._of_believed = np.array([self._columns[name] for name in believed], dtype=np.intp)

    def _known(self) -> Known:
        """Return what the controller knows of the object and its robots."""
        return Known(self._believed.swarm, self._believed.matrix, self._wind_loads)

    def _wind_loads(self, headings: Array, air: Array) -> Array:
        """Return the wrenches (runs, 3) of the wind at headings (runs,) [rad]."""
        states, streams = np.zeros((len(air), BODY)), np.zeros((len(air), 4))
        states[:, 2], streams[:, :2] = headings, air
        return self._bare.wind(states, streams)

    def run(self, progress: RunProgress) -> Run:
        """Go on to the end, or until stopped from the keyboard."""
        number = 0
        try:
            while number < self._last:
                number = self._go_on(number)
                if progress is not None:
                    progress(number / self._last)
            self._happen(number)
            self._instant(number, self._streams.block(number, 1)[0], self._noise.block(1)[0])
        except KeyboardInterrupt:
            if not len(self._keeper.numbers):
                raise
        self._give_away()
        return self._answer(self._keeper)

    def _go_on(self, number: int) -> int:
        """Go on from an instant to the next event, or for a block; returns the number then."""
        self._happen(number)
        due = self._schedule.next
        free = self._number(due) - number if due < self._simulation.duration else BLOCK
        count = min(BLOCK, free, self._last - number)
        streams, noise = self._streams.block(number, count), self._noise.block(count)
        self._keep_way(streams[0])
        for k in range(count):
            self._instant(number + k, streams[k], noise[k])
            self._move(number + k, streams[k])
        return number + count

    def _keep_way(self, stream: Array) -> None:
        """Keep the objects' velocities over the ground where the water's have changed at once."""
        change = np.zeros((len(stream), 3))
        change[:, :2] = self._water - stream[:, 2:]
        if change.any():
            self._state[:, 3:BODY] += Headings(self._state[:, 2]).to_object(change)
            self._water = stream[:, 2:]

    def _happen(self, number: int) -> None:
        """Let events happen at an instant."""
        there, believed = self._there, self._believed
        period = self._tuning.period
        self._schedule.pass_to(number * period, (number + SAME) * period)
        if there is not self._crew.there:
            self._state = state_of(there.swarm, self._crew.there, self._state)
        if believed is not self._crew.believed:
            new = self._crew.believed
            vectors = vectors_of(believed.swarm, new.swarm, self._allotment.vectors)
            self._allotment = Allotment(new, vectors, period)
        self._settle()
        if believed is not self._believed:
            self._controller.change(self._known())

    def _instant(self, number: int, stream: Array, noise: Array) -> None:
        """Look at the objects, and decide."""
        time, poses = number * self._tuning.period, self._state[:, :3]
        reference = self._reference.at(time)
        keepers = [k for k in (self._keeper, self._pieces) if k is not None]
        for keeper in keepers:
            keeper.measure(poses, reference.pose)
        look = Look(time, poses + noise, stream[:, :2].copy(), self._allotment.made, reference)
        wanted = _checked(self._controller.wrenches(look), len(poses))
        found = self._allotment.share_out(wanted)
        self._vectors = found.vectors
        keepers = [keeper for keeper in keepers if keeper.keeps(number)]
        if keepers:
            told = self._told(stream, wanted, found.shares, found.shortfalls)
            for keeper in keepers:
                keeper.keep(number, reference.pose, told)
            if self._pieces is not None and self._pieces.is_full:
                self._give_away()

    def _give_away(self) -> None:
        """Give away the piece that is kept, if there is one."""
        piece, sink = self._pieces, self._sink
        if piece is not None and sink is not None and len(piece.numbers):
            self.pour(sink, self._every)
            sink(self._answer(piece))

    def _told(
        self, stream: Array, wanted: Array, shares: Array, shortfalls: Array
    ) -> dict[str, Array]:
        """Return what is to be kept of an instant, by name, a row for each run."""
        state, plant, runs = self._state, self._there, len(self._seeds)
        count = len(plant)
        robots = {
            "forces": (np.zeros((runs, len(self._columns))), self._of_there,
                       state[:, BODY : BODY + count]),
            "angles": (np.full((runs, len(self._columns)), np.nan), self._of_there,
                       state[:, BODY + count :]),
            "shares": (np.zeros((runs, len(self._columns))), self._of_believed, shares),
        }  # fmt: skip
        told = {}
        for name, (rows, columns, values) in robots.items():
            rows[:, columns] = values
            told[name] = rows
        told.update(
            poses=state[:, :3], velocities=state[:, 3:BODY], streams=stream,
            loads=plant.load(state, stream), wanted=wanted, given=plant.given(state),
            shortfalls=shortfalls,
        )  # fmt: skip
        return told

    def _move(self, number: int, stream: Array) -> None:
        """Let a period pass."""
        period, steps = self._tuning.period, self._steps
        asked = self._vectors if self._believed is self._there else self._vectors[:, self._asked]
        orders = self._there.orders(asked)
        self._state = self._there.advance(self._state, orders, stream, None, period / steps, steps)
        self._allotment.follow(self._vectors)
        self._reference.advance(number * period, period)

    def _answer(self, keeper: Keeper) -> Run:
        """Return what became of the runs, at the instants that a keeper has."""
        numbers = keeper.numbers
        times = numbers.astype(float) * self._tuning.period
        return Run(
            simulation=self._simulation,
            seeds=self._seeds,
            times=times,
            names=tuple(self._columns),
            stints=self._schedule.stints(float(times[-1])),
            happenings=tuple(at for at in self._schedule.happenings if at.time <= times[-1]),
            gusts=self._gusts,
            is_whole=bool(numbers[-1] == self._last),
            **keeper.arrays(),
        )


class Noise:
    """What sensors add to poses, drawn from a source of its own for each run.

    Parameters
    ----------
    seeds : sequence of int
    position : float [m]
    heading : float [rad]
        Standard deviations.
    """

    def __init__(self, seeds: Sequence[int], position: float, heading: float) -> None:
        self._sources = [generator_of(seed, SENSORS) for seed in seeds]
        self._sizes = np.array([position, position, heading])

    def block(self, count: int) -> Array:
        """Return the noise (count, runs, 3) [m, m, rad] of the next instants."""
        draws = np.array([source.standard_normal((count, 3)) for source in self._sources])
        return np.ascontiguousarray((draws * self._sizes).swapaxes(0, 1))


def _checked(wanted: Array, runs: int) -> Array:
    """Return what a controller wants, if it is a wrench for each run."""
    found = np.ascontiguousarray(wanted, dtype=float)
    if found.shape == (runs, 3) and np.isfinite(found).all():
        return found
    raise SimulationInvalid(
        f"the controller wants {shown(found)}; it should be finite numbers ({runs}, 3) [N, N, N m]"
    )


def _check_memory(runs: int, last: int, robots: int, every: int) -> None:
    """Raise `SimulationInvalid` if more would be kept than memory should hold."""
    if numbers_kept(runs, last // every + 2, robots) > MOST_NUMBERS:
        least = math.ceil(numbers_kept(runs, last, robots) / MOST_NUMBERS) + 1
        raise SimulationInvalid(
            f"every is {every}: {runs} runs of {last} periods with {robots} robots would keep "
            f"more than {MOST_NUMBERS:.0e} numbers; keep one of {least} periods or more, or run "
            "fewer at once"
        )
