"""The object and its robots in MuJoCo's own language, MJCF."""

import math
from collections.abc import Sequence
from dataclasses import dataclass
from xml.etree import ElementTree
from xml.etree.ElementTree import Element, SubElement

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.environment.limits import COEFFICIENT, OFFSET
from swarmgrasp.errors import SimulationInvalid, SwarmInvalid, refuse
from swarmgrasp.outline.polygon import signed_area, triangles_of
from swarmgrasp.plain import Plain
from swarmgrasp.ranges import array_of, items, kind_faults, numbers, shown
from swarmgrasp.simulation.actuator import LAG
from swarmgrasp.simulation.hull import Hull
from swarmgrasp.simulation.plant import STEP
from swarmgrasp.swarm import Swarm

Array = NDArray[np.float64]
GRAVITY = 9.80665
"""Standard gravity [m/s^2]."""
FEWEST_FEET = 3
HEIGHT = 0.1
"""Of the object as it is drawn, relative to its extent."""
THICKNESS = 0.008
"""Radius of a robot as it is drawn, and of a foot, relative to that extent."""
UNSEEN = {"contype": "0", "conaffinity": "0"}
"""Of what is drawn and touches nothing."""


@dataclass(frozen=True)
class Floor(Plain):
    """A level floor, on which an object stands on feet.

    Attributes
    ----------
    friction : float
        Coefficient of dry friction between feet and floor.
    feet : sequence of (float, float) [m, m]
        At least three, in the frame of the outline's vertices. Those that stand evenly about the
        centre of mass bear the same weight.

    Raises
    ------
    SimulationInvalid
        If the friction is outside its range, or the feet are no points; all faults at once.

    Examples
    --------
    >>> Floor(0.5, [(0, 0), (1, 0)])
    Traceback (most recent call last):
    ...
    swarmgrasp.errors.SimulationInvalid: floor: the feet are [(0, 0), (1, 0)]; they should be at ...
    """

    friction: float
    feet: Sequence[tuple[float, float]]

    def __post_init__(self) -> None:
        """Check the values."""
        faults = COEFFICIENT.faults("friction", self.friction)
        feet = tuple(map(numbers, items(self.feet) or ()))
        points = [f for f in feet if len(f) == 2 and not any(OFFSET.faults("", x) for x in f)]
        if len(feet) < FEWEST_FEET or len(points) < len(feet):
            faults.append(
                f"the feet are {shown(self.feet)}; they should be at least {FEWEST_FEET} points "
                f"(x, y) of numbers of size <= {OFFSET.high:g} [m]"
            )
        if faults:
            raise SimulationInvalid(f"floor: {fault}" for fault in faults)
        vars(self).update(friction=float(self.friction), feet=feet)

    def grip(self, hull: Hull) -> float:
        """Return the force [N] at which an object begins to slide: friction times weight."""
        return self.friction * hull.mass * GRAVITY


def mjcf(
    swarm: Swarm,
    hull: Hull,
    floor: Floor | None = None,
    *,
    lags: ArrayLike = 0.0,
    step: float = 0.002,
    name: str = "swarmgrasp",
) -> str:
    """Return an object and its robots as a model for MuJoCo.

    Robots are motors at sites on the object: one for a robot that pushes along a line, and two,
    along x and y, for one that can push otherwise; in their order, and in newtons. Without a floor
    the object moves in the plane, with nothing to resist; on one it stands on feet, has its weight
    and may tip.

    Parameters
    ----------
    swarm : Swarm
    hull : Hull
        Its mass, centre and inertia: MuJoCo has one mass for every direction, none of water.
    floor : Floor, optional
    lags : float or (n,) [s]
        Time constants of the robots' forces.
    step : float [s]
    name : str
        Of the model.

    Raises
    ------
    SimulationInvalid, SwarmInvalid
        If a value is none of these; all faults at once.

    Examples
    --------
    >>> from swarmgrasp import Outline, Robot
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> swarm = Swarm(square, [Robot((1.0, 0.5), direction=3.14, limit=2.0, name="Ajax")])
    >>> text = mjcf(swarm, Hull.ashore(square, 30.0))
    >>> print(text[text.index("<actuator>") :])  # doctest: +NORMALIZE_WHITESPACE
    <actuator>
        <motor name="Ajax" gear="0 0 1 0 0 0" ctrlrange="0 2" site="Ajax" />
      </actuator>
    </mujoco>
    <BLANKLINE>
    """
    delays = _checked(swarm, hull, floor, lags, step)
    root = Element("mujoco", model=name)
    SubElement(root, "compiler", angle="radian", autolimits="true", inertiafromgeom="false")
    # a pyramid of friction lets go at 0.98 of the limit askew; and cones creep less at 10
    SubElement(
        root, "option", timestep=_text(step), gravity=_text(0.0, 0.0, -GRAVITY),
        integrator="RK4" if floor is None else "implicitfast", cone="elliptic", impratio="10",
    )  # fmt: skip
    light = SubElement(SubElement(root, "visual"), "headlight")
    light.attrib.update(ambient=_text(0.4, 0.4, 0.4), diffuse=_text(0.6, 0.6, 0.6))
    _add_mesh(SubElement(root, "asset"), swarm)
    body = _add_object(SubElement(root, "worldbody"), swarm, hull, floor)
    _add_robots(body, SubElement(root, "actuator"), swarm, delays)
    ElementTree.indent(root)
    return ElementTree.tostring(root, encoding="unicode") + "\n"


