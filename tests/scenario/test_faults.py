"""Every fault of a scenario file is told with its line, column and key."""

import contextlib
import random
import re
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.scenario import example_names, example_text, load_scenario, parse_scenario
from swarmgrasp.scenario.schema import ScenarioFile
from swarmgrasp.scenario.validate import STAND_INS, WANTED, models_in

# line 1 is the outline, line 2 opens the robots, line 3 is the first of them
HEAD = (
    "outline: {vertices: [[0, 0], [4, 0], [4, 2], [0, 2]], edges: [south, east, north, west]}\n"
    "robots:\n"
)
ROBOT = "  - {edge: east, along: 1, direction: inward, limit: 1}\n"


def told(text: str) -> list[str]:
    """Return the faults of a text, one line each."""
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(text, "a.yaml")
    faults = list(caught.value.faults)
    assert str(caught.value).splitlines() == faults == list(map(str, caught.value.records))
    return faults


ROBOTS = {
    "{at: 1, direction: 0, limit: -0.5}": (
        "3:34: robots.0.limit: should be greater than 0 (got -0.5)"
    ),
    "{at: 1, direction: 0, limit: 0}": "3:34: robots.0.limit: should be greater than 0 (got 0)",
    "{at: 1, direction: 0, limit: .nan}": (
        "3:34: robots.0.limit: should be a finite number (got .nan)"
    ),
    "{at: 1, direction: 0, limit: .inf}": (
        "3:34: robots.0.limit: should be a finite number (got .inf)"
    ),
    "{at: 1, direction: 0, limit: '5'}": "3:34: robots.0.limit: should be a number (got '5')",
    "{at: 1, direction: 0, limit: true}": "3:34: robots.0.limit: should be a number (got true)",
    "{at: 1, direction: 0, limit: }": (
        "3:27: robots.0.limit: has no value; give one or leave the key out"
    ),
    "{at: 1, direction: 0, limt: 1, limit: 1}": (
        "3:27: robots.0.limt: unknown key; did you mean 'limit'?"
    ),
    "{at: 1, direction: 0}": "3:5: robots.0.limit: is missing; give the largest force",
    "{at: 1, at: 2, direction: 0, limit: 1}": (
        "3:13: robots.0.at: duplicate key; it is already given on line 3"
    ),
    "{at: 1, direction: north, limit: 1}": (
        "3:24: robots.0.direction: should be an angle, 'inward' or 'outward' (got 'north')"
    ),
    "{at: 1, direction: {a: 1}, limit: 1}": (
        "3:24: robots.0.direction: should be a number (got {a: 1})"
    ),
    "{at: 1, direction: 2e6, limit: 1}": (
        "3:24: robots.0.direction: should be at most 1e+06 (got 2e6)"
    ),
    "{at: 1, direction: 0, limit: 1e-200}": (
        "3:5: robots.0: R1: the limit is 1e-200; it should be 1e-100 <= limit <= 1e+100 [N]"
    ),
    "{at: 12.5, direction: 0, limit: 1}": (
        "3:10: robots.0.at: should lie in [0, 12] m, the length of the boundary (got 12.5)"
    ),
    "{contact: [4.5, 1], direction: 0, limit: 1}": (
        "3:15: robots.0.contact: is off the boundary; the nearest boundary point is "
        "[4, 1] m on east, 0.5 m away (got [4.5, 1])"
    ),
    "{contact: [5, 1], direction: 0, limit: 1, mounted: true}": (
        "3:15: robots.0.contact: a mounted robot should be inside; the nearest boundary point is "
        "[4, 1] m on east, 1 m away (got [5, 1])"
    ),
    "{at: 1, direction: 0, limit: 1, mounted: true}": (
        "3:46: robots.0.mounted: a mounted robot is given by its contact [x, y]"
    ),
    "{contact: [4, 2], direction: inward, limit: 1}": (
        "3:34: robots.0.direction: the normal is ambiguous at a corner; give the contact by edge "
        "and along, or an angle (got 'inward')"
    ),
    "{edge: eastt, along: 1, direction: 0, limit: 1}": (
        "3:12: robots.0.edge: there is no such edge; they run from 0 to 3; did you mean 'east'? "
        "(got 'eastt')"
    ),
    "{edge: east, along: 3, direction: 0, limit: 1}": (
        "3:25: robots.0.along: should lie in [0, 2] m, the length of east (got 3)"
    ),
    "{edge: east, direction: 0, limit: 1}": "3:5: robots.0: edge needs along, the distance on it",
    "{at: 1, theta: 2, direction: 0, limit: 1}": (
        "3:5: robots.0: theta and at each say where; keep one"
    ),
    "{direction: 0, limit: 1}": (
        "3:5: robots.0: should say where, by contact, theta, at, or edge with along"
    ),
    "7": "3:5: robots.0: should be a mapping of keys to values (got 7)",
    "!!python/object:os.system {at: 1, direction: 0, limit: 1}": (
        "3:5: robots.0: the tag '!!python/object:os.system' is not allowed; write plain values"
    ),
}


