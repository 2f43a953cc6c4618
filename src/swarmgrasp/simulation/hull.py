"""What an object weighs in water: its mass, and the water that moves along."""

import math
from dataclasses import dataclass, replace
from functools import cached_property
from typing import Self

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.environment import WATER, Environment
from swarmgrasp.environment.limits import OFFSET, Range
from swarmgrasp.errors import OutlineInvalid, SimulationInvalid, refuse
from swarmgrasp.frozen import read_only
from swarmgrasp.outline import Outline
from swarmgrasp.outline.polygon import centroid
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import array_of, items, kind_faults, number, numbers, shown
from swarmgrasp.simulation.actuator import ATTACHED

MASS = Range(1e-9, 1e15, "kg")
INERTIA = Range(1e-12, 1e30, "kg m^2")
ADDED = Range(0.0, 1e15, "kg")
ADDED_INERTIA = Range(0.0, 1e30, "kg m^2")
DEPTH = Range(1e-9, 1e6, "m")
BLOCK = Range(1e-3, 1.0, "1")

THICKNESSES = (0.1, 0.2, 0.5, 1.0, 2.0, 5.0, 10.0)
"""Draughts over half beams, of the table below."""
RECTANGLES = (2.23, 1.98, 1.70, 1.51, 1.36, 1.21, 1.14)
"""Added masses of rectangles that move sideways over that of a circle as high: DNV-RP-C205, table
D-1."""

EIGENVALUE_NOISE = 1e-12
"""How far below 0 rounding takes an eigenvalue, relative to the largest entry."""

Pair = tuple[float, float]
Triple = tuple[float, float, float]
NO_DAMPING: tuple[Triple, Triple, Triple] = ((0.0, 0.0, 0.0),) * 3


