"""Tables of wind loads: interpolation, and what is held in them."""

import math
from pathlib import Path

import numpy as np
import pytest

from swarmgrasp import Outline, Robot, Swarm, capability
from swarmgrasp.environment import KNOT, Environment, WindTable
from swarmgrasp.errors import EnvironmentInvalid, ScenarioInvalid
from swarmgrasp.scenario import convert, load_scenario, parse_scenario

HULL = "outline: {vertices: [[-40, -10], [44, -10], [44, 10], [-40, 10]], origin: [0, 0]}\n"
BARGE = Outline([(-40, -10), (44, -10), (44, 10), (-40, 10)], origin=(0, 0))
TUGS = [((-20, -10), 90), ((20, -10), 90), ((-20, 10), -90), ((20, 10), -90)]
SWARM = Swarm(
    BARGE,
    [
        *(Robot(at, math.radians(way), 60e3) for at, way in TUGS),
        Robot((-40, 0), 0.0, 60e3),
        Robot((44, 0), math.pi, 60e3),
    ],
)
TABLE = (
    "wind speed [kn];from [deg];Fx [kN];Fy [kN];Mz [kN m]\n"
    "20;180;9;0;0\n20;0;-9,5;0;0\n20;90;0;-40;-60\n20;45;-7;-20;100\n20;135;6;-22;-210\n"
)
"""Of one side, in disorder, as marine engineers count: sway to starboard, yaw clockwise."""


def scenario_of(folder: Path, table: str, wind: str = "table: loads.csv") -> Environment:
    """Return the surroundings of a scenario with a table."""
    (folder / "loads.csv").write_text(table)
    path = folder / "asked.yaml"
    path.write_text(f"frame: NED\n{HULL}robots: []\nenvironment: {{wind: {{{wind}}}}}\n")
    return load_scenario(path).environment


def test_a_table_tells_the_load_of_any_wind(tmp_path: Path) -> None:
    """Linear over bearings, mirrored, with the square of the speed, moments from midship."""
    around = scenario_of(tmp_path, TABLE, "table: loads.csv, speed: 10 kn, from: 67.5 deg")
    assert around.wind.speeds == (20 * KNOT,)
    amid = np.array([-3.5e3, 30e3, -20e3 + 2.0 * 30e3])  # at 20 kn, about (0, 0): midship is (2, 0)
    assert around.load(BARGE) == pytest.approx(amid / 4.0, rel=1e-12)
    port = around.wind_load(BARGE, -math.radians(67.5), 40 * KNOT)
    assert port == pytest.approx(4.0 * amid * [1, -1, -1], rel=1e-12)
    about = scenario_of(tmp_path, TABLE, "table: {file: loads.csv, about: [0, 0], frame: ENU}")
    assert about.wind_load(BARGE, math.pi / 2, 20 * KNOT).tolist() == [0.0, -40e3, -60e3]
    told = convert(tmp_path / "asked.yaml").text("asked.yaml")
    assert parse_scenario(told).environment.to_data() == about.to_data()


def test_what_is_held_in_a_table_of_one_speed(tmp_path: Path) -> None:
    """By hand: two tugs abeam hold 40 kN and the yaw of 60 kN m and of midship 2 m ahead."""
    found = capability(SWARM, scenario_of(tmp_path, TABLE), [math.pi / 2])
    assert (found.intact[0] / KNOT / 20) ** 2 == pytest.approx(60 / (20 + (60 + 80) / 40), rel=1e-9)


def test_winds_of_several_speeds_are_interpolated(tmp_path: Path) -> None:
    """Loads with a current grow less than with the square; what is held is the end of holding."""
    grown = TABLE + TABLE.split("\n", 1)[1].replace("20;", "30;").replace("-40", "-70")
    around = scenario_of(tmp_path, grown)
    assert not around.grows_with_square
    beam = [around.wind_load(BARGE, math.pi / 2, speed * KNOT)[1] for speed in (10, 20, 25, 30, 60)]
    share = (25**2 - 20**2) / (30**2 - 20**2)
    assert beam == pytest.approx([10e3, 40e3, 40e3 + share * 30e3, 70e3, 280e3])
    found = capability(SWARM, around, [math.pi / 2])
    at_end = around.wind_load(BARGE, math.pi / 2, found.intact[0])
    assert abs(at_end[2]) / 20 + at_end[1] == pytest.approx(120e3, rel=1e-6)


TURNS = {
    "a turn": range(0, 360, 30),
    "a turn and its end": range(0, 361, 30),
    "both sides": range(-180, 181, 30),
    "two turns": range(-90, 630, 30),
    "one side": range(0, 181, 30),
}


