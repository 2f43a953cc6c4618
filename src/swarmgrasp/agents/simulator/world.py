"""A network and the bodies of its robots, in one thread, from one seed: the same run every time.

Each robot is a process that may hang or be killed, and a body that travels, fastens, lets go and
falls off. Every message is encoded and decoded. The invariants are checked after every event.
"""

import heapq
import math
from collections.abc import Callable, Sequence
from dataclasses import replace
from hashlib import blake2b
from typing import Any

from swarmgrasp.agents.protocol import (
    Agent,
    Phase,
    Place,
    Planner,
    Settings,
    State,
    read_state,
    state_bytes,
)
from swarmgrasp.agents.protocol import events as ev
from swarmgrasp.agents.protocol.record import LIVES
from swarmgrasp.agents.protocol.wire import Message, decode, encode
from swarmgrasp.agents.simulator.chance import between, mixed
from swarmgrasp.agents.simulator.checks import Book, Broken
from swarmgrasp.agents.simulator.faults import Fault, Mode, Schedule, What
from swarmgrasp.agents.simulator.links import Links
from swarmgrasp.agents.simulator.node import Node, Process
from swarmgrasp.agents.simulator.outcome import Outcome
from swarmgrasp.errors import SwarmGraspError

TRAVEL = (1.0, 8.0)
"""How long a robot travels to a place [s]."""
FASTENING = (0.2, 2.0)
"""How long it takes to fasten, or to let go [s]."""
PATIENCE = 60.0
"""How long it may take until all is settled in calm, and as many seconds more for each robot as
travelling, fastening and moving one after the other take [s]."""
QUIET = 2.0
"""For how long nothing may change before all counts as settled [s]."""
EFFORT = 10
"""Steps of a joint search for a plan."""
SOON = 1e-3
"""Shortest time between two wishes of a process to be woken [s]."""

# what chance is drawn for
_TRAVEL, _FASTEN, _MEASURE, _CLOCK, _NONCE, _KILLED, _WOKEN, _ANYONE, _WITNESS = range(1, 10)


def settings_of(schedule: Schedule) -> Settings:
    """Return how the agents of a schedule behave, as its mode asks.

    Parameters
    ----------
    schedule : Schedule
    """
    usual = Settings(forget=8.0, hold=5.0, worth=0.0 if schedule.seed % 2 else 0.02)
    match schedule.mode:
        case Mode.ROSTER:
            return replace(usual, roster=schedule.names)
        case Mode.RESOLVE:
            return replace(usual, resolve=True)
        case Mode.BURST:
            return replace(usual, worth=0.0, gather=0.2)
        case _:
            return usual


