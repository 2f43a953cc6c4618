"""What an agent asks of the mathematics: its place beside others, and what a swarm is worth."""

import hashlib
import math
from collections.abc import Iterable, Sequence
from dataclasses import replace
from functools import cached_property, lru_cache
from typing import NamedTuple, Protocol

import numpy as np

from swarmgrasp.agents.protocol.record import BASIS, Kind, Place, Plan, Record, Row
from swarmgrasp.agents.protocol.wire import PROTOCOL, encode
from swarmgrasp.errors import ForceSetUnsupported, NowhereToAttach, SwarmGraspError
from swarmgrasp.placement import Problem, best_move, place, place_together
from swarmgrasp.placement.pieces import SLIVER
from swarmgrasp.placement.problem import check_newcomer
from swarmgrasp.placement.together.moving import newcomer_like
from swarmgrasp.quality import Criterion, quality
from swarmgrasp.swarm import Newcomer, Robot, Swarm

REMEMBERED = 4096
"""Answers that are kept for the next question."""
EFFORT = 400
"""Steps of a joint search for a plan, unless told otherwise."""

Rows = tuple[Row, ...]


class Who(NamedTuple):
    """What robot goes somewhere.

    Attributes
    ----------
    name : str
        Of a robot that the mission begins with; "" for all others.
    kind : Kind, optional
        As in its record.
    """

    name: str = ""
    kind: Kind | None = None


class Planner(Protocol):
    """The mathematics of a mission; the same answers for the same questions everywhere."""

    @property
    def mission(self) -> str:
        """A digest of all that is the same for all robots of a mission."""

    @property
    def present(self) -> Rows:
        """The robots that the mission begins with, in order."""

    @property
    def fewest(self) -> int:
        """Robots below which the quality is 0 wherever they are."""

    def place(self, rows: Rows, obstacles: tuple[Place, ...], who: Who) -> Place | None:
        """Return the best place beside robots, clear of obstacles; None if there is no room.

        Parameters
        ----------
        rows : tuple of Row
            The robots that are reckoned with, in order.
        obstacles : tuple of Place
            Where others are, or will be, that are only kept clear of.
        who : Who
            What robot goes there.
        """

    def lower(self, rows: Rows) -> float:
        """Return the certified quality [N] of robots."""

    def is_clear(self, place: Place, others: Iterable[Place]) -> bool:
        """Tell whether a place keeps the spacing to others."""

    def measured(self, place: Place) -> Place:
        """Return the place on the object that is nearest to a measured one."""

    def who(self, record: Record) -> Who:
        """Return what robot a record is of."""

    def fault(self, record: Record) -> str:
        """Return why no robot of the mission can be what a record says; "" if one can."""

    def plan(self, rows: Rows, names: Sequence[str], who: Who) -> Plan | None:
        """Return places for several robots together, beside others; None if they are no help.

        Parameters
        ----------
        rows : tuple of Row
            The robots that they go beside, in order.
        names : sequence of str
            Of the robots that go together.
        who : Who
            What robot each of them is.
        """

    def mover(self, rows: Rows, names: Sequence[str], floor: float, gain: float) -> str:
        """Return who should move to raise the quality by a share of it; "" for nobody.

        Parameters
        ----------
        rows : tuple of Row
            The robots that hold the object, in order.
        names : sequence of str
            Of those that may move.
        floor : float [N]
            Quality below which nobody lets go.
        gain : float
            Least gain, as a share of the quality now.
        """


def basis_of(rows: Iterable[Row]) -> bytes:
    """Return a digest of robots that are reckoned with, in their order."""
    digest = hashlib.blake2b(digest_size=BASIS)
    for row in rows:
        digest.update(encode(row))
    return digest.digest()


