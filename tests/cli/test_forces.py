import csv
import io
import json

import pytest

ROUND = "fx,fy,tz\n100,0,-50\n\n0,100,-150\n0,0,-50\n"


@pytest.fixture
def table(tmp_path):
    """Three wrenches in a file, with an empty line between them."""
    path = tmp_path / "wrenches.csv"
    path.write_text(ROUND)
    return path


def test_tells_who_pushes_how_hard(run):
    """300 kN ahead, mostly from the stern; the report says so in words."""
    status, said, complaints = run("forces", "deck-barge", "--wrench", "300kN", "0", "0")
    assert (status, complaints) == (0, "")
    assert said.startswith("Deck barge: the tugs make it, with shares up to 38.9 %\n")
    assert "Wanted         30.591 tf along x: " in said
    assert "Largest share  38.9 %: Castor\n" in said
    assert "Reserve        the tugs could make up to 2.57 times this" in said
    assert "Castor       31.141  38.9 %" in said
    assert "Ajax              0     0 %" in said
    assert "Metric: force weights 1 and 1" in said


def test_negative_numbers_are_numbers(run):
    """A hyphen begins no option here; small forces have a unit of their own."""
    status, said, _ = run("forces", "deck-barge", "--wrench", "-5 N", "0", "-1e-3 N m")
    assert status == 0
    assert "Wanted         -0.00050986 tf along x" in said
    assert "force [tf]      share  limit [tf]" in said


def test_out_of_reach_is_said_plainly(run):
    """What is made instead, how far short it falls, and what it would take."""
    status, said, _ = run("forces", "deck-barge", "--wrench", "900kN", "0", "0")
    assert status == 0
    assert said.startswith("Deck barge: out of reach by 12.3")
    for label in ("Made instead", "Missing", "Short by", "It takes       limits larger by 16.8 %"):
        assert label in said
    assert (
        "limits 5.97 times"
        in run("forces", "deck-barge", "--wrench", "-2MN", "-100kN", "5 MN m")[1]
    )


def test_a_wrench_may_be_beyond_all_limits(run):
    """Five robots of a rectangle do not push to port, however strong."""
    _, said, _ = run("forces", "rectangle-5", "--wrench", "0", "1", "0")
    assert "Made instead  no wrench" in said
    assert "no limits would be large enough" in said


def test_no_wrench_needs_no_force(run, pontoon):
    """The table is there all the same."""
    _, said, _ = run("forces", pontoon, "--wrench", "0", "0", "0")
    assert said.startswith("Pontoon: no force is needed\n")
    assert "Wanted  no wrench" in said
    assert said.count("0    0 %") == 4


def test_a_scenario_may_have_no_robots(run, pontoon):
    """Nobody there: nothing is made, and no table."""
    text = pontoon.read_text()
    pontoon.write_text(text[: text.index("robots:")] + "robots: []\n")
    status, said, _ = run("forces", pontoon, "--wrench", "0", "1", "0")
    assert status == 0
    assert "out of reach by 1.0000 N" in said


def test_the_load_is_held_too(run, pontoon):
    """The environment's part and the robots' are told apart."""
    wrench = ("--wrench", "0", "0", "0", "--load", "-500", "0", "0")
    _, said, _ = run("forces", pontoon, *wrench)
    assert "Wanted         no wrench" in said
    assert "Load           -0.50000 kN along x" in said
    assert "By the robots  0.50000 kN along x" in said


def test_the_load_may_be_the_scenarios(run, pontoon):
    """That of its criterion, unless an option says otherwise."""
    pontoon.write_text(pontoon.read_text() + "criterion: {load: [0, 0, 300]}\n")
    _, said, _ = run("forces", pontoon, "--wrench", "0", "0", "0")
    assert "By the robots  -0.30000 kN m of torque" in said
    _, said, _ = run("forces", pontoon, "--wrench", "0", "0", "0", "--load", "0", "0", "0")
    assert "no force is needed" in said


