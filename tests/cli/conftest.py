import pytest

SCENARIO = """\
name: Pontoon
outline: {vertices: [[-2, -1], [2, -1], [2, 1], [-2, 1]], edges: [starboard, bow, port, stern]}
robots:
  - {name: A, edge: starboard, along: 1, direction: inward, limit: 1000}
  - {name: B, edge: port, along: 1.5, direction: inward, limit: 1000}
  - {name: C, edge: bow, along: 0.5, direction: inward, limit: 1000}
  - {name: D, edge: stern, along: 0.8, direction: inward, limit: 1000}
newcomer: {name: E, limit: 1500, attachment: push, half_angle: 0.5}
"""


@pytest.fixture
def pontoon(tmp_path):
    """Four robots on a pontoon and a fifth to come, in a file."""
    path = tmp_path / "pontoon.yaml"
    path.write_text(SCENARIO)
    return path
