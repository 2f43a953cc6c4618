"""`swarmgrasp study`."""

import json

import pyarrow.parquet as pq
import pytest

from swarmgrasp.simulation.study import rows, sizes, together, work
from workers import InlinePool


@pytest.fixture(autouse=True)
def at_once(monkeypatch):
    """Work in this process."""
    monkeypatch.setattr(work, "Pool", InlinePool)


def test_a_study_is_done_told_and_told_again(run, pontoon, tmp_path):
    """Once; after that it is only summed up, by its folder alone."""
    folder, picture = tmp_path / "new" / "sizes", tmp_path / "a.png"
    asked = ("study", pontoon, folder, "--runs", "200", "--robots", "4:5")
    status, said, told = run(*asked, "--plot", picture)
    assert (status, told.splitlines()[0][:16]) == (0, "200 of 200 runs,")
    lines = said.splitlines()
    assert lines[0].startswith("Pontoon: Less than half of the random swarms of up to 5 robots")
    assert lines[2].startswith("robots  runs  with force closure [%]  quality of 10 % [N]  median")
    assert int(lines[3].split()[1]) + int(lines[4].split()[1]) == 200
    assert lines[6:8] == [
        "Runs  200",
        "of    4 to 5 random robots like E of 1.5000 kN, anywhere along the outline",
    ]
    assert lines[-1] == f"wrote {picture}"
    assert picture.stat().st_size > 0
    again = run("study", folder), run("study", folder, "--report"), run(*asked)
    assert {(status, said, told) for status, said, told in again} == {
        (0, "\n".join(lines[:-1]) + "\n", "")
    }
    status, said, _ = run("study", folder, "--json", "-")
    document = json.loads(said)
    assert (document["runs"], document["plan"]["study"]["kind"]) == (200, "sizes")
    assert [row[0] for row in document["findings"]["rows"]] == [4, 5]
    status, said, _ = run("study", folder, "--csv", "-")
    assert said.startswith("robots,runs,with force closure [%],")
    assert [row.split(",")[0] for row in said.splitlines()[1:]] == ["4", "5"]


def test_a_study_is_told_as_its_file_speaks(run, pontoon, tmp_path):
    """By its folder alone, too; in SI units if that is asked for, and the rows are."""
    pontoon.write_text("units: {force: kgf}\nwords: tug\n" + pontoon.read_text())
    said = run("study", pontoon, tmp_path / "a", "--runs", "50", "--robots", "5")[1]
    assert "swarms of up to 5 tugs have force closure" in said
    assert "\ntugs  runs  with force closure [%]  quality of 10 % [kgf]  median [kgf]" in said
    assert "of    5 to 5 random tugs like E of 1500.0 kgf, anywhere" in said
    assert run("study", tmp_path / "a", "--report")[1] == said
    said = run("study", tmp_path / "a", "--report", "--units", "si")[1]
    assert "of    5 to 5 random tugs like E of 14.710 kN, anywhere" in said


@pytest.mark.parametrize("kind", ["losses", "together"])
def test_other_kinds(run, pontoon, tmp_path, kind, monkeypatch):
    """Each is told and drawn."""
    monkeypatch.setattr(together, "EFFORT", 20)
    picture = tmp_path / "a.svg"
    asked = ("study", pontoon, tmp_path / "a", "--of", kind, "--robots", "5", "--runs", "2")
    status, said, _ = run(*asked, "--plot", picture)
    assert status == 0
    assert said.startswith("Pontoon: ")
    assert picture.stat().st_size > 0


def test_an_interrupt_says_how_to_go_on(run, pontoon, tmp_path, monkeypatch):
    """Exit status 130, and what is done is kept."""
    monkeypatch.setattr(sizes.Sizes, "size", 50)
    folder, measure = tmp_path / "a", sizes.Sizes.measure

    def interrupted(study, seeds):
        if measured:
            raise KeyboardInterrupt
        measured.extend(seeds)
        return measure(study, seeds)

    measured = []
    monkeypatch.setattr(sizes.Sizes, "measure", interrupted)
    status, said, told = run("study", pontoon, folder, "--runs", "100")
    assert (status, said) == (130, "")
    last = "stopped: 50 of 100 runs are done and kept; go on with: swarmgrasp study "
    assert told.splitlines()[-1] == f"{last}{folder}"
    monkeypatch.setattr(sizes.Sizes, "measure", measure)
    status, said, _ = run("study", folder)
    assert (status, "Runs  100\n" in said) == (0, True)


