"""`swarmgrasp simulate`: words, files, exit status and faults."""

import json
import math
import re
import signal
from importlib import import_module

import numpy as np
import pytest
from pyarrow import parquet

from swarmgrasp.cli.show.simulate import show
from swarmgrasp.simulation.record import read_log
from swarmgrasp.simulation.run import Run
from swarmgrasp.simulation.verdict import verdict_of
from swarmgrasp.terms import SI

FILE = """\
name: Pontoon
units: {{length: m, angle: deg}}
outline: {{vertices: [[-2, -1], [2, -1], [2, 1], [-2, 1]], edges: [starboard, bow, port, stern]}}
robots:
  - {{name: A, edge: starboard, along: 0.5, direction: inward, limit: 200}}
  - {{name: B, edge: starboard, along: 3.5, direction: inward, limit: 200}}
  - {{name: C, edge: port, along: 0.5, direction: inward, limit: 200}}
  - {{name: D, edge: port, along: 3.5, direction: inward, limit: 200}}
  - {{name: E, edge: bow, along: 1, direction: inward, limit: 200}}
  - {{name: F, edge: stern, along: 1, direction: inward, limit: 200}}
newcomer: {{name: G, limit: 200, attachment: push, half_angle: 30}}
environment:
  wind: {{vessel: tender, frontal_area: 2, lateral_area: 4{wind}}}
  current: {{frontal_area: 1, lateral_area: 2}}
"""
WIND = ", speed: 5, from: 90"
SIMULATION = """\
simulation:
  duration: 12
  seed: 4
  robots: {lag: 1, slew: 1}
  control: {period: 0.1}
"""


@pytest.fixture
def pond(tmp_path):
    """Return a function that writes a pontoon in the wind, and what happens to it."""

    def pond(more=SIMULATION, wind=WIND):
        path = tmp_path / "pond.yaml"
        path.write_text(FILE.format(wind=wind) + more)
        return path

    return pond


def test_an_object_that_is_held(run, pond):
    """Within what, in the first line; the wind that acts; the margin; status 0."""
    status, said, complaints = run("simulate", pond())
    assert (status, complaints) == (0, "")
    lines = said.splitlines()
    assert lines[0].startswith("Pontoon: held within 0.0")
    assert lines[0].endswith(" deg for 12 s")
    assert "Wind     5 m/s from 90 deg, no gusts" in lines
    assert "Current  none" in lines
    assert any(line.startswith("Margin   ") and "mean load at the start" in line for line in lines)
    assert any(line.endswith("never") and "the run begins" in line for line in lines)


def test_a_run_too_short_to_tell_anything_says_so(run, pond):
    """Not how many thousand per cent of load it would have told."""
    _, said, _ = run("simulate", pond(), "--for", "0.1")
    assert "Length   too short a run to tell even a load twice as large as the robots" in said


def test_a_control_too_slow_is_told_where_it_is_said(run, pond):
    """For its observer, and for so short a run: all at once, before anything is run."""
    slow = SIMULATION.replace("period: 0.1", "period: 20") + "  events: [{at: 15, lose: A}]\n"
    status, said, complaints = run("simulate", pond(slow))
    assert (status, said) == (2, "")
    for told, wanted in zip(
        complaints.splitlines(),
        (
            ":16:13: simulation.duration: the run ends at 12 s, before a period of the control, 20",
            ":19:21: simulation.control.period: the control's period is 20 s, too long for an obse",
            ":20:12: simulation.events.0: lose at 15 s: the run ends at 12 s; it should be before",
        ),
        strict=True,
    ):
        assert wanted in told
    complaints = run("simulate", pond(), "--for", "0.01")[2]
    assert complaints.startswith("--for: the run ends at 0.01 s, before a period of the control")
    still = SIMULATION.replace("{lag: 1, slew: 1}", "{lag: 0, except: [{name: A, lag: 1}]}")
    assert run("simulate", pond(still), "--for", "1")[0] == 0  # another's lag is enough


def test_an_object_that_is_not_held(run, pond):
    """A loss on the lee side: when and after what it left, foretold and simulated; status 1."""
    status, said, _ = run(
        "simulate",
        pond(),
        "--losing",
        "D@2s",
        "--wind",
        "12kn",
        "--from",
        "90",
        "--within",
        "30cm",
        "--for",
        "30",
    )
    assert status == 1
    first = said.splitlines()[0]
    assert "not held from " in first
    assert " s after D is lost, " in first
    assert " N out of reach; off by " in first
    (row,) = [line.split() for line in said.splitlines() if line.startswith("     2  D is lost")]
    simulated, foretold = map(float, row[-2:])
    assert foretold / 1.6 < simulated < 1.6 * foretold


