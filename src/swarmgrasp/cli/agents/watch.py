"""`swarmgrasp agents watch`: who is where in what phase, live."""

import json as text
import signal
import sys
from collections.abc import Callable, Iterator
from contextlib import ExitStack, contextmanager
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

from cyclopts import Parameter

from swarmgrasp.cli.dash import Dashed
from swarmgrasp.cli.inputs import UsageFault, blaming, output_faults, read_scenario
from swarmgrasp.cli.lasting import say
from swarmgrasp.texts import clean
from swarmgrasp.words import Lengths, Unit, list_words, turned

if TYPE_CHECKING:
    from rich.console import RenderableType

EVERY = 0.5
"""Seconds between two pictures of the swarm, when nothing happens."""
SILENT = 3.5
"""Seconds after which it is told that a robot is not heard."""
MOST_NAMES = 4
"""Names of those who have confirmed that are told."""
MOST_CONFLICTS = 8

Show = Callable[[dict[str, Any]], None]


def watch(
    file: Dashed,
    /,
    *,
    connect: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    tls: Path | None = None,
    seconds: float | None = None,
    json: Annotated[bool, Parameter(negative="")] = False,
    mcap: Path | None = None,
) -> None:
    """Watch robots that decide for themselves: who is where, confirmed by whom, who is silent.

    A watcher is no robot: it listens at a router, and nobody waits for it.

    Example: swarmgrasp agents watch deck-barge --seconds 5

    Parameters
    ----------
    file
        The robots' scenario in YAML, "-" for standard input, or a built-in example.
    connect
        Endpoints of routers; port 7447 of this machine unless given.
    tls
        Folder with certificates; the one of "watch" is shown.
    seconds
        End after so many; on and on unless given.
    json
        Print the swarm as a line of JSON whenever it changes, and twice a second.
    mcap
        Also record these lines in a file of the MCAP format, which other tools replay.
    """
    from swarmgrasp.packages import check_installed

    check_installed("msgspec", "zenoh", purpose="Watching robots on the network")
    if mcap is not None:
        check_installed("mcap", extra="logs", purpose="Recording")
    faults = output_faults(mcap, (".mcap",))
    if seconds is not None and not seconds > 0.0:
        faults.append(f"--seconds is {seconds:g}; it should be > 0")
    scenario = read_scenario(file, faults)
    from swarmgrasp.agents.network import Listener, NetworkSettings, Watch, steady_clock
    from swarmgrasp.agents.protocol import ProblemPlanner

    with blaming(file):
        planner = ProblemPlanner(scenario.problem())
    settings = NetworkSettings(mode="client", connect=connect, tls=tls, name="watch")
    with ExitStack() as stack:
        shows = [_shown_as_json if json else stack.enter_context(_live(scenario.name))]
        if mcap is not None:
            shows.append(stack.enter_context(_recording(mcap)))
        listener = Listener(settings, planner.mission)
        stack.callback(listener.close)
        signal.signal(signal.SIGTERM, signal.default_int_handler)
        watching, end = Watch(planner), steady_clock() + (seconds or float("inf"))
        while steady_clock() < end:
            for event in listener.events(min(EVERY, max(0.0, end - steady_clock()))):
                asked = watching.take(steady_clock(), event)
                if asked:
                    listener.ask(asked)
            data = watching.data(steady_clock())
            for show in shows:
                show(data)


def _shown_as_json(data: dict[str, Any]) -> None:
    """Print the swarm as a line of JSON."""
    say(text.dumps(data))


@contextmanager
def _live(title: str) -> Iterator[Show]:
    """Show the swarm on a terminal, always the same lines; in a pipe, its last state."""
    if not sys.stdout.isatty():
        last: list[dict[str, Any]] = [{}]
        try:
            yield lambda data: last.__setitem__(0, data)
        finally:
            if last[0]:
                _print_plain(title, last[0])
        return
    from rich.live import Live

    with Live(auto_refresh=False) as live:
        yield lambda data: live.update(_picture(title, data), refresh=True)


def _headline(title: str, data: dict[str, Any]) -> str:
    """Return what matters most."""
    robots = data["robots"]
    attached = sum(robot["phase"] in {"attached", "asking"} for robot in robots)
    unit = Unit.for_size(data["quality"], data["certified"])
    return (
        f"{title}: {attached + len(data['alone'])} robots hold it; quality "
        f"{unit.text(data['quality'])} now, {unit.text(data['certified'])} certified by a robot"
    )


def _rows(data: dict[str, Any]) -> list[list[str]]:
    """Return a row for each robot."""
    places = [robot["place"] for robot in data["robots"] if robot["place"]]
    extent = max((abs(p[key]) for p in places for key in ("x", "y")), default=1.0) or 1.0
    lengths = Lengths.for_extent(2.0 * extent)
    rows = []
    for robot in data["robots"]:
        place, by = robot["place"], robot["confirmed_by"]
        where = lengths.point((place["x"], place["y"])) if place else ""
        way = f"{turned(place['direction']):.1f}" if place else ""
        rest = [f"{len(by) - MOST_NAMES} more"] if len(by) > MOST_NAMES else []
        silent = robot["silent"]
        heard = "never" if silent is None else "yes" if silent < SILENT else f"{silent:.0f} s ago"
        ends = "" if robot["running"] else ", its process has ended"
        names = list_words([*by[:MOST_NAMES], *rest])
        rows.append([robot["name"], robot["phase"], str(robot["ticket"]), where, way, names,
                     f"{heard}{ends}"])  # fmt: skip
    return rows


HEADINGS = ("robot", "phase", "ticket", "place", "to [deg]", "confirmed by", "heard")


def _picture(title: str, data: dict[str, Any]) -> "RenderableType":
    """Return the swarm as a table."""
    from rich.console import Group
    from rich.table import Table
    from rich.text import Text

    table = Table(box=None, pad_edge=False, padding=(0, 2, 0, 0), header_style="cyan")
    for heading in HEADINGS:
        table.add_column(heading)
    for row in _rows(data):
        table.add_row(*(Text(clean(cell)) for cell in row))
    told = [Text(clean(words), style="bold yellow") for words in data["conflicts"]]
    head = Text(clean(_headline(title, data)), style="bold")
    return Group(head, table, *told[-MOST_CONFLICTS:])


def _print_plain(title: str, data: dict[str, Any]) -> None:
    """Print the swarm as aligned columns."""
    from swarmgrasp.cli.show.report import Column, Report

    report = Report()
    report.headline(_headline(title, data))
    report.table([Column(heading) for heading in HEADINGS], _rows(data))
    for words in data["conflicts"]:
        report.sentence(words)


@contextmanager
def _recording(path: Path) -> Iterator[Show]:
    """Record the swarm in a file of the MCAP format, by the time of day."""
    import time

    from mcap.writer import Writer

    try:
        file = path.open("wb")
    except OSError as error:
        raise UsageFault(f"{path}: cannot be written: {error.strerror}") from None
    with file:
        writer = Writer(file)
        writer.start()
        form = text.dumps({"type": "object"}).encode()
        schema = writer.register_schema("swarmgrasp.Swarm", "jsonschema", form)
        channel = writer.register_channel("/swarm", "json", schema)

        def record(data: dict[str, Any]) -> None:
            now = time.time_ns()
            line = text.dumps(data).encode()
            writer.add_message(channel, log_time=now, data=line, publish_time=now)

        try:
            yield record
        finally:
            writer.finish()
