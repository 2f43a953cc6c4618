"""`swarmgrasp judge`: what it says, writes and refuses."""

from dataclasses import replace

import mujoco

import swarmgrasp.packages
from swarmgrasp.simulation import mujoco as ours

FILE = """
units: {length: m, force: N, angle: deg}
outline: {vertices: [[-1, -1], [1, -1], [1, 1], [-1, 1]]}
robots:
  - {name: A, contact: [1, 0.5], direction: 180, limit: 10}
  - {name: B, contact: [-1, -0.5], direction: 0, limit: 10}
"""


def test_it_agrees_and_writes_a_model(run, tmp_path):
    """The first line answers; the model is one that MuJoCo reads, and has all robots."""
    path = tmp_path / "ring.xml"
    status, said, complaints = run("judge", "escort-ring", "--losing", 1, "--mjcf", path)
    first, *_, last = said.splitlines()
    assert (status, complaints) == (0, "")
    assert "MuJoCo agrees: " in first
    assert first.endswith(
        "is held after the worst loss of 1 tug, beside the load, and 1 % more is not"
    )
    assert f"MuJoCo {mujoco.__version__}" in said
    assert last == f"wrote {path}"
    assert mujoco.MjModel.from_xml_path(str(path)).nu == 8


def test_a_disagreement_is_a_status(run, monkeypatch):
    """Were 1.01 of the quality held, the quality would be wrong."""
    right = ours.judge

    def wrong(quality, hull):
        found = right(quality, hull)
        return replace(found, trials=tuple(replace(t, is_held=True) for t in found.trials))

    monkeypatch.setattr(ours, "judge", wrong)
    status, said, _ = run("judge", "escort-ring")
    assert status == 1
    assert "does not agree that" in said.splitlines()[0]


def test_faults_are_told_at_once(run, tmp_path):
    """Of options; of an object whose mass nothing tells; of robots that hold nothing."""
    path = tmp_path / "box.yaml"
    path.write_text(FILE)
    status, said, complaints = run(
        "judge", path, "--mass", "-3", "--losing", "q", "--mjcf", "ring.png"
    )
    assert (status, said, len(complaints.splitlines())) == (2, "", 3)
    assert "nothing tells the mass of the object; give --mass" in run("judge", path)[2]
    assert "the quality is 0" in run("judge", path, "--mass", 20)[2]


def test_an_object_too_light_for_mujoco_is_told(run, tmp_path, monkeypatch):
    """With how much heavier it should be, and nothing is left where one stands."""
    monkeypatch.chdir(tmp_path)
    status, _, complaints = run("judge", "deck-barge", "--mass", 1e-9)
    assert (status, list(tmp_path.iterdir())) == (2, [])
    assert complaints.startswith("deck-barge: an object of 1e-09 kg is too light to judge: ")
    times = float(complaints.split("; give it ")[1].split()[0])
    assert run("judge", "deck-barge", "--mass", 1.1e-9 * times)[0] == 0


def test_without_mujoco_it_says_how_to_install_it(run, monkeypatch):
    """In one line."""
    monkeypatch.setattr(swarmgrasp.packages, "find_spec", lambda _: None)
    status, _, complaints = run("judge", "escort-ring")
    assert status == 2
    assert complaints.startswith("`swarmgrasp judge` needs mujoco; ")
    assert complaints.rstrip().endswith("install it with: pip install 'swarmgrasp[mujoco]'")
