"""How `swarmgrasp forces` tells what the robots do for a wrench."""

import math
from collections.abc import Collection, Sequence
from typing import Any, Final

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.cli.show.change import telling_of, xy_columns
from swarmgrasp.cli.show.held import drift_words, weather_words
from swarmgrasp.cli.show.report import Column, Mood, Report
from swarmgrasp.forces import Forces
from swarmgrasp.scenario import Scenario
from swarmgrasp.swarm import Robot, Swarm
from swarmgrasp.swarm.force_words import heading
from swarmgrasp.swarm.stance import stance
from swarmgrasp.telling import Telling
from swarmgrasp.terms import Terms
from swarmgrasp.words import digits, list_words, percent, trimmed, wrench_words

IDLE = 1e-7
"""Share that is told as none."""
FULL = 2e-6
"""Difference of two shares that counts as none: twice what the least squares may take."""
NONE = 1e-9
"""Size of a wrench, relative to one beside it, that is told as none."""
FREE: Final = {
    "fx": "the force ahead or aft",
    "fy": "the force to port or starboard",
    "tz": "the torque",
}
"""What the parts of a wrench are called."""
MOST_NAMED = 4
"""Robots that the headline names."""
MANY = 1000.0
"""Reserve beyond which nobody counts."""
AT_END = 1e-6
"""Difference of two angles [rad] that counts as none."""


def show(
    scenario: Scenario,
    found: Forces,
    terms: Terms,
    *,
    free: Collection[str] = (),
    times: float = 1.0,
    nearest: Forces | None = None,
) -> None:
    """Write the forces for one wrench for people.

    Parameters
    ----------
    scenario : Scenario
    found : Forces
    terms : Terms
    free : collection of {"fx", "fy", "tz"}
        The parts of the wrench that do not matter.
    times : float
        The multiple of the wanted wrench that they are for.
    nearest : Forces, optional
        For the wanted wrench itself, which is then out of reach.
    """
    report, swarm = Report(), found.swarm
    told = (found.wanted, found.wrench, found.load, found.wanted - found.load)
    tell = telling_of(terms, swarm, [size_of(swarm, wrench) for wrench in told])
    said, mood = _headline(scenario, found, tell, times)
    report.headline(f"{scenario.name}: {said}", mood)
    report.blank()
    facts = _missed(found, tell, free) if found.is_degraded else _made(found, tell, free, times)
    report.facts([*facts, *(_nearer(nearest, tell) if nearest is not None else [])])
    _show_robots(report, found, tell)
    report.small_print(swarm, tell, share_words(swarm, terms))


def _headline(scenario: Scenario, found: Forces, tell: Telling, times: float) -> tuple[str, Mood]:
    """Answer what was asked: what is made, or whether the load is held."""
    robots, top = tell.terms.several, share(found.largest_share)
    short = tell.force.text(found.shortfall)
    if found.load.any() and not found.wanted.any():
        weather = weather_words(scenario, found.load, tell)
        if found.is_degraded:
            drift = drift_words(found.missing, found.swarm)
            return f"not held {weather}: out of reach by {short}, {drift}", "bad"
        return f"held {weather}: busiest {_busiest(found)}, {top}", "good"
    if times < 1.0:
        if times == 0.0:
            return f"out of reach, and no part of it the same way: the {robots} push none", "bad"
        many = f"{digits(times, times, 6)} times as much the same way"
        return f"out of reach; the {robots} make {many}", "caution"
    if found.is_degraded:
        return f"out of reach by {short}", "caution"
    if not found.shares.any():
        return "no force is needed", "good"
    return f"the {robots} make it, with shares up to {top}", "good"


def share_words(swarm: Swarm, terms: Terms) -> str:
    """Say what a share is."""
    if swarm.has_rays_only:
        return f"Share: a {terms.robot}'s force as a part of its limit."
    taut = "; above a least force, a part of the way to its limit" if _has_rests(swarm) else ""
    return f"Share: a {terms.robot}'s force as a part of the largest it can exert that way{taut}."


def _has_rests(swarm: Swarm) -> bool:
    """Tell whether robots may always exert some force."""
    return bool(swarm.leasts.any() or swarm.rare.envelopes)


