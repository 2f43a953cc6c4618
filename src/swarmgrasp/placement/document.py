"""Answers as JSON: complete enough that a stranger can check them."""

import json
from collections.abc import Sequence
from itertools import pairwise
from pathlib import Path
from typing import Any

from swarmgrasp.errors import AnswerInvalid
from swarmgrasp.files import write_whole
from swarmgrasp.outline import Stretch
from swarmgrasp.placement.answer import Placement
from swarmgrasp.quality.criterion import Criterion
from swarmgrasp.quality.task import Polytope
from swarmgrasp.swarm import Robot, Tolerance, Zone
from swarmgrasp.verify.digest import digest_of

FORMAT = "swarmgrasp answer 2"
LARGEST_FILE = 50_000_000
"""Bytes; an answer for 1 000 robots takes about 0.2 MB."""


def document_of(answers: Placement | Sequence[Placement]) -> dict[str, Any]:
    """Return answers as plain data: one placement, or a sequence of them.

    Lengths are in m, forces in N, angles in rad, in the frame of the vertices.

    Parameters
    ----------
    answers : Placement or sequence of Placement
        As given by `place_sequence`: each finds the robots of those before it.

    Raises
    ------
    AnswerInvalid
        If there is none, or they do not follow one from the other.
    """
    answers = (answers,) if isinstance(answers, Placement) else tuple(answers)
    if not answers:
        raise AnswerInvalid("there is no answer to write")
    for before, after in pairwise(answers):
        found, left = after.problem.swarm, before.swarm_after
        if found is not left and found.robots != left.robots:
            raise AnswerInvalid(
                f"{after.robot.name or 'a robot'} was placed in another swarm than the one that "
                f"{before.robot.name or 'the robot before it'} joined: write them apart"
            )
    swarm = answers[0].problem.swarm
    outline = swarm.outline
    document = {
        "format": FORMAT,
        "outline": {
            "vertices": outline.vertices.tolist(),
            "origin": outline.origin.tolist(),
            "edge_names": list(outline.edge_names),
            "precision": outline.precision,
        },
        "metric": {
            "force_weights": list(swarm.force_weights),
            "characteristic_length": swarm.characteristic_length,
        },
        "robots": [_robot(robot) for robot in swarm.robots],
        "placements": [_placement(answer) for answer in answers],
    }
    return {**document, "digest": digest_of(document)}


def answer_text(answers: Placement | Sequence[Placement]) -> str:
    """Return answers as the text of a JSON file."""
    return json.dumps(document_of(answers), indent=1, ensure_ascii=False) + "\n"


def write_answer(path: str | Path, answers: Placement | Sequence[Placement]) -> None:
    """Write answers to a JSON file, whole or not at all.

    Examples
    --------
    >>> from tempfile import TemporaryDirectory
    >>> from swarmgrasp import Newcomer, Outline, Robot, Swarm, place
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> crew = [Robot((1, 0.3), 3.0), Robot((-1, 0.5), 0.4), Robot((0.2, -1), 1.7)]
    >>> answer = place(Swarm(square, crew), Newcomer(attachment="push"))
    >>> with TemporaryDirectory() as folder:
    ...     write_answer(f"{folder}/answer.json", answer)
    ...     sorted(read_answer(f"{folder}/answer.json"))[:3]
    ['digest', 'format', 'metric']
    """
    write_whole(path, answer_text(answers).encode())


def read_answer(path: str | Path) -> dict[str, Any]:
    """Read an answer file, unchecked but for being JSON.

    Raises
    ------
    AnswerInvalid
        If it cannot be read, is too large, or is not a JSON object; with file and line.
    """
    try:
        with Path(path).open("rb") as file:
            return parse_answer(file.read(LARGEST_FILE + 1), str(path))
    except OSError as error:
        raise AnswerInvalid(f"{path}: cannot be read: {error.strerror}") from None
    except ValueError as error:
        if isinstance(error, AnswerInvalid):
            raise
        raise AnswerInvalid(f"{str(path)!r}: not a path: {error}") from None


