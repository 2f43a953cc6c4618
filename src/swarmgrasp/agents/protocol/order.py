"""Who goes where: everyone takes the best place given all with an earlier ticket.

Nobody waits for the claims of those before: the places of all are a function of the records, and
each robot computes them (T32, T34). What was published is used where it rests on the same robots,
so that rounding on other machines cannot split the swarm.
"""

from collections.abc import Iterable, Sequence, Set
from dataclasses import dataclass

from swarmgrasp.agents.protocol.planner import Planner, Rows, basis_of
from swarmgrasp.agents.protocol.record import Phase, Place, Plan, Record, Row

PLANNED = 6
"""Robots that are planned together at most."""
SURE = 1e-6
"""Relative difference of a plan's quality that is rounding."""


@dataclass(frozen=True)
class View:
    """The robots that a robot reckons with.

    Attributes
    ----------
    fixed : tuple of Row
        Robots of the mission that have no process of their own.
    settled : tuple of Record
        Robots at their place, by ticket.
    movers : tuple of Record
        Robots on their way, by ticket.
    doubted : frozenset of str
        Settled robots that are kept clear of and not counted.
    """

    fixed: Rows
    settled: tuple[Record, ...]
    movers: tuple[Record, ...]
    doubted: frozenset[str] = frozenset()

    def counted_before(self, order: tuple[int, str]) -> list[Row]:
        """Return the settled robots before a ticket, where they are."""
        settled = (r for r in self.settled if r.order < order and r.id not in self.doubted)
        return [*self.fixed, *map(row_of, settled)]

    def obstacles_to(self, order: tuple[int, str]) -> tuple[Place, ...]:
        """Return the places of settled robots that a ticket does not count."""
        return tuple(
            r.place
            for r in self.settled
            if r.place is not None and (r.order > order or r.id in self.doubted)
        )

    @property
    def holding(self) -> Rows:
        """All robots that hold the object and are counted."""
        holding = (r for r in self.settled if r.phase >= Phase.ATTACHED)
        return (*self.fixed, *(row_of(r) for r in holding if r.id not in self.doubted))


def view_of(
    records: Iterable[Record], present: Rows, is_forgotten: Iterable[str], doubted: Iterable[str]
) -> View:
    """Return the robots to reckon with.

    Parameters
    ----------
    records : iterable of Record
    present : tuple of Row
        The mission's own robots: those of them that have a record are as it says.
    is_forgotten : iterable of str
        Robots on their way that have not been heard for long.
    doubted : iterable of str
        Robots that are silent, if such are kept clear of and not counted.
    """
    known = list(records)
    gone = {each for record in known for each in record.gone}
    names, forgotten = {record.id for record in known}, set(is_forgotten)
    there = [r for r in known if (r.id, r.incarnation) not in gone]
    settled = sorted((r for r in there if r.is_at_its_place), key=lambda r: r.order)
    movers = (r for r in there if r.is_on_its_way and r.id not in forgotten)
    fixed = (row for row in present if row.id not in names and (row.id, 0) not in gone)
    return View(
        tuple(fixed),
        tuple(settled),
        tuple(sorted(movers, key=lambda r: r.order)),
        frozenset(doubted),
    )


def row_of(record: Record) -> Row:
    """Return a robot at its place, or where it is going."""
    assert record.place is not None
    return Row(record.id, record.ticket, record.place, record.kind)


@dataclass(frozen=True)
class Choice:
    """A robot's place by the rule, and what that rests on.

    Attributes
    ----------
    place : Place, optional
        None if there is no room.
    basis : bytes
        Digest of those before it.
    rows : tuple of Row
        Those before it, where the rule puts them.
    obstacles : tuple of Place
    plan : Plan, optional
        The joint plan that it is a part of.
    """

    place: Place | None
    basis: bytes
    rows: Rows
    obstacles: tuple[Place, ...]
    plan: Plan | None = None


def choices(
    view: View, planner: Planner, until: str, blocked: Sequence[Place] = ()
) -> dict[str, Choice]:
    """Return the places of the robots on their way, in order, up to one of them.

    Parameters
    ----------
    view : View
    planner : Planner
    until : str
        The last robot that is asked for.
    blocked : sequence of Place
        Places that this last robot has seen to be taken.
    """
    plan = best_plan(view, planner)
    planned = dict(plan.places) if plan else {}
    mark = b"" if plan is None else _mark(plan)
    found: dict[str, Choice] = {}
    placed: list[Row] = []
    for record in view.movers:
        rows = in_order([*view.counted_before(record.order), *placed], planner)
        obstacles = view.obstacles_to(record.order)
        if record.id == until:
            obstacles += tuple(blocked)
        taken = [*(row.place for row in rows), *obstacles]
        basis, place = basis_of(rows), None
        is_planned = record.id in planned
        if is_planned:
            basis = mark
        offers = [record.place if record.basis == basis else None]
        offers += [planned[record.id]] if is_planned else []
        for offer in offers:
            if offer is not None and planner.is_clear(offer, taken):
                place = offer
                break
        else:
            place = planner.place(rows, obstacles, planner.who(record))
        found[record.id] = Choice(place, basis, rows, obstacles, plan if is_planned else None)
        if place is not None:
            placed.append(Row(record.id, record.ticket, place, record.kind))
        if record.id == until:
            break
    return found


