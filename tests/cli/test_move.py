import json

import pytest


def test_tells_who_had_better_be_elsewhere(run, tmp_path):
    """Headline, facts, and the best move of each robot."""
    target = tmp_path / "moves.json"
    status, said, complaints = run("move", "deck-barge", "--json", target)
    assert (status, complaints) == (0, "")
    lines = said.splitlines()
    assert lines[0] == "Deck barge: Castor had better be on stern pads"
    assert "Quality    23.374 -> 33.721 tf (+44 %)" in lines
    assert "Meanwhile  0 tf without Castor" in lines
    assert any(line.startswith("Proven     no move of one tug is better") for line in lines)
    rows = lines[lines.index("The best move of each tug") + 2 :][:5]
    assert [row.split()[0] for row in rows] == ["Castor", "Boreas", "Electra", "Dione", "Ajax"]
    found = json.loads(target.read_text())
    assert found["improves"]
    assert found["ranked"][0]["robot"] == "Castor"
    assert found["ranked"][0]["quality"] == pytest.approx(330.69e3, rel=1e-4)
    assert found["ranked"][0]["quality_without"] == 0.0
    assert said.endswith(f"wrote {target}\n")


def test_robots_that_stand_well(run, pontoon):
    """Two that push against each other: no move of one gives any quality."""
    text = pontoon.read_text().splitlines(keepends=True)
    pontoon.write_text("".join([*text[:5], text[-1]]))
    status, said, _ = run("move", pontoon)
    assert status == 0
    assert said.startswith("Pontoon: no robot had better be elsewhere\n")
    assert "leave them" in said


def test_by_a_criterion(run):
    """The scenario's, or that of the options; JSON alone on standard output."""
    _, said, _ = run("move", "rectangle-15", "--losing", "1", "--json", "-")
    found = json.loads(said)
    assert found["problem"]["criterion"]["losing"] == 1
    assert found["quality_before"] == pytest.approx(1.2638, rel=1e-4)
    assert found["ranked"][0]["quality"] > found["quality_before"]


def test_nobody_can_move(run):
    """A vessel with its own thrusters only."""
    status, said, complaints = run("move", "drillship-thrusters")
    assert (status, said) == (2, "")
    assert complaints.startswith("drillship-thrusters: there is no robot that could move")
