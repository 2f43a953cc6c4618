"""A swarm: the object, the robots holding it, and the metric that makes wrenches comparable."""

import math
from collections.abc import Iterable, Iterator, Mapping, Sequence, Set
from dataclasses import dataclass, field, replace
from functools import cached_property
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import (
    ForceSetUnsupported,
    MetricInvalid,
    RobotInvalid,
    SwarmInvalid,
    refuse,
)
from swarmgrasp.frozen import Frozen, read_only
from swarmgrasp.outline import Outline
from swarmgrasp.outline.outline import check_outline
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import (
    STRONGEST,
    WEAKEST,
    items,
    kind_faults,
    length_faults,
    number,
    numbers,
    shown,
)
from swarmgrasp.swarm.columns import (
    FAR,
    MOST_LISTED,
    Columns,
    Couple,
    check_contacts,
    checked_columns,
    checked_tolerances,
    columns_of,
    couple_of,
    robot_of,
    snapped,
)
from swarmgrasp.swarm.force_set import (
    ForceSets,
    force_sets_of,
    least_along,
    lines_among,
    rays_among,
)
from swarmgrasp.swarm.matrix import Axes, checked_allocation, robots_from, square_around
from swarmgrasp.swarm.names import Names, checked_names, names_of, numbered
from swarmgrasp.swarm.rare import Rare
from swarmgrasp.swarm.robot import Robot
from swarmgrasp.swarm.rounding import generator_errors
from swarmgrasp.swarm.sectors import Sector
from swarmgrasp.swarm.tolerance import Tolerance
from swarmgrasp.visible import Visible


