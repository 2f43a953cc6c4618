"""What a person should know, each thing when it is new."""

from swarmgrasp.agents.protocol.events import Report


class Reports:
    """Reports of one event, and what has been told already."""

    def __init__(self) -> None:
        self.new: list[Report] = []
        self._told: dict[str, str] = {}
        self._refused = 0

    def tell(self, what: str, words: str, *about: str) -> None:
        """Tell of something."""
        self.new.append(Report(what, words, about))

    def tell_once(self, key: str, what: str, words: str, *about: str) -> None:
        """Tell of something, unless the same was told under this key last."""
        if self._told.get(key) != words:
            self._told[key] = words
            self.tell(what, words, *about)

    def forget(self, key: str) -> None:
        """Let a thing be told again."""
        self._told.pop(key, None)

    def refuse(self, sender: str, fault: str) -> None:
        """Count what cannot be, and tell of it at the 1st, 2nd, 4th, 8th time and so on."""
        self._refused += 1
        if self._refused & (self._refused - 1) == 0:
            count = f" ({self._refused} so far)" if self._refused > 1 else ""
            self.tell("refused", f"{sender} {fault}{count}", sender)

    def take(self) -> list[Report]:
        """Return the reports of one event."""
        new, self.new = self.new, []
        return new
