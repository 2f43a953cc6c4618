import json
import re

import pytest

METRIC = "Metric: force weights 1 and 1, characteristic length"


def test_says_where_which_way_how_much_and_how_sure(run, pontoon):
    """The answer names contact, direction, gain, bound, what limits now, metric and units."""
    status, said, complaints = run("place", pontoon)
    assert (status, complaints) == (0, "")
    assert said.startswith("Pontoon: the best place for E\n")
    assert re.search(r"contact \(-?[\d.]+, -?[\d.]+\) m, [\d.]+ m along the outline", said)
    assert re.search(r"Direction +-?[\d.]+ deg: pushing.* the inward normal", said)
    assert re.search(r"Force +1\.5000 kN, its limit", said)
    assert re.search(r"Quality +\S+ -> \S+ k?N \((\+\d.* %|from none)\)", said)
    assert re.search(r"Proven +no allowed place is better.*upper bound", said)
    assert re.search(r"Limit now +what remains weakest is", said)
    assert METRIC in said
    assert "Units: SI with degrees" in said


def test_an_unimproving_newcomer_is_told_first(run):
    """Where no single robot helps, the first lines say so, and why."""
    status, said, _ = run("place", "drillship-thrusters")
    first, _, why, suggestion = said.splitlines()[:4]
    assert status == 0
    assert first == "Drillship thrusters: no allowed place for helper raises the quality"
    assert "equally weak" in why
    assert "prepares best for the next robot" in suggestion


def test_several_robots_have_a_row_each(run, pontoon):
    """--robots 3 tells three placements and the quality from first to last."""
    status, said, _ = run("place", pontoon, "--robots", 3)
    assert status == 0
    assert [f"E {k} " in said for k in (1, 2, 3, 4)] == [True, True, True, False]
    assert "for each robot given those before it" in said


@pytest.mark.parametrize("robots", ["1.5", "0x2", "1_0", "0", "-1", "1001", "two"])
def test_robots_are_a_whole_number(run, pontoon, robots):
    """Nothing is rounded, and nothing read as another number than it looks."""
    fault = f"--robots is {robots}; it should be a whole number from 1 to 1000\n"
    assert run("place", pontoon, "--robots", robots) == (2, "", fault)


def test_a_coarse_answer_is_not_called_the_best(run, pontoon):
    """With a gap that matters, the headline promises no more than the proof."""
    _, said, _ = run("place", pontoon, "--gap", 0.9)
    (gap,) = re.findall(r"better by more than (\S+) %", said)
    assert float(gap) > 0.1
    assert said.startswith("Pontoon: best found place for E\n")


@pytest.mark.parametrize(("asked", "told"), [([], "0.0001"), (["--gap", 1e-9], "0.0000000")])
def test_a_gap_is_told_as_finely_as_asked_for(run, asked, told):
    """Of the usual gap no more is said than that it is closed."""
    _, said, _ = run("place", "deck-barge", *asked)
    assert re.search(rf"no allowed place is better by more than {told}\d* %", said)


def test_too_few_robots_are_told_how_many_it_takes(run, pontoon):
    """Force closure takes four: with one there, three more."""
    lines = pontoon.read_text().splitlines(keepends=True)
    pontoon.write_text("".join([*lines[:4], lines[-1]]))
    assert "(--robots 3 goes on from here)" in run("place", pontoon)[1]


def test_newcomers_are_not_called_like_robots(run, pontoon):
    """Several newcomers are numbered, without a number that a robot has already."""
    pontoon.write_text(pontoon.read_text().replace("name: B", "name: E 2"))
    status, said, _ = run("place", pontoon, "--robots", 2)
    assert status == 0
    assert re.search(r"\bE 1\b", said)
    assert re.search(r"\bE 3\b", said)


def test_a_robot_without_a_place_is_told_with_the_file(run, pontoon):
    """Which of several robots finds none, and in which file."""
    pontoon.write_text(pontoon.read_text() + "spacing: 1.5\n")
    status, said, complaints = run("place", pontoon, "--robots", 9)
    assert (status, said) == (2, "")
    assert re.match(rf"{re.escape(str(pontoon))}: only \d of 9 robots find a place: ", complaints)


def test_runners_up_are_those_near_the_best(run):
    """--runners-up 1 asks for equals only; 0.9 also lists the other pads."""
    _, said, _ = run("place", "deck-barge")
    assert re.search(r"^port fore pads +10\.00 .* 97\.5 %", said, re.MULTILINE)
    _, said, _ = run("place", "deck-barge", "--runners-up", 1)
    assert "Next best" not in said


