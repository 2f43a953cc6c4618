"""The parts of an answer beside the answer itself: pictures and tables, each by itself."""

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass, replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.capability import capability
from swarmgrasp.errors import ForceSetUnsupported, SwarmGraspError
from swarmgrasp.gui.asking import Found
from swarmgrasp.gui.figures import Figures
from swarmgrasp.gui.replies import Empty
from swarmgrasp.gui.sending import framed, write_message
from swarmgrasp.gui.sphere import sphere
from swarmgrasp.gui.told_parts import (
    Ball,
    CapabilityPart,
    Figure,
    LandscapePart,
    LandscapePiece,
    Least,
    LossesPart,
    LossRow,
    MeshPart,
    ProofPart,
    Slope,
    SlopesPart,
)
from swarmgrasp.placement import landscape
from swarmgrasp.quality import losses, sensitivities
from swarmgrasp.swarm import Robot, Swarm
from swarmgrasp.wrench_set import WrenchSet

STEPS = 30_000
"""Whole steps from the middle of a body to its rim, and of a landscape."""
MOST_FACETED = 40
"""Robots whose wrench set is told facet by facet, if they push along a line each."""
FLAT = 1e-12
"""Area of a triangle that is none, relative to the largest."""
MOST_LOST = 300
"""Robots whose losses are told one by one, and whose places are compared cell by cell."""
COARSE, FINE = 15.0, 5.0
"""Degrees between bearings."""
COARSE_CELLS, FINE_CELLS = (120, 24), (240, 72)
"""Of the landscape: contacts on the allowed boundary, about, and directions."""


class Nothing(Exception):
    """A part has nothing to tell, for a reason."""


@dataclass(frozen=True)
class Sheet:
    """What one ask is answered.

    Attributes
    ----------
    n : int
    found : Found
    stopped : callable
        Whether it has been overtaken, and nobody waits for its parts.
    """

    n: int
    found: Found
    stopped: Callable[[], bool]

    @property
    def figures(self) -> Figures:
        """How figures are written."""
        return Figures(self.found.question.terms)


# -- the wrench set ------------------------------------------------------------------------


def mesh(sheet: Sheet, ms: Callable[[], float]) -> bytes:
    """Tell the wrench set of the worst case, moved by the load, with its ball."""
    found, criterion = sheet.found, sheet.found.problem.criterion
    swarm, load = found.after.worst_swarm, np.array(criterion.load)
    if not len(swarm):
        raise Nothing(f"There are no {found.question.terms.several}, and no wrenches.")
    is_few = len(swarm) <= MOST_FACETED and bool(swarm.is_line.all())
    body = _facets(swarm) if is_few else rounded(swarm)
    corners = body.corners + load * swarm.scale
    unit = (float(np.abs(corners).max()) or 1.0) / STEPS
    ball, radius = None, found.after.value
    if criterion.task is None and radius > 0.0:
        x, y, z = (radius * found.after.direction / unit).tolist()
        face = int(np.argmax(body.normals @ found.after.direction)) if is_few else None
        ball = Ball((0.0, 0.0, 0.0), radius / unit, (x, y, z), face)
    return framed(
        MeshPart(
            n=sheet.n, ms=ms(), unit=unit, ball=ball,
            before=found.before / unit if criterion.task is None else None,
            needed=(0.0, 0.0, 0.0), arrays=(),
        ),
        {
            "corners": np.rint(corners / unit).astype(np.int16),
            "faces": body.faces.astype(np.uint16),
            "starts": body.starts.astype(np.uint16),
            "normals": np.rint(body.normals * 127.0).astype(np.int8),
        },
    )  # fmt: skip


class Body(NamedTuple):
    """A body: corners (v, 3) [N] in the metric's coordinates, faces one after the other."""

    corners: NDArray[np.float64]
    faces: NDArray[np.int64]
    starts: NDArray[np.int64]
    normals: NDArray[np.float64]


def _facets(swarm: Swarm) -> Body:
    """Return the wrench set facet by facet."""
    found = WrenchSet(swarm).mesh()
    if not found.faces:
        raise Nothing("All wrenches lie in a line: the set has no inside.")
    faces = np.array([i for face in found.faces for i in face])
    starts = np.cumsum([0, *map(len, found.faces)])
    return Body(found.vertices * swarm.scale, faces, starts, found.normals)


def rounded(swarm: Swarm) -> Body:
    """Return the farthest wrenches in directions all round, joined as the directions are."""
    directions, triangles = sphere()
    corners = WrenchSet(swarm).farthest(directions * swarm.scale) * swarm.scale
    sides = corners[triangles]
    normals = np.cross(sides[:, 1] - sides[:, 0], sides[:, 2] - sides[:, 0])
    sizes = np.linalg.norm(normals, axis=1)
    middles = directions[triangles].sum(axis=1)
    middles /= np.linalg.norm(middles, axis=1)[:, None]
    is_flat = sizes <= FLAT * sizes.max(initial=0.0)  # some directions have one farthest wrench
    normals = np.where(is_flat[:, None], middles, normals / np.where(is_flat, 1.0, sizes)[:, None])
    starts = 3 * np.arange(len(triangles) + 1)
    return Body(corners, triangles.ravel(), starts, normals)


