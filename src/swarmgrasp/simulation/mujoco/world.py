"""An object and its robots that MuJoCo moves: the one door to it."""

import math
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
from numpy.typing import ArrayLike, NDArray

from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.packages import check_installed
from swarmgrasp.ranges import array_of, is_whole, shown
from swarmgrasp.simulation.hull import Hull
from swarmgrasp.simulation.mujoco.model import Floor, columns_of, mjcf
from swarmgrasp.simulation.plant import MOST_STEPS
from swarmgrasp.swarm import Swarm

Array = NDArray[np.float64]
SETTLING = 1.0
"""How long an object on a floor settles on its feet before the start [s]."""
YAW = {3: 2, 6: 5}
"""Which coordinate turns the object, by how many there are: in the plane, and on a floor."""


class World:
    """An object in MuJoCo, at first at rest at pose 0.

    Parameters
    ----------
    swarm : Swarm
    hull : Hull
    floor : Floor, optional
    lags : float or (n,) [s]
    step : float [s]
        As for `mjcf`.

    Raises
    ------
    PackageMissing
        Without MuJoCo.
    SimulationInvalid, SwarmInvalid
        As for `mjcf`, and if MuJoCo does not take the model.

    Examples
    --------
    A mass of 2 kg pushed ahead with 3 N for 2 s has come 3 m:

    >>> from swarmgrasp import Outline, Robot
    >>> square = Outline([(-1, -1), (1, -1), (1, 1), (-1, 1)])
    >>> swarm = Swarm(square, [Robot((-1.0, 0.0), direction=0.0, limit=3.0)])
    >>> world = World(swarm, Hull.ashore(square, 2.0))
    >>> world.advance([(3.0, 0.0)], steps=1000).round(9).tolist()
    [3.0, 0.0, 0.0]
    """

    def __init__(
        self,
        swarm: Swarm,
        hull: Hull,
        floor: Floor | None = None,
        *,
        lags: ArrayLike = 0.0,
        step: float = 0.002,
    ) -> None:
        check_installed("mujoco", extra="mujoco", purpose="A world of MuJoCo")
        import mujoco

        self.swarm, self.step = swarm, step
        self._library = mujoco
        text = mjcf(swarm, hull, floor, lags=lags, step=step)
        try:
            with self._silent():
                self._model = mujoco.MjModel.from_xml_string(text)
        except ValueError as error:  # such as of a shape too small for it
            said = " ".join(str(error).split())
            raise SimulationInvalid(
                f"MuJoCo does not take the model of the object: {said}"
            ) from None
        self._data = mujoco.MjData(self._model)
        self._columns = columns_of(swarm)
        self._start = np.zeros(3)
        if floor is not None:
            self._step(math.ceil(SETTLING / step))
            self._start = self.pose

    @property
    def pose(self) -> Array:
        """(3,) [m, m, rad]: x, y and heading, in the earth's frame."""
        place = np.array(self._data.qpos)
        if len(place) == 3:
            return place - self._start
        w, x, y, z = place[3:7]
        turn = math.atan2(2.0 * (w * z + x * y), 1.0 - 2.0 * (y * y + z * z))
        return np.array([place[0], place[1], turn]) - self._start

    @property
    def net(self) -> Array:
        """(3,) [N, N, N m]: what the object receives, by its acceleration: mass times that.

        In the earth's frame, about the outline's origin.
        """
        with self._silent():
            self._library.mj_forward(self._model, self._data)
        found = np.zeros(self._model.nv)
        self._library.mj_mulM(self._model, self._data, found, self._data.qacc)
        return found[[0, 1, YAW[len(found)]]]

    @property
    def _has_begun_anew(self) -> bool:
        """Whether numbers became too large for MuJoCo, which then goes back to the start."""
        kinds = self._library.mjtWarning
        too_large = (kinds.mjWARN_BADQPOS, kinds.mjWARN_BADQVEL, kinds.mjWARN_BADQACC)
        return any(self._data.warning[int(kind)].number for kind in too_large)

    def order(self, vectors: ArrayLike, load: ArrayLike = (0.0, 0.0, 0.0)) -> None:
        """Say which forces robots are to exert from now on, and what else acts.

        Parameters
        ----------
        vectors : (n, 2) [N, N]
            In the object's frame, such as those of `forces`.
        load : (3,) [N, N, N m]
            A wrench on the object about the outline's origin, in the earth's frame.

        Raises
        ------
        SimulationInvalid
            If these are no such numbers; all faults at once.
        """
        wanted, other = array_of(vectors), array_of(load)
        shape = (len(self.swarm), 2)
        faults = []
        if wanted is None or wanted.shape != shape or not np.isfinite(wanted).all():
            faults.append(f"the forces are {shown(vectors)}; they should be numbers {shape} [N, N]")
        if other is None or other.shape != (3,) or not np.isfinite(other).all():
            faults.append(f"the load is {shown(load)}; it should be three finite numbers")
        if faults or wanted is None or other is None:
            raise SimulationInvalid(faults)
        self._data.ctrl[:] = [
            x * along[0] + y * along[1]
            for (x, y), axes in zip(wanted.tolist(), self._columns, strict=True)
            for along in axes
        ]
        applied = self._data.qfrc_applied
        applied[0], applied[1], applied[YAW[len(applied)]] = other.tolist()

    def advance(
        self, vectors: ArrayLike, load: ArrayLike = (0.0, 0.0, 0.0), *, steps: int = 1
    ) -> Array:
        """Return the pose (3,) [m, m, rad] some steps on.

        Parameters
        ----------
        vectors : (n, 2) [N, N]
        load : (3,) [N, N, N m]
            As for `order`.
        steps : int

        Raises
        ------
        SimulationInvalid
            If these are no such numbers, or the motion grows beyond all that MuJoCo counts.
        """
        if not (is_whole(steps) and 0 <= steps <= MOST_STEPS):
            raise SimulationInvalid(
                f"the steps are {shown(steps)}; they should be a whole number, 0 <= steps <= "
                f"{MOST_STEPS:g}"
            )
        self.order(vectors, load)
        if steps:
            self._step(steps)
            if self._has_begun_anew:
                raise SimulationInvalid(
                    f"in steps of {self.step:g} s the motion grows beyond all that MuJoCo counts; "
                    "take shorter steps, or a heavier object"
                )
        return self.pose

    def _step(self, steps: int) -> None:
        """Let MuJoCo take some steps."""
        with self._silent():
            self._library.mj_step(self._model, self._data, nstep=steps)

    @contextmanager
    def _silent(self) -> Iterator[None]:
        """Keep MuJoCo from writing its warnings to a file of its own where the user stands.

        It counts them in its data, where `_has_begun_anew` finds them.
        """
        library = self._library
        before = library.get_mju_user_warning()
        library.set_mju_user_warning(lambda _: None)
        try:
            yield
        finally:
            library.set_mju_user_warning(before)