def test_json_on_standard_output_is_json_alone(run, pontoon):
    """`--json -` prints the answer file and nothing else."""
    status, said, complaints = run("place", pontoon, "--json", "-")
    assert (status, complaints) == (0, "")
    assert json.loads(said)["format"] == "swarmgrasp placements 3"


def test_files_are_written_and_named(run, pontoon, tmp_path):
    """--json and --plot write the answer and three pictures, and say so."""
    target, picture = tmp_path / "a.json", tmp_path / "a.svg"
    status, said, _ = run("place", pontoon, "--json", target, "--plot", picture)
    names = ["a.json", "a.svg", "a-wrenches.svg", "a-landscape.svg"]
    assert status == 0
    assert said.splitlines()[-4:] == [f"wrote {tmp_path / name}" for name in names]
    assert {path.name for path in tmp_path.iterdir()} == {*names, "pontoon.yaml"}


def test_every_fault_is_told_at_once_and_nothing_written(run, tmp_path):
    """Faults of options, output paths and the scenario come together, one per line."""
    bad = tmp_path / "bad.yaml"
    bad.write_text("outline: {vertices: [[0, 0], [1, 0], [1, 1]]}\nrobots: [{at: 9, limit: -1}]\n")
    before = sorted(tmp_path.iterdir())
    status, said, complaints = run(
        "place", bad, "--robots", 0, "--gap", 2, "--runners-up", 7,
        "--json", tmp_path / "answer.yaml", "--plot", tmp_path / "no" / "plan.bmp",
    )  # fmt: skip
    told = complaints.splitlines()
    assert (status, said) == (2, "")
    assert [line.split(" is ")[0] for line in told[:3]] == ["--robots", "--gap", "--runners-up"]
    assert told[3].endswith("answer.yaml: the name should end in .json")
    assert "plan.bmp: the name should end in .pdf or .png or .svg" in told[4]
    assert "there is no folder" in told[5]
    assert all(re.match(rf"{re.escape(str(bad))}:\d+:\d+: robots\.0", line) for line in told[6:])
    assert len(told) == 9
    assert sorted(tmp_path.iterdir()) == before


def test_a_folder_without_permission_is_told_before_computing(run, pontoon, tmp_path, monkeypatch):
    """An unwritable folder is a fault, not a surprise after the search."""
    monkeypatch.setattr("os.access", lambda *_: False)
    status, said, complaints = run("place", pontoon, "--json", tmp_path / "a.json")
    assert (status, said) == (2, "")
    assert complaints == f"{tmp_path}: the folder may not be written to; choose another\n"


@pytest.mark.parametrize(
    ("file", "fault"),
    [
        ("nowhere.yaml", "there is no such file, and no built-in example of that name"),
        ("/", "/: is a folder; give a file in it"),
    ],
)
def test_a_file_that_cannot_be_read(run, file, fault):
    """A missing file or a folder is told in one line."""
    status, said, complaints = run("place", file)
    assert (status, said, complaints.count("\n")) == (2, "", 1)
    assert fault in complaints


def test_a_scenario_without_newcomer_has_nobody_to_place(run, pontoon):
    """The fault says what to add."""
    pontoon.write_text("\n".join(pontoon.read_text().splitlines()[:-1]))
    status, said, complaints = run("place", pontoon)
    assert (status, said) == (2, "")
    assert "has no newcomer, and `swarmgrasp place` needs one; add one" in complaints


def test_names_cannot_play_tricks(run, pontoon):
    """Control characters in a name are refused, and shown, not sent to the terminal."""
    plain = pontoon.read_text()
    pontoon.write_text(plain.replace("name: E", "name: 'E[red]'"))
    status, said, _ = run("place", pontoon)
    assert status == 0
    assert "the best place for E[red]" in said.splitlines()[0]
    pontoon.write_text(plain.replace("name: E", r'name: "E\e[31m\n"'))
    status, said, complaints = run("place", pontoon)
    assert (status, said) == (2, "")
    assert (
        r"newcomer.name: holds U+001B, a control character; leave it out (got 'E\x1b" in complaints
    )


def test_a_place_for_the_worst_loss(run):
    """The criterion is told beside the quality, and what the swarm does as it stands."""
    status, said, _ = run("place", "rectangle-15", "--losing", "1", "--runners-up", "1")
    assert status == 0
    assert "after the worst loss of 1 robot" in said
    assert "As it stands" in said
    assert run("place", "rectangle-15", "--losing", "1.5")[0] == 2


