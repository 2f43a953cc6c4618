"""The frame of a file and ours, by hand and by what a frame must keep."""

import math

import numpy as np
import pytest

from swarmgrasp.errors import TermsInvalid
from swarmgrasp.terms import Frame, Terms

FRAMES = [
    Frame(),
    Frame(mirrored=True),
    Frame(bow=math.pi / 2),
    Frame(bow=0.7, mirrored=True, heading=0.7),
]


@pytest.mark.parametrize("frame", FRAMES)
def test_frame_keeps_lengths_and_comes_back(frame: Frame) -> None:
    """To a file and back is nothing; lengths, and the torque of a force's arm, stay."""
    rng = np.random.default_rng(1)
    points, wrench = rng.normal(size=(5, 2)), rng.normal(size=(4, 3))
    there = frame.to_file(points)
    assert np.allclose(frame.from_file(there), points)
    assert np.allclose(np.linalg.norm(there, axis=1), np.linalg.norm(points, axis=1))
    assert np.allclose(frame.wrench_from_file(frame.wrench_to_file(wrench)), wrench)
    arm, force = points[0], points[1]
    torque = arm[0] * force[1] - arm[1] * force[0]
    (x, y), (fx, fy) = frame.to_file(arm), frame.to_file(force)
    assert np.allclose(frame.wrench_to_file([*force, torque])[2], x * fy - y * fx)


@pytest.mark.parametrize("frame", FRAMES)
@pytest.mark.parametrize("direction", [0.0, 0.4, -2.5])
def test_directions_turn_as_forces_do(frame: Frame, direction: float) -> None:
    """A direction in the file's frame is that of the force there, counted as the file counts."""
    x, y = frame.to_file([math.cos(direction), math.sin(direction)])
    told = frame.direction_to_file(direction)
    assert np.allclose([math.cos(told), math.sin(told)], [x, y])
    assert math.isclose(frame.direction_from_file(told), direction, abs_tol=1e-12)


def test_bow_of_a_file_is_ahead() -> None:
    """Of a chart with north along x and east along y, a bow to the south-east is our x."""
    chart = Frame(bow=math.radians(135), mirrored=True, heading=math.radians(135))
    south_east, south_west = [-1.0, 1.0], [-1.0, -1.0]
    assert np.allclose(chart.from_file(south_east), [math.sqrt(2), 0.0])
    assert np.allclose(chart.from_file(south_west), [0.0, -math.sqrt(2)])  # to starboard
    assert math.isclose(math.degrees(chart.bearing(0.0)), 135.0)


def test_terms_tell_all_their_faults() -> None:
    """Every unit that is unknown is told, and a word for robots that is none."""
    with pytest.raises(TermsInvalid) as error:
        Terms(length="yard", speed="mach", robot="")
    assert len(error.value.faults) == 3
    with pytest.raises(TermsInvalid, match="angle in radians"):
        Frame(bow=math.nan)
