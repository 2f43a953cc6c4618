"""A run as an MCAP file for Foxglove: where everything is, and how hard the robots push.

The topics are `/tf` (where the object is and should be, in the earth's frame), in these frames the
scenes `/outlines` (once), `/names` (as they change) and `/forces`, and `/state` (numbers, as JSON).
Whoever goes to another time is shown the last message of each topic, which is therefore whole. The
clock starts at 0.
"""

import math
from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

from swarmgrasp.files import scratch_for
from swarmgrasp.packages import check_installed
from swarmgrasp.simulation.export import colours
from swarmgrasp.simulation.export.scene import Film, Pusher, Scene
from swarmgrasp.simulation.run import Run

if TYPE_CHECKING:
    from foxglove.messages import Color, FrameTransform, Pose, SceneEntity, Timestamp

EARTH, OBJECT, TARGET = "earth", "object", "target"
"""The frames."""
MOST = 20_000
"""Instants that are written, at most."""
LONGEST = 0.25
"""Length of the arrow of the largest limit, relative to the object's extent."""
STATE = {
    "title": "swarmgrasp.State",
    "type": "object",
    "properties": {
        "x": {"type": "number", "description": "m"},
        "y": {"type": "number", "description": "m"},
        "heading": {"type": "number", "description": "rad"},
        "error": {"type": "number", "description": "m"},
        "turn": {"type": "number", "description": "rad"},
        "shortfall": {"type": "number", "description": "N"},
        "wind": {"type": "array", "items": {"type": "number"}, "description": "m/s"},
        "water": {"type": "array", "items": {"type": "number"}, "description": "m/s"},
        "shares": {
            "type": "object",
            "description": "of each robot's limit",
            "additionalProperties": {"type": "number"},
        },
        "happened": {"type": "string"},
    },
}
"""The schema of `/state`."""


def write_mcap(run: Run, path: str | Path, *, index: int = 0) -> Path:
    """Write one of the runs as an MCAP file, whole or not at all.

    Parameters
    ----------
    run : Run
    path : str or Path
    index : int
        Which of the runs.

    Returns
    -------
    Path

    Raises
    ------
    PackageMissing
        Without foxglove-sdk.
    """
    check_installed("foxglove", extra="logs", purpose="An MCAP file")
    import foxglove
    from foxglove.channels import FrameTransformsChannel, SceneUpdateChannel
    from foxglove.messages import FrameTransforms, SceneUpdate

    target, film = Path(path), Film(run, index)
    context = foxglove.Context()
    with scratch_for(target) as scratch, foxglove.open_mcap(scratch, context=context):
        frames = FrameTransformsChannel("/tf", context=context)
        outlines, names, forces = (
            SceneUpdateChannel(topic, context=context)
            for topic in ("/outlines", "/names", "/forces")
        )
        state = foxglove.Channel("/state", schema=STATE, context=context)
        there: tuple[str, ...] | None = None
        for i in film.picked(MOST):
            scene = film.at(i)
            at = round(1e9 * scene.time)
            frames.log(FrameTransforms(transforms=list(_transforms(scene))), log_time=at)
            if i == 0:
                outlines.log(SceneUpdate(entities=_outlines(film, scene)), log_time=at)
            now = tuple(pusher.robot.name for pusher in scene.pushers)
            if now != there:
                there = now
                names.log(SceneUpdate(entities=[_names(film, scene)]), log_time=at)
            forces.log(SceneUpdate(entities=[_forces(film, scene)]), log_time=at)
            state.log(_numbers(run, scene, index, i), log_time=at)
    return target


def _numbers(run: Run, scene: Scene, index: int, i: int) -> dict[str, Any]:
    """Return the numbers of an instant."""
    shares = run.shares[index, i].tolist()
    x, y, heading = scene.pose.tolist()
    return {
        "x": x,
        "y": y,
        "heading": heading,
        "error": scene.error,
        "turn": scene.turn,
        "shortfall": scene.shortfall,
        "wind": scene.wind.tolist(),
        "water": scene.water.tolist(),
        "shares": dict(zip(run.names, shares, strict=True)),
        "happened": scene.happening.words,
    }


def _transforms(scene: Scene) -> "Iterator[FrameTransform]":
    """Yield where the object is and where it should be."""
    from foxglove.messages import FrameTransform, Vector3

    for frame, (x, y, heading) in ((OBJECT, scene.pose), (TARGET, scene.reference)):
        yield FrameTransform(
            timestamp=_stamp(scene.time),
            parent_frame_id=EARTH,
            child_frame_id=frame,
            translation=Vector3(x=float(x), y=float(y), z=0.0),
            rotation=_turn(float(heading)),
        )