def _made(
    found: Forces, tell: Telling, free: Collection[str], times: float
) -> list[tuple[str, str]]:
    """Tell a wrench that is made, who pushes hardest, and how much larger it might be."""
    facts = _asked(found, tell, free, times)
    if not found.shares.any():
        return facts
    facts.append(("Largest share", f"{share(found.largest_share)}: {_hardest(found)}"))
    robots = tell.terms.several
    proof = found.certificate.sectors
    if proof is None or proof.is_best:
        facts.append(("", f"no forces of these {robots} make the wrench with a smaller one"))
    else:
        facts.append(("", "in the best choice of sectors found: there are too many to try all"))
    if found.needed < 1.0 - FULL and times == 1.0 and not _has_rests(found.swarm):
        more = 1.0 / found.needed
        many = f"up to {trimmed(more, 3)}" if more < MANY else f"more than {MANY:g}"
        said = "could make {} times what they make"
        if not found.load.any():
            said = "could make {} times this"
        elif not found.wanted.any():
            said = "could hold {} times this load"
        facts.append(("Reserve", f"the {robots} {said.format(many)}"))
    return facts


def _missed(found: Forces, tell: Telling, free: Collection[str]) -> list[tuple[str, str]]:
    """Tell a wrench that is out of reach: what is made instead, and what would be needed."""
    swarm, robots = found.swarm, tell.terms.several
    wanted = size_of(swarm, found.wanted - found.load)
    what = f"what the {robots} were to make" if found.load.any() else "it"
    short = tell.force.text(found.shortfall)
    left = f"{percent(found.shortfall / wanted)} of {what}"
    if math.isinf(found.needed):
        needed = f"no limits would be large enough: these {robots} do not push that way"
    else:
        more = found.needed - 1.0
        needed = (
            f"limits larger by {percent(more)}"
            if more < 1.0
            else f"limits {trimmed(found.needed, 3)} times as large"
        )
        needed += ", counted from the least forces" if _has_rests(swarm) else ""
    return [
        *_asked(found, tell, free),
        ("Made instead", wrench_text(swarm, found.wrench, tell, wanted)),
        ("Missing", wrench_text(swarm, found.missing, tell)),
        ("Short by", f"{short} in the metric, {left}; {_nearest(found)}"),
        ("It takes", needed),
        *([("Largest share", f"{share(found.largest_share)}: {_hardest(found)}")]
          if found.shares.any() else []),
        *([] if found.is_least_squares else
          [("", "other forces for it may have a smaller sum of squares")]),
    ]  # fmt: skip


def _nearest(found: Forces) -> str:
    """Say that no wrench is nearer, or that none nearer was found."""
    proof = found.certificate.sectors
    is_known = proof is None or proof.is_best
    return "nothing is nearer" if is_known else "nothing nearer was found"


def _nearer(nearest: Forces, tell: Telling) -> list[tuple[str, str]]:
    """Tell the wrench wanted when only a multiple of it is made, and the one nearest to it."""
    swarm = nearest.swarm
    made = wrench_text(swarm, nearest.wrench, tell, size_of(swarm, nearest.wanted - nearest.load))
    return [
        ("Wanted", wrench_text(swarm, nearest.wanted, tell)),
        ("Nearest", f"{made}; short by {tell.force.text(nearest.shortfall)}"),
    ]


def _asked(
    found: Forces, tell: Telling, free: Collection[str], times: float = 1.0
) -> list[tuple[str, str]]:
    """Tell the wrench wanted, or a multiple of it, and the environment's part of it."""
    swarm = found.swarm
    label = "Wanted" if times == 1.0 else "Made"
    facts = [(label, wrench_text(swarm, found.wanted, tell))]
    if free:
        facts.append(("", f"{list_words([FREE[part] for part in free])} may be anything"))
    if found.load.any():
        facts.append(("Load", f"{wrench_text(swarm, found.load, tell)}, on the object"))
        rest = found.wanted - found.load
        facts.append((f"By the {tell.terms.several}", wrench_text(swarm, rest, tell)))
    return facts


def wrench_text(
    swarm: Swarm, wrench: NDArray[Any] | Sequence[float], tell: Telling, beside: float = 0.0
) -> str:
    """Say what a wrench is, in numbers and in words; beside one of some size [N] it may be none."""
    if size_of(swarm, wrench) <= NONE * beside:
        return "no wrench"
    x, y, turn = tell.wrench(np.asarray(wrench).tolist(), swarm.characteristic_length)
    parts = [(x, "along x"), (y, "along y"), (turn, "of torque")]
    told = [f"{text} {way}" for text, way in parts if not text.startswith("0 ")]
    return f"{', '.join(told)}: {wrench_words(np.asarray(wrench) * swarm.scale)}"


def size_of(swarm: Swarm, wrench: NDArray[Any] | Sequence[float]) -> float:
    """Return the length of a wrench in the metric [N]."""
    return float(np.linalg.norm(np.asarray(wrench) * swarm.scale))