SIMULATION = """
environment:
  wind: {vessel: tender, frontal_area: 1, lateral_area: 2, speed: 3, from: 20 deg}
  current: {frontal_area: 1, lateral_area: 2}
simulation: {duration: 5, hull: {draught: 0.5}, weather: {gusts: npd}}
"""


@pytest.mark.parametrize("kind", ["gusts", "story"])
def test_studies_of_simulations(run, pontoon, tmp_path, kind):
    """Of the file's own; told and drawn."""
    pontoon.write_text(pontoon.read_text() + SIMULATION)
    picture = tmp_path / "a.png"
    asked = ("study", pontoon, tmp_path / "a", "--of", kind, "--runs", "3", "--plot", picture)
    status, said, told = run(*asked)
    assert (status, told) == (0, "3 of 3 runs" + told.removeprefix("3 of 3 runs"))
    assert said.startswith("Pontoon: ")
    assert "Fault" not in said
    assert picture.stat().st_size > 0


def test_a_run_of_a_story_can_be_seen_alone(run, pontoon, tmp_path):
    """By its seed, as the rows have it."""
    pontoon.write_text(pontoon.read_text() + SIMULATION)
    run("study", pontoon, tmp_path / "a", "--of", "story", "--runs", "1")
    with rows(tmp_path / "a") as ask:
        ((seed, distance),) = ask("SELECT seed, distance FROM runs")
    log = tmp_path / "alone.parquet"
    assert run("simulate", pontoon, "--seed", seed, "--log", log)[2] == ""
    kept = pq.read_table(log)
    assert max(kept["error"].to_pylist()) == pytest.approx(distance, rel=1e-6)


@pytest.mark.parametrize(
    ("options", "faults"),
    [
        (["--runs", "1x", "--robots", "a", "--workers", "0"],
         ["--runs is 1x", "--workers is 0", "--robots is a"]),
        (["--runs", "9", "--of", "sums"], ["--of is sums; it should be sizes, losses, tog"]),
        (["--of", "losses"], ["--runs is missing; say how many, such as --runs 10000"]),
        (["--runs", "9", "--newcomers", "3"], ["--newcomers is not for --of sizes"]),
        (["--runs", "9", "--of", "story", "--robots", "3", "--newcomers", "3"],
         ["--robots is not for --of story", "--newcomers is not for --of story"]),
        (["--runs", "9", "--of", "gusts"], ["simulation: is missing; say what is to be simulated"]),
        (["--runs", "9", "--robots", "9:4"], ["--robots is 9:4; it should be 1 <= first"]),
        (["--runs", "9", "--workers", "2", "--dask", "tcp://h:1"], ["--workers and --dask excl"]),
        (["--report", "--seed", "2", "--workers", "1"], ["--report runs nothing", "--seed: the"]),
    ],
)  # fmt: skip
def test_wrong_options(run, pontoon, tmp_path, options, faults):
    """All faults at once, and no folder is made."""
    status, said, told = run("study", pontoon, tmp_path / "a", *options)
    assert (status, said) == (2, "")
    lines = [line.removeprefix(f"{pontoon}: ") for line in told.splitlines()]
    assert len(lines) == len(faults)
    assert all(line.startswith(fault) for line, fault in zip(lines, faults, strict=True))
    assert not (tmp_path / "a").exists()


def test_a_folder_that_is_none_of_a_study(run, pontoon, tmp_path):
    """Named, with how to begin; a scenario without a newcomer says nothing of random robots."""
    status, _, told = run("study", tmp_path)
    assert (status, told) == (
        2, f"{tmp_path}: holds no study; begin one with `swarmgrasp study FILE FOLDER --runs N`\n"
    )  # fmt: skip
    pontoon.write_text("\n".join(pontoon.read_text().splitlines()[:-1]))
    status, _, told = run("study", pontoon, tmp_path / "a", "--runs", "9")
    assert (status, told.startswith(f"{pontoon}: newcomer: is missing")) == (2, True)
