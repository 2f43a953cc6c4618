"""The text of a scenario file with what has changed put into it, and nothing else touched."""

import difflib
import re
from dataclasses import replace

import numpy as np
import pytest

from swarmgrasp import Newcomer, Outline, Robot, Stretch, Swarm, Tolerance, Zone
from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.scenario import edited, example_names, example_text, parse_scenario
from swarmgrasp.scenario.splice import Splice

NED = """\
# seen from above, y to starboard
frame: NED
bow: +y
units: {length: ft, force: tf, angle: deg, speed: kn}
outline:
  vertices: [[0, 0], [0, 40], [20, 40], [20, 0]] # drawn along y
robots:
  - {name: Ajax, edge: 1, along: 5, direction: outward, limit: {ahead: 30, astern: 20}} # bow
  - {name: Boreas, at: 70, direction: inward, limit: 40, steers: 20}

  # those on board
  - {name: Castor, contact: [10, 20], sectors: [[10, 80], [200, 300]], limit: 5, mounted: true}
  - name: Dione # a finger
    at: 25
    friction: 0.5
    limit: [2, 20]
    tolerance: {contact: [-1, 2], direction: [-3, 4]}
zones:
  - {edge: 2, from: 1, to: 30}
  - {name: lead, at: 50, attachment: pull, half_angle: 60}
no_go: [{from: 95, to: 105}]
"""


def values(scenario):
    """Return all numbers of a scenario in one row, and all that is no number."""

    def leaves(data):
        """Go through what plain data hold."""
        for item in data.values() if isinstance(data, dict) else data:
            if isinstance(item, dict | list):
                yield from leaves(item)
            else:
                yield item

    around = None if scenario.environment is None else scenario.environment.to_data()
    found = list(leaves([scenario.problem().to_data(), scenario.newcomer is None, [around]]))
    is_number = [isinstance(x, float) for x in found]
    numbers = np.array([x for x, is_one in zip(found, is_number, strict=True) if is_one])
    return numbers, [x for x, is_one in zip(found, is_number, strict=True) if not is_one]


def check(text, wanted):
    """Put a scenario into a text; read again it is the same, and the comments are there."""
    found = edited(text, wanted)
    numbers, others = values(parse_scenario(found))
    truth, rest = values(wanted)
    assert others == rest
    assert numbers == pytest.approx(truth, rel=1e-12, abs=1e-12 * np.abs(truth).max())
    assert edited(found, wanted) == found
    lines = [line.strip() for line in found.splitlines()]
    assert all(c.strip() in lines for c in text.splitlines() if c.strip().startswith("#"))
    return found


def changed(scenario, rng):
    """Return a scenario with some of everything changed at random."""
    swarm, outline = scenario.swarm, scenario.swarm.outline
    robots = list(swarm.robots)

    def spot():
        return outline.at_arc_length(float(rng.uniform(0.0, outline.perimeter)))

    i = int(rng.integers(len(robots)))
    if not robots[i].mounted:
        at = spot()
        turn = at.inward if rng.random() < 0.5 else float(rng.uniform(-3, 3))
        sectors = robots[i].sectors
        robots[i] = replace(robots[i], contact=at.point, **({} if sectors else {"direction": turn}))
    k = int(rng.integers(len(robots)))
    robots[k] = replace(robots[k], limit=1.25 * robots[k].limit, name="Someone else")
    if rng.random() < 0.6:
        del robots[int(rng.integers(len(robots)))]
    new = Robot(spot().point, 0.3, 1.7, steers=0.25, name="Newly", tolerance=Tolerance(0.0, 0.1))
    robots.insert(int(rng.integers(len(robots) + 1)), new)
    zones, newcomer = scenario.zones, scenario.newcomer
    is_inside = newcomer is not None and newcomer.mounted
    if zones is not None and not is_inside:
        a, b = sorted(rng.uniform(0.0, 0.9 * outline.perimeter, 2).tolist())
        zones = (*zones[1:], Zone(Stretch(a, b, "new pads"), "pull", 0.25))
    if newcomer is not None:
        newcomer = replace(newcomer, limit=newcomer.limit * 1.5)
    around = scenario.environment
    if around is not None and around.is_steady:
        wind = replace(around.wind, speed=7.0, bearing=float(rng.uniform(0.0, 6.0)))
        around = replace(around, wind=wind)
    return replace(
        scenario,
        swarm=Swarm(outline, robots, swarm.characteristic_length, swarm.force_weights),
        zones=zones,
        newcomer=newcomer,
        no_go=() if is_inside else (*scenario.no_go, Stretch(0.1, 0.2 * outline.perimeter)),
        spacing=0.0 if is_inside else scenario.spacing + 0.1,
        environment=around,
        criterion=replace(scenario.criterion, losing=1 + scenario.criterion.losing),
    )


@pytest.mark.parametrize("name", [*example_names(), "NED"])
def test_any_change_is_read_back(name):
    """What is unchanged leaves every character; of any change the text says just that."""
    text = NED if name == "NED" else example_text(name)
    scenario = parse_scenario(text)
    assert edited(text, scenario) == text
    check(text, changed(scenario, np.random.default_rng(len(text))))


