"""Who may ask, and how much: hosts, origins, keys, rates, and what a page may load."""

import hmac
import secrets
from collections.abc import Collection
from dataclasses import dataclass, field

from swarmgrasp.gui.messages import MOST_ROBOTS_SHOWN, MOST_TEXT
from swarmgrasp.gui.replies import Limits

MOST_BYTES = 4_000_000
"""Of a message; a larger one ends the window's connection (1009)."""
RATE, BURST = 200.0, 400.0
"""Messages a second, and at once; those beyond are dropped."""
MOST_WINDOWS = 64
LIMITS = Limits(MOST_BYTES, int(RATE), MOST_TEXT, MOST_ROBOTS_SHOWN)
"""What a page says of these."""
HELLO_WITHIN = 3.0
"""Seconds that a window has to show its key."""
KEY_BYTES = 16
WRONG_KEY, TOO_MANY, OTHER_PROTOCOL = 4401, 4429, 4400
"""Codes with which a connection is closed."""
POLICY = "; ".join([
    "default-src 'none'",
    "script-src 'self'",
    "style-src 'self'",
    "font-src 'self'",
    "img-src 'self' data: blob:",
    "connect-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
    "frame-ancestors 'none'",
    "require-trusted-types-for 'script'",
    "trusted-types 'none'",
])  # fmt: skip
HEADERS = {
    "content-security-policy": POLICY,
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "cache-control": "no-cache",
}
"""Of every answer."""


def new_key() -> str:
    """Return a key of 128 bits that nobody can guess."""
    return secrets.token_hex(KEY_BYTES)


@dataclass(frozen=True)
class Guard:
    """What a request must show.

    Attributes
    ----------
    hosts : collection of str
        Names under which the server is asked, each with its port.
    scheme : str
        "http" or "https".
    key : str
    """

    hosts: Collection[str]
    scheme: str
    key: str = field(repr=False)

    def knows_host(self, host: str | None) -> bool:
        """Tell whether a request names this server: other names are of a page that rebinds."""
        return host is not None and host.lower() in self.hosts

    def knows_origin(self, origin: str | None) -> bool:
        """Tell whether a socket is opened by a page of this server."""
        return origin in {f"{self.scheme}://{host}" for host in self.hosts}

    def knows_key(self, key: str) -> bool:
        """Tell whether a key is the right one, in the same time whatever it is."""
        return hmac.compare_digest(key.encode(), self.key.encode())


@dataclass
class Bucket:
    """How many messages a window may still send: it fills with time.

    Examples
    --------
    >>> bucket = Bucket(rate=1.0, burst=2.0)
    >>> [bucket.take(now) for now in (0.0, 0.0, 0.0, 1.0, 1.0)]
    [True, True, False, True, False]
    """

    rate: float = RATE
    burst: float = BURST
    level: float = field(default=-1.0)
    last: float = 0.0

    def take(self, now: float) -> bool:
        """Tell whether a message may come at a time [s]."""
        if self.level < 0.0:
            self.level, self.last = self.burst, now
        self.level = min(self.burst, self.level + self.rate * (now - self.last))
        self.last = now
        if self.level < 1.0:
            return False
        self.level -= 1.0
        return True