def parse_answer(content: bytes, source: str) -> dict[str, Any]:
    """Do the same for the bytes of a file; `source` names it in messages."""
    if len(content) > LARGEST_FILE:
        raise AnswerInvalid(f"{source}: more than {LARGEST_FILE} bytes, too many for an answer")
    try:
        document = json.loads(content.decode())
    except UnicodeDecodeError as error:
        raise AnswerInvalid(f"{source}: not UTF-8 text (byte {error.start})") from None
    except json.JSONDecodeError as error:
        raise AnswerInvalid(f"{source}:{error.lineno}:{error.colno}: {error.msg}") from None
    except (RecursionError, ValueError) as error:  # nested too deeply, or a number too long
        raise AnswerInvalid(f"{source}: not an answer: {error}") from None
    if not isinstance(document, dict):
        raise AnswerInvalid(f"{source}:1:1: an answer is a JSON object")
    return document


def _number(value: float | None) -> float | None:
    return None if value is None else float(value)


def _robot(robot: Robot) -> dict[str, Any]:
    return {
        "contact": list(robot.contact),
        "direction": float(robot.direction),
        "limit": float(robot.limit),
        "name": robot.name,
        "mounted": robot.mounted,
        "tolerance": _tolerance(robot.tolerance),
    }


def _tolerance(tolerance: Tolerance | None) -> dict[str, Any] | None:
    if tolerance is None:
        return None
    return {
        "contact": list(tolerance.offsets),
        "direction": list(tolerance.turns),
        "least_limit": _number(tolerance.least_limit),
        "may_be_absent": tolerance.may_be_absent,
    }


def _criterion(criterion: Criterion) -> dict[str, Any]:
    task = criterion.task
    kind = "polytope" if isinstance(task, Polytope) else "ellipsoid"
    return {
        "losing": criterion.losing,
        "worst_case": criterion.worst_case,
        "load": list(criterion.load),
        "task": None if task is None else {"kind": kind, "rows": task.generators.tolist()},
    }


def _stretch(stretch: Stretch) -> dict[str, Any]:
    return {"start": float(stretch.start), "end": float(stretch.end), "name": stretch.name}


def _zone(zone: Zone) -> dict[str, Any]:
    return {
        **_stretch(zone.stretch),
        "attachment": zone.attachment,
        "half_angle": _number(zone.half_angle),
        "directions": None
        if zone.directions is None
        else [float(angle) for angle in zone.directions],
    }


def _placement(answer: Placement) -> dict[str, Any]:
    problem, newcomer = answer.problem, answer.problem.newcomer
    return {
        "criterion": _criterion(problem.criterion),
        "newcomer": {
            "limit": float(newcomer.limit),
            "attachment": newcomer.attachment,
            "half_angle": _number(newcomer.half_angle),
            "name": newcomer.name,
            "tolerance": _tolerance(newcomer.tolerance),
        },
        "zones": None if problem.zones is None else [_zone(zone) for zone in problem.zones],
        "no_go": [_stretch(stretch) for stretch in problem.no_go],
        "spacing": float(problem.spacing),
        "robot": _robot(answer.robot),
        "place": answer.place,
        "quality_before": answer.quality_before,
        "quality": answer.quality,
        "upper_bound": answer.upper_bound,
        "asked_gap": answer.asked_gap,
        "stopped_early": answer.stopped_early,
        "improves": answer.improves,
        "reason": answer.reason,
        "runners_up": [
            {"robot": _robot(r.robot), "quality": r.quality, "place": r.place}
            for r in answer.runners_up
        ],
        "proofs": [
            {"normals": proof.normals.tolist(), "weights": proof.weights.tolist()}
            for proof in answer.certificate.proofs
        ],
    }