def test_a_place_is_said_as_it_was():
    """Along its edge, by arc length; a direction in a word stays one; other lines stay."""
    scenario = parse_scenario(NED)
    swarm, outline = scenario.swarm, scenario.swarm.outline
    start, end = outline.edge_ends(outline.at_point(swarm["Ajax"].contact).edge)
    moved = swarm.with_pose("Ajax", tuple((start + 0.25 * (end - start)).tolist()))
    text = check(NED, replace(scenario, swarm=moved))
    old, new = NED.splitlines(), text.splitlines()
    lines = [line for line in difflib.ndiff(old, new) if line[0] in "+-"]
    assert len(lines) == 2
    along = re.fullmatch(
        r"\+   - \{name: Ajax, edge: 1, along: ([0-9.]+), direction: outward, "
        r"limit: \{ahead: 30, astern: 20\}\} # bow", lines[1],
    )  # fmt: skip
    assert float(along[1]) in (pytest.approx(5.0), pytest.approx(15.0))
    text = check(NED, replace(scenario, no_go=(Stretch(1.0, 2.0),)))
    assert re.search(r"no_go: \[\{from: [0-9.]+, to: [0-9.]+\}\]\n", text)
    zone = scenario.zones[0]
    shorter = replace(zone, stretch=replace(zone.stretch, end=zone.stretch.end - 0.3))
    text = check(NED, replace(scenario, zones=(shorter, *scenario.zones[1:])))
    assert re.search(r"- \{edge: 2, from: [0-9.]+, to: 30\}|- \{edge: 2, from: 1, to:", text)


@pytest.mark.parametrize("name", ["deck-barge", "supply-vessel", "NED"])
def test_corners_move_come_and_go(name):
    """Robots and zones stay where they are, whatever the text says them by."""
    text = NED if name == "NED" else example_text(name)
    scenario = parse_scenario(text)
    swarm, outline = scenario.swarm, scenario.swarm.outline
    loads = replace(scenario.criterion, load=(0.0, 0.0, 0.0))
    for count in (len(outline), len(outline) + 1):
        corners = outline.vertices.tolist()
        if count > len(outline):
            a, b = np.array(corners[0]), np.array(corners[1])
            corners.insert(1, ((a + b) / 2).tolist())
        else:
            corners[2] = [1.02 * corners[2][0], 1.01 * corners[2][1]]
        hull = Outline(corners, outline.origin, precision=outline.precision)
        robots = [r for r in swarm.robots if r.mounted or hull.nearest(r.contact)[0] < 1e-9]
        wanted = replace(
            scenario,
            swarm=Swarm(hull, robots, swarm.characteristic_length),
            zones=(Zone(hull.stretch(0, 0.5, 1.5)),),
            no_go=(),
            criterion=loads,
        )
        check(text, wanted)


def test_sections_come_and_go():
    """A newcomer, zones, a criterion where none was, and the other way round."""
    bare = "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}\nrobots: []\n"
    scenario = parse_scenario(bare)
    full = replace(
        scenario,
        name="Barge",
        newcomer=Newcomer(2.0, "push", 0.5, "tug"),
        zones=(Zone(Stretch(0.5, 3.0)),),
        no_go=(Stretch(1.0, 2.0, "ladder"),),
        swarm=scenario.swarm.with_robot(Robot((4.0, 1.0), 3.0, name="Ajax")),
        criterion=replace(scenario.criterion, load=(1.0, 2.0, 3.0)),
    )
    text = check(bare, full)
    assert text.startswith(bare.partition("\n")[0])
    assert parse_scenario(check(text, scenario)).newcomer is None


def test_shared_values_are_written_out():
    """What an alias stands for elsewhere stays there; the entry that changed says all of it."""
    text = (
        "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]]}\n"
        "no_go:\n  - &pad {from: 0.5, to: 1}\nzones:\n  - *pad\n  - {at: 5}\nrobots: []\n"
    )
    scenario = parse_scenario(text)
    zones = (replace(scenario.zones[0], stretch=Stretch(0.5, 1.5)), scenario.zones[1])
    assert "&pad {from: 0.5, to: 1}" in check(text, replace(scenario, zones=zones))
    check(text, replace(scenario, no_go=(Stretch(0.25, 1.0),)))


def test_what_a_file_cannot_say_is_told():
    """Two zones of one name, and a text with faults."""
    text = example_text("deck-barge")
    scenario = parse_scenario(text)
    twice = (*scenario.zones[:2], scenario.zones[0])
    with pytest.raises(ScenarioInvalid, match=r"is the name of zones\.0 too"):
        edited(text, replace(scenario, zones=twice))
    with pytest.raises(ScenarioInvalid, match="not valid YAML"):
        edited("outline: [", parse_scenario(text))


def test_parts_of_a_text():
    """Added, removed and replaced, with the comments of all others."""
    text = (
        "a: {x: 1, y: [1, 2], z: q}  # k\nb:\n  - 1 # one\n  # mid\n\n  - n: 2\n    m: |\n     t\n"
    )
    splice = Splice(text)
    a, b = splice.root.items
    splice.put(a.get("x"), "17")
    splice.remove(a, 2)
    splice.insert(a, 0, "v: 0")
    splice.remove(b, 0)
    splice.insert(b, 2, "3")
    assert splice.result() == (
        "a: {v: 0, x: 17, y: [1, 2]}  # k\nb:\n  # mid\n\n  - n: 2\n    m: |\n     t\n  - 3\n"
    )