def test_a_place_in_the_worst_case(run):
    """A tug that misses its place by some feet and degrees."""
    status, said, _ = run("place", "deck-barge", "--worst-case", "--gap", "1e-3")
    assert status == 0
    assert "in the worst poses" in said


def test_several_at_once(run, tmp_path):
    """Three tugs placed together hold more than one after the other, and the bound says so."""
    target, picture = tmp_path / "together.json", tmp_path / "plan.png"
    status, said, _ = run(
        "place", "deck-barge", "--robots", "3", "--together", "--gap", "0.01",
        "--json", target, "--plot", picture,
    )  # fmt: skip
    found = json.loads(target.read_text())
    assert status == 0
    assert "the best places for 3 tugs like Fortuna, all at once" in said
    assert found["sequential"] < 0.9 * found["quality"]
    assert found["quality"] <= found["upper_bound"] <= 1.011 * found["quality"]
    assert [robot["name"] for robot in found["robots"]] == ["Fortuna 1", "Fortuna 2", "Fortuna 3"]
    assert picture.exists()


@pytest.mark.parametrize(
    ("options", "fault"),
    [
        (["--effort", "100"], "--effort is for robots placed together: add --together"),
        (["--together"], "--together places several robots: add --robots 2 or more"),
        (
            ["--together", "--robots", "3", "--runners-up", "0.5"],
            "--runners-up is for robots placed one after the other: leave out --together",
        ),
        (
            ["--together", "--robots", "3", "--effort", "-1"],
            "--effort is -1; it should be a whole number from 0 to 999999999",
        ),
        (["--robots", "1001"], "--robots is 1001; it should be a whole number from 1 to 1000"),
    ],
)
def test_options_that_do_not_go_together(run, options, fault):
    """None is silently ignored."""
    assert run("place", "deck-barge", *options) == (2, "", f"{fault}\n")


def test_as_things_stand_is_told_in_a_unit_of_its_size(run, tmp_path):
    """Nothing is left after the failure, and much is there before it."""
    path = tmp_path / "tugs.yaml"
    path.write_text(
        "units: {force: kN, angle: deg}\n"
        "outline: {vertices: [[-40, -10], [40, -10], [40, 10], [-40, 10]], edges: [s, e, n, w]}\n"
        "robots:\n"
        "  - {name: A, edge: s, along: 10, direction: inward, limit: 300, steers: 30}\n"
        "  - {name: B, edge: s, along: 70, direction: inward, limit: 300, steers: 30}\n"
        "  - {name: C, edge: n, along: 10, direction: inward, limit: 300, steers: 30}\n"
        "  - {name: D, edge: n, along: 70, direction: inward, limit: 300, steers: 30}\n"
        "newcomer: {name: N, limit: 200, steers: true, attachment: push, half_angle: 20}\n"
        "zones: [{edge: w}]\n"
        "criterion: {failures: [[A, C], [B, D]]}\n"
    )
    status, said, _ = run("place", path)
    assert status == 0
    assert "stays 0 kN\n" in said
    assert "As it stands  stays 404.15 kN" in said


def test_where_not_is_told_of_every_zone_and_edge(run):
    """What is left, what takes the rest, what is gained; for one robot only."""
    said = run("place", "deck-barge", "--where-not")[1]
    assert "Where Fortuna may attach, and where not" in said
    lines = {line[:22].strip(): line for line in said.splitlines()}
    assert lines["stern pads"].endswith(
        "spacing to Castor (49.00 ft), spacing to Electra (11.00 ft)"
    )
    assert "no-go ladder and discharge hose (20.00 ft)" in said
    assert lines["bow"].endswith("outside the zones")
    status, _, complaints = run("place", "deck-barge", "--where-not", "--robots", "2")
    assert (status, complaints) == (
        2, "--where-not is of one robot: leave out --robots and --together\n"
    )  # fmt: skip


def test_a_bare_object_is_pointed_to_placing_together(run, tmp_path):
    """With what all at once reach, beside one after the other."""
    path = tmp_path / "bare.yaml"
    path.write_text(
        "outline: {vertices: [[-2, -1], [2, -1], [2, 1], [-2, 1]]}\n"
        "robots: []\n"
        "newcomer: {limit: 1000, attachment: push, half_angle: 0.5}\n"
    )
    said = run("place", path, "--robots", "4")[1]
    told = re.search(
        r"All at once +([\d.]+) kN or more, ([\d.]+) times as much: add --together", said
    )
    reached = re.search(r"Quality +0 -> ([\d.]+) kN", said)
    assert float(told[1]) / float(reached[1]) == pytest.approx(float(told[2]), rel=0.01)
