"""What a file says that is no fault, and is probably not what its writer means.

Each slip is told once, at the first place where it shows, with what to do about it. A file that is
merely unusual has none: what is looked for is what follows from one slip and hardly from anything
else.
"""

import math
import re
from collections.abc import Iterator

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.errors import FileFault
from swarmgrasp.outline.lines import meeting
from swarmgrasp.placement.room import Room, pulls_on_line
from swarmgrasp.scenario.faults import Faults, Path
from swarmgrasp.scenario.force_sets import largest
from swarmgrasp.scenario.quantities import measured
from swarmgrasp.scenario.scenario import Scenario
from swarmgrasp.scenario.schema import ScenarioFile
from swarmgrasp.scenario.units import Units
from swarmgrasp.scenario.unreal import Slip, unreal
from swarmgrasp.scenario.validate import Checked
from swarmgrasp.units import LENGTHS, is_geographic
from swarmgrasp.words import list_words, trimmed

APART = 500.0
"""How many times as strong as the weakest robot the strongest is where two units are mixed up: a
prefix too many is 1000 times, and robots differ by themselves."""
LONGER = 1.2
"""How many times as long across the bow as along it an outline is that is drawn the other way."""
OFF = 0.05
"""Share of the outline's width by which what is on the wrong side is off the middle."""
_ROUNDED = 1e-3
"""Least error of radians that are written with three decimals, each [rad]."""
_DIRECTIONS = frozenset(("direction", "theta", "sectors", "directions"))
_SIDES = {"port": (1, 1.0), "starboard": (1, -1.0), "stbd": (1, -1.0)}
_ENDS = {"bow": (0, 1.0), "stern": (0, -1.0)}
"""Words for where something is: the axis, and the sign along it."""
_OTHERWISE = {"port": "starboard", "starboard": "port", "stbd": "port"}
_BESIDE = re.compile(
    "and|aft|amidships|azimuth|bollard|corner|end|engine|fender|fore|forward|front|fwd|inner|inside"
    "|jet|main|mid|middle|midships?|of|outer|outside|pad|pod|propeller|pusher?|quarter|robot"
    "|shoulder|side|the|thruster|to|tug|tunnel|winch|port|starboard|stbd|bow|stern"
)
"""What else a robot's name may say beside a side: others, as of a harbour, are none."""


def slips_of(checked: Checked, units: Units, scenario: Scenario) -> tuple[FileFault, ...]:
    """Return what is probably a slip, each with its line, column and key, in the file's order.

    Parameters
    ----------
    checked : Checked
    units : Units
    scenario : Scenario
        Made of it.
    """
    found = Faults(checked.faults.source)
    for path, sentence in (
        *_angles(checked, units),
        *_sides(checked, units, scenario),
        *_lengthwise(checked, units, scenario),
        *_degrees_of_the_globe(checked, units),
        *_limits(checked, units),
        *_lines(units, scenario),
        *_bodies(scenario),
        *unreal(checked, units),
    ):
        found.add(checked.root.find(path).mark, path, sentence)
    return found.listed()


# -- angles -------------------------------------------------------------------------------


def _angles(checked: Checked, units: Units) -> Iterator[Slip]:
    """Tell degrees that are read as radians, and radians that are read as degrees."""
    plain = [
        (path, node.value, node.raw)
        for path, node in measured(checked.root, ScenarioFile, ("angle", "bearing", "heading"))
        if isinstance(node.value, int | float) and path[0] != "simulation"
    ]
    if units.angle == "rad":
        # the second end of a range may be a turn further
        many = [(path, v, raw) for path, v, raw in plain if abs(v) > math.tau * (1 + _is_end(path))]
        if many:
            path, value, raw = many[0]
            more = f" There {_more(len(many) - 1)} like it." if many[1:] else ""
            said = f"{raw} rad is {abs(value) / math.tau:.3g} turns; for degrees, write"
            yield path, f"{said} units: {{angle: deg}}, or {raw} deg here.{more}"
        return
    ways = [(path, v, raw) for path, v, raw in plain if _DIRECTIONS & set(path) and v]
    if ways and all(_is_part_of_turn(value) for _, value, _ in ways):
        path, _, raw = ways[0]
        said = f"{raw} deg is next to nothing, and as radians it is a common angle; for radians, "
        yield path, f"{said}write units: {{angle: rad}}, or {raw} rad here."


def _is_end(path: Path) -> bool:
    """Tell whether an angle is one end of a range."""
    return isinstance(path[-1], int)


def _is_part_of_turn(value: float) -> bool:
    """Tell whether a number is a multiple of a 24th of a turn in radians, up to one turn."""
    off = math.remainder(value, math.pi / 12.0)
    return _ROUNDED < abs(value) <= math.tau + _ROUNDED and abs(off) <= _ROUNDED


def _more(count: int) -> str:
    """Say how many more there are."""
    return "is one more" if count == 1 else f"are {count} more"


# -- sides --------------------------------------------------------------------------------


def _sides(checked: Checked, units: Units, scenario: Scenario) -> Iterator[Slip]:
    """Tell edges and robots that are called by one side and lie on the other."""
    outline = scenario.swarm.outline
    named = {name: i for i, name in enumerate(checked.file.outline.edges or ()) if name}
    ends = [outline.edge_ends(i) for i in range(len(outline))]
    edges: list[tuple[Path, str, NDArray[np.float64]]] = [
        (("outline", "edges", named[name]), name, 0.5 * (start + end))
        for name, (start, end) in zip(outline.edge_names, ends, strict=True)
        if name in named
    ]
    robots: list[tuple[Path, str, NDArray[np.float64]]] = [
        (("robots", i, "name"), robot.name, np.array(robot.contact))
        for i, robot in enumerate(scenario.swarm.robots)
        if all(map(_BESIDE.fullmatch, _words(robot.name)))
    ]
    middle = 0.5 * (outline.vertices.min(axis=0) + outline.vertices.max(axis=0))
    width = np.ptp(outline.vertices, axis=0)
    for things in (edges, robots):
        for places in (_ENDS, _SIDES):
            wrong = sorted(
                (path, name, word)
                for path, name, spot in things
                for word, (axis, sign) in places.items()
                if _words(name) & places.keys() == {word}
                and sign * (spot - middle)[axis] < -OFF * width[axis]
            )
            if wrong:
                yield wrong[0][0], _wrong_side(wrong, units)
                break  # what is turned by half a turn is wrong in both ways


