"""A swarm of processes on this machine, through what goes wrong, and a check of the end."""

from collections.abc import Callable, Sequence
from pathlib import Path

from swarmgrasp.agents.network.fleet import Main, Member
from swarmgrasp.agents.network.plain import place_data
from swarmgrasp.agents.network.process import steady_clock
from swarmgrasp.agents.network.stage import LEASE, Stage
from swarmgrasp.agents.protocol.planner import ProblemPlanner
from swarmgrasp.agents.protocol.record import Phase, Place, Record, Row
from swarmgrasp.words import Lengths, Unit, list_words

Say = Callable[[str], None]


class Demo(Stage):
    """Robots that join, are killed, hang, are split and heal.

    Parameters
    ----------
    file, planner, count, main, folder
        As for `Stage`.
    say : callable
        Takes the story, a sentence at a time.
    """

    def __init__(
        self, file: str, planner: ProblemPlanner, count: int, main: Main, folder: Path, say: Say
    ) -> None:
        super().__init__(file, planner, count, main, folder)
        self.say = say

    def run(self) -> list[str]:
        """Play it; return what differs from the central computation.

        Raises
        ------
        NetworkFailed
            If something that should happen does not.
        """
        with self:
            self._begin()
            self._join(self.first)
            self._kill_and_hang()
            self._split()
            return self._check()

    # -- the story ------------------------------------------------------------------------

    def _begin(self) -> None:
        """Start routers and robots, and wait until all see all."""
        begin = steady_clock()
        self.start()
        self.say(
            f"{len(self.names)} robots, each a process of its own, half of them at one router and "
            f"half at another, see each other after {steady_clock() - begin:.1f} s."
        )

    def _join(self, names: Sequence[str]) -> None:
        """Let robots come, and wait until they are attached and all know it."""
        begin = steady_clock()
        self.say(f"{list_words(names)} are asked to come, all at once.")
        self.ask(names, "join")
        self._await_attached(names)
        self.say(f"All are attached after {steady_clock() - begin:.1f} s:")
        for member in sorted((self.robot(n) for n in names), key=lambda m: m.record["ticket"]):
            self.say(f"    {_short(member.reports('fastens')[-1], 'confirmed by ', ' ')}")

    def _kill_and_hang(self) -> None:
        """Kill one process and stop another; both come back."""
        killed, hung = self.first[0], self.first[1]
        when = self.fleet.kill(killed)
        seen = self._await_seen(killed, when, "down")
        self.say(
            f"kill -9 {killed}: the others know after {1e3 * seen:.0f} ms that its process has "
            "ended. It holds the object all the same, and counts."
        )
        when = self.hang(hung)
        seen = self._await_seen(hung, when, "down", killed)
        self.say(
            f"kill -STOP {hung}: the others take it for ended after {seen:.1f} s, the lease being "
            f"{LEASE:g} s."
        )
        self.go_on(hung)
        self.go_on(killed)
        self._await_attached([killed, hung])
        everyone = set(self.names)
        self.fleet.wait(
            lambda: all(everyone - {r.name} <= r.sees for r in self.robots), "that all see all"
        )
        self.say(f"{killed} is started again and remembers where it is; {hung} goes on.")

    def _split(self) -> None:
        """Take the line between the routers away, let two come, and heal it."""
        begin = steady_clock()
        self.cut()
        self.fleet.wait(
            lambda: all(_since(r, begin, "cut") for r in self.robots), "that the line is missed"
        )
        one, other = self.late
        self.say(
            f"The line between the routers is cut. {one} and {other} are asked to come, "
            "one on each side."
        )
        self.ask(self.late, "join")
        robots = [self.robot(name) for name in self.late]
        self.fleet.wait(
            lambda: all(_waits_for_the_unheard(r) for r in robots), "that both arrive and wait"
        )
        is_same = robots[0].record["place"] == robots[1].record["place"]
        where = "the very same place" if is_same else "their places"
        self.say(f"Neither knows of the other: both are at {where}. But they wait:")
        for robot in robots:
            self.say(f"    {_short(robot.reports('waits')[-1], 'waits for ', ', ')}")
        begin = steady_clock()
        self.link()
        self._await_attached(self.late)
        self.say(f"The line is healed; {steady_clock() - begin:.1f} s later both are attached:")
        for robot in robots:
            for words in robot.reports("gives way"):
                self.say(f"    {words}")
        for robot in robots:
            self.say(f"    {robot.reports('attached')[-1]}")

    def _check(self) -> list[str]:
        """Compare what came of it with the central computation."""
        newcomers = [self.robot(name).record for name in (*self.first, *self.late)]
        newcomers.sort(key=lambda record: (record["ticket"], record["name"]))
        rows, faults = list(self.planner.present), list[str]()
        self.say("In the order of their tickets:")
        lengths = Lengths.for_extent(self.planner.problem.swarm.outline.extent)
        for record in newcomers:
            name = record["name"]
            who = self.planner.who(Record(name, 0, 0, Phase.LEFT))
            found = self.planner.place(tuple(rows), (), who)
            if found is None or place_data(found) != record["place"]:
                faults.append(f"{name} is elsewhere than one after the other would put it")
            place = Place(*(record["place"][key] for key in ("x", "y", "direction", "steers")))
            rows.append(Row(name, record["ticket"], place))
            where = lengths.point((place.x, place.y))
            self.say(f"    ticket {record['ticket']:<2}  {name:10} at {where}")
        for robot in self.robots:
            for other in self.robots:
                known = robot.heard.get(other.name)
                if robot is not other and known != other.record:
                    faults.append(f"{robot.name} knows something else of {other.name} than it says")
        quality = self.planner.lower(tuple(rows))
        told = max(self.robot(name).record["certified"] for name in self.names)
        if told != quality:
            faults.append(f"the robots certify {told:.9g} N; it is {quality:.9g} N")
        self.say(f"Quality {Unit.for_size(quality).text(quality)}, certified by the robots "
                 "themselves.")  # fmt: skip
        return faults

    # -- helpers --------------------------------------------------------------------------

    def _await_attached(self, names: Sequence[str]) -> None:
        """Wait until robots are attached, and everyone knows it."""

        def is_known() -> bool:
            records = {name: self.robot(name).record for name in names}
            return all(r.get("phase") == "attached" for r in records.values()) and all(
                robot.heard.get(name) == record
                for robot in self.robots
                for name, record in records.items()
                if name != robot.name
            )

        self.fleet.wait(is_known, f"that {list_words(names)} are attached and all know it")

    def _await_seen(self, name: str, when: float, what: str, *beside: str) -> float:
        """Wait until everyone has seen that a process ended; return how long that took [s]."""
        robots = [r for r in self.robots if r.name not in {name, *beside}]

        def times() -> list[float]:
            return [
                next((e["clock"] for e in r.told if e.get(what) == name and e["clock"] > when), 0.0)
                for r in robots
            ]

        self.fleet.wait(lambda: all(times()), f"that {name} is seen to have ended")
        return max(times()) - when


def _since(robot: Member, when: float, what: str) -> bool:
    """Tell whether a robot has told something since a time."""
    return any(what in each and each["clock"] > when for each in robot.told)


def _waits_for_the_unheard(robot: Member) -> bool:
    """Tell whether a robot is beside its place and waits for nobody whom it hears."""
    waits = robot.reports("waits")
    return robot.phase == "arrived" and bool(waits) and "(heard)" not in waits[-1]


def _short(words: str, before: str, between: str) -> str:
    """Return a sentence that ends with many robots, with the first three of them.

    Examples
    --------
    >>> _short("Ajax waits for A (heard), B, C, D, E", "waits for ", ", ")
    'Ajax waits for A (heard), B, C and 2 others'
    """
    head, _, tail = words.partition(before)
    robots = tail.split(between)
    if len(robots) <= 4:
        return words
    return f"{head}{before}{', '.join(robots[:3])} and {len(robots) - 3} others"
