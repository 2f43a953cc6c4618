"""The mathematics that the check of an answer needs, written anew and apart from the search."""

import math
from collections import Counter
from collections.abc import Iterator, Sequence
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

if TYPE_CHECKING:  # pydantic takes 0.1 s to import: not before it is needed
    from swarmgrasp.verify.claims import NewcomerClaim, ProblemClaim, StretchClaim, ZoneClaim

ABSOLUTE = 1e-12
"""Share of sum |b_i| that counts as rounding, and up to which a quality counts as 0."""
ANGLE = 1e-9
"""Angle [rad] that counts as none."""

Array = NDArray[np.float64]


def exact_quality(generators: Array) -> float:
    """Compute the quality (T2) in the plane across each generator.

    In that plane the generators are vectors in two dimensions and h is least at a normal to
    one of them; walking once around, sorted by angle, h changes by running sums.

    Parameters
    ----------
    generators : (n, 3) [N]
        In the metric's coordinates.

    Examples
    --------
    >>> cube = np.vstack([np.eye(3), -np.eye(3)])
    >>> exact_quality(cube)
    1.0
    """
    sizes = np.linalg.norm(generators, axis=1)
    least = math.inf
    for b, size in zip(generators, sizes, strict=True):
        if size == 0.0:
            continue
        basis = np.linalg.svd((b / size)[None, :])[2][1:]
        flat = generators @ basis.T
        lengths = np.linalg.norm(flat, axis=1)
        flip = np.where((flat[:, 1] > 0.0) | ((flat[:, 1] == 0.0) & (flat[:, 0] > 0.0)), 1.0, -1.0)
        folded = flat * flip[:, None]
        order = np.argsort(np.arctan2(folded[:, 1], folded[:, 0]))
        folded, total = folded[order], folded.sum(axis=0)
        past = np.cumsum(folded, axis=0) - folded
        spans = lengths[order] > 1e-14 * sizes[order]
        if not spans.any():
            continue
        normals = np.column_stack([-folded[:, 1], folded[:, 0]])[spans]
        normals /= np.linalg.norm(normals, axis=1)[:, None]
        width = (normals * (total - 2.0 * past[spans])).sum(axis=1)
        skew = np.abs(normals @ flat.sum(axis=0))
        least = min(least, float(0.5 * (width - skew).min()))
    zero = ABSOLUTE * float(sizes.sum())
    return least if zero < least < math.inf else 0.0


def spiral(count: int) -> Array:
    """Return unit normals (count, 3) spread evenly, on a Fibonacci spiral."""
    k = np.arange(count)
    z = 1.0 - (2.0 * k + 1.0) / count
    radius, turn = np.sqrt(1.0 - z * z), k * math.pi * (3.0 - math.sqrt(5.0))
    return np.column_stack([radius * np.cos(turn), radius * np.sin(turn), z])


def units_of(vectors: list[tuple[float, float, float]]) -> Array | None:
    """Return vectors scaled to unit length, or None if that cannot be done without loss."""
    rows = np.array(vectors)
    largest = np.abs(rows).max(axis=1, keepdims=True)
    if not (largest > 1e-100).all():
        return None
    rows = rows / largest
    return np.asarray(rows / np.linalg.norm(rows, axis=1, keepdims=True))


def crest(covector: Array, arms: Array, lo: Array, hi: Array) -> Array:
    """Return the greatest v . (F, arm x F) over unit forces in the sectors [lo, hi].

    Parameters
    ----------
    covector : (3,) or (3, m, 1) [1, 1, 1/m]
        One, or several.
    arms : (k, 2) [m, m]
    lo, hi : (k,) [rad]

    Returns
    -------
    (k,) or (m, k)
    """
    a = covector[0] - covector[2] * arms[:, 1]
    b = covector[1] + covector[2] * arms[:, 0]
    top = np.arctan2(b, a)
    turned = top + 2.0 * math.pi * np.ceil((lo - top) / (2.0 * math.pi))
    ends = np.maximum(a * np.cos(lo) + b * np.sin(lo), a * np.cos(hi) + b * np.sin(hi))
    return np.asarray(np.where(turned <= hi, np.hypot(a, b), ends))