class World:
    """A simulated network.

    Parameters
    ----------
    planner : Planner
        Shared by all robots: it remembers what it was asked.
    schedule : Schedule
    settings : Settings, optional
        As the schedule's mode asks when left out.
    agent : callable
        What makes an agent, as `Agent` does.
    """

    def __init__(
        self, planner: Planner, schedule: Schedule, settings: Settings | None = None,
        agent: Callable[..., Agent] = Agent,
    ) -> None:  # fmt: skip
        self.planner, self.schedule = planner, schedule
        self.settings = settings or settings_of(schedule)
        self.time = 0.0
        self.nodes = {name: Node(name, k) for k, name in enumerate(schedule.names)}
        self.book = self._opened()
        self._make = agent
        self._queue: list[tuple[float, int, Callable[..., None], tuple[Any, ...]]] = []
        self._pushed = 0
        self._links = Links(schedule)
        self._trace = blake2b(digest_size=8)
        self.events = self.messages = self.sent = self.turns = 0
        self.reports: list[tuple[float, str]] = []
        self._changed_at = 0.0
        for node in self.nodes.values():
            node.ahead = between(0.0, 1e5, schedule.seed, node.index, _CLOCK)
            node.rate = between(0.99, 1.01, schedule.seed, node.index, _CLOCK, 1)
        for fault in schedule.faults:
            self._push(fault.at, self._befall, fault)

    def _opened(self) -> Book:
        """Return the world's book, empty."""
        return Book(self.planner, self.schedule, self.settings, self.nodes)

    def run(self) -> Outcome:
        """Run until all is settled, or until an invariant breaks."""
        broken: Broken | None = None
        try:
            self._run()
        except Broken as error:
            broken = error
        return Outcome(
            self.schedule, broken, self.events, self.messages, self.sent, self.time,
            self.book.excused, self.turns, self.book.places(), tuple(self.reports),
            self._trace.hexdigest(),
        )  # fmt: skip

    def _run(self) -> None:
        """Run, and check."""
        calm, queue = self.schedule.calm, self._queue
        latest = calm + PATIENCE + self.settings.forget
        names = {name for each in self.schedule.faults for name in each.names}
        latest += len(names) * (TRAVEL[1] + 2.0 * FASTENING[1] + self.settings.silent)
        self._push(calm, self._calm_down)
        self._push(calm + QUIET, self._look, latest)
        while queue:
            self.time, _, act, about = heapq.heappop(queue)
            act(*about)
        self.book.check_end()

    def _look(self, latest: float) -> None:
        """End the run if all is settled."""
        nodes = self.nodes.values()
        deaf = self.schedule.mode is Mode.ONE_WAY
        phases = ((n.name, n.process.record.phase) for n in nodes if n.process)
        moving = [each for each in phases if not _is_at_rest(each[1], deaf=deaf)]
        maps = self._maps()
        is_long = self.time >= self.schedule.calm + self.book.silence_to_come + QUIET
        is_quiet = self.time - self._changed_at >= QUIET
        if is_long and is_quiet and not moving and (maps <= 1 or deaf):
            self._queue.clear()
        elif self.time >= latest:
            names = ", ".join(f"{name} is {phase.name.lower()}" for name, phase in moving)
            raise Broken(
                "settles", f"at {self.time:.0f} s of calm since {self.schedule.calm:.0f} s nothing "
                f"is settled: {names or f'{maps} different maps, or turns'}"
            )  # fmt: skip
        else:
            self._push(self.time + 1.0, self._look, latest)

    def _maps(self) -> int:
        """Count how many different things robots know that should know the same."""
        return len({n.agent.memory.digest for n in self.nodes.values() if n.agent})

    def _push(self, time: float, act: Callable[..., None], *about: Any) -> None:
        """Let something happen at a time."""
        self._pushed += 1
        heapq.heappush(self._queue, (time, self._pushed, act, about))

    # -- what befalls robots --------------------------------------------------------------

    def _befall(self, fault: Fault) -> None:
        """Let a fault happen."""
        what, end = fault.what, min(fault.until, self.schedule.calm)
        node = self.nodes[fault.names[0]]
        self._trace.update(str(fault).encode())
        match what:
            case What.START:
                self._start(node)
            case What.JOIN:
                self._start(node)
                node.wants = True
                self._tell(node, ev.Join())
            case What.LEAVE:
                node.wants = False
                self._tell(node, ev.Leave())
            case What.MOVE:
                self._tell(node, ev.Move())
            case What.FALL:
                self._fall(node)
            case What.HANG if node.process:
                node.hung_until = max(node.hung_until, end)
                node.mailbox = node.mailbox or []
                self._push(end, self._wake_up, node, node.starts)
                self._push(self.time + self.settings.silent, self._lose_lease, node, node.starts)
            case What.CRASH | What.FORGET if node.process:
                self._kill(node, forgets=what is What.FORGET)
                if self.schedule.mode is not Mode.DEAD or fault.until < math.inf:
                    self._push(end, self._start, node)
            case What.CUT:
                self._cut([fault.names, fault.names[::-1]], end)
            case What.DEAF:
                self._cut([fault.names[::-1]], fault.until)
            case What.SPLIT:
                within, names = set(fault.names), self.nodes
                pairs = [(a, b) for a in names for b in names if (a in within) != (b in within)]
                self._cut(pairs, end)
            case What.JUMP:
                node.ahead += between(-50.0, 50.0, self.schedule.seed, node.index, _CLOCK, 2)
                node.tick_at = math.inf
                self._push(self.time, self._tick, node, node.starts, None)

    def _calm_down(self) -> None:
        """End all that lasts, but for what is for ever."""
        self._trace.update(b"calm")
        if self.schedule.mode is not Mode.DEAD:
            for node in self.nodes.values():
                if node.starts and node.process is None:
                    self._start(node)
        else:
            for node in self.nodes.values():
                if node.starts and node.process is None and node.held is None:
                    self._be_witnessed(node)

    def _cut(self, pairs: Sequence[tuple[str, ...]], until: float) -> None:
        """Let messages from the first to the second of each pair be lost."""
        self._links.cut(pairs)
        if until < math.inf:
            self._push(until, self._links.mend, pairs)

    # -- processes ------------------------------------------------------------------------

    def _start(self, node: Node) -> None:
        """Start a robot's process, if none runs."""
        if node.process is not None:
            return
        if not node.kept:
            node.life += 1
        place = None if node.starts else self._first_place(node)
        if place is not None:
            node.held = node.claimed = place
            node.wants = True
        number = node.starts + 1 if node.kept else 1
        node.starts += 1
        nonce = mixed(self.schedule.seed, node.index, _NONCE, node.starts) % LIVES
        node.process = self._made(node, number * LIVES + nonce)
        node.mailbox, node.hung_until, node.tick_at = None, 0.0, math.inf
        self.book.begin(node, self.time)
        self._handle(node, ev.Start(node.held))
        if node.starts > 1:  # what its owner wants may have changed meanwhile
            self._handle(node, ev.Join() if node.wants else ev.Leave())
        for other in self._peers(node):
            self._tell_soon(other, ev.Up(node.name), node)

    def _first_place(self, node: Node) -> Place | None:
        """Return where a robot holds the object before its process first starts, if it does."""
        return next((row.place for row in self.planner.present if row.id == node.name), None)

    def _made(self, node: Node, incarnation: int) -> Process:
        """Return a robot's process, with what was kept for it."""
        state: State | None = None
        if node.kept:
            state = read_state(node.kept, self.planner.mission, node.name)
        return self._make(
            node.name, self.planner, self.settings, incarnation=incarnation, state=state
        )

    def _keep(self, node: Node) -> bytes:
        """Return what a robot's process has kept for the next one."""
        assert node.agent is not None
        return state_bytes(node.agent.state, self.planner.mission, node.name)

    def _peers(self, node: Node) -> list[Node]:
        """Return the other robots with a process whom the network tells of this one's."""
        return [n for n in self.nodes.values() if n is not node and n.process]

    def _kill(self, node: Node, *, forgets: bool) -> None:
        """Kill a robot's process."""
        node.kept, peers = b"" if forgets else self._keep(node), self._peers(node)
        node.process, node.mailbox = None, None
        node.job += 1
        if node.claimed is not None and node.held is None:
            # what it was about to do is done or not, but not later
            if mixed(self.schedule.seed, node.index, _KILLED, node.starts) & 1:
                self._hold(node)
            else:
                node.claimed = None
        for other in peers:
            self._tell_soon(other, ev.Down(node.name), node)

    def _tell_soon(self, node: Node, event: ev.Event, about: Node) -> None:
        """Let the network tell of a process, if it can."""
        if not self._links.is_cut(about.name, node.name):
            self._push(self.time + SOON, self._hear_of, node, event, about, about.starts)

    def _hear_of(self, node: Node, event: ev.Event, about: Node, starts: int) -> None:
        """Take the network's word of another's process; it is not told what is no longer so."""
        if isinstance(event, ev.Down) == (about.process is None) and about.starts == starts:
            self._tell(node, event)

    def _lose_lease(self, node: Node, starts: int) -> None:
        """Let the network think that a stopped process has ended, where nothing else came in."""
        if node.starts != starts or node.mailbox is None:
            return
        for other in self._peers(node):
            if other.mailbox is None and not self.book.has_heard(other, node, self.time):
                self._handle(other, ev.Down(node.name))

    def _wake_up(self, node: Node, starts: int) -> None:
        """Let a stopped process go on: it gets all at once, in whatever order with its clock."""
        if node.starts != starts or node.mailbox is None or self.time < node.hung_until:
            return
        letters, node.mailbox = node.mailbox, None
        if mixed(self.schedule.seed, node.index, _WOKEN, node.starts) & 1:
            self._handle(node, ev.Tick())
        for event, life in letters:
            self._tell(node, event, life)
        node.tick_at = math.inf
        self._plan_tick(node)

    def _tell(self, node: Node, event: Any, life: int = 0) -> None:
        """Tell a process something, now or when it is no longer stopped."""
        if node.process is None:
            return
        if node.mailbox is not None:
            node.mailbox.append((event, life))
        else:
            self._handle(node, event, life)

    def _tick(self, node: Node, starts: int, at: float | None) -> None:
        """Wake a process, if that is still what it wants."""
        if node.process is None or node.starts != starts or node.mailbox is not None:
            return
        if at is not None:
            if at != node.tick_at:
                return
            node.tick_at = math.inf
            if node.process.wake > node.clock(self.time) + 1e-6:
                self._plan_tick(node)
                return
        self._handle(node, ev.Tick())

    def _plan_tick(self, node: Node) -> None:
        """See to it that a process is woken when it wants to be."""
        assert node.process is not None
        at = max(node.time(node.process.wake), self.time + SOON)
        if at < node.tick_at - SOON:
            node.tick_at = at
            self._push(at, self._tick, node, node.starts, at)

    def _handle(self, node: Node, event: Any, life: int = 0) -> None:
        """Let a process take an event, check, and do what it wants done.

        `life` is that of the sender when it sent, if the event is a message.
        """
        process = node.process
        assert process is not None
        self.events += 1
        self.book.before(node, event, life, self.time)
        record = process.record
        try:
            effects: list[Any] = [*process.handle(node.clock(self.time), event)]
        except (ArithmeticError, AssertionError, AttributeError, LookupError, TypeError, ValueError,
                SwarmGraspError) as error:  # fmt: skip
            words = f"{node.name} fails at {type(event).__name__}: {type(error).__name__}: {error}"
            raise Broken("nobody fails", words) from error
        if process.record is not record:
            self._changed_at = self.time
            self._trace.update(encode(process.record))
        self.book.after(node, event, effects, self.time)
        for effect in effects:
            self._effect(node, effect)
        if node.mailbox is None:
            self._plan_tick(node)

    def _effect(self, node: Node, effect: Any) -> None:
        """Do what a process wants done."""
        seed = self.schedule.seed
        match effect:
            case ev.Send(to, message):
                self._send(node, to, message)
            case ev.Go():
                node.job += 1
                self.turns += 1
                takes = between(*TRAVEL, seed, node.index, _TRAVEL, node.job)
                self._push(self.time + takes, self._arrive, node, node.job)
            case ev.Halt():
                node.job += 1
            case ev.Fasten(place):
                node.job += 1
                node.claimed = place
                takes = between(*FASTENING, seed, node.index, _FASTEN, node.job)
                self._push(self.time + takes, self._touch, node, node.job)
            case ev.Loosen():
                node.job += 1
                takes = between(*FASTENING, seed, node.index, _FASTEN, node.job)
                self._push(self.time + takes, self._let_go, node, node.job)
            case ev.MakePlan(beside, names, who):
                plan = self._planner_of(node).plan(beside, names, who)
                self._push(self.time + 0.5, self._tell_plan, node, node.starts, plan)
            case ev.Report(what, words, about):
                self.reports.append((round(self.time, 3), words))
                self.book.told(node, what, about)

    def _planner_of(self, node: Node) -> Planner:
        """Return a robot's planner."""
        del node
        return self.planner

    def _tell_plan(self, node: Node, starts: int, plan: Any) -> None:
        """Tell a process the plan that it asked for."""
        if node.starts == starts:
            self._tell(node, ev.Planned(plan))

    # -- messages -------------------------------------------------------------------------

    def _send(self, node: Node, to: str, message: Message) -> None:
        """Send a message to whom it is for."""
        data = encode(message)
        message = decode(data)
        event = ev.Received(node.name, message, to != ev.EVERYONE)
        others = [other for other in self.nodes.values() if other is not node]
        self._post(node, data, self._chosen(node, others, to), event)

    def _chosen(self, node: Node, others: list[Node], to: str) -> list[Node]:
        """Return whom a message is for, of those it can be for."""
        if to == ev.EVERYONE:
            return others
        if to != ev.ANYONE:
            return [other for other in others if other.name == to]
        running = [other for other in others if other.process]
        if not running:
            return []
        self.messages += 1
        chosen = mixed(self.schedule.seed, node.index, _ANYONE, self.messages)
        return [running[chosen % len(running)]]

    def _post(self, node: Node, data: bytes, others: list[Node], event: Any) -> None:
        """Let a message come to others: each may be lost, late, or come twice."""
        self._trace.update(data)
        self.sent += len(data) * len(others)
        node.sent += len(data) if others else 0
        for other in others:
            if other.process is not None:
                for late in self._links.carry(node, other, self.time):
                    other.received += len(data)
                    self._push(self.time + late, self._deliver, other, event, node.life)

    def _deliver(self, node: Node, event: Any, life: int) -> None:
        """Hand a message over."""
        if node.process is not None:
            self.messages += 1
            self._tell(node, event, life)

    # -- bodies ---------------------------------------------------------------------------

    def _arrive(self, node: Node, job: int) -> None:
        """Be where it was to go."""
        if node.job == job:
            self._tell(node, ev.AtPlace())

    def _touch(self, node: Node, job: int) -> None:
        """Hold the object, or see that the place is taken."""
        if node.job != job or node.claimed is None:
            return
        if self.schedule.locks and not self.planner.is_clear(
            node.claimed, [n.held for n in self.nodes.values() if n.held and n is not node]
        ):
            node.claimed = None
            self._tell(node, ev.Refused())
            return
        self._tell(node, ev.Fastened(self._hold(node)))

    def _hold(self, node: Node) -> Place:
        """Take hold of the object, near where it was claimed."""
        claimed, schedule, k = node.claimed, self.schedule, node.index
        assert claimed is not None
        node.held = claimed
        if schedule.missed or schedule.turned:
            x, y, angle = (
                value + between(-most, most, schedule.seed, k, _MEASURE, node.job, j)
                for j, (value, most) in enumerate((
                    (claimed.x, schedule.missed), (claimed.y, schedule.missed),
                    (claimed.direction, schedule.turned),
                ))
            )  # fmt: skip
            node.held = self.planner.measured(Place(x, y, angle, claimed.steers))
        self._changed_at = self.time
        return node.held

    def _let_go(self, node: Node, job: int) -> None:
        """Hold the object no longer."""
        if node.job == job and node.held is not None:
            self._lose(node)
            self._tell(node, ev.Loosened())

    def _lose(self, node: Node) -> None:
        """Be loose."""
        node.held = node.claimed = None
        self._changed_at = self.time

    def _fall(self, node: Node) -> None:
        """Fall off the object, if it holds it."""
        if node.held is None:
            return
        self._lose(node)
        node.job += 1
        if node.process is not None:
            self._tell(node, ev.Loosened())
        else:
            self._be_witnessed(node)

    def _be_witnessed(self, node: Node) -> None:
        """Let another see that a robot whose process has ended is not at the object."""
        seeing = [other for other in self._peers(node) if other.mailbox is None]
        if seeing:
            chosen = mixed(self.schedule.seed, node.index, _WITNESS, node.starts) % len(seeing)
            self._handle(seeing[chosen], ev.Witness(node.name))


def _is_at_rest(phase: Phase, *, deaf: bool) -> bool:
    """Tell whether a robot has nothing more to do; who is not heard waits for ever."""
    return phase in {Phase.LEFT, Phase.WAITING, Phase.ATTACHED} or (
        deaf and phase in {Phase.ARRIVED, Phase.ASKING}
    )