def test_every_file_is_written(run, pond, tmp_path):
    """A log, a sheet and three animations, each told."""
    names = {"log": "a.parquet", "plot": "a.png", "gif": "a.gif", "mcap": "a.mcap",
             "player": "a.json"}  # fmt: skip
    options = [x for key, name in names.items() for x in (f"--{key}", tmp_path / name)]
    status, said, _ = run("simulate", pond(), "--for", "3", *options)
    assert status == 0
    for name in names.values():
        assert f"wrote {tmp_path / name}" in said
        assert (tmp_path / name).stat().st_size > 1000
    assert np.asarray(parquet.read_table(tmp_path / "a.parquet")["time"])[-1] == pytest.approx(3.0)


def test_options_change_what_the_file_says(run, pond, tmp_path):
    """Another seed moves it otherwise; events after an earlier end are left out, and told."""
    later = SIMULATION + "  events: [{at: 1, lose: A}, {at: 5, send: newcomer}]\n"
    later = later.replace("lag: 1,", "lag: 1, except: [{name: G, lag: 2}],")
    tables = []
    for seed in ("4", "5"):
        status, _, complaints = run(
            "simulate", pond(later), "--for", "2", "--seed", seed, "--log", tmp_path / "a.parquet"
        )
        assert status in (0, 1)
        assert complaints == "left out: 1 event after 2 s\n"
        tables.append(parquet.read_table(tmp_path / "a.parquet"))
    assert tables[0]["x"][-1] != tables[1]["x"][-1]
    assert tables[0]["seed"][0].as_py() == 4


STORY = """
name: Pontoon
units: {length: ft, force: kgf, angle: deg, speed: kn}
words: launch
frame: NED
heading: 30
outline: {vertices: [[-6, 3], [-6, -3], [6, -3], [6, 3]], edges: [stern, port, bow, starboard]}
robots:
  - {name: A, edge: starboard, along: 1.5, direction: inward, limit: 20}
  - {name: B, edge: starboard, along: 10.5, direction: inward, limit: 20}
  - {name: C, edge: port, along: 1.5, direction: inward, limit: 20}
  - {name: D, edge: port, along: 10.5, direction: inward, limit: 20}
newcomer: {name: G, limit: 20, attachment: push}
zones: [{edge: bow}]
environment:
  wind: {vessel: tender, frontal_area: 20, lateral_area: 40, speed: 10, from: E}
  current: {frontal_area: 10, lateral_area: 20}
simulation:
  duration: 4
  robots: {lag: 1, slew: 1}
  events:
    - {at: 1, send: newcomer, away: 30, speed: 10, make_fast: 60}
    - {at: 2, move: [1, 2, 10]}
    - {at: 3, wind: {speed: 12, from: SE}}
"""


def test_a_run_is_told_as_its_file_speaks(run, tmp_path):
    """In its units, its frame, true bearings and its word; in SI units if that is asked for."""
    path = tmp_path / "story.yaml"
    path.write_text(STORY)
    status, said, _ = run("simulate", path)
    assert status == 0
    assert re.search(r"held within [0-9.]+ ft and [0-9.]+ deg for 4 s", said)
    assert "Wind     10 kn from 90 deg true, no gusts" in said
    assert re.search(r"G is sent to \(6\.\d, -?\d\.\d\) ft, [0-9.]+ ft to go; it joins at", said)
    assert "the object is to move to (1, 2) ft, heading 40 deg true" in said
    assert "the weather changes: wind 12 kn from 135 deg true" in said
    assert "margin [kgf]  off by [ft]" in said
    assert "what the launches can exert" in said
    assert "Bearings: true, where it comes from; the bow is at 30 deg at the start." in said
    said = run("simulate", path, "--units", "si")[1]
    assert "the object is to move to (0.3048, 0.6096) m, heading 40 deg true" in said
    assert "wind 6.17 m/s from 135 deg true" in said
    plain = json.loads(run("simulate", path, "--json", "-")[1])["happenings"][2]
    assert plain["words"] == "the object is to move to (0.3048, -0.6096) m, heading -10 deg"
    assert plain["numbers"]["heading"] == pytest.approx(math.radians(-10))


FAULTS = {
    ("--for", "-1"): "--for is -1; it should be from 0.001 to 1e+06 s",
    ("--seed", "x"): "--seed is x; it should be a whole number from 0 to 9223372036854775807",
    ("--losing", "A"): (
        "--losing is A; it should be a robot or group and a time, such as Castor@60"
    ),
    ("--losing", "A@3 m"): (
        "--losing is A@3 m: the time is 3 m: 'm' is a unit of length, not of time; known: s, min, h"
    ),
    ("--losing", "Q@3"): (
        "--losing: lose at 3 s: there is no robot called 'Q' then; known: A, B, C, D, E, F"
    ),
    ("--losing", "A@30"): (
        "--losing: lose at 30 s: the run ends at 12 s; it should be before"
    ),
    ("--wind", "fast"): (
        "--wind is fast: 'fast' is no speed; write a number, or one with its unit, such as 25 kn"
    ),
    ("--within", "1e-10"): "--within is 1e-10; it should be from 1e-09 to 1e+09 m",
    ("--turn", "361"): "--turn is 361; it should be from 5.73e-08 to 360 deg",
    ("--gif", "a.png"): "a.png: the name should end in .gif",
}  # fmt: skip