def test_json_and_a_picture(run, pontoon, tmp_path):
    """The numbers in SI units; what was written is told."""
    numbers, picture = tmp_path / "forces.json", tmp_path / "forces.svg"
    wrench = ("--wrench", "500", "0", "-100")
    status, said, _ = run("forces", pontoon, *wrench, "--json", numbers, "--plot", picture)
    found = json.loads(numbers.read_text())
    assert status == 0
    assert said.endswith(f"wrote {numbers}\nwrote {picture}\n")
    assert picture.read_text().startswith("<?xml")
    assert [robot["name"] for robot in found["swarm"]["robots"]] == ["A", "B", "C", "D"]
    assert found["largest_share"] == max(found["shares"])
    assert found["wrench"] == pytest.approx([500.0, 0.0, -100.0], abs=1e-9)
    _, printed, aside = run("forces", pontoon, *wrench, "--json", "-", "--plot", picture)
    assert json.loads(printed)["shares"] == found["shares"]
    assert aside == f"wrote {picture}\n"


def test_a_table_of_wrenches(run, pontoon, table, tmp_path):
    """In one go: the hardest, what each robot does at most, and a table of all forces."""
    target = tmp_path / "forces.csv"
    status, said, _ = run("forces", pontoon, "--wrenches", table, "--csv", target)
    assert status == 0
    assert said.startswith("Pontoon: 3 wrenches, all made, with shares up to ")
    assert said.endswith(f"wrote {target}\n")
    rows = list(csv.reader(io.StringIO(target.read_text())))
    assert rows[0] == [
        "fx [N]", "fy [N]", "tz [N m]", "largest_share", "needed", "shortfall [N]",
        "A [N]", "B [N]", "C [N]", "D [N]",
    ]  # fmt: skip
    assert [row[:3] for row in rows[1:]] == [
        ["100.0", "0.0", "-50.0"], ["0.0", "100.0", "-150.0"], ["0.0", "0.0", "-50.0"],
    ]  # fmt: skip
    assert float(rows[1][9]) - float(rows[1][8]) == pytest.approx(100.0)
    for option in ("--csv", "--json"):
        _, printed, _ = run("forces", pontoon, "--wrenches", table, option, "-")
        if option == "--csv":
            assert printed == target.read_text()
        else:
            assert list(map(len, json.loads(printed)["shares"])) == [4, 4, 4]


def test_wrenches_out_of_reach_are_told_by_line(run, pontoon, table):
    """Lines are those of the file; other columns and the order of columns do not matter."""
    lines = "\n".join(f"{i},-9,0,{9000 if i in (3, 4, 7) else 1}" for i in range(30))
    table.write_text(f"t, tz, fy, FX\n{lines}\n")
    status, said, _ = run("forces", pontoon, "--wrenches", table)
    assert status == 0
    assert "30 wrenches, 3 out of reach" in said
    assert "Out of reach  lines 5 to 6, 9 of the table" in said
    assert "The 20 hardest wrenches" in said


def test_faults_of_a_table_are_told_at_once(run, table):
    """Each with its line, and those of the options and the scenario with them."""
    table.write_text("fx,fy,tz\n1,b,2\n1,a,3\nnan,0,0\n1,2,3\n")
    status, said, complaints = run("forces", "nowhere", "--wrenches", table, "--plot", "a.png")
    assert (status, said) == (2, "")
    assert complaints.splitlines()[:4] == [
        "--plot goes with --wrench; it draws the forces for one",
        f"{table}:2: fy should be a finite number (got 'b')",
        f"{table}:3: fy should be a finite number (got 'a')",
        f"{table}:4: fx should be a finite number (got 'nan')",
    ]
    assert "nowhere: there is no such file" in complaints


@pytest.mark.parametrize(
    ("text", "complaint"),
    [
        ("", ": is empty"),
        ("1,2,3\n", ":1: has no column fx; its first line should name fx, fy and tz"),
        ("fx,fy,fy\n1,2,3\n", ":1: has two columns fy"),
        ("fx [m],fy,tz\n1,2,3\n", ":1: 'fx': 'm' is a unit of length, not of force"),
        ("fx,fy,tz\n", ":1: has a header and no rows"),
        ("fx,fy,tz\n1,2\n", ":2: has 2 cells; there should be 3"),
        ("fx,fy,tz\n" + "x,y,z\n" * 30, "... and 40 more"),
        ("fx,fy,tz\n" + "1" * 200_000 + ",0,0\n", ":2: is no table"),
        ("fx,fy,tz\n1,2,3\n1e200,0,0\n", ":3: the largest of the three should be 0, or"),
    ],
)
def test_no_table_is_refused(run, pontoon, table, text, complaint):
    """With what is wrong about it."""
    table.write_text(text)
    status, said, complaints = run("forces", pontoon, "--wrenches", table)
    assert (status, said) == (2, "")
    assert complaint in complaints


