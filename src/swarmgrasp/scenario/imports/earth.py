"""Longitudes and latitudes as metres on the plane that touches the earth at their middle."""

import math
from collections.abc import Sequence
from typing import NamedTuple

from swarmgrasp.scenario.imports.hull import Point

EQUATOR, FLATTENING = 6_378_137.0, 1.0 / 298.257223563
"""Radius [m] and flattening of the ellipsoid of WGS 84."""
_SQUARED = FLATTENING * (2.0 - FLATTENING)
NARROWEST = 6_335_000.0
"""Least radius of curvature [m] of that ellipsoid, rounded down."""


class Local(NamedTuple):
    """Points on the touching plane: x to the east, y to the north.

    Attributes
    ----------
    points : list of (float, float) [m]
    middle : (float, float) [deg]
        The longitude and latitude where it touches.
    error : float [m]
        No distance between the points is off by more.
    """

    points: list[Point]
    middle: Point
    error: float


def on_the_plane(points: Sequence[Point]) -> Local:
    """Project longitudes and latitudes [deg] along the vertical of their middle.

    A distance d on the ground within r of the middle is shortened by at most d (r / R)^2 / 2, with
    the least radius of curvature R: by how much a chord's shadow is shorter than the arc.

    Examples
    --------
    A nautical mile along a meridian at the equator is 1842.9 m:

    >>> found = on_the_plane([(0.0, 0.0), (0.0, 1.0 / 60.0)])
    >>> round(found.points[1][1] - found.points[0][1], 1), found.error < 2e-5
    (1842.9, True)
    """
    first = points[0][0]
    east = [math.remainder(x - first, 360.0) for x, _ in points]
    middle = (
        math.remainder(first + 0.5 * (min(east) + max(east)), 360.0),
        0.5 * (min(y for _, y in points) + max(y for _, y in points)),
    )
    lon, lat = map(math.radians, middle)
    origin = _in_space(lon, lat)
    found = []
    for x, y in points:
        dx, dy, dz = (
            a - b for a, b in zip(_in_space(math.radians(x), math.radians(y)), origin, strict=True)
        )
        out = math.cos(lon) * dx + math.sin(lon) * dy
        found.append(
            (
                -math.sin(lon) * dx + math.cos(lon) * dy,
                -math.sin(lat) * out + math.cos(lat) * dz,
            )
        )
    far = max(math.hypot(*point) for point in found)
    return Local(found, middle, far * (far / NARROWEST) ** 2)


def _in_space(lon: float, lat: float) -> tuple[float, float, float]:
    """Return where a longitude and latitude [rad] lie on the ellipsoid [m]."""
    radius = EQUATOR / math.sqrt(1.0 - _SQUARED * math.sin(lat) ** 2)
    return (
        radius * math.cos(lat) * math.cos(lon),
        radius * math.cos(lat) * math.sin(lon),
        radius * (1.0 - _SQUARED) * math.sin(lat),
    )
