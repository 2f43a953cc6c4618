"""A simulated network of robots in groups: words within a group, and slots between all."""

from collections.abc import Callable
from dataclasses import replace
from typing import Any

from swarmgrasp.agents.groups import Member, Parts
from swarmgrasp.agents.groups import member as mb
from swarmgrasp.agents.groups import slot as sl
from swarmgrasp.agents.groups.planner import check_mission
from swarmgrasp.agents.groups.seeking import decode_seeking, encode_seeking
from swarmgrasp.agents.protocol import (
    Place,
    Planner,
    ProblemPlanner,
    Settings,
    read_state,
    state_bytes,
)
from swarmgrasp.agents.protocol import events as ev
from swarmgrasp.agents.protocol.wire import decode, encode
from swarmgrasp.agents.simulator.chance import between
from swarmgrasp.agents.simulator.crowd import crowd
from swarmgrasp.agents.simulator.faults import Fault, Schedule, What
from swarmgrasp.agents.simulator.group_checks import GroupBook
from swarmgrasp.agents.simulator.node import Node, Process
from swarmgrasp.agents.simulator.outcome import Outcome
from swarmgrasp.agents.simulator.world import World
from swarmgrasp.errors import ScheduleInvalid

BEGIN = 1.0
"""Within it the processes of all that hold the object first start [s]."""

_BEGIN = 11  # what chance is drawn for; all else is in world.py


class GroupWorld(World):
    """A simulated network of robots in groups.

    Parameters
    ----------
    planner : ProblemPlanner
        Of the mission, whose own robots have no process.
    schedule : Schedule
        Of mode groups.
    settings : Settings, optional
    member : callable
        What makes a member, as `Member` does.

    Raises
    ------
    AgentInvalid
        If the mission is not for groups, or there are too many.
    ScheduleInvalid
        If robots have no room, or the name of one that the mission begins with.
    """

    book: GroupBook

    def __init__(
        self, planner: ProblemPlanner, schedule: Schedule, settings: Settings | None = None,
        member: Callable[..., Member] = Member,
    ) -> None:  # fmt: skip
        self._problem, self._make_member = planner.problem, member
        self._parts = Parts.of(
            planner.problem.swarm.outline, schedule.groups, planner.problem.spacing
        )
        check_mission(planner.problem)
        named = [row.id for row in planner.present if row.id in schedule.names]
        if named:
            raise ScheduleInvalid(f"the mission begins with {' '.join(named)}: rename them")
        self._first = crowd(planner.problem, self._parts, schedule.begin, schedule.seed)
        super().__init__(planner, schedule, settings)
        for name, place in self._first.items():
            node = self.nodes[name]
            node.held = node.claimed = place
            at = between(0.0, BEGIN, schedule.seed, node.index, _BEGIN)
            self._push(at, self._befall, Fault(What.START, at, names=(name,)))

    def run(self) -> Outcome:
        """Run until all is settled, or until an invariant breaks."""
        outcome = super().run()
        if outcome.broken:
            return outcome
        return replace(outcome, census=self.book.census(self.time))

    def _opened(self) -> GroupBook:
        """Return the world's book, empty."""
        return GroupBook(self._problem, self._parts, self.planner, self.schedule, self.settings,
                         self.nodes)  # fmt: skip

    def _maps(self) -> int:
        """Count how many different things robots know that should know the same."""
        return max(len(each) for each in self.book.different()) + len(self.book.ghosts())

    # -- processes ------------------------------------------------------------------------

    def _first_place(self, node: Node) -> Place | None:
        """Return where a robot holds the object before its process first starts, if it does."""
        return self._first.get(node.name)

    def _made(self, node: Node, incarnation: int) -> Process:
        """Return a robot's process, with what was kept for it."""
        state = None
        if node.kept:
            state = read_state(node.kept, self.planner.mission, node.name)
        return self._make_member(
            node.name, self._problem, self._parts, self.settings, incarnation=incarnation,
            group=node.group if state else -1, state=state,
        )  # fmt: skip

    def _keep(self, node: Node) -> bytes:
        """Return what a robot's process has kept for the next one: nothing without a group."""
        if node.agent is None:
            return b""
        return state_bytes(node.agent.state, self.planner.mission, node.name)

    def _peers(self, node: Node) -> list[Node]:
        """Return the other robots of its group with a process."""
        members = self.book.members.get(node.group, {})
        return [other for other in members.values() if other is not node and other.process]

    def _planner_of(self, node: Node) -> Planner:
        """Return a robot's planner: that of its group."""
        process = node.process
        assert isinstance(process, Member)
        assert process.planner is not None
        return process.planner

    # -- messages -------------------------------------------------------------------------

    def _effect(self, node: Node, effect: Any) -> None:
        """Do what a process wants done."""
        match effect:
            case mb.Within(group, ev.Send(to, message)):
                data = encode(message)
                received = ev.Received(node.name, decode(data), to != ev.EVERYONE)
                within = self.book.members.get(group, {}).values()
                others = [other for other in within if other is not node]
                self._post(node, data, self._chosen(node, others, to), mb.Heard(group, received))
            case mb.Tell(to, slots):
                data = sl.encode(slots)
                told = mb.SlotsTold(node.name, sl.decode(data))
                self._post(node, data, self._chosen(node, self._others(node), to), told)
            case mb.Look(to, message):
                data = encode_seeking(message)
                sought = mb.Sought(node.name, decode_seeking(data))
                self._post(node, data, self._chosen(node, self._others(node), to), sought)
            case mb.Wonder():
                others = self._chosen(node, self._others(node), ev.ANYONE)
                self._post(node, b"?", others, mb.Wondered(node.name))
            case _:
                super()._effect(node, effect)

    def _others(self, node: Node) -> list[Node]:
        """Return all other robots."""
        return [other for other in self.nodes.values() if other is not node]
