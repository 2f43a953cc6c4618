"""Allocation matrices in tables: what is taken for one, the line of each fault, and units."""

from pathlib import Path

import pytest

from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.scenario import convert
from swarmgrasp.scenario.imports.allocation import is_allocation_file

THRUSTERS = [
    "name,Fx,Fy,Mz [ft],limit [kN]\nbow,0,1,100,20\ngyro,0,0,10,5\n",
    "row;bow;gyro\nFx;0;0\nFy;1;0\nMz [ft];100;10\nlimit [kN];20;5\n",
]


@pytest.mark.parametrize("content", THRUSTERS)
@pytest.mark.parametrize("length", ["m", "ft"])
def test_a_yaw_is_a_length_in_its_own_unit(tmp_path: Path, content: str, length: str) -> None:
    """A thruster a line or a column, in a scenario in either unit."""
    (tmp_path / "tam.csv").write_text(content)
    bow, gyro = convert(tmp_path / "tam.csv", units={"length": length}).scenario.swarm
    assert bow.contact == pytest.approx((30.48, 0.0))
    assert (bow.limit, gyro.lever) == (20e3, pytest.approx(3.048))


@pytest.mark.parametrize(
    ("content", "is_one"),
    [
        ("n,x,y\n1,0,0\n2,60,0\n3,60,20\n", False),
        ("name,x,y,n\na,0,0,1\nb,60,0,2\nc,60,20,3\n", False),
        ("x,y,n,limit\n0,1,30,5\n1,0,2,5\n", True),
        ("surge,sway,yaw\n0,1,30\n", True),
    ],
)
def test_points_of_a_survey_are_no_thrusters(tmp_path: Path, content: str, is_one: bool) -> None:
    """Their number, x and y are headings of a matrix, too; limits beside them tell."""
    path = tmp_path / "points.csv"
    path.write_text(content)
    assert is_allocation_file(path) is is_one
    if not is_one:
        assert convert(path).scenario.swarm.outline.area == 600.0


@pytest.mark.parametrize(
    ("name", "content", "said"),
    [
        (
            "a.csv",
            "Fx,Fy,Mz,limit\n0,1,30,5\n\n0,one,30,5\n0,1,x,5\n",
            ["a.csv:4: allocation: Fy should be a finite number (got 'one')",
             "a.csv:5: allocation: Mz should be a finite number (got 'x')"],
        ),
        (
            "b.csv",
            "Fx;0;1\nFy;x;0\n# yaw\nMz;30;x\nlimit;5;5\n",
            ["b.csv:2: allocation: column 2 should be a finite number (got 'x')",
             "b.csv:4: allocation: column 3 should be a finite number (got 'x')"],
        ),
        (
            "c.csv",
            "0,1,2,3\n0,1,2,3\n0,nan,2,3\n",
            ["c.csv:3: allocation: column 2 should be a finite number (got 'nan')"],
        ),
        (
            "d.csv",
            "Fx,Fy [m],Mz [kN],limit\n0,1,30,5\n",
            ["d.csv:1: allocation: 'fy' has no unit; leave it out",
             "d.csv:1: allocation: 'mz': 'kN' is a unit of force, not of length"],
        ),
        (
            "e.csv",
            "Fx;0;1\nup;1;0\nMz [s];30;2\nlimit;5;5\n",
            ["e.csv:2: allocation: a row is called 'up'", "e.csv:3: allocation: 'mz'",
             "e.csv: allocation: has no row Fy"],
        ),
    ],
)  # fmt: skip
def test_faults_are_told_in_their_lines(
    tmp_path: Path, name: str, content: str, said: list[str]
) -> None:
    """All of them, each by the column that its writer sees."""
    path, asked = tmp_path / name, tmp_path / "asked.yaml"
    path.write_text(content)
    hull = "[[-9, -3], [9, -3], [9, 3], [-9, 3]]"
    asked.write_text(f"outline: {{vertices: {hull}}}\nallocation: {{file: {name}}}\n")
    with pytest.raises(ScenarioInvalid) as caught:
        convert(asked)
    told = sorted(fault.replace(f"{tmp_path}/", "") for fault in caught.value.faults)
    assert len(told) == len(said)
    assert all(map(str.startswith, told, sorted(said)))


def test_capitals_of_a_name_make_no_difference(tmp_path: Path) -> None:
    """A list of rows in JSON, called as some systems write names."""
    path = tmp_path / "TAM.JSON"
    path.write_text("[[0, 0], [1, 0], [30, 2]]")
    assert len(convert(path, limits=[5.0, 5.0]).scenario.swarm) == 2


def test_options_that_play_no_part_are_told(tmp_path: Path) -> None:
    """What says how an outline is read, beside a matrix alone; keywords that there are none of."""
    path = tmp_path / "tam.csv"
    path.write_text(THRUSTERS[0])
    with pytest.raises(ScenarioInvalid, match="no outline is given: leave out scale"):
        convert(path, scale=2.0)
    with pytest.raises(TypeError, match="scal"):
        convert(path, scal=2.0)