def best_plan(view: View, planner: Planner) -> Plan | None:
    """Return the joint plan that holds, of all that were published: the best, and checked.

    A plan holds while all its robots are there and those beside it are where they were.
    """
    robots = {r.id: r for r in (*view.settled, *view.movers)}
    holding: list[tuple[float, str, Plan]] = []
    for record in robots.values():
        plan = record.plan
        if plan is None or not all(name in robots for name, _ in plan.places):
            continue
        names = {name for name, _ in plan.places}
        first = min(robots[name].order for name in names)
        others = (row for row in view.counted_before(first) if row.id not in names)
        before = in_order(others, planner)
        if basis_of(before) == plan.basis:
            rows = (*before, *(_planned_row(robots[n], place) for n, place in plan.places))
            quality = planner.lower(rows)
            if quality >= plan.quality * (1.0 - SURE) > 0.0:
                holding.append((-quality, record.id, plan))
    return min(holding, key=lambda each: each[:2])[2] if holding else None


def plan_wanted(view: View, planner: Planner, first: str) -> tuple[Rows, tuple[str, ...]] | None:
    """Return beside whom and for whom a joint plan is due, if a robot is the one to make it.

    It is due while those at their place cannot close the grasp, those on their way can, and no
    plan holds that has as many robots.
    """
    movers = view.movers
    if not movers or movers[0].id != first:
        return None
    who = planner.who(movers[0])
    alike = [r for r in movers if planner.who(r) == who][:PLANNED]
    before = in_order(view.counted_before(movers[0].order), planner)
    if len(alike) < 2 or len(before) + len(alike) < planner.fewest:
        return None
    plan = best_plan(view, planner)
    if plan is not None:
        under_way = {r.id for r in movers}
        can_grow = all(name in under_way for name, _ in plan.places)
        if not can_grow or len(plan.places) >= len(alike):
            return None
    if planner.lower(before) > 0.0:
        return None
    return before, tuple(r.id for r in alike)


def is_surprised(me: Record, view: View, confirmed: Set[tuple[str, int, int]]) -> Record | None:
    """Return a robot with a later ticket that holds the object and never asked this one.

    It did not reckon with this one: they could not hear each other.
    """
    for record in view.settled:
        if record.is_fixed and record.order > me.order and record.arrived_as not in confirmed:
            return record
    return None


def cut_off_by(
    me: Record, choice: Choice, view: View, planner: Planner, blocked: Sequence[Place] = ()
) -> Record | None:
    """Return a robot with a later ticket that stands where this one should, if there is one.

    It did not reckon with this one when it went there: it had not heard of it yet.
    """
    later = [r for r in view.settled if r.order > me.order and r.place is not None]
    if not later or choice.plan is not None:
        return None
    best = planner.place(choice.rows, tuple(blocked), planner.who(me))
    if best is None:
        return None
    near = (r for r in later if r.place and not planner.is_clear(best, [r.place]))
    return next(near, None)


def conflicts_of(me: Record, view: View, planner: Planner) -> list[Record]:
    """Return who is so near to a robot at its place that it must give way.

    To one that has arrived with an earlier ticket, and to any that holds the object.
    """
    assert me.place is not None
    return [
        other
        for other in view.settled
        if other.id != me.id
        and other.place is not None
        and (other.is_fixed or other.order < me.order)
        and not planner.is_clear(me.place, [other.place])
    ]


def too_close(view: View, planner: Planner, name: str = "") -> list[tuple[Record, Record]]:
    """Return the pairs that hold the object and are nearer than the spacing, the later one last.

    Parameters
    ----------
    view : View
    planner : Planner
    name : str
        The robot that is one of each pair; "" for all pairs.
    """
    holding = [r for r in view.settled if r.phase >= Phase.ATTACHED and r.place]
    return [
        (first, second)
        for k, second in enumerate(holding)
        for first in holding[:k]
        if name in ("", first.id, second.id)
        and first.place
        and second.place
        and not planner.is_clear(first.place, [second.place])
    ]


def _mark(plan: Plan) -> bytes:
    """Return a digest of a joint plan: what a place that is part of it rests on."""
    rows = (Row(name, 0, place) for name, place in plan.places)
    return basis_of((*rows, Row(plan.basis.hex(), 0, Place(0.0, 0.0, 0.0))))


def _planned_row(record: Record, place: Place) -> Row:
    """Return a robot of a plan: where it is, if it is at its place, or where it is to go."""
    return row_of(record) if record.is_at_its_place else Row(record.id, 0, place, record.kind)


def in_order(rows: Iterable[Row], planner: Planner) -> Rows:
    """Return robots in the order in which they are reckoned, the same everywhere.

    As the mission lists them, then by ticket: as they would join one after the other.
    """
    listed = {row.id: k for k, row in enumerate(planner.present)}

    def place_in_order(row: Row) -> tuple[int, int, str]:
        at_start = listed.get(row.id, len(listed)) if row.ticket == 0 else len(listed)
        return at_start, row.ticket, row.id

    return tuple(sorted(rows, key=place_in_order))
