"""`swarmgrasp agent`: one robot that decides for itself, or a router between such robots."""

import json as text
import sys
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from threading import Thread
from typing import TYPE_CHECKING, Annotated, Any, Literal

from cyclopts import Parameter

from swarmgrasp.cli.amounts import Amount
from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.inputs import UsageFault, blaming, noting, read_scenario
from swarmgrasp.cli.lasting import end_on_signals, say
from swarmgrasp.files import target_faults
from swarmgrasp.texts import clean

if TYPE_CHECKING:
    from swarmgrasp.agents.network import NetworkSettings, Process, Transport
    from swarmgrasp.agents.network.body import Body
    from swarmgrasp.agents.protocol import Kind, Place, ProblemPlanner, Settings, State
    from swarmgrasp.terms import Terms

BEATS = 3.5
"""Signs of life within the time after which a robot counts as silent."""
SHORTEST = 0.1
"""The shortest such time [s], and lease."""
ASTRAY = 0.05
"""How far from the object a robot may be told to hold it, in extents: what a measurement may miss
it by, but no other unit or frame."""
FARTHEST = 1e9
"""Coordinates [m] that may be told."""
Flag = Annotated[bool, Parameter(negative="")]
Time = Annotated[str, Parameter(metavar="TIME")]


def agent(
    file: Dashed | None = None,
    /,
    *,
    name: str | None = None,
    router: Flag = False,
    mode: Literal["peer", "client"] | None = None,
    listen: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    connect: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    lease: Time = "3",
    tls: Path | None = None,
    state: Path | None = None,
    roster: str | None = None,
    limit: Annotated[str | None, Parameter(metavar="FORCE")] = None,
    body: Literal["stand-in", "stdio", "zenoh"] = "stand-in",
    speed: Annotated[str, Parameter(metavar="SPEED")] = "1 m/s",
    fastening: Time = "1",
    attached_at: Annotated[
        tuple[str, str, str] | None,
        Parameter(metavar="X Y DIRECTION", negative="", allow_leading_hyphen=True),
    ] = None,
    waits: Flag = False,
    silent: Time = "3.5",
    worth: float = 0.02,
    resolve: Flag = False,
    json: Flag = False,
) -> None:
    """Be one robot that decides for itself among others on the network.

    It finds its place, goes there, attaches once all that are heard have confirmed it, and
    says what it does. Ended by a signal, it leaves if it does not hold the object yet; if it
    does, it stays attached, and the others go on counting it.

    Numbers without a unit are in the file's, angles in degrees, times in seconds.

    Example: swarmgrasp agent deck-barge --name Fortuna

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example such as deck-barge; the
        same for all robots. A router needs none.
    name
        The robot's. One of the scenario's own starts attached at its place.
    router
        Be a router between robots, which are its clients, instead of a robot.
    mode
        Connect to others, each to each (peer), or to a router (client); peer unless given, and
        client with --tls.
    listen
        Endpoints for others, as tcp/127.0.0.1:7447; on this machine alone unless given.
    connect
        Endpoints of others.
    lease
        After which a process that hangs counts as ended; at most --silent.
    tls
        Folder with certificates, which `swarmgrasp agents keys` makes: of a router, and of each
        robot, by its name.
    state
        File that keeps what it knows from one life of its process to the next.
    roster
        Robots, parted by commas, each of which must confirm before it attaches, heard or not.
    limit
        Its largest force, such as 300kN, where it differs from the scenario's newcomer.
    body
        A stand-in that travels by itself, or a real robot whose own software reads orders and
        tells events, as lines of JSON on standard output and input, or as samples on the network.
    speed
        Of the stand-in.
    fastening
        How long the stand-in takes to fasten, and to let go.
    attached_at
        Where it holds the object at the start, as its process may have ended without a state: its
        contact and the direction of its force, in the file's frame.
    waits
        Do not join until told to, by the event "join".
    silent
        After which others that are not heard are not waited for; signs of life come 3.5 times as
        often. With a hundred robots on one machine take 16, and a lease of 10.
    worth
        Share by which another place must be better before it turns to it on its way.
    resolve
        Let go and come anew if it holds the object too close to another that came first.
    json
        Print lines of JSON instead of sentences: reports, orders, and what is heard.
    """
    from swarmgrasp.packages import check_installed

    check_installed("msgspec", "zenoh", purpose="A robot on the network")
    from swarmgrasp.agents.network import NetworkSettings

    faults = [] if state is None else target_faults(state)
    lasts = _times(faults, lease=lease, silent=silent, fastening=fastening)

    def network() -> NetworkSettings:
        return NetworkSettings(
            mode="router" if router else mode or ("client" if tls else "peer"),
            listen=listen, connect=connect, lease=lasts["lease"], tls=tls,
            name="router" if router else name or "",
        )  # fmt: skip

    if router:
        given = [word for word, there in (("FILE", file), ("--name", name), ("--mode", mode),
                 ("--state", state), ("--roster", roster)) if there]  # fmt: skip
        if given:
            raise UsageFault(f"a router is no robot; leave out {' and '.join(given)}")
        with noting(faults):
            here = network()
        if faults:
            raise UsageFault(faults)
        _be_router(here, json)
        return
    if file is None or not name:
        raise UsageFault("a robot needs FILE and --name; --router makes a router instead")
    from swarmgrasp.agents.protocol import ProblemPlanner

    with noting(faults):
        here = network()
    settings = _settings(lasts, worth, roster, resolve, faults)
    with noting(faults):
        scenario = read_scenario(file)
        with blaming(file):
            planner = ProblemPlanner(scenario.problem())
        kind = _kind(planner, limit, scenario.terms, faults)
        attached = _place(planner, attached_at, scenario.terms, faults)
        fast = 1.0
        with noting(faults):
            fast = Amount("--speed", speed, "speed").value(scenario.terms)
        if body == "stand-in":
            _body(planner, name, attached, body, fast, lasts["fastening"])
    if faults:
        raise UsageFault(faults)
    _be_robot(here, planner, settings, name, kind, state, attached,
              (body, fast, lasts["fastening"]), not waits, json)  # fmt: skip