def _outlines(film: Film, scene: Scene) -> "list[SceneEntity]":
    """Return the object's outline, where it is and where it should be."""
    from foxglove.messages import LinePrimitive, LinePrimitiveLineType, Point3, SceneEntity

    corners = (film.run.simulation.problem.swarm.outline.vertices - film.origin).tolist()
    points = [Point3(x=x, y=y, z=0.0) for x, y in corners]
    return [
        SceneEntity(
            timestamp=_stamp(scene.time),
            frame_id=frame,
            id=frame,
            frame_locked=True,
            lines=[
                LinePrimitive(
                    type=LinePrimitiveLineType.LineLoop,
                    pose=_pose(0.0, 0.0, 0.0),
                    thickness=thickness,
                    scale_invariant=True,
                    points=points,
                    color=_colour(colour),
                )
            ],
        )
        for frame, thickness, colour in ((OBJECT, 3.0, colours.INK), (TARGET, 1.0, colours.GREY))
    ]


def _names(film: Film, scene: Scene) -> "SceneEntity":
    """Return the names of those that hold the object."""
    from foxglove.messages import SceneEntity, TextPrimitive

    texts = []
    for pusher in scene.pushers:
        x, y = pusher.robot.contact - film.origin
        texts.append(
            TextPrimitive(
                pose=_pose(float(x), float(y), 0.0),
                billboard=True,
                font_size=12.0,
                scale_invariant=True,
                color=_colour(colours.INK),
                text=pusher.robot.name,
            )
        )
    return SceneEntity(
        timestamp=_stamp(scene.time), frame_id=OBJECT, id="names", frame_locked=True, texts=texts
    )


def _forces(film: Film, scene: Scene) -> "SceneEntity":
    """Return the forces of those that hold the object, and those who are on their way."""
    from foxglove.messages import SceneEntity, SpherePrimitive, Vector3

    extent = film.run.simulation.problem.swarm.outline.extent
    strongest = max((robot.limit for robot in film.robots.values()), default=1.0)
    size = 0.02 * extent
    coming = []
    for _, point in scene.travellers:
        x, y = _in_object(point, scene)
        coming.append(
            SpherePrimitive(
                pose=_pose(x, y, 0.0),
                size=Vector3(x=size, y=size, z=size),
                color=_colour(colours.ORANGE),
            )
        )
    return SceneEntity(
        timestamp=_stamp(scene.time),
        frame_id=OBJECT,
        id="robots",
        frame_locked=True,
        arrows=[
            _arrow(film, pusher, LONGEST * extent / strongest, size)
            for pusher in scene.pushers
            if pusher.force.any()
        ],
        spheres=coming,
    )


def _arrow(film: Film, pusher: Pusher, scale: float, thickness: float) -> Any:
    """Return the arrow of a force: it ends at the contact if it goes into the object."""
    from foxglove.messages import ArrowPrimitive

    x, y = pusher.robot.contact - film.origin
    length = scale * math.hypot(*pusher.force)
    heading = math.atan2(pusher.force[1], pusher.force[0])
    if film.pushes(pusher):
        x, y = x - length * math.cos(heading), y - length * math.sin(heading)
    head = min(length, 2.0 * thickness)
    return ArrowPrimitive(
        pose=_pose(float(x), float(y), heading),
        shaft_length=length - head,
        shaft_diameter=0.5 * thickness,
        head_length=head,
        head_diameter=thickness,
        color=_colour(colours.BLUE),
    )


def _in_object(point: Any, scene: Scene) -> tuple[float, float]:
    """Return a point of the earth's frame in the object's."""
    x, y, heading = scene.pose.tolist()
    dx, dy = float(point[0]) - x, float(point[1]) - y
    cos, sin = math.cos(heading), math.sin(heading)
    return cos * dx + sin * dy, cos * dy - sin * dx


def _stamp(time: float) -> "Timestamp":
    """Return a time [s] as Foxglove writes it."""
    from foxglove.messages import Timestamp

    nanoseconds = round(1e9 * time)
    return Timestamp(sec=nanoseconds // 10**9, nsec=nanoseconds % 10**9)


def _turn(heading: float) -> Any:
    """Return a turn about the vertical."""
    from foxglove.messages import Quaternion

    return Quaternion(x=0.0, y=0.0, z=math.sin(0.5 * heading), w=math.cos(0.5 * heading))


def _pose(x: float, y: float, heading: float) -> "Pose":
    """Return a place and a heading in the plane."""
    from foxglove.messages import Pose, Vector3

    return Pose(position=Vector3(x=x, y=y, z=0.0), orientation=_turn(heading))


def _colour(colour: str) -> "Color":
    """Return a colour."""
    from foxglove.messages import Color

    red, green, blue = colours.shares(colour)
    return Color(r=red, g=green, b=blue, a=1.0)
