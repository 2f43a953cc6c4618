"""Scenarios as a page has them: text, document, and how their people speak."""

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from swarmgrasp.errors import FileFault, ScenarioInvalid
from swarmgrasp.gui.figures import LABELS
from swarmgrasp.gui.messages import Doc, Fault, Measure, Speech
from swarmgrasp.gui.replies import Scene, SceneTitle
from swarmgrasp.plain import plain
from swarmgrasp.scenario import Scenario, example_names, example_text, named_files, parse_scenario
from swarmgrasp.terms import Frame, Terms
from swarmgrasp.units import ANGLES, FORCES, LENGTHS, SPEEDS

_TAKES = re.compile(r"\b(file|table)\b")
"""What a text says that takes something from a file; others need not be looked through."""
_TITLE = re.compile(r"^name:\s*(.+?)\s*$", re.MULTILINE)
_KEY = re.compile(r"([\w.-]+): ")


@dataclass(frozen=True)
class Source:
    """A scene's text, and the files that texts may take from: paths as they say them, and where.

    `scenario` is what the text says, where that has been read.
    """

    text: str
    files: Mapping[str, Path] = field(default_factory=dict)
    scenario: Scenario | None = None

    @classmethod
    def beside(cls, text: str, folder: Path, scenario: Scenario | None = None) -> "Source":
        """Return the scene of a text in a folder; only the files that it names itself are read."""
        names = named_files(text) if _TAKES.search(text) else ()
        return cls(text, {path: folder / path for path in names}, scenario)


def built_in() -> dict[str, Source]:
    """Return the built-in scenes by name."""
    return {name: Source(example_text(name)) for name in example_names()}


def titles(sources: Mapping[str, Source]) -> tuple[SceneTitle, ...]:
    """Return the scenes to choose from, by their titles as they stand in the texts."""
    found = ((name, _TITLE.search(source.text)) for name, source in sources.items())
    return tuple(
        SceneTitle(name, match[1].strip("\"'") if match else name) for name, match in found
    )


def scene_of(n: int, name: str, source: Source) -> Scene:
    """Read a scene.

    Raises
    ------
    ScenarioInvalid
        If its text has faults.
    """
    scenario = source.scenario
    if scenario is None:
        scenario = parse_scenario(source.text, f"{name}.yaml", source.files)
    warnings = tuple(map(_fault, scenario.slips))
    return Scene(n, name, source.text, doc_of(scenario), speech_of(scenario), warnings)


def faults_of(error: ScenarioInvalid) -> tuple[Fault, ...]:
    """Return the faults of a scene's text."""
    return tuple(map(_fault, error.records))


def _fault(told: FileFault) -> Fault:
    """Return a fault as a page is told it."""
    return Fault(told.line, told.column, told.path, told.sentence)


def faults_in(told: Iterable[str]) -> tuple[Fault, ...]:
    """Return the faults of a document, each with the path of its key."""
    parts = ((_KEY.match(sentence), sentence) for sentence in told)
    return tuple(
        Fault(None, None, key[1] if key else "", sentence[key.end() :] if key else sentence)
        for key, sentence in parts
    )


def doc_of(scenario: Scenario) -> Doc:
    """Return the document of a scenario."""
    return Doc(
        name=scenario.name,
        description=scenario.description,
        problem=scenario.problem().to_data(),
        environment=plain(scenario.environment),
        in_weather=scenario.is_in_weather,
        newcomer=scenario.newcomer is not None,
    )


def speech_of(scenario: Scenario) -> Speech:
    """Return how a scenario's people speak; its forces in the prefix that suits its limits."""
    terms = scenario.terms
    force = terms.force
    if force == "N":
        limits = scenario.swarm.limits
        largest = max(
            float(limits.max(initial=0.0)), scenario.newcomer.limit if scenario.newcomer else 0.0
        )
        force = "MN" if largest >= 1e7 else "kN" if largest >= 1e3 else "N"
    return Speech(
        length=_measure(terms.length, LENGTHS),
        force=_measure(force, FORCES),
        angle=_measure("deg", ANGLES),
        speed=_measure(terms.speed, SPEEDS),
        torque_unit=f"{LABELS.get(force, force)}\u00a0{terms.length}",
        robot=terms.robot,
        bow=terms.frame.bow,
        mirrored=terms.frame.mirrored,
        heading=terms.frame.heading,
        bearings=terms.bearings,
    )


def terms_of(speech: Speech) -> Terms:
    """Return the terms that a page speaks in.

    Raises
    ------
    TermsInvalid
        If it names no unit that is known.
    """
    return Terms(
        length=speech.length.unit,
        force=speech.force.unit,
        speed=speech.speed.unit,
        frame=Frame(speech.bow, speech.mirrored, speech.heading),
        robot=speech.robot,
        bearings=speech.bearings,
    )


def _measure(unit: str, sizes: Mapping[str, float]) -> Measure:
    """Return a unit with its size."""
    return Measure(unit, sizes[unit], LABELS.get(unit, unit))