@pytest.mark.parametrize("robot", ROBOTS)
def test_a_faulty_robot_is_told_with_its_place(robot: str) -> None:
    """One fault, one sentence, with line, column and key path."""
    assert told(f"{HEAD}  - {robot}\n") == [f"a.yaml:{ROBOTS[robot]}"]


REST = {
    "newcomer: {limit: 1, attachment: pul}": (
        "4:34: newcomer.attachment: should be 'push', 'pull' or 'free' (got 'pul')"
    ),
    "newcomer: {limit: 1, attachment: pull, half_angle: 30}": (
        "4:52: newcomer.half_angle: should lie in [0, 1.57079633] rad (got 30)"
    ),
    "newcomer: {limit: 1, half_angle: 1}": (
        "4:34: newcomer.half_angle: goes with attachment: push or pull only; a free one pushes "
        "in any direction (got 1)"
    ),
    "zones: []": "4:8: zones: should hold 1 or more values, not 0 (got [])",
    "zones: [{from: 3, to: 13}]": (
        "4:23: zones.0.to: should lie in [0, 12] m, the length of the boundary (got 13)"
    ),
    "zones: [{edge: east, from: 1.5, to: 1}]": (
        "4:28: zones.0.from: should be less than to, which is 1 m (got 1.5)"
    ),
    "zones: [{at: 3, directions: [0, 7]}]": (
        "4:29: zones.0.directions: spans a full turn, which limits nothing; leave it out "
        "(got [0, 7])"
    ),
    "no_go: [{from: 3, to: 3}]": (
        "4:23: no_go.0.to: a single point forbids nothing, as the ends of a stretch are allowed; "
        "give it a width (got 3)"
    ),
    "no_go: {a: b}": "4:8: no_go: should be a list (got {a: 'b'})",
    "zones: [{from: 12, to: 0}]": (
        "4:24: zones.0.to: the stretch has no length; a single point is given by contact, theta, "
        "at or along (got 0)"
    ),
    "zones: [{name: z, at: 1}, {name: z, at: 2}]": (
        "4:34: zones.1.name: is the name of zones.0 too; names should differ (got 'z')"
    ),
    "no_go: [{from: 3}]": "4:9: no_go.0: should say where, by edge, or from and to",
    "spacing: -1": "4:10: spacing: should be at least 0 (got -1)",
    f"spacing: {'9' * 400}": f"4:10: spacing: should be a finite number (got {'9' * 37}...)",
    'zones: [{at: 1, name: "\\e[31mred"}]': (
        r"4:23: zones.0.name: holds U+001B, a control character; leave it out (got '\x1b[31mred')"
    ),
    'newcomer: {limit: 1, name: "a\\ud800"}': (
        r"4:28: newcomer.name: holds a control character; leave it out (got 'a\ud800')"
    ),
    'newcomer: {limit: 1, name: "a\\u200bb"}': (
        r"4:28: newcomer.name: holds U+200B ZERO WIDTH SPACE; leave it out (got 'a\u200bb')"
    ),
    'newcomer: {limit: 1, name: " "}': (
        "4:28: newcomer.name: shows nothing; give it a letter (got ' ')"
    ),
    "metric: {force_weights: [1, 0]}": (
        "4:29: metric.force_weights.1: should be greater than 0 (got 0)"
    ),
    "units: {length: yard}": "4:17: units.length: there is no unit of length 'yard'; "
    "known: m, mm, cm, km, ft, in (got 'yard')",
    "Zones: []": "4:1: Zones: unknown key; did you mean 'zones'?",
    "1: 2": "4:1: a key should be text (got 1)",
}


