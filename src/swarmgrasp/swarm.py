"""A swarm: the object, the robots holding it, and the metric that makes wrenches comparable."""

import math
from collections.abc import Iterable
from dataclasses import dataclass, field

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import MetricInvalid, OutlineInvalid, RobotInvalid, RobotOffBoundary
from swarmgrasp.outline import Outline
from swarmgrasp.robot import STRONGEST, WEAKEST, Robot, numbers


@dataclass(frozen=True, eq=False)
class Swarm:
    """Robots in contact with an object.

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
    RobotOffBoundary
        If robots are off the boundary, or mounted ones outside; all of them are named,
        each with its distance and the nearest boundary point.

    Examples
    --------
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> swarm = Swarm(square, [Robot((1, 0.5), direction=0.0, limit=2.0)])
    >>> swarm.generators.tolist()
    [[2.0, 0.0, -1.0]]
    """

    outline: Outline
    robots: tuple[Robot, ...]
    characteristic_length: float
    force_weights: tuple[float, float]
    generators: NDArray[np.float64] = field(repr=False)
    """(n, 3) [N, N, N m]: the wrench of each robot at its limit, about the origin."""

    def __init__(
        self,
        outline: Outline,
        robots: Iterable[Robot],
        characteristic_length: float | None = None,
        force_weights: tuple[float, float] = (1.0, 1.0),
    ) -> None:
        crew = tuple(robots)
        if not isinstance(outline, Outline):
            raise OutlineInvalid(f"{outline!r} is no outline: make one with Outline(vertices)")
        strangers = [robot for robot in crew if not isinstance(robot, Robot)]
        if strangers:
            raise RobotInvalid(f"{robot!r} is no Robot" for robot in strangers)
        length = outline.radius if characteristic_length is None else characteristic_length
        check_metric(length, force_weights)
        contacts = np.array([r.contact for r in crew], dtype=float).reshape(-1, 2)
        _check_contacts(outline, crew, contacts)
        generators = wrenches(
            contacts - outline.origin,
            np.array([r.direction for r in crew], dtype=float),
            np.array([r.limit for r in crew], dtype=float),
        )
        generators.setflags(write=False)
        object.__setattr__(self, "outline", outline)
        object.__setattr__(self, "robots", crew)
        object.__setattr__(self, "characteristic_length", float(length))
        object.__setattr__(self, "force_weights", tuple(map(float, force_weights)))
        object.__setattr__(self, "generators", generators)

    def __len__(self) -> int:
        """Return the number of robots."""
        return len(self.robots)

    @property
    def scale(self) -> NDArray[np.float64]:
        """(3,) [1, 1, 1/m]: A^(1/2), which makes the metric Euclidean."""
        a1, a2 = self.force_weights
        return np.array([math.sqrt(a1), math.sqrt(a2), 1.0 / self.characteristic_length])

    @property
    def scaled_generators(self) -> NDArray[np.float64]:
        """(n, 3) [N, N, N]: the generators in the metric's coordinates."""
        return self.generators * self.scale

    @property
    def contacts(self) -> NDArray[np.float64]:
        """(n, 2) [m, m]: where the robots hold the object, in the frame of the vertices."""
        return np.array([robot.contact for robot in self.robots], dtype=float).reshape(-1, 2)

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
        return self.robots[index].name or f"robot {index}"

    def with_robot(self, robot: Robot) -> "Swarm":
        """Return the swarm with one robot more.

        Examples
        --------
        >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        >>> len(Swarm(square, []).with_robot(Robot((1, 0), direction=3.14)))
        1
        """
        crew = (*self.robots, robot)
        return Swarm(self.outline, crew, self.characteristic_length, self.force_weights)


def wrenches(
    arms: NDArray[np.float64], directions: NDArray[np.float64], forces: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Compute the wrenches of forces at moment arms: (F, c x F), the paper's B_i corrected.

    Parameters
    ----------
    arms : (n, 2) [m, m]
    directions : (n,) [rad]
    forces : (n,) [N]

    Returns
    -------
    (n, 3) [N, N, N m]

    Examples
    --------
    >>> wrenches(np.array([[1.0, 0.5]]), np.array([0.0]), np.array([2.0])).tolist()
    [[2.0, 0.0, -1.0]]
    """
    fx, fy = forces * np.cos(directions), forces * np.sin(directions)
    return np.column_stack([fx, fy, arms[:, 0] * fy - arms[:, 1] * fx])


def check_metric(length: float, force_weights: tuple[float, float]) -> None:
    """Raise `MetricInvalid` unless all three numbers are positive and in range."""
    named = [("characteristic length", length, "m")]
    weights = tuple(force_weights)
    if len(weights) != 2:
        raise MetricInvalid(f"the force weights are {weights!r}; they should be two numbers")
    named += [(f"force weight a{i}", a, "1") for i, a in enumerate(weights, 1)]
    faults = [
        f"the {name} is {value!r}; it should be {WEAKEST:g} <= value <= {STRONGEST:g} [{unit}]"
        for name, value, unit in named
        if not any(WEAKEST <= number <= STRONGEST for number in numbers((value,)))
    ]
    if faults:
        raise MetricInvalid(faults)


def _check_contacts(
    outline: Outline, robots: tuple[Robot, ...], contacts: NDArray[np.float64]
) -> None:
    """Raise `RobotOffBoundary` naming every robot that holds nothing."""
    distances, arc_lengths = outline.nearest(contacts)
    faults = []
    for i in np.flatnonzero(~(distances <= outline.tolerance)):
        robot = robots[i]
        if robot.mounted and outline.contains(robot.contact):
            continue
        nearest = outline.at_arc_length(float(arc_lengths[i]))
        where = outline.off_boundary(robot.contact, nearest, float(distances[i]))
        remedy = (
            "a mounted robot should be inside the outline"
            if robot.mounted
            else "move it there, or declare it mounted if it sits inside the outline"
        )
        faults.append(f"{robot.name or f'robot {i}'} at {where}; {remedy}")
    if faults:
        raise RobotOffBoundary(faults)
