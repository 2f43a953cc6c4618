"""Planning beside the records of one's own group and the summaries of all others."""

from collections.abc import Sequence
from dataclasses import replace
from functools import lru_cache

import numpy as np

from swarmgrasp.agents.groups.slot import Slot
from swarmgrasp.agents.groups.slots import BINS, Slots
from swarmgrasp.agents.knowledge.unevenness import largest_support
from swarmgrasp.agents.protocol.planner import REMEMBERED, ProblemPlanner, Rows, Who, basis_of
from swarmgrasp.agents.protocol.record import Place, Plan
from swarmgrasp.errors import AgentInvalid, NowhereToAttach
from swarmgrasp.placement import Problem
from swarmgrasp.quality import quality
from swarmgrasp.summary import Summary
from swarmgrasp.swarm import Swarm


class GroupPlanner(ProblemPlanner):
    """The planner of one group: its places along its part, its quality with all other groups.

    Places to keep clear of come from the records of the group; nobody else is near. What the others
    can do comes from their summaries; whom these leave out is not reckoned with, as if nobody were
    there (T33).

    Parameters
    ----------
    problem : Problem
        The mission, with robots and newcomers that push along one ray each, and the nominal
        quality.
    slots : Slots
        May take in more between questions.
    group : int

    Raises
    ------
    AgentInvalid
        If the mission asks for more than summaries tell.
    """

    def __init__(self, problem: Problem, slots: Slots, group: int) -> None:
        check_mission(problem)
        self.slots, self.group = slots, group
        no_go = (*problem.no_go, *slots.parts.others({group}))
        super().__init__(replace(problem, no_go=no_go))
        self._beside = lru_cache(REMEMBERED)(self._placed_beside)
        self._others = lru_cache(1)(self._summed)

    @property
    def others(self) -> Summary:
        """The summary of the other groups."""
        return self._others(self.slots.changes)

    @property
    def fewest(self) -> int:
        """Robots of the group below which the quality is 0 wherever they are."""
        return max(0, super().fewest - self.others.count)

    def place(self, rows: Rows, obstacles: tuple[Place, ...], who: Who) -> Place | None:
        """Return the best place of the group's part, clear of obstacles; None if there is none."""
        if not self.others.count:
            return super().place(rows, obstacles, who)
        return self._beside(rows, obstacles, who, self.slots.changes)

    def lower(self, rows: Rows) -> float:
        """Return the certified quality [N] of the group's robots and all other groups (T29)."""
        least, _ = self.slots.unknown(self.group)
        if not self.others.count:
            return super().lower(rows) + least
        rays, rest = self._split(rows)
        known = Summary.of(rays, BINS) + self.others
        return known.quality().lower + quality(rest).bound + least

    def has_room(self, rows: Rows) -> bool:
        """Tell whether the mission's newcomer has a place beside the group's robots."""
        try:
            self._asked(rows, (), Who()).pieces()
        except NowhereToAttach:
            return False
        return True

    def plan(self, rows: Rows, names: Sequence[str], who: Who) -> Plan | None:
        """Return places for several robots together, while there are no other groups."""
        return None if self.others.count else super().plan(rows, names, who)

    def mover(self, rows: Rows, names: Sequence[str], floor: float, gain: float) -> str:
        """Return who should move: nobody, for the quality is known of all groups only."""
        return "" if self.others.count else super().mover(rows, names, floor, gain)

    def slot(self, rows: Rows, writer: str, turn: int, sequence: int) -> Slot:
        """Return what the group tells all others of its robots.

        Parameters
        ----------
        rows : tuple of Row
            Those that hold the object, the mission's own among them, which it leaves out.
        """
        present = {row.id for row in self.present}
        own = tuple(row for row in rows if row.id not in present)
        rays, rest = self._split(own)
        return Slot(
            self.group, turn, sequence, writer, len(own), basis_of(own), self.has_room(rows),
            quality(rest).bound, largest_support(rest), Summary.of(rays, BINS).to_bytes(),
        )  # fmt: skip

    def _split(self, rows: Rows) -> tuple[Swarm, Swarm]:
        """Return the robots that push along one ray each, and the others."""
        swarm = self._swarm(rows)
        is_ray = swarm.is_ray
        rest = swarm.without_rows(np.flatnonzero(is_ray).tolist())
        return swarm.without_rows(np.flatnonzero(~is_ray).tolist()), rest

    def _summed(self, _: int) -> Summary:
        """Add up the other groups."""
        return self.slots.summary(self.group)

    def _placed_beside(
        self, rows: Rows, obstacles: tuple[Place, ...], who: Who, _: int
    ) -> Place | None:
        """Find the best place beside a summary."""
        asked = self._asked(rows, (*(row.place for row in rows), *obstacles), who)
        if not asked.newcomer.is_ray:
            return None
        rays = self._split(rows)[0]
        known, outline = Summary.of(rays, BINS) + self.others, asked.swarm.outline
        try:
            robot = known.place(outline, asked.newcomer, asked.zones, asked.no_go).robot
        except NowhereToAttach:
            return None
        return Place(*robot.contact, robot.direction)


def check_mission(problem: Problem) -> None:
    """Raise `AgentInvalid` for a mission that summaries cannot serve."""
    faults = []
    if not problem.criterion.is_nominal:
        faults.append("groups know the nominal quality only: leave out the criterion")
    if not problem.newcomer.is_ray or not problem.swarm.has_rays_only:
        faults.append(
            "groups are for robots that push along one ray each: leave out the groups, or what "
            "the robots steer, reverse or have of friction"
        )
    if faults:
        raise AgentInvalid(faults)
