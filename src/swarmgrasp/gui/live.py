"""Agents on the network, for the page to watch; of a demonstration it can kill and split them."""

from collections.abc import Callable
from contextlib import ExitStack, suppress
from pathlib import Path
from queue import Empty, Full, Queue
from tempfile import TemporaryDirectory
from threading import Thread
from typing import Any, Literal

from msgspec.structs import replace

from swarmgrasp.agents.network import Listener, NetworkSettings, Watch, steady_clock
from swarmgrasp.agents.network.fleet import Main
from swarmgrasp.agents.network.stage import Stage, check_count
from swarmgrasp.agents.protocol import ProblemPlanner
from swarmgrasp.errors import SwarmGraspError
from swarmgrasp.gui.figures import Figures
from swarmgrasp.gui.messages import Control
from swarmgrasp.gui.replies import Error, First, LivePhase, LiveProcess, LiveRobot, LiveTold
from swarmgrasp.gui.sending import write_message
from swarmgrasp.terms import Terms
from swarmgrasp.words import list_words

EVERY = 0.25
"""Seconds that are waited for something to be heard."""
SILENT = 3.5
"""Seconds after which a robot does not answer."""
MOST_ORDERS = 64
"""Orders that wait to be done, at most."""
PHASES: dict[str, LivePhase] = {
    "left": "left",
    "waiting": "idle",
    "coming": "coming",
    "arrived": "arrived",
    "fastening": "making fast",
    "attached": "holds",
    "asking": "leaving",
}
"""What phases are called in the page."""
HOLDING = ("holds", "leaving")
To = Literal["new", "old", "all"]
"""Whom a frame is for: those that know nothing yet, those that know the rest, or all."""
Tell = Callable[[bytes, To], None]
"""Takes a frame for those that watch."""


