"""The keys under which robots speak: one protocol, one mission, and who speaks, in each."""

from dataclasses import dataclass

from swarmgrasp.agents.protocol.wire import PROTOCOL

ROOT = "swarmgrasp"


@dataclass(frozen=True)
class Keys:
    """The keys of one robot, or, with "*" for a part, of all.

    Attributes
    ----------
    protocol : str
    mission : str
    name : str
    """

    protocol: str
    mission: str
    name: str

    @property
    def base(self) -> str:
        """What all keys of the mission begin with."""
        return f"{ROOT}/{self.protocol}/{self.mission}"

    @property
    def to_all(self) -> str:
        """What it says to everyone: Put and Beat."""
        return f"{self.base}/all/{self.name}"

    def to(self, other: str) -> str:
        """Return the key of what it says to another alone."""
        return f"{self.base}/to/{other}/{self.name}"

    @property
    def alive(self) -> str:
        """The token that is there while its process is."""
        return f"{self.base}/alive/{self.name}"

    @property
    def records(self) -> str:
        """All records it has, for whoever asks and is no robot."""
        return f"{self.base}/records/{self.name}"

    @property
    def order(self) -> str:
        """What its own software is to do."""
        return f"{self.base}/body/{self.name}/order"

    @property
    def event(self) -> str:
        """What its own software tells it."""
        return f"{self.base}/body/{self.name}/event"

    @property
    def ask(self) -> str:
        """What an operator wishes of it."""
        return f"{self.base}/ask/{self.name}"

    @property
    def answer(self) -> str:
        """What it makes of an operator's wish."""
        return f"{self.base}/answer/{self.name}"

    @property
    def written(self) -> tuple[str, ...]:
        """All keys that it and its own software write."""
        said = (self.to_all, self.to("*"), self.alive, self.records, self.answer)
        return (*said, self.order, self.event)


def own_keys(mission: str, name: str) -> Keys:
    """Return the keys of a robot by this version of the protocol."""
    return Keys(str(PROTOCOL), mission, name)


def every(key: str) -> str:
    """Return a key with any robot at its end.

    Examples
    --------
    >>> every(own_keys("a1", "Ajax").to_all)
    'swarmgrasp/1/a1/all/*'
    """
    return f"{key.rpartition('/')[0]}/*"


def router_key(identity: str) -> str:
    """Return the token that is there while a router is."""
    return f"{ROOT}/{PROTOCOL}/router/{identity}"


ALL_ALIVE = Keys("*", "*", "*").alive
ALL_ROUTERS = router_key("*")