def columns_of(swarm: Swarm) -> list[list[tuple[float, float]]]:
    """Return what each robot's motors push along: one unit vector each, in the object's frame."""
    own = zip(np.cos(swarm.directions).tolist(), np.sin(swarm.directions).tolist(), strict=True)
    both = [(1.0, 0.0), (0.0, 1.0)]
    return [
        [along] if is_line else both
        for along, is_line in zip(own, swarm.is_line.tolist(), strict=True)
    ]


def _checked(
    swarm: Swarm, hull: Hull, floor: Floor | None, lags: ArrayLike, step: float
) -> list[float]:
    """Return the lag of each robot [s], or raise what is wrong with the values."""
    crowd = kind_faults(swarm, Swarm, "Swarm(outline, robots)")
    faults = kind_faults(hull, Hull, "Hull.ashore(outline, mass)") + STEP.faults("step", step)
    faults += [] if floor is None else kind_faults(floor, Floor, "Floor(friction, feet)")
    given = array_of(lags)
    delays = np.zeros((0, 0)) if given is None else given
    if delays.ndim > 1 or delays.size not in (1, 0 if crowd else len(swarm)):
        faults.append(
            f"the lags are {shown(lags)}; they should be one number, or one for each robot [s]"
        )
    else:
        faults += [fault for lag in np.unique(delays).tolist() for fault in LAG.faults("lag", lag)]
    refuse((SwarmInvalid, crowd), (SimulationInvalid, faults))
    found: list[float] = np.broadcast_to(delays, len(swarm)).tolist()
    return found


def _add_object(world: Element, swarm: Swarm, hull: Hull, floor: Floor | None) -> Element:
    """Add water or a floor, and on it the object, with its mass, how it moves and what it shows."""
    grip = UNSEEN if floor is None else {"friction": _text(floor.friction, 0.0, 0.0)}
    colour = _text(0.55, 0.68, 0.78, 1.0) if floor is None else _text(0.62, 0.6, 0.56, 1.0)
    SubElement(
        world, "geom", dict(grip), name="ground", type="plane", size=_text(0.0, 0.0, 1.0),
        rgba=colour,
    )  # fmt: skip
    body = SubElement(world, "body", name="object")
    height = 0.0 if floor is None else HEIGHT * swarm.outline.extent
    flat = 0.5 * hull.inertia + hull.mass * height**2 / 12.0
    SubElement(
        body, "inertial", pos=_text(*hull.centre, 0.5 * height), mass=_text(hull.mass),
        diaginertia=_text(flat, flat, hull.inertia),
    )  # fmt: skip
    if floor is not None:
        SubElement(body, "freejoint", name="object")
        _add_feet(body, floor, swarm)
    else:
        for called, axis in (("x", (1, 0, 0)), ("y", (0, 1, 0))):
            SubElement(body, "joint", name=called, type="slide", axis=_text(*axis))
        SubElement(body, "joint", name="heading", type="hinge", axis=_text(0, 0, 1))
    SubElement(
        body, "geom", dict(UNSEEN), name="object", type="mesh", mesh="object",
        mass=_text(hull.mass), rgba=_text(0.83, 0.81, 0.76, 1.0),
    )  # fmt: skip
    return body


