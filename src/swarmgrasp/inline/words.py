"""What is said of each kind of object: the same that the command line prints of it."""

from collections.abc import Callable, Sequence
from functools import partial, singledispatch
from typing import Any, Final

from swarmgrasp.capability import (
    Capability,
    CapabilityJoined,
    CapabilityNumbers,
    CapabilityPlacement,
    ThrustUse,
)
from swarmgrasp.cli.show import (
    capability,
    capability_joined,
    capability_numbers,
    count,
    forces,
    move,
    place_for_capability,
    placement,
    simulate,
    thrust_use,
    together,
    trajectory,
)
from swarmgrasp.cli.show import quality as grade
from swarmgrasp.cli.show.change import telling_of
from swarmgrasp.cli.show.held import weather_words
from swarmgrasp.cli.show.report import Line, Piece, told_by
from swarmgrasp.cli.show.sheet import block, without_blanks
from swarmgrasp.forces import Forces, ForcesAlong
from swarmgrasp.outline import Outline
from swarmgrasp.pages.page import Paragraph, Part
from swarmgrasp.placement import HowMany, Move, Placement, Placements, Problem, Together
from swarmgrasp.quality import Quality, Sensitivities, quality
from swarmgrasp.report import outline_facts, question
from swarmgrasp.scenario import Scenario
from swarmgrasp.simulation import Run, verdict_of
from swarmgrasp.swarm import Swarm
from swarmgrasp.telling import Telling
from swarmgrasp.terms import SI

MOST_ROWS: Final = 30
"""Rows of a table that a notebook shows."""
NAMELESS: Final = "-"
"""What an object without a name is called in its first line, until that is taken away."""
OF_FILE: Final = ", as in the file"
"""Said of the frame; likewise."""


@singledispatch
def words_of(shown: Any) -> list[Part]:
    """Return what is said of an object, what matters most first."""
    raise NotImplementedError(f"of {type(shown).__name__} nothing is said")


def _told(show: Callable[[], None]) -> list[Part]:
    """Return what a command tells of an object that has no name and is of no file."""
    first, *rest = map(_unnamed, without_blanks(told_by(show, MOST_ROWS)))
    return [block(first, is_first=True), *map(block, rest)]


def _unnamed(piece: Piece) -> Piece:
    """Return a line without a name before what it says, and without a word of a file."""
    if not isinstance(piece, Line):
        return piece
    said = piece.text.removeprefix(f"{NAMELESS}: ").replace(OF_FILE, "")
    return Line(piece.kind, said[:1].upper() + said[1:], piece.mood)


# -- questions ----------------------------------------------------------------------------


@words_of.register
def _(shown: Outline) -> list[Part]:
    tell = Telling.of(SI, shown.extent, [])
    return [Paragraph("Outline", "strong"), outline_facts(shown, tell)]


@words_of.register
def _(shown: Problem) -> list[Part]:
    return _asked(Scenario(
        "Problem", "", shown.swarm, shown.newcomer, shown.zones, shown.no_go, shown.spacing,
        criterion=shown.criterion,
    ))  # fmt: skip


@words_of.register
def _(shown: Scenario) -> list[Part]:
    return _asked(shown)


def _asked(scenario: Scenario) -> list[Part]:
    """Return what a scenario asks."""
    swarm, criterion = scenario.swarm, scenario.criterion
    tell = telling_of(scenario.terms, swarm, [], scenario.newcomer)
    weather = weather_words(scenario, criterion.load, tell) if criterion.has_load else ""
    about = [Paragraph(scenario.description)] if scenario.description else []
    return [Paragraph(scenario.name, "strong"), *about, question(scenario, tell, weather)]


@words_of.register
def _(shown: Swarm) -> list[Part]:
    return words_of(quality(shown))


# -- answers ------------------------------------------------------------------------------


def _bare(swarm: Swarm) -> Scenario:
    """Return a scenario of a swarm and nothing else."""
    return Scenario(NAMELESS, "", swarm, None, None, (), 0.0)


@words_of.register
def _(shown: Quality) -> list[Part]:
    return _told(lambda: grade.show(_bare(shown.swarm), shown, (), None, SI))


@words_of.register
def _(shown: Sensitivities) -> list[Part]:
    return _told(lambda: grade.show(_bare(shown.swarm), shown.quality, (), shown, SI))


@words_of.register
def _(shown: Forces) -> list[Part]:
    return _told(lambda: forces.show(_bare(shown.swarm), shown, SI))


@words_of.register
def _(shown: ForcesAlong) -> list[Part]:
    rows = range(1, len(shown) + 1)
    return _told(lambda: trajectory.show(NAMELESS, shown, rows, SI))


@words_of.register
def _(shown: Placement) -> list[Part]:
    return _told(lambda: placement.show(NAMELESS, [shown], SI))


@words_of.register
def _(shown: Placements) -> list[Part]:
    return _told(lambda: placement.show(NAMELESS, shown, SI))


@words_of.register
def _(shown: Run) -> list[Part]:
    return _told(lambda: simulate.show(NAMELESS, shown, verdict_of(shown), SI))


SHOWS: Final[Sequence[tuple[type, Callable[..., None]]]] = (
    (Together, together.show),
    (HowMany, count.show),
    (Move, move.show),
    (Capability, capability.show),
    (CapabilityNumbers, capability_numbers.show),
    (CapabilityJoined, capability_joined.show),
    (CapabilityPlacement, place_for_capability.show),
    (ThrustUse, thrust_use.show),
)
"""How all others are told: with a name, the answer and the terms."""


def _by_name(show: Callable[..., None], shown: Any) -> list[Part]:
    """Return what is told of an answer."""
    return _told(lambda: show(NAMELESS, shown, SI))


for _kind, _show in SHOWS:
    words_of.register(_kind, partial(_by_name, _show))