@pytest.mark.parametrize("unit", ["deg", "rad", "rad of two decimals"])
@pytest.mark.parametrize("turns", TURNS)
def test_bearings_of_tables_go_round_as_people_write_them(tmp_path, turns, unit) -> None:
    """In degrees or radians, rounded or not, with the first bearing once more at the end or not."""
    lines = [f"speed,from [{unit[:3]}],fx,fy,mz"]
    for degrees in TURNS[turns]:
        way = math.radians(degrees)
        told = f"{degrees}" if unit == "deg" else f"{way:.{2 if 'two' in unit else 7}f}"
        lines.append(f"10,{told},{-9 * math.cos(way):.6f},{20 * math.sin(way):.6f},0")
    table = scenario_of(tmp_path, "\n".join(lines), "table: {file: loads.csv, frame: ENU}").wind
    assert table.is_of_one_side == (turns == "one side")
    for degrees in (0.0, 90.0, 180.0, 240.0, 300.0):
        way = math.radians(degrees)
        surge, sway, _ = table.load(BARGE, way, 10.0)
        off = 0.1 if "two" in unit else 1e-4
        assert (surge, sway) == pytest.approx((-9 * math.cos(way), 20 * math.sin(way)), abs=off)


def test_bearings_of_a_table_in_another_unit_are_refused(tmp_path: Path) -> None:
    """Degrees that are read as radians, and radians that are read as degrees, tell no loads."""
    text = "9,0,1,0,0\n9,90,0,1,0\n9,180,1,0,0\n"
    with pytest.raises(ScenarioInvalid, match=r"run to 180 rad; they look like degrees"):
        scenario_of(tmp_path, text)
    path = tmp_path / "asked.yaml"
    path.write_text("units: {angle: deg}\n" + path.read_text())
    rows = "9,0,1,0,0\n9,1.571,0,1,0\n9,3.1416,1,0,0\n"
    (tmp_path / "loads.csv").write_text(rows)
    with pytest.raises(ScenarioInvalid, match="look like radians that are read as degrees"):
        load_scenario(path)


@pytest.mark.parametrize(
    ("table", "said"),
    [
        (TABLE.replace("20;45;-7", "20;45;x"), "loads.csv:5: environment.wind.table: fx should be"),
        (TABLE.replace("20;45", "21;45"), "the wind of 10.289 m/s from 45 deg is missing"),
        (TABLE + "20;90;0;-41;-60\n", "stands twice, with other loads"),
        (TABLE.replace("Mz", "Mx"), "unknown column 'mx'"),
        (
            TABLE.replace("[kn]", "[knZ]"),
            "loads.csv:1: environment.wind.table: 'wind sp",
        ),
        ("20,0,1,2,3\n20,1.5,1,2,3\n", "leave a gap from 85.94 to 0 deg"),
        ("20,0,1,2\n", "has 4 cells"),
        ("0,0,1,2,3\n0,1.57,1,2,3\n0,3.14,1,2,3\n", "the first speed is 0"),
        ("", "is empty"),
    ],
)
def test_wrong_tables_are_refused(tmp_path: Path, table: str, said: str) -> None:
    """With the file and the line, or the place in the scenario; with no other fault beside."""
    with pytest.raises(ScenarioInvalid) as caught:
        scenario_of(tmp_path, table)
    assert any(said in fault for fault in caught.value.faults)
    assert all("table" in fault for fault in caught.value.faults)


def test_tables_are_checked_and_go_with_no_drag() -> None:
    """In Python, and in text beside what also says the loads, and for a run in time."""
    with pytest.raises(EnvironmentInvalid) as caught:
        WindTable((0.0, -1.0), (0.0, 3.0), (((1, 2, 3),),), about=(1,), speed=3.0)
    assert len(caught.value.faults) == 7
    with pytest.raises(EnvironmentInvalid, match=r"\(m, 5\) finite numbers"):
        WindTable.from_rows([[1, 2, 3]])
    rows = "rows: [[9, 0, 1, 0, 0], [9, 90, 0, 1, 0], [9, 180, 1, 0, 0]]"
    text = (
        f"units: {{angle: deg}}\n{HULL}robots: []\nenvironment: {{wind: {{table: {{{rows}}}%s}}}}\n"
    )
    table = parse_scenario(text % "").environment.wind
    assert table.is_of_one_side
    with pytest.raises(ScenarioInvalid, match=r"table\.rows: is missing; give rows"):
        parse_scenario(text.replace(rows, "about: [0, 0]") % "")
    with pytest.raises(ScenarioInvalid) as refused:
        parse_scenario(text % ", vessel: ferry, frontal_area: 3, speed: 3")
    assert len(refused.value.faults) == 3
    run = "simulation: {duration: 60, hull: {draught: 2}}\n"
    with pytest.raises(ScenarioInvalid, match="a run in time knows none"):
        parse_scenario(text % ", speed: 3, from: 0" + run)


def test_a_wind_that_exerts_nothing_is_refused():
    """From any bearing: how much of it is held has no end."""
    rows = [(10.0, 0.0, 0, 0, 0), (10.0, 1.5, 0, 4e4, 0), (10.0, 3.0, 0, 0, 1.0)]
    with pytest.raises(EnvironmentInvalid, match="no wind from 0 deg exerts anything"):
        WindTable.from_rows(rows)