def _times(faults: list[str], **given: str) -> dict[str, float]:
    """Return the times [s] given as options; 1 s for those with a fault, which is noted."""
    found = {}
    for what, said in given.items():
        amount = Amount(f"--{what}", said, "time", 0.0)
        wrong = amount.faults()
        faults += wrong
        found[what] = 1.0 if wrong else amount.value()
    return found


def _be_router(here: "NetworkSettings", json: bool) -> None:
    """Be a router until a signal comes."""
    from swarmgrasp.agents.network import Router

    router = Router(here)
    end_on_signals(router.stop)
    words = f"router at {' and '.join(here.listen)}"
    say(text.dumps({"router": here.listen}) if json else words)
    router.run()


def _be_robot(
    here: "NetworkSettings", planner: "ProblemPlanner", settings: "Settings", name: str,
    kind: "Kind | None", state: Path | None, attached: "Place | None",
    body: tuple[str, float, float], joins: bool, json: bool,
) -> None:  # fmt: skip
    """Be a robot until a signal comes."""
    from swarmgrasp.agents.network import Process, Store, Transport, incarnation_of
    from swarmgrasp.agents.protocol import Agent
    from swarmgrasp.errors import NetworkFailed

    store = None if state is None else Store(state, planner.mission, name)
    known = store.read() if store else None
    robot = Agent(name, planner, settings, kind=kind, state=known,
                  incarnation=incarnation_of(known, name))  # fmt: skip
    attached = attached or _attached(planner, known, name)
    hull = _body(planner, name, attached, *body)
    transport = Transport(here, planner.mission, name)
    if transport.is_taken():
        transport.end()
        raise NetworkFailed(
            f"a process of {name} is on the network already; choose another name, or wait for "
            f"{here.lease:g} s if it has just ended"
        )
    process = Process(robot, transport, hull, _teller(name, json, body[0]), store=store)
    end_on_signals(process.stop)
    if body[0] == "stdio":
        Thread(target=_listen, args=(transport, process), daemon=True).start()
    transport.begin()
    try:
        process.run(attached, joins)
    finally:
        transport.end()


