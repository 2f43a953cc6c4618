"""Polygons as arrays: what makes one valid, its area and its centroid."""

from collections import Counter
from collections.abc import Sequence

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import OutlineInvalid
from swarmgrasp.ranges import STRONGEST, array_of, name_faults, shown


def checked_vertices(vertices: ArrayLike) -> NDArray[np.float64]:
    """Return the vertices as a fresh (k, 2) array, or raise `OutlineInvalid`."""
    found = array_of(vertices)
    if found is None:
        raise OutlineInvalid(
            f"the vertices are {shown(vertices)}; they should be a list of [x, y] pairs of numbers"
        )
    corners: NDArray[np.float64] = found
    if corners.ndim != 2 or corners.shape[1] != 2:
        raise OutlineInvalid(
            f"the vertices have shape {corners.shape}; they should be (k, 2), k at least 3"
        )
    bad = np.flatnonzero(~(np.abs(corners) <= STRONGEST).all(axis=1))
    if len(bad):
        raise OutlineInvalid(
            f"vertex {i} is ({corners[i, 0]}, {corners[i, 1]}); coordinates should be finite, of "
            f"size <= {STRONGEST:g} [m]"
            for i in bad
        )
    extent = float(np.linalg.norm(np.ptp(corners, axis=0))) if len(corners) else 0.0
    step = np.linalg.norm(np.roll(corners, -1, axis=0) - corners, axis=1)
    corners = corners[step > 1e-12 * extent]  # repeated vertices, the closing one included
    if len(corners) < 3:
        raise OutlineInvalid(
            f"the outline has {len(corners)} distinct vertices; it needs at least 3"
        )
    if np.linalg.svd(corners - corners.mean(axis=0), compute_uv=False)[1] <= 1e-9 * extent:
        raise OutlineInvalid("the vertices are collinear: the outline encloses no area")
    # shapely takes 20 ms to load and is needed for such checks alone
    from shapely import Polygon
    from shapely.validation import explain_validity

    verdict = explain_validity(Polygon(corners))
    if verdict != "Valid Geometry":
        where = verdict.partition("[")[2].rstrip("]").replace(" ", ", ")
        raise OutlineInvalid(
            f"the outline crosses or touches itself at ({where}) m: list the vertices in order "
            "around a simple polygon"
        )
    return corners


def exterior(polygon: object) -> NDArray[np.float64]:
    """Return the corners (k, 2) of a polygon of shapely, or raise `OutlineInvalid`."""
    from shapely import Polygon, get_coordinates

    if not isinstance(polygon, Polygon):
        raise OutlineInvalid(
            f"the polygon is {shown(type(polygon).__name__)}; it should be a shapely Polygon"
        )
    if polygon.interiors:
        raise OutlineInvalid(
            f"the polygon has {len(polygon.interiors)} holes; it should be its exterior alone, "
            "Polygon(polygon.exterior)"
        )
    corners: NDArray[np.float64] = get_coordinates(polygon.exterior)
    return corners


def is_simple(corners: Sequence[Sequence[float]]) -> bool:
    """Tell whether corners, in order, are a spot, a line, or a polygon that crosses nothing."""
    from shapely import Polygon

    if len(corners) < 3:
        return len(set(map(tuple, corners))) == len(corners)
    found = Polygon(corners)
    return bool(found.is_valid and found.area > 0.0)


def is_within(corners: ArrayLike, outer: ArrayLike, tolerance: float) -> bool:
    """Tell whether a spot, a line or a polygon lies in another polygon, but for a tolerance [m]."""
    from shapely import LineString, Point, Polygon

    points = np.asarray(corners, dtype=float)
    kinds = {1: lambda: Point(points[0]), 2: lambda: LineString(points)}
    inner = kinds.get(len(points), lambda: Polygon(points))()
    return bool(Polygon(np.asarray(outer)).buffer(tolerance).covers(inner))


def edge_name_faults(names: list[str], count: int) -> list[str]:
    """Return what is wrong with a list of edge names."""
    faults = []
    if len(names) != count:
        faults.append(f"there are {len(names)} edge names for {count} edges; give one per edge")
    faults += [f"edge {i}: {fault}" for i, name in enumerate(names) for fault in name_faults(name)]
    uses = Counter(name for name in names if isinstance(name, str) and name)
    return faults + [
        f"the edge name {shown(name)} is used {uses[name]} times"
        for name in sorted(uses)
        if uses[name] > 1
    ]


def signed_area(corners: NDArray[np.float64]) -> float:
    """Return the polygon's area [m^2], negative when it runs clockwise."""
    x, y = (corners - corners[0]).T
    return float(0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def centroid(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Return the centroid of a polygon's area, (2,) [m, m]."""
    local = corners - corners[0]
    following = np.roll(local, -1, axis=0)
    cross = local[:, 0] * following[:, 1] - following[:, 0] * local[:, 1]
    moment: NDArray[np.float64] = ((local + following) * cross[:, None]).sum(axis=0)
    centroid: NDArray[np.float64] = corners[0] + moment / (3.0 * cross.sum())
    return centroid


def triangles_of(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """Cut a simple polygon into triangles (k - 2, 3, 2) whose corners are its own.

    Examples
    --------
    >>> square = np.array([(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)])
    >>> [abs(signed_area(triangle)) for triangle in triangles_of(square)]
    [0.5, 0.5]
    """
    from shapely import Polygon, constrained_delaunay_triangles, get_coordinates

    found = constrained_delaunay_triangles(Polygon(corners))
    return np.array([get_coordinates(part)[:3] for part in found.geoms])


def as_point(value: ArrayLike) -> NDArray[np.float64]:
    """Return a point as a fresh array (2,); nan where it is none."""
    point = array_of(value)
    return point if point is not None and point.shape == (2,) else np.full(2, np.nan)
