"""A swarm: the object, the robots holding it, and the metric that makes wrenches comparable."""

import math
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property
from typing import Any, TypeVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import MetricInvalid, OutlineInvalid, RobotInvalid
from swarmgrasp.outline import Outline
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import STRONGEST, WEAKEST, numbers
from swarmgrasp.swarm.columns import (
    NAMELESS,
    Columns,
    Names,
    check_contacts,
    checked_columns,
    columns_of,
    robot_label,
)
from swarmgrasp.swarm.robot import Robot
from swarmgrasp.swarm.rounding import generator_errors
from swarmgrasp.swarm.tolerance import Tolerance

Column = TypeVar("Column", NDArray[np.float64], NDArray[np.bool_])
Tolerances = Mapping[int, Tolerance]
"""The tolerances of those robots that have one, by index."""


@dataclass(frozen=True, eq=False)
class Swarm(Plain):
    """Robots in contact with an object.

    Kept as read-only arrays, so that there may be a million of them: see `from_arrays`.

    Parameters
    ----------
    outline : Outline
    robots : iterable of Robot
        Mounted robots lie anywhere inside the outline, all others on its boundary.
    characteristic_length : float [m], optional
        Turns torque into force in the metric, a3 = 1 / L^2; by default the largest
        distance from the outline's origin to the outline.
    force_weights : tuple of float
        The metric's a1 and a2, for surge and sway.

    Raises
    ------
    MetricInvalid
        If a weight or the length is not positive and finite.
    RobotInvalid
        If something is no `Robot`.
    RobotOffBoundary
        If robots are off the boundary, or mounted ones outside; the first ten are named,
        each with its distance and the nearest boundary point.

    Examples
    --------
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> swarm = Swarm(square, [Robot((1, 0.5), direction=0.0, limit=2.0)])
    >>> swarm.generators.tolist()
    [[2.0, 0.0, -1.0]]
    """

    outline: Outline
    contacts: NDArray[np.float64]
    """(n, 2) [m, m]: where the robots hold the object, in the frame of the vertices."""
    directions: NDArray[np.float64]
    """(n,) [rad]: of their forces on the object, counter-clockwise from +x."""
    limits: NDArray[np.float64]
    """(n,) [N]: the largest forces they can exert."""
    mounted: NDArray[np.bool_] = field(repr=False)
    """(n,): which are a vessel's own thrusters."""
    generators: NDArray[np.float64] = field(repr=False)
    """(n, 3) [N, N, N m]: the wrench of each robot at its limit, about the origin."""
    characteristic_length: float
    force_weights: tuple[float, float]
    tolerances: Tolerances = field(repr=False)
    """Of those robots that have one, by index."""
    _names: Names = field(repr=False)

    def __init__(
        self,
        outline: Outline,
        robots: Iterable[Robot],
        characteristic_length: float | None = None,
        force_weights: tuple[float, float] = (1.0, 1.0),
    ) -> None:
        robots = tuple(robots)
        columns = columns_of(robots)
        names = {i: robot.name for i, robot in enumerate(robots) if robot.name}
        tolerances = {i: robot.tolerance for i, robot in enumerate(robots) if robot.tolerance}
        self._fill(outline, columns, names, tolerances, characteristic_length, force_weights)
        vars(self)["robots"] = robots

    @classmethod
    def from_arrays(
        cls,
        outline: Outline,
        contacts: ArrayLike,
        directions: ArrayLike,
        limits: ArrayLike = 1.0,
        *,
        characteristic_length: float | None = None,
        force_weights: tuple[float, float] = (1.0, 1.0),
        mounted: ArrayLike = False,
    ) -> "Swarm":
        """Make a swarm of nameless robots from arrays, which are copied.

        Parameters
        ----------
        outline : Outline
        contacts : (n, 2) [m, m]
            Where the robots hold the object, in the frame of the outline's vertices.
        directions : (n,) [rad]
            Directions of their forces on the object, counter-clockwise from +x.
        limits : float or (n,) [N]
            The largest forces they can exert.
        characteristic_length : float [m], optional
        force_weights : tuple of float
            The metric, as for any `Swarm`.
        mounted : bool or (n,)
            Which are a vessel's own thrusters, anywhere inside the outline.

        Raises
        ------
        RobotInvalid
            If an array has the wrong shape or type, or values are outside their range; the
            first ten robots at fault are described, the others counted.
        MetricInvalid, RobotOffBoundary
            As for any `Swarm`.

        Examples
        --------
        >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        >>> swarm = Swarm.from_arrays(square, [(1, 0.5), (0, -1)], [0.0, 0.0], limits=2.0)
        >>> swarm.generators.tolist()
        [[2.0, 0.0, -1.0], [2.0, 0.0, 2.0]]
        >>> swarm.robots[1]
        Robot(contact=(0.0, -1.0), direction=0.0, limit=2.0, name='', mounted=False, tolerance=None)
        """
        columns = checked_columns(contacts, directions, limits, mounted)
        swarm = cls.__new__(cls)
        swarm._fill(outline, columns, NAMELESS, {}, characteristic_length, force_weights)
        return swarm

    def _fill(
        self,
        outline: Outline,
        columns: Columns,
        names: Names,
        tolerances: Tolerances,
        length: float | None,
        force_weights: tuple[float, float],
    ) -> None:
        """Check what only the outline and the metric can tell, and keep everything."""
        if not isinstance(outline, Outline):
            raise OutlineInvalid(f"{outline!r} is no outline: make one with Outline(vertices)")
        length = outline.radius if length is None else length
        check_metric(length, force_weights)
        check_contacts(outline, columns, names)
        check_tolerances(outline, tolerances, names)
        generators = wrenches(columns.contacts - outline.origin, columns.directions, columns.limits)
        vars(self).update(
            {name: _read_only(column) for name, column in columns._asdict().items()},
            outline=outline,
            generators=_read_only(generators),
            characteristic_length=float(length),
            force_weights=tuple(map(float, force_weights)),
            tolerances=tolerances,
            _names=names,
        )

    def __setstate__(self, state: dict[str, Any]) -> None:
        """Come back from a copy or a pickle, read-only again."""
        vars(self).update(state)
        for value in state.values():
            if isinstance(value, np.ndarray):
                _read_only(value)

    def __len__(self) -> int:
        """Return the number of robots."""
        return len(self.directions)

    @cached_property
    def robots(self) -> tuple[Robot, ...]:
        """The robots one by one; those of a swarm made from arrays are made when asked for."""
        columns = (self.contacts, self.directions, self.limits, self.mounted)
        rows = zip(*(column.tolist() for column in columns), strict=True)
        return tuple(
            Robot((x, y), direction, limit, self._names.get(i, ""), mounted, self.tolerances.get(i))
            for i, ((x, y), direction, limit, mounted) in enumerate(rows)
        )

    @cached_property
    def scale(self) -> NDArray[np.float64]:
        """(3,) [1, 1, 1/m]: A^(1/2), which makes the metric Euclidean."""
        a1, a2 = self.force_weights
        return _read_only(
            np.array([math.sqrt(a1), math.sqrt(a2), 1.0 / self.characteristic_length])
        )

    @cached_property
    def scaled_generators(self) -> NDArray[np.float64]:
        """(n, 3) [N, N, N]: the generators in the metric's coordinates."""
        return _read_only(self.generators * self.scale)

    @cached_property
    def errors(self) -> NDArray[np.float64]:
        """(n,) [N]: by how much the scaled generators may be off, by the outline's `precision`."""
        columns = Columns(self.contacts, self.directions, self.limits, self.mounted)
        return _read_only(generator_errors(self.outline, columns, self.scale))

    @cached_property
    def noise(self) -> float:
        """By how much a quality may be off [N], by the outline's `precision` (T4)."""
        return float(self.errors.sum())

    @property
    def metric_sentence(self) -> str:
        """The metric in words, for every output."""
        a1, a2 = self.force_weights
        return (
            f"force weights {a1:g} and {a2:g}, characteristic length "
            f"{self.characteristic_length:.6g} m"
        )

    def robot_label(self, index: int) -> str:
        """Return the name of a robot, or "robot i" for a nameless one."""
        return robot_label(range(len(self))[index], self._names)

    def with_robot(self, robot: Robot) -> "Swarm":
        """Return the swarm with one robot more.

        Examples
        --------
        >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        >>> len(Swarm(square, []).with_robot(Robot((1, 0), direction=3.14)))
        1
        """
        outline, count, one = self.outline, len(self), columns_of((robot,))
        names = {**self._names, count: robot.name} if robot.name else self._names
        tolerances = self.tolerances
        if robot.tolerance:
            tolerances = {**tolerances, count: robot.tolerance}
            check_tolerances(outline, {count: robot.tolerance}, names)
        check_contacts(outline, one, names, first=count)
        rows = one._asdict()
        rows["generators"] = wrenches(one.contacts - outline.origin, one.directions, one.limits)
        swarm = Swarm.__new__(Swarm)
        vars(swarm).update(
            {name: _joined(getattr(self, name), row) for name, row in rows.items()},
            outline=outline,
            characteristic_length=self.characteristic_length,
            force_weights=self.force_weights,
            scale=self.scale,
            tolerances=tolerances,
            _names=names,
        )
        if "robots" in vars(self):
            vars(swarm)["robots"] = (*self.robots, robot)
        return swarm

    def without(self, robots: Iterable[int]) -> "Swarm":
        """Return the swarm without some robots, given by index.

        Raises
        ------
        RobotInvalid
            If an index is none of a robot.

        Examples
        --------
        >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        >>> pair = Swarm(square, [Robot((1, 0), 0.0, name="Ajax"), Robot((0, 1), 0.0)])
        >>> [robot.name for robot in pair.without([1]).robots]
        ['Ajax']
        """
        gone = set(robots)
        count = len(self)
        strange = [i for i in gone if not (isinstance(i, int | np.integer) and 0 <= i < count)]
        if strange:
            raise RobotInvalid(
                f"{i!r} is no index of a robot; it should be 0 <= index < {count}" for i in strange
            )
        kept = [i for i in range(count) if i not in gone]
        columns = ("contacts", "directions", "limits", "mounted", "generators")
        swarm = Swarm.__new__(Swarm)
        vars(swarm).update(
            {name: _read_only(getattr(self, name)[kept]) for name in columns},
            outline=self.outline,
            characteristic_length=self.characteristic_length,
            force_weights=self.force_weights,
            scale=self.scale,
            tolerances={k: self.tolerances[i] for k, i in enumerate(kept) if i in self.tolerances},
            _names={k: self._names[i] for k, i in enumerate(kept) if i in self._names},
        )
        return swarm

    def with_tolerance(self, tolerance: Tolerance) -> "Swarm":
        """Return the swarm with one tolerance for every robot; a mounted one keeps its contact.

        Raises
        ------
        RobotInvalid
            If it is no tolerance, or does not go with a robot's limit or with the boundary.
        """
        return Swarm(
            self.outline,
            [
                replace(
                    robot,
                    tolerance=replace(tolerance, contact=0.0) if robot.mounted else tolerance,
                )
                for robot in self.robots
            ],
            self.characteristic_length,
            self.force_weights,
        )