def _add_mesh(asset: Element, swarm: Swarm) -> None:
    """Describe the object as a prism."""
    corners = swarm.outline.vertices
    count = len(corners)
    index = {tuple(corner): i for i, corner in enumerate(corners.tolist())}
    faces: list[int] = []
    for triangle in triangles_of(corners):
        a, b, c = (index[tuple(corner)] for corner in triangle.tolist())
        if signed_area(triangle) < 0.0:
            b, c = c, b
        faces += [a + count, b + count, c + count, a, c, b]
    for i in range(count):
        j = (i + 1) % count
        faces += [i, j, j + count, i, j + count, i + count]
    points, height = corners - swarm.outline.origin, HEIGHT * swarm.outline.extent
    both = np.vstack([np.column_stack([points, np.full(count, z)]) for z in (0.0, height)])
    SubElement(
        asset, "mesh", name="object", inertia="exact", vertex=_text(*both.ravel().tolist()),
        face=" ".join(map(str, faces)),
    )  # fmt: skip


def _add_feet(body: Element, floor: Floor, swarm: Swarm) -> None:
    """Let the object stand on its feet, which touch the floor at height 0."""
    radius = THICKNESS * swarm.outline.extent
    for x, y in np.subtract(floor.feet, swarm.outline.origin).tolist():
        SubElement(
            body, "geom", type="sphere", size=_text(radius), pos=_text(x, y, radius), mass="0",
            friction=_text(floor.friction, 0.0, 0.0), rgba=_text(0.3, 0.3, 0.3, 1.0),
        )  # fmt: skip


def _add_robots(body: Element, actuators: Element, swarm: Swarm, lags: list[float]) -> None:
    """Add each robot: a site and its motors, and a rod on top, drawn from where it pushes."""
    size = swarm.outline.extent
    radius, reach, above = THICKNESS * size, 0.12 * size, HEIGHT * size
    points = (swarm.contacts - swarm.outline.origin).tolist()
    names, motors = list(swarm.names), _motors_of(swarm)
    for name, (x, y), angle, own, lag in zip(
        names, points, swarm.directions.tolist(), motors, lags, strict=True
    ):
        cos, sin = math.cos(angle), math.sin(angle)
        turned = {"zaxis": _text(cos, sin, 0.0)} if len(own) == 1 else {}
        SubElement(body, "site", turned, name=name, pos=_text(x, y, 0.0), size=_text(radius))
        SubElement(
            body, "geom", dict(UNSEEN), type="capsule", size=_text(radius), mass="0",
            fromto=_text(x - reach * cos, y - reach * sin, above, x, y, above),
            rgba=_text(0.8, 0.36, 0.0, 1.0),
        )  # fmt: skip
        for motor in own:
            if lag > 0.0:
                delay = {"dyntype": "filterexact", "dynprm": _text(lag)}
                SubElement(actuators, "general", motor, site=name, **delay)
            else:
                SubElement(actuators, "motor", motor, site=name)


def _motors_of(swarm: Swarm) -> list[list[dict[str, str]]]:
    """Return names, gears and ranges of each robot's motors; all names are different."""
    taken, found = set(swarm.names), []
    most = np.maximum(swarm.limits * np.hypot(1.0, swarm.frictions), swarm.reverse_limits)
    for name, is_line, low, high, far in zip(
        swarm.names, swarm.is_line.tolist(), swarm.lows.tolist(), swarm.limits.tolist(),
        most.tolist(), strict=True,
    ):  # fmt: skip
        if is_line:
            own = [{"name": name, "gear": "0 0 1 0 0 0", "ctrlrange": _text(low, high)}]
        else:
            own = []
            for axis, gear in (("x", "1 0 0 0 0 0"), ("y", "0 1 0 0 0 0")):
                called = f"{name} {axis}"
                while called in taken:
                    called += "'"
                own.append({"name": called, "gear": gear, "ctrlrange": _text(-far, far)})
        found.append(own)
        taken |= {motor["name"] for motor in own}
    return found


def _text(*values: float) -> str:
    """Return numbers as MJCF has them, to the last bit."""
    return " ".join(repr(float(value)).removesuffix(".0") for value in values)