@pytest.mark.parametrize("line", REST)
def test_a_fault_outside_the_robots_is_told_with_its_place(line: str) -> None:
    """Newcomer, zones, no-go stretches, spacing, metric and units have their own sentences."""
    assert told(f"{HEAD}{ROBOT}{line}\n") == [f"a.yaml:{REST[line]}"]


with pytest.raises((OverflowError, ValueError)) as raised:
    chr(0xFFFFFFFF)
NO_CHARACTER = str(raised.value)
"""What this Python says of it: versions differ."""
DOCUMENTS = {
    "": "1:1: the file is empty; it should hold a scenario",
    "# nothing\n": "1:1: the file is empty; it should hold a scenario",
    "- 1\n": "1:1: should be a mapping of keys to values (got [1])",
    "a: [1, 2": (
        "1:9: not valid YAML: while parsing a flow sequence expected ',' or ']', but "
        "got '<stream end>'"
    ),
    "a: 1\n b: 2\n": "2:3: not valid YAML: a colon makes a key here; put "
    "a text with a colon in quotes",
    "a: \x07": "1:4: not valid YAML: special characters are not allowed",
    "a: 1\n---\nb: 2\n": "2:1: a second document starts; a file holds one scenario",
    "a: &x [1, *x]\n": "1:11: the alias *x contains itself",
    "a: *x\n": "1:4: the alias *x stands for nothing",
    "%YAML 1.3\n---\nname: x\n": ("1:1: a scenario is YAML 1.2; leave out the line '%YAML 1.3'"),
    "# 1.1 reads `no` as false\n%YAML 1.1\n---\nname: no\n": (
        "2:1: a scenario is YAML 1.2; leave out the line '%YAML 1.1'"
    ),
    'a: "\\UFFFFFFFF"\n': f"1:1: not valid YAML: {NO_CHARACTER}",
    "[" * 30: "1:21: nested too deep; at most 20 levels are read",
}


@pytest.mark.parametrize("text", DOCUMENTS)
def test_a_text_that_is_no_document_is_refused_with_its_place(text: str) -> None:
    """Empty, unfinished, recursive or bottomless: one sentence, never a traceback."""
    assert told(text) == [f"a.yaml:{DOCUMENTS[text]}"]


def test_aliases_that_explode_are_refused_at_once() -> None:
    """Ten levels of ten aliases stand for 10^10 values: they would not fit in any memory."""
    lines = ["a0: &a0 [1, 1, 1, 1, 1, 1, 1, 1, 1, 1]"]
    lines += [f"a{i}: &a{i} [{', '.join([f'*a{i - 1}'] * 10)}]" for i in range(1, 10)]
    (fault,) = told("\n".join(lines))
    assert "too many values, aliases expanded; at most 100000 are read" in fault


OUTLINES = {
    "[[0, 0], [10, 10], [10, 0], [0, 10]]": "(5, 5) ft",
    "[[0, 0], [1, 1], [2, 2]]": "collinear",
    "[[0, 0], [1, 1], [0, 0]]": "needs at least 3",
    "[[0, 0], [1e-9, 0], [0, 1e-9]]": "it should be at least 1e-06 ft",
}


@pytest.mark.parametrize("vertices", OUTLINES)
def test_an_outline_that_is_no_polygon_is_told_in_the_units_of_the_file(vertices: str) -> None:
    """A crossing point is named in feet when the file speaks of feet."""
    text = f"units: {{length: ft}}\noutline:\n  vertices: {vertices}\nrobots: []\n"
    (fault,) = told(text)
    assert fault.startswith("a.yaml:3:13: outline.vertices: ")
    assert OUTLINES[vertices] in fault


