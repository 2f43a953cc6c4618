"""`swarmgrasp agents keys`: certificates for trials."""

from pathlib import Path
from typing import Annotated

from cyclopts import Parameter

from swarmgrasp.cli.show.report import told_written


def keys(
    folder: Path,
    names: tuple[str, ...],
    /,
    *,
    at: Annotated[tuple[str, ...], Parameter(negative="")] = (),
) -> None:
    """Make certificates, by which a router lets each robot write its own keys and no other's.

    The first time this makes an authority that signs them, and certificates for a router,
    for a watcher and for an operator too. Nothing is overwritten. This is for trials: keep the
    authority's key from the robots, and use your own authority where it matters.

    Example: swarmgrasp agents keys certificates Ajax Boreas

    Parameters
    ----------
    folder
        Where to, created if need be.
    names
        Robots.
    at
        Names or addresses under which robots reach the router, beside this machine's own.
    """
    from swarmgrasp.packages import check_installed

    check_installed("cryptography", "msgspec", "zenoh", purpose="Making certificates")
    from swarmgrasp.agents.network import make_papers

    told_written(make_papers(folder, names, at))