def hull_of(points: Array) -> Array:
    """Return the corners of the hull of points (k, 2), counter-clockwise, each wrapped to the next.

    Examples
    --------
    >>> hull_of(np.array([[0, 0], [2, 0], [1, 0], [1, 1], [2, 2], [0, 2]])).tolist()
    [[0, 0], [2, 0], [2, 2], [0, 2]]
    """
    first = int(np.lexsort((points[:, 0], points[:, 1]))[0])
    found, heading = [first], 0.0
    while len(found) <= len(points):
        steps = points - points[found[-1]]
        far = np.hypot(steps[:, 0], steps[:, 1])
        turns = np.arctan2(steps[:, 1], steps[:, 0]) - heading
        turns = (turns + ANGLE) % (2.0 * math.pi) - ANGLE
        turns[far == 0.0] = math.inf
        if not turns.min() < math.inf:
            break
        least = turns <= turns.min() + 1e-15
        following = int(np.argmax(np.where(least, far, -1.0)))
        if following == first:
            break
        heading = math.atan2(steps[following, 1], steps[following, 0])
        found.append(following)
    return points[found]


def within(zone: "ZoneClaim | None", lo: float, hi: float) -> Iterator[tuple[float, float]]:
    """Yield the parts of a sector that a zone's range of directions allows."""
    if zone is None or zone.directions is None:
        yield lo, hi
        return
    first, last = zone.directions
    width = (last - first) % (2.0 * math.pi)
    if width == 0.0 and last != first:  # whole turns: any direction
        yield lo, hi
        return
    for turn in range(-2, 3):
        start = first % (2.0 * math.pi) + 2.0 * math.pi * turn
        a, b = max(start, lo), min(start + width, hi)
        if a > b + ANGLE:
            continue
        yield (a, b) if a <= b else (0.5 * (a + b),) * 2


def sides_of(
    asked: "ProblemClaim", zone: "ZoneClaim | None", inward: float
) -> Iterator[tuple[float, float]]:
    """Yield the sectors allowed at an edge, each on one side of it."""
    source = _source(asked, zone)
    free = source.attachment == "free"
    half = math.pi / 2 if free or source.half_angle is None else source.half_angle
    if asked.newcomer.friction:  # a finger pushes
        if source.attachment != "pull":
            yield from within(zone, inward, inward)
        return
    if asked.newcomer.steers and free:
        yield whole_turn(zone, inward)
        return
    for side, middle in (("push", inward), ("pull", inward + math.pi)):
        if not free and source.attachment != side:
            continue
        yield from within(zone, middle - half, middle + half)


def is_line(asked: "ProblemClaim", zone: "ZoneClaim | None") -> bool:
    """Tell whether a newcomer pulls on a line in a zone."""
    return _source(asked, zone).attachment == "pull"


def _source(asked: "ProblemClaim", zone: "ZoneClaim | None") -> "NewcomerClaim | ZoneClaim":
    """Return what says how a newcomer attaches in a zone."""
    return asked.newcomer if zone is None or zone.attachment is None else zone


def whole_turn(zone: "ZoneClaim | None", inward: float) -> tuple[float, float]:
    """Return the sector that a newcomer keeps which may exert anything a zone allows."""
    if zone is not None and zone.directions is not None:
        first, last = zone.directions
        width = (last - first) % (2.0 * math.pi)
        if width > 0.0 or last == first:
            return first, first + width
    return inward - math.pi, inward + math.pi


def covers(stretch: "StretchClaim", arc: float, perimeter: float, slack: float) -> bool:
    """Tell whether a stretch covers an arc length, its ends widened by a slack [m]."""
    length = stretch.end - stretch.start
    if length < 0.0:
        length += perimeter
    past = (arc - stretch.start + slack) % perimeter
    return past <= length + 2.0 * slack


def distance_to(point: Array, p: Array, q: Array) -> float:
    """Return the distance [m] of a point from a segment."""
    return float(np.linalg.norm(point - p - share_along(point, p, q) * (q - p)))


def share_along(point: Array, p: Array, q: Array) -> float:
    """Return how far along a segment lies its point nearest to another, within [0, 1]."""
    along = q - p
    square = float(along @ along)
    return min(max(float((point - p) @ along) / square, 0.0), 1.0) if square > 0.0 else 0.0


def turns_into(angle: float, lo: float, hi: float) -> bool:
    """Tell whether an angle lies in [lo, hi], whole turns aside."""
    turned = angle + 2.0 * math.pi * math.ceil((lo - angle) / (2.0 * math.pi))
    return lo <= turned <= hi or lo <= turned - 2.0 * math.pi <= hi


def labels_of(zones: "Sequence[ZoneClaim | None]") -> list[str]:
    """Return the zones' names; of several with one name, each with its number."""
    names = ["" if zone is None else zone.name for zone in zones]
    uses, so_far, labels = Counter(names), Counter[str](), []
    for name in names:
        so_far[name] += 1
        labels.append(f"{name} ({so_far[name]})" if name and uses[name] > 1 else name)
    return labels