def test_all_faults_are_told_at_once_in_the_order_of_the_file() -> None:
    """A bad limit hides neither its own robot's contact nor the next robot's."""
    robots = (
        "  - {contact: [9, 9], direction: 0, limit: -1}\n  - {at: 99, direction: 0, limit: 1}\n"
    )
    faults = told(f"{HEAD}{robots}spacing: -1\nzones: [{{at: 20}}]\n")
    keys = [fault.split(": ")[1] for fault in faults]
    assert keys == ["robots.0.contact", "robots.0.limit", "robots.1.at", "spacing", "zones.0.at"]


def test_a_bad_outline_hides_no_other_fault() -> None:
    """Robots cannot be located without it, but their numbers are still checked."""
    faults = told("outline: {vertices: [[0, 0], [1, x], [y, 1]]}\nrobots: [{at: 1, limit: 0}]\n")
    assert [fault.split(": ")[1] for fault in faults] == [
        "outline.vertices.1.1",
        "outline.vertices.2.0",
        "robots.0.direction",
        "robots.0.limit",
    ]


NAMES = {
    "  - {name: A, at: 1, direction: 0, limit: 1}\n": (
        "4:12: robots.1.name: is the name of robots.0 too; names should differ (got 'A')"
    ),
    "newcomer: {name: A, limit: 1}\n": (
        "4:18: newcomer.name: is the name of robots.0 too; names should differ (got 'A')"
    ),
    "  - {name: newcomer, at: 1, direction: 0, limit: 1}\nnewcomer: {limit: 1}\n": (
        "5:11: newcomer: is called 'newcomer', which is the name of robots.1 too; names should "
        "differ"
    ),
}


@pytest.mark.parametrize("rest", NAMES)
def test_names_differ(rest: str) -> None:
    """Robots and the newcomer can be told apart in every report."""
    first = "  - {name: A, at: 2, direction: 0, limit: 1, two_way: true}\n"
    assert told(f"{HEAD}{first}{rest}") == [f"a.yaml:{NAMES[rest]}"]


@pytest.mark.parametrize(
    "outline", ["[[0, 0], [4, x], [4, 2]]", "[[0, 0], [4, 4], [4, 0], [0, 4]]"]
)
def test_a_bad_outline_hides_no_fault_that_needs_no_outline(outline: str) -> None:
    """Contacts given twice or not at all, half angles, and stretches the wrong way round."""
    faults = told(
        f"outline: {{vertices: {outline}, edges: [a, b, a, c]}}\n"
        "robots: [{at: 1, theta: 1, direction: 0, limit: 1}, {direction: 0, limit: 1}]\n"
        "newcomer: {limit: 1, attachment: push, half_angle: 3}\n"
        "zones: [{}, {edge: c, from: 3, to: 1}]\nno_go: [{from: 1, to: 1}]\n"
    )
    keys = [fault.split(": ")[1] for fault in faults]
    assert keys[0].startswith("outline.vertices")
    assert keys[1:] == [
        "outline.edges.2",
        "robots.0",
        "robots.1",
        "newcomer.half_angle",
        "zones.0",
        "zones.1.from",
        "no_go.0.to",
    ]


def test_edges_are_judged_before_there_is_an_outline() -> None:
    """They are there or not, and as long as they are, whatever is wrong with another corner."""
    outline = "outline: {vertices: [[0, 0], [4, 0], [4, 2 ft], [0, x]], edges: [south, e, n, w]}\n"
    faults = told(
        f"{outline}robots: [{{edge: soth, along: 1, direction: 0, limit: 1}}, {{edge: 4, along: 9, "
        "direction: 0, limit: 1}, {edge: 1, along: 0.7, direction: 0, limit: 1}, {edge: n, "
        "along: 99, direction: inward, limit: 1}]\n"
        "zones: [{edge: edge 2}, {edge: south, from: 1, to: 5}, {at: 99}]\n"
        "no_go: [{edge: 9}]\n"
    )
    assert [fault.partition(": ")[2].partition(" (")[0] for fault in faults] == [
        "outline.vertices.3.1: should be a number",
        "robots.0.edge: there is no such edge; they run from 0 to 3; did you mean 'south'?",
        "robots.1.edge: there is no such edge; they run from 0 to 3",
        "robots.2.along: should lie in [0, 0.6096] m, the length of e",
        "zones.0.edge: there is no such edge; they run from 0 to 3; known: south, e, n, w",
        "zones.1.to: should lie in [0, 4] m, the length of south",
        "no_go.0.edge: there is no such edge; they run from 0 to 3",
    ]
    # corners that are said twice, as that of a closed ring, make no edge
    ring = "outline: {vertices: [[0, 0], [0, 0], [4, 0], [4, 2], [0, x], [0, 0]]}\n"
    faults = told(
        f"{ring}robots: []\nno_go: [{{edge: 1, to: 3}}, {{edge: 0, to: 3}}, {{edge: 4}}]\n"
    )
    assert [fault.partition(": ")[2].partition(" (")[0] for fault in faults[1:]] == [
        "no_go.0.to: should lie in [0, 2] m, the length of edge 1",
        "no_go.2.edge: there is no such edge; they run from 0 to 3",
    ]