@dataclass(frozen=True, eq=False)
class Swarm(Frozen, Plain, Visible):
    """Robots in contact with an object, each known by its name.

    Kept as read-only arrays, so that there may be a million of them: see `from_arrays`. A robot
    without a name is called R and the first number that nobody has: R1, R2 and so on. Going through
    a swarm yields its robots, and ``swarm["Ajax"]`` is the robot of that name.

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
        If something is no `Robot`, or two have one name.
    RobotOffBoundary
        If robots are off the boundary, or mounted ones outside; the first ten are named,
        each with its distance and the nearest boundary point.

    Examples
    --------
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> swarm = Swarm(square, [Robot((1, 0.5), direction=0.0, limit=2.0)])
    >>> swarm.generators.tolist()
    [[2.0, 0.0, -1.0]]
    >>> swarm = swarm.with_robot(Robot((-1, 0), 3.14, name="Ajax")).without("R1")
    >>> [robot.name for robot in swarm], "R1" in swarm, swarm["Ajax"].limit
    (['Ajax'], False, 1.0)
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
    reverse_limits: NDArray[np.float64] = field(repr=False)
    """(n,) [N]: the largest forces they can exert the other way."""
    steers: NDArray[np.float64] = field(repr=False)
    """(n,) [rad]: how far either side of their directions they turn their forces at any time."""
    frictions: NDArray[np.float64] = field(repr=False)
    """(n,): of fingers; 0 for other robots."""
    leasts: NDArray[np.float64] = field(repr=False)
    """(n,) [N]: the forces they always exert at least."""
    generators: NDArray[np.float64] = field(repr=False, compare=False)
    """(n, 3) [N, N, N m]: the wrench of each at its limit in its direction, about the origin."""
    characteristic_length: float
    force_weights: tuple[float, float]
    rare: Rare = field(repr=False)
    """What only some robots have: tolerances, envelopes, groups, sectors and bodies."""
    names: Names = field(repr=False)
    """Of the robots, in the order of the arrays: ``swarm.names[i]``."""

    def __init__(
        self,
        outline: Outline,
        robots: Iterable[Robot],
        characteristic_length: float | None = None,
        force_weights: tuple[float, float] = (1.0, 1.0),
    ) -> None:
        given = items(robots)
        columns = columns_of(robots if given is None else given)
        kept: tuple[Robot, ...] = given or ()
        names = names_of([robot.name for robot in kept])
        rare = Rare.of(kept)
        self._fill(outline, columns, names, rare, characteristic_length, force_weights)
        if all(robot.name for robot in kept):
            vars(self)["robots"] = kept

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
        reverse_limits: ArrayLike = 0.0,
        steers: ArrayLike = 0.0,
        frictions: ArrayLike = 0.0,
        leasts: ArrayLike = 0.0,
        names: Sequence[str] | None = None,
        tolerances: Tolerance | Sequence[Tolerance | None] | None = None,
        snap: float = 0.0,
    ) -> "Swarm":
        """Make a swarm of robots from arrays, which are copied.

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
        reverse_limits, leasts : float or (n,) [N]
        steers : float or (n,) [rad]
        frictions : float or (n,)
            As for `Robot`; a friction of 0 is none.
        names : sequence of str, optional
            One a robot, "" for a nameless one; all are nameless when left out.
        tolerances : Tolerance or sequence of Tolerance or None, optional
            One for all, or one a robot.
        snap : float [m]
            By how much contacts that were measured may be off the boundary; they are moved to
            its nearest point. Those of mounted robots stay.

        Raises
        ------
        RobotInvalid
            If an array has the wrong shape or type, or values are outside their range, or names are
            no names or not unique; the first ten robots at fault are described, the others counted.
        MetricInvalid, RobotOffBoundary
            As for any `Swarm`; a robot farther off than `snap`, with how far it is.

        Examples
        --------
        >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        >>> swarm = Swarm.from_arrays(square, [(1, 0.5), (0, -1)], [0.0, 0.0], limits=2.0)
        >>> swarm.generators.tolist()
        [[2.0, 0.0, -1.0], [2.0, 0.0, 2.0]]
        >>> swarm["R2"]
        Robot(contact=(0.0, -1.0), direction=0.0, limit=2.0, name='R2', mounted=False, ...)
        """
        columns = checked_columns(
            contacts, directions, limits, mounted, reverse_limits, steers, frictions, leasts
        )
        count = len(columns.limits)
        called = numbered(count) if names is None else checked_names(names, count)
        rare = Rare(tolerances=checked_tolerances(tolerances, columns, called))
        refuse((RobotInvalid, length_faults(snap, "snap")))
        if snap > 0.0:
            check_outline(outline)
            columns = snapped(outline, columns, called, snap)
        swarm = cls.__new__(cls)
        swarm._fill(outline, columns, called, rare, characteristic_length, force_weights)
        return swarm

    @classmethod
    def from_matrix(
        cls,
        matrix: ArrayLike,
        limits: object,
        *,
        names: Sequence[str] | None = None,
        frame: Axes = "ENU",
        outline: Outline | None = None,
        characteristic_length: float | None = None,
        force_weights: tuple[float, float] = (1.0, 1.0),
    ) -> "Swarm":
        """Make a swarm from an allocation matrix, whose columns are the wrenches of thrusters.

        Each is on board, on the line of action of its column: where that is nearest to the origin,
        or nearest to there within the outline. A column without a force, a pure torque, is a couple
        at the origin: see `lever` of a `Robot`.

        Parameters
        ----------
        matrix : (3, n) [1, 1, m]
            Surge, sway and yaw about the outline's origin, of each column per newton.
        limits : (n,) [N]
            For each column the largest force, both ways, or the lowest and the highest: (0, 60e3)
            pushes one way.
        names : sequence of str, optional
            One a column; "thruster 1" and so on when left out.
        frame : {"ENU", "NED"}
            Whether sway is to port and yaw counter-clockwise, or to starboard and clockwise.
        outline : Outline, optional
            The object; when left out, a square about the origin that all lines of action meet, and
            then the characteristic length is the largest of their arms, 1 m if all are 0.
        characteristic_length : float [m], optional
        force_weights : tuple of float
            The metric, as for any `Swarm`.

        Raises
        ------
        RobotInvalid
            If the matrix, a limit or a name is at fault, or a line of action runs past the outline;
            all faults at once.
        MetricInvalid
            As for any `Swarm`.

        Examples
        --------
        Two propellers, a bow tunnel, and a gyro of up to 1 MN m, as marine engineers write them:

        >>> matrix = [[1, 1, 0, 0], [0, 0, 1, 0], [-8, 8, 30, 1]]
        >>> ship = Swarm.from_matrix(matrix, [800e3, 800e3, 200e3, 1e6], frame="NED")
        >>> [robot.contact for robot in ship], ship["thruster 4"].lever
        ([(0.0, -8.0), (0.0, 8.0), (30.0, 0.0), (0.0, 0.0)], -1.0)
        """
        asked = checked_allocation(matrix, limits, names, frame)
        if outline is None:
            outline = square_around(asked)
            characteristic_length = characteristic_length or asked.reach or 1.0
        robots = robots_from(asked, outline)
        return cls(outline, robots, characteristic_length, force_weights)

    def _fill(
        self,
        outline: Outline,
        columns: Columns,
        names: Names,
        rare: Rare,
        length: float | None,
        force_weights: tuple[float, float],
    ) -> None:
        """Check what only the outline and the metric can tell, and keep everything."""
        check_outline(outline)
        length = outline.radius if length is None else length
        check_metric(length, force_weights)
        check_contacts(outline, columns, names, rare.couples)
        check_tolerances(outline, rare, names)
        generators = wrenches(columns.contacts - outline.origin, columns.directions, columns.limits)
        a1, a2 = numbers(force_weights)
        vars(self).update(
            columns._asdict(),
            outline=outline,
            generators=generators,
            characteristic_length=float(length),
            force_weights=(a1, a2),
            rare=rare,
            names=names,
        )
        self._freeze()

    def __len__(self) -> int:
        """Return the number of robots."""
        return len(self.directions)

    def __iter__(self) -> Iterator[Robot]:
        """Go through the robots."""
        return iter(self.robots)

    def __contains__(self, name: object) -> bool:
        """Tell whether a robot has a name."""
        return self.names.index(name) is not None

    def __getitem__(self, name: str) -> Robot:
        """Return the robot of a name.

        Raises
        ------
        RobotInvalid
            If there is none.
        """
        return self._robot(self.index(name))

    def index(self, name: str) -> int:
        """Return the row in the arrays that holds the robot of a name.

        Raises
        ------
        RobotInvalid
            If there is none.
        """
        found = self.names.index(name)
        if found is None:
            raise RobotInvalid(self._stranger(name))
        return found

    def _stranger(self, name: object) -> str:
        """Return the sentence for a name that nobody has."""
        known = ", ".join(self.names[i] for i in range(min(len(self), MOST_LISTED)))
        more = f" and {len(self) - MOST_LISTED} more" if len(self) > MOST_LISTED else ""
        return f"there is no robot called {shown(name)}; there are {known or 'none'}{more}"

    def _robot(self, i: int) -> Robot:
        """Return a robot of the arrays."""
        if "robots" in vars(self):
            return self.robots[i]
        return robot_of(self.columns, i, self.names[i], **self.rare.of_robot(i))

    @property
    def columns(self) -> Columns:
        """The values of the robots, one array each."""
        return Columns(*(getattr(self, name) for name in Columns._fields))

    @cached_property
    def robots(self) -> tuple[Robot, ...]:
        """The robots one by one; those of a swarm made from arrays are made when asked for."""
        return tuple(map(self._robot, range(len(self))))

    @property
    def tolerances(self) -> Mapping[int, Tolerance]:
        """Of those robots that have one, by index."""
        return self.rare.tolerances

    @cached_property
    def is_ray(self) -> NDArray[np.bool_]:
        """(n,): which robots push along one ray only, from nothing to their limit."""
        return read_only(rays_among(self.columns, self.rare.shapes))

    @cached_property
    def has_rays_only(self) -> bool:
        """Whether all robots push along one ray each, so that their wrenches span a zonotope."""
        return bool(self.is_ray.all())

    @cached_property
    def is_line(self) -> NDArray[np.bool_]:
        """(n,): which robots push along one line only, one way or both."""
        return read_only(lines_among(self.columns, self.rare.shapes))

    @property
    def lows(self) -> NDArray[np.float64]:
        """(n,) [N]: the least force of each in its direction; negative for both ways."""
        return least_along(self.columns)

    @cached_property
    def force_sets(self) -> ForceSets:
        """What each robot can exert at its contact, in the object's frame (T20).

        Raises
        ------
        ForceSetUnsupported
            If robots have sectors with gaps between: their forces are no convex set.
        """
        check_gaps(self)
        elements, counts = force_sets_of(self.columns, self.rare.envelopes, self.rare.hulls)
        return ForceSets(read_only(elements), read_only(counts))

    @property
    def filled(self) -> "Swarm":
        """The swarm as if robots filled the gaps between their sectors: it exerts at least as much.

        Each exerts the convex hull of its forces.
        """
        return self.choosing({}) if self.rare.gaps else self

    def choosing(self, sectors: Mapping[int, Sector]) -> "Swarm":
        """Return the swarm with one sector for some robots with gaps, and the others' gaps filled.

        Parameters
        ----------
        sectors : mapping of int to (float, float) [rad, rad]
            By the robots' rows in the arrays; each of half a turn or less, or the hull is taken.
        """
        columns = self.columns._asdict() | {"generators": np.array(self.generators)}
        rows, ends = list(sectors), np.array(list(sectors.values())).reshape(-1, 2)
        columns["directions"], columns["steers"] = np.array(self.directions), np.array(self.steers)
        columns["directions"][rows] = np.remainder(ends.mean(axis=1) + math.pi, math.tau) - math.pi
        columns["steers"][rows] = 0.5 * (ends[:, 1] - ends[:, 0])
        columns["generators"][rows] = wrenches(
            self.contacts[rows] - self.outline.origin, columns["directions"][rows],
            self.limits[rows],
        )  # fmt: skip
        return self._like(columns, self.names, self.rare.choosing(rows))

    @cached_property
    def machines(self) -> NDArray[np.intp]:
        """(n,): the machine that each robot is part of, 0 1 2 ...: robots of a group are one."""
        first: dict[str, int] = {}
        same = np.arange(len(self))
        for i, group in sorted(self.rare.groups.items()):
            same[i] = first.setdefault(group, i)
        return read_only(np.unique(same, return_inverse=True)[1].reshape(-1))

    @cached_property
    def groups(self) -> Mapping[str, tuple[str, ...]]:
        """The robots of each group, by its name: those that fail together."""
        members: dict[str, tuple[str, ...]] = {}
        for i, group in sorted(self.rare.groups.items()):
            members[group] = (*members.get(group, ()), self.names[i])
        return MappingProxyType(members)

    @cached_property
    def nearness(self) -> NDArray[np.float64]:
        """(n,): by what the limits, forces and leasts of these arrays are to be multiplied.

        1 but for couples, which the arrays hold as weak forces far away (T29).
        """
        found = np.ones(len(self))
        found[list(self.rare.couples)] = FAR
        return read_only(found)

    @cached_property
    def scale(self) -> NDArray[np.float64]:
        """(3,) [1, 1, 1/m]: A^(1/2), which makes the metric Euclidean."""
        a1, a2 = self.force_weights
        return read_only(np.array([math.sqrt(a1), math.sqrt(a2), 1.0 / self.characteristic_length]))

    @cached_property
    def scaled_generators(self) -> NDArray[np.float64]:
        """(n, 3) [N, N, N]: the generators in the metric's coordinates."""
        return read_only(self.generators * self.scale)

    @cached_property
    def errors(self) -> NDArray[np.float64]:
        """(n,) [N]: by how much the scaled generators may be off, by the outline's `precision`."""
        return read_only(generator_errors(self.outline, self.columns, self.scale))

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

    def with_robot(self, robot: Robot) -> "Swarm":
        """Return the swarm with one robot more.

        Raises
        ------
        RobotInvalid
            If it is no `Robot`, or another has its name.
        RobotOffBoundary
            If it holds nothing.

        Examples
        --------
        >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        >>> len(Swarm(square, []).with_robot(Robot((1, 0), direction=3.14)))
        1
        """
        one = columns_of((robot,))
        names = self.names.joined(robot.name)
        rows = self._rows(one, names[len(self)], couple_of(robot))
        check_tolerances(self.outline, Rare.of((robot,), first=len(self)), names)
        joined = {name: np.concatenate([getattr(self, name), row]) for name, row in rows.items()}
        swarm = self._like(joined, names, self.rare.with_robot(len(self), robot))
        if "robots" in vars(self) and robot.name:
            vars(swarm)["robots"] = (*self.robots, robot)
        return swarm

    def with_pose(
        self, name: str, contact: tuple[float, float], direction: float | None = None
    ) -> "Swarm":
        """Return the swarm with one robot elsewhere, in the same order.

        Parameters
        ----------
        name : str
            Of the robot.
        contact : tuple of float [m, m]
            Where it holds the object then.
        direction : float [rad], optional
            Of its force; as it is when left out.

        Raises
        ------
        RobotInvalid
            If there is no robot of that name, or a number is none.
        RobotOffBoundary
            If it holds nothing there.

        Examples
        --------
        >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        >>> pair = Swarm(square, [Robot((1, 0), 0.0, name="Ajax"), Robot((0, 1), 0.5)])
        >>> moved = pair.with_pose("Ajax", (1, 0.5))
        >>> [robot.contact for robot in moved]
        [(1.0, 0.5), (0.0, 1.0)]
        """
        i = self.index(name)
        old = self._robot(i)
        robot = replace(old, contact=contact)
        if direction is not None:
            robot = replace(robot, direction=direction)
        return self.replaced(name, robot)

    def replaced(self, name: str, robot: Robot) -> "Swarm":
        """Return the swarm with a robot in the place of another, in the same order.

        Parameters
        ----------
        name : str
            Of the robot that leaves.
        robot : Robot
            Who takes its place, and its name if it has none of its own.

        Raises
        ------
        RobotInvalid
            If there is no robot of that name, if it is no `Robot`, or if another has its name.
        RobotOffBoundary
            If it holds nothing.

        Examples
        --------
        >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        >>> pair = Swarm(square, [Robot((1, 0), 0.0, name="Ajax"), Robot((0, 1), 0.5)])
        >>> stronger = pair.replaced("Ajax", Robot((1, 0), 0.0, limit=3.0))
        >>> stronger["Ajax"].limit, len(stronger)
        (3.0, 2)
        """
        i, one = self.index(name), columns_of((robot,))
        robot = robot if robot.name else replace(robot, name=name)
        names = self.names if robot.name == name else self.names.renamed(i, robot.name)
        rows = self._rows(one, robot.name, couple_of(robot))
        check_tolerances(self.outline, Rare.of((robot,), first=i), names)
        moved = {column: np.array(getattr(self, column)) for column in rows}
        for column, row in rows.items():
            moved[column][i] = row[0]
        swarm = self._like(moved, names, self.rare.with_robot(i, robot))
        if "robots" in vars(self):
            vars(swarm)["robots"] = (*self.robots[:i], robot, *self.robots[i + 1 :])
        return swarm

    def _rows(self, one: Columns, name: str, couple: Couple | None) -> dict[str, NDArray[Any]]:
        """Return what the arrays hold of one robot, which should hold the object."""
        check_contacts(self.outline, one, names_of([name]), {0: couple} if couple else {})
        arms = one.contacts - self.outline.origin
        return {
            **one._asdict(),
            "generators": wrenches(arms, one.directions, one.limits),
        }

    def without(self, names: str | Iterable[str]) -> "Swarm":
        """Return the swarm without one robot or some, given by name; the others keep theirs.

        Raises
        ------
        RobotInvalid
            If there is no robot of a name; all such names are told.

        Examples
        --------
        >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        >>> pair = Swarm(square, [Robot((1, 0), 0.0, name="Ajax"), Robot((0, 1), 0.0)])
        >>> [robot.name for robot in pair.without("Ajax")]
        ['R1']
        """
        return self.without_rows(map(self.index, self.known(names)))

    def known(self, names: str | Iterable[str]) -> tuple[str, ...]:
        """Return the names of robots, one or several, if they are.

        Raises
        ------
        RobotInvalid
            If there is no robot of a name; all such names are told.
        """
        wanted = (names,) if isinstance(names, str) else items(names)
        if isinstance(names, Set):
            wanted = tuple(names)
        if wanted is None:
            raise RobotInvalid(f"the names are {shown(names)}; they should be a name or several")
        faults = [self._stranger(name) for name in wanted if name not in self]
        if faults:
            raise RobotInvalid(faults)
        return wanted

    def without_rows(self, rows: Iterable[int]) -> "Swarm":
        """Return the swarm without the robots in some rows of the arrays."""
        gone = set(rows)
        kept = np.delete(np.arange(len(self)), list(gone))
        left = {name: getattr(self, name)[kept] for name in (*Columns._fields, "generators")}
        rare = self.rare.without(gone, lambda i: int(np.searchsorted(kept, i)))
        return self._like(left, self.names.without(gone), rare)

    def _like(self, columns: dict[str, NDArray[Any]], names: Names, rare: Rare) -> "Swarm":
        """Return a swarm of other robots, which are known to be right, in the same metric."""
        swarm = Swarm.__new__(Swarm)
        vars(swarm).update(
            columns,
            outline=self.outline,
            characteristic_length=self.characteristic_length,
            force_weights=self.force_weights,
            scale=self.scale,
            rare=rare,
            names=names,
        )
        swarm._freeze()
        return swarm

    def with_tolerance(self, tolerance: Tolerance) -> "Swarm":
        """Return the swarm with one tolerance for every robot; a mounted one keeps its contact.

        Raises
        ------
        RobotInvalid
            If it is no tolerance, or does not go with a robot's limit or with the boundary.
        """
        faults = kind_faults(tolerance, Tolerance, "Tolerance(...)")
        if faults:
            raise RobotInvalid(faults)
        return Swarm(
            self.outline,
            [
                replace(
                    robot,
                    tolerance=_kept(tolerance, robot),
                )
                for robot in self
            ],
            self.characteristic_length,
            self.force_weights,
        )


