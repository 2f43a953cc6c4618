"""What must hold, whatever happens: computed from the world's own book, not from what robots think.

The book knows which message of which life of a robot another has taken in, and when that one was
awake; who holds the object where; and what each robot has said of itself.
"""

import itertools
import math
from collections.abc import Mapping
from dataclasses import dataclass, field

from swarmgrasp.agents.protocol import Phase, Place, Planner, Record, Row, Settings
from swarmgrasp.agents.protocol import events as ev
from swarmgrasp.agents.protocol.order import in_order
from swarmgrasp.agents.protocol.record import MOST_TICKET
from swarmgrasp.agents.protocol.wire import Ack, Put, Records, encode
from swarmgrasp.agents.simulator.faults import Mode, Schedule, What
from swarmgrasp.agents.simulator.node import Node

ROUNDING = 1e-9
"""Relative difference of two qualities that is rounding."""


class Broken(Exception):
    """An invariant does not hold.

    Attributes
    ----------
    invariant : str
        Which, in few words; the same for the same fault.
    words : str
        What has happened.
    """

    def __init__(self, invariant: str, words: str) -> None:
        super().__init__(f"{invariant}: {words}")
        self.invariant, self.words = invariant, words


@dataclass
class Page:
    """What the book knows of one robot.

    Attributes
    ----------
    deaf : float [s]
        Time of its own clock in which it did not listen: more than half of `silent` at a stretch.
    last : float, optional [s]
        Its own clock at its last event.
    since : float [s]
        Since when it has listened, by its clock without the time in which it was deaf.
    heard : dict
        When each other robot was heard last, by the same clock, and in which of its lives.
    versions : dict
        The newest version that it knows of each robot.
    heard_at_commit : dict
        Whom it had heard when it fastened, and in which life.
    lower : float [N]
    counted : dict
        What it certified last, and with whom where.
    is_moving : bool
        Whether it has let go to find a better place.
    arrivals : int
        How often it has arrived.
    tickets : dict
        The tickets that it knew when it arrived last.
    """

    deaf: float = 0.0
    last: float | None = None
    since: float = 0.0
    heard: dict[str, tuple[float, int]] = field(default_factory=dict)
    versions: dict[str, tuple[int, int]] = field(default_factory=dict)
    heard_at_commit: dict[str, int] = field(default_factory=dict)
    lower: float = 0.0
    counted: dict[str, Place] = field(default_factory=dict)
    is_moving: bool = False
    arrivals: int = 0
    tickets: dict[str, int] = field(default_factory=dict)