def test_an_unread_unit_hides_no_place_that_is_in_it() -> None:
    """Plain numbers are compared with plain ones, in what the file calls them."""
    faults = told(
        "units: {length: cubit}\n"
        "outline: {vertices: [[0, 0], [9, 0], [9, 4], [0, 4]], edges: [a, b, c, d]}\n"
        "robots:\n"
        "  - {contact: [9, 5], direction: 0, limit: 1}\n"
        "  - {at: 27, direction: 30, limit: 1, tolerance: {contact: 20}}\n"
        "  - {edge: e, along: 0.9 m, direction: 0, limit: 1, steers: 30}\n"
        "zones: [{edge: a, from: 2, to: 1}]\n"
    )
    assert [fault.partition(": ")[2].partition(" (")[0] for fault in faults[1:]] == [
        "robots.0.contact: is off the boundary; the nearest boundary point is [9, 4] cubit on c, "
        "1 cubit away",
        "robots.1.at: should lie in [0, 26] cubit, the length of the boundary",
        "robots.1.tolerance.contact: spans 40 cubit, the whole boundary and more",
        "robots.2.edge: there is no such edge; they run from 0 to 3; known: a, b, c, d",
        "robots.2.steers: should lie in [0, 3.14159265] rad, or be any",
        "zones.0.from: should be less than to, which is 1 cubit",
    ]


def test_an_unread_unit_makes_no_fault_of_what_is_in_another_unit() -> None:
    """The hull is written in cubits, the robot and the zone in metres too: no size is known."""
    faults = told(
        "units: {length: cubit}\n"
        "outline: {vertices: [[0, 0], [9, 0], [9, 4], [0, 4]], edges: [a, b, c, d]}\n"
        "robots: [{contact: [9, 0.9 m], direction: 0, limit: -1}]\n"
        "zones: [{edge: a, from: 2, to: 1.8 m}]\n"
    )
    keys = [fault.split(": ")[1] for fault in faults]
    assert keys == ["units.length", "robots.0.limit"]


def test_a_faulty_edge_name_hides_no_place() -> None:
    """Points are still located; only references to edges by name are left alone."""
    text = "outline: {{vertices: [[0, 0], [4, 0], [4, 2], [0, 2]], edges: {}}}\nrobots:\n"
    robots = (
        "  - {at: 99, direction: 0, limit: 1}\n  - {edge: b, along: 9, direction: 0, limit: 1}\n"
    )
    twice = [fault.split(": ")[1] for fault in told(text.format("[a, b, a, c]") + robots)]
    assert twice == ["outline.edges.2", "robots.0.at", "robots.1.along"]
    few = [fault.split(": ")[1] for fault in told(text.format("[a, b]") + robots)]
    assert few == ["outline.edges", "robots.0.at"]


def test_a_flood_of_faults_is_cut() -> None:
    """After fifty faults only their number is told."""
    faults = told(HEAD + "  - {at: 1, direction: 0, limit: 0}\n" * 60)
    assert len(faults) == 51
    assert faults[-1] == "a.yaml: ... and 10 more"


