"""A run as JSON for a page that plays it."""

import json
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.files import write_whole
from swarmgrasp.plain import picked, plain
from swarmgrasp.simulation.export.scene import Film
from swarmgrasp.simulation.run import Run

MOST = 2000
"""Instants that are told, at most."""
FIGURES = 4
"""Digits of a column's numbers, by its largest."""


def player_data(run: Run, *, index: int = 0, most: int = MOST) -> dict[str, Any]:
    """Return one of the runs as plain data, in SI units and radians.

    Parameters
    ----------
    run : Run
    index : int
        Which of the runs.
    most : int
        Instants that are told, at most.

    Returns
    -------
    dict
        `outline` (k, 2) from the origin; `robots`, each with `name`, `contact` (2,), `limit` and
        the times `there` [from, to]; `routes` of those that were sent; `happenings`, each with
        `time`, `kind`, `robot`, `words` and `numbers`, as `Happening` has them; and columns of m
        instants: `times`, `poses` (m, 3), `references` (m, 3), `wind` and `water` (m, 2),
        `shortfalls` (m,), `forces` and `angles` (m, n). Of a robot that is not there the force is 0
        and the angle null.
    """
    film = Film(run, index)
    chosen = list(film.picked(most))
    robots = [
        {
            "name": name,
            "contact": (np.array(film.robots[name].contact) - film.origin).tolist(),
            "limit": film.robots[name].limit,
            "there": [[s.start, s.end] for s in run.stints if name in s.swarm],
        }
        for name in run.names
        if name in film.robots
    ]
    rows = [run.names.index(robot["name"]) for robot in robots]
    outline = run.simulation.problem.swarm.outline.vertices - film.origin
    return {
        "format": "swarmgrasp/run/1",
        "seed": run.seeds[index],
        "outline": outline.tolist(),
        "robots": robots,
        "routes": [
            {
                "robot": route.robot,
                "start": route.start,
                "arrival": route.arrival,
                "joined": route.joined,
                "points": short(route.points),
            }
            for route in film.routes
        ],
        "happenings": [
            {**picked(h, "time", "kind", "robot", "words"), "numbers": dict(h.numbers)}
            for h in run.happenings
        ],
        "times": run.times[chosen].tolist(),
        "poses": short(run.poses[index, chosen]),
        "references": short(run.references[chosen]),
        "wind": short(run.streams[index, chosen, :2]),
        "water": short(run.streams[index, chosen, 2:]),
        "shortfalls": short(run.shortfalls[index, chosen]),
        "forces": short(run.forces[index][np.ix_(chosen, rows)]),
        "angles": short(run.angles[index][np.ix_(chosen, rows)]),
    }


def write_player(run: Run, path: str | Path, *, index: int = 0) -> Path:
    """Write one of the runs as JSON for a page, whole or not at all.

    Parameters
    ----------
    run : Run
    path : str or Path
    index : int
        Which of the runs.

    Returns
    -------
    Path
    """
    text = json.dumps(player_data(run, index=index), separators=(",", ":"), allow_nan=False)
    write_whole(path, text.encode())
    return Path(path)


def short(values: NDArray[np.floating[Any]]) -> Any:
    """Return numbers as lists, with digits that suit the largest of each column.

    Examples
    --------
    >>> short(np.array([[123456.0, 0.123456], [1.0, np.nan]]))
    [[123460.0, 0.12346], [0.0, None]]
    """
    exact = np.asarray(values, float)
    most = np.nanmax(np.abs(np.nan_to_num(exact)), axis=0, initial=0.0)
    step = 10.0 ** (np.floor(np.log10(np.maximum(most, 1e-9))) - FIGURES)
    rounded = np.round(exact / step) * step
    tidy = np.array([float(f"{v:.12g}") for v in rounded.ravel()]).reshape(exact.shape)
    return plain(tidy)
