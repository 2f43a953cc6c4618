"""Errors a caller can meet, all children of `SwarmGraspError`.

Every message shows the offending value, the range it should lie in and the remedy.
An error that collects several faults lists them one per line; faults of several kinds are told
by an error of the first one's kind.
"""

from collections.abc import Iterable, Sequence
from typing import NamedTuple


class SwarmGraspError(ValueError):
    """Base of every error this package raises on purpose.

    Parameters
    ----------
    faults : str or iterable of str
        One sentence per fault; they are all shown.
    """

    def __init__(self, faults: str | Iterable[str]) -> None:
        self.faults: tuple[str, ...] = (faults,) if isinstance(faults, str) else tuple(faults)
        super().__init__("\n".join(self.faults))


class OutlineInvalid(SwarmGraspError):
    """The vertices do not describe a simple polygon with an area."""


class ContactInvalid(SwarmGraspError):
    """A contact description names no boundary point, or more than one."""


class RobotInvalid(SwarmGraspError):
    """A robot or newcomer has a value outside its range."""


class SwarmInvalid(SwarmGraspError):
    """What should be a swarm is none."""


class ForceSetUnsupported(SwarmGraspError):
    """Robots exert more than one ray of forces, which what is asked for does not know."""


class RobotOffBoundary(SwarmGraspError):
    """A robot is not on the boundary, or a mounted one is outside the outline."""


class ZoneInvalid(SwarmGraspError):
    """A zone, a no-go stretch or a spacing is malformed or outside the outline."""


class TermsInvalid(SwarmGraspError):
    """A unit in which answers are told is unknown, or a frame or a word for robots is none."""


class EnvironmentInvalid(SwarmGraspError):
    """A wind, a current or a coefficient is outside its range, or a part is missing."""


class MetricInvalid(SwarmGraspError):
    """A force weight or the characteristic length is not a positive number."""


class WrenchInvalid(SwarmGraspError):
    """A wrench, generator or direction is not three finite numbers."""


class CriterionInvalid(SwarmGraspError):
    """What is asked of a swarm has a value outside its range."""


class WrenchSetTooLarge(SwarmGraspError):
    """A wrench set has more faces than a mesh of it may list."""


class ProblemInvalid(SwarmGraspError):
    """What should be a problem is none, or what is asked of its search is outside its range."""


class NowhereToAttach(SwarmGraspError):
    """Zones, no-go stretches and spacing leave no boundary point to a newcomer."""


class QuantityInvalid(SwarmGraspError):
    """A quantity is no number with a unit of what is measured."""


class FileFault(NamedTuple):
    """One thing that is wrong with a file, and where; as text, the line that tells it.

    Attributes
    ----------
    file : str
        As messages call it; "" where the sentence says it all.
    line, column : int or None
        Counted from 1; None for the file as a whole, or for the whole line.
    path : str
        Keys with dots that lead to it, such as ``robots.0.limit``; "" for the file itself.
    sentence : str
        What is wrong and what it should be.

    Examples
    --------
    >>> print(FileFault("barge.yaml", 5, 48, "robots.0.limit", "should be greater than 0"))
    barge.yaml:5:48: robots.0.limit: should be greater than 0
    """

    file: str
    line: int | None
    column: int | None
    path: str
    sentence: str

    def __str__(self) -> str:
        """Return the whole message."""
        at = [str(number) for number in (self.line, self.column) if number is not None]
        place = ":".join([self.file, *at])
        return ": ".join(part for part in (place, self.path, self.sentence) if part)


class ScenarioInvalid(SwarmGraspError):
    """A scenario file has faults; each carries file, line, column and key.

    Parameters
    ----------
    faults : str or iterable of str or FileFault

    Attributes
    ----------
    records : tuple of FileFault
        The faults, each with its place apart from its sentence.
    """

    def __init__(self, faults: str | Iterable[str | FileFault]) -> None:
        listed = (faults,) if isinstance(faults, str) else tuple(faults)
        self.records: tuple[FileFault, ...] = tuple(
            fault if isinstance(fault, FileFault) else FileFault("", None, None, "", fault)
            for fault in listed
        )
        super().__init__(map(str, self.records))


class DataInvalid(SwarmGraspError):
    """Plain data do not make the object: keys are missing or unknown, or values are wrong."""


class AnswerInvalid(SwarmGraspError):
    """An answer file is malformed, was altered, or claims what its proof does not show."""


class LinearProgramFailed(SwarmGraspError):
    """A linear program that has a solution was not solved, by rounding."""


class ForcesNotProven(SwarmGraspError):
    """Push forces can be found but not proven to be the least, by rounding."""


class SummaryInvalid(SwarmGraspError):
    """A summary's bytes are damaged, or two summaries do not go together."""


class MessageInvalid(SwarmGraspError):
    """Bytes between robots hold no message, or one that no sound robot sends."""


class AgentInvalid(SwarmGraspError):
    """What an agent is told to be, how it is to behave, or what it is to remember is at fault."""


class NetworkFailed(SwarmGraspError):
    """The network cannot be opened as asked, or this process may not be on it."""


class ScheduleInvalid(SwarmGraspError):
    """A schedule of a simulated network is impossible, or written as none."""


class SimulationInvalid(SwarmGraspError):
    """A simulation's hull, robots, weather or events have values that cannot be, or contradict."""


class StudyInvalid(SwarmGraspError):
    """A study, its plan or its folder is at fault, or the folder is of another study."""


class StudyStopped(SwarmGraspError):
    """A study cannot go on; what is done is kept."""


class NotInThePaper(SwarmGraspError):
    """The source paper's algorithm is asked for something it does not know."""


class PackageMissing(SwarmGraspError):
    """An optional package that is needed here is not installed."""


class SwarmGraspWarning(UserWarning):
    """Base of every warning that this package gives: what is said is allowed, and hardly meant."""


class DirectionWarning(SwarmGraspWarning):
    """A direction is several turns, as degrees are that are taken for radians."""


class FrictionWarning(SwarmGraspWarning):
    """A coefficient of friction is beyond anything real."""


class ScenarioWarning(SwarmGraspWarning):
    """A scenario file says what is probably a slip."""


def refuse(*kinds: tuple[type[SwarmGraspError], Sequence[str]]) -> None:
    """Raise the first kind of error that has faults, with the faults of all of them.

    Examples
    --------
    >>> refuse((RobotInvalid, []), (MetricInvalid, []))
    >>> refuse((RobotInvalid, []), (MetricInvalid, ["no length"]), (ZoneInvalid, ["no zone"]))
    Traceback (most recent call last):
    ...
    swarmgrasp.errors.MetricInvalid: no length
    no zone
    """
    faults = [fault for _, found in kinds for fault in found]
    if faults:
        raise next(kind for kind, found in kinds if found)(faults)
