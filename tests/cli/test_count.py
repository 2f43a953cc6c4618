import json

import pytest


def test_tells_the_fewest_and_where_they_go(run, tmp_path):
    """Two tugs for 600 kN, one is proven not to be enough."""
    target = tmp_path / "count.json"
    status, said, complaints = run("count", "deck-barge", "--quality", "600kN", "--json", target)
    assert (status, complaints) == (0, "")
    lines = said.splitlines()
    assert lines[0] == "Deck barge: 2 tugs are the fewest for 61.183 tf"
    assert "Proven      2 tugs can, 1 cannot, wherever they attach" in lines
    assert sum(line.startswith("Fortuna ") for line in lines) == 2
    found = json.loads(target.read_text())
    assert (found["count"], found["at_least"], found["is_proven"]) == (2, 2, True)
    assert found["quality"] >= 600e3
    assert len(found["answer"]["robots"]) == 2
    assert said.endswith(f"wrote {target}\n")


def test_more_than_allowed(run):
    """Out of reach of so many, and proven to be."""
    status, said, _ = run("count", "deck-barge", "--quality", "2MN", "--most", "3")
    assert status == 0
    assert "203.94 tf is out of reach of 3 tugs" in said
    assert "Quality  23.374 tf as it is" in said
    assert "3 tugs cannot reach it, wherever they attach" in said


def test_not_found_is_not_out_of_reach(run):
    """Without effort nothing is settled, and nothing printed says that it is."""
    status, said, _ = run(
        "count", "deck-barge", "--quality", "1.2MN", "--most", "5", "--effort", "0"
    )
    assert status == 0
    assert "was not reached with up to 5 tugs" in said
    assert "no places for up to 5 tugs that reach it were found; no fewer than" in said
    assert "cannot" not in said


def test_none_is_needed(run):
    """What is there already needs no table."""
    _, said, _ = run("count", "deck-barge", "--quality", "1kN", "--json", "-")
    found = json.loads(said)
    assert (found["count"], found["answer"]) == (0, None)
    assert (
        "1.0000 kN is there" in run("count", "deck-barge", "--quality", "1000", "--units", "si")[1]
    )


@pytest.mark.parametrize(
    ("options", "fault"),
    [
        (["--quality", "0"], "--quality is 0; it should be more than 0"),
        (["--quality", "1", "--most", "1.5"], "--most is 1.5; it should be a whole number"),
        (["--quality", "1", "--effort", "1.5"], "--effort is 1.5; it should be a whole number"),
    ],
)
def test_wrong_numbers(run, options, fault):
    """All named before anything is computed."""
    status, said, complaints = run("count", "deck-barge", *options)
    assert (status, said) == (2, "")
    assert fault in complaints


def test_a_scenario_without_a_newcomer(run, pontoon):
    """Nobody to count."""
    pontoon.write_text("".join(pontoon.read_text().splitlines(keepends=True)[:-1]))
    status, _, complaints = run("count", pontoon, "--quality", "1")
    assert status == 2
    assert "has no newcomer, and `swarmgrasp count` needs one; add one" in complaints


def test_the_required_quality_may_have_a_unit(run):
    """Tonnes are tonnes; knots are no force."""
    assert run("count", "deck-barge", "--quality", "60t")[1].startswith(
        "Deck barge: 2 tugs are the fewest for 60.000 tf\n"
    )
    status, _, complaints = run("count", "deck-barge", "--quality", "6kn")
    assert (status, complaints) == (
        2, "--quality is 6kn: 'kn' is a unit of speed, not of force; did you mean 'kN'?\n"
    )  # fmt: skip