def wrenches(
    arms: NDArray[np.float64], directions: NDArray[np.float64], forces: NDArray[np.float64] | float
) -> NDArray[np.float64]:
    """Compute the wrenches of forces at moment arms: (F, c x F), the paper's B_i corrected.

    Parameters
    ----------
    arms : (..., 2) [m, m]
    directions : (...) [rad]
    forces : float or (...) [N]

    Returns
    -------
    (..., 3) [N, N, N m]

    Examples
    --------
    >>> wrenches(np.array([[1.0, 0.5]]), np.array([0.0]), np.array([2.0])).tolist()
    [[2.0, 0.0, -1.0]]
    """
    fx, fy = forces * np.cos(directions), forces * np.sin(directions)
    torques = arms[..., 0] * fy - arms[..., 1] * fx
    found = np.empty((*torques.shape, 3))
    found[..., 0], found[..., 1], found[..., 2] = fx, fy, torques
    return found


def check_swarm(swarm: object) -> None:
    """Raise `RobotInvalid` unless something is a swarm."""
    if not isinstance(swarm, Swarm):
        kind = type(swarm).__name__
        raise RobotInvalid(f"{kind} is no Swarm: make one with Swarm(outline, robots)")


def check_tolerances(outline: Outline, tolerances: Tolerances, names: Names) -> None:
    """Raise `RobotInvalid` where a contact may be anywhere more than once around the boundary."""
    faults = [
        f"{robot_label(i, names)}: its contact may lie on {last - first:.6g} m of the boundary; "
        f"that should be at most the perimeter, {outline.perimeter:.6g} m"
        for i, (first, last) in ((i, found.offsets) for i, found in tolerances.items())
        if last - first > outline.perimeter
    ]
    if faults:
        raise RobotInvalid(faults)


def check_metric(length: float, force_weights: tuple[float, float]) -> None:
    """Raise `MetricInvalid` unless all three numbers are positive and in range."""
    named = [("characteristic length", length, "m")]
    faults = []
    try:
        a1, a2 = force_weights
    except (TypeError, ValueError):
        faults.append(f"the force weights are {force_weights!r}; they should be two numbers")
    else:
        named += [("force weight a1", a1, "1"), ("force weight a2", a2, "1")]
    faults += [
        f"the {name} is {value!r}; it should be {WEAKEST:g} <= value <= {STRONGEST:g} [{unit}]"
        for name, value, unit in named
        if not any(WEAKEST <= number <= STRONGEST for number in numbers((value,)))
    ]
    if faults:
        raise MetricInvalid(faults)


def _joined(rows: Column, more: Column) -> Column:
    """Return the rows of both arrays."""
    return _read_only(np.concatenate([rows, more]))


def _read_only(array: Column) -> Column:
    """Return an array, now read-only."""
    array.setflags(write=False)
    return array
