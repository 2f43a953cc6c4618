"""`swarmgrasp agent`: what is wrong with its options, before anything is on the network."""

import pytest

pytest.importorskip("zenoh")

WRONG = {
    ("--silent", "0.01s"): "--silent is 0.01; it should be 0.1 to 86400 [s]",
    ("--worth", "nan"): "worth is nan; it should be 0 to 1",
    ("--roster", "Ajax,,Boreas"): "roster: a robot has the name ''",
    ("--limit", "-3"): "--limit is -3; it should be from",
    ("--speed", "0"): "the speed is 0.0",
    ("--listen", "here"): "the endpoint is 'here'",
    (
        "--attached-at",
        "0",
        "0",
        "1",
    ): "--attached-at is (0.00, 0.00) ft, 36.00 ft from the boundary; it should be at most",
    ("--state", "none/state"): "none/state: there is no folder none; create it first",
}


def test_all_that_is_wrong_is_told_at_once(run):
    """Options of robot, body and network: a line for each, whatever else is wrong."""
    words = [word for option in WRONG for word in option]
    status, said, complaints = run("agent", "deck-barge", "--name", "Fortuna", *words)
    assert (status, said) == (2, "")
    lines = complaints.splitlines()
    assert len(lines) == len(WRONG)
    for fault in WRONG.values():
        assert [line for line in lines if line.startswith(fault)], fault


def test_a_file_that_is_none_is_told_with_the_rest(run):
    """What needs the scenario is left out, what does not is not."""
    status, _, complaints = run("agent", "none.yaml", "--name", "Fortuna", "--lease", "5")
    assert status == 2
    first, second = complaints.splitlines()
    assert first == "the lease is 5 s; it should be at most --silent, 3.5 s"
    assert second.startswith("none.yaml: there is no such file")


@pytest.mark.parametrize("place", [("nan", "0", "0"), ("1e300", "0", "0"), ("-38", "0", "1e9")])
def test_a_robot_is_not_attached_where_no_object_is(run, place):
    """A place in another unit or frame would be taken for the nearest one on the boundary."""
    status, _, complaints = run("agent", "deck-barge", "--name", "Fortuna", "--attached-at", *place)
    assert status == 2
    assert complaints.startswith("--attached-at is ")
