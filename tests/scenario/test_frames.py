"""One scenario in any units, in any frame, as numbers or with their units, is one question."""

import math
import re

import numpy as np
import pytest

from swarmgrasp import quality
from swarmgrasp.cli import main
from swarmgrasp.scenario import Scenario, parse_scenario, scenario_text
from swarmgrasp.units import ANGLES, FORCES, LENGTHS

SIZES = {"length": LENGTHS, "force": FORCES, "angle": ANGLES}


class Writer:
    """Write values of our frame in SI as a file has them, by hand."""

    def __init__(self, rng: np.random.Generator, bow: float, *, mirrored: bool) -> None:
        self.rng, self.bow, self.mirrored = rng, bow, mirrored
        self.units = {of: str(rng.choice(list(sizes))) for of, sizes in SIZES.items()}

    def told(self, value: float, of: str) -> str:
        """Return a value as a number, or in a unit of its own."""
        unit = self.units[of]
        if self.rng.random() < 0.5:
            unit = str(self.rng.choice(list(SIZES[of])))
            return f"{float(value) / SIZES[of][unit]!r} {unit}"
        return repr(float(value) / SIZES[of][unit])

    def point(self, point: tuple[float, float]) -> str:
        """Return a point: mirrored, then turned as the file's coordinates turn."""
        x, y = point[0], -point[1] if self.mirrored else point[1]
        cos, sin = math.cos(self.bow), math.sin(self.bow)
        along, across = x * cos - y * sin, x * sin + y * cos
        return f"[{self.told(along, 'length')}, {self.told(across, 'length')}]"

    def angle(self, direction: float) -> str:
        """Return a direction."""
        return self.told(self.bow + (-direction if self.mirrored else direction), "angle")

    def pair(self, first: float, last: float, of: str) -> str:
        """Return two offsets, the first of them against the file's sense."""
        ends = (-last, -first) if self.mirrored else (first, last)
        return f"[{self.told(ends[0], of)}, {self.told(ends[1], of)}]"

    def span(self, first: float, last: float) -> str:
        """Return directions from one to another."""
        ends = (last, first) if self.mirrored else (first, last)
        return f"[{self.angle(ends[0])}, {self.angle(ends[1])}]"

    def arc(self, arc: float, perimeter: float) -> str:
        """Return an arc length from the first vertex."""
        return self.told(perimeter - arc if self.mirrored else arc, "length")

    def stretch(self, first: float, last: float, perimeter: float) -> str:
        """Return where a stretch begins and ends."""
        ends = (last, first) if self.mirrored else (first, last)
        return f"from: {self.arc(ends[0], perimeter)}, to: {self.arc(ends[1], perimeter)}"

    def wrench(self, parts: tuple[float, float, float]) -> str:
        """Return a wrench; its torque without a unit, in that of the file."""
        x, y = parts[0], -parts[1] if self.mirrored else parts[1]
        cos, sin = math.cos(self.bow), math.sin(self.bow)
        torque = -parts[2] if self.mirrored else parts[2]
        torque /= FORCES[self.units["force"]] * LENGTHS[self.units["length"]]
        along, across = x * cos - y * sin, x * sin + y * cos
        return f"[{self.told(along, 'force')}, {self.told(across, 'force')}, {torque!r}]"