# -- weather from all round ----------------------------------------------------------------


def coarse_capability(sheet: Sheet, ms: Callable[[], float]) -> bytes:
    """Tell the winds held, every 15 degrees."""
    return _capability(sheet, ms, COARSE)


def fine_capability(sheet: Sheet, ms: Callable[[], float]) -> bytes:
    """Tell the winds held, every 5 degrees."""
    return _capability(sheet, ms, FINE)


def _capability(sheet: Sheet, ms: Callable[[], float], step: float) -> bytes:
    """Tell the winds held from all round, with the newcomer and without."""
    found, environment = sheet.found, sheet.found.question.environment
    if environment is None:
        raise Nothing("The scenario says nothing of what the object shows to the wind.")
    if not len(found.swarm):
        raise Nothing(f"There are no {found.question.terms.several} to hold it.")
    criterion = found.problem.criterion
    losing = criterion.losing or int(not criterion.failures)
    bearings = np.radians(np.arange(0.0, 360.0 - 1e-9, step))
    asked: tuple[Any, ...] = environment, bearings, losing, criterion.worst_case, criterion.failures
    after = capability(found.swarm, *asked)
    arrays = {"bearings": bearings, "intact": after.intact, "lost": after.after_loss}
    is_less = bool(criterion.losing or criterion.failures)
    held = after.after_loss if is_less else after.intact
    worst = after.worst_after_loss if is_less else after.worst
    shown = None
    if found.placement is not None:
        before = capability(found.problem.swarm, *asked)
        arrays |= {"before_intact": before.intact, "before_lost": before.after_loss}
        least = before.after_loss if is_less else before.intact
        shown = sheet.figures.in_speed(float(least.min()))
    bearing, speed = float(bearings[worst]), float(held[worst])
    words = f"least wind held{' after a loss' * is_less}, from {sheet.figures.coming(bearing)}"
    figure = Figure(shown, sheet.figures.in_speed(speed), sheet.figures.terms.speed, words)
    return framed(
        CapabilityPart(n=sheet.n, ms=ms(), least=Least(bearing, speed), figure=figure, arrays=()),
        {name: values.astype(np.float32) for name, values in arrays.items()},
    )


# -- losses and slopes ---------------------------------------------------------------------


def told_losses(sheet: Sheet, ms: Callable[[], float]) -> bytes:
    """Tell what the loss of each leaves, beside those that are lost anyway but one."""
    found = sheet.found
    swarm, criterion = found.swarm, found.problem.criterion
    if len(swarm) > MOST_LOST:
        raise Nothing(
            f"Each loss by itself is not asked past {MOST_LOST} {found.question.terms.several}; "
            "\u201close 1\u201d above asks for the worst."
        )
    if len(swarm) < 2:
        raise Nothing("Nobody is left when one is lost.")
    beside = replace(criterion, losing=max(0, criterion.losing - 1))
    rows = losses(swarm, **beside.keywords)
    whole = rows[0].quality_before
    told = tuple(
        LossRow(
            row.name, row.quality, row.quality > 0.0, rank == 0,
            sheet.figures.force(row.quality) if row.quality > 0.0 else "not held",
        )
        for rank, row in enumerate(rows)
    )  # fmt: skip
    text = f"all there: {sheet.figures.forces(whole)}"
    return write_message(LossesPart(n=sheet.n, ms=ms(), rows=told, all=whole, text=text))


def slopes(sheet: Sheet, ms: Callable[[], float]) -> bytes:
    """Tell how fast the quality rises when one moves or turns."""
    found = sheet.found
    swarm, criterion = found.swarm, found.problem.criterion
    if criterion.worst_case:
        raise Nothing("Slopes are of robots whose poses are known.")
    if len(swarm) > MOST_LOST or not len(swarm):
        raise Nothing("Slopes are shown of few robots only.")
    try:
        rates = sensitivities(swarm, **criterion.keywords)
    except ForceSetUnsupported as error:
        raise Nothing(error.faults[0]) from None
    rows = zip(swarm, rates.contact.tolist(), rates.direction_per_degree.tolist(), strict=True)
    told = tuple(_slope(sheet, robot, metre, degree) for robot, metre, degree in rows)
    return write_message(SlopesPart(n=sheet.n, ms=ms(), rows=told))


def _slope(sheet: Sheet, robot: Robot, metre: list[float], degree: list[float]) -> Slope:
    """Return the slopes of a robot: clockwise, and counter-clockwise."""
    per_metre, direction = None, None
    if not math.isnan(metre[0]):
        outline = sheet.found.swarm.outline
        contact, ahead = outline.at_point(robot.contact), metre[1] >= metre[0]
        per_metre, direction = max(metre), contact.inward - 0.5 * math.pi
        if not ahead:
            before = contact.edge - contact.is_corner
            direction = outline.inward_normal(before % len(outline)) + 0.5 * math.pi
    turn = None
    if not math.isnan(degree[0]):
        turn = degree[1] if degree[1] >= degree[0] else -degree[0]
    return Slope(robot.name, per_metre, direction, turn, _slope_words(sheet, per_metre, degree))


