"""The loads of a wind as somebody measured or computed them: a table by speed and bearing."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.environment.geometry import folded_of, midship_of, numbers_in
from swarmgrasp.environment.limits import BEARING, OFFSET, SPEED
from swarmgrasp.errors import EnvironmentInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.outline.outline import check_outline
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import STRONGEST, array_of, items, numbers, shown

SAME_BEARING = 1e-9
"""Difference of two bearings [rad] that is none."""
WIDEST_GAP = 0.5 * math.pi + SAME_BEARING
"""Between two bearings of a table, at most [rad]."""
ROUNDED = 0.005
"""By how much a bearing ahead or astern may be rounded [rad]: 3.14 is one."""
ONE_SIDE = np.array([1.0, -1.0, -1.0])
"""What surge, sway and yaw are times on the other side."""
Array = NDArray[np.float64]


@dataclass(frozen=True)
class WindTable(Plain):
    """The loads of winds by speed and bearing, and perhaps a wind.

    Between bearings loads are interpolated linearly. A table that ends at ahead and astern is of
    one side: from the other, sway and yaw change sign. Over speeds they are interpolated linearly
    in the square of the speed, from nothing in calm air; beyond the last, they grow with the
    square. Of one speed they are thus scaled with the square of the speed.

    Attributes
    ----------
    speeds : tuple of float [m/s]
        Rising, above 0.
    bearings : tuple of float [rad]
        Where the wind comes from, clockwise from the bow, rising within [0, 2 pi), at most a right
        angle apart.
    loads : tuple of tuple of (float, float, float) [N, N, N m]
        For each speed and each bearing: surge (forward), sway (to port) and yaw
        (counter-clockwise).
    about : tuple of float [m, m], optional
        The point that yaw moments are about, in the frame of the outline's vertices; midship, the
        middle of the outline's extent, when left out.
    speed : float [m/s], optional
        Of a steady wind; goes with `bearing`.
    bearing : float [rad], optional
        Where that wind comes from, clockwise from the bow.

    Raises
    ------
    EnvironmentInvalid
        If a number is outside its range, or the table is no table; all faults at once.

    Examples
    --------
    A beam wind from starboard at half the speed of the table, one from half-way to ahead, and one
    from port:

    >>> rows = [(20.0, 0.0, -9e3, 0, 0), (20.0, math.pi / 2, 0, 4e4, 0), (20.0, math.pi, 9e3, 0, 0)]
    >>> table = WindTable.from_rows(rows)
    >>> barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
    >>> table.load(barge, [math.pi / 2, math.pi / 4, -math.pi / 2], 10.0).tolist()
    [[0.0, 10000.0, 0.0], [-1125.0, 5000.0, 0.0], [0.0, -10000.0, 0.0]]
    """

    speeds: Sequence[float]
    bearings: Sequence[float]
    loads: tuple[tuple[tuple[float, float, float], ...], ...]
    about: tuple[float, float] | None = None
    speed: float | None = None
    bearing: float | None = None

    def __post_init__(self) -> None:
        """Check the values."""
        speeds, bearings, loads = numbers(self.speeds), numbers(self.bearings), array_of(self.loads)
        faults = _rising_faults("speeds", self.speeds, speeds, SPEED.high, "m/s")
        if speeds and not speeds[0] > 0.0:
            faults.append(f"the first speed is {speeds[0]:g}; it should be above 0 [m/s]")
        faults += _rising_faults("bearings", self.bearings, bearings, math.tau, "rad")
        faults += _gap_faults(bearings)
        shape = (len(speeds), len(bearings), 3)
        if loads is None or loads.shape != shape or not (np.abs(loads) <= STRONGEST).all():
            faults.append(
                f"the loads are {shown(self.loads)}; they should be {shape[0]} by {shape[1]} by 3 "
                "numbers [N, N, N m]"
            )
        elif bearings:
            idle = np.flatnonzero((loads == 0.0).all(axis=(0, 2)))
            faults += [
                f"no wind from {math.degrees(bearings[k]):g} deg exerts anything; a load there "
                "should not be 0, 0, 0"
                for k in idle.tolist()
            ]
        about = numbers(self.about) if self.about is not None else ()
        if self.about is not None and len(about) != 2:
            faults.append(f"the point about is {shown(self.about)}; it should be two numbers [m]")
        faults += [fault for value in about for fault in OFFSET.faults("point about", value)]
        if (self.speed is None) != (self.bearing is None):
            faults.append("the speed and the bearing of a wind go together; give both or neither")
        faults += [] if self.speed is None else SPEED.faults("speed", self.speed)
        faults += [] if self.bearing is None else BEARING.faults("bearing", self.bearing)
        if faults or loads is None:
            raise EnvironmentInvalid(f"wind: {fault}" for fault in faults)
        vars(self).update(
            speeds=speeds,
            bearings=bearings,
            loads=tuple(tuple(map(_triple, part)) for part in loads.tolist()),
            about=about or None,
            speed=None if self.speed is None else float(self.speed),
            bearing=None if self.bearing is None else float(self.bearing),
        )

    @classmethod
    def from_rows(
        cls,
        rows: ArrayLike,
        *,
        about: tuple[float, float] | None = None,
        speed: float | None = None,
        bearing: float | None = None,
    ) -> "WindTable":
        """Make a table from its rows, in any order.

        Parameters
        ----------
        rows : (m, 5) [m/s, rad, N, N, N m]
            Speed and bearing of a wind, and what it exerts: as for the class, bearings of any turn.
            Every speed has the same bearings. Those next to ahead or astern, as 3.14 and 6.283,
            are rounded ones of these.
        about, speed, bearing
            As for the class.

        Raises
        ------
        EnvironmentInvalid
            As for the class, or if a wind is missing, or stands twice with other loads, or if the
            bearings look like those in another unit.
        """
        found = array_of(rows)
        if found is None or found.ndim != 2 or found.shape[1] != 5 or not np.isfinite(found).all():
            raise EnvironmentInvalid(
                f"wind: the rows are {shown(rows)}; they should be (m, 5) finite numbers: speed "
                "[m/s], bearing [rad], surge, sway [N] and yaw [N m]"
            )
        _check_unit(float(np.abs(found[:, 1]).max(initial=0.0)))
        halves = np.round(found[:, 1] / math.pi)
        is_near = np.abs(found[:, 1] - halves * math.pi) <= ROUNDED
        turns = np.where(is_near, halves % 2.0 * math.pi, np.remainder(found[:, 1], math.tau))
        rounded = np.round(turns / SAME_BEARING)
        speeds, at = np.unique(found[:, 0], return_inverse=True)
        _, first, along = np.unique(rounded, return_index=True, return_inverse=True)
        loads = np.full((len(speeds), len(first), 3), np.nan)
        faults = []
        for i, k, row in zip(at.ravel(), along.ravel(), found, strict=True):
            if not np.isnan(loads[i, k, 0]) and not np.array_equal(loads[i, k], row[2:]):
                faults.append(f"{_wind_words(row[0], row[1])} stands twice, with other loads")
            loads[i, k] = row[2:]
        faults += [
            f"{_wind_words(speeds[i], turns[first[k]])} is missing: every speed should have the "
            "same bearings"
            for i, k in np.argwhere(np.isnan(loads[..., 0]))
        ]
        if faults:
            raise EnvironmentInvalid(f"wind: {fault}" for fault in faults)
        told = tuple(tuple(map(_triple, part)) for part in loads.tolist())
        return cls(
            tuple(speeds.tolist()), tuple(turns[first].tolist()), told, about, speed, bearing
        )

    @property
    def is_of_one_side(self) -> bool:
        """Whether it ends at ahead and astern, and stands for both sides."""
        return _is_of_one_side(self.bearings)

    @property
    def grows_with_square(self) -> bool:
        """Whether loads grow with the square of the speed throughout."""
        return len(self.speeds) == 1

    @cached_property
    def _around(self) -> tuple[Array, Array]:
        """Bearings (m,) from below 0 to past a turn, and loads (k, m, 3) there."""
        bearings, loads = np.array(self.bearings), np.array(self.loads)
        if self.is_of_one_side:
            inner = slice(-2, 0, -1)
            bearings = np.concatenate([bearings, math.tau - bearings[inner]])
            loads = np.concatenate([loads, ONE_SIDE * loads[:, inner]], axis=1)
        bearings = np.concatenate([bearings[-1:] - math.tau, bearings, bearings[:1] + math.tau])
        return bearings, np.concatenate([loads[:, -1:], loads, loads[:, :1]], axis=1)

    def load(self, outline: Outline, bearings: ArrayLike, speeds: ArrayLike) -> Array:
        """Interpolate the wrench that a wind exerts on the object.

        Parameters
        ----------
        outline : Outline
            Gives midship, and the origin that moments are taken about.
        bearings : (...) [rad]
            Where the wind comes from, clockwise from the bow.
        speeds : (...) [m/s]

        Returns
        -------
        (..., 3) [N, N, N m]
        """
        check_outline(outline)
        turned, fast = np.broadcast_arrays(
            np.remainder(folded_of(bearings)[0], math.tau), numbers_in(speeds, "speeds", SPEED)
        )
        known, loads = self._around
        after = np.clip(np.searchsorted(known, turned, side="right"), 1, len(known) - 1)
        share = ((turned - known[after - 1]) / (known[after] - known[after - 1]))[..., None]
        at = loads[:, after - 1] + share * (loads[:, after] - loads[:, after - 1])
        squares = np.concatenate([[0.0], np.square(self.speeds)])
        grid = np.concatenate([np.zeros_like(at[:1]), at])
        square = np.asarray(fast**2)
        above = np.clip(np.searchsorted(squares, square), 1, len(squares) - 1)
        part = (square - squares[above - 1]) / (squares[above] - squares[above - 1])
        high, low = (
            np.take_along_axis(grid, index[None, ..., None], axis=0)[0]
            for index in (above, above - 1)
        )
        wrench = np.where(
            (square > squares[-1])[..., None],
            at[-1] * (square / squares[-1])[..., None],
            low + part[..., None] * (high - low),
        )
        x, y = (
            midship_of(outline) if self.about is None else np.array(self.about)
        ) - outline.origin
        wrench[..., 2] += x * wrench[..., 1] - y * wrench[..., 0]
        return np.asarray(wrench)


def _triple(row: list[float]) -> tuple[float, float, float]:
    """Return the numbers of a row."""
    surge, sway, yaw = row
    return surge, sway, yaw


def _is_of_one_side(bearings: Sequence[float]) -> bool:
    """Tell whether bearings run from ahead to astern."""
    return len(bearings) > 1 and bearings[0] == 0.0 and abs(bearings[-1] - math.pi) <= SAME_BEARING


def _rising_faults(
    name: str, given: object, found: tuple[float, ...], most: float, unit: str
) -> list[str]:
    """Return what is wrong with numbers that should rise, below the most."""
    if not found or len(found) != len(items(given) or ()):
        return [f"the {name} are {shown(given)}; they should be one or more numbers [{unit}]"]
    if any(b <= a for a, b in pairwise(found)) or found[-1] >= most or found[0] < 0.0:
        return [
            f"the {name} are {shown(given)}; they should rise, from 0 or more to less than "
            f"{most:.6g} [{unit}]"
        ]
    return []


def _check_unit(farthest: float) -> None:
    """Raise if the bearings of a table, the farthest from 0 given [rad], are in another unit."""
    degrees = math.degrees(farthest)
    if 1.0 < degrees <= math.tau + ROUNDED:
        raise EnvironmentInvalid(
            f"wind: all bearings are within {degrees:.4g} deg; they look like radians that are "
            "read as degrees"
        )
    if farthest > 2.0 * math.tau + ROUNDED:
        raise EnvironmentInvalid(
            f"wind: bearings run to {farthest:.6g} rad; they look like degrees that are read as "
            "radians"
        )


def _gap_faults(bearings: tuple[float, ...]) -> list[str]:
    """Return what is wrong with bearings that leave gaps around the object."""
    if not bearings:
        return []
    around = bearings if _is_of_one_side(bearings) else (*bearings, bearings[0] + math.tau)
    return [
        f"the bearings leave a gap from {math.degrees(a):.4g} to {math.degrees(b) % 360.0:.4g} deg"
        "; it should be at most 90 deg, and those of one side run from 0 to 180 deg"
        for a, b in pairwise(around)
        if b - a > WIDEST_GAP
    ]


def _wind_words(speed: float, bearing: float) -> str:
    """Name a wind of a table."""
    return f"the wind of {speed:.6g} m/s from {math.degrees(bearing) % 360.0:.4g} deg"
