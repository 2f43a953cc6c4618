"""An object as HTML within a page of others: its picture below its first line."""

from typing import Final

from swarmgrasp.capability import CapabilityPlacement
from swarmgrasp.forces import Forces, ForcesAlong
from swarmgrasp.inline.pictures import figure_of
from swarmgrasp.inline.words import words_of
from swarmgrasp.pages.page import Drawing, Paragraph, Part, html_part
from swarmgrasp.placement import HowMany, Move, Placement, Placements, Problem, Together
from swarmgrasp.plot import svg
from swarmgrasp.quality import Quality, Sensitivities
from swarmgrasp.scenario import Scenario
from swarmgrasp.swarm import Swarm

MOST_DRAWN: Final = 100
"""Robots that are drawn unless a picture is asked for."""


def html_of(shown: object) -> str:
    """Return the picture and the sentences of an object."""
    first, *rest = words_of(shown)
    swarm, picture = _swarm_of(shown), list[Part]()
    if swarm is None or len(swarm) <= MOST_DRAWN:
        said = first.text if isinstance(first, Paragraph) else ""
        picture = [Drawing("", svg(figure_of(shown), title=said), "")]
    else:
        picture = [Paragraph(f"More than {MOST_DRAWN} robots: plot() draws them.", "note")]
    return html_part([first, *picture, *rest])


def _swarm_of(shown: object) -> Swarm | None:
    """Return the robots that the picture of an object shows one by one."""
    match shown:
        case Swarm():
            return shown
        case Quality() | Sensitivities() | Forces() | ForcesAlong() | Problem() | Scenario():
            return shown.swarm
        case Placement() | Together() | HowMany() | Move():
            return shown.problem.swarm
        case Placements():
            return shown[0].problem.swarm
        case CapabilityPlacement():
            return shown.placement.problem.swarm
    return None
