"""How an agent behaves: its periods, and what it does where nobody can know better."""

from dataclasses import dataclass

from swarmgrasp.agents.protocol.record import id_fault
from swarmgrasp.errors import AgentInvalid
from swarmgrasp.ranges import flag_faults, number, shown

LONGEST = 86_400.0
"""Longest period [s]."""


@dataclass(frozen=True)
class Settings:
    """How an agent behaves; all periods in seconds.

    Attributes
    ----------
    beat : float [s]
        Between signs of life.
    silent : float [s]
        After it, who has not been heard is not waited for; more than three beats.
    forget : float [s]
        After it, who is on its way and has not been heard does not count.
    hold : float [s]
        How long a confirmation holds; less than `forget`.
    ask : float [s]
        How long a newcomer waits for someone to tell it what is known.
    retry : float [s]
        Between requests to those who have not confirmed.
    gather : float [s]
        How long news are let come in before they are acted upon.
    worth : float
        By what share another place must be better before a robot on its way turns to it; with 0
        final places are those of one placed after the other.
    roster : tuple of str
        Robots of whom each must confirm, heard or not. Without one, all that are heard.
    resolve : bool
        Whether the later of two that hold the object too close to each other lets go.
    counts_silent : bool
        Whether robots at the object that are silent count; else they are kept clear of only.
    floor : float [N]
        Quality below which nobody lets go to move.
    improve : float, optional
        By what share a move must raise the quality for a robot to ask for it by itself.
    many : int
        From so many robots on, those that hold the object confirm by their beats.

    Raises
    ------
    AgentInvalid
        If a value is outside its range; all faults at once.
    """

    beat: float = 1.0
    silent: float = 3.5
    forget: float = 60.0
    hold: float = 10.0
    ask: float = 0.5
    retry: float = 0.5
    gather: float = 0.05
    worth: float = 0.02
    roster: tuple[str, ...] = ()
    resolve: bool = False
    counts_silent: bool = True
    floor: float = 0.0
    improve: float | None = None
    many: int = 64

    def __post_init__(self) -> None:
        """Check the values."""
        faults = []
        for what in ("beat", "silent", "forget", "hold", "ask", "retry"):
            value = getattr(self, what)
            if not 1e-3 <= number(value) <= LONGEST:
                faults.append(f"{what} is {shown(value)}; it should be 0.001 to {LONGEST:g} [s]")
        if not 0.0 <= number(self.gather) <= LONGEST:
            faults.append(f"gather is {shown(self.gather)}; it should be 0 to {LONGEST:g} [s]")
        if not faults:
            if not self.silent > 3.0 * self.beat:
                faults.append(
                    f"silent is {self.silent:g} s; it should be more than three beats, "
                    f"{3.0 * self.beat:g} s"
                )
            if not self.hold < self.forget:
                faults.append(
                    f"hold is {self.hold:g} s; it should be less than forget, {self.forget:g} s"
                )
        if not 0.0 <= number(self.worth) <= 1.0:
            faults.append(f"worth is {shown(self.worth)}; it should be 0 to 1")
        if not number(self.floor) >= 0.0:
            faults.append(f"the floor is {shown(self.floor)}; it should be >= 0 [N]")
        if self.improve is not None and not 0.0 < number(self.improve) <= 1e6:
            faults.append(f"improve is {shown(self.improve)}; it should be > 0")
        faults += flag_faults(self.resolve, "resolve")
        faults += flag_faults(self.counts_silent, "counts_silent")
        faults += [f"roster: a robot {fault}" for name in self.roster if (fault := id_fault(name))]
        if faults:
            raise AgentInvalid(faults)
        vars(self).update(roster=tuple(self.roster))
