"""What is to be believed of noisy looks: pose, velocity, and the load that nobody measures."""

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.simulation.frames import Headings, nearest_turns, times
from swarmgrasp.simulation.hull import inverse_of

Array = NDArray[np.float64]


class Observer:
    """An estimate of pose, velocity and bias, corrected by looks.

    With the error e of the pose, all in the earth's frame, and the observer's frequency w,

        pose' = velocity + 3 w e
        velocity' = M^-1 (what robots and wind exert, and the bias) + 3 w^2 e
        bias' = M w^3 e

    so that errors die away as exp(-w t). It is told the wrench that the robots make, not the one
    they were asked for: what is out of their reach does not wind the bias up.

    Parameters
    ----------
    frequency : float [rad/s]
    matrix : (3, 3) [kg, kg m, kg m^2]
        The masses about the outline's origin, in the object's frame.
    poses : (runs, 3) [m, m, rad]
        Known at the start.
    biases : (runs, 3) [N, N, N m]
        What else acts on the object at the start, in the earth's frame.
    """

    def __init__(self, frequency: float, matrix: Array, poses: Array, biases: Array) -> None:
        self._frequency = frequency
        self.poses, self.velocities, self.biases = (
            poses.copy(), np.zeros_like(poses), biases.copy()
        )  # fmt: skip
        self.weigh(matrix)

    def weigh(self, matrix: Array) -> None:
        """Take other masses."""
        self._matrix, self._inverse = matrix, inverse_of(matrix)

    def predict(self, wrenches: Array, period: float) -> None:
        """Go on for a period [s] in which known wrenches (runs, 3) act, in the object's frame."""
        headings = Headings(self.poses[:, 2])
        acting = wrenches + headings.to_object(self.biases)
        speeding = headings.to_earth(times(self._inverse, acting))
        self.poses += period * self.velocities
        self.velocities += period * speeding

    def correct(self, looks: Array, period: float) -> None:
        """Take a look (runs, 3) [m, m, rad] at the poses into account."""
        w, headings = self._frequency, Headings(self.poses[:, 2])
        off = nearest_turns(looks - self.poses)
        pull = headings.to_earth(times(self._matrix, headings.to_object(off)))
        self.poses += (3.0 * w * period) * off
        self.velocities += (3.0 * w * w * period) * off
        self.biases += (w * w * w * period) * pull
