"""What is to be seen of a run at an instant."""

import numpy as np
import pytest

from made_runs import JOINED, LOST, SENT, made_run
from swarmgrasp.simulation.export.scene import Film, placed


@pytest.fixture(scope="module")
def film():
    return Film(made_run(), 1)


def at(film, time):
    return film.at(int(np.searchsorted(film.run.times, time)))


def test_who_is_there_is_seen_with_the_force_it_exerts(film):
    """Castor until it is lost, Fortuna once it has joined; forces in the object's frame."""
    before, without, after = (at(film, t) for t in (LOST - 2, LOST, JOINED))
    names = [{p.robot.name for p in scene.pushers} for scene in (before, without, after)]
    assert names[0] - names[1] == {"Castor"}
    assert names[2] - names[1] == {"Fortuna"}
    castor = next(p for p in before.pushers if p.robot.name == "Castor")
    i = film.run.names.index("Castor")
    assert np.hypot(*castor.force) == pytest.approx(
        film.run.forces[1, film.run.times == before.time, i][0]
    )
    assert film.pushes(castor)
    dione = next(p for p in before.pushers if p.robot.name == "Dione")
    assert not film.pushes(dione)


def test_a_newcomer_is_seen_on_its_way(film):
    """From where it waits to beside its place, and no longer once it has joined."""
    assert at(film, SENT - 2).travellers == ()
    ((name, point),) = at(film, SENT).travellers
    assert name == "Fortuna"
    assert np.hypot(*point) == pytest.approx(400.0, rel=0.01)
    fortuna = np.array(film.robots["Fortuna"].contact) - film.origin
    ((_, last),) = at(film, JOINED - 2).travellers
    extent = film.run.simulation.problem.swarm.outline.extent
    here = placed(fortuna[None], at(film, JOINED - 2).pose)[0]
    assert np.hypot(*(last - here)) < 0.1 * extent
    assert at(film, JOINED).travellers == ()


def test_instants_are_picked_evenly(film):
    """Never more than there are, the first and the last among them."""
    assert list(film.picked(4)) == [0, 50, 100, 150]
    assert list(film.picked(1000)) == list(range(151))
