"""A run written by hand: what logs, pictures and exports are tried on."""

import math
from dataclasses import replace

import numpy as np

from swarmgrasp.environment import KNOT
from swarmgrasp.placement import place
from swarmgrasp.scenario import load_example
from swarmgrasp.simulation.events import Lose, Send
from swarmgrasp.simulation.hull import Hull
from swarmgrasp.simulation.run import Happening, Run, Stint
from swarmgrasp.simulation.simulation import Simulation

LOST, NOTICED, SENT, JOINED, END = 60.0, 65.0, 66.0, 180.0, 300.0


def made_run(seeds=(1, 2), instants=151):
    """Return a run of the deck barge that loses Castor, drifts off, and comes back with Fortuna.

    The object drifts along a parabola from the loss to the join and comes back exponentially;
    forces swing about a half of each limit. No law of motion stands behind any of it.
    """
    scenario = load_example("deck-barge")
    wind = replace(scenario.environment.wind, speed=20 * KNOT, bearing=math.radians(60))
    environment = replace(scenario.environment, wind=wind)
    before, problem = scenario.swarm, scenario.problem()
    without = before.without("Castor")
    after = place(without, problem.newcomer, zones=problem.zones).swarm_after
    simulation = Simulation(
        problem,
        environment,
        Hull.afloat(before.outline, environment),
        events=(Lose(LOST, "Castor", NOTICED - LOST), Send(SENT)),
        duration=END,
    )
    stints = (Stint(0.0, LOST, before), Stint(LOST, JOINED, without), Stint(JOINED, END, after))
    names = (*before.names, "Fortuna")
    times = np.linspace(0.0, END, instants)
    return Run(
        simulation=simulation,
        seeds=tuple(seeds),
        times=times,
        names=names,
        stints=stints,
        happenings=happenings(before, without, after),
        gusts=np.full(len(seeds), 0.9),
        is_whole=True,
        **motion(times, len(seeds)),
        **efforts(times, len(seeds), names, stints),
    )


def motion(times, runs):
    """Return where the object is, and what acts on it."""
    drift = np.where(times < LOST, 0.0, np.minimum(times, JOINED) - LOST) / (JOINED - LOST)
    back = np.exp(-np.maximum(times - JOINED, 0.0) / 20.0)
    size = (0.1 * np.sin(times / 7.0) + 8.0 * drift**2 * back)[:, None]
    way = np.array([-0.8, 0.6, math.radians(2.0)])
    poses = np.stack([(1.0 + 0.1 * run) * size * way for run in range(runs)])
    errors = np.hypot(poses[..., 0], poses[..., 1])
    load = np.array([-60e3, 140e3, 2e6]) * (1.0 + 0.1 * np.sin(times / 11.0))[:, None]
    same = {"loads": load, "wanted": -load, "given": -0.95 * load}
    wind = np.array([-5.1, 8.9, -0.26, 0.45]) * (1.0 + 0.1 * np.sin(times / 11.0))[:, None]
    return {
        "references": kept(np.zeros((len(times), 3))),
        "poses": kept(poses),
        "velocities": kept(np.gradient(poses, times, axis=1)),
        "distances": kept(errors),
        "turns": kept(np.abs(poses[..., 2])),
        "streams": kept(np.stack([wind] * runs)),
        "shortfalls": kept(np.stack([17e3 * drift * (drift < 1.0)] * runs)),
        **{name: kept(np.stack([rows] * runs)) for name, rows in same.items()},
    }


def efforts(times, runs, names, stints):
    """Return what the robots do."""
    shares = np.zeros((runs, len(times), len(names)))
    angles, forces = np.full_like(shares, np.nan), np.zeros_like(shares)
    for stint in stints:
        now = (times >= stint.start) & ((times < stint.end) | (stint.end == END))
        for robot in stint.swarm:
            i = names.index(robot.name)
            shares[:, now, i] = 0.5 + 0.3 * np.sin(times[now] / 13.0 + i)
            forces[:, now, i] = robot.limit * shares[:, now, i]
            angles[:, now, i] = robot.direction
    return {"shares": kept(shares), "angles": kept(angles), "forces": kept(forces)}


def happenings(before, without, after):
    """Return what happened, in words."""
    load = np.array([-60e3, 140e3, 2e6])
    told = (
        (0.0, "start", "", "The run starts.", before, 477e3, 210e3, 0.0),
        (LOST, "lost", "Castor", "Castor is lost.", without, 0.0, 0.0, 17e3),
        (NOTICED, "noticed", "Castor", "The others know that Castor is lost.", without, 0.0, 0.0,
         17e3),
        (SENT, "sent", "Fortuna", "Fortuna is sent.", without, 0.0, 0.0, 17e3),
        (JOINED, "joined", "Fortuna", "Fortuna joins.", after, 477e3, 200e3, 0.0),
    )  # fmt: skip
    return tuple(
        Happening(time, kind, robot, words, swarm, load.copy(), quality, margin, shortfall)
        for time, kind, robot, words, swarm, quality, margin, shortfall in told
    )


def kept(numbers):
    """Return numbers as a run keeps them."""
    return np.asarray(numbers, np.float32)