class Live:
    """What is known of the agents, told as it changes.

    Parameters
    ----------
    planner : ProblemPlanner
        Of their question.
    terms : Terms
        That words are told in.
    settings : NetworkSettings, optional
        Where to listen; nothing in a demonstration, which has routers of its own.
    stage : callable, optional
        Makes the demonstration, given a folder for what robots remember.
    """

    def __init__(
        self, planner: ProblemPlanner, terms: Terms, settings: NetworkSettings | None,
        stage: Callable[[Path], Stage] | None = None,
    ) -> None:  # fmt: skip
        self.planner, self.figures = planner, Figures(terms)
        self._settings, self._make_stage = settings, stage
        self._stage: Stage | None = None
        self._orders: Queue[Control] = Queue(MOST_ORDERS)
        self._rows: dict[str, LiveRobot] = {}
        self._last: LiveTold | None = None
        self._stopped: set[str] = set()
        self._thread: Thread | None = None
        self._ends = False

    @property
    def is_demonstration(self) -> bool:
        """Whether agents can be killed, hung and split."""
        return self._make_stage is not None

    def begin(self, tell: Tell) -> None:
        """Begin to listen, or tell those that have just begun to watch what is known."""
        if self._thread is None:
            self._thread = Thread(target=self._run, args=(tell,), name="live")
            self._thread.start()
        elif self._last is not None:
            whole = self._told(self._last, tuple(self._rows.values()), whole=True)
            tell(write_message(whole), "new")

    def order(self, message: Control) -> None:
        """Do something to an agent, or the network, in a demonstration; not if too much waits."""
        with suppress(Full):
            self._orders.put_nowait(message)

    def end(self) -> None:
        """End, with all agents of a demonstration."""
        self._ends = True
        if self._thread is not None:
            self._thread.join()

    # -- the thread ------------------------------------------------------------------------

    def _run(self, tell: Tell) -> None:
        """Listen to the end."""
        try:
            with ExitStack() as stack:
                for_routers = [self._settings] if self._settings is not None else []
                if self._make_stage is not None:
                    for_routers = self._open(stack, self._make_stage)
                ears = []
                for settings in for_routers:
                    listener = Listener(settings, self.planner.mission)
                    stack.callback(listener.close)
                    ears.append((listener, Watch(self.planner)))
                while not self._ends:
                    self._hear(ears)
                    self._obey(tell)
                    self._tell([watch.data(steady_clock()) for _, watch in ears], tell)
        except SwarmGraspError as error:
            tell(write_message(Error(None, error.faults[0])), "all")

    def _open(self, stack: ExitStack, make_stage: Callable[[Path], Stage]) -> list[NetworkSettings]:
        """Start the demonstration, and ask all but the last to come; return where to listen."""
        folder = Path(stack.enter_context(TemporaryDirectory()))
        self._stage = stack.enter_context(make_stage(folder))
        self._stage.start()
        self._stage.ask(self._stage.first, "join")
        return [
            NetworkSettings(mode="client", connect=(end,), name="watch")
            for end in self._stage.ends[:2]
        ]

    def _hear(self, ears: list[tuple[Listener, Watch]]) -> None:
        """Take what has been said."""
        for listener, watch in ears:
            for event in listener.events(EVERY / len(ears)):
                asked = watch.take(steady_clock(), event)
                if asked:
                    listener.ask(asked)

    def _obey(self, tell: Tell) -> None:
        """Do what was ordered."""
        while True:
            try:
                order = self._orders.get_nowait()
            except Empty:
                return
            if self._stage is not None:
                said = self._done(self._stage, order)
                if said:
                    tell(write_message(Error(order.n, said)), "all")

    def _done(self, stage: Stage, order: Control) -> str:
        """Do what was ordered, where it is not so; return why it cannot be done, or nothing."""
        name, process = order.robot, self._process(order.robot or "")
        match order.what, process:
            case "split", _ if not stage.is_cut:
                stage.cut()
            case "join", _ if stage.is_cut:
                stage.link()
            case "split" | "join", _:
                pass
            case _, None:
                return f"There is no robot {name!r} in this demonstration."
            case "kill", "runs" | "stopped":
                stage.fleet.kill(str(name))
            case "stop", "runs":
                self._stopped.add(str(name))
                stage.hang(str(name))
            case "go on", "stopped" | "ended":
                self._stopped.discard(str(name))
                stage.go_on(str(name))
            case "come" | "leave", "runs":
                stage.ask([str(name)], {"come": "join", "leave": "leave"}[order.what])
        return ""

    # -- what is told ----------------------------------------------------------------------

    def _tell(self, known: list[dict[str, Any]], tell: Tell) -> None:
        """Tell what has changed."""
        rows = {row.name: row for row in self._robots(known)}
        changed = tuple(row for row in rows.values() if self._rows.get(row.name) != row)
        quality = max((data["quality"] for data in known), default=0.0)
        certified = max((data["certified"] for data in known), default=0.0)
        conflicts = dict.fromkeys(words for data in known for words in data["conflicts"])
        told = self._frame(quality, certified, self._sides(rows), tuple(conflicts))
        before = self._last and self._told(self._last, (), whole=False)
        if changed or before is None or _untimed(before) != _untimed(told):
            self._rows, self._last = rows, told
            frame = write_message(self._told(told, changed, whole=before is None))
            tell(frame, "new" if before is None else "old")

    def _frame(
        self, quality: float, certified: float, sides: tuple[tuple[str, ...], ...],
        conflicts: tuple[str, ...],
    ) -> LiveTold:  # fmt: skip
        """Return what is told beside the rows."""
        good = quality > 0.0
        first = (
            f"Holds {self.figures.forces(quality)} every way"
            if good
            else ("Does not hold every way")
        )
        second = "nothing is certified yet"
        if certified:
            told = self.figures.forces(certified)
            second = f"{told} certified now, whatever the others do"
        if len(sides) > 1:
            second = f"out of touch: {list_words([_few(side) for side in sides])}"
        return LiveTold(
            t=steady_clock(), whole=False, first=First(first, good), second=second,
            certified=certified or None, robots=(), sides=sides, conflicts=conflicts,
            cut=None if self._stage is None else self._stage.is_cut,
        )  # fmt: skip

    @staticmethod
    def _told(told: LiveTold, rows: tuple[LiveRobot, ...], *, whole: bool) -> LiveTold:
        """Return the same with rows."""
        return replace(told, robots=rows, whole=whole)

    def _robots(self, known: list[dict[str, Any]]) -> list[LiveRobot]:
        """Return a row for each robot, of all that was heard on either side."""
        found: dict[str, list[dict[str, Any]]] = {}
        for data in known:
            for robot in data["robots"]:
                found.setdefault(robot["name"], []).append(robot)
        alone = {name for data in known for name in data["alone"]} - found.keys()
        swarm = self.planner.problem.swarm
        fixed = [
            LiveRobot(
                robot.name, "holds", robot.contact, robot.direction, robot.limit,
                confirmed=0, of=0, hears=None, deaf=(), there=True, process=None,
            )
            for robot in swarm
            if robot.name in alone
        ]  # fmt: skip
        return fixed + [self._row(name, found) for name in sorted(found)]

    def _row(self, name: str, found: dict[str, list[dict[str, Any]]]) -> LiveRobot:
        """Return one robot's row, of what is known of all."""
        told = found[name]
        last, swarm = _last(told), self.planner.problem.swarm
        phase, place = PHASES[last["phase"]], last["place"]
        there = phase in HOLDING
        silences = [one["silent"] for one in told if one["silent"] is not None]
        if not any(one["running"] for one in told) or min(silences, default=SILENT) >= SILENT:
            phase = "not answering"
        by = {one for each in told for one in each["confirmed_by"]}
        others = [other for other in found if other != name]
        deaf, process = self._deaf(name, others), self._process(name)
        limit = swarm[name].limit if name in swarm else self.planner.problem.newcomer.limit
        return LiveRobot(
            name, phase, None if place is None else (place["x"], place["y"]),
            None if place is None else place["direction"], limit, confirmed=len(by),
            of=len(others), hears=None if process is None else len(others) - len(deaf), deaf=deaf,
            there=there, process=process,
        )  # fmt: skip

    def _deaf(self, name: str, others: list[str]) -> tuple[str, ...]:
        """Return whom a robot does not hear; as far as that is known, in a demonstration."""
        if self._stage is None or name not in self._stage.names:
            return ()
        stage, hears = self._stage, self._stage.robot(name).sees
        return tuple(
            other for other in others if other not in hears or not stage.reaches(name, other)
        )

    def _process(self, name: str) -> LiveProcess | None:
        """Return what a robot's process does; known in a demonstration."""
        if self._stage is None or name not in self._stage.names:
            return None
        if not self._stage.robot(name).process.is_alive():
            return "ended"
        return "stopped" if name in self._stopped else "runs"

    def _sides(self, rows: dict[str, LiveRobot]) -> tuple[tuple[str, ...], ...]:
        """Return who is in touch with whom: of those that answer, in groups."""
        left = {name for name, row in rows.items() if row.of and row.phase != "not answering"}
        sides = []
        while left:
            side, new = set[str](), {min(left)}
            while new:
                side |= new
                new = {
                    other
                    for name in new
                    for other in left - side
                    if other not in rows[name].deaf and name not in rows[other].deaf
                }
            sides.append(tuple(sorted(side)))
            left -= side
        return tuple(sides)


def _last(told: list[dict[str, Any]]) -> dict[str, Any]:
    """Return the latest of what is known of a robot."""
    return max(told, key=lambda one: (one["incarnation"], one["sequence"]))


def _untimed(told: LiveTold) -> tuple[object, ...]:
    """Return what is told, without when."""
    return told.first, told.second, told.certified, told.sides, told.conflicts, told.cut


def _few(side: tuple[str, ...]) -> str:
    """Return who is on a side, in short."""
    return side[0] if len(side) == 1 else f"{side[0]} and {len(side) - 1} more"


def demonstration(
    file: str, planner: ProblemPlanner, count: int, main: Main
) -> Callable[[Path], Stage]:
    """Return what starts a demonstration of so many robots, given a folder.

    Raises
    ------
    AgentInvalid
        If so many make none.
    """
    check_count(planner, count)
    return lambda folder: Stage(file, planner, count, main, folder)