@pytest.mark.parametrize(
    ("options", "complaint"),
    [
        ((), "--wrench is missing"),
        (("--wrench", "1", "2"), "requires 3"),
        (("--wrench", "1", "nan", "2"), "--wrench is 1 nan 2: 'nan' is no force"),
        (
            ("--wrench", "1", "0", "0", "--load", "1e200", "0", "0"),
            "--load is 1e200 0 0; the largest of the three should be",
        ),
        (("--wrench", "1", "0", "0", "--wrenches", "a.csv"), "do not go together"),
        (("--wrench", "1", "0", "0", "--csv", "a.txt"), "should end in .csv"),
        (("--wrenches", "a.csv", "--csv", "-", "--json", "-"), "cannot both be printed"),
        (("--wrenches", "none.csv"), "none.csv: there is no such file"),
    ],
)
def test_wrong_options_are_told(run, pontoon, options, complaint):
    """Before anything is computed."""
    status, said, complaints = run("forces", pontoon, *options)
    assert (status, said) == (2, "")
    assert complaint in complaints


def test_a_wrench_its_load_and_the_rest_are_told_with_one_prefix(run):
    """The robots make 900 kN of 1.2 MN, and 0.3 MN are the load's."""
    _, said, _ = run(
        "forces", "deck-barge", "--wrench", "1.2MN", "0", "0", "--load", "300kN", "0", "0"
    )
    told = [line for line in said.splitlines() if line.startswith(("Wanted", "Load ", "By the"))]
    assert len(told) == 3
    assert all(" tf along x" in line for line in told)


def test_robots_that_steer_are_told_which_way(run, tmp_path):
    """Force, share and direction of each tug, and who steers as far as it can; in tables, too."""
    picture = tmp_path / "tugs.png"
    wrench = ("--wrench", "300", "150", "0", "--plot", picture)
    status, said, complaints = run("forces", "harbour-tugs", *wrench)
    assert (status, complaints) == (0, "")
    assert "Largest share  59.5 %: Ajax (at its starboard limit), Boreas (at its starboard" in said
    rows = [line.split() for line in said.splitlines()]
    (ajax,) = [row for row in rows if row[:1] == ["Ajax"]]
    assert ajax[1:6] == ["178.43", "59.5", "%", "300.00", "60.0"]
    assert "of the largest it can exert that way." in said
    assert picture.exists()
    table = tmp_path / "wrenches.csv"
    table.write_text("Surge [MN], sway, Mz\n0.3,150,0\n0,0,0\n")
    status, said, _ = run("forces", "harbour-tugs", "--wrenches", table, "--csv", "-")
    head, first, still = csv.reader(io.StringIO(said))
    assert head[6:] == [
        f"{n} [{u}]" for u in ("kN", "deg") for n in ("Ajax", "Boreas", "Castor", "Dione")
    ]
    assert float(first[6]) == pytest.approx(178.4321, rel=1e-5)
    assert [float(v) for v in first[10:]] == pytest.approx([60.0, 60.0, -60.0, -60.0], abs=1e-4)
    assert {float(v) for v in still[6:10]} == {0.0}
    _, printed, _ = run("forces", "harbour-tugs", *wrench[:4], "--json", "-")
    found = json.loads(printed)
    assert found["is_least_squares"] is True
    assert found["vectors"][0] == pytest.approx([89_216.1, 154_526.7], rel=1e-5)


