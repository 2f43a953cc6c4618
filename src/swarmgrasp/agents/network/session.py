"""Opening Zenoh, and what is said when it cannot be opened."""

import json
import re

import zenoh

from swarmgrasp.agents.network.settings import NetworkSettings
from swarmgrasp.errors import NetworkFailed

_FROM_SOURCE = re.compile(r" at \S+\.rs:\d+\.?")
"""Where in its own source Zenoh saw a fault."""


def open_session(settings: NetworkSettings) -> zenoh.Session:
    """Open the network.

    Raises
    ------
    NetworkFailed
        If it cannot be opened: a port is in use, nobody answers, a certificate is refused.
    """
    config = zenoh.Config()
    for key, value in settings.zenoh_config().items():
        config.insert_json5(key, json.dumps(value))
    try:
        return zenoh.open(config)
    except zenoh.ZError as error:
        raise NetworkFailed(_words(settings, str(error))) from None


def _words(settings: NetworkSettings, told: str) -> str:
    """Return the sentence for a fault."""
    told = _FROM_SOURCE.sub("", told).strip()
    listen, connect = " or ".join(settings.listen), " or ".join(settings.connect)
    if "Address already in use" in told:
        return f"{listen}: the port is in use; choose another with --listen"
    if "Cannot assign requested address" in told:
        return f"{listen}: this machine has no such address; choose another with --listen"
    if "Unable to connect" in told:
        refused = ", or it refuses this certificate" if settings.tls is not None else ""
        return (
            f"{connect}: no router answers there{refused}; `swarmgrasp agent --router` starts one"
        )
    return f"the network cannot be opened: {told}"
