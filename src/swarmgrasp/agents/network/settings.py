"""How a process is on the network: whom it listens to, whom it connects to, with what certificate.

Nothing is looked for: all endpoints are given, and those of this machine alone are the default.
"""

import re
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Literal

from swarmgrasp.agents.network.certificates import ROUTER, Papers
from swarmgrasp.agents.protocol.wire import MOST_BYTES
from swarmgrasp.errors import AgentInvalid
from swarmgrasp.ranges import number, shown

Mode = Literal["peer", "client", "router"]
PORT = 7447
"""Where routers listen, and are looked for."""
LONGEST_LEASE = 3600.0
"""Longest lease [s]."""
PATIENCE = 10.0
"""How long a client waits for its router at the start [s]."""
MOST_LINKS = 4096
"""Connections of one process."""
_ENDPOINT = re.compile(r"(tcp|tls)/(\[[0-9a-fA-F:.%]+\]|[^/\s\[\]:#?]+):([0-9]{1,5})")


@dataclass(frozen=True)
class NetworkSettings:
    """How a process is on the network.

    Attributes
    ----------
    mode : {"peer", "client", "router"}
        Peers connect to each other, each to each; clients to a router, which is the better above
        twenty robots; a router is no robot.
    listen : tuple of str
        Endpoints, as `tcp/127.0.0.1:7447`; left out, peers take a free port of this machine,
        and routers port 7447 of it.
    connect : tuple of str
        Endpoints of others; left out, clients look for a router on this machine.
    lease : float [s]
        After it, a process that hangs or a broken line counts as ended.
    tls : Path, optional
        Folder with certificates, as `swarmgrasp agents keys` makes it: robots are clients then.
    name : str
        Whose certificate it shows: a robot's name, or "router" or "watch".

    Raises
    ------
    AgentInvalid
        If a value is outside its range; all faults at once.
    """

    mode: Mode = "peer"
    listen: tuple[str, ...] = ()
    connect: tuple[str, ...] = ()
    lease: float = 3.0
    tls: Path | None = None
    name: str = ""

    def __post_init__(self) -> None:
        """Check the values, and fill in the usual endpoints."""
        scheme = "tcp" if self.tls is None else "tls"
        usual_listen = {"peer": ("tcp/127.0.0.1:0",), "router": (f"{scheme}/127.0.0.1:{PORT}",)}
        listen = tuple(self.listen) or usual_listen.get(self.mode, ())
        connect = tuple(self.connect)
        if self.mode == "client" and not connect:
            connect = (f"{scheme}/127.0.0.1:{PORT}",)
        faults = []
        if self.mode not in {"peer", "client", "router"}:
            faults.append(f"the mode is {shown(self.mode)}; it should be peer, client or router")
        if self.mode == "client" and listen:
            faults.append("a client listens nowhere; leave --listen out, or be a peer")
        faults += [fault for end in (*listen, *connect) if (fault := _endpoint_fault(end, scheme))]
        if not 0.1 <= number(self.lease) <= LONGEST_LEASE:
            faults.append(
                f"the lease is {shown(self.lease)}; it should be 0.1 to {LONGEST_LEASE:g} [s]"
            )
        if self.tls is not None:
            if self.mode == "peer":
                faults.append(
                    "with certificates robots are clients of a router, which sees to it that each "
                    "writes its own keys only; leave out what makes it a peer"
                )
            faults += Papers(self.tls, self.name).faults()
        if faults:
            raise AgentInvalid(faults)
        vars(self).update(listen=listen, connect=connect)

    def zenoh_config(self) -> dict[str, Any]:
        """Return what Zenoh is to be told: values by key."""
        retry = {"period_init_ms": 100, "period_max_ms": 1000, "period_increase_factor": 2}
        told: dict[str, Any] = {
            "mode": self.mode,
            "listen/endpoints": self.listen,
            "listen/timeout_ms": 0,
            "listen/exit_on_failure": True,
            "connect/endpoints": self.connect,
            "connect/timeout_ms": round(1e3 * PATIENCE) if self.mode == "client" else -1,
            "connect/exit_on_failure": False,
            "connect/retry": retry,
            "scouting/multicast/enabled": False,
            "transport/shared_memory/enabled": False,
            "transport/link/tx/lease": round(1e3 * self.lease),
            "transport/link/rx/max_message_size": 2 * MOST_BYTES,
            "transport/unicast/max_sessions": MOST_LINKS,
            "transport/unicast/accept_pending": MOST_LINKS,
        }
        if self.tls is not None:
            papers = Papers(self.tls, self.name)
            told["transport/link/tls"] = papers.zenoh_config(is_router=self.mode == "router")
            if self.name == ROUTER:
                told["access_control"] = papers.access_control()
        return told


def _endpoint_fault(endpoint: str, scheme: str) -> str:
    """Return what is wrong with an endpoint; "" if nothing is."""
    found = _ENDPOINT.fullmatch(endpoint)
    if not found or int(found[3]) > 65535:
        example = f"{scheme}/127.0.0.1:{PORT}"
        return f"the endpoint is {shown(endpoint)}; it should be as {example}"
    if found[1] != scheme:
        why = "without --tls it should be" if scheme == "tcp" else "with --tls it should be"
        return f"the endpoint {endpoint} is by {found[1]}; {why} {scheme}"
    return ""