class Book:
    """The world's book, and the checks.

    Parameters
    ----------
    planner : Planner
    schedule : Schedule
    settings : Settings
    nodes : dict
        The robots, by name.
    """

    def __init__(
        self, planner: Planner, schedule: Schedule, settings: Settings, nodes: Mapping[str, Node]
    ) -> None:
        self.planner, self.schedule, self.settings = planner, schedule, settings
        self.nodes = nodes
        self.pages = {name: Page() for name in nodes}
        self.excused = 0
        self.turns = 0
        self._said: dict[tuple[str, int, int], bytes] = {}
        self._told: set[tuple[str, str, tuple[str, ...]]] = set()
        own = {row.id: row for row in planner.present}
        self._fixed = tuple(row for row in planner.present if row.id not in nodes)
        self._own = own
        is_forever = schedule.mode in {Mode.DEAD, Mode.ONE_WAY}
        self.silence_to_come = settings.forget + 2.0 * settings.beat if is_forever else 0.0
        """How long claims of those that are never heard again count [s]."""

    # -- who has heard whom ---------------------------------------------------------------

    def begin(self, node: Node, time: float) -> None:
        """Note that a process starts."""
        page = self.pages[node.name]
        page.deaf, page.last, page.heard = 0.0, None, {}
        page.since = node.clock(time)
        if not node.kept:
            page.versions = {}

    def _listened(self, node: Node, time: float) -> float:
        """Return a robot's clock without the time in which it was deaf; note it if it was."""
        page, clock = self.pages[node.name], node.clock(time)
        last = clock if page.last is None else page.last
        gap = clock - last
        if not 0.0 <= gap <= 0.5 * self.settings.silent:
            page.deaf += gap
            page.since = clock - page.deaf
        page.last = clock
        return clock - page.deaf

    def before(self, node: Node, event: ev.Event, life: int, time: float) -> None:
        """Note what a robot is about to hear."""
        now = self._listened(node, time)
        page = self.pages[node.name]
        if isinstance(event, ev.Received):
            page.heard[event.sender] = now, life
        elif isinstance(event, ev.Down) and self.nodes[event.name].process is None:
            page.heard.pop(event.name, None)  # it is told that the process has ended

    def has_heard(self, node: Node, other: Node, time: float) -> bool:
        """Tell whether a robot has heard another's present life, or has not listened for long."""
        page = self.pages[node.name]
        now, silent = node.clock(time) - page.deaf, self.settings.silent
        if now - page.since < silent - ROUNDING:
            return True
        heard, life = page.heard.get(other.name, (-math.inf, 0))
        return life == other.life and now - heard < silent - ROUNDING

    # -- after every event ----------------------------------------------------------------

    def after(self, node: Node, event: ev.Event, effects: list[ev.Effect], time: float) -> None:
        """Check what an event has led to."""
        agent, page = node.agent, self.pages[node.name]
        assert agent is not None
        if isinstance(event, ev.Received):
            match event.message:
                case Put(record) | Ack(_, record):
                    self._check_version(node, record)
                case Records(_, _, records):
                    for record in records:
                        self._check_version(node, record)
        record = agent.record
        if page.versions.get(node.name) != record.version:
            self._check_version(node, record)
            self._check_word(record)
        if record.phase is Phase.ARRIVED and record.arrival != page.arrivals:
            page.arrivals = record.arrival
            page.tickets = {each.id: each.ticket for each in agent.memory}
        for effect in effects:
            if isinstance(effect, ev.Fasten):
                self._check_commit(node, effect.place, time)
            elif isinstance(effect, ev.Loosen) and record.phase is Phase.ASKING:
                self._check_move(node, time)
            elif isinstance(effect, ev.Go):
                self.turns += 1
        if record.phase in {Phase.ATTACHED, Phase.WAITING, Phase.LEFT}:
            page.is_moving = False  # it has settled, if only for want of room, or has gone
        begins_attached = isinstance(event, ev.Start) and event.attached is not None
        if record.phase is Phase.ATTACHED and (begins_attached or isinstance(event, ev.Fastened)):
            page.lower = record.lower
            page.counted = self._counted(node)
            self._check_quality(node)

    def told(self, node: Node, what: str, about: tuple[str, ...]) -> None:
        """Note what a robot has told people."""
        self._told.add((node.name, what, about))

    def _check_version(self, node: Node, record: Record) -> None:
        """Check that what a robot knows of another never gets older."""
        assert node.agent is not None
        known, versions = node.agent.memory.get(record.id), self.pages[node.name].versions
        before, now = versions.get(record.id), known.version if known else None
        if before is not None and (now is None or now < before):
            words = f"{node.name} knew version {before} of {record.id}, and now {now}"
            raise Broken("versions never go back", words)
        if now is not None:
            versions[record.id] = now

    def _check_word(self, record: Record) -> None:
        """Check that a robot says one thing only with one version."""
        key, content = (record.id, *record.version), encode(record)
        if self._said.setdefault(key, content) != content:
            words = f"{record.id} says two things with version {record.version}"
            raise Broken("no two stories", words)

    def _are_close(self, first: Place, second: Place) -> bool:
        """Tell whether two claimed places are too close, even if both are missed."""
        missed = math.sqrt(2.0) * self.schedule.missed
        return not self.planner.is_clear(first, [_farther(first, second, 2.0 * missed)])

    def _check_commit(self, node: Node, place: Place, time: float) -> None:
        """Check that nobody is too close to where a robot fastens (S)."""
        page = self.pages[node.name]
        for row in self._fixed:
            if self._are_close(place, row.place):
                words = f"{node.name} fastens too close to {row.id}, which is there from the start"
                raise Broken("spacing", words)
        page.heard_at_commit = {
            other.name: other.life
            for other in self.nodes.values()
            if other is not node and self.has_heard(node, other, time)
        }
        for other in self.nodes.values():
            there = other.held or other.claimed
            if other is node or there is None or not self._are_close(place, there):
                continue
            theirs = self.pages[other.name].heard_at_commit
            words = f"{node.name} fastens too close to {other.name} at {time:.3f} s"
            if self.settings.roster:
                raise Broken("spacing", f"{words}, though both are on the roster")
            if other.name in page.heard_at_commit:
                raise Broken("spacing", f"{words}, though it had heard it")
            if theirs.get(node.name) == node.life:
                raise Broken("spacing", f"{words}, which had heard it when it fastened")
            self.excused += 1

    def _check_move(self, node: Node, time: float) -> None:
        """Check that nobody else that is heard is moving (R10)."""
        page = self.pages[node.name]
        for name, other in self.pages.items():
            mover = self.nodes[name]
            if (
                other.is_moving
                and mover is not node
                and mover.process is not None
                and self.has_heard(node, mover, time)
            ):
                words = f"{node.name} lets go at {time:.3f} s to move while {name} is moving"
                raise Broken("one moves at a time", words)
        page.is_moving = True

    def _counted(self, node: Node) -> dict[str, Place]:
        """Return whom a robot counts where."""
        assert node.agent is not None
        return {row.id: row.place for row in node.agent.view.holding}

    def _check_quality(self, node: Node) -> None:
        """Check a certified quality against the true one, if all that it counts are there (Q)."""
        page = self.pages[node.name]
        there = {row.id: row.place for row in self._truth()}
        if node.held is None or any(there.get(n) != place for n, place in page.counted.items()):
            return
        true = self.planner.lower(self._truth())
        if page.lower > true * (1.0 + ROUNDING) + ROUNDING:
            raise Broken(
                "quality is certified",
                f"{node.name} certifies {page.lower:.9g} N, but the robots that it counts and all "
                f"others are worth {true:.9g} N",
            )

    def _truth(self) -> tuple[Row, ...]:
        """Return all that hold the object."""
        rows = [*self._fixed]
        for node in self.nodes.values():
            if node.held is not None:
                ticket = node.agent.record.ticket if node.agent else 0
                rows.append(Row(node.name, ticket, node.held))
            elif not node.starts and node.name in self._own:
                rows.append(self._own[node.name])
        return in_order(rows, self.planner)

    # -- at the end -----------------------------------------------------------------------

    def check_end(self) -> None:
        """Check that all is as it should be once everything has come to rest."""
        alive = [node for node in self.nodes.values() if node.process is not None]
        for node in alive:
            if node.held is not None:
                self._check_quality(node)
        if self.schedule.mode is Mode.ONE_WAY:
            self._check_waiting(alive)
        else:
            self._check_maps(alive)
        self._check_records(alive)
        self._check_room(alive)
        self._check_pairs(alive)
        if self.schedule.mode is Mode.BURST and self.turns > 3 * len(alive):
            words = (
                f"{len(alive)} robots turned {self.turns} times; at most {3 * len(alive)} are due"
            )
            raise Broken("few turns", words)
        self._check_order(alive)

    def _check_waiting(self, alive: list[Node]) -> None:
        """Check that who waits for ever says for whom."""
        for node in alive:
            assert node.agent is not None
            waits = node.agent.waits_for
            if node.agent.record.asks and (node.name, "waits", waits) not in self._told:
                raise Broken("tells for whom it waits", f"{node.name} waits, and does not say why")

    def _check_maps(self, alive: list[Node]) -> None:
        """Check that all know the same."""
        for first, second in itertools.pairwise(alive):
            assert first.agent
            assert second.agent
            if first.agent.memory.digest != second.agent.memory.digest:
                raise Broken("equal maps", f"{first.name} and {second.name} know different things")

    def _check_records(self, alive: list[Node]) -> None:
        """Check that what everyone knows of who holds the object is so."""
        for node in alive:
            assert node.agent is not None
            for record in [r for r in node.agent.view.settled if r.is_fixed]:
                other = self.nodes[record.id]
                if self.schedule.mode is Mode.ONE_WAY and record.phase is Phase.FASTENING:
                    continue
                if other.held != record.place and other.process is not None:
                    words = (
                        f"{node.name} knows {record.id} at {record.place}; it is at {other.held}"
                    )
                    raise Broken("records are facts", words)
            if (node.held is not None) != node.agent.record.is_fixed:
                words = (
                    f"{node.name} is {node.agent.record.phase.name.lower()}, held at {node.held}"
                )
                raise Broken("records are facts", words)

    def _check_room(self, alive: list[Node]) -> None:
        """Check that everyone that wants a place has one, or that there is no room."""
        deaf = self.schedule.mode is Mode.ONE_WAY
        for node in alive:
            assert node.agent is not None
            record, view = node.agent.record, node.agent.view
            if record.phase is Phase.LEFT and node.wants:
                raise Broken("who has room comes", f"{node.name} was told to come and stays away")
            if record.phase is not Phase.WAITING or deaf:
                continue
            rows = in_order(view.counted_before((MOST_TICKET, "")), self.planner)
            if self.planner.place(rows, (), self.planner.who(record)) is not None:
                raise Broken(
                    "who has room comes", f"{node.name} finds no room, though there is some"
                )

    def _check_pairs(self, alive: list[Node]) -> None:
        """Check that both of every pair that is too close have said so."""
        fixed = [node for node in alive if node.held is not None]
        for k, second in enumerate(fixed):
            for first in fixed[:k]:
                assert first.held
                assert second.held
                if self.planner.is_clear(first.held, [second.held]):
                    continue
                pair = f"{first.name} and {second.name} are too close"
                if self.schedule.mode is Mode.RESOLVE:
                    raise Broken("the later of a pair moves", f"{pair} at the end")
                for name in (first.name, second.name):
                    about = {(first.name, second.name), (second.name, first.name)}
                    if not any((name, "too close", each) in self._told for each in about):
                        raise Broken("pairs are reported", f"{pair}, and {name} does not say so")

    def places(self) -> tuple[tuple[str, Place], ...]:
        """Return the robots that hold the object, in the order of their tickets."""
        there = [n for n in self.nodes.values() if n.held is not None and n.agent is not None]
        there.sort(key=lambda n: n.agent.record.order if n.agent else (0, ""))
        return tuple((n.name, n.held) for n in there if n.held is not None)

    def _check_order(self, alive: list[Node]) -> None:
        """Check that places are those of one after the other, to the last bit (E)."""
        schedule = self.schedule
        has_surprise = any(what in {"new ticket", "taken"} for _, what, _ in self._told)
        only_joins = all(each.what in {What.START, What.JOIN} for each in schedule.faults)
        is_exact = not (schedule.missed or schedule.turned or self.settings.worth)
        if not (only_joins and is_exact and not has_surprise and self._fixed_closes):
            return
        rows, before = list(self._fixed), dict[str, int]()
        for node in sorted(alive, key=lambda n: n.agent.record.order if n.agent else (0, "")):
            assert node.agent is not None
            record, known = node.agent.record, self.pages[node.name].tickets
            if node.held is not None and record.ticket and not before.items() <= known.items():
                return  # it arrived without knowing of all that are before it
            before[node.name] = record.ticket
            if record.ticket == 0:
                if node.held is not None:
                    rows.append(Row(node.name, 0, node.held))
                continue
            found = self.planner.place(in_order(rows, self.planner), (), self.planner.who(record))
            if (found) != node.held:
                words = f"{node.name} is at {node.held}; one after the other it would be at {found}"
                raise Broken("places are those of one after the other", words)
            if node.held is not None:
                rows.append(Row(node.name, record.ticket, node.held))

    @property
    def _fixed_closes(self) -> bool:
        """Whether joint plans are never due."""
        return self.planner.lower(self.planner.present) > 0.0


def _farther(first: Place, second: Place, by: float) -> Place:
    """Return the second place, farther from the first by a distance."""
    gap = math.hypot(second.x - first.x, second.y - first.y)
    if not by or not gap:
        return second
    reach = (gap + by) / gap
    x, y = (a + (b - a) * reach for a, b in ((first.x, second.x), (first.y, second.y)))
    return Place(x, y, second.direction, second.steers)