@dataclass(frozen=True)
class Hull(Plain):
    """What an object weighs in water.

    Points are given from the outline's origin, in the object's frame: x forward, y to port.

    Attributes
    ----------
    mass : float [kg]
    centre : tuple of float [m, m]
        Of mass.
    inertia : float [kg m^2]
        About the centre of mass.
    added : tuple of float [kg, kg, kg m^2]
        A11, A22 and A66: of the water that has to move when the object surges, sways and yaws.
    added_at : tuple of float [m, m]
        Where these act and are taken about.
    damping : 3 tuples of 3 float [N s/m, N s, N m s]
        A matrix that, times the velocity over the ground (u, v, r), is a wrench against it; none
        by default. The drag of the water is not meant: that is the `Current`'s.

    Raises
    ------
    SimulationInvalid
        If a number is outside its range, or damping would drive the object; all faults at once.

    Examples
    --------
    >>> Hull(-1.0, (0.0, 0.0), 0.0, (0.0, 0.0, 0.0))
    Traceback (most recent call last):
    ...
    swarmgrasp.errors.SimulationInvalid: hull: the mass is -1.0; it should be 1e-09 <= mass <= ...
    hull: the inertia is 0.0; it should be 1e-12 <= inertia <= 1e+30 [kg m^2]
    """

    mass: float
    centre: Pair
    inertia: float
    added: Triple
    added_at: Pair = (0.0, 0.0)
    damping: tuple[Triple, Triple, Triple] = NO_DAMPING

    def __post_init__(self) -> None:
        """Check the values."""
        faults = MASS.faults("mass", self.mass) + INERTIA.faults("inertia", self.inertia)
        for called, point in (("centre", self.centre), ("added masses' point", self.added_at)):
            if len(numbers(point)) != 2 or any(OFFSET.faults("", x) for x in numbers(point)):
                faults.append(
                    f"the {called} is {shown(point)}; it should be two numbers of size <= "
                    f"{OFFSET.high:g} [m]"
                )
        added = items(self.added) or ()
        if len(added) != 3:
            faults.append(
                f"the added masses are {shown(self.added)}; they should be A11, A22 and A66"
            )
        else:
            for called, value in zip(("A11", "A22"), added, strict=False):
                faults += ADDED.faults(f"added mass {called}", value)
            faults += ADDED_INERTIA.faults("added inertia A66", added[2])
        faults += _damping_faults(self.damping)
        if faults:
            raise SimulationInvalid(f"hull: {fault}" for fault in faults)
        vars(self).update(
            mass=float(self.mass),
            inertia=float(self.inertia),
            centre=numbers(self.centre),
            added=numbers(self.added),
            added_at=numbers(self.added_at),
            damping=tuple(map(numbers, self.damping)),
        )

    @classmethod
    def afloat(
        cls,
        outline: Outline,
        environment: Environment | None = None,
        *,
        draught: float | None = None,
        block: float = 1.0,
        mass: float | None = None,
    ) -> Self:
        """Make the hull that floats on an outline, by formulas for a box of its length and beam.

        With length L, beam B, draught T, area A and block coefficient C_b, the mass, unless given,
        is density A T C_b; it is spread evenly over the outline. V is the volume of so much water:

            A11 = 2.7 density V^(5/3) / L^2                          (Soeding 1982)
            A22 = (pi / 2) density C_a T^2 L C_b                      (strips; DNV-RP-C205)
            A66 = A22 L^2 / 12

        with C_a from 2.23 for a shallow box, T = 0.05 B, to 1.14 for a deep one. They act at
        midship, the middle of the outline's extent.

        Parameters
        ----------
        outline : Outline
        environment : Environment, optional
            Its current tells the density, 1026 kg/m^3 without, and the lateral area under water.
        draught : float [m], optional
            Without, that lateral area over the length, or what the mass needs.
        block : float
            Part of outline times draught that is in the water, within [0.001, 1].
        mass : float [kg], optional

        Raises
        ------
        OutlineInvalid, SimulationInvalid
            If a value is outside its range, or nothing tells the draught; all faults at once.

        Examples
        --------
        >>> barge = Outline([(-40, -10), (40, -10), (40, 10), (-40, 10)])
        >>> hull = Hull.afloat(barge, draught=2.5)
        >>> round(hull.mass), [round(added / hull.mass, 3) for added in hull.added[:2]]
        (4104000, [0.106, 0.375])
        """
        shape = kind_faults(outline, Outline, "Outline(vertices)")
        faults = BLOCK.faults("block coefficient", block)
        if environment is not None:
            faults += kind_faults(environment, Environment, "Environment(wind)")
        faults += [] if mass is None else MASS.faults("mass", mass)
        faults += [] if draught is None else DEPTH.faults("draught", draught)
        wrong = (SimulationInvalid, [f"hull: {fault}" for fault in faults])
        refuse((OutlineInvalid, shape), wrong)
        current = None if environment is None else environment.current
        density = WATER if current is None else current.density
        length, beam = np.ptp(outline.vertices, axis=0).tolist()
        if draught is None and current is not None:
            draught = current.lateral_area / length
        elif draught is None and mass is not None:
            draught = mass / (density * outline.area * block)
        _check_draught(draught, length)
        depth = number(draught)
        weight = density * outline.area * depth * block if mass is None else float(mass)
        surge = 2.7 * density * (weight / density) ** (5.0 / 3.0) / length**2
        strip = 0.5 * math.pi * density * _thickness_factor(2.0 * depth / beam) * depth**2
        sway = strip * length * block
        corners = outline.vertices - outline.origin
        centre, spread = _spread(corners)
        midship = 0.5 * (corners.min(axis=0) + corners.max(axis=0))
        added = (surge, sway, sway * length**2 / 12.0)
        return cls(weight, _pair(centre), weight * spread, added, _pair(midship))

    @classmethod
    def ashore(cls, outline: Outline, mass: float) -> Self:
        """Make the hull of an object that no water touches, such as a pallet on a floor.

        Its mass is spread evenly over the outline, and nothing moves along.

        Parameters
        ----------
        outline : Outline
        mass : float [kg]

        Raises
        ------
        OutlineInvalid, SimulationInvalid
            If one is none; all faults at once.

        Examples
        --------
        >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
        >>> round(Hull.ashore(square, 30.0).inertia, 9)
        20.0
        """
        wrong = [f"hull: {fault}" for fault in MASS.faults("mass", mass)]
        shape = kind_faults(outline, Outline, "Outline(vertices)")
        refuse((OutlineInvalid, shape), (SimulationInvalid, wrong))
        centre, spread = _spread(outline.vertices - outline.origin)
        return cls(float(mass), _pair(centre), float(mass) * spread, (0.0, 0.0, 0.0))

    def with_robots(self, masses: ArrayLike, contacts: ArrayLike) -> "Hull":
        """Return the hull with robots rigidly attached, each as a mass at a point.

        Parameters
        ----------
        masses : (n,) [kg]
        contacts : (n, 2) [m, m]
            From the outline's origin.

        Raises
        ------
        SimulationInvalid
            If these are no numbers of such shapes, or a mass is negative.

        Examples
        --------
        >>> hull = Hull(3.0, (0.0, 0.0), 1.0, (0.0, 0.0, 0.0)).with_robots([1.0], [(4.0, 0.0)])
        >>> hull.mass, hull.centre, hull.inertia
        (4.0, (1.0, 0.0), 13.0)
        """
        weights, points = array_of(masses), array_of(contacts)
        if weights is None or weights.ndim != 1 or not _are_masses(weights):
            raise SimulationInvalid(
                f"the masses of the robots are {shown(masses)}; they should be a list of numbers, "
                f"0 <= mass <= {ATTACHED.high:g} [kg]"
            )
        points = np.zeros((0, 2)) if points is not None and not points.size else points
        if points is None or points.shape != (len(weights), 2) or not np.isfinite(points).all():
            raise SimulationInvalid(
                f"the contacts of the robots are {shown(contacts)}; they should be finite numbers "
                f"({len(weights)}, 2) [m, m]"
            )
        own = np.array(self.centre)
        mass = self.mass + float(weights.sum())
        shift = np.sum(weights[:, None] * (points - own), axis=0) / mass
        inertia = self.inertia + self.mass * float(shift @ shift)
        inertia += float(np.sum(weights * np.sum((points - own - shift) ** 2, axis=1)))
        return replace(self, mass=mass, centre=_pair(own + shift), inertia=inertia)

    @cached_property
    def matrix(self) -> NDArray[np.float64]:
        """(3, 3) [kg, kg m, kg m^2]: mass and added masses about the outline's origin."""
        m, (x, y) = self.mass, self.centre
        a11, a22, a66 = self.added
        p, q = self.added_at
        surge, sway = m + a11, m + a22
        ahead, abeam = -m * y - a11 * q, m * x + a22 * p
        yaw = self.inertia + m * (x * x + y * y) + a66 + a11 * q * q + a22 * p * p
        found = [[surge, 0.0, ahead], [0.0, sway, abeam], [ahead, abeam, yaw]]
        return read_only(np.array(found))


