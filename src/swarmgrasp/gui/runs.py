"""A recorded run, for the page to play: from the player's JSON, or from a log in Parquet."""

import math
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import msgspec
import numpy as np
from msgspec import Struct
from numpy.typing import NDArray

from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.files import read_fault
from swarmgrasp.gui.figures import Figures, figure
from swarmgrasp.gui.messages import Pair, Triple
from swarmgrasp.gui.replies import First, RunHappening, RunRobot, RunRoute, RunTold
from swarmgrasp.gui.sending import framed
from swarmgrasp.outline import Outline
from swarmgrasp.simulation.export.player import player_data
from swarmgrasp.simulation.record import read_log
from swarmgrasp.simulation.sentences import sentence
from swarmgrasp.simulation.verdict import USUAL_TURN, usual_within
from swarmgrasp.telling import Telling
from swarmgrasp.terms import SI, Terms

LARGEST = 64_000_000
"""Bytes of a run in JSON."""
MOST = 20_000
"""Instants that are played, at most."""
Row = tuple[float | None, ...]
Column = NDArray[np.float32]


class PlayedRobot(Struct, frozen=True, forbid_unknown_fields=True):
    """A robot of a run: see `RunRobot`."""

    name: str
    contact: Pair
    limit: float
    there: tuple[Pair, ...]


class PlayedHappening(Struct, frozen=True, forbid_unknown_fields=True):
    """Something that happened, in words, or in numbers that make them: see `Happening`."""

    time: float
    kind: str
    robot: str
    words: str
    numbers: dict[str, float] = {}

    def told(self, tell: Telling) -> RunHappening:
        """Return it in the terms of a scene."""
        numbers = self.numbers
        words = sentence(self.kind, self.robot, numbers, tell) if numbers else self.words
        return RunHappening(self.time, self.kind, self.robot, words)


class Played(Struct, frozen=True, forbid_unknown_fields=True):
    """What `swarmgrasp simulate --player` writes."""

    format: str
    seed: int
    outline: tuple[Pair, ...]
    robots: tuple[PlayedRobot, ...]
    routes: tuple[RunRoute, ...]
    happenings: tuple[PlayedHappening, ...]
    times: tuple[float, ...]
    poses: tuple[Triple, ...]
    references: tuple[Triple, ...]
    wind: tuple[Pair, ...]
    water: tuple[Pair, ...]
    shortfalls: tuple[float, ...]
    forces: tuple[Row, ...]
    angles: tuple[Row, ...]


@dataclass(frozen=True)
class Recorded:
    """A run by the name of its file."""

    name: str
    played: Played

    def told(self, n: int, terms: Terms) -> bytes:
        """Return the run as one binary frame, with its verdict in the terms of a scene."""
        played, columns = self.played, self._columns()
        outline = Outline(played.outline)
        within, tell = usual_within(outline), Telling.of(terms, outline.extent, [])
        first, second = _verdict(columns, within, terms)
        angles = columns["angles"]
        sent = {route.robot for route in played.routes}
        robots = tuple(
            RunRobot(
                robot.name, robot.contact, _way(angles[:, i]), robot.limit,
                robot.name in sent, robot.there,
            )
            for i, robot in enumerate(played.robots)
        )  # fmt: skip
        head = RunTold(
            n, self.name, first, second, played.seed, within, USUAL_TURN, played.outline, robots,
            played.routes, tuple(each.told(tell) for each in played.happenings), (),
        )  # fmt: skip
        return framed(head, columns)

    def _columns(self) -> dict[str, Column]:
        """Return the columns as arrays."""
        count = len(self.played.robots)
        shapes: dict[str, tuple[int, ...]] = {
            "times": (-1,), "poses": (-1, 3), "references": (-1, 3), "wind": (-1, 2),
            "water": (-1, 2), "shortfalls": (-1,), "forces": (-1, count), "angles": (-1, count),
        }  # fmt: skip
        return {
            name: np.array(getattr(self.played, name), dtype=np.float32).reshape(shape)
            for name, shape in shapes.items()
        }


def _way(angles: Column) -> float:
    """Return where a robot points first."""
    there = angles[~np.isnan(angles)]
    return float(there[0]) if len(there) else 0.0


def _verdict(columns: dict[str, Column], within: float, terms: Terms) -> tuple[First, str]:
    """Say whether the object was held, and how far it was off at most."""
    off = columns["poses"].astype(float) - columns["references"]
    far = float(np.hypot(off[:, 0], off[:, 1]).max(initial=0.0))
    turns = np.abs((off[:, 2] + np.pi) % (2.0 * np.pi) - np.pi)
    turn, figures = float(turns.max(initial=0.0)), Figures(terms)
    seconds = figure(float(columns["times"][-1]))
    worst = f"turned by {figure(math.degrees(turn))}\u00b0 at most, in {seconds}\u00a0s"
    if far <= within and turn <= USUAL_TURN:
        return First(f"Held within {figures.lengths(within)}", True), (
            f"off by {figures.lengths(far)} and {worst}"
        )
    return First(f"Off by {figures.lengths(far)}", False), worst


def read_run(path: Path) -> Recorded:
    """Read a run.

    Parameters
    ----------
    path : Path
        Ending in .parquet, a log; or a .json file of the player.

    Raises
    ------
    SimulationInvalid
        If it cannot be read, or is none.
    PackageMissing
        Without pyarrow, for a log.
    """
    if path.suffix.lower() == ".parquet":
        run = read_log(path)
        return Recorded(
            path.name, msgspec.convert(player_data(run, most=MOST), Played, strict=True)
        )
    try:
        with path.open("rb") as file:
            raw = file.read(LARGEST + 1)
    except OSError as error:
        raise SimulationInvalid(read_fault(path, error)) from None
    if len(raw) > LARGEST:
        raise SimulationInvalid(f"{path}: is too large; it should have at most {LARGEST} bytes")
    return Recorded(path.name, _played(path, lambda: msgspec.json.decode(raw, type=Played)))


def _played(path: Path, read: Callable[[], Played]) -> Played:
    """Return what a reader gives, if it is a run whose columns go together."""
    try:
        played = read()
        for happening in played.happenings:
            happening.told(Telling.of(SI, 1.0, []))
    except (msgspec.DecodeError, KeyError, RecursionError) as error:
        raise SimulationInvalid(
            f"{path}: is no run, as `swarmgrasp simulate --player` writes it: {error}"
        ) from None
    columns = (
        played.poses, played.references, played.wind, played.water, played.shortfalls,
        played.forces, played.angles,
    )  # fmt: skip
    width = len(played.robots)
    if any(len(column) != len(played.times) for column in columns) or any(
        len(row) != width for row in (*played.forces, *played.angles)
    ):
        raise SimulationInvalid(f"{path}: its columns have not the same number of instants")
    return played
