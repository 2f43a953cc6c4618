"""Station keeping: from looks at the object to the wrench it is to receive."""

from collections.abc import Callable
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import NDArray

from swarmgrasp.simulation.control import Tuning
from swarmgrasp.simulation.frames import Headings, nearest_turns, times
from swarmgrasp.simulation.observer import Observer
from swarmgrasp.simulation.reference import Point
from swarmgrasp.swarm import Swarm

Array = NDArray[np.float64]

DAMPING = 0.85
"""Of the pull to the reference, 1 being critical: a little less is back sooner after a loss, and
from 0.8 down overshoots by metres from far away, where the robots' limits cut the pull off."""


class Known(NamedTuple):
    """What a controller knows of the object and its robots.

    Attributes
    ----------
    swarm : Swarm
        Those that are believed to be there.
    matrix : (3, 3) [kg, kg m, kg m^2]
        Masses about the outline's origin, in the object's frame.
    wind_loads : callable
        From headings (runs,) [rad] and velocities of the air (runs, 2) [m/s] in the earth's frame
        to the wrenches (runs, 3) of the wind on the object, in its frame.
    """

    swarm: Swarm
    matrix: Array
    wind_loads: Callable[[Array, Array], Array]


class Look(NamedTuple):
    """What a controller sees at an instant, of all runs.

    Attributes
    ----------
    time : float [s]
    poses : (runs, 3) [m, m, rad]
        Measured, with noise.
    air : (runs, 2) [m/s]
        The wind's velocity in the earth's frame.
    made : (runs, 3) [N, N, N m]
        The wrench that the robots are believed to exert, in the object's frame.
    reference : Point
        What the object is to do.
    """

    time: float
    poses: Array
    air: Array
    made: Array
    reference: Point


class Controller(Protocol):
    """What decides on the wrench that the object is to receive; the robots share it out.

    Each array has a row for each run, and what it gives for one should not depend on the others.
    """

    def begin(self, known: Known, tuning: Tuning, poses: Array, rests: Array) -> None:
        """Forget all before, and begin.

        Parameters
        ----------
        known : Known
        tuning : Tuning
        poses : (runs, 3) [m, m, rad]
            Those at the start.
        rests : (runs, 3) [N, N, N m]
            What acts on the object at the start beside wind and robots, in its frame.
        """

    def change(self, known: Known) -> None:
        """Take note that robots have come, or are known to be gone."""

    def wrenches(self, look: Look) -> Array:
        """Return the wrenches (runs, 3) that the robots are to exert, in the object's frame."""


class StationKeeping:
    """The controller that is taken where no other is given.

    Wanted is ``M (w^2 (reference - pose) + 1.7 w (its velocity - velocity) + its acceleration)``,
    of what the observer believes, less the loads of bias and wind.
    """

    def begin(self, known: Known, tuning: Tuning, poses: Array, rests: Array) -> None:
        """Begin at known poses, with known loads."""
        self._known, self._tuning = known, tuning
        biases = Headings(poses[:, 2]).to_earth(rests)
        self._observer = Observer(tuning.observer, known.matrix, poses, biases)
        self._acting = np.zeros_like(poses)
        self._is_begun = False

    def change(self, known: Known) -> None:
        """Take the masses of the robots that are there now."""
        self._known = known
        self._observer.weigh(known.matrix)

    def wrenches(self, look: Look) -> Array:
        """Return the wrenches (runs, 3) that take the object back to its reference."""
        seen, period, w = self._observer, self._tuning.period, self._tuning.frequency
        if self._is_begun:
            seen.predict(self._acting, period)
        self._is_begun = True
        seen.correct(look.poses, period)
        headings, goal = Headings(seen.poses[:, 2]), look.reference
        off = nearest_turns(goal.pose - seen.poses)
        pull = (
            w * w * off + 2.0 * DAMPING * w * (goal.velocity - seen.velocities) + goal.acceleration
        )
        wind = self._known.wind_loads(seen.poses[:, 2], look.air)
        self._acting = look.made + wind
        push = times(self._known.matrix, headings.to_object(pull))
        return push - headings.to_object(seen.biases) - wind