def _kept(tolerance: Tolerance, robot: Robot) -> Tolerance:
    """Return what a robot can have of a tolerance: mounted ones stay, and couples do not turn."""
    if robot.mounted:
        tolerance = replace(tolerance, contact=0.0)
    return replace(tolerance, direction=0.0) if robot.lever else tolerance


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


def swarm_faults(swarm: object) -> list[str]:
    """Return what is wrong with something that should be a swarm."""
    return kind_faults(swarm, Swarm, "Swarm(outline, robots)")


def check_rays(swarm: Swarm, what: str) -> None:
    """Raise `ForceSetUnsupported` unless all robots push along one ray each.

    Parameters
    ----------
    swarm : Swarm
    what : str
        What is asked for, such as "a summary".
    """
    if not swarm.has_rays_only:
        raise ForceSetUnsupported(
            f"{what} is for robots that push along one ray each, and these do not: "
            f"{_listed(swarm, np.flatnonzero(~swarm.is_ray).tolist())}"
        )


def check_gaps(swarm: Swarm, what: str = "what is asked for") -> None:
    """Raise `ForceSetUnsupported` if robots have sectors with gaps between.

    Parameters
    ----------
    swarm : Swarm
    what : str
        What is asked for, such as "a wrench set".
    """
    if swarm.rare.gaps:
        raise ForceSetUnsupported(
            f"{what} is not known of robots whose sectors have gaps between: "
            f"{_listed(swarm, sorted(swarm.rare.gaps))}; their quality, what losses leave of it, "
            "push forces and the place of one newcomer are, and anything of robots of one "
            "sector each, of half a turn or less"
        )