def test_a_file_that_cannot_be_read_is_told_by_name(tmp_path: Path) -> None:
    """Missing, a folder, not UTF-8, or a name no file can have."""
    latin = tmp_path / "latin.yaml"
    latin.write_bytes(b"name: ok\ndescription: caf\xe9\n")
    for path, said in {
        tmp_path / "none.yaml": "there is no such file",
        tmp_path: "is a folder; give a file in it",
        latin / "inside": "cannot be read: Not a directory",
        latin: "latin.yaml:2:17: not UTF-8 (byte 0xe9); save it as UTF-8",
        Path("a\0b"): "is no path of a file",
    }.items():
        with pytest.raises(ScenarioInvalid, match=re.escape(said)):
            load_scenario(path)


def test_a_huge_file_is_refused_before_it_is_read(tmp_path: Path) -> None:
    """The size is enough to say no; where there is none, no more is read than allowed."""
    with pytest.raises(ScenarioInvalid, match="/dev/zero:1:1: is too large"):
        load_scenario("/dev/zero")
    huge = tmp_path / "huge.yaml"
    with huge.open("wb") as file:
        file.truncate(10_000_000)
    with pytest.raises(ScenarioInvalid, match="is too large; it should have at most 1000000 bytes"):
        load_scenario(huge)


def test_plain_words_are_read_as_yaml_1_2_reads_them() -> None:
    """`no` is a name and `1e-3` a number."""
    scenario = parse_scenario(f"name: no\n{HEAD}  - {{name: on, at: 1, direction: 0, limit: 1e-3}}")
    assert (scenario.name, scenario.swarm.robots[0].name) == ("no", "on")
    assert scenario.swarm.robots[0].limit == 1e-3


@settings(max_examples=150, deadline=None)
@given(st.binary(max_size=200))
def test_any_bytes_load_or_are_refused(
    tmp_path_factory: pytest.TempPathFactory, raw: bytes
) -> None:
    """Whatever a file holds, the only error is ScenarioInvalid."""
    path = tmp_path_factory.getbasetemp() / "bytes.yaml"
    path.write_bytes(raw)
    with pytest.raises(ScenarioInvalid):
        load_scenario(path)


@settings(max_examples=100, deadline=None)
@given(st.randoms(use_true_random=False))
def test_any_mutation_of_an_example_loads_or_is_refused(rng: random.Random) -> None:
    """Words deleted, doubled, swapped or replaced by hostile ones: never another error."""
    name = rng.choice([n for n in example_names() if n != "hull-120"])
    words = re.split(r"(\W)", example_text(name))
    hostile = ["", "[", "}", "&a ", "*a", "\t", "\x00", "\ud800", "9" * 400, ".nan", "~", "-1e308"]
    for _ in range(rng.choice([1, 2, 8])):
        words[rng.randrange(len(words))] = rng.choice([*hostile, rng.choice(words)])
    with contextlib.suppress(ScenarioInvalid):
        parse_scenario("".join(words))


def test_every_required_key_has_a_stand_in_and_a_remedy() -> None:
    """One that is missing is told, and what else is wrong is looked for all the same."""
    models, required = [ScenarioFile], set()
    for model in models:
        for name, info in model.model_fields.items():
            required |= {info.alias or name} if info.is_required() else set()
            models += [part for part in models_in(info.annotation) if part not in models]
    assert len(models) > 20
    assert required == STAND_INS.keys()
    assert required == WANTED.keys()


def test_faults_are_records_too():
    """Line, column, key and sentence apart; a file as a whole has no line."""
    with pytest.raises(ScenarioInvalid) as caught:
        parse_scenario(HEAD + ROBOT.replace("limit: 1", "limit: -1"), "a.yaml")
    (fault,) = caught.value.records
    place = ("a.yaml", 3, 54, "robots.0.limit")
    assert fault == (*place, "should be greater than 0 (got -1)")
    with pytest.raises(ScenarioInvalid) as caught:
        load_scenario("nowhere.yaml")
    assert [fault[:4] for fault in caught.value.records] == [("", None, None, "")]
    slipped = parse_scenario(HEAD + ROBOT.replace("limit: 1", "limit: 900") + ROBOT)
    assert [str(slip) for slip in slipped.slips] == list(slipped.warnings)
    assert all(slip.line and slip.path for slip in slipped.slips)