AUV = """\
name: AUV
outline: {vertices: [[-0.3, -0.25], [0.3, -0.25], [0.3, 0.25], [-0.3, 0.25]], origin: [0, 0]}
units: {length: m, force: N, angle: deg}
metric: {characteristic_length: 0.3}
robots:
  - {name: fr, contact: [0.25, -0.2], direction: 45, limit: 40, mounted: true, two_way: true}
  - {name: fl, contact: [0.25, 0.2], direction: -45, limit: 40, mounted: true, two_way: true}
  - {name: rr, contact: [-0.25, -0.2], direction: -45, limit: 40, mounted: true, two_way: true}
  - {name: rl, contact: [-0.25, 0.2], direction: 45, limit: 40, mounted: true, two_way: true}
"""
AIRSHIP = """\
name: Airship
outline: {vertices: [[-2, -0.6], [2, -0.6], [2, 0.6], [-2, 0.6]], origin: [0, 0]}
units: {length: m, force: N, angle: deg}
metric: {characteristic_length: 1}
robots:
  - {name: left, contact: [0, 0.5], direction: 0, limit: 10, mounted: true}
  - {name: right, contact: [0, -0.5], direction: 0, limit: 10, mounted: true}
  - {name: tail, contact: [-1.8, 0], direction: 90, limit: 2, mounted: true, two_way: true}
"""


@pytest.fixture
def asked(run, tmp_path):
    """Ask for forces in a file of some text; return the answer."""

    def asked(text, *options):
        path = tmp_path / "asked.yaml"
        path.write_text(text)
        status, said, complaints = run("forces", path, *options)
        assert (status, complaints) == (0, "")
        return said

    return asked


def test_the_direction_is_kept_if_that_is_wanted(asked):
    """0.282843 = 0.2 sqrt(2) times 200, 200, 60, beside the nearest wrench."""
    said = asked(AUV, "--wrench", "200", "200", "60", "--keep-direction")
    assert said.startswith("AUV: out of reach; the robots make 0.282843 times as much the same way")
    assert "Made           56.569 N along x, 56.569 N along y, 16.971 N m of torque" in said
    assert "Nearest        56.57 N along x, 56.57 N along y, 25.456 N m of torque" in said
    said = asked(AUV, "--wrench", "20", "20", "6", "--keep-direction")
    assert "AUV: the robots make it, with shares up to" in said


def test_a_part_that_does_not_matter(asked):
    """The tail turns by 2 N at 1.8 m if the force across is free, and by nothing if not."""
    said = asked(AIRSHIP, "--wrench", "0", "any", "3.6")
    assert said.startswith("Airship: the robots make it, with shares up to 100 %")
    assert "Wanted         -2.0000 N along y, 3.6000 N m of torque" in said
    assert "the force to port or starboard may be anything" in said
    assert asked(AIRSHIP, "--wrench", "0", "0", "3.6").startswith("Airship: out of reach by")
    said = asked(AIRSHIP, "--wrench", "0", "any", "4", "--losing", "left,right")
    assert said.startswith("Airship: out of reach by 0.4")


def test_units_and_the_frame_of_the_file_on_the_command_line(asked, run):
    """A file with y to starboard: its own axes are asked in, and answered in."""
    said = run("forces", "deck-barge", "--wrench", "30tf", "-1 kN", "0")[1]
    assert "Wanted         30.000 tf along x, -0.102 tf along y" in said
    marine = f"frame: NED\n{AUV}"
    said = asked(marine, "--wrench", "0", "20", "0")
    assert "Wanted         20.000 N along y: moving to starboard" in said


def test_a_load_is_held_without_being_asked(asked):
    """Its first line says so, and who is busiest."""
    said = asked(AUV + "criterion: {load: [0, 16, 0]}\n")
    assert said.startswith("AUV: held against the load: busiest ")
    assert "times this load" in said


@pytest.mark.parametrize(
    ("options", "fault"),
    [
        (("--wrench", "any", "any", "any"), "one of the three should be a number"),
        (("--wrench", "1", "2", "3 kn"), "--wrench is 1 2 3 kn: 'kn' is"),
        (("--load", "any", "0", "0"), "a load is what it is"),
        (("--losing", "Zeus", "--wrench", "1", "0", "0"), "--losing takes 'Zeus', which is no"),
    ],
)
def test_what_cannot_be_asked_is_told(run, options, fault):
    """Each with its remedy."""
    status, said, complaints = run("forces", "deck-barge", *options)
    assert (status, said) == (2, "")
    assert fault in complaints
