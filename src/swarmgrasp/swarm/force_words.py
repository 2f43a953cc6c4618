"""What a robot can exert, in words."""

import math

from swarmgrasp.swarm.robot import Newcomer, Robot
from swarmgrasp.telling import Telling
from swarmgrasp.terms import SI
from swarmgrasp.words import trimmed


def force_words(robot: Robot, tell: Telling | None = None) -> str:
    """Say how hard a robot pushes which way, as an answer is told, or in the unit that suits it.

    Examples
    --------
    >>> force_words(Robot((0, 0), math.pi / 2, 210e3, steers=math.pi / 6))
    '210 kN within 30 deg of 90 deg'
    >>> force_words(Robot((0, 0), 0.0, 51e3, reverse_limit=40e3))
    '51 kN ahead, 40 kN astern, at 0 deg'
    >>> force_words(Robot((0, 0), 0.0, 1.5, steers=math.pi))
    '1.5 N in any direction'
    >>> azimuth = Robot((0, 0), limit=90e3, sectors=[(math.pi / 9, 8 / 9 * math.pi), (3.5, 5.9)])
    >>> force_words(azimuth)
    '90 kN from 20 to 160 deg or 200.5 to 338 deg'
    >>> force_words(Robot((0, 0), limit=90e3, reverse_limit=90e3, lever=2.0, mounted=True))
    '90 kN one way, 90 kN the other, on a lever of 2.0000 m, turning to port'
    """
    tell = tell or Telling.of(SI, 1.0, [robot.limit])
    if robot.lever:
        strength = strength_words(robot, tell).replace(" ahead", " one way")
        side = "port" if robot.lever > 0.0 else "starboard"
        lever = tell.length.text(abs(robot.lever))
        return (
            f"{strength.replace(' astern', ' the other')}, on a lever of {lever}, turning to {side}"
        )
    friction = f", friction {robot.friction:.4g}" if robot.friction else ""
    comma = "," if robot.reverse_limit else ""
    return f"{strength_words(robot, tell)}{comma} {_way(robot, tell)}{friction}"


def newcomer_words(newcomer: Newcomer, tell: Telling | None = None) -> str:
    """Say how hard a newcomer pushes, which way it may, and how much of that it keeps.

    Examples
    --------
    >>> newcomer_words(Newcomer(60e3, "push", math.pi / 6, steers=True))
    '60 kN, pushing, steering within 30 deg of the normal'
    """
    way, half = f"{newcomer.attachment}ing", newcomer.half_angle
    within = f"within {90 if half is None else width(half)} deg of the normal"
    if newcomer.friction:
        said = f"pushing along the normal, friction {newcomer.friction:.4g}"
    elif newcomer.attachment == "free":
        said = "steering any way" if newcomer.steers else "pushing any way"
    else:
        said = f"{way}, steering {within}" if newcomer.steers else f"{way} {within}"
    return f"{strength_words(newcomer, tell)}, {said}{', on board' if newcomer.mounted else ''}"


def strength_words(robot: Robot | Newcomer, tell: Telling | None = None) -> str:
    """Say how hard a robot pushes, both ways if it does.

    Examples
    --------
    >>> strength_words(Robot((0, 0), 0.0, 20e3, least=2e3))
    '2 to 20 kN'
    """
    unit = (tell or Telling.of(SI, 1.0, [robot.limit])).force
    limit, other_way = (trimmed(f / unit.newtons, 5) for f in (robot.limit, robot.reverse_limit))
    if robot.reverse_limit:
        return f"{limit} {unit.name} ahead, {other_way} {unit.name} astern"
    least = robot.least / unit.newtons if isinstance(robot, Robot) else 0.0
    return f"{trimmed(least, 5)} to {limit} {unit.name}" if least else f"{limit} {unit.name}"


def _way(robot: Robot, tell: Telling) -> str:
    """Say which way a robot pushes."""
    if robot.steers >= math.pi:
        return "in any direction"
    if robot.sectors is not None:
        return f"from {' or '.join(map(tell.sector, robot.sectors))}"
    ahead = f"{'bearing ' * tell.terms.bearings}{tell.short(robot.direction)} deg"
    if robot.envelope is not None:
        return f"at most, by an envelope about {ahead}"
    return f"within {width(robot.steers)} deg of {ahead}" if robot.steers else f"at {ahead}"


def width(angle: float) -> str:
    """Return a width [rad] in degrees as text.

    Examples
    --------
    >>> width(math.pi / 6), width(1.0)
    ('30', '57.3')
    """
    return f"{math.degrees(angle):.4g}"


def heading(robot: Robot, tell: Telling) -> str:
    """Return the direction of a robot in degrees for a table; "any" or "several" if it has none."""
    if robot.sectors is not None:
        return "several"
    if robot.lever:
        return "turns"
    return "any" if robot.steers >= math.pi else tell.degrees(robot.direction)
