"""Answers come in the terms of the file, or in SI units; directions as bearings on request."""

import csv
import json
import re
from dataclasses import replace

import numpy as np
import pytest

from swarmgrasp.cli.show import placement
from swarmgrasp.placement import place_sequence
from swarmgrasp.scenario import load_example
from swarmgrasp.terms import Frame, Terms

COMMANDS = [
    ["place", "deck-barge"],
    ["place", "deck-barge", "--robots", "2", "--together", "--effort", "20"],
    ["quality", "deck-barge", "--losing", "1", "--sensitivities"],
    ["forces", "deck-barge", "--wrench", "300kN", "0", "0"],
    ["move", "deck-barge"],
    ["count", "deck-barge", "--quality", "300kN"],
]


@pytest.mark.parametrize("command", COMMANDS, ids=lambda command: " ".join(command))
def test_units_are_those_of_the_file_or_si(run, command):
    """No number in metres or newtons where the file has feet and tonnes; and the other way."""
    status, said, complaints = run(*command)
    assert (status, complaints) == (0, "")
    assert " tf" in said or "[tf" in said
    assert "Units: feet, tonne-force (tf), knots, degrees. Frame: x forward, y to port" in said
    assert not any(unit in said for unit in (" m,", "[m]", "kN", " N "))
    status, said, complaints = run(*command, "--units", "si")
    assert (status, complaints) == (0, "")
    assert "kN" in said
    assert "Units: SI with degrees. Frame" in said
    assert not any(unit in said for unit in (" ft", "[ft", " tf", "[tf"))


def test_numbers_without_a_unit_are_in_those_of_the_answer(run, tmp_path):
    """Options and tables alike: tonnes and feet of a file, or newtons and metres on request."""
    table = tmp_path / "wrenches.csv"
    table.write_text("fx,fy,tz\n20,-1,30\n")
    told = tmp_path / "told.csv"
    told.write_text("fx [tf],fy [kip],tz [tf ft]\n20,-2.204622622,30\n")
    si = {"20": 196133.0, "-1": -9806.65, "30": 89672.0076}
    asked = [
        (["--wrench", "20", "-1", "30"], "file"),
        (["--wrench", "20tf", "-1 t", "30 tf ft"], "si"),
        (["--wrench", *map(str, si.values())], "si"),
        (["--wrenches", table], "file"),
        (["--wrenches", told], "si"),
    ]
    found = []
    for options, units in asked:
        _, said, complaints = run("forces", "deck-barge", *options, "--units", units, "--json", "-")
        assert complaints == ""
        found.append(np.ravel(json.loads(said)["wanted"]))
    for wanted in found:
        np.testing.assert_allclose(wanted, list(si.values()), rtol=1e-8)
    for units, wind, factor in (("file", "20", 1852 / 3600), ("si", "20", 1.0)):
        said = run("capability", "deck-barge", "--use", wind, "--units", units, "--json", "-")[1]
        assert json.loads(said)["speed"] == pytest.approx(20 * factor)


def test_directions_as_bearings(run):
    """Clockwise from the bow, in sentences, tables and the small print."""
    said = run("place", "deck-barge", "--bearings")[1]
    assert "Direction  bearing 112.9 deg: pushing" in said
    assert "bearing [deg]" in said
    assert "degrees clockwise from the bow" in said


def test_a_file_of_another_frame_and_word_is_answered_in_them(capsys):
    """With y to starboard and angles clockwise, points and directions are mirrored."""
    terms = Terms("ft", "tf", speed="kn", frame=Frame(mirrored=True), robot="tug")
    answers = place_sequence(load_example("deck-barge").problem(), 1, runners_up=0.9)
    placement.show("Barge", answers, terms)
    said = capsys.readouterr().out
    assert "contact (-40.00, -36.00) ft" in said
    assert "Direction  112.9 deg: pushing, 22.9 deg clockwise off the inward normal" in said
    assert "the best tug on each other edge" in said
    assert "Frame: x forward, y to starboard, as in the file; torques clockwise." in said
    north = replace(terms, frame=Frame(heading=1.0), bearings=True)
    placement.show("Barge", answers, north)
    said = capsys.readouterr().out
    assert "bearing 170.2 deg" in said  # 112.9 from a bow at 57.3
    assert "degrees clockwise from north" in said


def test_one_unit_for_all_forces_of_an_answer(run, pontoon):
    """Of a small wanted wrench and large limits, too."""
    said = run("forces", pontoon, "--wrench", "5", "0", "0", "--load", "400", "0", "0")[1]
    assert "kN" in said
    assert " N " not in said
    assert "[N" not in said


def test_tables_as_csv(run, tmp_path):
    """Each in a file of its own, with its units in the first line; or the first one printed."""
    path = tmp_path / "losses.csv"
    status, said, _ = run("quality", "deck-barge", "--losing", "1", "--csv", path)
    assert status == 0
    assert said.endswith(f"wrote {path}\nwrote {tmp_path / 'losses-robots.csv'}\n")
    rows = list(csv.DictReader(path.read_text().splitlines()))
    assert rows[3]["without"] == "Boreas"
    assert float(rows[3]["quality [tf]"]) == pytest.approx(3.6661)
    assert float(rows[3]["left [%]"]) == pytest.approx(15.7)
    status, said, complaints = run("place", "deck-barge", "--csv", "-")
    assert (status, complaints) == (0, "")
    assert said.startswith("place,x [ft],y [ft],")
    status, _, complaints = run("quality", "deck-barge", "--csv", "-", "--json", "-")
    assert status == 2
    assert "cannot both be printed" in complaints


def test_large_numbers_are_written_out(run, tmp_path):
    """Limits in pounds, areas and seas in millimetres: all digits of whole numbers, no powers."""
    barge = tmp_path / "barge.yaml"
    barge.write_text(
        "units: {length: mm, force: lbf, angle: deg, speed: kn}\n"
        "outline: {vertices: [[-130000, -33000], [130000, -33000], [130000, 33000], "
        "[-130000, 33000]]}\n"
        "robots:\n"
        "  - {edge: 0, along: 50000, direction: inward, limit: 134885, steers: 30}\n"
        "  - {edge: 2, along: 40000, direction: inward, limit: 134885, steers: 30}\n"
        "newcomer: {limit: 1348850, attachment: push, length: 30000, beam: 9000}\n"
        "spacing: 12345\n"
        "environment:\n"
        "  wind: {vessel: ferry, frontal_area: 1.2e9, lateral_area: 5.4e9, speed: 9, from: 60}\n"
        "  waves: {height: 2100, period: 7}\n"
        "criterion: {load: environment}\n"
    )
    told = [run(*each)[1] for each in (
        ("quality", barge), ("place", barge), ("capability", barge, "--step", "90"),
    )]  # fmt: skip
    for words, said in zip(
        ("134885 lbf within 30 deg", "needs 30000 mm by 9000 mm", "1200000000 mm2 ahead"),
        told,
        strict=True,
    ):
        assert words in said
        assert not re.search(r"\de[+-]\d", said)
    assert "a sea of 2100 mm and 7 s from 60 deg" in told[0]