def written(rng: np.random.Generator, seed: int, bow: float, *, mirrored: bool) -> str:
    """Return the file of the scenario of a seed, in the units and the frame of a writer."""
    drawn = np.random.default_rng(seed)
    file = Writer(rng, bow, mirrored=mirrored)
    turns = np.sort(drawn.uniform(0.0, 2.0 * np.pi, 7)) + 0.01 * np.arange(7)
    radii = drawn.uniform(20.0, 40.0, 7)
    corners = np.column_stack([radii * np.cos(turns), radii * np.sin(turns)]).round(1)
    if drawn.random() < 0.5:
        corners = corners[::-1]
    ccw = np.roll(corners[::-1], 1, axis=0) if _area(corners) < 0.0 else corners
    sides = np.linalg.norm(np.roll(ccw, -1, axis=0) - ccw, axis=1)
    perimeter = float(sides.sum())
    arcs = np.sort(drawn.uniform(0.0, perimeter, 6))
    a, b, c, d, e, f = arcs.tolist()
    way, limit = drawn.uniform(-3.0, 3.0), drawn.uniform(1e5, 1e6)
    told, sector = file.told, (way, way + 1.0)
    # a clockwise file measures along an edge from its end, as its sense of turning has it
    side = sides[0] if _area(corners) > 0.0 else sides[-1]
    along = 0.3 * side if not mirrored else 0.7 * side
    left = -limit if mirrored else limit
    vertices = ", ".join(file.point((float(x), float(y))) for x, y in corners)
    return f"""
units: {{{", ".join(f"{of}: {unit}" for of, unit in file.units.items())}}}
frame: {"NED" if mirrored else "ENU"}
bow: {told(bow, "angle")}
heading: {told(0.5, "angle")}
words: tug
outline: {{vertices: [{vertices}], origin: {file.point((1.0, 2.0))}, precision: 0}}
robots:
  - {{at: {file.arc(a, perimeter)}, direction: {file.angle(way)}, limit: {told(limit, "force")},
     tolerance: {{contact: {file.pair(-1.0, 2.0, "length")},
     direction: {file.pair(-0.1, 0.2, "angle")}}}}}
  - {{at: {file.arc(b, perimeter)}, direction: inward, limit: [{told(0.1 * limit, "force")},
     {told(limit, "force")}], steers: {told(0.5, "angle")}}}
  - {{edge: 0, along: {told(along, "length")}, direction: outward, limit: {told(limit, "force")}}}
  - {{at: {file.arc(c, perimeter)}, limit: {told(limit, "force")},
     sectors: [{file.span(*sector)}, {file.span(way + 2.0, way + 3.0)}]}}
  - {{contact: {file.point((3.0, -2.0))}, mounted: true, direction: {file.angle(way + 1.0)},
     envelope: [[{told(limit, "force")}, 0], [0, {told(left, "force")}], [0, 0]]}}
  - {{at: {file.arc(d, perimeter)}, direction: inward, limit: {told(limit, "force")}}}
newcomer: {{limit: {told(limit, "force")}, attachment: push, half_angle: {told(0.5, "angle")}}}
zones:
  - {{{file.stretch(b, f, perimeter)}}}
  - {{{file.stretch(f, a, perimeter)}, directions: {file.span(*sector)}}}
  - {{at: {file.arc(e, perimeter)}}}
no_go: [{{edge: 2}}]
criterion:
  load: {file.wrench((0.1 * limit, 0.2 * limit, limit))}
  task: {{polytope: [{file.wrench((limit, 0.0, 0.0))}, {file.wrench((0.0, limit, -limit))}]}}
environment:
  wind: {{vessel: tender, frontal_area: 100 m2, lateral_area: 250 m2, speed: 10, from: NE}}
  current: {{frontal_area: 10 m2, lateral_area: 20 m2, speed: 1, from: {told(1.0, "angle")}}}
simulation:
  hull: {{centre: {file.point((1.0, -1.0))}, draught: {told(2.0, "length")},
    damping: {_damping(file)}}}
  events:
    - {{at: 60, move: [{file.point((5.0, 3.0))[1:-1]}, {told(-0.1 if mirrored else 0.1, "angle")}]}}
    - {{at: 90, follow: [{file.point((9.0, -3.0))}], speed: 1}}
"""


def _area(corners: np.ndarray) -> float:
    x, y = corners.T
    return float(0.5 * (x * np.roll(y, -1) - y * np.roll(x, -1)).sum())


def _damping(file: Writer) -> list[list[float]]:
    """Return a matrix that, times a velocity of the file, is a wrench of the file."""
    ours = np.array([[100.0, 20.0, 30.0], [-10.0, 200.0, 40.0], [5.0, 60.0, 3000.0]])
    cos, sin = math.cos(file.bow), math.sin(file.bow)
    side = -1.0 if file.mirrored else 1.0
    turned = np.array([[cos, -side * sin, 0.0], [sin, side * cos, 0.0], [0.0, 0.0, side]])
    return (turned @ ours @ turned.T).tolist()


