"""How a scenario file speaks: its frame, and the terms in which answers to it are told."""

import math
from typing import Any

from swarmgrasp.scenario.schema import ScenarioFile
from swarmgrasp.scenario.units import Units
from swarmgrasp.terms import Frame, Terms


def frame_of(file: ScenarioFile) -> Frame:
    """Return how the coordinates and directions of a file lie in ours."""
    plain = Units(**file.units.model_dump())
    heading = None if file.heading is None else plain.radians(file.heading) % math.tau
    return Frame(plain.radians(file.bow), file.frame == "NED", heading)


def terms_of(file: ScenarioFile, units: Units) -> Terms:
    """Return the terms in which answers to a file are told."""
    word = file.words if isinstance(file.words, str | None) else file.words.robot
    named: dict[str, Any] = {"robot": word} if word else {}
    return Terms(**file.units.model_dump(), frame=units.frame, **named)
