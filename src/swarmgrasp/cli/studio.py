"""`swarmgrasp studio`: a page where everything can be seen and moved."""

import os
import ssl
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

from cyclopts import Parameter

from swarmgrasp.cli.dash import DASH, Dashed
from swarmgrasp.cli.inputs import (
    STDIN,
    UsageFault,
    is_written,
    noting,
    read_scenario,
    read_stdin,
    whole_faults,
)
from swarmgrasp.cli.lasting import INTERRUPTED, end_on_signals, say

if TYPE_CHECKING:
    from swarmgrasp.gui.live import Live
    from swarmgrasp.gui.scenes import Source

DEFAULT = "escort-ring"
"""The scene opened unless told otherwise."""
LOOPBACK = ("127.0.0.1", "::1", "localhost")
ANYWHERE = ("0.0.0.0", "::", "")


def studio(
    file: Dashed = DEFAULT,
    /,
    *,
    port: Annotated[str, Parameter(metavar="INT")] = "0",
    browser: bool = True,
    run: Path | None = None,
    host: str = "127.0.0.1",
    certificate: Path | None = None,
    key: Path | None = None,
    watch: Annotated[bool, Parameter(negative="")] = False,
    connect: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    tls: Path | None = None,
    demonstration: Annotated[str | None, Parameter(metavar="INT")] = None,
) -> int:
    """Open a page where tugs are dragged and the certified answer follows.

    Serves a page on this machine and prints its link, with a key that nobody else knows; Ctrl-C
    ends it. It listens at 127.0.0.1, and loads nothing from anywhere else.

    Example: swarmgrasp studio deck-barge

    Parameters
    ----------
    file
        Scenario in YAML, "-" for standard input, or a built-in example; escort-ring unless given.
    port
        Where to listen; any that is free unless given.
    browser
        Open the page in a browser.
    run
        A run to play: what `swarmgrasp simulate` wrote with --player (.json) or --log (.parquet).
    host
        Another address or name of this machine to listen at. Whoever reaches it and has the link
        can use the page; it asks for --certificate and --key.
    certificate
        File of the certificate for TLS, in PEM.
    key
        File of its private key, in PEM.
    watch
        Show the robots of this scenario that decide for themselves, as `swarmgrasp agents watch`
        does.
    connect
        Endpoints of their routers; port 7447 of this machine unless given.
    tls
        Folder with certificates; the one of "watch" is shown.
    demonstration
        Run so many robots as processes on this machine and watch them; the page can kill and stop
        them, and split the network.
    """
    from swarmgrasp.packages import check_installed

    check_installed(
        "msgspec", "starlette", "uvicorn", "websockets", extra="studio", purpose="The page"
    )
    faults = whole_faults("--port", port, 0, 65535) + _door_faults(host, certificate, key)
    from swarmgrasp.cli.report import html_of
    from swarmgrasp.gui.scenes import built_in
    from swarmgrasp.gui.server import Settings, opened

    scenes, played = built_in(), None
    with noting(faults):
        name, scenes[name] = _scene(file, scenes)
    if run is not None:
        from swarmgrasp.gui.runs import read_run

        with noting(faults):
            played = read_run(run)
    live = None
    if watch or demonstration is not None or connect or tls:
        live = _live(file, faults, watch, connect, tls, demonstration)
    if faults:
        raise UsageFault(faults)
    settings = Settings(
        scenes, name, host, int(port), reporting=html_of, run=played, live=live,
        certificate=certificate, private_key=key,
    )  # fmt: skip
    try:
        serving = opened(settings)
    except OSError as error:
        raise UsageFault(f"{host}, port {port}: cannot listen there: {error.strerror}") from None
    say(serving.link)
    if browser and _has_display():
        import webbrowser

        webbrowser.open(serving.link)
    end_on_signals(serving.end)
    serving.run()
    return INTERRUPTED


def _live(
    file: str, faults: list[str], watch: bool, connect: tuple[str, ...], tls: Path | None,
    demonstration: str | None,
) -> "Live | None":  # fmt: skip
    """Return what watches agents; None, and faults, if it cannot."""
    from swarmgrasp.packages import check_installed

    check_installed("msgspec", "zenoh", purpose="Watching robots on the network")
    wrong = whole_faults("--demonstration", demonstration)
    if not watch and (connect or tls):
        wrong.append("--connect and --tls are for --watch: add it")
    if watch and demonstration is not None:
        wrong.append("--demonstration has routers of its own: leave out --watch")
    if file == DASH:
        wrong.append("FILE is read by others, too; standard input cannot be")
    faults += wrong
    if faults:
        return None
    from swarmgrasp.agents.network import NetworkSettings
    from swarmgrasp.agents.protocol import ProblemPlanner
    from swarmgrasp.cli.app import main
    from swarmgrasp.gui.live import Live
    from swarmgrasp.gui.live import demonstration as staged

    with noting(faults):
        scenario = read_scenario(file)
        planner = ProblemPlanner(scenario.problem())
        if demonstration is not None:
            stage = staged(file, planner, int(demonstration), main)
            return Live(planner, scenario.terms, None, stage)
        settings = NetworkSettings(mode="client", connect=connect, tls=tls, name="watch")
        return Live(planner, scenario.terms, settings)
    return None


def _door_faults(host: str, certificate: Path | None, key: Path | None) -> list[str]:
    """Return what is wrong with where it listens, and with the files of TLS."""
    if host in ANYWHERE:
        return [f"--host is {host!r}; name the one address of this machine that is asked for"]
    if (certificate is None) != (key is None):
        return ["--certificate and --key go together: give both"]
    if certificate is None or key is None:
        if host in LOOPBACK:
            return []
        return [
            f"--host {host} opens the page to others, who could read along: give --certificate "
            "and --key, or leave it out"
        ]
    try:
        ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER).load_cert_chain(certificate, key)
    except (OSError, ValueError) as error:
        return [f"--certificate {certificate}, --key {key}: cannot be used: {error}"]
    return []


def _scene(file: str, known: "dict[str, Source]") -> "tuple[str, Source]":
    """Return the scene of a command line: its name and its text."""
    from swarmgrasp.answer_file import LARGEST_FILE
    from swarmgrasp.gui.scenes import Source
    from swarmgrasp.scenario import parse_scenario, scenario_text

    if file in known and not is_written(file):
        return file, known[file]
    if file == DASH:
        raw = read_stdin(LARGEST_FILE)
        scenario = parse_scenario(raw, STDIN)
    else:
        scenario = read_scenario(file)  # its faults are told here, before a page opens
        raw = Path(file).read_bytes()
    name = STDIN if file == DASH else Path(file).stem
    if scenario.answer is not None:
        return name, Source(scenario_text(scenario))
    text = raw.decode("utf-8-sig")
    if file == DASH:
        return name, Source(text, scenario=scenario)
    return name, Source.beside(text, Path(file).parent, scenario)


def _has_display() -> bool:
    """Tell whether a browser would have a window: without one, some open in the terminal."""
    if sys.platform in {"darwin", "win32"}:
        return True
    return bool(os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY"))
