"""What must hold of robots in groups: beside the rest, what groups know of each other."""

from collections import defaultdict
from collections.abc import Mapping
from typing import Any

from swarmgrasp.agents.groups import GroupPlanner, Member, Parts, Slot, Slots
from swarmgrasp.agents.groups.member import Heard, SlotsTold, Sought, Tell, Wondered
from swarmgrasp.agents.protocol import Place, Planner, Settings
from swarmgrasp.agents.protocol import events as ev
from swarmgrasp.agents.protocol.order import in_order
from swarmgrasp.agents.protocol.planner import basis_of
from swarmgrasp.agents.simulator.checks import ROUNDING, Book, Broken
from swarmgrasp.agents.simulator.faults import Schedule
from swarmgrasp.agents.simulator.node import Node
from swarmgrasp.agents.simulator.outcome import Census
from swarmgrasp.placement import Problem


class GroupBook(Book):
    """The book of a world of groups, and the checks.

    Parameters
    ----------
    problem : Problem
    parts : Parts
    planner : Planner
    schedule : Schedule
    settings : Settings
    nodes : dict
        The robots, by name.
    """

    def __init__(
        self, problem: Problem, parts: Parts, planner: Planner, schedule: Schedule,
        settings: Settings, nodes: Mapping[str, Node],
    ) -> None:  # fmt: skip
        super().__init__(planner, schedule, settings, nodes)
        self._problem, self._parts = problem, parts
        self.members: defaultdict[int, dict[str, Node]] = defaultdict(dict)
        """Robots by their group; -1 for those that have none."""
        self._rows: dict[bytes, dict[str, Place]] = {}
        """Whom a slot counts where, by its basis."""

    # -- after every event ----------------------------------------------------------------

    def before(self, node: Node, event: Any, life: int, time: float) -> None:
        """Note what a robot is about to hear, of its own group."""
        super().before(node, _within(node, event), life, time)

    def after(self, node: Node, event: Any, effects: list[Any], time: float) -> None:
        """Check what an event has led to."""
        member = _member(node)
        inner = _within(node, event)
        if member.group != node.group:
            self._enter(node, member.group, time)
        if node.agent is None:
            return
        super().after(node, inner, effects, time)
        for effect in effects:
            if isinstance(effect, Tell) and effect.to == ev.EVERYONE:
                self._check_written(node, effect.slots)

    def _enter(self, node: Node, group: int, time: float) -> None:
        """Note that a robot goes to another group: it begins a life there."""
        self.members[node.group].pop(node.name, None)
        self.members[group][node.name] = node
        if node.group != -1:
            node.life += 1
        node.group = group
        self.pages[node.name].versions = {}
        self.begin(node, time)

    def _check_written(self, node: Node, slots: tuple[Slot, ...]) -> None:
        """Check that what a slot counts is what its writer knows, and what follows from all."""
        assert node.agent is not None
        for slot in slots:
            present = {row.id for row in self.planner.present}
            holding = in_order(node.agent.view.holding, self.planner)
            rows = [row for row in holding if row.id not in present]
            if basis_of(rows) == slot.basis:
                self._rows[slot.basis] = {row.id: row.place for row in rows}
            if slot.basis not in self._rows:
                words = f"{node.name} tells of {slot.count} robots that nobody has known so"
                raise Broken("slots are facts", words)
        self._check_bounds(node, final=False)

    def _counted(self, node: Node) -> dict[str, Place]:
        """Return whom a robot counts where: those of its group, and those of the others' slots."""
        slots = _member(node).slots
        others = [self._rows[slot.basis] for slot in slots if slot.group != node.group]
        found = super()._counted(node)
        for rows in others:
            found |= rows
        return found

    def _check_bounds(self, node: Node, *, final: bool) -> None:
        """Check the bounds that a robot knows, as long as those counted stay; at the end both."""
        slots = _member(node).slots
        there = {row.id: row.place for row in self._truth()}
        count = len(self._fixed)
        for slot in slots:
            rows = self._rows[slot.basis]
            count += len(rows)
            if any(there.get(name) != place for name, place in rows.items()):
                if final:
                    words = f"{node.name} counts {slot.count} robots in group {slot.group}"
                    raise Broken("slots are facts", f"{words}, of which some are not so")
                return
        true, (lower, upper) = self.planner.lower(self._truth()), slots.bounds()
        words = f"{node.name} bounds the quality by {lower:.9g} and {upper:.9g} N"
        if lower > true * (1.0 + ROUNDING) + ROUNDING:
            raise Broken("quality is certified", f"{words}; it is {true:.9g} N")
        if final and count != len(there):
            words = f"{node.name} counts {count} robots; {len(there)} hold the object"
            raise Broken("slots are facts", words)
        if final and upper < true * (1.0 - ROUNDING) - ROUNDING:
            raise Broken("quality is certified", f"{words}; it is {true:.9g} N")

    def _check_commit(self, node: Node, place: Place, time: float) -> None:
        """Check that nobody is too close, of another group in no case (S)."""
        for other in self.nodes.values():
            there = other.held or other.claimed
            if other.group != node.group and there and self._are_close(place, there):
                words = f"{node.name} fastens too close to {other.name}, of another group"
                raise Broken("spacing", words)
        super()._check_commit(node, place, time)

    # -- at the end -----------------------------------------------------------------------

    def different(self) -> list[set[Any]]:
        """Return what should be known alike: all slots, and each group's records."""
        running = [node for node in self.nodes.values() if node.process]
        found: list[set[Any]] = [{tuple(s.version for s in _member(n).slots) for n in running}]
        groups = self.members.values()
        return found + [{n.agent.memory.digest for n in g.values() if n.agent} for g in groups]

    def _check_maps(self, alive: list[Node]) -> None:
        """Check that all of a group know the same, and all of all groups."""
        slots, *maps = self.different()
        if len(slots) > 1:
            raise Broken("equal slots", f"{len(slots)} different things are known of all groups")
        for group, known in zip(self.members, maps, strict=True):
            if len(known) > 1:
                words = f"in group {group} {len(known)} different things are known"
                raise Broken("equal maps", words)
        for node in alive:
            self._check_bounds(node, final=True)

    def _check_records(self, alive: list[Node]) -> None:
        """Check that nobody is taken to be at its place in a group that it is not in."""
        super()._check_records([node for node in alive if node.agent])
        for words in self.ghosts():
            raise Broken("records are facts", words)

    def ghosts(self) -> list[str]:
        """Return who is taken to be at its place in a group that it is not in, as sentences."""
        running = [(node, node.agent) for node in self.nodes.values() if node.agent]
        return [
            f"{node.name} knows {record.id} to be in group {node.group}; it is elsewhere"
            for node, agent in running
            for record in agent.view.settled
            if self.nodes[record.id].group != node.group
        ]

    def _check_room(self, alive: list[Node]) -> None:
        """Check that everyone that wants a place has one, or that no group has room."""
        outside = [node for node in alive if node.wants and node.held is None]
        if not outside:
            return
        empty, truth = Slots(self._problem.swarm, self._parts), self._truth()
        for group in range(len(self._parts)):
            if GroupPlanner(self._problem, empty, group).has_room(truth):
                raise Broken(
                    "who has room comes",
                    f"{outside[0].name} is at no place, though group {group} has room",
                )

    def _check_pairs(self, alive: list[Node]) -> None:
        """Check that both of every pair that is too close have said so, within each group.

        Places of two groups are not too close; where robots miss them, nobody can tell.
        """
        for members in self.members.values():
            super()._check_pairs([node for node in alive if node.name in members])

    def _check_order(self, alive: list[Node]) -> None:
        """Check nothing: places depend on what slots said when they were chosen."""

    def census(self, time: float) -> Census:
        """Return what the swarm has come to."""
        running = [node for node in self.nodes.values() if node.process]
        slots = _member(running[0]).slots
        sent = [node.sent / time for node in self.nodes.values()]
        received = [node.received / time for node in self.nodes.values()]
        true = self.planner.lower(self._truth())
        return Census(
            slots.count, *slots.bounds(), true, sum(sent) / len(sent), max(sent),
            sum(received) / len(received),
        )  # fmt: skip


def _member(node: Node) -> Member:
    """Return a robot's process."""
    assert isinstance(node.process, Member)
    return node.process


def _within(node: Node, event: Any) -> ev.Event:
    """Return what an event is within the robot's group: time that passes, if it is of another."""
    match event:
        case Heard(group, received):
            return received if group == _member(node).group else ev.Tick()
        case SlotsTold() | Wondered() | Sought():
            return ev.Tick()
        case _:
            return event  # type: ignore[no-any-return]
