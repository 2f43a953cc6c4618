"""`swarmgrasp convert`: a scenario of other programs' files, and what was assumed of them."""

from pathlib import Path

import pytest

from swarmgrasp.cli.app import main
from swarmgrasp.scenario import load_scenario

DATA = Path(__file__).parents[1] / "data" / "cases" / "outline-files"


def test_a_scenario_is_written_with_what_was_assumed(tmp_path, capsys):
    """In comments and on the terminal; what is read back holds the robots of the table, too."""
    tugs, out = tmp_path / "tugs.csv", tmp_path / "dock.yaml"
    tugs.write_text("name,edge,along,direction,limit [tf]\nAjax,0,3,inward,60\n")
    assert main(["convert", str(DATA / "geojson.json"), str(out), "--robots", str(tugs)]) == 0
    told = capsys.readouterr().out
    assert "taken for metres" in told
    assert f"wrote {out}" in told
    assert out.read_text().startswith(
        "# Made of geojson.json by swarmgrasp convert.\n# Assumed:\n# -"
    )
    scenario = load_scenario(out)
    assert scenario.swarm.outline.area == 1200.0
    assert scenario.swarm["Ajax"].limit == pytest.approx(588399.0)
    assert main(["convert", str(out), "-"]) == 0  # a scenario of its own is written anew
    assert "vertices:" in capsys.readouterr().out


def test_nothing_is_written_after_a_fault(tmp_path, capsys):
    """All faults are told, and an existing file stays without --force."""
    out = tmp_path / "dock.yaml"
    (tmp_path / "dock.csv").write_text("0,0\n60,0\n60,x\n")
    assert main(["convert", str(tmp_path / "dock.csv"), str(out), "--tolerance", "5 kN"]) == 2
    assert capsys.readouterr().err.count("\n") == 2
    assert not out.exists()
    out.write_text("mine")
    assert main(["convert", str(DATA / "outline.csv"), str(out)]) == 2
    assert "--force" in capsys.readouterr().err
    assert out.read_text() == "mine"
    assert main(["convert", str(DATA / "outline.csv"), str(out), "--force"]) == 0


def test_options_that_play_no_part_are_refused(tmp_path, capsys):
    """An outline beside an outline, limits of no matrix, a bow for a scenario."""
    out, plan = str(tmp_path / "dock.yaml"), str(DATA / "outline.csv")
    assert main(["convert", plan, out, "--outline", plan, "--limits", "5kN"]) == 2
    told = capsys.readouterr().err
    assert "is an outline: leave out outline" in told
    assert "is an outline: leave out limits" in told
    assert main(["convert", plan, out]) == 0
    assert main(["convert", out, "-", "--bow", "90"]) == 2
    assert "is a scenario: leave out bow" in capsys.readouterr().err
    assert main(["convert", out, "-", "--length", "ft"]) == 2
    assert "is a scenario: leave out units" in capsys.readouterr().err


MATRIX = '{"tam": [[1, 0], [0, 1], [2, 3]], %s}'


def test_nothing_that_is_said_is_passed_over(tmp_path, capsys):
    """Keys of a mapping, degrees of a drawing, a frame in which no map is: told, or refused."""
    tam, out = tmp_path / "tam.json", str(tmp_path / "ship.yaml")
    tam.write_text(MATRIX % '"by": "me", "limits": [1, 1]')
    assert main(["convert", str(tam), "-"]) == 0
    assert "The keys by are left out." in capsys.readouterr().err
    for more, said in (
        ('"limit": [1, 1]', ":1: unknown key 'limit'; did you mean 'limits'?"),
        ('"T": [[1], [0], [2]]', ":1: tam and T each say the matrix; keep one"),
        ('"frme": "NED", "limits": 3', ":1: unknown key 'frme'; did you mean 'frame'?"),
        ('"frme": "NED", "limits": 3', ":1: limits: should be a list, one a column"),
    ):
        tam.write_text(MATRIX % more)
        assert main(["convert", str(tam), out]) == 2
        assert f"{tam}{said}" in capsys.readouterr().err.replace("allocation: ", "")
    drawing = str(DATA.parents[1] / "imports" / "s.svg")
    assert main(["convert", drawing, out, "--coordinates", "metres"]) == 2
    assert "has no longitudes and latitudes; leave out coordinates" in capsys.readouterr().err
    globe = tmp_path / "dock.csv"
    globe.write_text("longitude,latitude\n10.1,54.3\n10.101,54.3\n10.1,54.301\n")
    assert main(["convert", str(globe), out, "--frame", "NED"]) == 2
    assert "x runs to the east and y to the north, as in no frame: NED" in capsys.readouterr().err
    assert main(["convert", str(globe), out, "--frame", "ENU"]) == 0
