"""`swarmgrasp agents ask`: what an operator wishes of a robot."""

from pathlib import Path
from typing import Annotated, Literal

from cyclopts import Parameter

from swarmgrasp.cli.lasting import say
from swarmgrasp.texts import clean

REFUSES = 1
"""Exit status when a robot cannot do what is wished now."""


def ask(
    name: str,
    wish: Literal["join", "leave", "move"],
    /,
    *,
    connect: Annotated[tuple[str, ...], Parameter(negative="")] = (),
    tls: Path | None = None,
) -> int:
    """Ask a robot on the network to join, to leave, or to look for a better place.

    It answers at once what it makes of that, and does it as the rules allow: a robot that holds
    the object lets go to move only when all others have agreed.

    Exit status: 0 when it will, 1 when it cannot now.

    Example: swarmgrasp agents ask Fortuna leave --connect tcp/127.0.0.1:7447

    Parameters
    ----------
    name
        The robot's.
    wish
        Join, leave or move.
    connect
        Endpoints of the robots' router; port 7447 of this machine unless given.
    tls
        Folder with certificates; the one of "operator" is shown, and no robot's may ask.
    """
    from swarmgrasp.packages import check_installed

    check_installed("msgspec", "zenoh", purpose="Asking a robot on the network")
    from swarmgrasp.agents.network import NetworkSettings, ask_robot

    settings = NetworkSettings(mode="client", connect=connect, tls=tls, name="operator")
    answer = ask_robot(settings, name, wish)
    say(f"{name} is asked to {wish}: it is {answer.phase}")
    for words in answer.words:
        say(clean(words))
    return REFUSES if answer.refuses else 0