TURNING = ("direction", "sectors", "directions", "bearing", "inward_normals")
"""Keys of angles that a full turn leaves as they are."""


def leaves(value: object, path: tuple[str, ...] = ()) -> list[tuple[tuple[str, ...], object]]:
    """Return the leaves of plain data, in order, each with the keys that lead to it."""
    if isinstance(value, dict):
        return [leaf for key in value for leaf in leaves(value[key], (*path, key))]
    if isinstance(value, list):
        return [leaf for item in value for leaf in leaves(item, path)]
    return [(path, value)]


def asked(scenario: Scenario) -> list[tuple[tuple[str, ...], object]]:
    """Return all that a scenario asks."""
    assert scenario.environment is not None
    assert scenario.simulation is not None
    parts = (scenario.problem(), scenario.environment, scenario.simulation)
    return [leaf for part in parts for leaf in leaves(part.to_data())]


def assert_same(one: Scenario, other: Scenario) -> None:
    """Compare all that two scenarios ask, numbers to 1e-12 of what is about them."""
    for (path, first), (also, second) in zip(asked(one), asked(other), strict=True):
        assert path == also
        if not isinstance(first, float):
            assert first == second, path
            continue
        assert isinstance(second, float)
        apart = abs(first - second)
        if path[-1] in TURNING and "tolerance" not in path:
            apart = abs(math.remainder(apart, math.tau))
        size = 1e6 if {"criterion", "envelope", "damping"} & set(path) else 40.0
        assert apart <= 1e-12 * max(abs(first), size), path


@pytest.mark.parametrize("seed", range(3))
def test_a_scenario_is_one_question_in_any_terms(seed: int) -> None:
    """Units, quantities, frame and bow change nothing of it, nor of the quality."""
    plain = parse_scenario(written(np.random.default_rng(0), seed, 0.0, mirrored=False))
    for turn in range(3):
        rng = np.random.default_rng([seed, turn])
        for mirrored in (False, True):
            bow = float(rng.choice([0.0, 0.5 * math.pi, rng.uniform(-3.0, 3.0)]))
            scenario = parse_scenario(written(rng, seed, bow, mirrored=mirrored))
            assert_same(scenario, plain)
            frame = scenario.terms.frame
            assert (frame.mirrored, scenario.terms.robot) == (mirrored, "tug")
            assert (frame.bow, frame.heading) == pytest.approx((bow, 0.5), rel=1e-14)
    again = parse_scenario(scenario_text(plain))
    assert_same(again, plain)
    assert (again.terms.robot, again.terms.frame.heading) == ("tug", plain.terms.frame.heading)
    assert quality(scenario.swarm).value == pytest.approx(quality(plain.swarm).value, rel=1e-9)


def test_where_an_answer_says_it_goes_the_file_puts_it(tmp_path, capsys) -> None:
    """The arc length told of a place, written as `at` of a robot, is that place: in any frame."""
    for frame in ("ENU", "NED"):
        path = tmp_path / f"{frame}.yaml"
        head = f"frame: {frame}\noutline: {{vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}}\n"
        path.write_text(
            head + "robots: []\nnewcomer: {limit: 5, attachment: push, half_angle: 0}\n"
            "zones: [{from: 5, to: 5.5}]\n"
        )
        assert main(["place", str(path)]) == 0
        told = re.search(r"contact \((\S+), (\S+)\) m, (\S+) m along", capsys.readouterr().out)
        assert told is not None
        x, y, arc = map(float, told.groups())
        again = parse_scenario(head + f"robots: [{{at: {arc}, direction: inward, limit: 5}}]")
        contact = again.terms.frame.to_file(again.swarm.robots[0].contact)
        assert contact.tolist() == pytest.approx([x, y], abs=1e-3)
