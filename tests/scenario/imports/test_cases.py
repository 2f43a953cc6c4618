"""Hulls in halves and allocation matrices, from the files that people have to the right numbers."""

import math
from pathlib import Path

import numpy as np
import pytest

from swarmgrasp import capability, forces, losses, quality
from swarmgrasp.environment import KNOT
from swarmgrasp.errors import ScenarioInvalid
from swarmgrasp.scenario import convert, load_scenario, parse_scenario

CASES = Path(__file__).parents[2] / "data" / "cases"
HELD = [49.56, 44.55, 35.30]
"""Winds [kn] held from 45, 90 and 135 degrees: by another Blendermann and linear programs."""
BEARINGS = np.radians([45.0, 90.0, 135.0])


@pytest.mark.parametrize("name", ["turned", "half"])
def test_half_a_hull_holds_what_the_whole_one_does(name: str) -> None:
    """Mirrored, with the bow where it is, it holds the winds of the hull drawn bow ahead."""
    scenario = load_scenario(CASES / "hull-halves" / f"{name}.yaml")
    found = capability(scenario.swarm, scenario.environment, BEARINGS)
    assert found.intact / KNOT == pytest.approx(HELD, abs=0.01)


def test_convert_turns_the_bow_ahead() -> None:
    """Of a half with its centreline along y, and says so; an angle given holds."""
    told = convert(CASES / "hull-halves" / "half.csv")
    whole = load_scenario(CASES / "hull-halves" / "turned.yaml").swarm.outline
    assert told.scenario.swarm.outline.vertices[0].tolist() == [43.85, 0.0]
    assert told.scenario.swarm.outline.area == pytest.approx(whole.area, rel=1e-12)
    assert any("turned" in sentence for sentence in told.said)
    aft = convert(CASES / "hull-halves" / "half.csv", bow="-y", units={"length": "ft"})
    assert aft.scenario.swarm.outline.vertices[0].tolist() == pytest.approx([-43.85 * 0.3048, 0.0])


def test_a_matrix_in_a_file_is_a_scenario(tmp_path: Path) -> None:
    """Of the published vessel, with pure torque: 768.669 kN; in text with a hull of its own."""
    table = CASES / "allocation" / "supply-vessel.csv"
    told = convert(table, frame="NED")
    assert [len(told.scenario.swarm), len(told.said)] == [7, 4]
    hull = "[[-38.1, -9], [38.1, -9], [38.1, 9], [-38.1, 9]]"
    path = tmp_path / "asked.yaml"
    path.write_text(
        f"units: {{force: kN}}\nframe: NED\noutline: {{vertices: {hull}, origin: [0, 0]}}\n"
        f"metric: {{characteristic_length: 38.1}}\nallocation: {{file: {table}}}\n"
    )
    swarm = load_scenario(path).swarm
    assert quality(swarm).value == pytest.approx(768.669e3, abs=1.0)
    bare = swarm.without("gyro")
    assert quality(bare).value == pytest.approx(748.323e3, abs=1.0)
    assert losses(bare)[0].quality == pytest.approx(465.147e3, abs=1.0)
    found = forces(swarm, (0.0, 0.0, 2e6))
    assert found.verify()
    (tmp_path / "whole.yaml").write_text(told.text("supply-vessel.csv"))
    again = load_scenario(tmp_path / "whole.yaml").swarm
    assert again.to_data() == told.scenario.swarm.to_data()


