"""Directions with a gap: the sectors of a thruster that must not blow at its neighbour (T28)."""

import math
from collections.abc import Sequence

from swarmgrasp.ranges import angles, items, shown

Sector = tuple[float, float]
"""Directions [rad], counter-clockwise from the first to the second, at most a turn apart."""
Sectors = Sequence[Sector]
SAME_ANGLE = 1e-9
"""Angle [rad] that counts as none."""
EXAMPLE = "such as [(0.4, 2.7), (3.5, 5.9)]"


def sector_faults(sectors: object) -> list[str]:
    """Return what is wrong with sectors: something that is none, or two that overlap.

    Examples
    --------
    >>> sector_faults([(0.0, 2.0), (1.0, 3.0)])
    ['sectors 1 and 2 overlap, (0.0, 2.0) and (1.0, 3.0) [rad]: say them as one']
    """
    given = items(sectors)
    if not given:
        return [f"the sectors are {shown(sectors)}; there should be one or more, {EXAMPLE} [rad]"]
    faults = [
        f"sector {k} is {shown(each)}; it should be two angles within 1e6, from and to, "
        "counter-clockwise [rad]"
        for k, each in enumerate(given, start=1)
        if len(angles(each)) != 2
    ]
    if faults:
        return faults
    turned = [_turned(*angles(each)) for each in given]
    return [
        f"sectors {j + 1} and {k + 1} overlap, {shown(given[j])} and {shown(given[k])} [rad]: "
        "say them as one"
        for k in range(len(turned))
        for j in range(k)
        if _overlap(turned[j], turned[k])
    ]


def joined(sectors: object) -> Sectors:
    """Return sectors without faults in order around, those that touch as one.

    They start within [0, 2 pi), the first of them soonest. All around is (0, 2 pi).

    Examples
    --------
    >>> joined([(2.0, 3.0), (0.5, 1.0), (1.0, 1.5)])
    ((0.5, 1.5), (2.0, 3.0))
    """
    found: list[Sector] = []
    for start, end in sorted(_turned(*angles(each)) for each in items(sectors) or ()):
        if found and start - found[-1][1] <= SAME_ANGLE:
            found[-1] = (found[-1][0], end)
        else:
            found.append((start, end))
    first, last = found[0], found[-1]
    if first[0] + math.tau - last[1] <= SAME_ANGLE:  # they touch across the x axis
        if len(found) == 1:
            return ((0.0, math.tau),)
        found = [*found[1:-1], (last[0], first[1] + math.tau)]
    return tuple(found)


def middle_of(sectors: Sectors) -> float:
    """Return the middle of the widest sector [rad], the first of several, within half a turn of 0.

    Examples
    --------
    >>> middle_of(((0.5, 1.5), (2.0, 5.0)))
    -2.7831853071795862
    """
    widest = max(end - start for start, end in sectors) - SAME_ANGLE
    start, end = next(sector for sector in sectors if sector[1] - sector[0] >= widest)
    return math.remainder(0.5 * (start + end), math.tau)


def convex_parts(sectors: Sectors) -> Sectors:
    """Return sectors of half a turn or less that make up the same directions.

    The forces of one that is wider are not convex: it is two half turns, which may overlap.

    Examples
    --------
    >>> convex_parts(((0.0, 1.0), (2.0, 6.0)))
    ((0.0, 1.0), (2.0, 5.141592653589793), (2.858407346410207, 6.0))
    """
    found: list[Sector] = []
    for start, end in sectors:
        if end - start <= math.pi + SAME_ANGLE:
            found.append((start, end))
        else:
            found += [(start, start + math.pi), (end - math.pi, end)]
    return tuple(found)


def sector_words(sector: Sector) -> str:
    """Say between which directions a sector lies, counter-clockwise.

    Examples
    --------
    >>> sector_words((math.radians(200), math.radians(400)))
    '200 to 40 deg'
    """
    start, end = (f"{round(math.degrees(angle), 1) % 360.0:g}" for angle in sector)
    return f"{start} to {end} deg" if sector[0] != sector[1] else f"{start} deg"


def _turned(start: float, end: float) -> Sector:
    """Return a sector that starts within [0, 2 pi); as it is, if it does."""
    if 0.0 <= start < math.tau and start <= end <= start + math.tau:
        return start, end
    width = (end - start) % math.tau
    if abs(end - start) > SAME_ANGLE and not SAME_ANGLE < width < math.tau - SAME_ANGLE:
        width = math.tau  # whole turns apart
    start %= math.tau
    start = start if start < math.tau else 0.0  # a negative number next to zero
    return start, start + width


def _overlap(one: Sector, other: Sector) -> bool:
    """Tell whether one of two sectors begins inside the other."""
    return any(
        (c - a) % math.tau < b - a - SAME_ANGLE for (a, b), (c, _) in ((one, other), (other, one))
    )