@pytest.mark.parametrize("options", FAULTS)
def test_a_wrong_option_is_told(run, pond, options):
    """One sentence with the value, its range and what to do; status 2."""
    status, said, complaints = run("simulate", pond(), *options)
    assert (status, said, complaints) == (2, "", FAULTS[options] + "\n")


def test_what_a_file_needs(run, pond, pontoon):
    """An environment, and a wind: from the file or the command line."""
    status, _, complaints = run("simulate", pontoon)
    assert status == 2
    assert complaints.startswith(f"{pontoon}:1:1: environment: is missing; say what")
    complaints = run("simulate", "deck-barge")[2]  # which no reader can look up a line in
    assert complaints.startswith("deck-barge, a built-in example: environment.wind: a simulation")
    calm = pond(more="", wind="")
    status, _, complaints = run("simulate", calm)
    assert status == 2
    assert complaints.startswith(f"{calm}:1:1: environment.wind: a simulation needs its")
    status, said, _ = run("simulate", calm, "--wind", "1kn", "--from", "0", "--for", "1s")
    assert status == 0
    assert "Wind     0.514 m/s from 0 deg, gusts of standard deviation 0.0" in said


def test_the_largest_winds(run, pond, tmp_path):
    """By statics and simulated, at every bearing; a file without a wind will do."""
    calm = pond(more="", wind="")
    picture = tmp_path / "limits.png"
    status, said, complaints = run(
        "simulate", calm, "--capability", "--for", "2", "--within", "0.001", "--plot", picture
    )
    assert (status, complaints) == (0, "")
    lines = said.splitlines()
    assert lines[0].startswith("Pontoon: simulated, ")
    assert " of the static limits are held in a steady wind, " in lines[0]
    rows = [line.split() for line in lines if line[:14].strip().isdigit()]
    assert [float(row[0]) for row in rows] == [15.0 * k for k in range(24)]
    assert all(float(row[4]) >= 0.9 for row in rows)
    assert picture.exists()
    said = run("simulate", calm, "--capability", "--for", "2")[1]  # too short to go anywhere
    assert ": simulated, more than 1.300 of the static limits are held in a steady" in said
    assert "in gusts; 2 s are too short to tell them all\n" in said
    status, _, complaints = run("simulate", calm, "--capability", "--gif", "a.gif")
    assert (status, complaints) == (2, "--gif is of a run, and --capability makes none\n")


def test_a_run_that_is_stopped_is_told_as_far_as_it_went(monkeypatch, run, pond, tmp_path):
    """Ctrl-C keeps what was run: its files are written, and the status is 130."""
    room = import_module("swarmgrasp.simulation.simulate")
    whole = room.simulate

    def interrupted(simulation, *, sink, progress):
        def tell(part):
            if 0.4 < part < 0.6:
                signal.raise_signal(signal.SIGINT)
            progress(part)

        return whole(simulation, sink=sink, progress=tell)

    monkeypatch.setattr(room, "simulate", interrupted)
    path = tmp_path / "a.parquet"
    status, said, _ = run("simulate", pond(SIMULATION.replace("12", "60")), "--log", path)
    assert status == 130
    first = said.splitlines()[0]
    assert first.startswith("Pontoon: held within ")
    assert " deg until it was stopped at " in first
    assert first.endswith(" of 60 s")
    kept = read_log(path)
    assert not kept.is_whole
    assert f" at {kept.times[-1]:g} s of " in first


def test_a_full_turn_is_told_as_one_and_ends_where_it_should(capsys):
    """The largest error counts turns; the last one goes the shorter way."""
    from dataclasses import replace

    from made_runs import made_run

    run: Run = made_run(seeds=(1,))
    poses, turns = run.poses.copy(), run.turns.copy()
    poses[0, 100:, 2] += 2.0 * math.pi
    turns[0, 100:] = np.abs(poses[0, 100:, 2])
    run = replace(run, poses=poses, turns=turns)
    show("Barge", run, verdict_of(run), SI)
    first = capsys.readouterr().out.splitlines()[0]
    assert "36" in first.split(" deg at most")[0].split(" and ")[-1]
    assert " and 0.14 deg at 300 s" in first