@pytest.mark.parametrize(
    ("name", "content"),
    [
        ("a.csv", "name,Fx,Fy,Mz,limit [kN]\nbow,0,1,30,20\ngyro,0,0,2,5\n"),
        ("b.csv", ";bow;gyro\nsurge;0;0\nsway;1;0\nyaw;30;2\nleast;-20000;-5 kN\nmax;20000;5 kN\n"),
        (
            "c.json",
            '{"T": [[0,0],[1,0],[30,2]], "limits": ["20 kN", [-5000, 5000]],\n'
            '"names": ["bow", "gyro"]}',
        ),
        (
            "d.yaml",
            "tam: [[0,0],[1,0],[7,7],[7,7],[7,7],[30,2]]\nlimits: [20 kN, 5 kN]\n"
            "names: [bow, gyro]\n",
        ),
    ],
)
def test_every_form_holds_the_same_matrix(tmp_path: Path, name: str, content: str) -> None:
    """A thruster a line or a column, words of the field, six rows, limits with units or pairs."""
    (tmp_path / name).write_text(content)
    bow, gyro = convert(tmp_path / name).scenario.swarm
    assert (bow.name, bow.contact, bow.limit, bow.reverse_limit) == ("bow", (30, 0), 20e3, 20e3)
    assert (gyro.name, gyro.lever, gyro.limit, gyro.reverse_limit) == ("gyro", 2.0, 5e3, 5e3)
    assert bow.direction == pytest.approx(math.pi / 2)


def test_arrays_of_numpy_and_bare_numbers(tmp_path: Path) -> None:
    """Limits come from where they are asked; objects in an array are not read."""
    rows = np.array([[0.0, 0, 1, 0], [1, 0, 0, 1], [30, 2, 0, -30]])
    np.save(tmp_path / "a.npy", rows)
    np.savetxt(tmp_path / "b.txt", rows)
    for name in ("a.npy", "b.txt"):
        swarm = convert(tmp_path / name, limits=[2e3, [0, 5e3], "1 kN", 7]).scenario.swarm
        assert swarm.robots[1].reverse_limit == 0.0
        assert swarm.robots[2].limit == 1000.0
        with pytest.raises(ScenarioInvalid, match="limits: is missing"):
            convert(tmp_path / name)
    np.save(tmp_path / "c.npy", np.array([{}]), allow_pickle=True)
    (tmp_path / "d.npy").write_bytes(
        (tmp_path / "a.npy").read_bytes().replace(b"(3, 4)", b"(3, 4[")
    )
    np.save(tmp_path / "e.npy", rows[:2])
    np.save(tmp_path / "f.npy", rows * math.nan)
    for name, said in (
        ("c", "cannot be read"),
        ("d", "cannot be read"),
        ("e", "3 rows"),
        ("f", "finite"),
    ):
        with pytest.raises(ScenarioInvalid, match=said):
            convert(tmp_path / f"{name}.npy", limits=[1] * 4)


HULL = "outline: {vertices: [[-9, -3], [9, -3], [9, 3], [-9, 3]], origin: [0, 0]}\n"


@pytest.mark.parametrize(
    ("keys", "said"),
    [
        ("{matrix: [[1], [0], [4]], limits: [3]}", "4 m from the origin, past the outline"),
        ("{matrix: [[1, 2], [0], [4]], limits: [3]}", "the rows have 2, 1 and 1 numbers"),
        ("{matrix: [[1], [0], [0]]}", "allocation.limits: is missing"),
        ("{matrix: [[1], [0], [0]], limits: [0]}", "the limit is 0.0"),
        ("{matrix: [[1], [0], [0]], limits: [[1, 2, 3]]}", "allocation.limits.0"),
        ("{matrix: [[1], [0], [0]], limits: [2 ft]}", "unit of length, not of force"),
        ("{matrix: [[1], [0], [0]], limits: [2], frame: up}", "allocation.frame"),
        ("{matrix: [[1], [0]], limits: [2]}", "allocation.matrix"),
        ("{file: none.csv}", "files are read for scenarios in files only"),
    ],
)
def test_wrong_matrices_are_refused_with_their_place(keys: str, said: str) -> None:
    """In one line each."""
    with pytest.raises(ScenarioInvalid, match=said) as caught:
        parse_scenario(f"{HULL}allocation: {keys}\n")
    assert len(caught.value.faults) == 1
    assert caught.value.faults[0].startswith("<text>:2:")
