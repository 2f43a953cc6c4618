"""Controllers of one's own: they see what is promised, and what they want is made."""

import numpy as np
import pytest

from moored import moored
from swarmgrasp.errors import SimulationInvalid
from swarmgrasp.simulation import Controller, Known, Look, Lose, Tuning, simulate


class Spy:
    """Holds the mean load blindly, and keeps what it is shown."""

    def __init__(self) -> None:
        self.looks: list[Look] = []
        self.crews: list[int] = []

    def begin(self, known: Known, tuning: Tuning, poses: np.ndarray, rests: np.ndarray) -> None:
        """Work out what holds the object at the start."""
        assert poses.shape == rests.shape
        assert tuning.period == 0.1
        self.rests = rests
        self.change(known)

    def change(self, known: Known) -> None:
        """Count who is known to be there."""
        self.known = known
        self.crews.append(len(known.swarm))

    def wrenches(self, look: Look) -> np.ndarray:
        """Want the opposite of the loads."""
        self.looks.append(look)
        return -self.rests - self.known.wind_loads(np.zeros(len(look.poses)), look.air)


def test_a_controller_sees_noisy_poses_the_wind_and_who_is_known_to_be_there() -> None:
    """At each period, for all runs; a loss only when it is noticed."""
    spy: Controller = Spy()
    calm = moored("deck-barge", 30.0, 60.0, duration=20.0, events=(Lose(5, "Electra", 3.0),))
    run = simulate(calm, range(40), spy, every=1)
    assert spy.crews == [6, 5]
    times = [look.time for look in spy.looks]
    np.testing.assert_allclose(times, run.times, rtol=1e-12)
    noise = np.array([look.poses for look in spy.looks]).swapaxes(0, 1) - run.poses
    np.testing.assert_allclose(noise.std(axis=(0, 1)), (0.3, 0.3, np.radians(0.1)), rtol=0.05)
    np.testing.assert_allclose(spy.looks[0].air[0], run.streams[0, 0, :2], rtol=1e-6)
    np.testing.assert_allclose(spy.looks[0].made, run.given[:, 0], rtol=1e-5)
    early = run.times < 5.0
    assert run.distances[:, early].max() < 1e-6  # it wants what holds the object


@pytest.mark.parametrize("wanted", [np.zeros(3), np.full((1, 3), np.nan)], ids=["shape", "nan"])
def test_what_is_no_wrench_for_each_run_is_refused(wanted: np.ndarray) -> None:
    """The message says what it should be."""

    class Careless(Spy):
        def wrenches(self, look: Look) -> np.ndarray:
            super().wrenches(look)
            return wanted

    calm = moored("deck-barge", 10.0, 0.0, duration=1.0)
    with pytest.raises(SimulationInvalid, match=r"finite numbers \(1, 3\) \[N, N, N m\]"):
        simulate(calm, controller=Careless())