class ProblemPlanner:
    """The planner of a placement's question.

    Parameters
    ----------
    problem : Problem
        The object, the robots attached from the start, the newcomers, zones and criterion. The
        newcomer is what a robot is that says nothing else.
    effort : int
        Steps of a joint search for a plan.

    Raises
    ------
    ForceSetUnsupported
        If it is not known how to place such a newcomer.
    """

    def __init__(self, problem: Problem, effort: int = EFFORT) -> None:
        check_newcomer(problem)
        self.problem, self._effort = problem, effort
        self._base = {robot.name: robot for robot in problem.swarm}
        self._near = SLIVER * problem.swarm.outline.extent
        self._robot = lru_cache(REMEMBERED)(self._made)
        self._places = lru_cache(REMEMBERED)(self._placed)
        self._lowers = lru_cache(REMEMBERED)(self._quality)
        self._faults = lru_cache(REMEMBERED)(self._fault)
        self._plans = lru_cache(REMEMBERED)(self._planned)

    @property
    def mission(self) -> str:
        """A digest of the question, and of the rules by which robots speak."""
        told = repr((PROTOCOL, self.problem.to_data())).encode()
        return hashlib.blake2b(told, digest_size=BASIS).hexdigest()

    @cached_property
    def present(self) -> Rows:
        """The robots that the mission begins with, in order."""
        return tuple(
            Row(robot.name, 0, Place(*robot.contact, robot.direction, robot.steers))
            for robot in self.problem.swarm
        )

    @property
    def fewest(self) -> int:
        """Robots below which the quality is 0 wherever they are."""
        return self.problem.fewest

    def place(self, rows: Rows, obstacles: tuple[Place, ...], who: Who) -> Place | None:
        """Return the best place beside robots, clear of obstacles; None if there is no room."""
        return self._places(rows, obstacles, who)

    def lower(self, rows: Rows) -> float:
        """Return the certified quality [N] of robots."""
        return self._lowers(rows)

    def is_clear(self, place: Place, others: Iterable[Place]) -> bool:
        """Tell whether a place keeps the spacing to others."""
        spacing = self.problem.spacing - self._near
        if spacing <= 0.0 or self.problem.newcomer.mounted:
            return True
        return all(math.hypot(place.x - p.x, place.y - p.y) >= spacing for p in others)

    def measured(self, place: Place) -> Place:
        """Return the place on the object that is nearest to a measured one."""
        outline = self.problem.swarm.outline
        if self.problem.newcomer.mounted:
            return place
        (distance,), (arc,) = outline.nearest((place.x, place.y))
        if distance <= outline.tolerance:
            return place  # as it was claimed, to the last digit
        x, y = outline.at_arc_length(float(arc)).point
        return Place(x, y, place.direction, place.steers)

    def who(self, record: Record) -> Who:
        """Return what robot a record is of."""
        known = record.kind is None and record.id in self._base
        return Who(record.id if known else "", record.kind)

    def fault(self, record: Record) -> str:
        """Return why no robot of the mission can be what a record says; "" if one can."""
        return self._faults(self.who(record), record.kind, record.place, record.plan)

    def _fault(self, who: Who, kind: Kind | None, place: Place | None, plan: Plan | None) -> str:
        """Find why no robot can be so."""
        places = [place] if place else []
        places += [planned for _, planned in plan.places] if plan else []
        outline = self.problem.swarm.outline
        try:
            self._newcomer(who)
            for where in places:
                robot = self._robot(Row(who.name or "it", 0, where, kind))
                if not robot.mounted:
                    outline.at_point(robot.contact)
                elif not outline.contains(robot.contact):
                    return f"({where.x:.9g}, {where.y:.9g}) m is outside the object"
        except SwarmGraspError as error:
            return error.faults[0]
        return ""

    def plan(self, rows: Rows, names: Sequence[str], who: Who) -> Plan | None:
        """Return places for several robots together, beside others; None if they are no help."""
        return self._plans(rows, tuple(names), who)

    def _planned(self, rows: Rows, names: tuple[str, ...], who: Who) -> Plan | None:
        """Find places for several robots together."""
        try:
            found = place_together(self._asked(rows, (), who), len(names), effort=self._effort)
        except SwarmGraspError:
            return None
        if not found.improves:
            return None
        places = (Place(*r.contact, r.direction, r.steers) for r in found.robots)
        planned = tuple(zip(names, places, strict=True))
        return Plan(basis_of(rows), found.quality, planned)

    def mover(self, rows: Rows, names: Sequence[str], floor: float, gain: float) -> str:
        """Return who should move to raise the quality by a share of it; "" for nobody."""
        found, asked = [], self._asked(rows, (), Who())
        for name in names:
            try:
                move = best_move(asked, robots=name).best
            except SwarmGraspError:  # it has nowhere to go, or is no robot that moves alone
                continue
            if move.quality_without >= floor and move.gain > gain * move.before.value:
                found.append((-move.quality, name))
        return min(found)[1] if found else ""

    def _made(self, row: Row) -> Robot:
        """Return a robot."""
        place, contact = row.place, (row.place.x, row.place.y)
        known = self._base.get(row.id)
        if known is not None and row.kind is None:
            steers = place.steers if known.steers else 0.0
            return replace(known, contact=contact, direction=place.direction, steers=steers)
        newcomer = self._newcomer(Who("", row.kind))
        return Robot(
            contact, place.direction, newcomer.limit, row.id, newcomer.mounted, newcomer.tolerance,
            newcomer.reverse_limit, place.steers, newcomer.friction, body=newcomer.body,
        )  # fmt: skip

    def _newcomer(self, who: Who) -> Newcomer:
        """Return what robot goes somewhere, as a newcomer."""
        usual, kind = self.problem.newcomer, who.kind
        if who.name:
            return newcomer_like(self.problem, self._base[who.name])
        if kind is None:
            return usual
        return replace(
            usual, limit=kind.limit, attachment=kind.attachment, half_angle=kind.half_angle,
            steers=kind.steers, reverse_limit=kind.reverse_limit, friction=kind.friction,
        )  # fmt: skip

    def _swarm(self, rows: Rows) -> Swarm:
        """Return robots as a swarm."""
        swarm = self.problem.swarm
        robots = [self._robot(row) for row in rows]
        return Swarm(swarm.outline, robots, swarm.characteristic_length, swarm.force_weights)

    def _asked(self, rows: Rows, obstacles: tuple[Place, ...], who: Who) -> Problem:
        """Return the question where a robot goes."""
        problem, swarm = self.problem, self._swarm(rows)
        there = np.array([(place.x, place.y) for place in obstacles]).reshape(-1, 2)
        near = swarm.outline.stretches_near(there, problem.spacing)
        return replace(
            problem, swarm=swarm, newcomer=self._newcomer(who), no_go=(*problem.no_go, *near),
            criterion=self._criterion(swarm),
        )  # fmt: skip

    def _criterion(self, swarm: Swarm) -> Criterion:
        """Return the criterion, without failures of robots that are not there."""
        criterion = self.problem.criterion
        if not criterion.failures:
            return criterion
        there = {robot.name for robot in swarm} | {robot.group for robot in swarm}
        failures = (tuple(n for n in each if n in there) for each in criterion.failures)
        return replace(criterion, failures=tuple(each for each in failures if each))

    def _placed(self, rows: Rows, obstacles: tuple[Place, ...], who: Who) -> Place | None:
        """Find the best place."""
        try:
            found = place(self._asked(rows, obstacles, who))
        except (NowhereToAttach, ForceSetUnsupported):  # the latter of a robot of the mission
            return None
        robot = found.robot
        return Place(*robot.contact, robot.direction, robot.steers)

    def _quality(self, rows: Rows) -> float:
        """Return the certified quality [N] of robots."""
        swarm = self._swarm(rows)
        return quality(swarm, **self._criterion(swarm).keywords).bound