def _listed(swarm: Swarm, rows: Sequence[int]) -> str:
    """Name the robots in some rows of the arrays, the first of them if they are many."""
    names = [swarm.names[i] for i in rows[:MOST_LISTED]]
    more = f" and {len(rows) - MOST_LISTED} more" if len(rows) > MOST_LISTED else ""
    return f"{', '.join(names)}{more}"


def check_swarm(swarm: object) -> None:
    """Raise `SwarmInvalid` unless something is a swarm."""
    refuse((SwarmInvalid, swarm_faults(swarm)))


def check_tolerances(outline: Outline, rare: Rare, names: Names) -> None:
    """Raise `RobotInvalid` where a contact may be anywhere more than once around the boundary."""
    faults = [
        f"{names[i]}: its contact may lie on {last - first:.6g} m of the boundary; "
        f"that should be at most the perimeter, {outline.perimeter:.6g} m"
        for i, (first, last) in ((i, found.offsets) for i, found in rare.tolerances.items())
        if last - first > outline.perimeter
    ]
    if faults:
        raise RobotInvalid(faults)


def check_metric(length: float, force_weights: tuple[float, float]) -> None:
    """Raise `MetricInvalid` unless all three numbers are positive and in range."""
    named = [("characteristic length", length, "m")]
    faults = []
    weights = items(force_weights) or ()
    if len(weights) == 2:
        named += [("force weight a1", weights[0], "1"), ("force weight a2", weights[1], "1")]
    else:
        faults.append(f"the force weights are {shown(force_weights)}; they should be two numbers")
    faults += [
        f"the {name} is {shown(value)}; it should be {WEAKEST:g} <= value <= {STRONGEST:g} [{unit}]"
        for name, value, unit in named
        if not WEAKEST <= number(value) <= STRONGEST
    ]
    if faults:
        raise MetricInvalid(faults)