def _settings(
    lasts: dict[str, float], worth: float, roster: str | None, resolve: bool, faults: list[str]
) -> "Settings":
    """Return how it behaves, and note what is wrong with it."""
    from swarmgrasp.agents.protocol import Settings
    from swarmgrasp.agents.protocol.settings import LONGEST

    usual, silent, lease = Settings(), lasts["silent"], lasts["lease"]
    if not SHORTEST <= silent <= LONGEST:
        faults.append(f"--silent is {silent:g}; it should be {SHORTEST:g} to {LONGEST:g} [s]")
        silent = usual.silent
    elif lease > silent:
        faults.append(f"the lease is {lease:g} s; it should be at most --silent, {silent:g} s")
    names = () if roster is None else tuple(word.strip() for word in roster.split(","))
    with noting(faults):
        return Settings(beat=silent / BEATS, silent=silent, worth=worth, roster=names,
                        resolve=resolve)  # fmt: skip
    return usual


def _kind(
    planner: "ProblemPlanner", limit: str | None, terms: "Terms", faults: list[str]
) -> "Kind | None":
    """Return what a robot is, if that differs from the newcomer; note a limit out of range."""
    from swarmgrasp.agents.protocol import Kind
    from swarmgrasp.ranges import STRONGEST, WEAKEST

    if limit is None:
        return None
    usual = planner.problem.newcomer
    with noting(faults):
        strong = Amount("--limit", limit, "force", WEAKEST, STRONGEST).value(terms)
        usual = replace(usual, limit=strong)
    return Kind(usual.limit, usual.attachment, usual.half_angle, usual.steers,
                usual.reverse_limit, usual.friction)  # fmt: skip


def _place(
    planner: "ProblemPlanner", given: tuple[str, str, str] | None, terms: "Terms",
    faults: list[str],
) -> "Place | None":  # fmt: skip
    """Return where it says that it is attached; note a place that is far from the object."""
    from swarmgrasp.agents.protocol import Place
    from swarmgrasp.ranges import MOST_TURNED
    from swarmgrasp.telling import Telling

    if given is None:
        return None
    told = []
    for part, of, most in zip(
        given, ("length", "length", "angle"), (FARTHEST, FARTHEST, MOST_TURNED), strict=True
    ):
        with noting(faults):
            told.append(Amount("--attached-at", part, of, -most, most).value(terms))
    if len(told) < len(given):
        return None
    x, y = terms.frame.from_file(told[:2]).tolist()
    spot, direction = (x, y), terms.frame.direction_from_file(told[2])
    outline = planner.problem.swarm.outline
    if not planner.problem.newcomer.mounted or not outline.contains(spot):
        off, most = float(outline.nearest(spot)[0][0]), ASTRAY * outline.extent
        if off > most:
            tell = Telling.of(terms, outline.extent, [])
            faults.append(
                f"--attached-at is {tell.point(spot)}, {tell.length.text(off)} from the boundary; "
                f"it should be at most {tell.length.short(most)} from it, in the file's frame"
            )
    return Place(x, y, direction)


def _attached(planner: "ProblemPlanner", state: "State | None", name: str) -> "Place | None":
    """Return where a robot holds the object at its start: as it knew last, or as the file says."""
    records = state.records if state else ()
    for record in records:
        if record.id == name:
            return record.place if record.is_fixed else None
    return next((row.place for row in planner.present if row.id == name), None)


def _body(
    planner: "ProblemPlanner", name: str, attached: "Place | None", kind: str, speed: float,
    fastening: float,
) -> "Body":  # fmt: skip
    """Return the robot itself."""
    from swarmgrasp.agents.network import RealBody, StandIn

    if kind != "stand-in":
        return RealBody()
    return StandIn(name, planner.problem.swarm.outline, speed, fastening, attached)


def _listen(transport: "Transport", process: "Process") -> None:
    """Take what the robot's software says on standard input; end with it."""
    from swarmgrasp.agents.network import Item

    for line in sys.stdin.buffer:
        if line.strip():
            transport.inbox.put(Item("body", "", line))
    process.stop()


def _teller(name: str, json: bool, body: str) -> Callable[[dict[str, Any]], None]:
    """Return what prints; with software on standard output, sentences go to standard error."""
    from swarmgrasp.agents.network import steady_clock

    begin, aside = steady_clock(), body == "stdio"
    words = sys.stderr if aside else sys.stdout

    def tell(told: dict[str, Any]) -> None:
        if json or (aside and "order" in told):
            line = {"robot": name, "clock": steady_clock(), **told}
            say(text.dumps(line))
        elif "words" in told:
            print(
                f"{steady_clock() - begin:7.1f} s  {clean(told['words'])}", file=words, flush=True
            )

    return tell