def _words(name: str) -> set[str]:
    """Return the words of a name that are longer than a letter."""
    return set(re.findall(r"[a-z]{2,}", name.lower()))


def _wrong_side(wrong: list[tuple[Path, str, str]], units: Units) -> str:
    """Say what is on the wrong side, and what to do about it."""
    names = list_words([repr(name) for _, name, _ in wrong[:4]])
    names += f" and {len(wrong) - 4} more" if wrong[4:] else ""
    verb = "lies" if len(wrong) == 1 else "lie"
    word = wrong[0][2]
    if word in _ENDS:
        where = "forward" if word == "stern" else "aft"
        return f"{names} {verb} {where} of the middle; say which way the bow points, by bow"
    where = f"to {_OTHERWISE[word]}" if len(wrong) == 1 else "on the other side"
    said = f"{names} {verb} {where} as the file is read, with "
    if units.frame.bow:
        return f"{said}this frame and bow; if its angles run the other way, change frame"
    if units.frame.mirrored:
        return f"{said}y to starboard; if y runs to port in it, leave out frame: NED"
    return f"{said}y to port; if y runs to starboard in it, write frame: NED"


# -- the object ---------------------------------------------------------------------------


def _lengthwise(checked: Checked, units: Units, scenario: Scenario) -> Iterator[Slip]:
    """Tell a hull that is longest across its bow, by the areas that wind and current meet."""
    around = checked.file.environment
    long, wide = np.ptp(scenario.swarm.outline.vertices, axis=0).tolist()
    if around is None or wide <= LONGER * long:
        return
    for stream, section in (("wind", around.wind), ("current", around.current)):
        if section is None or section.lateral_area is None or section.frontal_area is None:
            continue
        if section.lateral_area > section.frontal_area:
            along, across = (trimmed(size / units.metres(1.0), 4) for size in (long, wide))
            yield (
                ("environment", stream, "lateral_area"),
                "is larger than the frontal area, and so the object should be longest along its "
                f"bow; but the outline is {along} {units.length} along the bow and {across} "
                f"{units.length} across it. Say which way the bow points, such as by bow: +y",
            )
            return


def _degrees_of_the_globe(checked: Checked, units: Units) -> Iterator[Slip]:
    """Tell longitudes and latitudes that are read as lengths."""
    corners = np.array(checked.file.outline.vertices)
    written = checked.root.find(("outline", "vertices", 0, 0))
    if not isinstance(written.value, str) and is_geographic(corners):
        size = float(np.linalg.norm(np.ptp(corners, axis=0)))
        yield (
            ("outline", "vertices"),
            f"these look like longitude and latitude, and are read as an object {size:.3g} "
            f"{units.length} across; give coordinates in {units.length} from a point nearby",
        )


def _limits(checked: Checked, units: Units) -> Iterator[Slip]:
    """Tell limits that are so far apart that one seems to be in another unit."""
    file = checked.file
    forces: list[tuple[float, Path, str]] = [
        (largest(robot), ("robots", i), robot.name or f"robot {i + 1}")
        for i, robot in enumerate(file.robots)
    ]
    forces += [
        (largest(section), path, section.name or "the newcomer")
        for section, path in checked.newcomers()
    ]
    if not forces:
        return
    (least, path, _), (most, _, strongest) = min(forces), max(forces)
    if most >= APART * least:
        key = "limit" if checked.has(*path, "limit") else "envelope"
        said = f"{trimmed(least, 6)} {units.force} is {trimmed(most / least, 4)} times less than "
        said += f"the {trimmed(most, 6)} {units.force} of {strongest}; are both in "
        yield (*path, key), f"{said}{units.force}?"


# -- lines and bodies ---------------------------------------------------------------------


def _lines(units: Units, scenario: Scenario) -> Iterator[Slip]:
    """Tell robots whose line runs through the object."""
    outline = scenario.swarm.outline
    for i, robot in enumerate(scenario.swarm.robots):
        if not pulls_on_line(outline, robot):
            continue
        ends = (robot.direction + robot.steers * share for share in (0.0, -1.0, 1.0))
        met = next(filter(None, (meeting(outline, robot.contact, way) for way in ends)), None)
        if met is not None:
            x, y = (value / LENGTHS[units.length] for value in units.frame.to_file(met.point))
            far = trimmed(met.distance / LENGTHS[units.length], 4)
            where = f"({trimmed(x, 4)}, {trimmed(y, 4)}) {units.length}"
            said = (
                f"the line of {robot.name} runs through the object: it meets "
                f"{outline.edge_label(met.edge)} at {where}, after "
                f"{far} {units.length}; a line that is bent there pulls another way"
            )
            yield ("robots", i), said


def _bodies(scenario: Scenario) -> Iterator[Slip]:
    """Tell robots whose bodies are in each other."""
    names = list(scenario.swarm.names)
    for one, other in Room(scenario.swarm).crossings() if scenario.swarm.rare.bodies else ():
        said = f"{one} and {other} are in each other's way: their bodies overlap"
        yield ("robots", names.index(one)), said