def _slope_words(sheet: Sheet, metre: float | None, degree: list[float]) -> str:
    """Say what a move and a turn bring."""
    figures, parts = sheet.figures, []
    if metre is not None and metre > 0.0:
        parts.append(f"{figures.forces(metre)} a metre")
    best = max(degree)
    if best > 0.0:
        way = "clockwise" if degree[0] == best else "counter-clockwise"
        parts.append(f"{figures.forces(best)} a degree {way}")
    return ", ".join(parts) or "nothing to gain"


# -- all places ----------------------------------------------------------------------------


def coarse_landscape(sheet: Sheet, ms: Callable[[], float]) -> bytes:
    """Tell the quality at some allowed places, in some directions."""
    return _landscape(sheet, ms, COARSE_CELLS)


def fine_landscape(sheet: Sheet, ms: Callable[[], float]) -> bytes:
    """Tell the quality at many allowed places, in many directions."""
    return _landscape(sheet, ms, FINE_CELLS)


def _landscape(sheet: Sheet, ms: Callable[[], float], cells: tuple[int, int]) -> bytes:
    """Tell the quality at allowed places, in allowed directions; nothing if it is overtaken."""
    found, outline = sheet.found, sheet.found.swarm.outline
    if found.placement is None:
        raise Nothing(found.nowhere or "There is nobody to place.")
    if len(found.swarm) > MOST_LOST:
        raise Nothing(
            f"Places are not compared cell by cell past {MOST_LOST} "
            f"{found.question.terms.several}; the best one is still proven."
        )
    if found.problem.newcomer.mounted:
        raise Nothing("Places inside are not compared one by one; the best is still proven.")
    patches = landscape(found.asked, *cells, stop=sheet.stopped)
    flat = np.concatenate([patch.values.ravel() for patch in patches])
    best = np.concatenate([patch.values.max(axis=1) for patch in patches])
    if np.isnan(flat).any():
        return b""
    firsts = np.cumsum([0, *(patch.values.size for patch in patches)]).tolist()
    told = tuple(
        LandscapePiece(
            patch.place, outline.edge_label(patch.edge), float(patch.arc_lengths[0]),
            float(patch.arc_lengths[-1]), tuple(patch.arc_lengths.tolist()),
            tuple((patch.angles + (0.0 if patch.inward else math.pi)).tolist()), first,
        )
        for patch, first in zip(patches, firsts, strict=False)
    )  # fmt: skip
    if found.about == "wind":
        flat, best = np.sqrt(flat), np.sqrt(best)
    low, high = float(flat.min()), float(flat.max())
    unit = (high or 1.0) / STEPS
    arrays = {"values": _steps(flat, unit), "strip": _steps(best, unit)}
    part = LandscapePart(n=sheet.n, ms=ms(), pieces=told, unit=unit, low=low, high=high, arrays=())
    return framed(part, arrays)


def _steps(values: NDArray[np.float64], unit: float) -> NDArray[np.uint16]:
    """Return values as whole numbers, one more than steps of a unit."""
    return (1 + np.rint(values / unit)).astype(np.uint16)


def proof(sheet: Sheet, ms: Callable[[], float]) -> bytes:
    """Tell what the check says."""
    if sheet.found.placement is None:
        raise Nothing("There is nothing to check.")
    verdict = sheet.found.placement.verify()
    text = "checked by code that shares nothing with the search" if verdict else verdict.faults[0]
    return write_message(ProofPart(n=sheet.n, ms=ms(), ok=bool(verdict), text=text))


FINELY, FINE_LANDSCAPE = "capability, fine", "landscape, fine"
NAMED: Mapping[str, Any] = {FINELY: "capability", FINE_LANDSCAPE: "landscape"}
"""What parts are called in the page, where it is another name."""
FINER: Mapping[str, str] = {coarse: fine for fine, coarse in NAMED.items()}
"""Parts that have a finer one of their name."""
PARTS: Mapping[str, Callable[[Sheet, Callable[[], float]], bytes]] = {
    "mesh": mesh,
    "capability": coarse_capability,
    "losses": told_losses,
    "landscape": coarse_landscape,
    "slopes": slopes,
    FINE_LANDSCAPE: fine_landscape,
    FINELY: fine_capability,
    "proof": proof,
}
"""The parts, in the order in which they are told."""
MOVING = ("mesh", "capability", "losses", "landscape")
"""Those told in a gesture, if they are cheap."""


def tell(part: str, sheet: Sheet, ms: Callable[[], float]) -> bytes:
    """Return a part as it goes over the wire, or why it has nothing."""
    try:
        return PARTS[part](sheet, ms)
    except Nothing as why:
        said = str(why)
    except SwarmGraspError as error:
        said = error.faults[0]
    return write_message(Empty(sheet.n, NAMED.get(part, part), said))
