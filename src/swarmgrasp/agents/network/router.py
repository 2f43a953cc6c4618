"""A router: it passes on what robots say, and sees to it that each writes its own keys only."""

from threading import Event

from swarmgrasp.agents.network.keys import router_key
from swarmgrasp.agents.network.session import open_session
from swarmgrasp.agents.network.settings import NetworkSettings


class Router:
    """A router in this process.

    Its token tells robots that it is there: if it vanishes together with robots, it is a line that
    has ended, not they.

    Parameters
    ----------
    settings : NetworkSettings
    """

    def __init__(self, settings: NetworkSettings) -> None:
        self._ends = Event()
        self._session = open_session(settings)
        key = router_key(str(self._session.zid()))
        self._token = self._session.liveliness().declare_token(key)

    def stop(self) -> None:
        """End soon; may be called from a signal's handler."""
        self._ends.set()

    def run(self) -> None:
        """Pass on messages until told to end."""
        self._ends.wait()
        self._session.close()
