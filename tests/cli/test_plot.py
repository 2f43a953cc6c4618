import pytest


@pytest.mark.parametrize("what", ["plan", "wrenches", "landscape"])
def test_writes_each_picture(run, pontoon, tmp_path, what):
    """One picture of the kind asked for, and its name."""
    target = tmp_path / "picture.svg"
    status, said, complaints = run("plot", pontoon, target, "--what", what)
    assert (status, said, complaints) == (0, f"wrote {target}\n", "")
    assert target.read_text().lstrip().startswith("<?xml")


def test_a_landscape_needs_a_newcomer(run, pontoon, tmp_path):
    """Without a newcomer the plan is drawn, and a landscape is refused."""
    pontoon.write_text("\n".join(pontoon.read_text().splitlines()[:-1]))
    assert run("plot", pontoon, tmp_path / "a.png")[0] == 0
    status, _, complaints = run("plot", pontoon, tmp_path / "b.png", "--what", "landscape")
    assert status == 2
    assert "has no newcomer" in complaints
    assert not (tmp_path / "b.png").exists()
