"""A swarm of processes on this machine, half of it at one router and half at another."""

import signal
from collections.abc import Sequence
from pathlib import Path
from typing import Self

from swarmgrasp.agents.network.fleet import Fleet, Main, Member, ask, free_ports
from swarmgrasp.agents.protocol.planner import ProblemPlanner
from swarmgrasp.errors import AgentInvalid

NAMES = (
    "Fortuna", "Galatea", "Hector", "Iris", "Jason", "Kallisto", "Leander", "Medea", "Nereus",
    "Orion", "Pallas", "Rhea", "Selene", "Theseus", "Urania", "Zephyr",
)  # fmt: skip
LATE = 2
"""Robots that are to join while the network is split, one on each side."""
MOST = 32
LEASE = 2.0
"""After it, a process that hangs counts as ended [s]."""
TRAVEL = 2.0
"""Seconds that a stand-in takes for the length of the object."""
LINK = "link"
"""The router between the two others."""


def check_count(planner: ProblemPlanner, count: int) -> None:
    """Raise `AgentInvalid` if so many robots make no story."""
    present = len(planner.present)
    least = present + LATE + 2
    if not least <= count <= MOST:
        raise AgentInvalid(
            f"{count} robots make no demonstration; it should be {least} to {MOST}: {present} "
            f"that the scenario begins with, and {LATE + 2} or more that come"
        )


class Stage:
    """Robots of a scenario and others that come, each a process; all are ended with it.

    Parameters
    ----------
    file : str
        The scenario, as processes are told it.
    planner : ProblemPlanner
        Of its question.
    count : int
        Robots, those of the scenario among them.
    main : callable
        Runs this program with the words of a command line.
    folder : Path
        For what the robots keep from one life of their process to the next.

    Attributes
    ----------
    names : list of str
        Of all robots; `first` and `late` are those that come.

    Raises
    ------
    AgentInvalid
        If so many robots make no story.
    """

    def __init__(
        self, file: str, planner: ProblemPlanner, count: int, main: Main, folder: Path
    ) -> None:
        check_count(planner, count)
        present = [row.id for row in planner.present]
        spare = (name for name in (*NAMES, *(f"R{k}" for k in range(MOST))) if name not in present)
        comers = [next(spare) for _ in range(count - len(present))]
        self.file, self.planner, self.folder = file, planner, folder
        self.names = [*present, *comers]
        self.first, self.late = comers[:-LATE], comers[-LATE:]
        self.ends = [f"tcp/127.0.0.1:{port}" for port in free_ports(3)]
        self.fleet = Fleet(main)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.fleet.end()

    @property
    def robots(self) -> list[Member]:
        """The robots' processes."""
        return [self.fleet.members[name] for name in self.names]

    def robot(self, name: str) -> Member:
        """Return a robot's process."""
        return self.fleet.members[name]

    def others(self, robot: Member) -> set[str]:
        """Return the names of all robots but one."""
        return set(self.names) - {robot.name}

    def start(self) -> None:
        """Start routers and robots, and wait until all see all."""
        west, east, _ = self.ends
        for name, end in (("west", west), ("east", east)):
            self.fleet.start(name, "--listen", end, "--lease", LEASE)
        self._await_routers("west", "east")
        self.link()
        for name in self.names:
            self.start_robot(name)
        self.fleet.wait(
            lambda: all(self.others(r) <= r.sees for r in self.robots), "that all see all"
        )

    def start_robot(self, name: str) -> None:
        """Start a robot's process."""
        speed = self.planner.problem.swarm.outline.extent / TRAVEL
        self.fleet.start(
            name, "--mode", "client", "--connect", self._end_of(name), "--lease", LEASE,
            "--roster", ",".join(self.names), "--worth", 0,
            "--speed", f"{speed} m/s", "--fastening", 0.5,
            "--state", self.folder / f"{name}.state", "--waits", file=self.file,
        )  # fmt: skip

    def ask(self, names: Sequence[str], event: str) -> None:
        """Tell robots something, each through its own router."""
        for end in self.ends[:2]:
            ask(end, self.planner.mission, [n for n in names if self._end_of(n) == end], event)

    def link(self) -> None:
        """Start the router between the two others."""
        west, east, link = self.ends
        self.fleet.start(LINK, "--listen", link, "--connect", west, "--connect", east,
                         "--lease", LEASE)  # fmt: skip
        self._await_routers(LINK)

    def cut(self) -> float:
        """Kill the router between the two others; return when [s]."""
        return self.fleet.kill(LINK)

    @property
    def is_cut(self) -> bool:
        """Whether the two routers have no link."""
        return not self.fleet.members[LINK].process.is_alive()

    def hang(self, name: str) -> float:
        """Stop a process, which then hangs; return when [s]."""
        return self.fleet.signal(name, signal.SIGSTOP)

    def go_on(self, name: str) -> None:
        """Let a process go on that hangs, or start one again that has ended."""
        if self.robot(name).process.is_alive():
            self.fleet.signal(name, signal.SIGCONT)
        else:
            self.start_robot(name)

    def reaches(self, one: str, other: str) -> bool:
        """Tell whether there is a way between two robots: one router, or the link of both."""
        if self._end_of(one) == self._end_of(other):
            return True
        return not self.is_cut

    def _end_of(self, name: str) -> str:
        """Return the endpoint of a robot's router."""
        return self.ends[self.names.index(name) % 2]

    def _await_routers(self, *names: str) -> None:
        """Wait until routers listen."""
        routers = [self.fleet.members[name] for name in names]
        self.fleet.wait(lambda: all("router" in str(r.told[-1:]) for r in routers), "a router")