def inverse_of(matrix: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the inverse (3, 3) of a matrix of masses as `Hull.matrix` has it.

    By cofactors: when lengths and masses are scaled by powers of 2, so are all its numbers, to the
    last bit, which pivots would not leave so.

    Examples
    --------
    >>> hull = Hull(2.0, (1.0, 2.0), 2.0, (0.0, 0.0, 0.0))
    >>> inverse_of(hull.matrix).tolist()
    [[2.5, -1.0, 1.0], [-1.0, 1.0, -0.5], [1.0, -0.5, 0.5]]
    """
    (a, _, d), (_, b, e), (_, _, c) = matrix.tolist()
    yaw = c - d * d / a - e * e / b
    p, q = d / a, e / b
    rows = [
        [1.0 / a + p * p / yaw, p * q / yaw, -p / yaw],
        [p * q / yaw, 1.0 / b + q * q / yaw, -q / yaw],
        [-p / yaw, -q / yaw, 1.0 / yaw],
    ]
    return np.array(rows)


def _check_draught(draught: float | None, length: float) -> None:
    """Raise `SimulationInvalid` if nothing tells a draught, or it is deeper than a hull is long."""
    if draught is None:
        raise SimulationInvalid(
            "hull: nothing tells how deep it floats; give a draught [m], a mass [kg], or an "
            "environment with a current, whose lateral area under water tells"
        )
    if draught > length:
        raise SimulationInvalid(
            f"hull: the draught is {shown(draught)}; it should be 0 < draught <= {length:.6g}, the "
            "length of the outline [m]; of a deeper hull give the masses: Hull(mass, ...)"
        )


def _spread(corners: NDArray[np.float64]) -> tuple[NDArray[np.float64], float]:
    """Return the centroid (2,) [m, m] of a polygon, and the square of its radius of gyration."""
    middle = centroid(corners)
    start = corners - middle
    end = np.roll(start, -1, axis=0)
    turn = start[:, 0] * end[:, 1] - end[:, 0] * start[:, 1]
    squares = np.sum(start * start + start * end + end * end, axis=1)
    return middle, float(np.sum(turn * squares) / (6.0 * np.sum(turn)))


def _are_masses(weights: NDArray[np.float64]) -> bool:
    """Tell whether numbers are masses of robots."""
    return bool(((weights >= ATTACHED.low) & (weights <= ATTACHED.high)).all())


def _thickness_factor(thickness: float) -> float:
    """Return C_a of a draught over half a beam, between the table's rows by their logarithms."""
    return float(np.interp(math.log(thickness), np.log(THICKNESSES), RECTANGLES))


def _damping_faults(damping: object) -> list[str]:
    """Return what is wrong with a matrix of damping."""
    rows = array_of(damping)
    if rows is None or rows.shape != (3, 3) or not np.isfinite(rows).all():
        return [f"the damping is {shown(damping)}; it should be three rows of three finite numbers"]
    least = float(np.linalg.eigvalsh(rows + rows.T).min())
    if least >= -EIGENVALUE_NOISE * float(np.abs(rows).max()):
        return []
    return [
        f"the damping is {shown(damping)}; it should take energy out of any motion: u' D u >= 0"
    ]


def _pair(point: NDArray[np.float64]) -> Pair:
    """Return a point as numbers."""
    x, y = point.tolist()
    return x, y