def share(part: float) -> str:
    """Return a share in percent.

    Examples
    --------
    >>> [share(part) for part in (0.12345, 1.0 - 1e-16, 1e-17)]
    ['12.3 %', '100 %', '0 %']
    """
    return percent(round(part, 9)) if part > IDLE else "0 %"


def _busiest(found: Forces) -> str:
    """Name the robots with the largest share, or some of them."""
    rows = np.flatnonzero(found.shares >= found.largest_share - FULL).tolist()
    names = [found.swarm.names[i] for i in rows[:MOST_NAMED]]
    more = len(rows) - len(names)
    return list_words([*names, f"{more} more"] if more else names)


def _hardest(found: Forces) -> str:
    """Name the robots with the largest share, and say where they are at the end of a sector."""
    hardest = np.flatnonzero(found.shares >= found.largest_share - FULL).tolist()
    names = [_named(found, i) for i in hardest[:8]]
    more = f" and {len(hardest) - 8} more" if len(hardest) > 8 else ""
    return ", ".join(names) + more


def _named(found: Forces, index: int) -> str:
    """Name a robot, with how it pushes if there is something to say of it."""
    said = manner(found.swarm.robots[index], float(found.directions[index]))
    return f"{found.swarm.names[index]} ({said})" if said else found.swarm.names[index]


def manner(robot: Robot, direction: float) -> str:
    """Say what there is to say of the direction [rad] of a robot's force.

    Examples
    --------
    >>> tug = Robot((0.0, 0.0), 0.5, steers=0.3)
    >>> manner(tug, 0.8), manner(tug, 0.2), manner(tug, 0.6)
    ('at its port limit', 'at its starboard limit', '')
    >>> manner(Robot((0.0, 0.0), 0.0, reverse_limit=0.6), math.pi)
    'astern'
    >>> manner(Robot((0.0, 0.0), 0.0, friction=1.0), math.pi / 4)
    'about to slip'
    """
    if robot.lever:
        turns_back = math.sin(direction) < 0.0
        return f"turning to {'port' if (robot.lever > 0.0) != turns_back else 'starboard'}"
    off = math.remainder(direction - robot.direction, math.tau)
    is_astern = robot.reverse_limit > 0.0 and abs(off) > 0.5 * math.pi
    if is_astern and not robot.steers:
        return "astern"
    if robot.friction and abs(abs(off) - math.atan(robot.friction)) <= AT_END:
        return "about to slip"
    if is_astern and robot.steers < math.pi:
        off = math.remainder(off + math.pi, math.tau)
    words = ["astern"] if is_astern and robot.steers < math.pi else []
    if robot.sectors is not None:
        ends = [math.remainder(direction - end, math.tau) for each in robot.sectors for end in each]
        return "at the end of a sector" if min(map(abs, ends)) <= AT_END else ""
    if 0.0 < robot.steers < math.pi and abs(abs(off) - robot.steers) <= AT_END:
        words.append(f"at its {'port' if off > 0.0 else 'starboard'} limit")
    return ", ".join(words)


def _show_robots(report: Report, found: Forces, tell: Telling) -> None:
    """Write the table of robots."""
    swarm, unit = found.swarm, tell.force
    if not len(swarm):
        return
    columns = [
        Column(tell.terms.robot),
        *(Column(text, is_number=True) for text in (
            f"force [{unit.name}]", "share", f"limit [{unit.name}]", tell.way,
        )),
        *xy_columns(tell),
        Column("place", is_spare=True),
    ]  # fmt: skip
    if not swarm.has_rays_only:
        columns.insert(-1, Column("how", is_spare=True))

    def row(index: int) -> list[str]:
        """Return what is told of a robot."""
        robot = swarm[swarm.names[index]]
        part, direction = float(found.shares[index]), float(found.directions[index])
        is_idle = part <= IDLE and robot.least == 0.0 and robot.envelope is None
        said = "" if is_idle else manner(robot, direction)
        where = "on board" if robot.mounted else stance(swarm.outline, robot).where
        is_other_way = "astern" in said or (robot.lever and math.sin(direction) < 0.0)
        limit = robot.reverse_limit if is_other_way else robot.limit
        return [
            robot.name, unit.number(0.0 if is_idle else float(found.forces[index])),
            share(part), unit.number(limit),
            heading(robot, tell) if is_idle or robot.lever else tell.degrees(direction),
            *tell.xy(robot.contact),
            *([] if swarm.has_rays_only else [said]), where,
        ]  # fmt: skip

    report.blank()
    report.table(columns, map(row, range(len(swarm))), "robots")
